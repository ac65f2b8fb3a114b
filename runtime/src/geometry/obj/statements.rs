//! The statements of an OBJ file and their words.

/// Reads the words of a file one after another, statement by statement. Comments are left out, a
/// `\` at the end of a line carries on in the next one, and lines end with LF, CR LF or CR. Nothing
/// is taken to be UTF-8: names may be in any encoding.
#[derive(Clone, Debug)]
pub(super) struct Statements<'f> {
    bytes: &'f [u8],
    at: usize,
    line: usize,
    has_begun: bool,
}

impl<'f> Statements<'f> {
    /// At the start of a file, behind its byte order mark.
    pub(super) fn new(bytes: &'f [u8]) -> Self {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        Self { bytes, at: 0, line: 1, has_begun: false }
    }

    /// The line of the last word, from 1.
    pub(super) fn line(&self) -> usize {
        self.line
    }

    /// The first word of the next statement. What the last one still had in its line is passed
    /// over; what it had in further lines is not, so a statement whose words nobody reads ends with
    /// its line: a path such as `C:\` does not swallow what comes after it.
    pub(super) fn statement(&mut self) -> Option<&'f [u8]> {
        loop {
            if self.has_begun && !self.pass_line() {
                return None;
            }
            self.has_begun = true;
            if let Some(word) = self.word() {
                return Some(word);
            }
        }
    }

    /// The next word of the statement.
    pub(super) fn word(&mut self) -> Option<&'f [u8]> {
        loop {
            self.at += count(self.rest(), is_blank);
            match *self.rest().first()? {
                b'\n' | b'\r' | b'#' => return None,
                b'\\' if self.carries_on(self.at) => {
                    if !self.pass_line() {
                        return None;
                    }
                }
                _ => break,
            }
        }
        let start = self.at;
        while let Some(&byte) = self.bytes.get(self.at) {
            let is_end = match byte {
                b'\n' | b'\r' => true,
                b'#' => !self.is_number_sign(start),
                b'\\' => self.carries_on(self.at),
                byte => is_blank(byte),
            };
            if is_end {
                break;
            }
            self.at += 1;
        }
        Some(&self.bytes[start..self.at])
    }

    fn rest(&self) -> &'f [u8] {
        &self.bytes[self.at..]
    }

    /// Whether the `#` here belongs to a number as Microsoft's library writes it, `1.#QNAN`. Were
    /// it the start of a comment, the number would be 1.
    fn is_number_sign(&self, start: usize) -> bool {
        let letter = self.bytes.get(self.at + 1).is_some_and(u8::is_ascii_alphabetic);
        letter && self.bytes[start..self.at].ends_with(b"1.")
    }

    /// Whether nothing but a comment follows the `\` there in its line.
    fn carries_on(&self, at: usize) -> bool {
        let rest = &self.bytes[at + 1..];
        matches!(rest.get(count(rest, is_blank)), None | Some(b'\n' | b'\r' | b'#'))
    }

    /// Goes to the start of the next line; false where there is none.
    fn pass_line(&mut self) -> bool {
        self.at += count(self.rest(), |byte| byte != b'\n' && byte != b'\r');
        self.at += match self.rest() {
            [] => return false,
            [b'\r', b'\n', ..] => 2,
            _ => 1,
        };
        self.line += 1;
        true
    }
}

/// How many bytes at the start are of that kind.
fn count(bytes: &[u8], is_of: impl Fn(u8) -> bool) -> usize {
    bytes.iter().position(|&byte| !is_of(byte)).unwrap_or(bytes.len())
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\x0b' | b'\x0c')
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every statement with the line of its last word.
    fn read(text: &str) -> Vec<(usize, Vec<&str>)> {
        let mut statements = Statements::new(text.as_bytes());
        let mut all = Vec::new();
        while let Some(word) = statements.statement() {
            let words = std::iter::once(word);
            let mut words: Vec<_> = words.map(|word| std::str::from_utf8(word).unwrap()).collect();
            while let Some(word) = statements.word() {
                words.push(std::str::from_utf8(word).unwrap());
            }
            all.push((statements.line(), words));
        }
        all
    }

    #[test]
    fn lines_end_in_three_ways_and_blanks_do_not_matter() {
        let expected = vec![(1, vec!["v", "1", "2"]), (3, vec!["f", "3"])];
        assert_eq!(read("v 1 2\n\nf 3"), expected);
        assert_eq!(read("\u{feff}v 1\t2 \r\n\r\n \t f\x0c3\r\n"), expected);
        assert_eq!(read("v 1 2\r\rf 3\r"), expected);
    }

    #[test]
    fn comments_are_left_out_wherever_they_stand() {
        assert_eq!(
            read("# a\nv 1 # b\nf 2#c\n#\n  # d \\\nv 3"),
            [(2, vec!["v", "1"]), (3, vec!["f", "2"]), (6, vec!["v", "3"])]
        );
        // A number of Microsoft's is no number and a comment.
        assert_eq!(read("v -1.#IND 1.#QNAN0 2"), [(1, vec!["v", "-1.#IND", "1.#QNAN0", "2"])]);
    }

    #[test]
    fn a_backslash_at_the_end_of_a_line_carries_on() {
        let expected = vec![(3, vec!["f", "1", "2", "3"]), (4, vec!["v"])];
        assert_eq!(read("f 1 \\\n2\\\n 3\nv"), expected);
        assert_eq!(read("f 1\\\r\n 2 \\  \r\n3\r\nv"), expected);
        assert_eq!(read("f 1 2 \\ # and\n\\\n3\nv"), expected);
        assert_eq!(read("f 1 \\"), [(1, vec!["f", "1"])]);
        assert_eq!(read("f a\\b"), [(1, vec!["f", "a\\b"])]);
    }

    #[test]
    fn a_statement_nobody_reads_ends_with_its_line() {
        let mut statements = Statements::new(b"usemtl C:\\\nv 1");
        assert_eq!(statements.statement(), Some(&b"usemtl"[..]));
        assert_eq!(statements.statement(), Some(&b"v"[..]));
        assert_eq!(statements.line(), 2);
    }
}
