//! Ward's, Cook and Torrance's and GGX' reflectance as roughness vanishes, at mirror pairs and next to them.

use std::f64::consts::PI;

use phenomenon_compiler::testing::build::{color, scalar};

use crate::bounds::hold;
use crate::nodes::{Asked, Input, LIGHT_AND_RAY, along_x, choice, upright};
use crate::perfect_mirrors::{facets, held, mirror_pairs, with};
use crate::scenes::dot;

/// What counts as the least roughness.
const LEAST: f32 = 1e-6;

fn least(roughness: f64) -> f64 {
    roughness.max(LEAST.into())
}

/// Ward's four forms.
fn ward(at: &[f64], form: i32) -> f64 {
    let (light, viewer, sum) = facets(at);
    let (u, v) = (least(at[6]), least(at[7]));
    let depth = (sum[0] / sum[2] / u).powi(2) + (sum[1] / sum[2] / v).powi(2);
    let lobe = (-depth).exp() / (4.0 * PI * u * v);
    match form {
        1 => lobe / (light * viewer),
        2 => lobe * 4.0 * dot(sum, sum) / sum[2].powi(4),
        3 if light * viewer < 1e-4 => 0.0,
        _ => lobe / (light * viewer).sqrt(),
    }
}

/// Roughnesses along and across.
const ROUGH: [[f32; 2]; 5] =
    [[0.0, 0.0], [0.0, 1.0], [f32::MIN_POSITIVE, LEAST], [1e-4, 1e-5], [0.3, 0.01]];

#[test]
fn wards_forms_keep_their_peak() {
    let inputs = [
        LIGHT_AND_RAY[0],
        LIGHT_AND_RAY[1],
        Input::Number("roughness_u"),
        Input::Number("roughness_v"),
    ];
    for form in 0..4 {
        let fixed = [upright(), along_x(), ("form", choice(form))];
        let asked = Asked { node: "ward_brdf", inputs: &inputs, fixed: &fixed, output: "value" };
        // Where mental ray's form ends, 32 bits may tell otherwise than 64.
        let on_the_edge =
            |row: &Vec<f32>| (f64::from(row[2]) * f64::from(-row[5]) / 1e-4 - 1.0).abs() < 1e-6;
        let rows: Vec<Vec<f32>> =
            with(&mirror_pairs(), &ROUGH).into_iter().filter(|row| !on_the_edge(row)).collect();
        let name = format!("vanishing_roughness: ward form {form}");
        hold(&name, &asked, &rows, 2.0, |at| held(ward(at, form)));
    }
}

/// GGX with a Fresnel term of 1 and heights correlated.
fn ggx(at: &[f64]) -> f64 {
    let (light, viewer, sum) = facets(at);
    let (a, b) = (least(at[6]), least(at[7]));
    let stretched = (sum[0] / a).powi(2) + (sum[1] / b).powi(2) + sum[2].powi(2);
    let distribution = (dot(sum, sum) / stretched).powi(2) / (PI * a * b);
    let length = |x: f64, y: f64, z: f64| ((x * a).powi(2) + (y * b).powi(2) + z * z).sqrt();
    let crossed = light * length(at[3], at[4], at[5]) + viewer * length(at[0], at[1], at[2]);
    distribution / (2.0 * crossed)
}

#[test]
fn ggx_keeps_its_peak() {
    let inputs = [
        LIGHT_AND_RAY[0],
        LIGHT_AND_RAY[1],
        Input::Number("roughness_u"),
        Input::Number("roughness_v"),
    ];
    let fixed = [upright(), along_x(), ("f0", color([1.0; 4]))];
    let asked = Asked { node: "ggx_brdf", inputs: &inputs, fixed: &fixed, output: "value" };
    let rows = with(&mirror_pairs(), &ROUGH);
    hold("vanishing_roughness: ggx", &asked, &rows, 2.0, |at| held(ggx(at)));
}

/// Beckmann's distribution under Torrance and Sparrow's grooves, the index 100: Fresnel's term is all but constant.
#[test]
fn grooves_keep_their_peak() {
    let inputs = [LIGHT_AND_RAY[0], LIGHT_AND_RAY[1], Input::Number("roughness")];
    let fixed = [upright(), ("ior", scalar(100.0))];
    let asked =
        Asked { node: "torrance_sparrow_brdf", inputs: &inputs, fixed: &fixed, output: "value" };
    let grooves = |at: &[f64]| {
        let (light, viewer, sum) = facets(at);
        let rough = least(at[6]).powi(2);
        let slope = (sum[0] * sum[0] + sum[1] * sum[1]) / (sum[2] * sum[2]);
        let distribution = (-slope / rough).exp() * (1.0 + slope).powi(2) / (PI * rough);
        let (low, high) = (light.min(viewer), light.max(viewer));
        let seen = (1.0_f64).min(4.0 * sum[2] * low / dot(sum, sum));
        let cosine = (dot(sum, sum).sqrt() / 2.0).min(1.0);
        let fresnel = crate::grazing::dielectric(cosine, 1.0, 100.0);
        distribution * seen * fresnel / (4.0 * low * high)
    };
    let rows = with(&mirror_pairs(), &[[0.0], [LEAST], [1e-4], [0.3], [1.0]]);
    hold("vanishing_roughness: torrance_sparrow", &asked, &rows, 2.0, |at| held(grooves(at)));
}
