//! Layers of high dynamic range: all modes over base and layer from 0 over the neighbours of one half and of 1 to
//! the largest they may be.

use crate::bounds::hold;
use crate::nodes::{Asked, Input, choice};

/// Of base and layer.
type Formula = fn(f64, f64) -> f64;

/// Lights from nothing to the largest of the range of factors.
fn lights() -> Vec<f32> {
    let near = |x: f32| [x.next_down(), x, x.next_up()];
    let small = [0.0, f32::from_bits(1), 1e-19, 0.1];
    let large = [2.0, 100.0, 65_504.0, 1e19];
    small.into_iter().chain(near(0.5)).chain(near(1.0)).chain(large).collect()
}

fn rows() -> Vec<Vec<f32>> {
    let lights = lights();
    lights.iter().flat_map(|&base| lights.iter().map(move |&layer| vec![base, layer])).collect()
}

/// Held to the largest number of 32 bits.
fn finite(value: f64) -> [f64; 3] {
    [value.clamp(f32::MIN.into(), f32::MAX.into()); 3]
}

/// As the file of `overlay` says.
fn overlay(base: f64, layer: f64) -> f64 {
    if base >= 1.0 { base } else { base * (base + 2.0 * layer.min(1.0) * (1.0 - base)) }
}

fn screen(base: f64, layer: f64) -> f64 {
    if base < 1.0 && layer < 1.0 { base + layer * (1.0 - base) } else { base.max(layer) }
}

#[test]
fn overlay_and_screen_neither_turn_nor_burst() {
    let formulas: [(&str, Formula); 2] = [("overlay", overlay), ("screen", screen)];
    for (node, formula) in formulas {
        let inputs = [Input::Number("base"), Input::Number("layer")];
        let asked = Asked { node, inputs: &inputs, fixed: &[], output: "color" };
        hold(&format!("bright_overlays: {node}"), &asked, &rows(), 2.0, |at| {
            finite(formula(at[0], at[1]))
        });
    }
}

/// A mode as the doc of `blend` has it; a quotient by 0 is 0.
fn mode(number: i32, a: f64, b: f64) -> f64 {
    let over = |x: f64, by: f64| if by == 0.0 { 0.0 } else { x / by };
    let lit = |by: f64| if by < 0.5 { 2.0 * a * b } else { 1.0 - 2.0 * (1.0 - a) * (1.0 - b) };
    match number {
        0 => b,
        1 => a + b,
        2 => a - b,
        3 => a * b,
        4 => over(a, b),
        5 => a + b - a * b,
        6 => lit(a),
        7 => lit(b),
        8 => a * ((1.0 - a) * b + a + b - a * b),
        9 => a + 2.0 * b - 1.0,
        10 => a + b - 1.0,
        11 if b == 0.0 => 0.0,
        11 => 1.0 - (1.0 - a) / b,
        12 => over(a, 1.0 - b),
        13 => a.min(b),
        14 => a.max(b),
        15 => (a - b).abs(),
        16 => a + b - 2.0 * a * b,
        17 => 1.0 - (1.0 - a - b).abs(),
        _ => (a + b) / 2.0,
    }
}

#[test]
fn every_mode_follows_its_formula_into_bright_light() {
    for number in 0..19 {
        let inputs = [Input::Number("base"), Input::Number("layer")];
        let fixed = [("mode", choice(number))];
        let asked = Asked { node: "blend", inputs: &inputs, fixed: &fixed, output: "result" };
        hold(&format!("bright_overlays: blend mode {number}"), &asked, &rows(), 2.0, |at| {
            finite(mode(number, at[0], at[1]))
        });
    }
}
