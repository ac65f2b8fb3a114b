//! `branchy.json` by hand.

use glam::{Vec3A, Vec4};
use phenomenon_compiler::state::State;

use super::blending::hue;

/// One side of a choice.
pub struct Side {
    pub shift: Vec3A,
    pub frequencies: Vec3A,
    pub exponents: [f32; 2],
    pub saturation: f32,
    pub weight: f32,
}

const fn side(
    shift: Vec3A,
    frequencies: Vec3A,
    exponents: [f32; 2],
    saturation: f32,
    weight: f32,
) -> Side {
    Side { shift, frequencies, exponents, saturation, weight }
}

pub static LEFT: Side = side(
    Vec3A::new(-0.29, 0.396, -0.601),
    Vec3A::new(2.817, -1.778, 1.575),
    [1.482, 0.718],
    0.63,
    0.644,
);
pub static RIGHT: Side = side(
    Vec3A::new(-0.286, 0.794, -0.693),
    Vec3A::new(-1.478, -1.904, 3.471),
    [1.345, 1.103],
    0.731,
    0.586,
);
pub static INNER: Side = side(
    Vec3A::new(0.837, 0.683, -0.871),
    Vec3A::new(-3.637, 1.108, 1.651),
    [1.958, 0.737],
    0.813,
    0.633,
);
pub static OUTER: Side = side(
    Vec3A::new(0.559, 0.567, -0.646),
    Vec3A::new(-3.569, 3.096, -3.894),
    [1.828, 1.065],
    0.427,
    0.529,
);
pub static EVEN: Side = side(
    Vec3A::new(-0.328, 0.486, -0.171),
    Vec3A::new(-2.231, 1.06, -3.306),
    [0.488, 0.436],
    0.669,
    0.587,
);
pub static ODD: Side = side(
    Vec3A::new(0.365, -0.504, -0.348),
    Vec3A::new(-1.324, 3.847, 1.875),
    [0.712, 1.094],
    0.325,
    0.426,
);
pub static LOWER: Side = side(
    Vec3A::new(0.867, 0.401, -0.615),
    Vec3A::new(2.86, -2.294, 3.809),
    [2.356, 0.839],
    0.613,
    0.305,
);
pub static UPPER: Side = side(
    Vec3A::new(0.432, -0.116, 0.148),
    Vec3A::new(2.399, 2.827, -3.214),
    [1.579, 0.417],
    0.873,
    0.448,
);

impl Side {
    fn over(&self, color: Vec4, point: &State) -> Vec4 {
        let swirl = Vec3A::from(point.point) + self.shift;
        let depth = swirl.length();
        let along = if depth == 0.0 { 0.0 } else { swirl.dot(self.frequencies) / depth };
        let wave = along.sin();
        let tone = wave.exp().powf(self.exponents[0]);
        let grain = (tone / depth.exp()).powf(self.exponents[1]);
        let lit = hue(wave, self.saturation, tone) * grain;
        color.lerp(lit.extend(1.0), self.weight)
    }
}

/// Lets a point choose the first side of each choice.
pub fn to_one_side(point: &mut State) {
    point.uv = point.uv.map(|x| x / 2.0);
    point.inv_normal = true;
    point.reflection_level = 0;
}

/// Its colour at a point.
pub fn shade(point: &State) -> Vec4 {
    let [u, v] = point.uv;
    let choices = [
        if u < 0.5 { &LEFT } else { &RIGHT },
        if point.inv_normal { &INNER } else { &OUTER },
        if point.reflection_level <= 0 || point.reflection_level == 2 { &EVEN } else { &ODD },
        if v < 0.5 { &LOWER } else { &UPPER },
    ];
    let start = Vec4::from(point.incoming);
    let color = choices.iter().fold(start, |color, side| side.over(color, point));
    (color * 0.8).with_w(color.w)
}
