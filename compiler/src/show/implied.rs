//! Defaults that are evaluated though they have no box: fields of the state, and the nodes some
//! inputs stand for.

use std::fmt::Write;

use crate::effects::Asked;
use crate::nodes::{DefaultValue, Kind, NodeLibrary};
use crate::state::Iterated;
use crate::values::Type;

use super::theme::Accent;
use super::values;

/// Nodes told below one another; a default of another crate's node may lead back to itself.
const DEEPEST: usize = 4;
/// Most characters told of one.
const LONGEST: usize = 1_000;

/// A mark in the header of a node.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Badge {
    /// Its colours.
    pub accent: Accent,
    /// Its text.
    pub text: &'static str,
    /// Whether it is due to a default, not to the node itself.
    pub by_default: bool,
}

/// A default that is evaluated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Implied {
    /// `state.normal`, or the type of the node.
    pub text: String,
    /// The same with all that the node reads by default in turn.
    pub told: String,
    /// Its colours, where it is more than arithmetic.
    pub accent: Option<Accent>,
    /// What it asks of the renderer.
    pub asks: Option<Badge>,
}

/// What is said in the header of a node.
pub(super) fn badge(kind: &Kind) -> Option<Badge> {
    let (accent, text) = match kind {
        Kind::Plain | Kind::List(_) => return None,
        Kind::Fields(_) => (Accent::State, "state"),
        Kind::Request(effect) => match effect.asked() {
            Asked::LightColors | Asked::LightDensity => (Accent::Light, "light"),
            Asked::Texels | Asked::TextureSize => (Accent::State, "texture"),
            Asked::Rays(_) => (Accent::Ray, "ray"),
        },
        Kind::Loop(Iterated::Lights, _) => (Accent::Light, "light loop"),
        Kind::Loop(Iterated::Samples, _) => (Accent::Scope, "loop"),
        Kind::Scope(_) => (Accent::Scope, "scope"),
    };
    Some(Badge { accent, text, by_default: false })
}

/// What `default` stands for.
pub(super) fn implied(library: &NodeLibrary, default: &DefaultValue) -> Implied {
    let text = values::default(default, Type::Generic).text;
    let asks = asks(library, default, DEEPEST);
    let accent = match default {
        DefaultValue::State(_) => Some(Accent::State),
        _ => asks.as_ref().map(|badge| badge.accent),
    };
    let mut told = String::new();
    tell(library, default, DEEPEST, &mut told);
    Implied { text, told, accent, asks }
}

/// The first request among a default's node and what that reads by default.
fn asks(library: &NodeLibrary, default: &DefaultValue, deepest: usize) -> Option<Badge> {
    let (DefaultValue::Node(name), Some(deepest)) = (default, deepest.checked_sub(1)) else {
        return None;
    };
    let signature = library.signature(library.find(name)?);
    if let Kind::Request(_) | Kind::Loop(..) = signature.kind {
        return badge(&signature.kind).map(|badge| Badge { by_default: true, ..badge });
    }
    signature.inputs.iter().find_map(|input| asks(library, &input.default, deepest))
}

/// Writes `lambert(normal = state.normal, …)`.
fn tell(library: &NodeLibrary, default: &DefaultValue, deepest: usize, told: &mut String) {
    told.push_str(&values::default(default, Type::Generic).text);
    let DefaultValue::Node(name) = default else { return };
    let Some(node_type) = library.find(name) else { return };
    let inputs = &library.signature(node_type).inputs;
    let Some(deepest) = deepest.checked_sub(1).filter(|_| told.len() < LONGEST) else {
        told.push_str("(…)");
        return;
    };
    for (at, input) in inputs.iter().enumerate() {
        told.push_str(if at == 0 { "(" } else { ", " });
        let _ = write!(told, "{} = ", input.name);
        tell(library, &input.default, deepest, told);
    }
    if !inputs.is_empty() {
        told.push(')');
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nodes::{Definition, node, state};
    use crate::state::Field;

    #[test]
    fn nodes_without_a_box_are_told_with_all_they_read() {
        let library = NodeLibrary::standard();
        let direction = implied(&library, &node("reflection_direction"));
        assert_eq!((direction.accent, direction.asks), (None, None));
        assert_eq!(
            direction.told,
            "reflection_direction(direction = state.direction, normal = state.normal, \
             normal_geom = state.normal_geom)"
        );
        let light = implied(&library, &node("light_color"));
        assert_eq!((light.text.as_str(), light.accent), ("light_color", Some(Accent::Light)));
        assert!(light.asks.is_some_and(|badge| badge.by_default && badge.text == "light"));
        // What it reads by default asks the light, so it does, too.
        let lambert = implied(&library, &node("lambert"));
        assert_eq!(lambert.accent, Some(Accent::Light));
        assert_eq!(implied(&library, &state(Field::U)).told, "state.u");
        let unknown = implied(&library, &node("no_such_node"));
        assert_eq!((unknown.told.as_str(), unknown.accent), ("no_such_node", None));
    }

    #[test]
    fn defaults_that_lead_back_to_themselves_end() {
        let mut library = NodeLibrary::standard();
        let add = library.find("dot").expect("a node of the library");
        let mut definition: Definition = library.definition(add).clone();
        for input in &mut definition.signature.inputs {
            input.default = node("dot");
        }
        library.add(definition);
        let implied = implied(&library, &node("dot"));
        assert_eq!(implied.asks, None);
        assert!(implied.told.contains("(…)") && implied.told.len() < 2 * LONGEST);
    }
}
