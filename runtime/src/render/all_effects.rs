//! Doing at every point what no shader there asks for: what a renderer pays that knows nothing of its graphs. Nobody
//! looks at what comes of it.

use std::hint::black_box;

use phenomenon_compiler::effects::{Effect, EffectSet, Points, Ray, Trace};
use phenomenon_compiler::state::{RayType, State, Surfaces};

use super::context::Context;
use super::entry::Entry;
use super::light_lists::ListedSample;
use super::points::{Waiting, hit_state, prepared, unit_direction};
use crate::geometry::{double, single};

impl Context<'_> {
    /// At points that were shaded by one that asks for `asked`: looks up all there is of the surface, draws every light
    /// sample and casts its shadow ray unless the shader does, and casts a ray of each kind that the shader does not. The
    /// surfaces these rays meet are worked out, not shaded. The trace depth of the scene bounds them like any other.
    pub(super) fn do_everything_else(&mut self, asked: EffectSet, states: &[State]) {
        if self.is_over_limit() {
            return;
        }
        for state in states {
            let of = &self.surfaces;
            black_box((of.derivative_u(state), of.derivative_v(state), of.footprint(state)));
            black_box((of.vertex_color(state), of.second_uv(state)));
        }
        if !asked.contains(Effect::LightColor) {
            self.light_everything(states);
        }
        for trace in Trace::ALL {
            if !asked.contains(trace.into()) {
                self.cast(trace, states);
            }
        }
    }

    fn light_everything(&mut self, states: &[State]) {
        let scene = self.scene;
        let mut colors = std::mem::take(&mut self.unseen);
        for (number, light) in (0..).zip(&scene.lights) {
            for sample in 0..light.kind.samples() {
                let token = ListedSample { light: number, sample }.token();
                colors.clear();
                colors.resize(states.len(), [0.0; 3]);
                self.costs.of_mut(Entry::LightLoops).count += states.len() as u64;
                self.nested(Some(Entry::ShadowRays), |context, scratch| {
                    context.light_points(token, Points::from(states), &mut colors, scratch);
                });
                black_box(&colors);
            }
        }
        self.unseen = colors;
    }

    fn cast(&mut self, trace: Trace, states: &[State]) {
        let before = self.clock.renderer(Some(Effect::from(trace).into()));
        for state in states {
            let along = match trace {
                Trace::Reflection | Trace::Environment | Trace::Probe => mirrored(state),
                Trace::Refraction | Trace::Transparent => state.direction,
            };
            let Some(direction) = unit_direction(along) else { continue };
            let ray = Ray { point: 0, origin: state.point, direction, site: 0 };
            let levels = (state.reflection_level, state.refraction_level);
            let allowed = match trace {
                Trace::Reflection => self.scene.depth.allows_reflection(levels.0, levels.1),
                Trace::Refraction | Trace::Transparent => {
                    self.scene.depth.allows_refraction(levels.0, levels.1)
                }
                Trace::Environment | Trace::Probe => true,
            };
            if !allowed {
                continue;
            }
            let (ray_type, count) = match trace {
                Trace::Reflection => (RayType::Reflection, &mut self.counts.reflection),
                Trace::Refraction => (RayType::Refraction, &mut self.counts.refraction),
                Trace::Transparent => (RayType::Transparent, &mut self.counts.transparent),
                Trace::Probe => (RayType::Eye, &mut self.counts.probe),
                Trace::Environment => {
                    let environment = self.scene.environment.as_ref();
                    self.counts.environment += u64::from(environment.is_some());
                    black_box(environment.and_then(|it| it.color(direction)));
                    continue;
                }
            };
            let Some(prepared) = prepared(state, &ray, direction) else { continue };
            *count += 1;
            if let Some(hit) = self.scene.intersect(&prepared, f64::INFINITY) {
                let material = self.scene.material_at(&hit);
                let origin = prepared.origin;
                let waiting = Waiting { slot: 0, material, origin, direction, hit };
                black_box(hit_state(self.scene, state, &ray, ray_type, &waiting));
            }
        }
        self.clock.switch(before);
    }
}

/// The direction in which a mirror sends the ray that came.
fn mirrored(state: &State) -> [f32; 3] {
    let (direction, normal) = (double(state.direction), double(state.normal));
    single(direction - normal * (2.0 * direction.dot(normal)))
}
