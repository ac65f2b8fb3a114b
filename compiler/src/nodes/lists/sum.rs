use crate::nodes::finite::SUMMAND;
use crate::nodes::{
    DefaultValue, Definition, FINITE, Input, Kind, ListForm, Output, Overload, Signature,
};
use crate::values::Type;

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    let overload = |generic| Overload { generic: Some(generic), code: None, guards: vec![None; 1] };
    Definition {
        signature: Signature {
            name: "sum",
            group: "lists",
            doc: "The sum of a list, from the first value to the last, each sum rounded; a colour has the alpha \
                  of the first. As `add` nodes in a row."
                .into(),
            source: "",
            inputs: vec![
                Input {
                    name: "values",
                    doc: "The values, all of one type.".into(),
                    value_type: Type::Generic,
                    default: DefaultValue::Required,
                    range: SUMMAND,
                    guarded: false,
                    scoped: false,
                    avoid: None,
                    list: true,
                },
            ],
            outputs: vec![Output {
                name: "result",
                doc: "The sum.".into(),
                value_type: Type::Generic,
                range: FINITE,
            }],
            kind: Kind::List(ListForm::Sum),
        },
        overloads: [Type::Scalar, Type::Vector, Type::Color].map(overload).into(),
    }
}
