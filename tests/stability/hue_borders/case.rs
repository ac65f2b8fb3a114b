//! Hues at the borders of sextants and three units in the last place to either side, far turns out and subnormal,
//! at values from the smallest number to 10^38.

use crate::bounds::hold;
use crate::nodes::{Asked, Input, values};
use phenomenon_compiler::testing::build::scalar;

fn hues() -> Vec<f32> {
    let mut hues = vec![0.0, f32::from_bits(1), -f32::from_bits(1), -1e-8, 1e-8];
    for border in -12..=13 {
        let (mut below, mut above) = (border as f32 / 6.0, border as f32 / 6.0);
        hues.push(below);
        for _ in 0..3 {
            (below, above) = (below.next_down(), above.next_up());
            hues.extend([below, above]);
        }
    }
    hues
}

/// `v (1 - s (1 - pure))` with tents over the turn.
fn exact(at: &[f64]) -> [f64; 3] {
    let sextant = (at[0] - at[0].floor()) * 6.0;
    let pure =
        [(sextant - 3.0).abs() - 1.0, 2.0 - (sextant - 2.0).abs(), 2.0 - (sextant - 4.0).abs()];
    pure.map(|pure| at[2] * (1.0 - at[1] * (1.0 - pure.clamp(0.0, 1.0))))
}

#[test]
fn colours_meet_at_the_borders() {
    let asked = Asked {
        node: "hsv_to_rgb",
        inputs: &[Input::Number("hue"), Input::Number("saturation"), Input::Number("value")],
        fixed: &[],
        output: "color",
    };
    let mut rows = Vec::new();
    for hue in hues() {
        for saturation in [1.0, 1.0_f32.next_down(), 0.5, 1e-8, 0.0] {
            for value in [1.0, 0.7, 1e-38, 1e38] {
                rows.push(vec![hue, saturation, value]);
            }
        }
    }
    hold("hue_borders", &asked, &rows, 2.0, exact);
    // No component above the value, none below 0.
    for (row, color) in rows.iter().zip(values(&asked, &rows)) {
        assert!(color.iter().all(|x| (0.0..=row[2]).contains(x)), "{row:?}: {color:?}");
    }
}

/// Hue in, hue out, across every border.
#[test]
fn hues_come_back() {
    use phenomenon_compiler::engine::{Shade, Shaded};
    use phenomenon_compiler::graph::RootKind;
    use phenomenon_compiler::state::State;
    use phenomenon_compiler::testing::build::Build;
    use phenomenon_compiler::testing::mock::MockRenderer;

    let mut build = Build::new();
    let hue = build.node("state", &[]).output("u");
    let color = build.node("hsv_to_rgb", &[("hue", hue), ("value", scalar(3.0))]).first();
    let back = build.node("rgb_to_hsv", &[("color", color)]);
    let inputs =
        [("r", back.output("hue")), ("g", back.output("saturation")), ("b", back.output("value"))];
    let color = build.node("combine_color", &inputs).first();
    let built = build.material(color);
    let points: Vec<State> =
        hues().iter().map(|&hue| State { uv: [hue, 0.0], ..State::default() }).collect();
    for options in crate::nodes::engines() {
        let mut shaded = vec![Shaded::default(); points.len()];
        let shader = built.shader(&[], options);
        shader.shade(RootKind::Material, &points, &mut MockRenderer::default(), &mut shaded);
        for (point, found) in points.iter().zip(shaded) {
            let turn = f64::from(point.uv[0]);
            let off = (f64::from(found.color[0]) - turn).rem_euclid(1.0);
            // A sixth of a component's rounding, and that of the turn.
            let allowed = 4.0 * crate::bounds::ROUNDING * (1.0 + turn.abs());
            assert!(off.min(1.0 - off) <= allowed, "{turn} comes back as {:?}", found.color);
            assert_eq!(found.color[1..3], [1.0, 3.0], "{turn}");
        }
    }
}
