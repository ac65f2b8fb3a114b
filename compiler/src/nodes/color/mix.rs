use crate::emit::Real;
use crate::emit::functions::passage::mixed;
use crate::nodes::finite::SUMMAND;

node! {
    /// Linear mix `a (1 - weight) + b weight`, per component and, for colours, alpha. At weight 0 `b`
    /// is not evaluated, at weight 1 `a` is not, and the other passes unchanged to the bit.
    mix in color generic,
    source "mental ray base shaders, mib_color_mix",
    inputs {
        /// Share of `b`; outside 0..1 it extrapolates.
        weight: scalar = 0.5, in 0.0..=1.0;
        /// Value at weight 0.
        a: generic = 0.0, in SUMMAND, when i.weight.not_equal(e.real(1.0));
        /// Value at weight 1.
        b: generic = 1.0, in SUMMAND, when i.weight.not_equal(e.real(0.0));
    }
    outputs {
        /// The mixture.
        result: generic;
    }
    body |e, i| Outputs { result: mixed(i.a, i.b, i.weight) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn mixes_colours_with_their_alpha() {
        let mixed =
            numbers!(weight = 0.25, a = [0.0, 4.0, -8.0, 1.0], b = [4.0, 0.0, 8.0, 0.0] => result);
        assert_eq!(mixed, [1.0, 3.0, -4.0, 0.75]);
        assert_eq!(number!(weight = 0.5, a = 1.0, b = 3.0 => result), 2.0);
        assert_eq!(
            numbers!(weight = 2.0, a = [0.0; 3], b = [1.0, 2.0, 3.0] => result),
            [2.0, 4.0, 6.0]
        );
    }

    #[test]
    fn the_ends_pass_to_the_bit_and_hide_the_other_side() {
        let (a, b) = ([-0.0, 1e-45, 0.1, 0.3], [f32::NAN, f32::INFINITY, -0.0, f32::NAN]);
        for weight in [0.0, -0.0] {
            let mixed = numbers!(weight = weight, a = a, b = b => result);
            assert_eq!(mixed.iter().map(|x| x.to_bits()).collect::<Vec<_>>(), a.map(f32::to_bits));
        }
        assert_eq!(numbers!(weight = 1.0, a = b, b = a => result), a);
    }

    #[test]
    fn a_side_without_weight_is_not_demanded() {
        for (weight, a, b) in [
            (0.0, true, false),
            (-0.0, true, false),
            (1.0, false, true),
            (1.0_f32.next_down(), true, true),
            (1e-45, true, true),
            (f32::NAN, true, true),
        ] {
            assert_eq!(demanded!(weight = weight => a), a, "{weight}");
            assert_eq!(demanded!(weight = weight => b), b, "{weight}");
        }
    }
}
