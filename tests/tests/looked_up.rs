//! What no state holds is looked up, in every engine, and only where a graph reads it.

use std::cell::Cell;
use std::sync::Arc;

use phenomenon_compiler::effects::{Answer, Ray, Renderer, Trace};
use phenomenon_compiler::engine::{Shade, Shaded};
use phenomenon_compiler::graph::{Binding, RootKind};
use phenomenon_compiler::state::{Footprint, Objects, State, Surface, Surfaces};
use phenomenon_compiler::testing::build::{Build, Built, every_engine};
use phenomenon_runtime::camera::Camera;
use phenomenon_runtime::geometry::{Mesh, Transform};
use phenomenon_runtime::render::Context;
use phenomenon_runtime::scene::{Scene, SceneBuilder};

/// Counts what it is asked for.
#[derive(Default)]
struct Counting {
    /// Derivatives by u, by v, colours, second coordinates, footprints.
    asked: [Cell<usize>; 5],
}

impl Counting {
    fn note(&self, at: usize) -> Surface {
        self.asked[at].set(self.asked[at].get() + 1);
        Surface {
            vertex_color: [0.5, 0.25, 0.125, 1.0],
            second_uv: [3.0, 4.0],
            ..Surface::default()
        }
    }
}

impl Surfaces for Counting {
    fn derivative_u(&self, _: &State) -> [f32; 3] {
        self.note(0).derivative_u
    }
    fn derivative_v(&self, _: &State) -> [f32; 3] {
        self.note(1).derivative_v
    }
    fn vertex_color(&self, _: &State) -> [f32; 4] {
        self.note(2).vertex_color
    }
    fn second_uv(&self, _: &State) -> [f32; 2] {
        self.note(3).second_uv
    }
    fn footprint(&self, _: &State) -> Footprint {
        self.note(4).footprint
    }
}

impl Renderer for Counting {
    fn trace(&mut self, _: Trace, _: &[State], _: &[Ray], answers: &mut [Answer]) {
        answers.fill(Answer::default());
    }
    fn objects(&self) -> Objects<'_> {
        Objects { surfaces: self, ..Objects::default() }
    }
}

fn state(output: &str) -> impl Fn(&mut Build) -> Binding {
    move |build| build.node("state", &[]).output(output)
}

/// A vector as a colour.
fn shown(build: &mut Build, vector: Binding) -> Binding {
    let split = build.node("split_vector", &[("vector", vector)]);
    let [r, g, b] = ["x", "y", "z"].map(|name| split.output(name));
    build.node("combine_color", &[("r", r), ("g", g), ("b", b)]).first()
}

#[test]
fn what_no_graph_reads_is_not_worked_out() {
    let looking: [(&str, [usize; 5]); 5] = [
        ("point", [0; 5]),
        ("derivative_u", [1, 0, 0, 0, 0]),
        ("derivative_v", [0, 1, 0, 0, 0]),
        ("vertex_color", [0, 0, 1, 0, 0]),
        ("dp_dy", [0, 0, 0, 0, 1]),
    ];
    for (field, expected) in looking {
        let mut build = Build::new();
        let value = state(field)(&mut build);
        let color = if field == "vertex_color" { value } else { shown(&mut build, value) };
        let built = build.material(color);
        for options in every_engine() {
            let shader = built.shader(&[], options);
            let mut renderer = Counting::default();
            let points = [State::default(); 11];
            let mut results = [Shaded::default(); 11];
            shader.shade(RootKind::Material, &points, &mut renderer, &mut results);
            let asked = renderer.asked.map(|asked| asked.get());
            assert_eq!(asked, expected.map(|each| each * 11), "{field} {options:?}");
            if field == "vertex_color" {
                assert_eq!(results[10].color, [0.5, 0.25, 0.125, 1.0]);
            }
        }
    }
}

#[test]
fn a_tangent_is_looked_up_only_where_roughnesses_differ() {
    for (across, expected) in [(0.1, 0), (0.2, 5)] {
        let mut build = Build::new();
        let number = |value| phenomenon_compiler::testing::build::scalar(value);
        let inputs = [("u", number(0.5)), ("v", number(0.25)), ("roughness_v", number(across))];
        let direction = build.node("glossy_reflection_direction", &inputs).first();
        let color = shown(&mut build, direction);
        let built = build.material(color);
        for options in every_engine() {
            let mut renderer = Counting::default();
            let mut results = [Shaded::default(); 5];
            let shader = built.shader(&[], options);
            shader.shade(RootKind::Material, &[State::default(); 5], &mut renderer, &mut results);
            assert_eq!(renderer.asked[0].get(), expected, "{across} {options:?}");
        }
    }
}

/// A rectangle that is turned, sized and moved, in front of a camera that looks along -x at it.
fn scene(built: &Built, options: phenomenon_compiler::engine::Options) -> Scene {
    let camera = Camera::new([9.0, 2.0, 3.0], [1.0, 2.0, 3.0], [0.0, 1.0, 0.0], 90.0).unwrap();
    let mut builder = SceneBuilder::new(camera);
    let material = builder.material(Arc::new(built.shader(&[], options)));
    let mut mesh = Mesh::rectangle(2.0, 4.0);
    mesh.colors = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0; 3]];
    let mesh = mesh.with_second_set(&Mesh { uvs: vec![[0.25, 0.75]; 4], ..mesh.clone() }).unwrap();
    // It faces +x: its x goes down and is 3 times as long.
    let place = Transform::new([3.0, 1.0, 1.0], [0.0, 0.0, -90.0], [1.0, 2.0, 3.0]);
    builder.mesh(&mesh, &place, material).unwrap();
    builder.sphere([0.0; 3], 1.0, &Transform::default(), material).unwrap();
    builder.build().unwrap()
}

/// What rays along -x find at heights and depths.
fn seen(build: impl Fn(&mut Build) -> Binding, at: &[[f32; 2]]) -> Vec<[f32; 3]> {
    let mut found: Option<Vec<[f32; 3]>> = None;
    for options in every_engine() {
        let mut graph = Build::new();
        let color = build(&mut graph);
        let built = graph.material(color);
        let scene = scene(&built, options);
        let states: Vec<State> =
            at.iter().map(|[y, z]| State { point: [5.0, *y, *z], ..State::default() }).collect();
        let ray = |(point, state): (u32, &State)| Ray {
            point,
            origin: state.point,
            direction: [-1.0, 0.0, 0.0],
            site: 0,
        };
        let rays: Vec<Ray> = (0..).zip(&states).map(ray).collect();
        let mut answers = vec![Answer::default(); rays.len()];
        Context::new(&scene, 64).trace(Trace::Reflection, &states, &rays, &mut answers);
        let colors: Vec<[f32; 3]> =
            answers.iter().map(|answer| [0, 1, 2].map(|at| answer.color[at])).collect();
        if let Some(found) = &found {
            assert_eq!(*found, colors, "{options:?}");
        }
        found = Some(colors);
    }
    found.unwrap_or_default()
}

fn close(found: [f32; 3], expected: [f32; 3]) {
    let near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 3e-6);
    assert!(near, "{found:?} for {expected:?}");
}

#[test]
fn surfaces_move_with_their_coordinates_in_the_scene() {
    let of = |name: &'static str| {
        move |build: &mut Build| {
            let vector = state(name)(build);
            shown(build, vector)
        }
    };
    // Width 2 three times as long, downwards; depth 4 towards -z.
    close(seen(of("derivative_u"), &[[2.0, 3.5]])[0], [0.0, -6.0, 0.0]);
    close(seen(of("derivative_v"), &[[2.0, 3.5]])[0], [0.0, 0.0, -4.0]);
    // The sphere at its equator on +x: u goes towards -z, v up.
    let tau = std::f32::consts::TAU;
    close(seen(of("derivative_u"), &[[0.0, 0.0]])[0], [0.0, 0.0, -tau]);
    close(seen(of("derivative_v"), &[[0.0, 0.0]])[0], [0.0, tau / 2.0, 0.0]);
}

#[test]
fn meshes_have_colours_and_a_second_set() {
    let colors = seen(state("vertex_color"), &[[4.999_999, 1.000_001], [2.0, 3.0], [0.0, 0.0]]);
    close(colors[0], [1.0, 0.0, 0.0]);
    close(colors[1], [0.5, 0.0, 0.5]);
    close(colors[2], [1.0; 3]);
    let second = |build: &mut Build| {
        let [u, v] = ["second_u", "second_v"].map(|name| state(name)(build));
        build.node("combine_color", &[("r", u), ("g", v)]).first()
    };
    let pairs = seen(second, &[[2.0, 3.5], [0.0, 0.0]]);
    close(pairs[0], [0.25, 0.75, 0.0]);
    // A sphere has one set.
    close(pairs[1], [0.75, 0.5, 0.0]);
}

#[test]
fn points_and_normals_are_known_in_every_space() {
    let choice = |number| Binding::Literal(phenomenon_compiler::values::Literal::Integer(number));
    let of = |kind: i32, to: i32, field: &'static str| {
        move |build: &mut Build| {
            let value = state(field)(build);
            let inputs = [("kind", choice(kind)), ("to", choice(to)), ("value", value)];
            let moved = build.node("transform_space", &inputs).first();
            shown(build, moved)
        }
    };
    // The point (1, 0.5, 4) of the scene, as the rectangle has it, and the camera.
    close(seen(of(0, 0, "point"), &[[0.5, 4.0]])[0], [0.5, 0.0, 1.0]);
    close(seen(of(0, 2, "point"), &[[0.5, 4.0]])[0], [-1.0, -1.5, -8.0]);
    close(seen(of(2, 0, "normal"), &[[0.5, 4.0]])[0], [0.0, 1.0, 0.0]);
    close(seen(of(2, 2, "normal"), &[[0.5, 4.0]])[0], [0.0, 0.0, 1.0]);
    close(seen(of(1, 0, "derivative_u"), &[[0.5, 4.0]])[0], [2.0, 0.0, 0.0]);
    // Its field of view is 90 degrees, the depth 8.
    let on_screen = |build: &mut Build| {
        let seen = build.node("world_to_screen", &[]).first();
        shown(build, seen)
    };
    close(seen(on_screen, &[[0.5, 4.0]])[0], [-0.125, -0.1875, 8.0]);
    let back = |build: &mut Build| {
        let point = build.node("screen_to_world", &[]).first();
        shown(build, point)
    };
    close(seen(back, &[[0.5, 4.0]])[0], [1.0, 0.5, 4.0]);
}
