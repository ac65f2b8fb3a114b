use crate::emit::Real;
use crate::emit::functions::passage::cut;
use crate::nodes::finite::{FACTOR, UNIT};

node! {
    /// What lies inside a mask: `input mask`, alpha too. Where the mask is 0 the input is not
    /// evaluated.
    inside in compositing generic,
    source "MaterialX 1.39, inside",
    inputs {
        /// The mask.
        mask: scalar = 1.0, in FACTOR, soft UNIT;
        /// What is cut.
        input: generic = 0.0, in FACTOR, when i.mask.not_equal(e.real(0.0));
    }
    outputs {
        /// What is left.
        result: generic;
    }
    body |e, i| {
        let shows = i.mask.not_equal(e.real(0.0));
        Outputs { result: cut(i.input, i.mask, shows) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn alpha_is_cut_too() {
        for mask in [0.0_f32, 0.25, 1.0] {
            let color = [1.0, 2.0, 4.0, 0.5];
            let cut = numbers!(input = color, mask = mask => result);
            assert_eq!(cut, color.map(|x| x * (mask)));
            assert_eq!(number!(input = 3.0, mask = mask => result), 3.0 * (mask));
        }
    }

    #[test]
    fn what_is_cut_away_is_not_evaluated() {
        assert!(!demanded!(mask = 0.0 => input) && demanded!(mask = 0.5 => input));
    }
}
