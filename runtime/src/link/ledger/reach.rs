//! Which roots are called, and for which rays: what is asked for only where nothing comes is not called for.

use phenomenon_compiler::effects::{LightMode, NamedLights};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::specialise::{Account, Fate};
use phenomenon_compiler::state::RayType;

use super::claim::{Claim, Graph};
use crate::lights::LightKind;
use crate::render::Entry;
use crate::scene::Scene;

/// What comes to the roots of a scene.
pub(super) struct Reach<'l> {
    scene: &'l Scene,
    /// Types of the rays that meet surfaces.
    cast: Vec<RayType>,
    /// Whether shadow rays are cast.
    shadows: bool,
}

impl<'l> Reach<'l> {
    /// Starts with camera rays, and follows what is asked for until nothing is added.
    pub fn of(scene: &'l Scene, graphs: &[Graph<'_>]) -> Self {
        let mut reach = Self { scene, cast: vec![RayType::Eye], shadows: false };
        loop {
            let before = (reach.cast.len(), reach.shadows);
            for claim in graphs.iter().flat_map(Graph::claims) {
                if reach.refusal(&claim).is_none() {
                    reach.follow(claim.entry);
                }
            }
            if before == (reach.cast.len(), reach.shadows) {
                return reach;
            }
        }
    }

    fn follow(&mut self, entry: Entry) {
        let ray_type = match entry {
            Entry::Reflection => RayType::Reflection,
            Entry::Refraction => RayType::Refraction,
            Entry::Transparent => RayType::Transparent,
            Entry::ShadowRays => {
                self.shadows = true;
                return;
            }
            _ => return,
        };
        if !self.cast.contains(&ray_type) {
            self.cast.push(ray_type);
        }
    }

    /// Whether shadow rays are cast.
    pub fn shadows(&self) -> bool {
        self.shadows
    }

    /// Why a claim comes to nothing; none where some point may ask.
    pub fn refusal(&self, claim: &Claim<'_>) -> Option<Refusal> {
        match claim.part.fate {
            Fate::Folded { .. } => return Some(Refusal::Folded),
            Fate::AboutNothing => return Some(Refusal::AboutNothing),
            Fate::Unconnected => return Some(Refusal::Unconnected),
            Fate::Asked => {}
        }
        if !is_done_ahead(claim.entry)
            && let Some(refusal) = self.uncalled(claim.account)
        {
            return Some(refusal);
        }
        let depth = &self.scene.depth;
        let lit = |account: &Account| {
            let lists = account.parts.iter().filter_map(|part| part.lights.as_ref());
            lists.into_iter().any(|list| self.lists_lights(list))
        };
        match claim.entry {
            Entry::Reflection if !depth.allows_reflection(0, 0) => Some(Refusal::TraceDepth),
            Entry::Refraction | Entry::Transparent if !depth.allows_refraction(0, 0) => {
                Some(Refusal::TraceDepth)
            }
            Entry::LightLoops | Entry::ShadowRays if self.scene.lights.is_empty() => {
                Some(Refusal::NoLights)
            }
            Entry::LightLoops => {
                let list = claim.part.lights.as_ref()?;
                (!self.lists_lights(list)).then_some(Refusal::NoLightOfTheList)
            }
            Entry::ShadowRays if !lit(claim.account) => Some(Refusal::NoLightOfTheList),
            // A shadow root sees its lights unshadowed: it casts no shadow rays itself.
            Entry::ShadowRays if claim.account.root == RootKind::Shadow => {
                Some(Refusal::LightsOfShadows)
            }
            Entry::SampleLoops if claim.part.samples.is_some_and(|count| count <= 0) => {
                Some(Refusal::NoSamples)
            }
            Entry::LightDensities if !self.has_environment_light() => {
                Some(Refusal::NoEnvironmentLight)
            }
            Entry::Environment if self.scene.environment.is_none() => Some(Refusal::NoEnvironment),
            _ => None,
        }
    }

    /// Why a root is not called, if it is not.
    fn uncalled(&self, account: &Account) -> Option<Refusal> {
        match (account.root, account.ray_type) {
            (RootKind::Shadow, _) if !self.shadows => Some(Refusal::NoShadowRays),
            (RootKind::Material, Some(ray_type)) if !self.cast.contains(&ray_type) => {
                Some(Refusal::NoRays(ray_type))
            }
            _ => None,
        }
    }

    fn has_environment_light(&self) -> bool {
        let mut kinds = self.scene.lights.iter().map(|light| &light.kind);
        kinds.any(|kind| matches!(kind, LightKind::Environment { .. }))
    }

    fn lists_lights(&self, list: &NamedLights) -> bool {
        let is_named = |name: &String| list.names.contains(name);
        let mut lights = self.scene.lights.iter().map(|light| &light.name);
        match list.mode {
            LightMode::All => lights.next().is_some(),
            LightMode::Listed if list.names.is_empty() => lights.next().is_some(),
            LightMode::Listed | LightMode::Inclusive => lights.any(is_named),
            LightMode::Exclusive => lights.any(|name| !is_named(name)),
        }
    }
}

/// Whether an entry is done before anybody asks, for all roots there are.
fn is_done_ahead(entry: Entry) -> bool {
    matches!(entry, Entry::Texture | Entry::Coordinates | Entry::ObjectFields)
}

/// Why a claim comes to nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Refusal {
    /// Specialisation left the node out.
    Folded,
    /// It is given no texture, or stands in no loop over lights.
    AboutNothing,
    /// Nothing connects it to its root.
    Unconnected,
    /// Its root is for rays of a type that none is of.
    NoRays(RayType),
    /// Its root is the shadow root, and no shadow ray is cast.
    NoShadowRays,
    /// A shadow root asks for lights: it sees them unshadowed.
    LightsOfShadows,
    /// The trace depth of the scene allows no such ray.
    TraceDepth,
    /// The scene has no lights.
    NoLights,
    /// It has none of those that are named.
    NoLightOfTheList,
    /// It has no light that is its environment.
    NoEnvironmentLight,
    /// It has no environment.
    NoEnvironment,
    /// The loop has no turns.
    NoSamples,
}
