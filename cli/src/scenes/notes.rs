//! What of a graph no picture shows, said rather than passed over.

use phenomenon_compiler::diagnostics::{Place, listed};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_runtime::render::CALLED_ROOTS;

use crate::terminal;

/// Says which roots and which requirements of a graph no picture depends on.
pub fn tell_idle(graph: &Graph) {
    tell_idle_roots(graph);
    tell_requirements(graph);
}

/// Says that a graph without a material is shown nowhere in a scene that is there to show it.
pub fn tell_unseen(graph: &Graph) {
    let has = |kind| graph.root(kind).is_some();
    if has(RootKind::Material) || has(RootKind::Environment) {
        return;
    }
    let of = if graph.roots.is_empty() {
        "it has no roots at all".to_owned()
    } else {
        let kinds = graph.roots.iter().map(|root| root.kind.name());
        format!("its roots are {}", listed(kinds))
    };
    terminal::tell(&format!(
        "note: nothing is seen of `{}`, for it has neither a material nor an environment root; {of}",
        graph.name,
    ));
}

/// Says that something is black because its graph lacks the root that is called.
pub fn tell_black(graph: &Graph, root: RootKind, place: &Place) {
    let what = if root == RootKind::Environment { "the environment" } else { "the object" };
    terminal::tell(&format!(
        "note: {}: `{}` has no `{}` root, so {what} is black",
        shown(place),
        graph.name,
        root.name(),
    ));
}

/// A place in a line.
pub fn shown(place: &Place) -> String {
    let (line, column) = place.line_column();
    format!("{}:{line}:{column}", place.file.name)
}

fn tell_idle_roots(graph: &Graph) {
    let kinds = graph.roots.iter().map(|root| root.kind);
    let idle: Vec<&str> =
        kinds.filter(|kind| !CALLED_ROOTS.contains(kind)).map(RootKind::name).collect();
    if !idle.is_empty() {
        terminal::tell(&format!(
            "note: `{}` is checked whole, but this renderer does not call shaders of type {}; it calls {}",
            graph.name,
            listed(idle),
            listed(CALLED_ROOTS.iter().map(|kind| kind.name())),
        ));
    }
}

/// Says which requirements of a graph this renderer does not meet.
fn tell_requirements(graph: &Graph) {
    let requirements = &graph.requirements;
    let choices = requirements.choices.iter().filter(|choice| !MET.contains(choice));
    let mut unmet: Vec<String> =
        choices.map(|(key, value)| format!("`{key}` to be `{value}`")).collect();
    if requirements.texture > 1 {
        unmet.push(format!("{} texture spaces", requirements.texture));
    }
    if requirements.bump > 0 {
        unmet.push(format!("{} bump bases", requirements.bump));
    }
    if !requirements.derivative.is_empty() {
        unmet.push("surface derivatives".into());
    }
    if requirements.volume_level > 0 {
        unmet.push("volumes in order".into());
    }
    if !unmet.is_empty() {
        let (name, unmet) = (&graph.name, unmet.join(", "));
        terminal::tell(&format!(
            "note: `{name}` requires {unmet}, which this renderer does not do"
        ));
    }
}

/// What this renderer does anyway: it traces all rays, casts shadows and hits both faces.
const MET: [(&&str, &&str); 4] =
    [(&"face", &"both"), (&"scanline", &"off"), (&"shadow", &"on"), (&"trace", &"on")];
