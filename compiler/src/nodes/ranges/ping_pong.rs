use crate::emit::Real;
use crate::emit::functions::conventions::modulo_or_zero;
use crate::nodes::NOT_NEGATIVE;
use crate::nodes::finite::SUMMAND;

node! {
    /// Up from 0 to `length` and down again, over and over, per component. A length of 0 gives
    /// 0, and its sign does not matter. A colour keeps its alpha.
    ping_pong in ranges per component,
    source "",
    inputs {
        /// Where to look.
        input: generic = 0.0, in SUMMAND;
        /// How high it goes, and how far it takes.
        length: scalar = 1.0, in SUMMAND, avoid zero;
    }
    outputs {
        /// The height.
        result: generic, in NOT_NEGATIVE;
    }
    body |e, i| {
        let length = i.length.absolute();
        let rest = modulo_or_zero(i.input, length * 2.0);
        rest.minimum(length * 2.0 - rest)
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn goes_up_and_down() {
        for (x, height) in
            [(0.0, 0.0), (1.5, 1.5), (2.0, 2.0), (2.5, 1.5), (4.0, 0.0), (-0.5, 0.5), (9.0, 1.0)]
        {
            assert_eq!(number!(input = x, length = 2.0 => result), height);
            assert_eq!(number!(input = x, length = -2.0 => result), height);
            assert_eq!(number!(input = x, length = 0.0 => result), 0.0);
        }
    }
}
