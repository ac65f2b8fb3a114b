//! Cosines from 0 over the smallest numbers to 1 less one unit in the last place, at mirrors and Fresnel's formulas.

use phenomenon_compiler::testing::build::vector;

use crate::bounds::hold;
use crate::nodes::{Asked, Input, values};

/// From along the surface to head on.
fn cosines() -> Vec<f32> {
    let near_one = |steps: u32| f32::from_bits(1.0_f32.to_bits() - steps);
    let tiny = [0.0, f32::from_bits(1), 1e-38, 1e-25, 1e-20, 1e-12, 1e-8, 1e-5, 2e-4, 1e-3, 0.03];
    let large = [0.3, 0.6, 0.9].into_iter().chain([100, 8, 3, 2, 1, 0].map(near_one));
    tiny.into_iter().chain(large).collect()
}

/// Each cosine with each pair of indices.
fn rows(pairs: &[[f32; 2]]) -> Vec<Vec<f32>> {
    let of = |&[a, b]: &[f32; 2]| cosines().into_iter().map(move |cosine| vec![cosine, a, b]);
    pairs.iter().flat_map(of).collect()
}

/// Reflectance of a dielectric for unequal indices, by amplitudes.
pub fn dielectric(cosine: f64, n1: f64, n2: f64) -> f64 {
    let along = n1 * cosine;
    let squared = (n2 - n1) * (n2 + n1) + along * along;
    if squared <= 0.0 {
        return 1.0;
    }
    let bent = squared.sqrt();
    let rs = (along - bent) / (along + bent);
    let rp = (n2 * n2 * cosine - n1 * bent) / (n2 * n2 * cosine + n1 * bent);
    (rs * rs + rp * rp) / 2.0
}

/// A complex number.
type Complex = [f64; 2];

/// `|(a - b) / (a + b)|^2`.
fn share(a: Complex, b: Complex) -> f64 {
    let squared = |x: f64, y: f64| x * x + y * y;
    squared(a[0] - b[0], a[1] - b[1]) / squared(a[0] + b[0], a[1] + b[1])
}

/// Reflectance of a metal in air, by complex amplitudes.
fn conductor(cosine: f64, n: f64, k: f64) -> f64 {
    // The root of (n + i k)^2 - 1 + cosine^2.
    let (real, imaginary) = ((n - 1.0) * (n + 1.0) - k * k + cosine * cosine, 2.0 * n * k);
    let size = real.hypot(imaginary);
    let root = match real < 0.0 {
        true => {
            let b = ((size - real) / 2.0).sqrt();
            [imaginary / 2.0 / b, b]
        }
        false => {
            let a = ((size + real) / 2.0).sqrt();
            [a, imaginary / 2.0 / a]
        }
    };
    let parallel = [(n * n - k * k) * cosine, imaginary * cosine];
    (share([cosine, 0.0], root) + share(parallel, root)) / 2.0
}

#[test]
fn dielectrics_keep_their_digits_at_every_cosine() {
    let next = 1.0_f32.next_up();
    let asked = Asked {
        node: "fresnel_dielectric",
        inputs: &[Input::Number("cosine"), Input::Number("ior_in"), Input::Number("ior_out")],
        fixed: &[],
        output: "reflectance",
    };
    let pairs = [[1.0, 1.5], [1.5, 1.0], [1.0, 100.0], [1.0, next], [next, 1.0], [1.33, 1.5]];
    hold("grazing: fresnel_dielectric", &asked, &rows(&pairs), 2.0, |at| {
        [dielectric(at[0], at[1], at[2]); 3]
    });
    let matched = rows(&[[1.0, 1.0], [1.5, 1.5], [next, next]]);
    assert!(values(&asked, &matched).iter().all(|value| *value == [0.0; 3]));
}

#[test]
fn conductors_keep_their_digits_at_every_cosine() {
    let asked = Asked {
        node: "fresnel_conductor",
        inputs: &[Input::Number("cosine"), Input::Number("ior"), Input::Number("extinction")],
        fixed: &[],
        output: "reflectance",
    };
    let pairs = [
        [0.2, 3.9],
        [1.5, 0.0],
        [0.7, 0.0],
        [1.0, 1e-3],
        [1.0, 1e-12],
        [1.0_f32.next_down(), 1e-6],
        [1e-6, 1e-6],
        [1e6, 1e6],
        [0.0, 2.0],
    ];
    hold("grazing: fresnel_conductor", &asked, &rows(&pairs), 4.0, |at| {
        [conductor(at[0], at[1], at[2]); 3]
    });
    // Air: nothing at all.
    for value in values(&asked, &rows(&[[1.0, 0.0]])) {
        assert_eq!(value, [0.0; 3]);
    }
}

/// Without extinction the index is known to the last digit, and so has to be the result.
#[test]
fn a_conductor_next_to_air_is_a_dielectric() {
    let asked = Asked {
        node: "fresnel_conductor",
        inputs: &[Input::Number("cosine"), Input::Number("ior")],
        fixed: &[("extinction", phenomenon_compiler::testing::build::scalar(0.0))],
        output: "reflectance",
    };
    let indices = [1.0_f32.next_up(), 1.000_001, 1.001, 1.5];
    let rows: Vec<Vec<f32>> = indices
        .into_iter()
        .flat_map(|ior| cosines().into_iter().map(move |cosine| vec![cosine, ior]))
        .collect();
    hold("grazing: fresnel_conductor next to air", &asked, &rows, 0.0, |at| {
        [dielectric(at[0], 1.0, at[1]); 3]
    });
}

#[test]
fn mirrored_rays_keep_their_direction() {
    let up = vector([0.0, 0.0, 1.0]);
    let asked = Asked {
        node: "reflection_direction",
        inputs: &[Input::Vector("direction")],
        fixed: &[("normal", up.clone()), ("normal_geom", up)],
        output: "direction",
    };
    let row = |cosine: f32| vec![(1.0 - f64::from(cosine).powi(2)).sqrt() as f32, 0.0, -cosine];
    // Along the surface it is lifted, by the node's doc.
    let rows: Vec<Vec<f32>> =
        cosines().into_iter().filter(|cosine| *cosine > 0.0).map(row).collect();
    hold("grazing: reflection_direction", &asked, &rows, 2.0, |at| {
        let length = (at[0] * at[0] + at[2] * at[2]).sqrt();
        [at[0] / length, 0.0, -at[2] / length]
    });
}
