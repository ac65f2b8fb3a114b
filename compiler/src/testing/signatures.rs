//! What signatures keep to.

use crate::nodes::{DefaultValue, Implied, Input, Kind, NodeLibrary, Signature};
use crate::values::{Literal, Type};

use super::subjects::Subjects;

/// Names are there once, docs are sentences, defaults are of the type and within the range.
///
/// # Panics
/// If that does not hold.
pub fn signatures_are_sound(subjects: &Subjects) {
    let library = subjects.library();
    for (node_type, definition) in subjects.iter() {
        let signature = &definition.signature;
        let name = &*signature.name;
        assert_eq!(library.find(name), Some(node_type), "{name} is listed twice");
        if let Err(error) = definition.check() {
            panic!("{error}");
        }
        assert!(!signature.doc.is_empty() && !signature.outputs.is_empty(), "{name}");
        assert!(library.groups().iter().any(|group| group.name == signature.group), "{name}");
        for overload in &definition.overloads {
            assert_eq!(overload.guards.len(), signature.inputs.len(), "{name}");
        }
        for (at, input) in signature.inputs.iter().enumerate() {
            assert!(input.doc.ends_with('.'), "{name}.{}", input.name);
            assert_eq!(signature.input(&input.name), Some(at), "{name}.{} twice", input.name);
            let guards = definition.overloads.iter().map(|overload| &overload.guards[at]);
            assert!(guards.map(Option::is_some).all(|guard| guard == input.guarded));
            let named = input.choices.is_empty() || input.fixed;
            assert!(named && (!input.fixed || input.value_type == Type::Integer), "{name}");
            check_default(library, name, input);
            check_implied(library, signature, input);
        }
        for (at, output) in signature.outputs.iter().enumerate() {
            assert!(output.doc.ends_with('.'), "{name}.{}", output.name);
            assert_eq!(signature.output(&output.name), Some(at), "{name}.{} twice", output.name);
        }
    }
}

fn check_implied(library: &NodeLibrary, signature: &Signature, input: &Input) {
    let Some(Implied { scope, of, .. }) = input.implied else { return };
    let scope = library.signature(library.find(scope).expect("the scope exists"));
    assert!(matches!(scope.kind, Kind::Scope(_)), "{}.{}", signature.name, input.name);
    let other = &signature.inputs[signature.input(of).expect("the input exists")];
    assert_eq!(other.value_type, input.value_type, "{}.{}", signature.name, input.name);
}

fn check_default(library: &NodeLibrary, name: &str, input: &Input) {
    let generic = input.value_type == Type::Generic;
    match &input.default {
        DefaultValue::Required => {}
        DefaultValue::Literal(literal) => {
            assert!(generic || literal.value_type() == input.value_type, "{name}.{}", input.name);
            if let Literal::Scalar(value) = literal {
                assert!(input.range.contains(&f64::from(*value)), "{name}.{}", input.name);
            }
        }
        DefaultValue::State(field) => assert_eq!(field.value_type(), input.value_type),
        DefaultValue::Node(implied) => {
            let implied = library.find(implied).expect("the implied node exists");
            let implied = library.signature(implied);
            assert_eq!(implied.outputs[0].value_type, input.value_type, "{name}.{}", input.name);
            let given = |input: &Input| !matches!(input.default, DefaultValue::Required);
            assert!(implied.inputs.iter().all(given), "{name}.{}", input.name);
        }
    }
}
