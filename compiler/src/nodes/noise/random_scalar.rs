use crate::emit::Real;
use crate::emit::functions::cells::share_of;
use crate::nodes::finite::SUMMAND;

node! {
    /// A random number between `low` and `high` for a number, the same at every look: of a brick, a flake,
    /// an object. MaterialX's `randomfloat` has the same values.
    ///
    /// Numbers are told apart in steps of 1/4096, whole numbers up to 2^19 too: those of one step have one
    /// random number.
    random_scalar in noise,
    source "Jenkins 2006, lookup3; MaterialX 1.39, randomfloat",
    inputs {
        /// What the random number is of.
        input: scalar = 0.0;
        /// The least.
        low: scalar = 0.0, in SUMMAND;
        /// The most.
        high: scalar = 1.0, in SUMMAND;
        /// Another seed gives other numbers.
        seed: integer = 0;
    }
    outputs {
        /// The random number.
        result: scalar;
    }
    body |e, i| {
        let random = share_of(i.input, i.seed);
        let (low, high) = (i.low, i.high);
        let result = random.mul_add(high, (e.real(1.0) - random) * low);
        Outputs { result: result.clamp_to(low, high) }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn values_of_materialx() {
        let of = |input: f32, low: f32, high: f32, seed: i32| numbers!(input = input, low = low, high = high, seed = seed => result);
        assert_close(&of(3.0 / 4096.0, 1.11422, 1.40902, 2), &[1.35781741], 1e-6, 0.0);
        // Ends the wrong way round give the second.
        assert_eq!(of(-2.62677, -2.13067, -2.45419, 1), [-2.45419]);
    }

    #[test]
    fn numbers_differ_by_input_and_seed_and_stay_within() {
        let of = |input: f32, seed: i32| number!(input = input, low = 2.0, high = 3.0, seed = seed => result);
        assert!(of(1.0, 0) != of(2.0, 0) && of(1.0, 0) != of(1.0, 1));
        for input in [-0.0, 1e-45, f32::MAX, f32::MIN, f32::NAN, f32::INFINITY] {
            assert!((2.0..=3.0).contains(&of(input, i32::MIN)), "{input}");
        }
    }
}
