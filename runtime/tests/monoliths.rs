//! Every shipped graph and its monolith: the same colours to within rounding and the same requests, and over
//! the compiler's arithmetic the same bits of both.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document;
use phenomenon_compiler::effects::{
    Answer, Effect, LightList, LightMode, LightSample, Lookup, Points, Ray, Renderer, Sampling,
    TextureId, Trace,
};
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::{
    Field, FieldSet, Footprint, Object, Objects, Place, RayType, State, Surface,
};
use phenomenon_compiler::testing::random::Random;
use phenomenon_compiler::values::{Literal, Space, Texture};
use phenomenon_runtime::monoliths::arithmetic::Arithmetic;
use phenomenon_runtime::monoliths::{
    Asking, NAMES, Parameter, PointShader, Pointwise, find, find_same_bits,
};

/// A renderer whose answers change smoothly with what is asked, and which keeps requests.
#[derive(Default)]
struct Mock {
    place: Place,
    asked: Vec<(Effect, u64, [u32; 3])>,
}

impl Mock {
    /// On an object that is turned, scaled and moved, with a surface that is not square.
    fn new() -> Self {
        let to_world = glam::Mat4::from_scale_rotation_translation(
            glam::Vec3::new(2.0, 1.0, 0.5),
            glam::Quat::from_euler(glam::EulerRot::XYZ, 0.4, -1.1, 2.0),
            glam::Vec3::new(0.3, -0.2, 4.0),
        );
        let object = Object {
            to_world: to_world.to_cols_array(),
            to_object: to_world.inverse().to_cols_array(),
            ..Object::at(0)
        };
        let footprint = Footprint {
            point: [[0.01, 0.002, -0.03], [0.004, -0.02, 0.005]],
            uv: [[0.01, 0.001], [-0.002, 0.03]],
        };
        let surface = Surface {
            derivative_u: [0.9, 0.3, -0.4],
            derivative_v: [-0.2, 0.7, 0.1],
            footprint,
            ..Surface::default()
        };
        Self { place: Place { object, surface, ..Place::default() }, asked: Vec::new() }
    }

    /// How often each effect was asked for.
    fn requests(&self) -> BTreeMap<Effect, usize> {
        let mut requests = BTreeMap::new();
        for (effect, ..) in &self.asked {
            *requests.entry(*effect).or_default() += 1;
        }
        requests
    }

    /// What was asked, and where, in whatever order.
    fn sites(&self) -> Vec<(Effect, u64)> {
        let mut sites: Vec<_> =
            self.asked.iter().map(|(effect, site, _)| (*effect, *site)).collect();
        sites.sort_unstable();
        sites
    }

    /// The same with every bit of what was asked.
    fn sorted(&self) -> Vec<(Effect, u64, [u32; 3])> {
        let mut asked = self.asked.clone();
        asked.sort_unstable();
        asked
    }
}

const LIGHTS: [[f32; 3]; 3] = [[0.6, 0.8, 0.0], [0.0, 0.6, -0.8], [-0.48, -0.6, 0.64]];

impl Renderer for Mock {
    fn trace(&mut self, trace: Trace, states: &[State], rays: &[Ray], answers: &mut [Answer]) {
        for (ray, answer) in rays.iter().zip(answers) {
            self.asked.push((trace.into(), ray.site, ray.direction.map(f32::to_bits)));
            let path = states[ray.point as usize].path;
            let [x, y, z] = ray.direction.map(|component| 0.5 + 0.5 * component);
            let probe = trace == Trace::Probe;
            *answer = Answer {
                color: if probe { [0.0; 4] } else { [x, y, z, 0.25 + 0.5 * x] },
                // Some points see nothing, so that the environment is asked instead.
                ok: trace == Trace::Environment || !path.is_multiple_of(3),
                hit: trace != Trace::Environment,
                distance: if path.is_multiple_of(5) { 0.0 } else { 2.0 + 3.0 * x },
            };
        }
    }

    fn objects(&self) -> Objects<'_> {
        Objects::of_place(&self.place)
    }

    fn light_list(&mut self, names: &[String], _: LightMode) -> LightList {
        assert!(names.is_empty());
        LightList(0)
    }

    fn light_count(&mut self, _: LightList) -> usize {
        LIGHTS.len()
    }

    fn light_samples(
        &mut self,
        _: LightList,
        iteration: usize,
        points: Points<'_>,
        samples: &mut [LightSample],
    ) {
        for (point, sample) in points.iter().zip(samples) {
            let reachable = !(point.path + iteration as u64).is_multiple_of(4);
            let (direction, token) = (LIGHTS[iteration], iteration as u64);
            *sample =
                LightSample { direction, distance: 0.0, density: f32::INFINITY, reachable, token };
        }
    }

    fn light_colors(&mut self, points: Points<'_>, tokens: &[u64], colors: &mut [[f32; 3]]) {
        let asked = tokens.iter().map(|token| (Effect::LightColor, *token, [0; 3]));
        self.asked.extend(asked.take(points.len()));
        for (token, color) in tokens.iter().zip(colors) {
            *color = [1.0 + *token as f32, 0.5, 0.25];
        }
    }
}

/// A number in -1..1.
fn signed_unit(random: &mut Random) -> f32 {
    random.unit() * 2.0 - 1.0
}

fn any_direction(random: &mut Random) -> [f32; 3] {
    loop {
        let vector = glam::Vec3::from_array([0; 3].map(|_| signed_unit(random)));
        if (0.1..1.0).contains(&vector.length()) {
            return vector.normalize().into();
        }
    }
}

fn points(ray_type: RayType) -> Vec<State> {
    let mut random = Random::new(7);
    (0..600)
        .map(|number| {
            let direction = any_direction(&mut random);
            let mut normal = any_direction(&mut random);
            let dot = |normal: [f32; 3]| (0..3).map(|k| normal[k] * direction[k]).sum::<f32>();
            if dot(normal) > 0.0 {
                normal = normal.map(|x| -x);
            }
            if number % 10 == 0 {
                normal = direction.map(|x| -x);
            }
            let point = [
                signed_unit(&mut random) * 9.0,
                signed_unit(&mut random),
                signed_unit(&mut random) * 9.0,
            ];
            let dot_nd = dot(normal).max(-1.0);
            State {
                direction,
                normal,
                normal_geom: normal,
                dot_nd,
                point,
                inv_normal: number % 3 == 1,
                ior_in: if number % 7 == 0 { 1.2 } else { 0.0 },
                uv: [random.unit(), random.unit()],
                reflection_level: i32::from(number % 4 == 1),
                path: number,
                ray_type,
                ..State::default()
            }
        })
        .collect()
}

fn graph_files() -> Vec<PathBuf> {
    let graphs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs");
    let mut files = Vec::new();
    for folder in std::fs::read_dir(graphs).expect("graphs can be listed") {
        let folder = folder.expect("its entries can be read").path();
        if folder.is_dir() && !folder.ends_with("broken") {
            let entries = std::fs::read_dir(folder).expect("a folder can be listed");
            let paths = entries.map(|entry| entry.expect("its entries can be read").path());
            files.extend(paths.filter(|path| path.extension().is_some_and(|it| it == "json")));
        }
    }
    files.sort();
    files
}

fn read(path: &Path, library: &NodeLibrary) -> Graph {
    let document = document::read_file(path).expect("the graph is JSON");
    let checked = check_graph(&document, library);
    assert!(checked.findings.is_empty(), "{}: {:#?}", path.display(), checked.findings);
    checked.graph.expect("a graph without findings")
}

fn shipped(name: &str) -> Arc<Graph> {
    let path = (graph_files().into_iter())
        .find(|path| path.file_stem().is_some_and(|stem| stem == name))
        .expect("the graph is shipped");
    Arc::new(read(&path, &NodeLibrary::standard()))
}

/// How far the results may be apart, of 1 and more in proportion. The bumps of snow are differences of noise a
/// step of 0.004 apart, at points up to 20 units from the middle of their object: there a last digit of a
/// coordinate is half a thousandth of the step.
fn rounding(name: &str) -> f32 {
    if name == "snow" { 4e-3 } else { 2e-4 }
}

/// Shades point by point in the graph and in both monoliths, and compares.
fn compare(name: &str, overrides: &[(String, Literal)]) -> BTreeMap<Effect, usize> {
    let options = Options { engine: Engine::Walk, ..Options::default() };
    let shader = Shader::new(shipped(name), overrides, options).expect("the graph compiles");
    let taken = |found: Option<Result<_, _>>| found.expect("it is there").expect("it takes them");
    let monolith: Box<dyn Shade> = taken(find(name, overrides));
    let same_bits: Box<dyn Shade> = taken(find_same_bits(name, overrides));
    let mut total = BTreeMap::new();
    for root in RootKind::ALL {
        assert_eq!(shader.has_root(root), monolith.has_root(root), "{name} {root:?}");
        if !shader.has_root(root) {
            continue;
        }
        let ray_type = match root {
            RootKind::Material => RayType::Eye,
            RootKind::Shadow => RayType::Shadow,
            RootKind::Environment => RayType::Environment,
            other => panic!("the renderer does not call {other:?}"),
        };
        let declared = monolith.effects(root);
        for point in points(ray_type) {
            let asked = [&shader as &dyn Shade, &*monolith, &*same_bits].map(|of| {
                let (mut renderer, mut result) = (Mock::new(), [Shaded::default()]);
                of.shade(root, &[point], &mut renderer, &mut result);
                (renderer, result[0])
            });
            let [(composed, expected), (by_hand, near), (by_same, same)] = asked;
            let what = format!("{name} {root:?} {overrides:?} {point:?}");
            assert_eq!(composed.sites(), by_hand.sites(), "{what}");
            let requests = composed.requests();
            assert!(requests.keys().all(|effect| declared.contains(*effect)), "{what}");
            assert_eq!(expected.ok, near.ok, "{what}");
            for (a, b) in expected.color.iter().zip(near.color) {
                assert!(
                    (a - b).abs() <= rounding(name) * (1.0 + a.abs()),
                    "{expected:?} {near:?} {what}"
                );
            }
            assert_eq!(composed.sorted(), by_same.sorted(), "{what}");
            let bits = |shaded: Shaded| (shaded.color.map(f32::to_bits), shaded.ok);
            assert_eq!(bits(expected), bits(same), "{expected:?} {same:?} {what}");
            for (effect, count) in requests {
                *total.entry(effect).or_default() += count;
            }
        }
    }
    total
}

fn set(name: &str, value: f32) -> (String, Literal) {
    (name.into(), Literal::Scalar(value))
}

#[test]
fn every_monolith_has_a_shipped_graph_with_its_parameters() {
    let library = NodeLibrary::standard();
    let mut names = Vec::new();
    for path in graph_files() {
        let graph = read(&path, &library);
        assert!(path.file_stem().is_some_and(|stem| *stem == *graph.name), "{}", path.display());
        if find(&graph.name, &[]).is_none() {
            // Not every graph is written by hand.
            continue;
        }
        for parameter in &graph.parameters {
            let value = [(parameter.name.clone(), parameter.default.clone())];
            let found = find(&graph.name, &value).expect("it has a monolith");
            assert!(found.is_ok(), "{}: {:?}", graph.name, found.err());
        }
        names.push(graph.name);
    }
    names.sort();
    assert_eq!(names, NAMES);
}

/// Those that the renderer works out only where something reads them.
fn on_demand(fields: FieldSet) -> BTreeSet<Field> {
    let is_on_demand = |field: &Field| match field {
        Field::U | Field::V => true,
        other => !other.of_point() && other.of_loop().is_none(),
    };
    let all = Field::ALL.iter().copied().filter(is_on_demand);
    all.filter(|field| fields.contains(*field)).collect()
}

#[test]
fn monoliths_read_what_their_graphs_read() {
    for name in NAMES {
        let graph = shipped(name);
        let (mut by_graph, mut by_hand) = (BTreeSet::new(), BTreeSet::new());
        let presets = graph.presets.iter().map(|preset| preset.with(Vec::new()));
        for values in std::iter::once(Vec::new()).chain(presets) {
            let shader = Shader::new(Arc::clone(&graph), &values, Options::default()).unwrap();
            let monolith = find(name, &values).unwrap().unwrap();
            for root in RootKind::ALL.into_iter().filter(|root| shader.has_root(*root)) {
                by_graph.extend(on_demand(shader.fields(root)));
                by_hand.extend(on_demand(monolith.fields(root)));
            }
        }
        // A graph's bump shifts the coordinates of the point; by hand it shifts the point alone.
        let by_graph_alone: Vec<&Field> = by_graph.difference(&by_hand).collect();
        let bumped: &[&Field] = if *name == "snow" { &[&Field::U, &Field::V] } else { &[] };
        assert_eq!(by_graph_alone, bumped, "{name}");
        assert!(by_hand.is_subset(&by_graph), "{name}: {by_hand:?}");
    }
}

/// A picture, as an author reads it.
#[derive(Default)]
struct Poster;

impl PointShader for Poster {
    const ROOTS: &'static [(RootKind, &'static [Effect])] =
        &[(RootKind::Material, &[Effect::ReadTexture])];
    const FIELDS: &'static [Field] = &[Field::U, Field::V];

    fn textures(&self) -> Vec<Texture> {
        ["b.png", "a.png"].map(|file| Texture { file: file.into(), space: Space::Srgb }).into()
    }

    fn parameter(&mut self, _: &str) -> Option<Parameter<'_>> {
        None
    }

    fn shade_point<A: Arithmetic>(
        &self,
        _: RootKind,
        point: &State,
        asking: &mut Asking<'_>,
    ) -> Shaded {
        let color = asking.texel(0, point) + 10.0 * asking.texel(1, point);
        Shaded { color: color.into(), ok: asking.texel(2, point) == glam::Vec4::ZERO }
    }
}

/// Pictures by the first letter of their names, which show where they are read.
struct Pictures;

impl Renderer for Pictures {
    fn trace(&mut self, _: Trace, _: &[State], _: &[Ray], _: &mut [Answer]) {}

    fn texture(&mut self, texture: &Texture) -> TextureId {
        TextureId(texture.file.as_bytes()[0].into())
    }

    fn read_texture(
        &mut self,
        texture: TextureId,
        _: Sampling,
        lookups: &[Lookup],
        colors: &mut [Option<[f32; 4]>],
    ) {
        for (lookup, color) in lookups.iter().zip(colors) {
            let [u, v] = lookup.uv;
            let letter = texture.0 as f32 - 96.0;
            *color = (texture != TextureId::NONE).then_some([u, v, letter, 1.0]);
        }
    }
}

#[test]
fn monoliths_read_pictures_by_number() {
    let poster = Pointwise::<Poster>::new(Poster);
    let point = State { uv: [0.25, 0.5], ..State::default() };
    let mut results = [Shaded::default()];
    poster.shade(RootKind::Material, &[point], &mut Pictures, &mut results);
    assert_eq!(results[0], Shaded { color: [2.75, 5.5, 12.0, 11.0], ok: true });
    assert_eq!(poster.textures().len(), 2);
}

#[test]
fn defaults_and_presets_agree() {
    for name in NAMES {
        compare(name, &[]);
        for preset in &shipped(name).presets {
            if !preset.values.is_empty() {
                compare(name, &preset.values);
            }
        }
    }
}

#[test]
fn the_glass_agrees_at_its_limits() {
    compare("advanced_glass", &[set("ior", 1.0)]);
    compare("advanced_glass", &[set("ior", 2.4), set("opacity", 0.5), set("depth", 3.0)]);
    compare("advanced_glass", &[set("depth", 0.0)]);
    let opaque = compare("advanced_glass", &[set("opacity", 1.0)]);
    let clear = compare("advanced_glass", &[]);
    assert!(clear.contains_key(&Effect::TraceRefraction));
    assert!(!opaque.contains_key(&Effect::TraceRefraction));
}

fn count(name: &str, value: i32) -> (String, Literal) {
    (name.into(), Literal::Integer(value))
}

#[test]
fn brushed_metal_agrees_at_its_limits() {
    let some = compare("aniso_brdf", &[]);
    let none = compare("aniso_brdf", &[set("specular_reflectance", 0.0)]);
    assert!(!none.contains_key(&Effect::TraceReflection));
    assert_eq!(none[&Effect::LightColor], some[&Effect::LightColor]);
    for brush in 0..3 {
        let direction = ("direction".into(), Literal::Vector([0.3, -2.0, 0.1]));
        let center = ("center".into(), Literal::Vector([0.0, 1.0, -0.5]));
        compare("aniso_brdf", &[count("brush", brush), direction, center]);
    }
    // Without a direction any will do, and of one roughness none is needed.
    compare("aniso_brdf", &[("direction".into(), Literal::Vector([0.0; 3]))]);
    compare("aniso_brdf", &[set("ru", 0.0), set("rv", 0.0), set("specular_reflectance", 1.0)]);
    compare("aniso_brdf", &[set("ru", 1e5), set("rv", 1e5), count("samples", 1)]);
}

#[test]
fn sunglasses_agree_at_their_limits() {
    let seen = compare("sunglasses", &[]);
    let closed = compare("sunglasses", &[set("refractivity", 0.0)]);
    // What lets no ray in lets none out.
    assert!(seen.contains_key(&Effect::TraceRefraction));
    assert!(!closed.contains_key(&Effect::TraceRefraction));
    let mirror = compare("sunglasses", &[set("reflectivity", 1.0), set("rainbow", 0.0)]);
    assert!(!mirror.contains_key(&Effect::LightColor));
    compare("sunglasses", &[set("reflectivity", 0.0), set("rainbow", 1.0)]);
}

#[test]
fn x_rays_agree_at_their_limits() {
    let all = compare("xray", &[]);
    // All is thin, and hides what is behind.
    let hidden = compare("xray", &[set("intensity", 1.0), set("near", 999.0), set("far", 1000.0)]);
    assert_eq!(hidden[&Effect::TraceProbe], all[&Effect::TraceProbe]);
    assert!(hidden[&Effect::TraceTransparent] < all[&Effect::TraceTransparent]);
    compare("xray", &[set("intensity", 0.0), set("slant", 0.0), set("spread", 0.0)]);
    for samples in [1, 7, 12, 256] {
        compare("xray", &[count("samples", samples), set("slant", 1.0), set("near", 5.0)]);
    }
}

#[test]
fn a_reflection_without_weight_casts_no_ray() {
    let none = compare("rainbow", &[set("reflectivity", 0.0), set("strength", 0.0)]);
    assert!(!none.contains_key(&Effect::TraceReflection));
    compare("rainbow", &[set("strength", 1.0), set("saturation", 0.3), set("ior", 4.0)]);
    // Points with another medium in front still mirror at ior 1.
    let some = compare("tinted_mirror", &[set("ior", 1.0)]);
    let all = compare("tinted_mirror", &[]);
    assert!(some[&Effect::TraceReflection] < all[&Effect::TraceReflection] / 2);
}

#[test]
fn the_floor_and_the_sky_agree_elsewhere() {
    compare("checker_floor", &[set("size", 0.37)]);
    let sun = ("sun_direction".into(), Literal::Vector([0.0, -3.0, 0.0]));
    compare("gradient_sky", &[sun, set("sun_edge", 0.5)]);
    let nowhere = ("sun_direction".into(), Literal::Vector([0.0; 3]));
    compare("gradient_sky", &[nowhere, set("sun_edge", 1.0)]);
}

#[test]
fn the_silk_agrees_at_its_limits() {
    compare("silk", &[set("metallic", 0.0), set("spread", 0.02)]);
    compare("silk", &[set("metallic", 1.0), set("spread", 1.0), set("unevenness", 1.0)]);
    compare("silk", &[set("threads", 2000.0), set("unevenness", 0.0)]);
}

#[test]
fn the_disc_agrees_at_its_limits() {
    let axis = |axis| ("axis".into(), Literal::Vector(axis));
    compare("cd", &[set("hub", 0.0), set("purity", 0.0), set("across", 0.2)]);
    compare("cd", &[set("hub", 7.0), set("dispersion", 10.0), axis([0.3, -2.0, 1.0])]);
    let center = ("center".into(), Literal::Vector([0.5, 0.0, -0.25]));
    compare("cd", &[set("along", 0.01), set("across", 1.0), set("purity", 1.0), center]);
    compare("cd", &[axis([0.0; 3]), set("dispersion", 0.0)]);
}

#[test]
fn the_snow_agrees_at_its_limits() {
    let thick = compare("snow", &[set("transparency", 0.0), set("glitter", 1.0)]);
    let thin = compare("snow", &[set("transparency", 1.0), set("depth", 20.0)]);
    // What lets no ray in lets none out.
    assert!(thin.contains_key(&Effect::TraceRefraction));
    assert!(!thick.contains_key(&Effect::TraceRefraction));
    compare("snow", &[set("transparency", 1.0), set("depth", 0.001), set("ior", 1.0)]);
    compare("snow", &[set("glitter", 0.0), set("grain", 0.0)]);
    compare("snow", &[set("crystal", 0.3), set("grain", 0.05), set("grain_size", 0.3)]);
}
