//! What is looked at before a file is parsed: size, encoding, nesting, stray characters. It bounds
//! what the recursive parser can meet.

/// Largest file that is read, in bytes.
pub const MAX_FILE_BYTES: usize = 64 << 20;
/// Deepest nesting of lists and objects.
pub const MAX_DEPTH: usize = 64;

/// What is wrong at a byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Irregularity {
    /// One bracket more than [`MAX_DEPTH`] is open.
    TooDeep,
    /// A control character inside a string.
    ControlInString(u8),
    /// A character that can start no JSON token, or is no JSON white space.
    Stray(char),
}

/// The first irregularity and its byte. Stops at what only the parser can judge (a comment, a
/// single quote): what follows has no meaning then.
pub(super) fn prescan(text: &str) -> Option<(usize, Irregularity)> {
    let bytes = text.as_bytes();
    let mut depth = 0;
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'"' => {
                at += 1;
                loop {
                    match bytes.get(at) {
                        None => return None,
                        Some(b'"') => break,
                        // An escaped control character is caught as one, not skipped.
                        Some(b'\\') if bytes.get(at + 1).is_some_and(|&next| next >= 0x20) => {
                            at += 2
                        }
                        Some(&control) if control < 0x20 => {
                            return Some((at, Irregularity::ControlInString(control)));
                        }
                        Some(_) => at += 1,
                    }
                }
            }
            b'[' | b'{' => {
                depth += 1;
                if depth > MAX_DEPTH {
                    return Some((at, Irregularity::TooDeep));
                }
            }
            b']' | b'}' => depth = depth.saturating_sub(1),
            b'/' | b'\'' => return None,
            b' ' | b'\t' | b'\r' | b'\n' => {}
            0x00..0x20 | 0x7f.. => {
                let stray = text[at..].chars().next().unwrap_or(char::REPLACEMENT_CHARACTER);
                return Some((at, Irregularity::Stray(stray)));
            }
            _ => {}
        }
        at += 1;
    }
    None
}
