//! The node `posterize`.

use phenomenon_compiler::emit::{Mask, Real};
use phenomenon_compiler::node;
use phenomenon_compiler::nodes::finite::UNIT;

node! {
    /// Steps of equal height, per component: how many of `levels` thresholds the input has reached, as
    /// a share of all. Between 0 and 1 it goes up by `1 / levels` at each multiple of that.
    posterize in foreign per component,
    source "",
    inputs {
        /// What is stepped.
        input: generic = 0.5, in UNIT;
        /// How many steps there are.
        levels: count = 4, in 1.0..=16.0;
        /// Whether a step is a jump, or rises over the whole way to the next.
        edges: choice = 0, of ["hard", "soft"];
    }
    outputs {
        /// The value, in steps.
        result: generic, in UNIT;
    }
    body |e, i| {
        let height = 1.0 / f64::from(i.levels);
        let mut sum = e.real(0.0);
        for level in 1..=i.levels {
            let below = e.real(f64::from(level - 1) * height);
            let share = match i.edges {
                0 => e.real(f64::from(level) * height).less_equal(i.input).select(e.real(1.0), e.real(0.0)),
                _ => ((i.input - below) * f64::from(i.levels)).saturate(),
            };
            sum = sum + share * e.real(height);
        }
        sum.minimum(e.real(1.0))
    }
}

#[cfg(test)]
mod tests {
    use phenomenon_compiler::{number, numbers};

    #[test]
    fn hard_edges_jump_at_multiples() {
        assert_eq!(number!(input = 0.24999999, levels = 4 => result), 0.0);
        assert_eq!(number!(input = 0.25, levels = 4 => result), 0.25);
        assert_eq!(number!(input = 1.0, levels = 4 => result), 1.0);
        assert_eq!(
            numbers!(input = [0.9, 0.1, 0.5, 0.3], levels = 2 => result),
            [0.5, 0.0, 0.5, 0.3]
        );
    }

    #[test]
    fn soft_edges_are_a_ramp() {
        for input in [0.0, 0.125, 0.5, 0.75, 1.0] {
            assert_eq!(number!(input = input, levels = 4, edges = 1 => result), input);
        }
    }
}
