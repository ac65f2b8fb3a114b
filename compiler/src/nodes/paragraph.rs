//! Documentation as written in the list.

/// Joins the lines of a doc comment.
pub fn paragraph(lines: &[&str]) -> String {
    let lines: Vec<&str> =
        lines.iter().map(|line| line.strip_prefix(' ').unwrap_or(line)).collect();
    lines.join("\n")
}
