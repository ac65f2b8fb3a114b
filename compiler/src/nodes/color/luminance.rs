use crate::emit::functions::colors::luminance;
use crate::nodes::BLACK;
use crate::nodes::finite::SUMMAND;

node! {
    /// Relative luminance of a scene-linear Rec. 709 colour: `0.2126 r + 0.7152 g + 0.0722 b`.
    luminance in color,
    source "ITU-R BT.709",
    inputs {
        /// The colour.
        color: color = BLACK, in SUMMAND;
    }
    outputs {
        /// Its luminance.
        result: scalar;
    }
    body |e, i| Outputs { result: luminance(i.color) }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn weighs_the_primaries() {
        assert_close(&numbers!(color = [1.0, 0.0, 0.0, 1.0] => result), &[0.2126], 1e-7, 0.0);
        assert_close(&numbers!(color = [0.0, 1.0, 0.0, 1.0] => result), &[0.7152], 1e-7, 0.0);
        assert_close(&numbers!(color = [0.0, 0.0, 1.0, 0.0] => result), &[0.0722], 1e-7, 0.0);
        assert_close(&numbers!(color = [2.0, 2.0, 2.0, 0.0] => result), &[2.0], 2e-7, 0.0);
        assert_eq!(number!(color = [0.0, 0.0, 0.0, 1.0] => result), 0.0);
    }
}
