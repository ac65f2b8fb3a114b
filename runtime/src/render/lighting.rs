//! What lights send to points, after shadows.

use glam::DVec3;
use phenomenon_compiler::effects::{LightList, LightSample, Points};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{Hit, RayType, State};

use super::context::Context;
use super::entry::Entry;
use super::light_lists::ListedSample;
use super::points::{note, place, precise_point};
use super::scratch::{Occluder, Scratch};
use crate::geometry::single;
use crate::lights::{Light, LightKind, LightSight, LightSource};
use crate::sampling::{child_path, light_position};
use crate::scene::Scene;

/// Request site of shadow rays; the light and the position among the occluders are mixed in.
const SHADOW_SITE: u64 = 0x7368_6164_6f77;

/// The token where a list has no such light.
const NO_LIGHT: u64 = u64::MAX;

impl Context<'_> {
    pub(super) fn sample_light(
        &mut self,
        list: LightList,
        iteration: usize,
        points: Points<'_>,
        samples: &mut [LightSample],
    ) {
        let Some(&listed) = self.light_lists.samples(list).get(iteration) else {
            return samples.fill(LightSample { token: NO_LIGHT, ..LightSample::default() });
        };
        let light = &self.scene.lights[listed.light as usize];
        let token = listed.token();
        for (point, sample) in points.iter().zip(samples) {
            *sample = match self.seen(light, listed, point) {
                Some(sight) => LightSample {
                    direction: sight.direction,
                    distance: sight.distance.unwrap_or(0.0) as f32,
                    density: sight.density,
                    reachable: true,
                    token,
                },
                None => LightSample { token, ..LightSample::default() },
            };
        }
    }

    /// Casts the shadow rays of a batch of points towards one light sample and writes what arrives.
    pub(super) fn light_points(
        &mut self,
        token: u64,
        points: Points<'_>,
        colors: &mut [[f32; 3]],
        scratch: &mut Scratch,
    ) {
        let scene = self.scene;
        let listed = ListedSample::of_token(token);
        let Some(light) = scene.lights.get(listed.light as usize) else { return };
        let share = light.kind.samples() as f32;
        scratch.occluders.clear();
        scratch.ranges.clear();
        scratch.sources.clear();
        for (at, (point, color)) in points.iter().zip(&mut *colors).enumerate() {
            let sight = self.seen(light, listed, point);
            scratch.sources.push(sight.map_or(LightSource::Towards(DVec3::Y), |it| it.source));
            let Some(sight) = sight else { continue };
            if sight.color == [0.0; 3] {
                continue;
            }
            // Shadow shaders see their lights unshadowed: shadows of shadows would never end.
            let shadowed = point.ray_type != RayType::Shadow;
            if shadowed && !self.gather_occluders(point, at as u32, sight.source, scratch) {
                continue;
            }
            *color = sight.color.map(|color| color / share);
        }
        if matches!(light.kind, LightKind::Environment { .. }) {
            self.shine(points, colors, scratch);
        }
        self.filter(listed, points, colors, scratch);
    }

    /// A sample of a light as a point sees it. Where on the light it lies, point and sample alone decide: it is
    /// the same however points are grouped, and the same for all loops at the point.
    #[inline]
    fn seen(&mut self, light: &Light, listed: ListedSample, point: &State) -> Option<LightSight> {
        let at = match light.kind.has_extent() {
            true => light_position(point.path, listed.light, listed.sample),
            false => [0.5; 2],
        };
        match light.kind {
            LightKind::Environment { .. } => self.seen_in_environment(light, point, at),
            _ => light.seen_from(point.point, at),
        }
    }

    /// Collects what lies between a point and a light, sorted by distance from the point; false if
    /// anything of it is opaque.
    fn gather_occluders(
        &mut self,
        state: &State,
        point: u32,
        source: LightSource,
        scratch: &mut Scratch,
    ) -> bool {
        self.counts.shadow += 1;
        let scene = self.scene;
        // A light in the very place of the point has nothing before it.
        let Some(ray) = source.ray_from(shadow_start(scene, state), state.normal_geom) else {
            return true;
        };
        let found = &mut scratch.found;
        found.clear();
        let mut clear = true;
        scene.every(&ray, |hit| {
            let material = scene.material_at(&hit);
            clear = scene.materials.get(material as usize).is_some_and(|m| m.has_shadow);
            let id = scene.tree.id(hit.slot);
            found.push(Occluder { hit, id, material, point });
            clear
        });
        if !clear {
            return false;
        }
        found.sort_unstable_by(|a, b| {
            let facing = b.hit.inside.cmp(&a.hit.inside);
            let distance = a.hit.t.total_cmp(&b.hit.t);
            let object = a.id.object.cmp(&b.id.object);
            distance.then(object).then(facing).then(a.id.primitive.cmp(&b.id.primitive))
        });
        // A ray through the edge of two triangles meets both, but passes one surface.
        found.dedup_by(|next, kept| {
            let place = |occluder: &Occluder| {
                (occluder.hit.t.to_bits(), occluder.id.object, occluder.hit.inside)
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
        listed: ListedSample,
        points: Points<'_>,
        colors: &mut [[f32; 3]],
        scratch: &mut Scratch,
    ) {
        let Scratch { occluders, found, ranges, sources, states, results, .. } = scratch;
        for layer in 0.. {
            ranges.retain(|&(point, _, count)| layer < count && colors[point as usize] != [0.0; 3]);
            if ranges.is_empty() {
                return;
            }
            found.clear();
            found.extend(ranges.iter().map(|&(_, start, _)| occluders[(start + layer) as usize]));
            found.sort_unstable_by_key(|occluder| (occluder.material, occluder.point));
            let site = shadow_site(listed, layer);
            for group in found.chunk_by(|a, b| a.material == b.material) {
                for batch in group.chunks(self.batch) {
                    states.clear();
                    states.extend(batch.iter().map(|occluder| {
                        shadow_state(
                            self.scene,
                            sources[occluder.point as usize],
                            points.get(occluder.point as usize),
                            occluder,
                            site,
                        )
                    }));
                    self.costs.of_mut(Entry::ShadowShaders).count += states.len() as u64;
                    let before = self.clock.renderer(Some(Entry::ShadowShaders));
                    self.shade_material(batch[0].material, RootKind::Shadow, states, results);
                    self.clock.switch(before);
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

/// Request site of the shadow shaders at one of the occluders on the way to a sample.
fn shadow_site(listed: ListedSample, layer: u32) -> u64 {
    let site = child_path(SHADOW_SITE, u64::from(listed.light) << 32 | u64::from(layer));
    if listed.sample == 0 { site } else { child_path(site, u64::from(listed.sample)) }
}

/// Where the shadow rays of a point start.
fn shadow_start(scene: &Scene, state: &State) -> DVec3 {
    scene.shadow_start(&state.hit, precise_point(state), state.inv_normal)
}

/// The state at an occluder: the ray runs from the light to the point.
fn shadow_state(
    scene: &Scene,
    source: LightSource,
    point: &State,
    occluder: &Occluder,
    site: u64,
) -> State {
    let start = shadow_start(scene, point);
    let ray = source.ray_from(start, point.normal_geom);
    let towards = ray.map_or(DVec3::Y, |ray| ray.direction);
    let surface = scene.surface(start, towards, &occluder.hit);
    let (center, radius) = scene.extent;
    let reach = (start - center).length() + radius * 2.0;
    let source = source.origin(start, towards, reach);
    let mut state = *point;
    state.ray_type = RayType::Shadow;
    state.incoming = [1.0; 4];
    state.path = child_path(point.path, site);
    // The ray runs the other way than the one that found the occluder.
    place(&mut state, &surface, !occluder.hit.inside, single(-towards));
    state.origin = single(source);
    state.dist = (source - surface.position).length() as f32;
    state.hit = Hit { cone: point.hit.cone, ..note(scene, &occluder.hit, &surface) };
    state
}
