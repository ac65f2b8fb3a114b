use crate::nodes::{Definition, FINITE, Kind, Output, Overload, Signature};
use crate::state::Field;

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    let fields: Vec<Field> = vec![Field::LightDirection, Field::LightDistance];
    Definition {
        signature: Signature {
            name: "light",
            group: "state",
            doc:
                "Where the light sample of the loop round this node lies; only inside a light loop."
                    .into(),
            source: "mental ray manual, miState",
            inputs: Vec::new(),
            outputs: fields
                .iter()
                .map(|field| Output {
                    name: field.name().trim_start_matches("light_"),
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
