use crate::nodes::{BLACK, Definition, Input, Kind, NOT_NEGATIVE, Output, Overload, Signature};
use crate::values::Type;

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    Definition {
        signature: Signature {
            name: "light_loop",
            group: "scopes",
            doc: "Evaluates `body` once for every light sample that can reach the point and sums the \
                  colours, in the order of the lights, then of their samples, in 32 bits. A \
                  sample's colour is that of its light divided by the light's number of samples. \
                  Alpha is 1."
                .into(),
            source: "mental ray manual, mi_sample_light",
            inputs: vec![
                Input {
                    name: "lights",
                    doc: "The lights to run over; none given: every light of the scene.".into(),
                    value_type: Type::Lights,
                    default: Vec::new().into(),
                    range: NOT_NEGATIVE,
                    avoid: None,
                    guarded: false,
                    scoped: false,
                    list: false,
                },
                Input {
                    name: "body",
                    doc: "What one light sample adds; may read the outputs of `light` and \
                          `light_color`."
                        .into(),
                    value_type: Type::Color,
                    default: BLACK.into(),
                    range: NOT_NEGATIVE,
                    avoid: None,
                    guarded: false,
                    scoped: true,
                    list: false,
                },
            ],
            outputs: vec![Output {
                name: "color",
                doc: "The sum.".into(),
                value_type: Type::Color,
                range: NOT_NEGATIVE,
            }],
            kind: Kind::LightLoop,
        },
        overloads: vec![Overload { generic: None, code: None, guards: vec![None, None] }],
    }
}
