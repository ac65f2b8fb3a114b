//! The reader and the canonical form.

use phenomenon_compiler::diagnostics::{Finding, Place};
use phenomenon_compiler::document::{Document, Value, ValueKind, canonical, read};

/// Reads bytes. What is read has its places in order, and its canonical form reads back to the
/// same document and is its own canonical form. What is not read is one finding inside the text.
pub fn read_anything(bytes: &[u8]) {
    match read("file.json", bytes) {
        Ok(document) => {
            visit(&document, &document.root, &mut 0);
            let form = canonical(&document);
            let again = read("form.json", form.as_bytes());
            let again = again.unwrap_or_else(|finding| panic!("{finding}\n{form}"));
            assert!(same(&document.root, &again.root), "other values:\n{form}");
            assert_eq!(canonical(&again), form, "formatting twice changes the text");
        }
        Err(finding) => hold(&finding),
    }
}

/// What every finding holds to.
pub fn hold(finding: &Finding) {
    assert!(!finding.message.is_empty() && !finding.help.is_empty(), "{finding}");
    assert!(finding.message.len() < 4000 && finding.help.len() < 4000, "{finding}");
    inside(&finding.place);
    for related in &finding.related {
        inside(&related.place);
        assert!(!related.message.is_empty());
    }
}

fn inside(place: &Place) {
    let text = &place.file.text;
    assert!(place.start <= place.end && place.end <= text.len());
    assert!(text.is_char_boundary(place.start) && text.is_char_boundary(place.end));
    assert!(place.line_column() <= place.end_line_column());
    assert!(place.length() <= place.end - place.start);
}

/// Places: inside their parents and in file order. Lines and columns take time, so only those of
/// every 50th are looked at.
fn visit(document: &Document, value: &Value, seen: &mut usize) {
    if seen.is_multiple_of(50) {
        inside(&document.place(value));
    }
    *seen += 1;
    let text = &document.file.text;
    assert!(text.is_char_boundary(value.start) && text.is_char_boundary(value.end));
    let mut end = value.start;
    match &value.kind {
        ValueKind::Array(elements) => {
            for element in elements {
                assert!(end <= element.start && element.end <= value.end);
                end = element.end;
                visit(document, element, seen);
            }
        }
        ValueKind::Object(members) => {
            for member in members {
                assert!(end <= member.key_start && member.key_end <= member.value.start);
                assert!(member.value.end <= value.end);
                end = member.value.end;
                visit(document, &member.value, seen);
            }
        }
        _ => {}
    }
}

/// Whether two values are equal but for their places.
fn same(a: &Value, b: &Value) -> bool {
    match (&a.kind, &b.kind) {
        (ValueKind::Array(a), ValueKind::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b))
        }
        (ValueKind::Object(a), ValueKind::Object(b)) => {
            a.len() == b.len()
                && a.iter().zip(b).all(|(a, b)| a.key == b.key && same(&a.value, &b.value))
        }
        (a, b) => a == b,
    }
}
