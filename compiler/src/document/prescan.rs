//! What is looked at before a file is parsed: size, encoding, nesting, stray characters. It bounds
//! what the recursive parser can meet.

/// Largest file that is read, in bytes.
pub const MAX_FILE_BYTES: usize = 64 << 20;
/// Deepest nesting of lists and objects.
pub const MAX_DEPTH: usize = 64;
/// Most values of a file. Each takes a hundred bytes of memory, be it one character of the file.
pub const MAX_VALUES: usize = 1 << 23;

/// What is wrong at a byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Irregularity {
    /// One bracket more than [`MAX_DEPTH`] is open.
    TooDeep,
    /// There are more than [`MAX_VALUES`].
    TooManyValues,
    /// A control character inside a string.
    ControlInString(u8),
    /// A character that can start no JSON token, or is no JSON white space.
    Stray(char),
}

impl Irregularity {
    /// Whether the parser must not see the file.
    pub(super) fn is_past_a_limit(self) -> bool {
        matches!(self, Irregularity::TooDeep | Irregularity::TooManyValues)
    }
}

/// The first irregularity and its byte. Stops at what only the parser can judge (a comment, a
/// single quote): what follows has no meaning then.
pub(super) fn prescan(text: &str) -> Option<(usize, Irregularity)> {
    let bytes = text.as_bytes();
    let mut depth: usize = 0;
    // Values but the first stand after a comma or an opening bracket, if it is not an empty one.
    let mut values = 1;
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
            b'[' | b'{' | b',' => {
                values += 1;
                if values > MAX_VALUES {
                    return Some((at, Irregularity::TooManyValues));
                }
                depth += usize::from(byte != b',');
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
