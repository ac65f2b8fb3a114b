//! A renderer without a scene: each answer is a hash of what the request may depend on, and each
//! request is logged.

use crate::effects::{
    Answer, Effect, LightList, LightMode, LightSample, Lookup, NamedLights, Points, Ray, Renderer,
    Sampling, TextureId, Trace,
};
use crate::state::{Camera, Field, Footprint, Object, Objects, State, Surfaces};
use crate::values::{Texture, Type};

use super::random::{Random, canonical, mixed};

/// A request: effect, number of the point that asked, then the words of all it may depend on.
pub type Record = Vec<u32>;

/// See the module.
#[derive(Clone, Debug, Default)]
pub struct MockRenderer {
    /// Requests so far; light samples, which cost nothing, aside.
    pub log: Vec<Record>,
    /// If given, the lights of every list, the same for all points.
    pub lights: Option<Vec<LightSample>>,
    /// The objects that points name.
    pub objects: Vec<Object>,
}

impl MockRenderer {
    /// With these lights in every list.
    pub fn with_lights(lights: Vec<LightSample>) -> Self {
        Self { lights: Some(lights), ..Self::default() }
    }

    /// The log in an order that does not depend on who asked first.
    pub fn sorted_log(mut self) -> Vec<Record> {
        self.log.sort_unstable();
        self.log
    }

    /// How often an effect was asked for.
    pub fn count(&self, effect: Effect) -> usize {
        self.log.iter().filter(|record| record[0] == effect as u32).count()
    }
}

/// The words of a field, NaNs made one where they are numbers.
fn field_words(field: Field, state: &State) -> impl Iterator<Item = u32> {
    let value_type = field.value_type();
    let mut words = vec![0; value_type.width()];
    field.read(state, &mut words);
    let is_number = matches!(value_type, Type::Scalar | Type::Vector | Type::Color);
    words.into_iter().map(move |word| if is_number { canonical(word) } else { word })
}

fn hash(words: impl IntoIterator<Item = u32>) -> u64 {
    words.into_iter().fold(0x1234_5678, |hash, word| mixed(hash ^ u64::from(word)) + 1)
}

fn numbers(values: impl IntoIterator<Item = f32>) -> impl Iterator<Item = u32> {
    values.into_iter().map(|x| canonical(x.to_bits()))
}

/// The token of a light sample: its list and its number there.
fn token(list: LightList, iteration: usize) -> u64 {
    u64::from(list.0) << 32 | iteration as u64
}

/// The words a light sample depends on; its colour depends on the side as well.
fn light_words(token: u64, state: &State) -> Vec<u32> {
    let mut words = vec![(token >> 32) as u32, token as u32];
    words.extend(field_words(Field::Point, state));
    words.extend(field_words(Field::NormalGeom, state));
    words
}

/// The record of a ray traced from a point.
fn record(effect: Effect, state: &State, ray: &Ray) -> Record {
    let mut record = vec![effect as u32, state.hit.instance];
    record.extend([(ray.site >> 32) as u32, ray.site as u32]);
    record.extend(numbers(ray.origin));
    record.extend(numbers(ray.direction));
    for &field in effect.reads() {
        record.extend(field_words(field, state));
    }
    record
}

/// Surfaces that differ from point to point, as nothing else tells.
struct Folded;

impl Folded {
    fn random(state: &State, salt: u32) -> Random {
        Random::new(hash([salt, state.hit.instance, state.hit.primitive]))
    }
}

impl Surfaces for Folded {
    fn derivative_u(&self, state: &State) -> [f32; 3] {
        Folded::random(state, 1).vector()
    }
    fn derivative_v(&self, state: &State) -> [f32; 3] {
        Folded::random(state, 2).vector()
    }
    fn vertex_color(&self, state: &State) -> [f32; 4] {
        let mut random = Folded::random(state, 3);
        [0; 4].map(|_| random.number())
    }
    fn second_uv(&self, state: &State) -> [f32; 2] {
        let mut random = Folded::random(state, 4);
        [0; 2].map(|_| random.number())
    }
    fn footprint(&self, state: &State) -> Footprint {
        let mut random = Folded::random(state, 5);
        let point = [0; 2].map(|_| random.vector());
        Footprint { point, uv: [0; 2].map(|_| [0; 2].map(|_| random.number())) }
    }
}

/// A camera that is turned, and not at the origin.
const CAMERA: Camera = Camera {
    to_world: [0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3.0, -2.0, 0.5, 1.0],
    to_camera: [0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.5, 2.0, -3.0, 1.0],
    height: 0.375,
};

impl Renderer for MockRenderer {
    fn trace(&mut self, trace: Trace, states: &[State], rays: &[Ray], answers: &mut [Answer]) {
        assert_eq!(rays.len(), answers.len());
        assert!(!rays.is_empty(), "a request without rays");
        for (ray, answer) in rays.iter().zip(answers) {
            let record = record(trace.into(), &states[ray.point as usize], ray);
            let mut random = Random::new(hash(
                record.iter().enumerate().filter(|(at, _)| *at != 1).map(|(_, word)| *word),
            ));
            self.log.push(record);
            *answer = Answer {
                color: [0; 4].map(|_| random.number()),
                ok: random.chance(70),
                hit: random.chance(70),
                distance: random.number(),
            };
        }
    }

    fn objects(&self) -> Objects<'_> {
        Objects { objects: &self.objects, surfaces: &Folded, camera: &CAMERA }
    }

    fn texture(&mut self, texture: &Texture) -> TextureId {
        let name = format!("{} {}", texture.file, texture.space.name());
        TextureId(hash(name.bytes().map(u32::from)) as u32)
    }

    fn read_texture(
        &mut self,
        texture: TextureId,
        sampling: Sampling,
        lookups: &[Lookup],
        colors: &mut [Option<[f32; 4]>],
    ) {
        assert_eq!(lookups.len(), colors.len());
        assert!(!lookups.is_empty(), "a request without points");
        for (Lookup { uv, default, footprint }, color) in lookups.iter().zip(colors) {
            let mut record = vec![Effect::ReadTexture as u32, texture.0];
            record.extend(sampling.wrap.map(|wrap| wrap as u32));
            record.push(sampling.filter as u32);
            record.extend(numbers(*uv));
            if sampling.has_default() {
                record.extend(numbers(*default));
            }
            if sampling.is_filtered() {
                record.extend(numbers(footprint.as_flattened().iter().copied()));
            }
            let mut random = Random::new(hash(record.iter().copied()));
            self.log.push(record);
            *color = random.chance(70).then(|| [0; 4].map(|_| random.number()));
        }
    }

    fn texture_size(&mut self, texture: TextureId) -> Option<[u32; 2]> {
        Some([texture.0 & 7, 1 + (texture.0 >> 3 & 7)])
    }

    fn light_list(&mut self, names: &[String], mode: LightMode) -> LightList {
        let NamedLights { names, mode } = NamedLights::new(names.to_vec(), mode);
        let number = hash(names.join(" ").bytes().map(u32::from)) as u32;
        LightList(number.wrapping_add(mode as u32))
    }

    fn light_count(&mut self, list: LightList) -> usize {
        match &self.lights {
            Some(lights) => lights.len(),
            None => Random::new(u64::from(list.0)).pick(&[0, 1, 2, 2, 3, 4]),
        }
    }

    fn light_samples(
        &mut self,
        list: LightList,
        iteration: usize,
        points: Points<'_>,
        samples: &mut [LightSample],
    ) {
        assert_eq!(points.len(), samples.len());
        if let Some(lights) = &self.lights {
            let token = token(list, iteration);
            return samples.fill(LightSample { token, ..lights[iteration] });
        }
        for (state, sample) in points.iter().zip(samples) {
            let token = token(list, iteration);
            let mut random = Random::new(hash(light_words(token, state)));
            *sample = LightSample {
                direction: random.vector(),
                distance: random.number(),
                density: random.number(),
                reachable: random.chance(70),
                token,
            };
        }
    }

    fn light_density(&mut self, directions: &[[f32; 3]], densities: &mut [f32]) {
        assert_eq!(directions.len(), densities.len());
        assert!(!directions.is_empty(), "a request without points");
        for (direction, density) in directions.iter().zip(densities) {
            let mut record = vec![Effect::LightDensity as u32];
            record.extend(numbers(*direction));
            *density = Random::new(hash(record.iter().copied())).number();
            self.log.push(record);
        }
    }

    fn light_colors(&mut self, points: Points<'_>, tokens: &[u64], colors: &mut [[f32; 3]]) {
        assert_eq!((points.len(), tokens.len()), (colors.len(), colors.len()));
        assert!(!points.is_empty(), "a request without points");
        for ((state, token), color) in points.iter().zip(tokens).zip(colors) {
            let mut words = light_words(*token, state);
            words.extend(field_words(Field::InvNormal, state));
            let mut random = Random::new(hash(words.iter().copied()) ^ 1);
            *color = [0; 3].map(|_| random.number());
            let mut record = vec![Effect::LightColor as u32, state.hit.instance];
            record.extend(words);
            self.log.push(record);
        }
    }
}
