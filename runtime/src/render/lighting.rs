//! What lights send to points, after shadows.

use phenomenon_compiler::effects::{LightList, LightSample};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{Hit, RayType, State};

use super::context::{Context, Scratch};
use super::points::place;
use crate::bvh::PrimitiveId;
use crate::geometry::{PreparedRay, RawHit, double, single, spawn_origin};
use crate::lights::{Light, LightSight};
use crate::sampling::child_path;
use crate::scene::Scene;

/// Request site of shadow rays; the light and the position among the occluders are mixed in.
const SHADOW_SITE: u64 = 0x7368_6164_6f77;

/// Something between a point and a light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Occluder {
    hit: RawHit,
    id: PrimitiveId,
    material: u32,
    /// Whether its outside faces the point.
    outwards: bool,
    /// Position of the point.
    point: u32,
}

impl Context<'_> {
    pub(super) fn sample_light(
        &mut self,
        list: LightList,
        iteration: usize,
        points: &[State],
        samples: &mut [LightSample],
    ) {
        let light = self.light(list, iteration).map(|light| &self.scene.lights[light as usize]);
        for (point, sample) in points.iter().zip(samples) {
            *sample = match light.and_then(|light| light.seen_from(point.point)) {
                Some(sight) => LightSample {
                    direction: sight.direction,
                    distance: sight.distance.unwrap_or(0.0) as f32,
                    reachable: true,
                },
                None => LightSample::default(),
            };
        }
    }

    /// Casts the shadow rays of a batch of points and writes what arrives.
    pub(super) fn light_points(
        &mut self,
        list: LightList,
        iteration: usize,
        points: &[State],
        colors: &mut [[f32; 3]],
        scratch: &mut Scratch,
    ) {
        let Some(number) = self.light(list, iteration) else { return };
        let scene = self.scene;
        let light = &scene.lights[number as usize];
        scratch.occluders.clear();
        scratch.ranges.clear();
        for (at, (point, color)) in points.iter().zip(&mut *colors).enumerate() {
            let Some(sight) = light.seen_from(point.point) else { continue };
            if sight.color == [0.0; 3] {
                continue;
            }
            // Shadow shaders see their lights unshadowed: shadows of shadows would never end.
            let shadowed = point.ray_type != RayType::Shadow;
            if shadowed && !self.gather_occluders(point, at as u32, &sight, scratch) {
                continue;
            }
            *color = sight.color;
        }
        self.filter(light, number, points, colors, scratch);
    }

    /// Collects what lies between a point and a light, sorted by distance from the point; false if
    /// anything of it is opaque.
    fn gather_occluders(
        &mut self,
        state: &State,
        point: u32,
        sight: &LightSight,
        scratch: &mut Scratch,
    ) -> bool {
        self.counts.shadow += 1;
        let scene = self.scene;
        let origin = spawn_origin(state.point, state.hit.error, state.normal_geom, sight.direction);
        let ray = PreparedRay::new(origin, sight.direction);
        let farthest = sight.distance.unwrap_or(f64::INFINITY);
        let found = &mut scratch.found;
        found.clear();
        let mut clear = true;
        scene.tree.every(&ray, farthest, |hit| {
            let material = scene.material_at(&hit);
            clear = scene.materials.get(material as usize).is_some_and(|m| m.has_shadow);
            let id = scene.tree.id(hit.slot);
            found.push(Occluder { hit, id, material, outwards: false, point });
            clear
        });
        if !clear {
            return false;
        }
        for occluder in &mut *found {
            let outside = scene.surface(&ray, &occluder.hit).normal_geom;
            let [x, y, z] = sight.direction;
            occluder.outwards = outside[0] * x + outside[1] * y + outside[2] * z < 0.0;
        }
        found.sort_unstable_by(|a, b| {
            let facing = a.outwards.cmp(&b.outwards);
            let distance = a.hit.t.total_cmp(&b.hit.t);
            let instance = a.id.instance.cmp(&b.id.instance);
            distance.then(instance).then(facing).then(a.id.primitive.cmp(&b.id.primitive))
        });
        // A ray through the edge of two triangles meets both, but passes one surface.
        found.dedup_by(|next, kept| {
            let place = |occluder: &Occluder| {
                (occluder.hit.t.to_bits(), occluder.id.instance, occluder.outwards)
            };
            place(next) == place(kept)
        });
        if !found.is_empty() {
            let start = scratch.occluders.len() as u32;
            scratch.occluders.extend_from_slice(found);
            scratch.ranges.push((point, start, found.len() as u32));
        }
        true
    }

    /// Multiplies the colours by what the occluders let through: the first of every point, then
    /// the second of every point that still gets light, and so on.
    fn filter(
        &mut self,
        light: &Light,
        number: u32,
        points: &[State],
        colors: &mut [[f32; 3]],
        scratch: &mut Scratch,
    ) {
        let Scratch { occluders, found, ranges, states, results, .. } = scratch;
        for layer in 0.. {
            ranges.retain(|&(point, _, count)| layer < count && colors[point as usize] != [0.0; 3]);
            if ranges.is_empty() {
                return;
            }
            found.clear();
            found.extend(ranges.iter().map(|&(_, start, _)| occluders[(start + layer) as usize]));
            found.sort_unstable_by_key(|occluder| (occluder.material, occluder.point));
            let site = child_path(SHADOW_SITE, u64::from(number) << 32 | u64::from(layer));
            for group in found.chunk_by(|a, b| a.material == b.material) {
                for batch in group.chunks(self.batch) {
                    states.clear();
                    states.extend(batch.iter().map(|occluder| {
                        shadow_state(
                            self.scene,
                            light,
                            &points[occluder.point as usize],
                            occluder,
                            site,
                        )
                    }));
                    self.shade_material(batch[0].material, RootKind::Shadow, states, results);
                    for (occluder, result) in batch.iter().zip(&*results) {
                        let color = &mut colors[occluder.point as usize];
                        for (channel, color) in color.iter_mut().enumerate() {
                            let passed = if result.ok { result.color[channel] } else { 0.0 };
                            *color *= passed;
                        }
                    }
                }
            }
        }
    }
}

/// The state at an occluder: the ray runs from the light to the point.
fn shadow_state(
    scene: &Scene,
    light: &Light,
    point: &State,
    occluder: &Occluder,
    site: u64,
) -> State {
    let sight = light.seen_from(point.point);
    let towards = sight.map_or([0.0, 1.0, 0.0], |sight| sight.direction);
    let origin = spawn_origin(point.point, point.hit.error, point.normal_geom, towards);
    let ray = PreparedRay::new(origin, towards);
    let surface = scene.surface(&ray, &occluder.hit);
    let (center, radius) = scene.extent;
    let reach = (double(origin) - center).length() + radius * 2.0;
    let source = light.origin(double(origin), towards, reach);
    let mut state = *point;
    state.ray_type = RayType::Shadow;
    state.incoming = [1.0; 4];
    state.path = child_path(point.path, site);
    place(&mut state, &surface, towards.map(|x| -x));
    state.origin = single(source);
    state.dist = (source - double(surface.point)).length() as f32;
    state.hit = Hit {
        instance: occluder.id.instance,
        primitive: occluder.id.primitive,
        error: surface.error,
    };
    state
}
