use crate::emit::Real;
use crate::emit::functions::conventions::clamp_finite;

node! {
    /// Light by stops of a camera: `input 2^stops`, per component; what overflows is the
    /// largest number. A colour keeps its alpha.
    exposure in color per component,
    source "",
    inputs {
        /// What is exposed.
        input: generic = 0.0;
        /// Stops: one more is twice the light.
        stops: scalar = 0.0, unit "stops", soft -5.0..=5.0;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| clamp_finite(i.input * i.stops.exp2())
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_stop_is_twice_the_light() {
        assert_eq!(number!(input = 0.25, stops = 3.0 => result), 2.0);
        assert_eq!(number!(input = -1.0, stops = -1.0 => result), -0.5);
        assert_eq!(number!(input = 0.0, stops = 1e9 => result), 0.0);
        assert_eq!(number!(input = -1.0, stops = 1e9 => result), f32::MIN);
    }
}
