//! How names, lists of them and ranges stand in messages.

use std::ops::RangeInclusive;

use super::{escaped, rounded};

/// Names between backticks, at most a dozen and one: `a`, `b` and `c`.
pub fn listed<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    joined(names, "and")
}

/// The same as a choice: `a`, `b` or `c`.
pub fn listed_or<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    joined(names, "or")
}

fn joined<'a>(names: impl IntoIterator<Item = &'a str>, joint: &str) -> String {
    let names: Vec<String> =
        names.into_iter().map(|name| format!("`{}`", shortened(name))).collect();
    match names.as_slice() {
        [] => "none".into(),
        [one] => one.clone(),
        // A thirteenth is shorter than to say that there is one.
        names if names.len() <= 13 => {
            let (last, rest) = names.split_last().expect("not empty");
            format!("{} {joint} {last}", rest.join(", "))
        }
        names => format!("{} and {} more", names[..12].join(", "), names.len() - 12),
    }
}

/// A name, cut where it is too long for a message, and with nothing in it that deceives.
pub fn shortened(name: &str) -> String {
    match name.char_indices().nth(64) {
        Some((at, _)) => format!("{}…", escaped(&name[..at])),
        None => escaped(name).into_owned(),
    }
}

/// A range as text.
pub(crate) fn shown(range: &RangeInclusive<f64>) -> String {
    let (low, high) = (*range.start(), *range.end());
    match (low <= -f64::from(f32::MAX), high >= f64::from(f32::MAX)) {
        (true, true) => "the finite numbers".into(),
        (false, true) if low == f64::from(f32::MIN_POSITIVE) => "the numbers above 0".into(),
        (false, true) => format!("{} and above", rounded(low)),
        (true, false) => format!("{} and below", rounded(high)),
        (false, false) => format!("{} to {}", rounded(low), rounded(high)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_end_with_a_name_or_with_several_more() {
        let names = ["n"; 20];
        assert_eq!(listed([]), "none");
        assert_eq!(listed(["a", "b"]), "`a` and `b`");
        assert_eq!(listed_or(["a", "b", "c"]), "`a`, `b` or `c`");
        assert!(listed(names[..13].iter().copied()).ends_with("`n` and `n`"));
        assert!(listed(names[..14].iter().copied()).ends_with("`n` and 2 more"));
    }

    #[test]
    fn names_are_cut_and_escaped() {
        assert_eq!(shortened("a\u{1b}b"), "a\\u{1b}b");
        assert_eq!(shortened(&"é".repeat(64)), "é".repeat(64));
        assert_eq!(shortened(&"é".repeat(65)), format!("{}…", "é".repeat(64)));
    }
}
