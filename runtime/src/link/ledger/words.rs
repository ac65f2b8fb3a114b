//! The words of reasons.

use std::collections::BTreeSet;

use phenomenon_compiler::diagnostics::Place;
use phenomenon_compiler::specialise::{Fate, Reason};
use phenomenon_compiler::state::RayType;

use super::claim::Claim;
use super::reach::Refusal;
use crate::link::notes::line_of;
use crate::link::uncompilable::place_of_node;
use crate::render::Entry;

/// Why a row is on: who asks, and how many nodes besides.
pub(super) fn asks(
    entry: Entry,
    claim: &Claim<'_>,
    ray_types: &BTreeSet<RayType>,
    others: usize,
) -> String {
    let mut words = format!("{} {}", claim.part.node, does(entry));
    if let Some(samples) = claim.part.samples {
        words += &format!(", {samples} a point,");
    }
    words += &format!(" in {}", claim.root());
    if !ray_types.is_empty() {
        words += &format!(", for rays of type {}", names(ray_types));
    }
    match others {
        0 => words,
        1 => words + "; another node does too",
        others => words + &format!("; {others} other nodes do too"),
    }
}

fn names(ray_types: &BTreeSet<RayType>) -> String {
    ray_types.iter().map(|of| of.name()).collect::<Vec<_>>().join(", ")
}

/// What a node does that has the renderer do something.
fn does(entry: Entry) -> &'static str {
    match entry {
        Entry::Reflection => "casts reflection rays",
        Entry::Refraction => "casts refraction rays",
        Entry::Transparent => "casts transparent rays",
        Entry::Probe => "probes for the next surface",
        Entry::Environment => "looks up the environment",
        Entry::LightLoops => "loops over lights",
        Entry::LightDensities => "asks for the density of the environment light",
        Entry::ShadowRays => "asks what lights send",
        Entry::SampleLoops => "draws samples",
        Entry::Texture => "reads it",
        Entry::TextureLevels => "reads a texture by what a pixel covers",
        Entry::Footprints => "reads what a pixel covers",
        Entry::Coordinates => "reads surface coordinates",
        Entry::Derivatives => "reads how points move with u and v",
        Entry::SecondCoordinates => "reads the second set of coordinates",
        Entry::VertexColors => "reads colours of corners",
        Entry::ObjectFields => "reads what is known of its object",
        Entry::Motion => "reads the time",
        Entry::EnvironmentShader | Entry::ShadowShaders | Entry::Tree => "asks for it",
    }
}

/// Whether a claim comes to nothing because of the type of the ray.
pub(super) fn depends_on_ray_type(claim: &Claim<'_>, refusal: Refusal) -> bool {
    match (&claim.part.fate, refusal) {
        (Fate::Folded { reasons, .. }, Refusal::Folded) => {
            reasons.iter().any(Reason::depends_on_ray_type)
        }
        _ => false,
    }
}

/// Why a claim comes to nothing; `likewise` are the other types of ray for which the same is true.
pub(super) fn refused(claim: &Claim<'_>, refusal: Refusal, likewise: &BTreeSet<RayType>) -> String {
    let (node, root) = (&claim.part.node, claim.root());
    match refusal {
        Refusal::Folded => folded(claim, likewise),
        Refusal::AboutNothing if claim.entry == Entry::Texture => {
            format!("{node} is given no texture")
        }
        Refusal::AboutNothing => format!("{node} stands in no loop over lights"),
        Refusal::Unconnected => format!("{node} is not connected to {root}"),
        Refusal::NoRays(ray_type) => {
            let name = ray_type.name();
            format!("{node} is evaluated for rays of type {name} alone, and none is cast")
        }
        Refusal::NoShadowRays => {
            format!("only {root} evaluates {node}, and no shadow ray is cast")
        }
        Refusal::LightsOfShadows => {
            format!("{node} stands in {root}, which sees its lights unshadowed")
        }
        Refusal::TraceDepth => {
            let kind = match claim.entry {
                Entry::Reflection => "reflection",
                _ => "refraction",
            };
            format!("the trace depth of the scene allows no {kind}: {node} casts nothing")
        }
        Refusal::NoLights => {
            format!("the scene has no lights: {node} in {root} has none to ask about")
        }
        Refusal::NoLightOfTheList => {
            format!("the scene has none of the lights that {node} in {root} names")
        }
        Refusal::NoEnvironmentLight => {
            format!("no light of the scene is its environment: {node} is answered with 0")
        }
        Refusal::NoEnvironment => {
            format!("the scene has no environment: {node} is answered with nothing")
        }
        Refusal::NoSamples => format!("{node} is given a count of 0"),
    }
}

fn folded(claim: &Claim<'_>, likewise: &BTreeSet<RayType>) -> String {
    let node = &claim.part.node;
    let (reasons, more) = match &claim.part.fate {
        Fate::Folded { reasons, more } => (&reasons[..], *more),
        _ => (&[][..], false),
    };
    if reasons.is_empty() {
        return format!("nothing that is evaluated leads to {node}");
    }
    let told = reasons.iter().map(|reason| {
        let place = place_of_node(&claim.graph.used.document, &reason.node.name);
        reason.told(&at(place.as_ref()))
    });
    let mut words = told.collect::<Vec<_>>().join("; ");
    words += &match (reasons.len(), more) {
        (1, _) => format!(", which leads to {node}"),
        (_, false) => format!("; both lead to {node}"),
        (_, true) => format!("; these and others lead to {node}"),
    };
    if !likewise.is_empty() {
        words += &format!("; likewise for rays of type {}", names(likewise));
    }
    words
}

fn at(place: Option<&Place>) -> String {
    place.map_or(String::new(), |place| format!(" ({})", line_of(place)))
}

/// Why a row is off where no node would ask for it.
pub(super) fn nobody(entry: Entry) -> &'static str {
    match entry {
        Entry::Reflection => "no graph of the scene has a node that casts reflection rays",
        Entry::Refraction => "no graph of the scene has a node that casts refraction rays",
        Entry::Transparent => "no graph of the scene has a node that casts transparent rays",
        Entry::Probe => "no graph of the scene has a node that probes",
        Entry::Environment => "the scene has no environment: what leaves it sees black",
        Entry::EnvironmentShader => "the scene has no environment: there is nothing to shade",
        Entry::LightLoops => "no graph of the scene has a loop over lights",
        Entry::LightDensities => {
            "no graph of the scene has a node that asks for densities of lights"
        }
        Entry::ShadowRays => "no graph of the scene has a node that asks what a light sends",
        Entry::ShadowShaders => {
            "no material has a shadow root: the first surface on the way to a light ends its ray"
        }
        Entry::SampleLoops => "no graph of the scene has a loop over samples: one ray a request",
        Entry::Texture => "no graph of the scene has a node that reads a texture",
        Entry::TextureLevels => "no texture is read by what a pixel covers",
        Entry::Footprints => "no node reads what a pixel covers: rays have no cones",
        Entry::Coordinates => "no node reads u or v",
        Entry::Derivatives => "no node reads how points move with u and v",
        Entry::SecondCoordinates => "no node reads the second set of coordinates",
        Entry::VertexColors => "no node reads colours of corners",
        Entry::ObjectFields => "no node reads anything of its object",
        Entry::Tree => "the scene has no surfaces: rays meet nothing",
        Entry::Motion => "no node reads time, and nothing moves",
    }
}
