use crate::emit::Real;
use crate::emit::functions::conventions::clamp_finite;
use crate::nodes::NOT_NEGATIVE;

node! {
    /// `2^input`, per component; the largest number where it overflows. A colour keeps its
    /// alpha.
    power_of_two in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The power.
        result: generic, in NOT_NEGATIVE;
    }
    body |e, i| clamp_finite(i.input.exp2())
}

#[cfg(test)]
mod tests {
    #[test]
    fn whole_powers_are_exact() {
        for (x, power) in [(0.0, 1.0), (10.0, 1024.0), (-2.0, 0.25), (1e9, f32::MAX), (-1e9, 0.0)] {
            assert_eq!(number!(input = x => result), power);
        }
    }
}
