use crate::emit::functions::conventions::modulo_or_zero;
use crate::nodes::finite::SUMMAND;

node! {
    /// The value moved into a range by whole lengths of it, per component: `low + modulo(input
    /// - low, high - low)`. An empty range gives `low`. A colour keeps its alpha.
    wrap in ranges per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0, in SUMMAND;
        /// Where the range begins.
        low: scalar = 0.0, in SUMMAND;
        /// Where it ends; never reached.
        high: scalar = 1.0, in SUMMAND;
    }
    outputs {
        /// The value in the range.
        result: generic;
    }
    body |e, i| i.low + modulo_or_zero(i.input - i.low, i.high - i.low)
}

#[cfg(test)]
mod tests {
    #[test]
    fn comes_back_at_the_other_end() {
        for (x, inside) in [(1.0, 1.0), (3.5, 1.5), (0.5, 2.5), (3.0, 1.0), (-5.0, 1.0)] {
            assert_eq!(number!(input = x, low = 1.0, high = 3.0 => result), inside);
        }
        assert_eq!(number!(input = 9.0, low = 2.0, high = 2.0 => result), 2.0);
    }
}
