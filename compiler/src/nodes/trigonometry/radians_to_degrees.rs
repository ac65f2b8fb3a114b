use crate::nodes::finite::FACTOR;

node! {
    /// Angle in degrees of one in radians, per component: `input 180 / pi`. A colour keeps its
    /// alpha.
    radians_to_degrees in trigonometry per component,
    source "",
    inputs {
        /// The angle.
        input: generic = 0.0, in FACTOR, unit "radians";
    }
    outputs {
        /// The angle in degrees.
        result: generic;
    }
    body |e, i| i.input * (180.0 / std::f64::consts::PI)
}

#[cfg(test)]
mod tests {
    #[test]
    fn pi_is_half_a_turn() {
        assert_eq!(number!(input = std::f32::consts::PI => result), 180.0);
    }
}
