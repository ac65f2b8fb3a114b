//! Requests as words: how both ways of running a graph put them to the renderer. They gather the words
//! of arguments and hand out those of answers; what an effect means is known here alone.

use crate::effects::{
    Answer, Asked, Effect, Lookup, Points, Ray, Renderer, Sampling, TextureId, Trace,
};
use crate::specialise::Subject;
use crate::state::State;

use super::links::Linked;

/// What is asked, for all points alike.
#[derive(Clone, Copy, Debug)]
pub(super) enum Question {
    /// To follow rays, with the key of their random numbers.
    Rays(Trace, u64),
    /// For the colours of the light samples with the points' tokens.
    LightColors,
    /// For the density of the environment light.
    LightDensity,
    /// For pixels of a texture.
    Texels(TextureId, Sampling),
    /// For the size of a texture.
    TextureSize(TextureId),
}

impl Question {
    /// The question of a request at a site; none if it lacks what the effect needs.
    pub(super) fn of<L>(
        effect: Effect,
        subject: Subject<L>,
        site: u64,
        links: Linked<'_>,
    ) -> Option<Self> {
        match (effect.asked(), subject) {
            (Asked::Rays(trace), _) => Some(Question::Rays(trace, site)),
            (Asked::LightColors, Subject::Light { .. }) => Some(Question::LightColors),
            (Asked::LightDensity, _) => Some(Question::LightDensity),
            (Asked::Texels, Subject::Texture(at, sampling)) => {
                Some(Question::Texels(links.texture(at), sampling))
            }
            (Asked::TextureSize, Subject::Texture(at, _)) => {
                Some(Question::TextureSize(links.texture(at)))
            }
            (Asked::LightColors | Asked::Texels | Asked::TextureSize, _) => None,
        }
    }
}

/// A request of some points, as words; kept between requests so that nothing is allocated.
#[derive(Debug, Default)]
pub(super) struct Asking {
    /// The points that ask: their numbers in the batch.
    pub numbers: Vec<u32>,
    /// Of each point, its state with the changes of scopes; empty where none changed what matters.
    pub scoped: Vec<State>,
    /// Of each point, the token of the light sample that is asked about; for light colours only.
    pub tokens: Vec<u64>,
    /// Argument words, point by point.
    pub arguments: Vec<u32>,
    /// The words of the answers, point by point.
    pub answers: Vec<u32>,
    rays: Vec<Ray>,
    traced: Vec<Answer>,
    colors: Vec<[f32; 3]>,
    directions: Vec<[f32; 3]>,
    densities: Vec<f32>,
    lookups: Vec<Lookup>,
    texels: Vec<Option<[f32; 4]>>,
}

impl Asking {
    /// Makes it ready for another request.
    pub(super) fn clear(&mut self) {
        self.numbers.clear();
        self.scoped.clear();
        self.tokens.clear();
        self.arguments.clear();
    }

    /// Puts the question of points of a batch to the renderer and writes the answers.
    pub(super) fn ask(&mut self, question: Question, batch: &[State], renderer: &mut dyn Renderer) {
        self.answers.clear();
        match question {
            Question::Rays(trace, site) => self.trace(trace, site, batch, renderer),
            Question::LightColors => self.light_colors(batch, renderer),
            Question::LightDensity => self.light_density(renderer),
            Question::Texels(texture, sampling) => self.read_texture(texture, sampling, renderer),
            Question::TextureSize(texture) => self.texture_size(texture, renderer),
        }
    }

    fn trace(&mut self, trace: Trace, site: u64, batch: &[State], renderer: &mut dyn Renderer) {
        let points = asking(batch, &self.numbers, &self.scoped);
        let width = self.arguments.len() / points.len().max(1);
        self.rays.clear();
        self.rays.extend(points.iter().enumerate().map(|(at, state)| {
            // A direction, then an origin, as far as the effect takes them.
            let (direction, origin) = match self.arguments[at * width..][..width] {
                [x, y, z] => ([x, y, z].map(f32::from_bits), state.point),
                [x, y, z, u, v, w] => {
                    ([x, y, z].map(f32::from_bits), [u, v, w].map(f32::from_bits))
                }
                _ => (state.direction, state.point),
            };
            Ray { point: points.number(at), origin, direction, site }
        }));
        self.traced.clear();
        self.traced.resize(self.rays.len(), Answer::default());
        renderer.trace(trace, points.states(), &self.rays, &mut self.traced);
        self.answers.resize(ANSWER * self.traced.len(), 0);
        let (rows, _) = self.answers.as_chunks_mut::<ANSWER>();
        for (row, answer) in rows.iter_mut().zip(&self.traced) {
            let [r, g, b, a] = answer.color.map(f32::to_bits);
            *row = [r, g, b, a, truth(answer.ok), truth(answer.hit), answer.distance.to_bits()];
        }
    }

    fn light_colors(&mut self, batch: &[State], renderer: &mut dyn Renderer) {
        let points = asking(batch, &self.numbers, &self.scoped);
        self.colors.clear();
        self.colors.resize(points.len(), [0.0; 3]);
        renderer.light_colors(points, &self.tokens, &mut self.colors);
        self.answers.resize(4 * self.colors.len(), 0);
        let (rows, _) = self.answers.as_chunks_mut::<4>();
        for (row, [r, g, b]) in rows.iter_mut().zip(&self.colors) {
            *row = [*r, *g, *b, 1.0].map(f32::to_bits);
        }
    }

    fn light_density(&mut self, renderer: &mut dyn Renderer) {
        self.directions.clear();
        let vectors = self.arguments.chunks_exact(3);
        self.directions
            .extend(vectors.map(|words| [words[0], words[1], words[2]].map(f32::from_bits)));
        self.densities.clear();
        self.densities.resize(self.directions.len(), 0.0);
        renderer.light_density(&self.directions, &mut self.densities);
        self.answers.extend(self.densities.iter().map(|density| density.to_bits()));
    }

    fn texture_size(&mut self, texture: TextureId, renderer: &mut dyn Renderer) {
        let size = renderer.texture_size(texture).unwrap_or_default();
        for _ in &self.numbers {
            self.answers.extend(size);
        }
    }

    fn read_texture(
        &mut self,
        texture: TextureId,
        sampling: Sampling,
        renderer: &mut dyn Renderer,
    ) {
        self.lookups.clear();
        let words = self.arguments.chunks_exact(sampling.words());
        self.lookups.extend(words.map(Lookup::from_words));
        self.texels.clear();
        self.texels.resize(self.lookups.len(), None);
        renderer.read_texture(texture, sampling, &self.lookups, &mut self.texels);
        for color in &self.texels {
            self.answers.extend(color.unwrap_or_default().map(f32::to_bits));
            self.answers.push(truth(color.is_some()));
        }
    }
}

/// The points with these numbers in a batch, or what scopes made of them.
pub(super) fn asking<'a>(
    batch: &'a [State],
    numbers: &'a [u32],
    scoped: &'a [State],
) -> Points<'a> {
    if scoped.is_empty() { Points::numbered(batch, numbers) } else { Points::from(scoped) }
}

/// Words of the answer to a ray.
const ANSWER: usize = 7;

/// A truth as a word.
fn truth(value: bool) -> u32 {
    if value { u32::MAX } else { 0 }
}
