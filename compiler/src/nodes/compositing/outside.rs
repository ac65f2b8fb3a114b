use crate::emit::Real;
use crate::emit::functions::passage::cut;
use crate::nodes::finite::{FACTOR, UNIT};

node! {
    /// What lies outside a mask: `input (1 - mask)`, alpha too. Where the mask is 1 the input
    /// is not evaluated.
    outside in compositing generic,
    source "MaterialX 1.39, outside",
    inputs {
        /// The mask.
        mask: scalar = 0.0, in FACTOR, soft UNIT;
        /// What is cut.
        input: generic = 0.0, in FACTOR, when i.mask.not_equal(e.real(1.0));
    }
    outputs {
        /// What is left.
        result: generic;
    }
    body |e, i| {
        let (one, mask) = (e.real(1.0), i.mask);
        Outputs { result: cut(i.input, one - mask, mask.not_equal(one)) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn alpha_is_cut_too() {
        for mask in [0.0_f32, 0.25, 1.0] {
            let color = [1.0, 2.0, 4.0, 0.5];
            let cut = numbers!(input = color, mask = mask => result);
            assert_eq!(cut, color.map(|x| x * (1.0 - mask)));
            assert_eq!(number!(input = 3.0, mask = mask => result), 3.0 * (1.0 - mask));
        }
    }

    #[test]
    fn what_is_cut_away_is_not_evaluated() {
        assert!(!demanded!(mask = 1.0 => input) && demanded!(mask = 0.5 => input));
    }
}
