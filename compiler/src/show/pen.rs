//! Writes elements of SVG.

use std::fmt::Write;

use super::escape::xml;
use super::text::Font;

/// Most characters of a text shown to those who point at something.
const LONGEST_TIP: usize = 4_000;

/// Writes elements.
pub(super) struct Pen {
    /// What is written so far.
    pub svg: String,
}

impl Pen {
    /// Text whose middle is at `y`.
    pub fn text(&mut self, x: f64, y: f64, font: Font, fill: &str, text: &str) {
        self.styled_text(x, y, font, fill, "", text);
    }

    /// The same with further attributes.
    pub fn styled_text(&mut self, x: f64, y: f64, font: Font, fill: &str, style: &str, text: &str) {
        let weight = if font.bold { " font-weight=\"700\"" } else { "" };
        let _ = writeln!(
            self.svg,
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\"{weight} fill=\"{fill}\"{style} \
             xml:space=\"preserve\">{}</text>",
            short(x),
            short(y + font.size * 0.35),
            short(font.size),
            xml(text)
        );
    }

    /// What is told to those who point at the element that is open.
    pub fn tip(&mut self, text: &str) {
        let _ = writeln!(self.svg, "<title>{}</title>", xml(&tip(text)));
    }
}

/// `text`, cut where it is absurdly long.
pub(super) fn tip(text: &str) -> String {
    text.chars().take(LONGEST_TIP).collect()
}

/// A coordinate with a tenth of a pixel.
pub(super) fn short(x: f64) -> String {
    let text = format!("{x:.1}");
    let text = text.strip_suffix(".0").unwrap_or(&text);
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
