//! The renderer as shaders see it: what they may ask of a context.

use phenomenon_compiler::effects::{
    Answer, Effect, LightList, LightMode, LightSample, Lookup, Points, Ray, Renderer, Sampling,
    TextureId, Trace,
};
use phenomenon_compiler::state::{Objects, RayType, State};
use phenomenon_compiler::values::Texture;

use super::context::Context;
use super::entry::Entry;
use super::points::{prepared, unit_direction};

impl Renderer for Context<'_> {
    fn trace(&mut self, trace: Trace, states: &[State], rays: &[Ray], answers: &mut [Answer]) {
        let entry = Some(Effect::from(trace).into());
        let ray_type = match trace {
            Trace::Reflection => RayType::Reflection,
            Trace::Refraction => RayType::Refraction,
            Trace::Transparent => RayType::Transparent,
            Trace::Environment => RayType::Environment,
            Trace::Probe => {
                return self.nested(entry, |context, _| context.probe(states, rays, answers));
            }
        };
        answers.fill(Answer::default());
        self.nested(entry, |context, scratch| {
            let batch = context.batch;
            for (rays, answers) in rays.chunks(batch).zip(answers.chunks_mut(batch)) {
                context.trace_queue(ray_type, states, rays, answers, scratch);
            }
        });
    }

    fn objects(&self) -> Objects<'_> {
        let scene = self.scene;
        let (objects, camera) = (&scene.known_objects, &scene.known_camera);
        Objects { objects, surfaces: &self.surfaces, camera }
    }

    fn texture(&mut self, texture: &Texture) -> TextureId {
        self.scene.textures.number(texture)
    }

    fn texture_size(&mut self, texture: TextureId) -> Option<[u32; 2]> {
        self.scene.textures.size(texture)
    }

    fn read_texture(
        &mut self,
        texture: TextureId,
        sampling: Sampling,
        lookups: &[Lookup],
        colors: &mut [Option<[f32; 4]>],
    ) {
        let before = self.clock.renderer(Some(Entry::Texture));
        self.costs.of_mut(Entry::Texture).count += lookups.len() as u64;
        self.costs.look_up(texture.0 as usize, lookups.len() as u64);
        self.scene.textures.read(texture, sampling, lookups, colors);
        self.clock.switch(before);
    }

    fn light_list(&mut self, names: &[String], mode: LightMode) -> LightList {
        self.light_lists.find(names, mode, &self.scene.lights)
    }

    fn light_count(&mut self, list: LightList) -> usize {
        self.light_lists.samples(list).len()
    }

    fn light_samples(
        &mut self,
        list: LightList,
        iteration: usize,
        points: Points<'_>,
        samples: &mut [LightSample],
    ) {
        let before = self.clock.renderer(Some(Entry::LightLoops));
        self.costs.of_mut(Entry::LightLoops).count += samples.len() as u64;
        self.sample_light(list, iteration, points, samples);
        self.clock.switch(before);
    }

    fn light_density(&mut self, directions: &[[f32; 3]], densities: &mut [f32]) {
        let before = self.clock.renderer(Some(Entry::LightLoops));
        self.costs.of_mut(Entry::LightLoops).count += directions.len() as u64;
        self.density_of_directions(directions, densities);
        self.clock.switch(before);
    }

    fn light_colors(&mut self, points: Points<'_>, tokens: &[u64], colors: &mut [[f32; 3]]) {
        colors.fill([0.0; 3]);
        self.nested(Some(Entry::ShadowRays), |context, scratch| {
            let batch = context.batch;
            let mut from = 0;
            for tokens in tokens.chunk_by(|a, b| a == b) {
                let colors = &mut colors[from..from + tokens.len()];
                for colors in colors.chunks_mut(batch) {
                    let points = points.part(from..from + colors.len());
                    from += colors.len();
                    context.light_points(tokens[0], points, colors, scratch);
                }
            }
        });
    }
}

impl Context<'_> {
    /// Looks for the next surface, and shades nothing.
    fn probe(&mut self, states: &[State], rays: &[Ray], answers: &mut [Answer]) {
        for (ray, answer) in rays.iter().zip(answers) {
            *answer = Answer::default();
            let Some(direction) = unit_direction(ray.direction) else { continue };
            let Some(prepared) = prepared(&states[ray.point as usize], ray, direction) else {
                continue;
            };
            self.counts.probe += 1;
            if let Some(hit) = self.scene.intersect(&prepared, f64::INFINITY) {
                *answer = Answer { color: [0.0; 4], ok: true, hit: true, distance: hit.t as f32 };
            }
        }
    }
}
