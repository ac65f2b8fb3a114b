use crate::nodes::{
    DefaultValue, Definition, FINITE, Input, Kind, ListForm, Output, Overload, Signature,
};
use crate::values::Type;

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    let overload = |generic| Overload { generic: Some(generic), code: None, guards: vec![None; 2] };
    Definition {
        signature: Signature {
            name: "element",
            group: "lists",
            doc: "One value of a list by its number, counted from 0; only the one chosen is evaluated, and it \
                  passes unchanged to the bit. A number outside the list takes the nearest value. As \
                  `select` nodes in a row."
                .into(),
            source: "",
            inputs: vec![
                Input {
                    name: "index",
                    doc: "Which one.".into(),
                    value_type: Type::Integer,
                    default: 0.into(),
                    range: FINITE,
                    guarded: false,
                    scoped: false,
                    avoid: None,
                    list: false,
                },
                Input {
                    name: "values",
                    doc: "The values, all of one type.".into(),
                    value_type: Type::Generic,
                    default: DefaultValue::Required,
                    range: FINITE,
                    guarded: false,
                    scoped: false,
                    avoid: None,
                    list: true,
                },
            ],
            outputs: vec![Output {
                name: "result",
                doc: "The value chosen, with its alpha.".into(),
                value_type: Type::Generic,
                range: FINITE,
            }],
            kind: Kind::List(ListForm::Element),
        },
        overloads: [Type::Scalar, Type::Vector, Type::Color].map(overload).into(),
    }
}
