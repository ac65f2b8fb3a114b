//! How wide text is, without a font at hand.
//!
//! Which font a viewer takes for `sans-serif` is not known. The tables hold, glyph by glyph, the
//! larger advance of the two families most viewers end at: Arial (with its metric twins Helvetica
//! and Liberation Sans) and DejaVu Sans (near Verdana). Text is therefore never wider than measured.

/// Size and weight of text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Font {
    /// Pixels of an em.
    pub size: f64,
    /// Whether it is bold.
    pub bold: bool,
}

/// Hundredths of an em from space to tilde, regular.
#[rustfmt::skip]
const REGULAR: [u8; 95] = [
    32, 41, 46, 84, 64, 96, 78, 28, 40, 40, 50, 84, 32, 37, 32, 34, 64, 64, 64,
    64, 64, 64, 64, 64, 64, 64, 34, 34, 84, 84, 84, 56, 102, 69, 69, 73, 78, 67,
    62, 78, 76, 30, 50, 67, 56, 87, 75, 79, 67, 79, 73, 67, 62, 74, 69, 99, 69,
    67, 69, 40, 34, 40, 84, 56, 50, 62, 64, 55, 64, 62, 36, 64, 64, 28, 28, 58,
    28, 98, 64, 62, 64, 64, 42, 53, 40, 64, 60, 82, 60, 60, 53, 64, 34, 64, 84,
];

/// Hundredths of an em from space to tilde, bold.
#[rustfmt::skip]
const BOLD: [u8; 95] = [
    35, 46, 53, 84, 70, 101, 88, 31, 46, 46, 53, 84, 38, 42, 38, 37, 70, 70, 70,
    70, 70, 70, 70, 70, 70, 70, 40, 40, 84, 84, 84, 62, 100, 78, 77, 74, 84, 69,
    69, 83, 84, 38, 56, 78, 64, 100, 84, 86, 74, 86, 78, 73, 69, 82, 78, 111, 78,
    73, 73, 46, 37, 46, 84, 56, 50, 68, 72, 60, 72, 68, 44, 72, 72, 35, 35, 67,
    35, 105, 72, 69, 72, 72, 50, 60, 48, 72, 66, 93, 65, 66, 59, 72, 37, 72, 84,
];

/// Hundredths of an em for letters of other scripts: wide Latin and Cyrillic letters reach it.
const OTHER: f64 = 142.0;
/// Hundredths of an em for pictographs.
const PICTOGRAPH: f64 = 160.0;

impl Font {
    /// Width of `text` in pixels, rather too large than too small.
    pub fn width(self, text: &str) -> f64 {
        text.chars().map(|c| self.advance(c)).sum()
    }

    fn advance(self, c: char) -> f64 {
        let table = if self.bold { &BOLD } else { &REGULAR };
        let hundredths = match c {
            ' '..='~' => f64::from(table[c as usize - ' ' as usize]),
            '…' | '→' | '·' => 100.0,
            '\u{1f000}'.. => PICTOGRAPH,
            _ => OTHER,
        };
        hundredths * self.size / 100.0
    }

    /// `text`, or its beginning with an ellipsis, no wider than `room` pixels.
    pub fn fitted(self, text: &str, room: f64) -> String {
        // Rooms are sums of widths; rounding must not cost a letter.
        if self.width(text) <= room + 1e-6 {
            return text.to_owned();
        }
        let room = room - self.advance('…');
        let mut width = 0.0;
        let mut kept = String::new();
        for c in text.chars() {
            width += self.advance(c);
            if width > room {
                break;
            }
            kept.push(c);
        }
        kept.push('…');
        kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FONT: Font = Font { size: 10.0, bold: false };

    #[test]
    fn widths_add_up() {
        assert_eq!(FONT.width(""), 0.0);
        assert!((FONT.width("mix") - 18.6).abs() < 1e-9);
        assert!(Font { bold: true, ..FONT }.width("mix") > FONT.width("mix"));
        assert!(FONT.width("é") > 10.0);
    }

    #[test]
    fn what_is_too_long_ends_in_an_ellipsis() {
        assert_eq!(FONT.fitted("mix", 18.7), "mix");
        let cut = FONT.fitted("a_very_long_name", 40.0);
        assert!(cut.ends_with('…') && FONT.width(&cut) <= 40.0, "{cut}");
        assert_eq!(FONT.fitted("語語語語", 40.0), "語語…");
        assert_eq!(FONT.fitted("mix", 0.0), "…", "no room still shows that something is there");
    }
}
