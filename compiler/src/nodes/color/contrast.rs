use crate::emit::Real;
use crate::nodes::finite::{FACTOR, UNIT};

node! {
    /// Contrast about a pivot, per component: `pivot + (input - pivot) amount`. An amount of 1
    /// changes nothing, 0 leaves the pivot. MaterialX has a pivot of 0.5, made for encoded colours;
    /// Blender's is `(1 + c) input + b - c / 2`, clamped at 0. A colour keeps its alpha.
    contrast in color per component,
    source "",
    inputs {
        /// What is changed.
        input: generic = 0.0, in FACTOR;
        /// The value that stays; 0.18 is middle grey.
        pivot: scalar = 0.18, in FACTOR, soft UNIT;
        /// Factor on the distance from the pivot.
        amount: scalar = 1.0, in FACTOR, soft 0.0..=2.0;
    }
    outputs {
        /// The value with its new contrast.
        result: generic;
    }
    body |e, i| (i.input - i.pivot).mul_add(i.amount, i.pivot)
}

#[cfg(test)]
mod tests {
    #[test]
    fn stretches_about_the_pivot() {
        assert_eq!(number!(input = 3.0, pivot = 1.0, amount = 2.0 => result), 5.0);
        assert_eq!(number!(input = 1.0, pivot = 1.0, amount = 100.0 => result), 1.0);
        assert_eq!(numbers!(input = [0.5; 3], pivot = 0.25, amount = 0.0 => result), [0.25; 3]);
    }

    #[test]
    fn an_amount_of_one_changes_nothing_but_the_last_bit() {
        for input in [0.0, 0.18, 1.0_f32.next_down(), 1e10] {
            let error = number!(input = input => result) - input;
            assert!(error.abs() <= f32::EPSILON * (input + 0.18), "{input}: {error:e}");
        }
    }
}
