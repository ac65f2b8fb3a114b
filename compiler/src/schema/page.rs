//! Tables of keys for the reference page of scene files.

use std::fmt::Write;

use super::key::{Given, Key, Kind, Section};
use super::scene_keys::SCENE;

/// The page with its tables as the keys are now. What stands between `<!-- keys of NAME -->` and `<!-- end -->` is made
/// anew for the section called `NAME`; the rest stays.
///
/// # Errors
/// The section that has no place in the page, or the mark that names none.
pub fn scene_page(page: &str) -> Result<String, String> {
    let mut left: Vec<&Section> = SCENE.all();
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

fn table(section: &Section) -> String {
    let mut text = String::from(
        "| key | value | unit | default | range | meaning |\n| --- | --- | --- | --- | --- | --- |\n",
    );
    for key in section.keys {
        let Key { name, kind, given, unit, doc } = key;
        let default = match given {
            Given::Required => "required".into(),
            Given::Choice => "one of these".into(),
            Given::Optional => String::new(),
            Given::Default(default) => format!("`{default}`"),
        };
        let (value, range) = (value(kind), kind.range());
        let _ = writeln!(text, "| `{name}` | {value} | {unit} | {default} | {range} | {doc} |");
    }
    text
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

    #[test]
    fn a_page_without_a_section_is_refused() {
        assert_eq!(scene_page("").unwrap_err(), "scene");
        assert_eq!(scene_page("<!-- keys of nothing --><!-- end -->").unwrap_err(), "nothing");
    }
}
