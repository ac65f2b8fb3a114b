//! Phong's lobes and Blinn's power with exponents to 10^8.

use std::f64::consts::{PI, TAU};

use crate::bounds::hold;
use crate::nodes::{Asked, Input, LIGHT_AND_RAY, choice, upright};
use crate::perfect_mirrors::{facets, held, mirror_pairs, with};

/// Half the squared distance between the viewer and the mirrored light.
fn off_mirror(at: &[f64]) -> f64 {
    let (light, viewer, sum) = facets(at);
    ((light - viewer).powi(2) + sum[0] * sum[0] + sum[1] * sum[1]) / 2.0
}

#[test]
fn phongs_lobes_are_as_narrow_as_they_say() {
    let inputs = [LIGHT_AND_RAY[0], LIGHT_AND_RAY[1], Input::Number("exponent")];
    let exponents = [[0.0], [1.0], [1e4], [1e7], [1e8]];
    let lobes: [fn(f64, f64) -> f64; 3] = [
        |off, n| (n * (-off).ln_1p()).exp(),
        |off, n| (1.0 - off) / (n * off + 1.0 - off),
        |off, n| (n * (-off).ln_1p()).exp() * (n + 2.0) / TAU,
    ];
    for (kind, lobe) in (0..).zip(lobes) {
        let fixed = [upright(), ("kind", choice(kind))];
        let asked = Asked { node: "phong_brdf", inputs: &inputs, fixed: &fixed, output: "value" };
        let rows = with(&mirror_pairs(), &exponents);
        let name = format!("huge_exponents: phong kind {kind}");
        hold(&name, &asked, &rows, 2.0, |at| {
            let off = off_mirror(at);
            held(if off < 1.0 { lobe(off, at[6]) } else { 0.0 })
        });
    }
}

#[test]
fn blinns_power_is_as_narrow_as_its_roughness_says() {
    let inputs = [LIGHT_AND_RAY[0], LIGHT_AND_RAY[1], Input::Number("roughness")];
    let fixed = [upright(), ("distribution", choice(2))];
    let asked =
        Asked { node: "microfacet_distribution", inputs: &inputs, fixed: &fixed, output: "value" };
    // The roughness of exponents 10^8, 10^7, 10^4 and 0.
    let roughnesses = [1e8, 1e7, 1e4, 0.0].map(|n: f64| [(2.0 / (n + 2.0)).sqrt() as f32]);
    let rows = with(&mirror_pairs(), &roughnesses);
    hold("huge_exponents: Blinn's power", &asked, &rows, 3.0, |at| {
        let (_, _, sum) = facets(at);
        let rough = at[6] * at[6];
        let slope = (sum[0] * sum[0] + sum[1] * sum[1]) / (sum[2] * sum[2]);
        held((-(1.0 / rough - 1.0) * slope.ln_1p()).exp() / (PI * rough))
    });
}
