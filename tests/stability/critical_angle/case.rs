//! Light about to leave glass: sixty cosines on either side of the critical one, and a glass ball in a white world.

use phenomenon_compiler::testing::build::vector;

use crate::bounds::hold;
use crate::grazing::dielectric;
use crate::nodes::{Asked, Input, values};
use crate::scenes::{furnace, pixels, scene, text};

const PAIRS: [[f32; 2]; 6] =
    [[1.5, 1.0], [1.33, 1.0], [2.42, 1.5], [100.0, 1.0], [1.000_1, 1.0], [1.5, 1.499_999_9]];

/// `n2^2 - n1^2 + n1^2 c^2`: more than nothing passes where it is above 0. Of 32-bit numbers its products are exact.
fn squared(n1: f64, n2: f64, cosine: f64) -> f64 {
    (n2 - n1) * (n2 + n1) + n1 * cosine * (n1 * cosine)
}

/// Rays on either side of the critical angle: x, y, z of the ray, both indices.
fn rows(passing: bool) -> Vec<Vec<f32>> {
    let mut rows = Vec::new();
    for [n1, n2] in PAIRS {
        let (a, b) = (f64::from(n1), f64::from(n2));
        let critical = (((a - b) * (a + b)).sqrt() / a) as f32;
        for step in -60..=60 {
            let cosine = f32::from_bits((critical.to_bits() as i32 + step) as u32);
            let squared = squared(a, b, cosine.into());
            // Closer than 64 bits tell is nothing.
            if squared.abs() > 1e-14 * b * b && (squared > 0.0) == passing {
                let sine = (1.0 - f64::from(cosine).powi(2)).sqrt() as f32;
                rows.push(vec![sine, 0.0, -cosine, n1, n2]);
            }
        }
    }
    assert!(rows.len() > 200);
    rows
}

#[test]
fn what_passes_and_what_does_not_is_told_to_the_last_cosine() {
    let up = vector([0.0, 0.0, 1.0]);
    let asked = Asked {
        node: "refraction_direction",
        inputs: &[Input::Vector("direction"), Input::Number("ior_in"), Input::Number("ior_out")],
        fixed: &[("normal", up.clone()), ("normal_geom", up)],
        output: "direction",
    };
    let unit = |x: f64, z: f64| {
        let length = x.hypot(z);
        [x / length, 0.0, z / length]
    };
    let (passing, total) = (rows(true), rows(false));
    for (direction, row) in values(&asked, &passing).iter().zip(&passing) {
        assert!(direction[2] < 0.0, "{row:?} passes, and goes {direction:?}");
    }
    hold("critical_angle: refracted", &asked, &passing, 2.0, |at| {
        let beyond = squared(at[3], at[4], -at[2]).max(0.0).sqrt() / at[3];
        unit(at[0], -beyond)
    });
    hold("critical_angle: reflected", &asked, &total, 2.0, |at| unit(at[0], -at[2]));
}

#[test]
fn reflectance_reaches_one_there_and_stays() {
    let asked = Asked {
        node: "fresnel_dielectric",
        inputs: &[Input::Number("cosine"), Input::Number("ior_in"), Input::Number("ior_out")],
        fixed: &[],
        output: "reflectance",
    };
    let of = |rows: Vec<Vec<f32>>| -> Vec<Vec<f32>> {
        rows.iter().map(|row| vec![-row[2], row[3], row[4]]).collect()
    };
    let (passing, total) = (of(rows(true)), of(rows(false)));
    hold("critical_angle: fresnel_dielectric", &asked, &passing, 2.0, |at| {
        [dielectric(at[0], at[1], at[2]); 3]
    });
    assert!(values(&asked, &total).iter().all(|value| *value == [1.0; 3]));
}

#[test]
fn a_glass_ball_in_a_white_world_is_not_seen() {
    let text = text("critical_angle");
    let found = pixels(40, 2, |options| scene("critical_angle", &text, options));
    for (at, pixel) in found.iter().enumerate() {
        let off = pixel.map(|x| (f64::from(x) - 1.0).abs());
        assert!(off.iter().all(|off| *off <= furnace(6)), "pixel {at}: {pixel:?}");
    }
}

#[test]
fn light_in_a_ball_is_bent_as_it_should_be() {
    crate::glass::hold("critical_angle", 40, 6);
}
