use crate::emit::functions::shaping::passage;
use crate::nodes::finite::{SUMMAND, UNIT};

node! {
    /// Where a value lies between two bounds, as a share clamped to 0..1, per component:
    /// `(input - low) / (high - low)`. Equal bounds make a step: 1 from the bound on. With
    /// `low` above `high` it falls. A colour keeps its alpha.
    linear_step in ranges per component,
    source "",
    inputs {
        /// Where to look.
        input: generic = 0.0, in SUMMAND;
        /// Where it is 0.
        low: generic = 0.0, in SUMMAND;
        /// Where it is 1.
        high: generic = 1.0, in SUMMAND;
    }
    outputs {
        /// The share.
        result: generic, in UNIT;
    }
    body |e, i| passage(i.input, i.low, i.high)
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_a_share() {
        assert_eq!(number!(input = 3.0, low = 2.0, high = 6.0 => result), 0.25);
        assert_eq!(number!(input = 3.0, low = 6.0, high = 2.0 => result), 0.75);
        assert_eq!(number!(input = 9.0, low = 2.0, high = 6.0 => result), 1.0);
        for (x, share) in [(2.0_f32.next_down(), 0.0), (2.0, 1.0)] {
            assert_eq!(number!(input = x, low = 2.0, high = 2.0 => result), share);
        }
    }
}
