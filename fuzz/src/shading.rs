//! A graph that was checked: drawn, compiled and run.

use std::sync::Arc;

use phenomenon_compiler::effects::{
    Answer, LightList, LightMode, LightSample, Points, Ray, Renderer, Trace,
};
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::show::{ShowError, draw_dot, draw_svg};
use phenomenon_compiler::state::State;

/// Most nodes of a graph that is run: what fuzzing looks for does not need more.
const MOST_NODES: usize = 200;

/// A renderer without a scene: answers are made of the questions.
#[derive(Default, PartialEq, Debug)]
struct Nothing {
    /// Rays by kind, then light samples asked for.
    asked: [usize; 6],
}

impl Renderer for Nothing {
    fn trace(&mut self, trace: Trace, _: &[State], rays: &[Ray], answers: &mut [Answer]) {
        self.asked[trace as usize] += rays.len();
        for (ray, answer) in rays.iter().zip(answers) {
            let [x, y, z] = ray.direction;
            *answer = Answer { color: [x, y, z, 1.0], ok: x >= 0.0, hit: y >= 0.0, distance: z };
        }
    }

    fn light_list(&mut self, names: &[String], _: LightMode) -> LightList {
        LightList(names.len() as u32)
    }

    fn light_count(&mut self, list: LightList) -> usize {
        1 + (list.0 as usize).min(2)
    }

    fn light_samples(
        &mut self,
        _: LightList,
        at: usize,
        _: Points<'_>,
        samples: &mut [LightSample],
    ) {
        let direction = if at == 0 { [0.0, 0.0, 1.0] } else { [0.0, 1.0, 0.0] };
        let token = at as u64;
        samples.fill(LightSample {
            direction,
            distance: at as f32,
            reachable: at < 2,
            token,
            ..LightSample::default()
        });
    }

    fn light_colors(&mut self, _: Points<'_>, tokens: &[u64], colors: &mut [[f32; 3]]) {
        self.asked[5] += colors.len();
        for (token, color) in tokens.iter().zip(colors) {
            *color = [1.0, *token as f32, -0.0];
        }
    }
}

/// Draws the graph.
pub fn draw(graph: &Graph) {
    let drawing = draw_svg(graph);
    assert!(matches!(drawing, Ok(_) | Err(ShowError::TooManyBoxes { .. })), "{drawing:?}");
    draw_dot(graph).expect("a checked graph can be written as DOT");
}

/// Runs the graph in two engines, which agree on bits and on what they ask for.
pub fn run(graph: Graph) {
    if graph.nodes.len() > MOST_NODES {
        return;
    }
    let graph = Arc::new(graph);
    let run = |engine| {
        let options = Options { engine, batch: 8, ..Options::default() };
        let shader = Shader::new(graph.clone(), &[], options).ok()?;
        Some(RootKind::ALL.map(|root| shade(&shader, root)))
    };
    assert_eq!(run(Engine::Walk), run(Engine::Batch));
}

/// The bits of a few points, every NaN as the same one, and what was asked for.
fn shade(shader: &Shader, root: RootKind) -> Option<(Vec<[u32; 5]>, Nothing)> {
    if !shader.has_root(root) {
        return None;
    }
    let inside = State { inv_normal: true, ior: 1.5, uv: [0.25, -3.0], ..State::default() };
    let grazing = State { dot_nd: -0.0, direction: [1.0, 0.0, 0.0], ..State::default() };
    let points = [State::default(), inside, grazing];
    let mut results = [Shaded::default(); 3];
    let mut renderer = Nothing::default();
    shader.shade(root, &points, &mut renderer, &mut results);
    let bits = |number: f32| if number.is_nan() { 0x7fc0_0000 } else { number.to_bits() };
    let of = |shaded: &Shaded| {
        let [r, g, b, a] = shaded.color.map(bits);
        [r, g, b, a, u32::from(shaded.ok)]
    };
    Some((results.iter().map(of).collect(), renderer))
}
