use crate::emit::functions::shaping::soft_minimum;
use crate::nodes::finite::SUMMAND;

node! {
    /// Larger of two values with a rounded corner, per component: where they are nearer than
    /// `distance`, it lies `distance h^3 / 6` above, h being the share of the distance that is
    /// missing. A distance of 0 is `maximum`. A colour keeps the alpha of `a`.
    smooth_maximum in arithmetic per component,
    source "Quilez 2013, Smooth minimum, the cubic one",
    inputs {
        /// First value.
        a: generic = 0.0, in SUMMAND;
        /// Second value.
        b: generic = 0.0, in SUMMAND;
        /// How near they are where the corner begins.
        distance: scalar = 0.1, in 0.0..=1e37;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| -soft_minimum(-i.a, -i.b, i.distance)
}

#[cfg(test)]
mod tests {
    #[test]
    fn rounds_the_corner_by_a_sixth() {
        assert_eq!(number!(a = 1.0, b = 1.0, distance = 0.6 => result), 1.0 + 0.1);
        assert_eq!(number!(a = 1.0, b = 2.0, distance = 0.5 => result), 2.0);
        assert_eq!(number!(a = -1.0, b = 2.0, distance = 0.0 => result), 2.0);
    }
}
