//! Tables of keys for reference pages.

use std::fmt::Write;

use crate::document::{Given, Key, Kind, Section};

/// The page with its tables as the keys are now. What stands between `<!-- keys of NAME -->` and `<!-- end -->` is made
/// anew for the section called `NAME`, which is one of `sections`; the rest stays.
///
/// # Errors
/// The section that has no place in the page, or the mark that names none.
pub fn with_tables(page: &str, sections: &[&Section]) -> Result<String, String> {
    let mut left = sections.to_vec();
    let mut text = String::new();
    let mut rest = page;
    while let Some((before, after)) = rest.split_once(MARK) {
        let (name, after) = after.split_once(" -->").unwrap_or((after, ""));
        let at = left.iter().position(|section| section.name == name).ok_or(name)?;
        let (_, after) = after.split_once(END).ok_or(name)?;
        let _ = write!(text, "{before}{MARK}{name} -->\n\n{}\n{END}", table(left.remove(at)));
        rest = after;
    }
    text.push_str(rest);
    match left.first() {
        Some(section) => Err(section.name.into()),
        None => Ok(text),
    }
}

const MARK: &str = "<!-- keys of ";
const END: &str = "<!-- end -->";

/// A column of a table: its title, and what stands in it for a key.
type Column = (&'static str, fn(&Key) -> String);

const COLUMNS: [Column; 7] = [
    ("key", |key| format!("`{}`", key.name)),
    ("of", |key| quoted(key.only)),
    ("value", |key| value(&key.kind)),
    ("unit", |key| key.unit.into()),
    ("default", default),
    ("range", |key| key.kind.range()),
    ("meaning", |key| key.doc.into()),
];

/// The table of a section, without the columns that would be empty.
fn table(section: &Section) -> String {
    let filled = |(_, cell): &Column| section.keys.iter().any(|key| !cell(key).is_empty());
    let columns: Vec<Column> = COLUMNS.into_iter().filter(filled).collect();
    let row = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut text = row(columns.iter().map(|(title, _)| (*title).to_owned()).collect());
    text.push_str(&row(columns.iter().map(|_| "---".to_owned()).collect()));
    for key in section.keys {
        text.push_str(&row(columns.iter().map(|(_, cell)| cell(key)).collect()));
    }
    text
}

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("`{word}`")).collect::<Vec<String>>().join(", ")
}

fn default(key: &Key) -> String {
    match key.given {
        Given::Required => "required".into(),
        Given::RequiredBut(types) => format!("required, but of {}", quoted(types)),
        Given::Choice => "one of these".into(),
        Given::Optional => String::new(),
        Given::Default(default) => format!("`{default}`"),
    }
}

/// What a value is, with the way to the section it has.
fn value(kind: &Kind) -> String {
    match kind.section() {
        Some(section) => format!("{0}, see [{1}](#{1})", kind.described(), section.name),
        None if matches!(kind, Kind::Settings) => format!("{}, see [set](#set)", kind.described()),
        None => kind.described(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    static ROOT: Section = Section {
        name: "root",
        what: "a root",
        keys: &[Key {
            name: "size",
            kind: Kind::Number(0.0..=1.0),
            only: &[],
            given: Given::Default("1"),
            unit: "metres",
            doc: "How large",
        }],
        one_of: &[],
    };

    #[test]
    fn tables_are_made_anew_and_the_rest_stays() {
        let page = with_tables("a\n<!-- keys of root -->old<!-- end -->\nb", &[&ROOT]).unwrap();
        assert!(page.starts_with("a\n<!-- keys of root -->\n\n| key | value |"), "{page}");
        assert!(page.contains(
            "\n| `size` | number | metres | `1` | 0 to 1 | How large |\n\n<!-- end -->\nb"
        ));
        assert_eq!(with_tables(&page, &[&ROOT]).unwrap(), page);
    }

    #[test]
    fn a_page_without_a_section_is_refused() {
        assert_eq!(with_tables("", &[&ROOT]).unwrap_err(), "root");
        let other = "<!-- keys of nothing --><!-- end -->";
        assert_eq!(with_tables(other, &[&ROOT]).unwrap_err(), "nothing");
    }
}
