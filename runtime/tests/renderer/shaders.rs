//! Shaders written by hand, and scenes made of them.

use std::sync::{Arc, Mutex};

use phenomenon_compiler::effects::{
    Answer, Effect, EffectSet, LightMode, LightSample, Ray, Renderer, Trace,
};
use phenomenon_compiler::engine::{Links, Shade, Shaded};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{Field, FieldSet, State};
use phenomenon_runtime::camera::Camera;
use phenomenon_runtime::geometry::Mesh;
use phenomenon_runtime::scene::SceneBuilder;

/// What a [`Hand`] does at its points.
pub type Body = dyn Fn(&[State], &mut dyn Renderer, &mut [Shaded]) + Send + Sync;

/// A shader made of closures, one for each root it has.
#[derive(Default)]
pub struct Hand {
    material: Option<Box<Body>>,
    shadow: Option<Box<Body>>,
    environment: Option<Box<Body>>,
    /// The fields it says it reads, if not all.
    reads: Option<FieldSet>,
}

impl Hand {
    pub fn material(
        body: impl Fn(&[State], &mut dyn Renderer, &mut [Shaded]) + Send + Sync + 'static,
    ) -> Self {
        Self { material: Some(Box::new(body)), ..Self::default() }
    }

    pub fn with_shadow(
        mut self,
        color: impl Fn(&State) -> [f32; 4] + Send + Sync + 'static,
    ) -> Self {
        self.shadow = Some(Box::new(each(color)));
        self
    }

    pub fn with_environment(
        mut self,
        body: impl Fn(&[State], &mut dyn Renderer, &mut [Shaded]) + Send + Sync + 'static,
    ) -> Self {
        self.environment = Some(Box::new(body));
        self
    }

    pub fn reading(mut self, fields: &[Field]) -> Self {
        self.reads = Some(fields.iter().copied().collect());
        self
    }

    fn body(&self, root: RootKind) -> Option<&Body> {
        match root {
            RootKind::Material => self.material.as_deref(),
            RootKind::Shadow => self.shadow.as_deref(),
            RootKind::Environment => self.environment.as_deref(),
            _ => None,
        }
    }
}

impl Shade for Hand {
    fn has_root(&self, root: RootKind) -> bool {
        self.body(root).is_some()
    }

    fn effects(&self, _: RootKind) -> EffectSet {
        Effect::ALL.into_iter().collect()
    }

    fn fields(&self, _: RootKind) -> FieldSet {
        self.reads.unwrap_or_else(|| Field::ALL.iter().copied().collect())
    }

    fn shade_linked(
        &self,
        root: RootKind,
        points: &[State],
        _: &Links,
        renderer: &mut dyn Renderer,
        results: &mut [Shaded],
    ) {
        self.body(root).expect("a root it has")(points, renderer, results);
    }
}

/// A body that asks for nothing.
pub fn each(
    color: impl Fn(&State) -> [f32; 4] + Send + Sync + 'static,
) -> impl Fn(&[State], &mut dyn Renderer, &mut [Shaded]) + Send + Sync + 'static {
    move |points, _, results| {
        for (point, result) in points.iter().zip(results) {
            *result = Shaded { color: color(point), ok: true };
        }
    }
}

pub fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn mirrored(state: &State) -> [f32; 3] {
    let twice = -2.0 * dot(state.direction, state.normal);
    [0, 1, 2].map(|k| state.direction[k] + twice * state.normal[k])
}

/// Refraction by Snell's law; the mirror direction under total reflection.
pub fn bent(state: &State, ior: f32) -> [f32; 3] {
    let eta = if state.inv_normal { ior } else { 1.0 / ior };
    let cosine = -state.dot_nd;
    let squared = 1.0 - eta * eta * (1.0 - cosine * cosine);
    if squared < 0.0 {
        return mirrored(state);
    }
    let along = eta * cosine - squared.sqrt();
    [0, 1, 2].map(|k| eta * state.direction[k] + along * state.normal[k])
}

/// A request along a direction, from the only point there is.
pub fn ask(state: &State, direction: [f32; 3], site: u64) -> Ray {
    Ray { point: 0, origin: state.point, direction, site }
}

/// Traces one ray per point, all at once or one by one as `together` says.
pub fn trace(
    renderer: &mut dyn Renderer,
    kind: Trace,
    points: &[State],
    together: bool,
    direction: impl Fn(&State) -> [f32; 3],
) -> Vec<Answer> {
    let ray =
        |(number, state): (u32, &State)| Ray { point: number, ..ask(state, direction(state), 7) };
    let rays: Vec<Ray> = (0..).zip(points).map(ray).collect();
    let mut answers = vec![Answer::default(); rays.len()];
    if together {
        renderer.trace(kind, points, &rays, &mut answers);
    } else {
        for (ray, answer) in rays.iter().zip(&mut answers) {
            let (ray, answer) = (std::slice::from_ref(ray), std::slice::from_mut(answer));
            renderer.trace(kind, points, ray, answer);
        }
    }
    answers
}

pub fn mirror() -> Arc<Hand> {
    Arc::new(Hand::material(|points, renderer, results| {
        let answers = trace(renderer, Trace::Reflection, points, true, mirrored);
        for (answer, result) in answers.iter().zip(results) {
            *result = Shaded { color: answer.color, ok: answer.ok };
        }
    }))
}

/// Half reflected, half refracted, with a green shadow.
pub fn glass(together: bool) -> Arc<Hand> {
    let material = Hand::material(move |points, renderer, results| {
        let reflected = trace(renderer, Trace::Reflection, points, together, mirrored);
        let refracted =
            trace(renderer, Trace::Refraction, points, together, |state| bent(state, 1.5));
        for (at, result) in results.iter_mut().enumerate() {
            let half = |k: usize| 0.3 * reflected[at].color[k] + 0.7 * refracted[at].color[k];
            *result = Shaded { color: [half(0), half(1), half(2), 1.0], ok: true };
        }
    });
    Arc::new(material.with_shadow(|_| [0.5, 0.9, 0.25, 1.0]))
}

pub fn normals() -> Arc<Hand> {
    Arc::new(Hand::material(each(|state| {
        let [x, y, z] = state.normal.map(|x| x * 0.5 + 0.5);
        [x, y, z, 1.0]
    })))
}

/// White paper under all lights, in a pattern that shows which way is which.
pub fn matte(together: bool) -> Arc<Hand> {
    Arc::new(Hand::material(move |points, renderer, results| {
        let list = renderer.light_list(&[], LightMode::Listed);
        results.fill(Shaded { color: [0.05, 0.05, 0.05, 1.0], ok: true });
        for light in 0..renderer.light_count(list) {
            let size = if together { points.len().max(1) } else { 1 };
            for (points, results) in points.chunks(size).zip(results.chunks_mut(size)) {
                let mut samples = vec![Default::default(); points.len()];
                let mut colors = vec![[0.0; 3]; points.len()];
                renderer.light_samples(list, light, points.into(), &mut samples);
                let tokens: Vec<u64> = samples.iter().map(|it: &LightSample| it.token).collect();
                renderer.light_colors(points.into(), &tokens, &mut colors);
                for (at, point) in points.iter().enumerate() {
                    let cosine = dot(samples[at].direction, point.normal).max(0.0);
                    let even = (point.point[0].floor() + point.point[2].floor()) as i32 % 2 == 0;
                    let albedo = if even { 0.8 } else { 0.3 };
                    for (sum, color) in results[at].color.iter_mut().zip(colors[at]) {
                        *sum += albedo * cosine * color;
                    }
                }
            }
        }
    }))
}

/// Keeps the states it is called with.
pub fn recorder() -> (Arc<Hand>, Arc<Mutex<Vec<State>>>) {
    let seen = Arc::new(Mutex::new(Vec::new()));
    let into = seen.clone();
    let hand = Hand::material(move |points, _, results| {
        into.lock().unwrap().extend_from_slice(points);
        results.fill(Shaded { color: [1.0; 4], ok: true });
    });
    (Arc::new(hand), seen)
}

/// A camera that looks at the origin from `position`.
pub fn looking_from(position: [f64; 3]) -> Camera {
    Camera::new(position, [0.0; 3], [0.0, 1.0, 1e-3], 40.0).unwrap()
}

pub fn builder() -> SceneBuilder {
    SceneBuilder::new(looking_from([0.5, 2.0, 6.0]))
}

/// A sequence of numbers in 0..1 from a seed.
pub struct Numbers(pub u64);

impl Numbers {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        (phenomenon_runtime::sampling::mixed(self.0) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn direction(&mut self) -> [f64; 3] {
        let z = 2.0 * self.next() - 1.0;
        let angle = std::f64::consts::TAU * self.next();
        let r = (1.0 - z * z).sqrt();
        [r * angle.cos(), r * angle.sin(), z]
    }
}

/// A closed ball of triangles: an octahedron cut `cuts` times, with unit vertices.
pub fn ball(cuts: usize) -> Mesh {
    let mut positions: Vec<[f64; 3]> = vec![
        [1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    let mut triangles: Vec<[u32; 3]> = vec![
        [0, 2, 4],
        [2, 1, 4],
        [1, 3, 4],
        [3, 0, 4],
        [2, 0, 5],
        [1, 2, 5],
        [3, 1, 5],
        [0, 3, 5],
    ];
    for _ in 0..cuts {
        let mut middles = std::collections::HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let (p, q) = (positions[a as usize], positions[b as usize]);
                let sum = [0, 1, 2].map(|k| p[k] + q[k]);
                let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
                positions.push(sum.map(|x| x / length));
                positions.len() as u32 - 1
            })
        };
        let mut finer = Vec::new();
        for [a, b, c] in triangles {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            finer.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    let positions = positions.iter().map(|p| p.map(|x| x as f32)).collect();
    Mesh { positions, triangles, ..Mesh::default() }
}
