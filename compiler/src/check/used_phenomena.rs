//! The phenomena a file names, as types of its nodes.

use std::rc::Rc;

use crate::document::{Reader, Value};

use super::draft::Draft;
use super::literals::beside;
use super::nested::Nested;
use super::reachable::{Named, Target, file_of};

/// Makes node types of the phenomena that `nodes` uses: of the files `named`, as far as they were
/// `checked`. What is wrong with a name is told where it stands.
pub(super) fn declare<'d>(
    reader: &mut Reader<'d>,
    nodes: Option<&'d Value>,
    draft: &mut Draft<'d>,
    mut named: Named,
    checked: &[Option<Rc<Nested>>],
) {
    for member in nodes.map_or(&[][..], Value::members) {
        let Some(value) = member.value.get("type") else { continue };
        let Some(file) = file_of(value) else { continue };
        if draft.phenomena.contains_key(file) {
            continue;
        }
        reader.object(value, "the type of a node", &["file"]);
        let nested = match named.remove(file) {
            Some(Target::Reached(at)) => checked.get(at).cloned().flatten(),
            Some(Target::Refused(finding)) => {
                finding.into_iter().for_each(|finding| reader.findings.push(finding));
                None
            }
            None => None,
        };
        let node_type = nested.map(|nested| {
            let path = beside(&reader.document.file.name, file).display().to_string();
            let node_type = draft.node_types.add(nested.definition(path));
            draft.nested.insert(node_type, nested);
            node_type
        });
        draft.phenomena.insert(file, node_type);
    }
}
