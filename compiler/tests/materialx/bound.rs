//! How far two evaluations in 32 bits may be apart.
//!
//! Both sides compute a formula in 32-bit numbers, in orders of their own. What either yields is what the
//! formula has for inputs that are a few units in the last place off (its backward error; sums, products and
//! the functions of either side are good to 4), then rounded. So they differ by no more than 4 units of the
//! result, and twice what it moves by when each input number is moved by 4 of its units.

use std::collections::BTreeMap;

use crate::cases::Case;
use crate::evaluate::Evaluator;

/// Units in the last place that count as the same.
const UNITS: u32 = 4;
/// No share of a result, or of what it is made of, beyond this is put down to rounding.
const MOST: f64 = 1.0 / 1024.0;

type Numbers = BTreeMap<String, Vec<f32>>;

/// Whether our value of a case is that of the file, the renderer's function being as coarse as its row says.
///
/// # Errors
/// If it is not, with what it is.
pub fn hold(case: &Case, coarse: f64, evaluator: &Evaluator) -> Result<(), String> {
    let coarse = if case.is_rendered { coarse } else { 0.0 };
    let ours = evaluator.values(&case.numbers)?;
    if ours.len() < case.value.len() {
        return Err(format!("{} numbers of {}", ours.len(), case.value.len()));
    }
    let pairs = || ours.iter().map(|&x| f64::from(x)).zip(case.value.iter().copied());
    if pairs().all(|(ours, theirs)| (ours - theirs).abs() <= units(theirs)) {
        return Ok(());
    }
    let moved = moved(case, evaluator, &ours)?;
    for (at, (ours, theirs)) in pairs().enumerate() {
        let most = MOST * theirs.abs().max(largest(&case.numbers));
        let bound = units(theirs) + coarse + (2.0 * moved[at]).min(most);
        let error = (ours - theirs).abs();
        if error.is_nan() || error > bound {
            return Err(format!("component {at} is {ours}, off by {error:e}, more than {bound:e}"));
        }
    }
    Ok(())
}

/// `UNITS` of a number.
fn units(x: f64) -> f64 {
    let size = x.abs() as f32;
    f64::from(UNITS) * f64::from(size.next_up() - size)
}

fn largest(numbers: &Numbers) -> f64 {
    numbers.values().flatten().fold(0.0, |most, &x| most.max(f64::from(x).abs()))
}

/// How far each component moves, in all, when input numbers move by `UNITS`.
fn moved(case: &Case, evaluator: &Evaluator, ours: &[f32]) -> Result<Vec<f64>, String> {
    let mut sums = vec![0.0; ours.len()];
    for (name, numbers) in &case.numbers {
        if case.truths.contains(name) {
            continue;
        }
        for at in 0..numbers.len() {
            let mut most = vec![0.0_f64; ours.len()];
            for step in [f32::next_up as fn(f32) -> f32, f32::next_down] {
                let mut changed = case.numbers.clone();
                let number = &mut changed.get_mut(name).expect("it is there")[at];
                *number = (0..UNITS).fold(*number, |x, _| step(x));
                let values = evaluator.values(&changed)?;
                for (most, (a, b)) in most.iter_mut().zip(values.iter().zip(ours)) {
                    *most = most.max((f64::from(*a) - f64::from(*b)).abs());
                }
            }
            sums.iter_mut().zip(most).for_each(|(sum, most)| *sum += most);
        }
    }
    Ok(sums)
}
