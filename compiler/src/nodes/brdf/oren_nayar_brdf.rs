use std::f64::consts::PI;

use crate::emit::functions::facets::Facets;
use crate::emit::functions::reflected::{grey, shown};
use crate::emit::{Color, Components, Mask, Real, Vector};
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, WHITE, state};
use crate::state::Field;

node! {
    /// Reflectance of a rough diffuse surface: grooves in the shape of a V, whose slopes have the standard
    /// deviation `sigma`, each diffuse. `full` has the light between the sides, `qualitative` leaves out what
    /// is small. Draw directions by `lambert_sample`. Reciprocal.
    ///
    /// The full model is negative near double grazing (down to -0.08 of the albedo), where it is clamped to 0,
    /// and its albedo reaches 1.02 at grazing angles; see the tests. Angles come from sine and cosine both,
    /// and `tan` of the mean of two angles from sums of these: no arc cosine is taken, nothing is 0 / 0.
    /// MaterialX's `roughness` is `sigma`; at 0 the model is Lambert's.
    oren_nayar_brdf in brdf,
    source "Oren and Nayar 1994, Generalization of Lambert's Reflectance Model",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Standard deviation of the slopes.
        sigma: scalar = 0.3, in 0.0..=1.5707964, unit "radians";
        /// Share of light each groove side reflects.
        color: color = WHITE, in UNIT;
        /// Which of the two models.
        model: choice = 0, of ["full", "qualitative"];
    }
    outputs {
        /// The reflectance, per steradian; alpha is 1.
        value: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let value = value(i.normal, i.direction, i.ray, i.sigma, i.color, i.model);
        Outputs { value: shown(facets.above(), value) }
    }
}

/// The reflectance where light and viewer are above the surface.
#[inline(always)]
pub fn value<R: Real>(
    normal: Vector<R>,
    light: Vector<R>,
    ray: Vector<R>,
    sigma: R,
    color: Color<R>,
    model: i32,
) -> Color<R> {
    let squared = sigma * sigma;
    let slopes = squared * 0.45 / (squared + 0.09);
    let first = squared * -0.5 / (squared + 0.33) + 1.0;
    let (cosine_in, cosine_out) = (normal.dot(light), -normal.dot(ray));
    // What lies along the surface, turned by a quarter.
    let (flat_in, flat_out) = (normal.cross(light), -normal.cross(ray));
    let aligned = flat_in.dot(flat_out);
    let high = cosine_in.maximum(cosine_out);
    if model == 1 {
        // cos(dphi) sin(a) tan(b) without an angle.
        let between = aligned.maximum(sigma.same(0.0)) / high;
        return color * (slopes.mul_add(between, first) * (1.0 / PI));
    }
    let angles = Angles::of(cosine_in, cosine_out, flat_in, flat_out, aligned);
    let share =
        first + slopes * angles.second() + squared * 0.125 / (squared + 0.09) * angles.third();
    let mutual = squared * 0.17 / (squared + 0.13) * angles.mutual();
    let once = color * (share * (1.0 / PI));
    let twice = color * color * (mutual * (1.0 / PI));
    (once + twice).maximum(grey(sigma.same(0.0)))
}

/// The angles of light and viewer from the normal: the larger `a` and the smaller `b`.
///
/// Near double grazing their tangents grow without bound, and what those multiply vanishes. So angles are had from
/// the surface, where they are small, and which of both is larger is told by the cosines.
struct Angles<R: Real> {
    /// `1 - 2 a / pi` and `1 - 2 b / pi`.
    rests: [R; 2],
    sines: [R; 2],
    cosines: [R; 2],
    /// Cosine of the angle between both, seen along the normal.
    apart: R,
    /// The square of its sine: not had from the cosine, which is all but 1 or -1 where both lie in one plane.
    aside: R,
}

impl<R: Real> Angles<R> {
    #[inline(always)]
    fn of(
        cosine_in: R,
        cosine_out: R,
        flat_in: Vector<R>,
        flat_out: Vector<R>,
        aligned: R,
    ) -> Self {
        let (squared_in, squared_out) = (flat_in.dot(flat_in), flat_out.dot(flat_out));
        let (sine_in, sine_out) = (squared_in.sqrt(), squared_out.sqrt());
        let across = flat_in.cross(flat_out);
        let one = cosine_in.same(1.0);
        let in_is_larger = cosine_in.less(cosine_out);
        let sines =
            [in_is_larger.select(sine_in, sine_out), in_is_larger.select(sine_out, sine_in)];
        let cosines = [cosine_in.minimum(cosine_out), cosine_in.maximum(cosine_out)];
        Self {
            rests: [
                cosines[0].atan2(sines[0]) * (2.0 / PI),
                cosines[1].atan2(sines[1]) * (2.0 / PI),
            ],
            sines,
            cosines,
            apart: aligned.divide_or_zero(sine_in * sine_out).clamp_to(-one, one),
            aside: across.dot(across).divide_or_zero(squared_in * squared_out),
        }
    }

    /// `2 b / pi`.
    #[inline(always)]
    fn smaller(&self) -> R {
        self.apart.same(1.0) - self.rests[1]
    }

    /// `cos(dphi) tan(b)` times `sin(a)`, less `(2 b / pi)^3` where both look away from each other: both are 1 less
    /// something.
    #[inline(always)]
    fn second(&self) -> R {
        let (one, three) = (self.apart.same(1.0), self.apart.same(3.0));
        let rest = self.rests[1];
        let cube = rest * (rest - 3.0).mul_add(rest, three);
        let sine = self.cosines[0] * self.cosines[0] / (one + self.sines[0]);
        let slope = self.apart.less(one.same(0.0)).select(cube - sine, self.sines[0]);
        self.apart * slope * (self.sines[1] / self.cosines[1])
    }

    /// `(1 - |cos(dphi)|) tan((a + b) / 2) (4 a b / pi^2)^2`.
    #[inline(always)]
    fn third(&self) -> R {
        let one = self.apart.same(1.0);
        let both = (one - self.rests[0]) * self.smaller();
        let mean = (self.sines[0] + self.sines[1]) / (self.cosines[0] + self.cosines[1]);
        self.aside / (one + self.apart.absolute()) * mean * (both * both)
    }

    /// `1 - cos(dphi) (2 b / pi)^2`.
    #[inline(always)]
    fn mutual(&self) -> R {
        let smaller = self.smaller();
        (-self.apart).mul_add(smaller * smaller, self.apart.same(1.0))
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    #[test]
    fn without_slopes_it_is_lamberts() {
        for model in [0, 1] {
            let value = numbers!(normal = UP, direction = [0.6, 0.0, 0.8], ray = [0.8, 0.0, -0.6], sigma = 0.0, color = [0.8, 0.8, 0.8, 1.0], model = model => value);
            assert_eq!(value[0], 0.8 * std::f32::consts::FRAC_1_PI);
        }
    }

    /// Values of Cycles and MaterialX, relative to albedo times cosine over pi.
    #[test]
    fn the_qualitative_model_has_the_values_of_others() {
        for (outer, inner, turn, expected) in [
            (30.0, 30.0, 0.0, 0.957809),
            (60.0, 60.0, 10.0, 1.22523),
            (75.0, 80.0, 30.0, 1.60902),
            (60.0, 60.0, 180.0, 0.8928571),
        ] {
            let at = |angle: f64, turn: f64| {
                let (angle, turn) = (angle.to_radians(), turn.to_radians());
                [angle.sin() * turn.cos(), angle.sin() * turn.sin(), angle.cos()]
            };
            let direction = at(inner, turn).map(|x| x as f32);
            let ray = at(outer, 0.0).map(|x| -x as f32);
            let value = number!(normal = UP, direction = direction, ray = ray, sigma = 0.3, model = 1 => value);
            let relative = f64::from(value) * std::f64::consts::PI;
            assert!((relative - expected).abs() < 2e-5, "{relative} {expected}");
        }
    }
}
