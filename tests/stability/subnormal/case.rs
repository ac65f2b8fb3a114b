//! Colours below the smallest normal number: no engine and no film takes them for 0, and what is made of them is
//! rounded as everything else.

use crate::bounds::hold;
use crate::nodes::{Asked, Input};
use crate::scenes::{pixels, scene, text};

/// Of two numbers.
type Formula = fn(f64, f64) -> f64;

/// Numbers below 2^-126, and some that meet them.
fn faint() -> Vec<f32> {
    [1, 2, 3, 1000, 0x7f_ffff, 0x80_0000]
        .map(f32::from_bits)
        .into_iter()
        .chain([1e-20, 1.0])
        .collect()
}

fn pairs() -> Vec<Vec<f32>> {
    let of = |a: f32| faint().into_iter().map(move |b| vec![a, b]);
    faint().into_iter().flat_map(of).collect()
}

/// Half the smallest number.
const HALF_A_STEP: f64 = 7.1e-46;

#[test]
fn sums_and_products_are_rounded_once() {
    let nodes: [(&str, Formula); 4] = [
        ("add", |a, b| a + b),
        ("subtract", |a, b| a - b),
        ("multiply", |a, b| a * b),
        ("maximum", f64::max),
    ];
    for (node, formula) in nodes {
        let inputs = [Input::Number("a"), Input::Number("b")];
        let asked = Asked { node, inputs: &inputs, fixed: &[], output: "result" };
        let rows = pairs();
        hold(&format!("subnormal: {node}"), &asked, &rows, 1.0, |at| [formula(at[0], at[1]); 3]);
        for (row, found) in rows.iter().zip(crate::nodes::values(&asked, &rows)) {
            let exact = formula(row[0].into(), row[1].into());
            let step = (exact.abs() * crate::bounds::ROUNDING).max(HALF_A_STEP);
            assert!((f64::from(found[0]) - exact).abs() <= step, "{node} {row:?}: {found:?}");
        }
    }
}

#[test]
fn colours_turn_and_come_back() {
    for value in faint() {
        let asked = Asked {
            node: "hsv_to_rgb",
            inputs: &[Input::Number("hue"), Input::Number("value")],
            fixed: &[],
            output: "color",
        };
        let rows: Vec<Vec<f32>> =
            [0.0, 1.0 / 3.0, 0.5].iter().map(|&hue| vec![hue, value]).collect();
        let found = crate::nodes::values(&asked, &rows);
        assert_eq!(found[0], [value, 0.0, 0.0]);
        assert_eq!(found[2], [0.0, value, value]);
    }
}

/// A mirror of one half under a sky of faint light, lit paper, and the sum of samples.
#[test]
fn pictures_keep_faint_light() {
    let text = text("subnormal");
    for faint in [1e-40_f32, f32::from_bits(8), f32::from_bits(0x80_0000)] {
        let number = format!("[{:e}, {:e}, {:e}]", faint, faint * 2.0, faint * 4.0);
        let text = text.replace("[1, 2, 4]", &number);
        for samples in [1, 4] {
            let found = pixels(16, samples, |options| scene("subnormal", &text, options));
            let (sky, mirrored) = ([1.0, 2.0, 4.0], [0.5, 1.0, 2.0]);
            let of = |factors: [f32; 3]| factors.map(|factor| factor * faint);
            // Left of the edge there is the sky, right of it its image in the mirror.
            assert!(found.contains(&of(sky)), "{faint:e}, {samples} samples: {found:?}");
            assert!(found.contains(&of(mirrored)), "{faint:e}, {samples} samples: {found:?}");
            assert!(found.iter().all(|pixel| pixel[0] >= 0.5 * faint && pixel[0] <= faint));
        }
    }
}
