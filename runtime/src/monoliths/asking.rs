//! Asking the renderer about one point at a time.

use glam::{Vec3, Vec4};
use phenomenon_compiler::effects::{
    Answer, LightList, LightSample, Lookup, Points, Ray, Renderer, Sampling, TextureId, Trace,
};
use phenomenon_compiler::engine::Links;
use phenomenon_compiler::state::{Field, State};

use super::arithmetic::Arithmetic;
use super::site::Site;

/// The renderer, and the list of all lights if it is linked.
pub struct Asking<'r> {
    renderer: &'r mut dyn Renderer,
    lights: Option<LightList>,
    textures: &'r [TextureId],
}

/// A sample of a light, as a point sees it.
#[derive(Clone, Copy, Debug)]
pub struct Light {
    /// Unit direction towards it.
    pub direction: Vec3,
    /// Distance to it; 0 for a light at infinity.
    pub distance: f32,
    token: u64,
}

impl<'r> Asking<'r> {
    /// Nothing asked yet.
    pub fn new(links: &'r Links, renderer: &'r mut dyn Renderer) -> Self {
        let Links { light_lists, textures } = links;
        Self { renderer, lights: light_lists.first().copied(), textures }
    }

    /// Casts a ray from the point.
    pub fn trace(&mut self, trace: Trace, point: &State, direction: Vec3, site: Site) -> Answer {
        let direction = direction.into();
        let ray = Ray { point: 0, origin: point.point, direction, site: site.key() };
        let mut answers = [Answer::default()];
        self.renderer.trace(trace, std::slice::from_ref(point), &[ray], &mut answers);
        answers[0]
    }

    /// What a ray sees.
    pub fn see(&mut self, trace: Trace, point: &State, direction: Vec3, site: Site) -> Vec4 {
        self.trace(trace, point, direction, site).color.into()
    }

    /// What a ray sees, or the environment where no shader answered it.
    pub fn see_or_sky(
        &mut self,
        trace: Trace,
        point: &State,
        direction: Vec3,
        [site, sky]: [Site; 2],
    ) -> Vec4 {
        let answer = self.trace(trace, point, direction, site);
        match answer.ok {
            true => answer.color.into(),
            false => self.see(Trace::Environment, point, direction, sky),
        }
    }

    /// How many samples all lights have.
    pub fn lights(&mut self) -> usize {
        self.lights.map_or(0, |list| self.renderer.light_count(list))
    }

    /// One of the samples, if it can reach the point. Casts no ray.
    pub fn light(&mut self, point: &State, number: usize) -> Option<Light> {
        let points = Points::from(std::slice::from_ref(point));
        let mut samples = [LightSample::default()];
        self.renderer.light_samples(self.lights?, number, points, &mut samples);
        let [LightSample { direction, distance, reachable, token, .. }] = samples;
        reachable.then_some(Light { direction: direction.into(), distance, token })
    }

    /// The light of a sample that arrives at the point; casts a shadow ray.
    pub fn light_color(&mut self, point: &State, light: &Light) -> Vec3 {
        let points = Points::from(std::slice::from_ref(point));
        let mut colors = [[0.0; 3]];
        self.renderer.light_colors(points, &[light.token], &mut colors);
        colors[0].into()
    }

    /// Light that a matt surface reflects: the sum over all lights of colour times light times cosine. Casts a
    /// shadow ray for each light before the surface.
    #[inline(always)]
    pub fn matt<A: Arithmetic>(&mut self, point: &State, color: Vec3) -> Vec3 {
        let mut sum = Vec3::ZERO;
        for number in 0..self.lights() {
            let Some(light) = self.light(point, number) else { continue };
            let cosine = A::dot(point.normal.into(), light.direction);
            if cosine > 0.0 {
                sum += A::lambert(color, self.light_color(point, &light), cosine);
            }
        }
        sum
    }

    /// The colour of a picture at the point's surface coordinates, bilinear and repeated; transparent black where
    /// there is none. The number is that among [`PointShader::textures`](super::PointShader::textures).
    pub fn texel(&mut self, number: usize, point: &State) -> Vec4 {
        let texture = self.textures.get(number).copied().unwrap_or(TextureId::NONE);
        let place = Lookup { uv: point.uv, ..Lookup::default() };
        let mut colors = [None];
        self.renderer.read_texture(texture, Sampling::default(), &[place], &mut colors);
        colors[0].unwrap_or_default().into()
    }

    /// What is known of the object, the surface or the camera of a point: the first `N` numbers of a field.
    pub fn look_up<const N: usize>(&self, field: Field, point: &State) -> [f32; N] {
        let mut words = [0; Field::MOST_WORDS];
        self.renderer.objects().read(field, point, &mut words);
        std::array::from_fn(|at| f32::from_bits(words[at]))
    }
}
