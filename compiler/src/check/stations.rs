//! Effects at stations that do not allow them: each shader type is called at a moment of its own,
//! and not everything can be asked of the renderer then.

use crate::diagnostics::{Code, Finding};
use crate::document::Reader;
use crate::effects::{Asked, Trace};
use crate::graph::RootKind;
use crate::nodes::{Kind, NodeType};
use crate::state::Iterated;

use super::draft::Draft;

/// Why a root of a shader type cannot do what a node does; none where it can.
fn forbidden(station: RootKind, kind: &Kind) -> Option<&'static str> {
    let asked = match kind {
        Kind::Request(effect) => Some(effect.asked()),
        _ => None,
    };
    let over_lights = matches!(kind, Kind::Loop(Iterated::Lights, _));
    let of_lights = [Asked::LightColors, Asked::LightDensity];
    let lights = over_lights || asked.is_some_and(|asked| of_lights.contains(&asked));
    let traces = asked.is_some_and(|asked| !of_lights.contains(&asked));
    let environment = asked == Some(Asked::Rays(Trace::Environment));
    match station {
        RootKind::Environment if environment => {
            Some("it is what an environment ray asks, and would ask itself")
        }
        RootKind::Light if lights => Some("it is what a light loop asks, and would ask itself"),
        RootKind::Displacement | RootKind::Geometry | RootKind::State if lights || traces => {
            Some("it runs before there is a scene to cast rays into")
        }
        RootKind::Output if lights || traces => {
            Some("it runs on finished pixels, where there is no point to cast rays from")
        }
        RootKind::Lens if lights => Some("it runs at the camera, where no surface is lit"),
        _ => None,
    }
}

/// Reports every node below a root that asks for what is not allowed there.
pub(super) fn check(reader: &mut Reader<'_>, draft: &Draft<'_>) {
    let mut reported = vec![false; draft.nodes.len()];
    for root in &draft.roots {
        let nested = draft.nested.values();
        let misapplied =
            nested.clone().any(|nested| !nested.graph.requirements.applies_to(root.kind));
        let anything = misapplied
            || draft.node_types.signatures().any(|it| forbidden(root.kind, &it.kind).is_some());
        if !anything {
            continue;
        }
        for (node, output) in draft.evaluated(root.sources()) {
            if let Some(node_type) = draft.nodes[node].node_type
                && !reported[node]
            {
                let at = (node, node_type, output);
                reported[node] = report(reader, draft, root.kind, at);
            }
        }
    }
}

fn report(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    station: RootKind,
    (node, node_type, output): (usize, NodeType, Option<usize>),
) -> bool {
    let signature = draft.node_types.signature(node_type);
    // A phenomenon asks whatever the nodes ask that its output rests on.
    let inner = draft.nested.get(&node_type);
    let why = forbidden(station, &signature.kind)
        .or_else(|| inner?.asks(output).find_map(|kind| forbidden(station, kind)));
    if let Some(inner) = inner
        && !inner.graph.requirements.applies_to(station)
    {
        let (described, station) = (draft.described(node), station.name());
        let message =
            format!("{described} stands below the root `{station}`, which its `apply` excludes");
        let place = reader.document.place_of_key(draft.nodes[node].member);
        let help =
            format!("use another phenomenon there, or add `{station}` to the `apply` of this one");
        reader.findings.push(Finding::new(Code::CONFLICTING_REQUIREMENTS, place, message, help));
        return true;
    }
    let Some(why) = why else { return false };
    let (described, station) = (draft.described(node), station.name());
    let message = format!("{described} cannot stand below the root `{station}`: {why}");
    let place = reader.document.place_of_key(draft.nodes[node].member);
    let help = format!("use it below another root, or give `{station}` what needs no rays");
    reader.findings.push(Finding::new(Code::MISPLACED_EFFECT, place, message, help));
    true
}
