//! Seeded randomness for tests, with a taste for hard values.

use crate::state::{Hit, RayType, State};
use crate::values::{Literal, Space, Texture, Type};

/// Numbers at which arithmetic goes wrong.
pub const HARD: [f32; 22] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    1.0 + f32::EPSILON,
    1.0 - f32::EPSILON / 2.0,
    0.5,
    2.0,
    3.0,
    f32::MIN_POSITIVE,
    1e-45,
    -1e-45,
    1e-20,
    f32::MAX,
    f32::MIN,
    1e20,
    2_147_483_648.0,
    -2_147_483_904.0,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
    0.1,
];

/// Names light lists are made of.
const LIGHTS: [&str; 3] = ["key", "fill", "rim"];
/// Textures, and none.
const TEXTURES: [Option<&str>; 3] = [None, Some("wood.png"), Some("sky.exr")];

/// A generator (SplitMix64) whose whole sequence follows from its seed.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The generator of a seed.
    pub fn new(seed: u64) -> Self {
        Self(mixed(seed))
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        mixed(self.0)
    }

    /// A number below `bound`, which is not 0.
    pub fn below(&mut self, bound: usize) -> usize {
        (self.bits() >> 16) as usize % bound
    }

    /// True in that many of a hundred cases.
    pub fn chance(&mut self, percent: usize) -> bool {
        self.below(100) < percent
    }

    /// One of `choices`, which are not empty.
    pub fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// A number in 0..1.
    pub fn unit(&mut self) -> f32 {
        (self.bits() >> 40) as f32 / (1 << 24) as f32
    }

    /// A number in 0..1, of all 53 bits.
    pub fn fine_unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Some number: often between -1 and 1, often 0 or 1, sometimes hard.
    pub fn number(&mut self) -> f32 {
        match self.below(10) {
            0 => self.pick(&HARD),
            1 | 2 => self.pick(&[0.0, 1.0]),
            3..=6 => self.unit(),
            _ => self.unit() * 2.0 - 1.0,
        }
    }

    /// A vector: near unit length, zero, along an axis, or of any numbers.
    pub fn vector(&mut self) -> [f32; 3] {
        match self.below(8) {
            0 => [0.0; 3],
            1 => [self.number(), self.number(), self.number()],
            2 => {
                let mut axis = [0.0; 3];
                axis[self.below(3)] = self.pick(&[1.0, -1.0]);
                axis
            }
            _ => {
                let v = [0; 3].map(|_| self.unit() * 2.0 - 1.0);
                let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
                v.map(|x| x / length)
            }
        }
    }

    /// A literal of a type.
    pub fn literal(&mut self, value_type: Type) -> Literal {
        match value_type {
            Type::Boolean => Literal::Boolean(self.chance(50)),
            Type::Integer => Literal::Integer(self.integer()),
            Type::Scalar | Type::Generic => Literal::Scalar(self.number()),
            Type::Color => Literal::Color([0; 4].map(|_| self.number())),
            Type::Vector => Literal::Vector(self.vector()),
            Type::Transform => Literal::Transform(std::array::from_fn(|at| match at {
                3 | 7 | 11 => 0.0,
                15 => 1.0,
                _ => self.number(),
            })),
            Type::String => Literal::String(self.pick(&["", "matte", "gloss"]).to_owned()),
            Type::Texture => Literal::Texture(
                self.pick(&TEXTURES)
                    .map(|file| Texture { file: file.to_owned(), space: Space::of_file(file) }),
            ),
            Type::Shader => Literal::NoShader,
            Type::Light => Literal::Light(self.pick(&LIGHTS).to_owned()),
            Type::Lights => {
                let names = LIGHTS.iter().filter(|_| self.chance(40));
                Literal::Lights(names.map(|name| (*name).to_owned()).collect())
            }
        }
    }

    fn integer(&mut self) -> i32 {
        if self.chance(10) { self.pick(&[i32::MIN, i32::MAX, -1, 8]) } else { self.below(5) as i32 }
    }

    /// Points to shade, all of one ray type, hard fields by chance; numbered in `hit.instance`.
    pub fn states(&mut self, count: usize) -> Vec<State> {
        let ray_type = self.pick(&[
            RayType::Eye,
            RayType::Eye,
            RayType::Reflection,
            RayType::Refraction,
            RayType::Transparent,
            RayType::Shadow,
            RayType::Environment,
            RayType::Displace,
        ]);
        (0..count).map(|index| self.state(index as u32, ray_type)).collect()
    }

    fn state(&mut self, index: u32, ray_type: RayType) -> State {
        State {
            origin: self.vector(),
            direction: self.vector(),
            point: self.vector(),
            normal: self.vector(),
            normal_geom: self.vector(),
            dot_nd: self.number(),
            dist: self.number(),
            inv_normal: self.chance(50),
            ior: self.number(),
            ior_in: self.number(),
            uv: [self.number(), self.number()],
            time: self.number(),
            raster: [self.number(), self.number()],
            ray_type,
            reflection_level: self.integer(),
            refraction_level: self.integer(),
            incoming: [self.number(), self.number(), self.number(), self.number()],
            path: self.bits(),
            hit: Hit { instance: index, ..Hit::default() },
        }
    }
}

/// Sixty-four bits mixed so that each depends on all.
pub fn mixed(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// The bits of a number with one NaN for all.
pub fn canonical(bits: u32) -> u32 {
    if f32::from_bits(bits).is_nan() { f32::NAN.to_bits() } else { bits }
}
