use crate::nodes::{Definition, FINITE, Kind, Output, Overload, Signature};
use crate::state::Field;

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    let fields: Vec<Field> =
        Field::ALL.iter().copied().filter(|field| !field.is_of_light()).collect();
    Definition {
        signature: Signature {
            name: "state",
            group: "state",
            doc: "The fields of the state, one output each.".into(),
            source: "mental ray manual, miState",
            inputs: Vec::new(),
            outputs: fields
                .iter()
                .map(|field| Output {
                    name: field.name(),
                    doc: field.doc().into(),
                    value_type: field.value_type(),
                    range: FINITE,
                })
                .collect(),
            kind: Kind::Fields(fields),
        },
        overloads: vec![Overload { generic: None, code: None, guards: Vec::new() }],
    }
}
