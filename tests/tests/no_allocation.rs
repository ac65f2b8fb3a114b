//! Shading allocates nothing once everything it works in has grown to its size: counted by an allocator
//! of this test's own, on the thread that shades.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::check::{OnDisk, read_graph_file};
use phenomenon_compiler::effects::{Answer, NoScene, Ray, Renderer, Trace};
use phenomenon_compiler::engine::{Engine, Links, Options, Shade, Shaded, Shader, Simd};
use phenomenon_compiler::graph::{Binding, Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::State;
use phenomenon_compiler::testing::build::Build;
use phenomenon_compiler::values::{Literal, Type};
use phenomenon_foreign_nodes::library;
use phenomenon_runtime::monoliths;
use phenomenon_runtime::render::Context;
use phenomenon_runtime::scene::Scene;
use phenomenon_runtime::scene_file::{MaterialRef, MaterialSource, read_scene, settings};

/// Counts the allocations of each thread.
struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<u64> = const { Cell::new(0) };
}

fn count() {
    // A thread that ends may still free and allocate; nobody counts then.
    let _ = ALLOCATIONS.try_with(|allocations| allocations.set(allocations.get() + 1));
}

// SAFETY: all is left to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: the caller keeps to what this trait asks.
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(at, layout) }
    }
    unsafe fn realloc(&self, at: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        // SAFETY: as above.
        unsafe { System.realloc(at, layout, size) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// Allocations of this thread while `work` runs for the third time.
fn allocations(mut work: impl FnMut()) -> u64 {
    work();
    work();
    let before = ALLOCATIONS.get();
    work();
    ALLOCATIONS.get() - before
}

#[test]
fn what_is_allocated_is_counted() {
    assert_eq!(allocations(|| drop(std::hint::black_box(Box::new(7)))), 1);
    assert_eq!(allocations(|| ()), 0);
}

fn engines() -> Vec<Options> {
    let mut all = Vec::new();
    for simd in [Simd::Native, Simd::Portable] {
        for engine in [Engine::Walk, Engine::Batch, Engine::Jit] {
            for batch in [1, 64] {
                all.push(Options { engine, simd, batch, ..Options::default() });
            }
        }
    }
    all
}

/// The default scene with a graph on its sphere; `shader` makes a shader of a graph and its values.
fn scene(
    graph: &str,
    mut shader: impl FnMut(Graph, &[(String, Literal)]) -> Arc<dyn Shade>,
) -> Scene {
    let library = NodeLibrary::standard();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let text = std::fs::read_to_string(folder.join("default.json")).unwrap();
    let subject = format!("\"file\": \"../graphs/{graph}\"");
    let text = text.replace("\"subject\": true", &subject);
    let file = read_scene("default", text.as_bytes(), &folder);
    assert!(file.findings.is_empty(), "{:?}", file.findings);
    let material = |material: &MaterialRef| -> Result<Arc<dyn Shade>, std::convert::Infallible> {
        let MaterialSource::File(path) = &material.source else { panic!("no subject is left") };
        let path: &PathBuf = path;
        let graph = read_graph_file(path, &library).graph.unwrap();
        let (values, _) = settings(material, &graph, &OnDisk);
        Ok(shader(graph, &values))
    };
    file.scene.unwrap().build(material).unwrap()
}

/// Rays from the camera's side of the scene, a grid of them.
fn rays(from: &State) -> Vec<Ray> {
    let across = |at: u32| at as f32 / 15.5 - 1.0;
    let towards = |at: u32| [across(at % 32) * 0.5, across(at / 32) * 0.5 - 0.1, -1.0];
    let ray = |at| Ray { point: 0, origin: from.point, direction: towards(at), site: at.into() };
    (0..32 * 32).map(ray).collect()
}

#[test]
fn rays_lights_and_textures_allocate_nothing() {
    for graph in ["glass/advanced_glass.json", "painted/painted.json", "rainbow/rainbow.json"] {
        for options in engines() {
            let scene = scene(graph, |graph, values| {
                Arc::new(Shader::new(Arc::new(graph), values, options).unwrap())
            });
            nothing_is_allocated(&scene, options.batch, &format!("{graph}, {options:?}"));
        }
    }
}

/// Nothing is while a grid of rays is traced that looks at a scene.
fn nothing_is_allocated(scene: &Scene, batch: usize, what: &str) {
    let state = State { point: [0.0, 1.0, 5.0], ..State::default() };
    let rays = rays(&state);
    let mut answers = vec![Answer::default(); rays.len()];
    let mut context = Context::new(scene, batch);
    let mut asked = 0;
    let allocated = allocations(|| {
        let before = context.points();
        context.trace(Trace::Reflection, &[state], &rays, &mut answers);
        asked = context.points() - before;
    });
    assert!(asked > 500, "{what} is hardly met: {asked} points");
    assert_eq!(allocated, 0, "{what}, {asked} points");
}

#[test]
fn what_is_written_by_hand_allocates_nothing() {
    let walk = Options { engine: Engine::Walk, ..Options::default() };
    for name in monoliths::NAMES {
        for find in [monoliths::find, monoliths::find_same_bits] {
            let by_hand = || Arc::<dyn Shade>::from(find(name, &[]).unwrap().unwrap());
            if !by_hand().has_root(RootKind::Material) {
                continue;
            }
            // On the sphere, whose graph is only there to be replaced.
            let scene =
                scene("constant/constant_simple.json", |graph, values| match graph.name.as_str() {
                    "constant_simple" => by_hand(),
                    _ => Arc::new(Shader::new(Arc::new(graph), values, walk).unwrap()),
                });
            nothing_is_allocated(&scene, 64, name);
        }
    }
}

#[test]
fn loops_over_samples_allocate_nothing() {
    let mut build = Build::with(library());
    let sample = build.node("sample", &[]);
    let wave = build.node_of("sine", Type::Scalar, &[("input", sample.output("u"))]);
    let body = build.node("combine_color", &[("r", wave.first()), ("g", sample.output("v"))]);
    let count = Binding::Literal(Literal::Integer(9));
    let mean = build.node("sample_mean", &[("count", count), ("body", body.first())]);
    let built = build.material(mean.first());
    let points: Vec<State> = (0..100)
        .map(|at| State { path: at, point: [at as f32, 0.5, 0.25], ..State::default() })
        .collect();
    let mut results = vec![Shaded::default(); points.len()];
    for options in engines() {
        let shader = built.shader(&[], options);
        let links = Links::default();
        let allocated = allocations(|| {
            shader.shade_linked(RootKind::Material, &points, &links, &mut NoScene, &mut results);
        });
        assert_eq!(allocated, 0, "{options:?}");
        assert!(results.iter().all(|result| result.ok));
    }
}
