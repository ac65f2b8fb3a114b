//! What a thread renders with: queues of rays become batches of points, and those are shaded.

use std::sync::Arc;

use phenomenon_compiler::effects::{Answer, Ray};
use phenomenon_compiler::engine::{Links, Shade, Shaded};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{RayType, State};

use super::clock::Clock;
use super::costs::Costs;
use super::entry::Entry;
use super::light_lists::LightLists;
use super::lookups::CountedSurfaces;
use super::points::{Waiting, environment_state, hit_state, prepared, unit_direction};
use super::scratch::Scratch;
use super::statistics::RayCounts;
use crate::geometry::PreparedRay;
use crate::lights::Environment;
use crate::scene::Scene;

/// Deepest nesting of requests. The trace depth ends rays long before; this bounds the stack
/// should a graph change the levels its rays carry.
const NESTING_LIMIT: usize = 160;

/// Answers the requests of shaders for one thread, and counts what they cost.
pub struct Context<'s> {
    pub(super) scene: &'s Scene,
    pub(super) batch: usize,
    pub(super) counts: RayCounts,
    pub(super) points: u64,
    pub(super) clock: Clock,
    /// What is counted besides rays and points.
    pub(super) costs: Costs,
    pub(super) surfaces: CountedSurfaces<'s>,
    /// Scratch space of the requests that are not running: one is taken per nested request, so
    /// nothing is allocated per ray.
    spare: Vec<Scratch>,
    nesting: usize,
    /// Lists of lights that shaders asked for.
    pub(super) light_lists: LightLists,
    /// Of each material, then of the environment: what its shader names. Shared, so that a shading call
    /// holds on to it while the context answers requests.
    links: Arc<[Links]>,
    /// Most rays it traces: then it answers nothing any more.
    pub(super) ray_limit: u64,
    /// Space for colours that nobody looks at.
    pub(super) unseen: Vec<[f32; 3]>,
    /// Whether it only looks at the environment, to find out how bright it is.
    pub(super) looking: bool,
    /// What is being shaded, innermost; none between shaders.
    pub(super) shading: Option<RootKind>,
}

impl<'s> Context<'s> {
    /// A renderer of `scene` that shades at most `batch` points at once (at least 1).
    pub fn new(scene: &'s Scene, batch: usize) -> Self {
        let mut context = Self {
            scene,
            batch: batch.max(1),
            counts: RayCounts::default(),
            points: 0,
            clock: Clock::new(),
            costs: Costs::default(),
            surfaces: CountedSurfaces::of(scene),
            spare: Vec::new(),
            nesting: 0,
            light_lists: LightLists::default(),
            links: Arc::new([]),
            ray_limit: u64::MAX,
            unseen: Vec::new(),
            looking: false,
            shading: None,
        };
        let materials = scene.materials.iter().map(|material| &material.shader);
        let environment = scene.environment.as_ref().and_then(Environment::shader);
        context.links =
            materials.chain(environment).map(|shader| shader.link(&mut context)).collect();
        context
    }

    /// One that only looks at the environment.
    pub(super) fn looking(scene: &'s Scene, batch: usize) -> Self {
        Self { looking: true, ..Self::new(scene, batch) }
    }

    /// Counts what another did on its behalf; times are taken by its own clock, which runs on.
    pub(super) fn bear(&mut self, other: &Self) {
        self.counts += other.counts;
        self.points += other.points;
        self.costs += &other.costs;
        other.surfaces.add_to(&mut self.costs);
    }

    /// Rays so far.
    pub fn counts(&self) -> RayCounts {
        self.counts
    }

    /// Points shaded so far.
    pub fn points(&self) -> u64 {
        self.points
    }

    /// Takes the time of every camera queue, and of what is looked up.
    pub(super) fn time_all(&mut self) {
        self.clock.every_queue = true;
        self.surfaces.time_to(&self.clock.elsewhere);
    }

    /// What the effects cost so far.
    pub(super) fn costs(&self) -> Costs {
        let mut costs = self.costs.clone();
        costs.take_rays(&self.counts);
        if self.clock.every_queue {
            for (entry, passed) in Entry::ALL.into_iter().zip(self.clock.entries) {
                costs.of_mut(entry).milliseconds += passed.as_secs_f64() * 1e3;
            }
        }
        self.surfaces.add_to(&mut costs);
        costs
    }

    /// Whether it has traced more rays than it may.
    #[inline]
    pub(super) fn is_over_limit(&self) -> bool {
        self.counts.traced() > self.ray_limit
    }

    /// Runs `work`, which is done for `entry`, with scratch space, unless requests nest too deeply or there were too many
    /// rays.
    pub(super) fn nested(
        &mut self,
        entry: Option<Entry>,
        work: impl FnOnce(&mut Self, &mut Scratch),
    ) {
        if self.nesting == NESTING_LIMIT || self.is_over_limit() {
            return;
        }
        let before = self.clock.renderer(entry);
        self.nesting += 1;
        let mut scratch = self.spare.pop().unwrap_or_default();
        work(self, &mut scratch);
        self.spare.push(scratch);
        self.nesting -= 1;
        self.clock.switch(before);
    }

    /// Traces camera rays: their states hold what the whole path shares.
    pub(super) fn trace_camera_rays(
        &mut self,
        states: &[State],
        rays: &[Ray],
        answers: &mut [Answer],
    ) {
        self.nested(None, |context, scratch| {
            context.trace_queue(RayType::Eye, states, rays, answers, scratch);
        });
    }

    /// Traces a queue: intersects all rays, shades the hits material by material in batches, then
    /// the misses.
    pub(super) fn trace_queue(
        &mut self,
        ray_type: RayType,
        states: &[State],
        rays: &[Ray],
        answers: &mut [Answer],
        scratch: &mut Scratch,
    ) {
        scratch.waiting.clear();
        scratch.missed.clear();
        for (slot, (ray, answer)) in rays.iter().zip(&mut *answers).enumerate() {
            *answer = Answer::default();
            let from = &states[ray.point as usize];
            let asked = match ray_type {
                RayType::Transparent => from.direction,
                _ => ray.direction,
            };
            let Some(direction) = unit_direction(asked) else { continue };
            let Some(prepared) = self.admit(ray_type, from, ray, direction) else {
                scratch.missed.push((slot as u32, direction));
                continue;
            };
            match self.scene.intersect(&prepared, f64::INFINITY) {
                Some(hit) => {
                    let material = self.scene.material_at(&hit);
                    let (slot, origin) = (slot as u32, prepared.origin);
                    scratch.waiting.push(Waiting { slot, material, origin, direction, hit });
                }
                None => scratch.missed.push((slot as u32, direction)),
            }
        }
        scratch.waiting.sort_unstable_by_key(|waiting| (waiting.material, waiting.slot));
        self.shade_hits(ray_type, states, rays, answers, scratch);
        self.look_up_environment(states, rays, answers, scratch);
    }

    /// Counts a ray and makes it ready; none if it may not be traced.
    #[inline]
    fn admit(
        &mut self,
        ray_type: RayType,
        from: &State,
        ray: &Ray,
        direction: [f32; 3],
    ) -> Option<PreparedRay> {
        let (reflections, refractions) = (from.reflection_level, from.refraction_level);
        let depth = &self.scene.depth;
        let (allowed, count) = match ray_type {
            RayType::Eye => {
                self.counts.eye += 1;
                return Some(PreparedRay::new(ray.origin, direction));
            }
            RayType::Reflection => {
                (depth.allows_reflection(reflections, refractions), &mut self.counts.reflection)
            }
            RayType::Refraction => {
                (depth.allows_refraction(reflections, refractions), &mut self.counts.refraction)
            }
            RayType::Transparent => {
                (depth.allows_refraction(reflections, refractions), &mut self.counts.transparent)
            }
            RayType::Shadow | RayType::Environment | RayType::Displace => return None,
        };
        if !allowed {
            return None;
        }
        let prepared = prepared(from, ray, direction)?;
        *count += 1;
        Some(prepared)
    }

    fn shade_hits(
        &mut self,
        ray_type: RayType,
        states: &[State],
        rays: &[Ray],
        answers: &mut [Answer],
        scratch: &mut Scratch,
    ) {
        let Scratch { waiting, states: hits, results, .. } = scratch;
        for group in waiting.chunk_by(|a, b| a.material == b.material) {
            for batch in group.chunks(self.batch) {
                if self.scene.called_for.coordinates {
                    self.costs.of_mut(Entry::Coordinates).count += batch.len() as u64;
                }
                hits.clear();
                hits.extend(batch.iter().map(|waiting| {
                    let ray = &rays[waiting.slot as usize];
                    hit_state(self.scene, &states[ray.point as usize], ray, ray_type, waiting)
                }));
                self.shade_material(batch[0].material, RootKind::Material, hits, results);
                for (waiting, result) in batch.iter().zip(&*results) {
                    answers[waiting.slot as usize] = Answer {
                        color: result.color,
                        ok: result.ok,
                        hit: true,
                        distance: waiting.hit.t as f32,
                    };
                }
            }
        }
    }

    /// Shades points of one material; black and not ok where it has no such root.
    pub(super) fn shade_material(
        &mut self,
        material: u32,
        root: RootKind,
        states: &[State],
        results: &mut Vec<Shaded>,
    ) {
        let scene = self.scene;
        let number = material as usize;
        let material = scene.materials.get(number);
        let has_root = material.is_some_and(|material| match root {
            RootKind::Material => material.has_material,
            RootKind::Shadow => material.has_shadow,
            _ => false,
        });
        results.clear();
        results.resize(states.len(), Shaded::default());
        if let (Some(material), true) = (material, has_root) {
            self.shade(&*material.shader, number, root, states, results);
            if scene.does_everything && root == RootKind::Material {
                self.do_everything_else(material.effects, states);
            }
        }
    }

    /// What rays see that leave the scene; black and not ok where nothing says it.
    pub(super) fn shade_environment(&mut self, states: &[State], results: &mut Vec<Shaded>) {
        let scene = self.scene;
        results.clear();
        results.resize(states.len(), Shaded::default());
        match &scene.environment {
            Some(Environment::Shader(shader)) if shader.has_root(RootKind::Environment) => {
                let links = scene.materials.len();
                self.costs.of_mut(Entry::EnvironmentShader).count += states.len() as u64;
                let before = self.clock.renderer(Some(Entry::EnvironmentShader));
                self.shade(&**shader, links, RootKind::Environment, states, results);
                self.clock.switch(before);
            }
            Some(environment) => {
                for (state, result) in states.iter().zip(results) {
                    if let Some(color) = environment.color(state.direction) {
                        *result = Shaded { color, ok: true };
                    }
                }
            }
            None => {}
        }
    }

    /// Shades points by the shader with these links.
    fn shade(
        &mut self,
        shader: &dyn Shade,
        links: usize,
        root: RootKind,
        states: &[State],
        results: &mut [Shaded],
    ) {
        self.points += states.len() as u64;
        let before = self.clock.shader();
        let outer = self.shading.replace(root);
        let all = Arc::clone(&self.links);
        shader.shade_linked(root, states, &all[links], self, results);
        self.shading = outer;
        self.clock.switch(before);
    }

    /// Answers the rays that missed. An environment shader's own rays see none: it would never end.
    fn look_up_environment(
        &mut self,
        states: &[State],
        rays: &[Ray],
        answers: &mut [Answer],
        scratch: &mut Scratch,
    ) {
        let scene = self.scene;
        let Some(environment) = &scene.environment else { return };
        let Scratch { missed, states: lookups, results, .. } = scratch;
        let from = |slot: u32| &states[rays[slot as usize].point as usize];
        let before = self.clock.renderer(Some(Entry::Environment));
        missed.retain(|(slot, _)| from(*slot).ray_type != RayType::Environment);
        self.counts.environment += missed.len() as u64;
        let answer = |color, ok| Answer { color, ok, hit: false, distance: 0.0 };
        let Environment::Shader(shader) = environment else {
            for &(slot, direction) in &*missed {
                let color = environment.color(direction);
                answers[slot as usize] = answer(color.unwrap_or_default(), color.is_some());
            }
            self.clock.switch(before);
            return;
        };
        if !shader.has_root(RootKind::Environment) {
            self.clock.switch(before);
            return;
        }
        for batch in missed.chunks(self.batch) {
            lookups.clear();
            lookups.extend(batch.iter().map(|&(slot, direction)| {
                environment_state(from(slot), &rays[slot as usize], direction)
            }));
            self.shade_environment(lookups, results);
            for (&(slot, _), result) in batch.iter().zip(&*results) {
                answers[slot as usize] = answer(result.color, result.ok);
            }
        }
        self.clock.switch(before);
    }
}
