//! The words of reasons.

use phenomenon_compiler::diagnostics::Place;
use phenomenon_compiler::specialise::{Fate, Reason};
use phenomenon_compiler::state::RayType;

use super::claim::Claim;
use super::reach::Refusal;
use crate::link::notes::line_of;
use crate::link::uncompilable::place_of_node;
use crate::render::Entry;

/// Why a row is on: who asks, and how many nodes besides.
pub(super) fn asks(claim: &Claim<'_>, ray_types: &[RayType], others: usize) -> String {
    let node = &claim.part.node;
    let verb = match claim.entry {
        Entry::LightLoops => "loops over lights",
        Entry::SampleLoops => "draws samples",
        _ => "asks for it",
    };
    let mut words = format!("{node} {verb}");
    if let Some(samples) = claim.part.samples {
        words += &format!(", {samples} a point");
    }
    words += &format!(" in {}", claim.root());
    if !ray_types.is_empty() {
        let names: Vec<&str> = ray_types.iter().map(|of| of.name()).collect();
        words += &format!(", for rays of type {}", names.join(", "));
    }
    words + &and_others(others, "asks", "ask")
}

/// Where more nodes do the same: "; 2 other nodes ask".
fn and_others(others: usize, one: &str, many: &str) -> String {
    match others {
        0 => String::new(),
        1 => format!("; another node {one} too"),
        others => format!("; {others} other nodes {many} too"),
    }
}

/// Why a claim comes to nothing.
pub(super) fn refused(claim: &Claim<'_>, refusal: Refusal) -> String {
    let node = &claim.part.node;
    match refusal {
        Refusal::Folded => match &claim.part.fate {
            Fate::Folded(reasons) => folded(claim, reasons),
            _ => format!("{node} is never asked for"),
        },
        Refusal::AboutNothing => format!("{node} is given no texture"),
        Refusal::Unconnected => format!("{node} is not connected to {}", claim.root()),
        Refusal::NoRays(ray_type) => {
            format!("{node} asks for it for {} rays alone, and none is cast", ray_type.name())
        }
        Refusal::NoShadowRays => {
            format!("only {} asks for it, by {node}, and no shadow ray is cast", claim.root())
        }
        Refusal::LightsOfShadows => {
            format!("{node} asks in {}, which sees its lights unshadowed", claim.root())
        }
        Refusal::TraceDepth => {
            format!("the trace depth of the scene is 0: no ray that {node} asks for is cast")
        }
        Refusal::NoLights => {
            format!("the scene has no lights: {node} in {} has none to ask about", claim.root())
        }
        Refusal::NoLightOfTheList => {
            format!("the scene has none of the lights that {node} in {} names", claim.root())
        }
        Refusal::NoEnvironment => {
            format!("the scene has no environment: {node} is answered with nothing")
        }
        Refusal::NoSamples => format!("{node} is given a count of 0"),
    }
}

fn folded(claim: &Claim<'_>, reasons: &[Reason]) -> String {
    let node = &claim.part.node;
    let told = reasons.iter().take(2).map(|reason| {
        let place = place_of_node(&claim.graph.used.document, &reason.node.name);
        format!("{reason}{}", at(place.as_ref()))
    });
    let told: Vec<String> = told.collect();
    let more = match reasons.len() {
        0..=2 => String::new(),
        more => format!("; and {} other inputs on the way to it are never asked for", more - 2),
    };
    format!("{}; so {node} is never asked{more}", told.join("; "))
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
