//! Oren and Nayar's reflectance where light and viewer both graze the surface: its tangents grow without bound there,
//! and what they multiply vanishes.

use std::f64::consts::PI;

use crate::bounds::hold_sum;
use crate::nodes::{Asked, Input, LIGHT_AND_RAY, choice, upright};
use crate::perfect_mirrors::{held, with};

/// The terms of a sum at a row.
type Terms = fn(&[f64]) -> Vec<f64>;

/// Light and ray at cosines from next to nothing to one half, in several turns about the normal.
fn pairs() -> Vec<Vec<f32>> {
    let cosines = [1e-38, 1e-20, 1e-10, 1e-7, 3e-6, 1e-5, 1e-4, 1e-2, 0.5];
    let mut pairs = Vec::new();
    for light in cosines {
        for viewer in cosines {
            for turn in [0.0, 1e-3, 0.5, 1.5, 1.6, 3.0, 3.135, PI] {
                let sine = |cosine: f64| (1.0 - cosine * cosine).sqrt();
                let towards = [sine(light) * turn.cos(), sine(light) * turn.sin(), light];
                let ray = [-sine(viewer), 0.0, -viewer];
                pairs.push(towards.into_iter().chain(ray).map(|x: f64| x as f32).collect());
            }
        }
    }
    pairs
}

/// The terms of the published sum for an albedo of 1; what vanishes beside a tangent comes from angles to the surface.
fn full(at: &[f64]) -> Vec<f64> {
    let flat = at[0].hypot(at[1]) * at[3].hypot(at[4]);
    let apart = (-(at[0] * at[3] + at[1] * at[4]) / flat).clamp(-1.0, 1.0);
    // 1 - |apart|, by the sine: next to nothing where both lie in one plane.
    let aside = ((at[0] * at[4] - at[1] * at[3]) / flat).powi(2) / (1.0 + apart.abs());
    // Of unit vectors: what rounding made them longer or shorter by is no angle.
    let sine = |cosine: f64| ((1.0 - cosine) * (1.0 + cosine)).sqrt();
    let (cosine_a, cosine_b) = (at[2].min(-at[5]), at[2].max(-at[5]));
    let (sine_a, sine_b) = (sine(cosine_a), sine(cosine_b));
    let (a, b) = (sine_a.atan2(cosine_a), sine_b.atan2(cosine_b));
    // sin a - (2 b / pi)^3, both 1 less something.
    let rest = cosine_b.atan2(sine_b) * 2.0 / PI;
    let cube = rest * (3.0 - 3.0 * rest + rest * rest) - cosine_a * cosine_a / (1.0 + sine_a);
    let slope = if apart >= 0.0 { sine_a } else { cube };
    let squared = at[6] * at[6];
    let first = 1.0 - 0.5 * squared / (squared + 0.33);
    let second = 0.45 * squared / (squared + 0.09) * apart * slope * (sine_b / cosine_b);
    let both = 4.0 * a * b / (PI * PI);
    let mean = (sine_a + sine_b) / (cosine_a + cosine_b);
    let third = 0.125 * squared / (squared + 0.09) * aside * mean * both * both;
    let mutual = 0.17 * squared / (squared + 0.13) * (1.0 - apart * (2.0 * b / PI).powi(2));
    vec![first / PI, second / PI, third / PI, mutual / PI]
}

/// The model without what light does twice.
fn qualitative(at: &[f64]) -> Vec<f64> {
    let aligned = -(at[0] * at[3] + at[1] * at[4]);
    let squared = at[6] * at[6];
    let first = 1.0 - 0.5 * squared / (squared + 0.33);
    let second = 0.45 * squared / (squared + 0.09) * aligned.max(0.0) / at[2].max(-at[5]);
    vec![first / PI, second / PI]
}

#[test]
fn both_models_keep_their_digits() {
    let inputs = [LIGHT_AND_RAY[0], LIGHT_AND_RAY[1], Input::Number("sigma")];
    let rows = with(&pairs(), &[[0.0], [0.3], [1.5]]);
    let models: [Terms; 2] = [full, qualitative];
    for (model, exact) in (0..).zip(models) {
        let fixed = [upright(), ("model", choice(model))];
        let asked =
            Asked { node: "oren_nayar_brdf", inputs: &inputs, fixed: &fixed, output: "value" };
        let name = format!("double_grazing: oren_nayar model {model}");
        let sum = |at: &[f64]| held(exact(at).iter().sum());
        let size = |at: &[f64]| exact(at).iter().map(|term| term.abs()).sum::<f64>();
        hold_sum(&name, &asked, &rows, 4.0, sum, size);
    }
}
