//! Long chains of nodes, for tests and for the bench.

use std::fmt::Write;

/// A chain of `length` sums, the first of which is the material; the last one adds to `last`.
pub fn chain(length: usize, last: &str) -> String {
    let mut text = String::from("{\"phenomenon\":\"chain\",\"nodes\":{\n");
    for at in 0..length {
        let source =
            if at + 1 < length { format!("{{\"node\":\"n{}\"}}", at + 1) } else { last.into() };
        let comma = if at + 1 < length { "," } else { "" };
        writeln!(
            text,
            "\"n{at}\":{{\"type\":\"add\",\"inputs\":{{\"a\":{source},\"b\":0.5}}}}{comma}"
        )
        .expect("a string takes any text");
    }
    text.push_str("},\"roots\":{\"material\":{\"node\":\"n0\"}}}");
    text
}
