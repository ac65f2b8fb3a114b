//! The environment as a light: what it sends to matt surfaces, and light samples and rays of a glaze combined.

use std::convert::Infallible;
use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::check::{check_graph, read_graph_file};
use phenomenon_compiler::document;
use phenomenon_compiler::engine::jit::Generator;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shader};
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::Literal;
use phenomenon_runtime::film::{self, Film};
use phenomenon_runtime::render::{Rendered, Settings, render};
use phenomenon_runtime::scene::Scene;
use phenomenon_runtime::scene_file::{MaterialRef, MaterialSource, read_scene};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// A ball seen from the front, under a sky that is yet to be said.
const SCENE: &str = r#"{
    "scene": "sky",
    "camera": { "position": [0, 1, 4], "look_at": [0, 0, 0], "field_of_view": 24 },
    "objects": [{ "sphere": { "radius": 1 }, "material": { "subject": true } }],
    "lights": [{ "name": "sky", "environment": { "samples": 4 } }],
    "environment": ENVIRONMENT
}"#;

const MATT: &str = r#"{ "phenomenon": "matt", "version": 1, "nodes": {
    "matt": { "type": "lambert", "inputs": { "color": [1, 1, 1] } },
    "lit": { "type": "light_loop", "inputs": { "body": { "node": "matt" } } } },
    "roots": { "material": { "node": "lit" } } }"#;

fn graph(text: &str) -> Arc<Graph> {
    let document = document::read("graph", text.as_bytes()).unwrap();
    let checked = check_graph(&document, &NodeLibrary::standard());
    Arc::new(checked.graph.unwrap_or_else(|| panic!("{:?}", checked.findings)))
}

fn scene(
    environment: &str,
    folder: &Path,
    graph: &Arc<Graph>,
    set: &[(String, Literal)],
    options: Options,
) -> Scene {
    let text = SCENE.replace("ENVIRONMENT", environment);
    let file = read_scene("sky", text.as_bytes(), folder);
    assert!(file.findings.is_empty(), "{:?}", file.findings);
    let shader = |material: &MaterialRef| -> Result<Arc<dyn Shade>, Infallible> {
        let (graph, set) = match &material.source {
            MaterialSource::File(path) => {
                let graph = read_graph_file(path, &NodeLibrary::standard()).graph;
                (Arc::new(graph.unwrap()), &[][..])
            }
            _ => (Arc::clone(graph), set),
        };
        Ok(Arc::new(Shader::new(graph, set, options).unwrap()))
    };
    file.scene.unwrap().build(shader).unwrap()
}

fn picture(scene: &Scene, samples: u32, seed: u64) -> Rendered {
    let settings =
        Settings { width: 6, height: 6, samples, seed, threads: 1, ..Settings::default() };
    render(scene, &settings, &|_, _| ()).unwrap()
}

/// A dim sky, a dark ground and a small sun, of 64 by 32 pixels.
fn sunny(folder: &Path) {
    let mut sky = Film::new(64, 32).unwrap();
    for row in 0..32 {
        for column in 0..64 {
            let light = match (column, row) {
                (36, 8) => 900.0,
                (_, 0..16) => 0.6,
                _ => 0.1,
            };
            sky.set(column, row, [light, light, light, 1.0]);
        }
    }
    film::write(&sky, &folder.join("sky.exr"), 1.0).unwrap();
}

const SUNNY: &str = r#"{ "image": "sky.exr", "rotation": 20 }"#;

#[test]
fn white_is_white_in_a_white_furnace() {
    let matt = graph(MATT);
    let here = Path::new(ROOT);
    let gradient =
        r#"{ "gradient": { "zenith": [1, 1, 1], "horizon": [1, 1, 1], "ground": [1, 1, 1] } }"#;
    for environment in [r#"{ "color": [1, 1, 1] }"#, gradient] {
        let scene = scene(environment, here, &matt, &[], Options::default());
        let lit = picture(&scene, 256, 0);
        let middle = lit.film.pixel(3, 3)[0];
        assert!((middle - 1.0).abs() < 0.02, "{middle}");
        // Half of the samples are below the surface: no ray is cast for them.
        let rays = lit.statistics.rays;
        assert_eq!(rays.reflection, 0);
        assert!(rays.shadow > rays.eye && rays.shadow < 3 * rays.eye, "{rays:?}");
    }
}

#[test]
fn every_engine_sees_the_same_light_of_a_graph() {
    let glazed = read_graph_file(
        &Path::new(ROOT).join("graphs/glazed/glazed.json"),
        &NodeLibrary::standard(),
    );
    let glazed = Arc::new(glazed.graph.unwrap_or_else(|| panic!("{:?}", glazed.findings)));
    let environment = r#"{ "file": "graphs/sky/gradient_sky.json" }"#;
    let jit = |generator| Options { engine: Engine::Jit, generator, ..Options::default() };
    let walk = Options { engine: Engine::Walk, ..Options::default() };
    let batch = Options { engine: Engine::Batch, batch: 7, ..Options::default() };
    let pictures = [walk, batch, jit(None), jit(Some(Generator::Cranelift))]
        .map(|options| picture(&scene(environment, Path::new(ROOT), &glazed, &[], options), 2, 0));
    for picture in &pictures {
        assert!(picture.film.pixels() == pictures[0].film.pixels());
        assert_eq!(picture.statistics.rays, pictures[0].statistics.rays);
        assert!(picture.film.pixels().iter().flatten().all(|x| x.is_finite()));
    }
    let red = pictures[0].film.pixel(3, 3);
    assert!(red[0] > 2.0 * red[2] && red[0] > 0.1, "{red:?}");
}

/// Mean and variance of the pixels over seeds.
fn spread(scene: &Scene) -> (f64, f64) {
    const SEEDS: u64 = 400;
    let (mut sums, mut squares) = (vec![0.0; 36], vec![0.0; 36]);
    for seed in 0..SEEDS {
        let film = picture(scene, 1, seed).film;
        for (at, pixel) in film.pixels().iter().enumerate() {
            let value = f64::from(pixel[0]);
            assert!(value.is_finite());
            sums[at] += value;
            squares[at] += value * value;
        }
    }
    let seeds = SEEDS as f64;
    let mean = sums.iter().sum::<f64>() / seeds / 36.0;
    let of_pixel = |(sum, square): (&f64, &f64)| square / seeds - (sum / seeds).powi(2);
    (mean, sums.iter().zip(&squares).map(of_pixel).sum::<f64>() / 36.0)
}

#[test]
fn light_samples_and_rays_find_the_same_and_together_with_less_noise() {
    let folder = tempfile::tempdir().unwrap();
    sunny(folder.path());
    let text = std::fs::read_to_string(Path::new(ROOT).join("graphs/glazed/glazed.json")).unwrap();
    let changed = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    };
    let root = r#""material": { "node": "shade" }"#;
    let by_light = changed("(3.14159265 * share_of_light)", "3.14159265")
        .replace(root, r#""material": { "node": "by_light" }"#);
    let by_rays = changed("(seen.hit ? 1 : share_of_ray)", "1")
        .replace(root, r#""material": { "node": "by_ray" }"#);
    for roughness in [0.08, 0.7] {
        let black = Literal::Color([0.0, 0.0, 0.0, 1.0]);
        let set = [
            ("color".to_owned(), black),
            ("glaze".to_owned(), Literal::Color([0.9, 0.9, 0.9, 1.0])),
            ("roughness".to_owned(), Literal::Scalar(roughness)),
        ];
        let [both, light, rays] = [&text, &by_light, &by_rays].map(|text| {
            spread(&scene(SUNNY, folder.path(), &graph(text), &set, Options::default()))
        });
        let told = format!("{roughness}: {both:?} {light:?} {rays:?}");
        // Means of 14,400 estimates each, three deviations apart at most.
        for alone in [light, rays] {
            let deviation = ((both.1 + alone.1) / 14_400.0).sqrt();
            assert!((both.0 - alone.0).abs() < 3.0 * deviation + 1e-3 * both.0, "{told}");
        }
        assert!(both.1 <= light.1.min(rays.1), "{told}");
    }
}
