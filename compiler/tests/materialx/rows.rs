//! The rows of `categories.txt`.

use crate::cases::Case;

/// How often a row's expression is evaluated for a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum How {
    /// Once.
    Whole,
    /// Once for up to three components, and once for a fourth.
    Lanes,
    /// For each component.
    Each,
    /// Never: there is nothing of ours.
    No,
}

/// What we have for a category, or for some of its nodedefs or outputs.
pub struct Row {
    /// The category.
    pub category: &'static str,
    /// The ends of nodedefs, or the outputs, it is for; all others if there are none.
    pub only: Vec<&'static str>,
    /// How it is evaluated.
    pub how: How,
    /// How far the renderer's function is off.
    pub coarse: f64,
    /// The expression, or the reason.
    pub text: &'static str,
}

impl Row {
    /// What tells it from others.
    pub fn key(&self) -> String {
        format!("{} {}", self.category, self.only.join(" "))
    }
}

/// All rows.
///
/// # Panics
/// If one cannot be read.
pub fn rows() -> Vec<Row> {
    let lines = include_str!("categories.txt").lines();
    let lines = lines.filter(|line| !line.is_empty() && !line.starts_with('#'));
    lines
        .map(|line| {
            let columns: Vec<&str> = line.splitn(3, " | ").collect();
            let [names, how, text] = columns[..] else { panic!("three columns: {line}") };
            let mut names = names.split_whitespace();
            let (how, coarse) = how.split_once(' ').unwrap_or((how, "0"));
            let coarse = coarse.parse().expect("a number");
            let how = match how {
                "whole" => How::Whole,
                "lanes" => How::Lanes,
                "each" => How::Each,
                "no" => How::No,
                _ => panic!("whole, lanes, each or no: {line}"),
            };
            Row {
                category: names.next().expect("a category"),
                only: names.collect(),
                how,
                coarse,
                text,
            }
        })
        .collect()
}

/// The row of a case: of the longest category its nodedef begins with, and of those the one that names the
/// end of the nodedef or the output, or else the one that names none.
pub fn row_of<'a>(rows: &'a [Row], case: &Case) -> Option<&'a Row> {
    let name = case.nodedef.strip_prefix("ND_")?;
    let end_of = |row: &Row| -> Option<String> {
        let end = name.strip_prefix(row.category)?;
        (end.is_empty() || end.starts_with('_')).then(|| end.trim_start_matches('_').to_owned())
    };
    let longest =
        rows.iter().filter(|row| end_of(row).is_some()).map(|row| row.category.len()).max()?;
    let mut of_category =
        rows.iter().filter(|row| row.category.len() == longest && end_of(row).is_some());
    let is_named = |row: &Row| {
        let end = end_of(row).unwrap_or_default();
        row.only.iter().any(|&only| only == end || only == case.output)
    };
    let named = of_category.clone().find(|row| is_named(row));
    named.or_else(|| of_category.find(|row| row.only.is_empty()))
}
