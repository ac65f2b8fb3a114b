//! Whole pictures: the same film and the same rays from every engine, whatever the number of threads,
//! the batch size and the forms of the node bodies; and the monoliths within rounding of them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::check::{OnDisk, read_graph_file};
use phenomenon_compiler::engine::jit::Generator;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shader, Simd};
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::Literal;
use phenomenon_runtime::film;
use phenomenon_runtime::monoliths::{self, MonolithError};
use phenomenon_runtime::render::{Rendered, Settings, render};
use phenomenon_runtime::scene::Scene;
use phenomenon_runtime::scene_file::{MaterialRef, MaterialSource, read_scene, settings};

const GRAPHS: [&str; 3] = [
    "graphs/constant/constant_simple.json",
    "graphs/glass/advanced_glass.json",
    "graphs/rainbow/rainbow.json",
];

/// Further ones written by hand, and tried in fewer ways.
const BY_HAND: [&str; 6] = [
    "graphs/aniso/aniso_brdf.json",
    "graphs/cd/cd.json",
    "graphs/silk/silk.json",
    "graphs/snow/snow.json",
    "graphs/sunglasses/sunglasses.json",
    "graphs/xray/xray.json",
];

/// With a texture, an array, a struct and a list of shaders; nobody wrote it by hand.
const PAINTED: &str = "graphs/painted/painted.json";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The default scene with the graph on its sphere, or the scene of the teapot with it on the mesh.
fn scene_text(shape: &str, graph: &str) -> String {
    let path = root().join("scenes").join(format!("{shape}.json"));
    let text = std::fs::read_to_string(path).unwrap();
    let file = format!("\"file\": \"../{graph}\"");
    let changed = match shape {
        "default" => text.replace("\"subject\": true", &file),
        _ => text.replace("\"file\": \"../graphs/glass/advanced_glass.json\"", &file),
    };
    assert!(changed.contains(&file), "{shape} takes no graph");
    changed
}

/// Builds a scene; `shader` makes a shader of each material's graph and values.
fn scene(
    shape: &str,
    graph: &str,
    mut shader: impl FnMut(Graph, &[(String, Literal)]) -> Arc<dyn Shade>,
) -> Scene {
    let library = NodeLibrary::standard();
    let folder = root().join("scenes");
    let file = read_scene(shape, scene_text(shape, graph).as_bytes(), &folder);
    assert!(file.findings.is_empty(), "{:?}", file.findings);
    let material = |material: &MaterialRef| -> Result<Arc<dyn Shade>, std::convert::Infallible> {
        let MaterialSource::File(path) = &material.source else { panic!("no subject is left") };
        let graph = read_graph_file(path, &library).graph.unwrap();
        let (values, findings) = settings(material, &graph, &OnDisk);
        assert!(findings.is_empty(), "{findings:?}");
        Ok(shader(graph, &values))
    };
    file.scene.unwrap().build(material).unwrap()
}

fn compiled(shape: &str, graph: &str, options: Options) -> Scene {
    scene(shape, graph, |graph, values| {
        Arc::new(Shader::new(Arc::new(graph), values, options).unwrap())
    })
}

/// What finds a monolith.
type Find = fn(&str, &[(String, Literal)]) -> Option<Result<Box<dyn Shade>, MonolithError>>;

/// With monoliths wherever there are any.
fn by_hand(shape: &str, graph: &str, find: Find) -> Scene {
    scene(shape, graph, |graph, values| match find(&graph.name, values) {
        Some(found) => Arc::from(found.unwrap()),
        None => Arc::new(Shader::new(Arc::new(graph), values, Options::default()).unwrap()),
    })
}

fn picture(scene: &Scene, threads: usize, batch: usize, size: (u32, u32)) -> Rendered {
    let settings = Settings {
        width: size.0,
        height: size.1,
        samples: 2,
        threads,
        batch,
        ..Settings::default()
    };
    render(scene, &settings, &|_, _| ()).unwrap()
}

fn exr(rendered: &Rendered) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film.exr");
    film::write(&rendered.film, &path, 1.0).unwrap();
    std::fs::read(path).unwrap()
}

#[test]
fn every_engine_renders_the_same_bytes_with_the_same_rays() {
    let size = (28, 20);
    for graph in GRAPHS.into_iter().chain([PAINTED]) {
        for shape in ["default", "teapot"] {
            let walk = Options { engine: Engine::Walk, ..Options::default() };
            let expected = picture(&compiled(shape, graph, walk), 1, 256, size);
            let bytes = exr(&expected);
            assert!(expected.statistics.rays.eye == 28 * 20 * 2);
            let engines = [Engine::Walk, Engine::Batch, Engine::Jit, Engine::Auto];
            let engines = engines.map(|engine| (engine, None));
            let cranelift = (Engine::Jit, Some(Generator::Cranelift));
            for (engine, generator) in engines.into_iter().chain([cranelift]) {
                for simd in [Simd::Native, Simd::Portable] {
                    for batch in [1, 7, 256] {
                        let options =
                            Options { engine, simd, generator, batch, ..Options::default() };
                        let scene = compiled(shape, graph, options);
                        for threads in [1, 2] {
                            let rendered = picture(&scene, threads, batch, size);
                            let what =
                                format!("{graph} on {shape}, {options:?}, {threads} threads");
                            assert_eq!(
                                rendered.statistics.rays, expected.statistics.rays,
                                "{what}"
                            );
                            assert!(exr(&rendered) == bytes, "{what}");
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn what_is_written_by_hand_is_the_same_in_every_engine() {
    let size = (40, 30);
    for graph in GRAPHS.into_iter().chain(BY_HAND) {
        for shape in ["default", "teapot"] {
            let engines = [
                (Engine::Walk, None),
                (Engine::Batch, None),
                (Engine::Jit, Some(Generator::Native)),
                (Engine::Jit, Some(Generator::Cranelift)),
            ];
            let rendered = engines.map(|(engine, generator)| {
                let options = Options { engine, generator, ..Options::default() };
                let rendered = picture(&compiled(shape, graph, options), 2, 256, size);
                (exr(&rendered), rendered.statistics.rays)
            });
            for (other, (engine, generator)) in rendered.iter().zip(engines) {
                assert!(*other == rendered[0], "{graph} on {shape}, {engine:?} {generator:?}");
            }
        }
    }
}

#[test]
fn monoliths_are_within_rounding_or_the_same_to_the_bit() {
    let size = (64, 48);
    for graph in GRAPHS.into_iter().chain(BY_HAND) {
        for shape in ["default", "teapot"] {
            let jit = picture(&compiled(shape, graph, Options::default()), 2, 256, size);
            let same = picture(&by_hand(shape, graph, monoliths::find_same_bits), 2, 256, size);
            assert_eq!(same.statistics.rays, jit.statistics.rays, "{graph} on {shape}");
            assert!(exr(&same) == exr(&jit), "{graph} on {shape}");
            let monolith = picture(&by_hand(shape, graph, monoliths::find), 2, 256, size);
            let difference = film::compare(&jit.film, &monolith.film).unwrap();
            assert!(difference.encoded.rms < 5e-3, "{graph} on {shape}: {difference:?}");
            let (a, b) = (jit.statistics.rays, monolith.statistics.rays);
            let kinds = [
                (a.eye, b.eye),
                (a.reflection, b.reflection),
                (a.refraction, b.refraction),
                (a.transparent, b.transparent),
                (a.probe, b.probe),
                (a.shadow, b.shadow),
                (a.environment, b.environment),
            ];
            for (composed, by_hand) in kinds {
                let apart = composed.abs_diff(by_hand) as f64;
                assert!(apart <= 0.005 * composed.max(1) as f64, "{graph} on {shape}: {a:?} {b:?}");
            }
        }
    }
}
