//! Graphs that are run by every engine.

use std::sync::Arc;

use phenomenon_compiler::effects::{
    Answer, LightList, LightMode, LightSample, Lookup, Points, Ray, Renderer, Sampling, TextureId,
    Trace,
};
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::{Literal, Texture};

/// A renderer in which reflections see 1, refractions 0.5, and every texture its coordinates.
#[derive(Default)]
pub struct Asked {
    pub rays: usize,
    pub textures: Vec<Texture>,
    pub lookups: usize,
}

impl Renderer for Asked {
    fn trace(&mut self, trace: Trace, _: &[State], rays: &[Ray], answers: &mut [Answer]) {
        self.rays += rays.len();
        let x = if trace == Trace::Reflection { 1.0 } else { 0.5 };
        answers.fill(Answer { color: [x, x, x, 1.0], ok: true, hit: true, distance: 2.0 });
    }
    fn texture(&mut self, texture: &Texture) -> TextureId {
        self.textures.push(texture.clone());
        TextureId(7)
    }
    fn read_texture(
        &mut self,
        texture: TextureId,
        sampling: Sampling,
        lookups: &[Lookup],
        colors: &mut [Option<[f32; 4]>],
    ) {
        assert_eq!(texture, TextureId(7));
        assert_eq!(sampling, Sampling::default());
        self.lookups += lookups.len();
        for (Lookup { uv: [u, v], .. }, color) in lookups.iter().zip(colors) {
            *color = u.is_finite().then_some([*u, *v, 0.25, 0.5]);
        }
    }
    fn light_list(&mut self, names: &[String], _: LightMode) -> LightList {
        LightList(names.len() as u32)
    }
    fn light_count(&mut self, list: LightList) -> usize {
        list.0 as usize
    }
    fn light_samples(
        &mut self,
        _: LightList,
        _: usize,
        _: Points<'_>,
        samples: &mut [LightSample],
    ) {
        let direction = [0.0, 0.0, 1.0];
        samples.fill(LightSample { direction, reachable: true, ..LightSample::default() });
    }
    fn light_colors(&mut self, _: Points<'_>, _: &[u64], colors: &mut [[f32; 3]]) {
        colors.fill([1.0, 2.0, 4.0]);
    }
}

/// The color of a root with these values, the same in every engine, and what was asked for it.
pub fn shaded(
    graph: &Graph,
    root: RootKind,
    values: &[(&str, Literal)],
    state: State,
) -> ([f32; 4], Asked) {
    let values: Vec<(String, Literal)> =
        values.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    let mut all = Vec::new();
    for engine in [Engine::Walk, Engine::Batch, Engine::Jit] {
        let options = Options { engine, ..Options::default() };
        let shader = Shader::new(Arc::new(graph.clone()), &values, options).unwrap();
        let mut asked = Asked::default();
        let mut results = [Shaded::default()];
        shader.shade(root, &[state], &mut asked, &mut results);
        all.push((results[0].color, asked));
    }
    let (color, asked) = all.remove(0);
    for (other, of_other) in all {
        assert_eq!(color.map(f32::to_bits), other.map(f32::to_bits));
        assert_eq!((asked.rays, asked.lookups), (of_other.rays, of_other.lookups));
    }
    (color, asked)
}

pub fn color(graph: &Graph, values: &[(&str, Literal)]) -> [f32; 4] {
    shaded(graph, RootKind::Material, values, State::default()).0
}
