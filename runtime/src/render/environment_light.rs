//! The environment as a light: directions drawn where it is bright, and what it shows there.

use phenomenon_compiler::effects::{Points, Ray};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{RayType, State};

use super::context::Context;
use super::entry::Entry;
use super::points::environment_state;
use super::scratch::Scratch;
use crate::geometry::{double, single};
use crate::lights::{
    DirectionTable, Environment, Light, LightKind, LightSight, LightSource, looks, seen, tinted,
};

/// Request site of the environment's shader where a light sample looks at it.
const LOOK_SITE: u64 = 0x6c6f_6f6b;

impl<'s> Context<'s> {
    /// How densely directions of the environment are drawn. Found out once for a scene, by whoever asks first, who bears what
    /// it costs; what finds it out sees no such light itself.
    fn directions(&mut self) -> Option<&'s DirectionTable> {
        if self.looking {
            return None;
        }
        let scene = self.scene;
        let table = scene.directions.get_or_init(|| {
            let before = self.clock.renderer(Some(Entry::EnvironmentShader));
            let mut looking = Context::looking(scene, self.batch);
            let table = looking.look();
            self.bear(&looking);
            self.clock.switch(before);
            table
        });
        table.as_ref()
    }

    /// A sample of the light as a point sees it. The environment's own shader is not lit by it: it would never end.
    pub(super) fn seen_in_environment(
        &mut self,
        light: &Light,
        point: &State,
        at: [f64; 2],
    ) -> Option<LightSight> {
        if point.ray_type == RayType::Environment {
            return None;
        }
        let (towards, density) = self.directions()?.sample(at)?;
        Some(light.seen_towards(towards, density))
    }

    /// How densely the environment light draws directions, with all its samples: not at all where it lights nothing, which is
    /// its own shader.
    pub(super) fn density_of_directions(&mut self, directions: &[[f32; 3]], densities: &mut [f32]) {
        densities.fill(0.0);
        if self.shading == Some(RootKind::Environment) {
            return;
        }
        let mut kinds = self.scene.lights.iter().map(|light| light.kind);
        let light = kinds.find(|kind| matches!(kind, LightKind::Environment { .. }));
        let Some(light) = light else { return };
        let Some(table) = self.directions() else { return };
        for (direction, density) in directions.iter().zip(densities) {
            let long = double(*direction);
            let length = long.length();
            if length > 0.0 && length.is_finite() {
                *density = table.density(long / length) * light.samples() as f32;
            }
        }
    }

    /// Multiplies what arrives by what the environment shows where it comes from.
    pub(super) fn shine(
        &mut self,
        points: Points<'_>,
        colors: &mut [[f32; 3]],
        scratch: &mut Scratch,
    ) {
        let Scratch { states, results, sources, .. } = scratch;
        states.clear();
        for ((point, color), source) in points.iter().zip(&*colors).zip(&*sources) {
            let LightSource::Towards(towards) = *source else { continue };
            if *color != [0.0; 3] {
                let (origin, direction) = (point.point, single(towards));
                let ray = Ray { point: 0, origin, direction, site: LOOK_SITE };
                states.push(environment_state(point, &ray, direction));
            }
        }
        self.shade_environment(states, results);
        let lit = colors.iter_mut().filter(|color| **color != [0.0; 3]);
        for (color, seen) in lit.zip(&*results) {
            *color = if seen.ok { tinted(*color, seen.color) } else { [0.0; 3] };
        }
    }

    /// Looks at the environment in all directions.
    fn look(&mut self) -> Option<DirectionTable> {
        if let Some(Environment::Image(image)) = &self.scene.environment {
            return image.directions();
        }
        let from = State::default();
        let (mut states, mut results, mut colors) = (Vec::new(), Vec::new(), Vec::new());
        let looks: Vec<[f32; 3]> = looks().collect();
        for directions in looks.chunks(self.batch) {
            states.clear();
            states.extend(directions.iter().map(|&direction| {
                let ray = Ray { point: 0, origin: from.point, direction, site: LOOK_SITE };
                environment_state(&from, &ray, direction)
            }));
            self.shade_environment(&states, &mut results);
            colors.extend(results.iter().map(|seen| if seen.ok { seen.color } else { [0.0; 4] }));
        }
        seen(&colors)
    }
}
