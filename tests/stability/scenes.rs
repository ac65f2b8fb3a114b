//! Pictures of small scenes, in every engine.

use std::convert::Infallible;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::check::{OnDisk, read_graph_file};
use phenomenon_compiler::engine::{Options, Shade, Shader};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::camera::Camera;
use phenomenon_runtime::render::{Settings, render};
use phenomenon_runtime::scene::Scene;
use phenomenon_runtime::scene_file::{MaterialRef, MaterialSource, read_scene, settings};

/// A colour without its alpha.
pub type Color = [f32; 3];

/// The folder of a case.
pub fn folder(case: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("stability").join(case)
}

/// The text of a case's scene.
pub fn text(case: &str) -> String {
    std::fs::read_to_string(folder(case).join("scene.json")).expect("the case has a scene")
}

/// The shader of a graph in the folder `graphs`.
pub fn shader(graph: &str, options: Options) -> Arc<dyn Shade> {
    let checked = read_graph_file(&folder("graphs").join(graph), &NodeLibrary::standard());
    assert!(checked.findings.is_empty(), "{:?}", checked.findings);
    Arc::new(Shader::new(Arc::new(checked.graph.expect("it has no error")), &[], options).unwrap())
}

/// A scene of a case from its text.
pub fn scene(case: &str, text: &str, options: Options) -> Scene {
    let library = NodeLibrary::standard();
    let file = read_scene(case, text.as_bytes(), &folder(case));
    assert!(file.findings.is_empty(), "{:?}", file.findings);
    let material = |material: &MaterialRef| -> Result<Arc<dyn Shade>, Infallible> {
        let MaterialSource::File(path) = &material.source else { panic!("there is no subject") };
        let checked = read_graph_file(path, &library);
        let graph = checked.graph.unwrap_or_else(|| panic!("{:?}", checked.findings));
        let (values, findings) = settings(material, &graph, &OnDisk);
        assert!(findings.is_empty(), "{findings:?}");
        Ok(Arc::new(Shader::new(Arc::new(graph), &values, options).unwrap()))
    };
    file.scene.expect("it has no error").build(material).unwrap()
}

/// The pixels of a square picture, row by row.
///
/// # Panics
/// If engines differ in a bit or a ray, or a number is not finite.
pub fn pixels(side: u32, samples: u32, scene: impl Fn(Options) -> Scene) -> Vec<Color> {
    let settings =
        Settings { width: side, height: side, samples, threads: 1, ..Settings::default() };
    let mut found: Option<(Vec<Color>, _)> = None;
    for options in crate::nodes::engines() {
        let rendered = render(&scene(options), &settings, &|_, _| ()).unwrap();
        let pixels = rendered.film.pixels().iter().map(|pixel| [0, 1, 2].map(|at| pixel[at]));
        let pixels: Vec<Color> = pixels.collect();
        let (first, rays) = found.get_or_insert_with(|| (pixels.clone(), rendered.statistics.rays));
        assert_eq!(*rays, rendered.statistics.rays, "{options:?}");
        for (at, (pixel, first)) in pixels.iter().zip(first).enumerate() {
            assert!(pixel.iter().all(|x| x.is_finite()), "{options:?} at {at}: {pixel:?}");
            assert_eq!(pixel.map(f32::to_bits), first.map(f32::to_bits), "{options:?} at {at}");
        }
    }
    found.expect("there are engines").0
}

/// The rays through the middles of the pixels, in their order, as the renderer casts them: of directions that were
/// made unit length, and rounded to 32 bits, once more.
pub fn rays(camera: &Camera, side: u32) -> Vec<([f64; 3], [f64; 3])> {
    let ray = |at: u32| {
        let middle = [(at % side) as f32 + 0.5, (at / side) as f32 + 0.5];
        let (origin, direction) = camera.ray(middle, side, side);
        let direction = direction.map(f64::from);
        let length = dot(direction, direction).sqrt();
        (origin.map(f64::from), direction.map(|x| f64::from((x / length) as f32)))
    };
    (0..side * side).map(ray).collect()
}

/// A product of two vectors.
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Glass that neither makes nor loses light shows a white world white: how far off it may be after so many
/// boundaries, each a mix of two numbers: three roundings.
pub fn furnace(levels: i32) -> f64 {
    (1.0 + 4.0 * crate::bounds::ROUNDING).powi(levels + 1) - 1.0
}
