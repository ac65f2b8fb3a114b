use crate::emit::{Int, Real};
use crate::nodes::finite::UNIT;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// The two numbers of a sample, spread: the unit square is cut into as many equal cells as there are
    /// samples, and each sample falls into its own. The mean over them errs less than over numbers drawn
    /// each for itself, and is as true.
    ///
    /// There are r rows, the largest divisor of the count not above its root, and `count / r` columns; sample
    /// k lies in row `k mod r`, and in the k-th of `count` slices of u. So a square count is best, and
    /// a prime one spreads u alone.
    stratified_sample in samples,
    source "Chiu, Shirley and Wang 1994, Multi-jittered Sampling",
    inputs {
        /// How many samples the loop takes: the same as its own.
        count: count = 16, in 1.0..=1024.0;
        /// Number of the sample, from 0; past the last one it begins anew.
        index: integer = state(Field::SampleIndex), in 0.0..=65_535.0;
        /// First number drawn.
        u: scalar = state(Field::SampleU), in UNIT;
        /// Second number drawn.
        v: scalar = state(Field::SampleV), in UNIT;
    }
    outputs {
        /// First number, below 1.
        u: scalar, in UNIT;
        /// Second number, below 1.
        v: scalar, in UNIT;
    }
    body |e, i| {
        let (count, rows) = (f64::from(i.count), f64::from(rows(i.count)));
        let index = modulo(i.index.to_real(), count);
        let within = |cell: E::Real, drawn: E::Real, cells: f64| {
            // Rounding may reach the end, which belongs to the next cell.
            ((cell + drawn.saturate()) / cells).minimum(e.real(1.0 - f64::from(f32::EPSILON) / 2.0))
        };
        Outputs { u: within(index, i.u, count), v: within(modulo(index, rows), i.v, rows) }
    }
}

/// The largest divisor that is not above the root.
#[inline(always)]
fn rows(count: i32) -> i32 {
    let mut rows = 1;
    for divisor in 2..=32 {
        if divisor * divisor <= count && count % divisor == 0 {
            rows = divisor;
        }
    }
    rows
}

/// A whole number modulo another, below 2^20 both: half added, the quotient cannot be rounded up.
#[inline(always)]
fn modulo<R: Real>(number: R, divisor: f64) -> R {
    let quotient = ((number + 0.5) / divisor).floor();
    number - quotient * divisor
}

#[cfg(test)]
mod tests {
    #[test]
    fn each_cell_has_one_sample() {
        for (count, rows) in [(1, 1), (2, 1), (16, 4), (12, 3), (7, 1), (1024, 32), (1000, 25)] {
            let columns = count / rows;
            let mut hit = vec![0; count as usize];
            for index in 0..count {
                for (drawn, low) in [(0.0, true), (0.999_999_94, false)] {
                    let u = number!(count = count, index = index, u = drawn, v = drawn => u);
                    let v = number!(count = count, index = index, u = drawn, v = drawn => v);
                    assert!((0.0..1.0).contains(&u) && (0.0..1.0).contains(&v), "{u} {v}");
                    let nudge = if low { 1e-5 } else { -1e-5 };
                    let column = ((u + nudge) * columns as f32) as i32;
                    let row = ((v + nudge) * rows as f32) as i32;
                    hit[(row * columns + column) as usize] += 1;
                }
            }
            assert!(hit.iter().all(|hits| *hits == 2), "{count}: {hit:?}");
        }
    }

    #[test]
    fn past_the_last_it_begins_anew() {
        for index in [3, 15, 27, 65_523] {
            let again = number!(count = 12, index = index, u = 0.25 => u);
            assert_eq!(again, number!(count = 12, index = 3, u = 0.25 => u));
        }
    }
}
