//! How far 32 bits may be off.
//!
//! An algorithm as stable as its problem allows gives the exact result of inputs a few roundings away, rounded a
//! few times. So the error has to stay below four units in the last place of the value, and what the exact value
//! changes by when each input is moved by so many roundings (2^-24, relatively), one by one, both ways, summed up.

use crate::nodes::{Asked, values};

/// Half a unit in the last place, relatively.
pub const ROUNDING: f64 = 1.0 / 16_777_216.0;
/// Below it, 32-bit exponentials times peaks of lobes have lost digits to underflow.
const FAINT: f64 = 1e-30;

/// How far each component may be off.
fn allowed(exact: &dyn Fn(&[f64]) -> [f64; 3], at: &[f64], roundings: f64) -> [f64; 3] {
    let here = exact(at);
    let mut allowed = here.map(|value| 8.0 * ROUNDING * value.abs() + FAINT);
    for number in 0..at.len() {
        let moved = |by: f64| {
            let mut moved = at.to_vec();
            moved[number] *= 1.0 + by;
            exact(&moved)
        };
        let (up, down) = (moved(roundings * ROUNDING), moved(-roundings * ROUNDING));
        for (component, allowed) in allowed.iter_mut().enumerate() {
            let change = |moved: [f64; 3]| (moved[component] - here[component]).abs();
            *allowed += change(up).max(change(down));
        }
    }
    allowed
}

/// Compares a node at rows of numbers with a formula in 64 bits over the same numbers.
///
/// # Panics
/// If it is farther off than allowed somewhere.
pub fn hold(
    name: &str,
    asked: &Asked<'_>,
    rows: &[Vec<f32>],
    roundings: f64,
    exact: impl Fn(&[f64]) -> [f64; 3],
) {
    hold_sum(name, asked, rows, roundings, exact, |_| 0.0);
}

/// The same of a sum whose terms may have both signs: four units in the last place of their sizes are allowed besides.
pub fn hold_sum(
    name: &str,
    asked: &Asked<'_>,
    rows: &[Vec<f32>],
    roundings: f64,
    exact: impl Fn(&[f64]) -> [f64; 3],
    size: impl Fn(&[f64]) -> f64,
) {
    assert!(!rows.is_empty(), "{name}: nothing is tried");
    let (mut worst, mut found) = (0.0_f64, Vec::new());
    for (row, value) in rows.iter().zip(values(asked, rows)) {
        let at: Vec<f64> = row.iter().map(|&number| number.into()).collect();
        let (expected, allowed) = (exact(&at), allowed(&exact, &at, roundings));
        let allowed = allowed.map(|allowed| allowed + 8.0 * ROUNDING * size(&at));
        for component in 0..3 {
            let (value, expected) = (f64::from(value[component]), expected[component]);
            assert!(expected.is_finite(), "{name} at {row:?}: the formula gives {expected}");
            let share = (value - expected).abs() / allowed[component];
            worst = worst.max(share);
            if share.is_nan() || share > 1.0 {
                found
                    .push(format!("{value:e} for {expected:e}, {share:.1} times too far: {row:?}"));
            }
        }
    }
    println!("{name}: {} rows, at most {worst:.2} of what is allowed", rows.len());
    found.truncate(12);
    assert!(found.is_empty(), "{name}, of {} rows, {worst:.1}:\n{}", rows.len(), found.join("\n"));
}
