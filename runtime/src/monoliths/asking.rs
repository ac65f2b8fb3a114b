//! Asking the renderer about one point at a time.

use glam::{Vec3, Vec4};
use phenomenon_compiler::effects::{Answer, LightList, LightSample, Points, Ray, Renderer, Trace};
use phenomenon_compiler::engine::Links;
use phenomenon_compiler::state::State;

/// The renderer, and the list of all lights if it is linked.
pub struct Asking<'r> {
    renderer: &'r mut dyn Renderer,
    lights: Option<LightList>,
}

impl<'r> Asking<'r> {
    /// Nothing asked yet.
    pub fn new(links: &Links, renderer: &'r mut dyn Renderer) -> Self {
        Self { renderer, lights: links.light_lists.first().copied() }
    }

    /// Casts a ray from the point.
    pub fn trace(&mut self, trace: Trace, point: &State, direction: Vec3, site: u64) -> Answer {
        let ray = Ray { point: 0, origin: point.point, direction: direction.into(), site };
        let mut answers = [Answer::default()];
        self.renderer.trace(trace, std::slice::from_ref(point), &[ray], &mut answers);
        answers[0]
    }

    /// What a ray sees, or the environment where no shader answered it. Sites `site` and
    /// `site + 1`.
    pub fn see(&mut self, trace: Trace, point: &State, direction: Vec3, site: u64) -> Vec4 {
        let answer = self.trace(trace, point, direction, site);
        let answer = match answer.ok {
            true => answer,
            false => self.trace(Trace::Environment, point, direction, site + 1),
        };
        Vec4::from(answer.color)
    }

    /// Light that a white diffuse surface reflects: the sum over all lights of colour times cosine.
    /// Casts a shadow ray for each light before the surface.
    pub fn diffuse(&mut self, point: &State) -> Vec3 {
        let Some(list) = self.lights else { return Vec3::ZERO };
        let points = Points::from(std::slice::from_ref(point));
        let mut sum = Vec3::ZERO;
        for iteration in 0..self.renderer.light_count(list) {
            let mut samples = [LightSample::default()];
            self.renderer.light_samples(list, iteration, points, &mut samples);
            let cosine = Vec3::from(samples[0].direction).dot(Vec3::from(point.normal));
            if samples[0].reachable && cosine > 0.0 {
                let mut colors = [[0.0; 3]];
                self.renderer.light_colors(points, &[samples[0].token], &mut colors);
                sum += Vec3::from(colors[0]) * cosine;
            }
        }
        sum
    }
}
