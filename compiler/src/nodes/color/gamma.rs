use crate::emit::Real;
use crate::emit::functions::shaping::signed_power;

node! {
    /// Gamma correction `input^(1 / gamma)`, per component; negative values are mirrored. Above
    /// 1 it brightens, as the knob of a display does. Blender's Gamma is the power itself:
    /// `safe_power`. A gamma of 0 counts as infinite. A colour keeps its alpha.
    gamma in color per component,
    source "",
    inputs {
        /// What is corrected.
        input: generic = 0.0;
        /// The gamma.
        gamma: generic = 1.0, avoid zero, soft 0.2..=5.0;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| signed_power(i.input, e.real(1.0).divide_or_zero(i.gamma))
}

#[cfg(test)]
mod tests {
    #[test]
    fn brightens_above_one() {
        assert_eq!(number!(input = 0.25, gamma = 2.0 => result), 0.5);
        assert_eq!(number!(input = -0.25, gamma = 2.0 => result), -0.5);
        assert_eq!(number!(input = 4.0, gamma = 2.0 => result), 2.0);
        assert_eq!(number!(input = 0.0, gamma = 0.0 => result), 0.0);
        assert_eq!(number!(input = 0.3, gamma = 0.0 => result), 1.0);
    }
}
