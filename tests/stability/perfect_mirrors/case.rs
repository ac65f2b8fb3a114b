//! Ashikhmin and Shirley's lobe at mirror pairs, where its exponent as printed is 0 / 0, and next to them, with
//! exponents to the largest there is: a perfect mirror.

use std::f64::consts::PI;

use phenomenon_compiler::testing::build::scalar;

use crate::bounds::hold;
use crate::nodes::{Asked, Input, LIGHT_AND_RAY, along_x, upright};
use crate::scenes::dot;

/// Light and ray of mirror pairs, the light moved off by a bit: along the plane of both and across.
pub fn mirror_pairs() -> Vec<Vec<f32>> {
    let mut rows = Vec::new();
    for cosine in [1.0_f32, 1.0_f32.next_down(), 0.8, 0.3, 1e-2, 1e-4, 1e-8, 1e-20] {
        let sine = (1.0 - f64::from(cosine).powi(2)).sqrt();
        for turn in [0.0, 0.7, 1.6] {
            let (x, y) = ((sine * f64::cos(turn)) as f32, (sine * f64::sin(turn)) as f32);
            for off in [0.0, 1e-8, 1e-6, 1e-4, 1e-3] {
                let off = off * cosine;
                rows.push(vec![x + off, y - 0.5 * off, cosine, x, y, -cosine]);
                rows.push(vec![x, y, cosine + off, x, y, -cosine]);
            }
        }
    }
    rows
}

/// Each pair with each of these numbers behind it.
pub fn with<const N: usize>(pairs: &[Vec<f32>], numbers: &[[f32; N]]) -> Vec<Vec<f32>> {
    let of = |numbers: &[f32; N]| {
        let numbers = *numbers;
        pairs.iter().map(move |pair| pair.iter().copied().chain(numbers).collect())
    };
    numbers.iter().flat_map(of).collect()
}

/// Cosines towards light and viewer, and the sum of both directions.
pub fn facets(at: &[f64]) -> (f64, f64, [f64; 3]) {
    (at[2], -at[5], [0, 1, 2].map(|k| at[k] - at[k + 3]))
}

/// The largest number of 32 bits: what is above it is held there.
pub fn held(value: f64) -> [f64; 3] {
    [value.clamp(0.0, f32::MAX.into()); 3]
}

/// The coat, with a reflectance of 0.25 head on.
fn coat(at: &[f64]) -> f64 {
    let (light, viewer, sum) = facets(at);
    let (u, v) = (at[6], at[7]);
    let (along, across) = (sum[0] * sum[0], sum[1] * sum[1]);
    let flat = along + across;
    let exponent = if flat == 0.0 { 0.0 } else { (u * along + v * across) / flat };
    let power = (-0.5 * exponent * (flat / (sum[2] * sum[2])).ln_1p()).exp();
    let lobe = ((u + 1.0) * (v + 1.0)).sqrt() / (2.0 * PI) * power;
    let cosine = (dot(sum, sum).sqrt() / 2.0).min(1.0);
    let fresnel = 0.25 + 0.75 * (1.0 - cosine).powi(5);
    fresnel * lobe / (4.0 * cosine * light.max(viewer))
}

#[test]
fn mirrors_have_a_peak_and_not_a_hole() {
    let inputs = [
        LIGHT_AND_RAY[0],
        LIGHT_AND_RAY[1],
        Input::Number("exponent_u"),
        Input::Number("exponent_v"),
    ];
    let asked = Asked {
        node: "ashikhmin_shirley_brdf",
        inputs: &inputs,
        fixed: &[upright(), along_x(), ("specular", scalar(0.25))],
        output: "coat",
    };
    let exponents = [[0.0, 0.0], [1.0, 1e8], [1e4, 10.0], [1e7, 1e7], [1e8, 1e8]];
    let rows = with(&mirror_pairs(), &exponents);
    hold("perfect_mirrors", &asked, &rows, 2.0, |at| held(coat(at)));
}
