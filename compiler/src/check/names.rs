//! Names that can stand in a path and on the command line.

use crate::diagnostics::Code;
use crate::document::{Member, Reader, Value};

use super::limits::MAX_NAME;

/// Reports a name that could not stand in a path or on the command line.
pub(super) fn check_name(reader: &mut Reader<'_>, value: &Value, what: &str, name: &str) {
    if let Some(message) = name_mistake(what, name) {
        reader.report(Code::BAD_NAME, value, message, NAME_HELP);
    }
}

/// The same for a name that is a key.
pub(super) fn check_key(reader: &mut Reader<'_>, member: &Member, what: &str) {
    check_key_as(reader, member, what, &member.key);
}

/// The same for a name that is a key in the file, if another in what was made of it.
pub(super) fn check_key_as(reader: &mut Reader<'_>, member: &Member, what: &str, name: &str) {
    if let Some(message) = name_mistake(what, name) {
        reader.report_key(Code::BAD_NAME, member, message, NAME_HELP);
    }
}

const NAME_HELP: &str = "use letters, digits, `_` and `-`, at most 256 of them";

/// What keeps a name from standing in a path or on the command line, in words that begin with `what`.
pub fn name_mistake(what: &str, name: &str) -> Option<String> {
    if name.is_empty() {
        return Some(format!("{what} is empty"));
    }
    let allowed = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-');
    if let Some(bad) = name.chars().find(|&c| !allowed(c)) {
        return Some(format!("{what} has the character {bad:?}"));
    }
    (name.chars().count() > MAX_NAME)
        .then(|| format!("{what} is longer than {MAX_NAME} characters"))
}
