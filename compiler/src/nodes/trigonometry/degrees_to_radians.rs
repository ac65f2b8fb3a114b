node! {
    /// Angle in radians of one in degrees, per component: `input pi / 180`. A colour keeps its
    /// alpha.
    degrees_to_radians in trigonometry per component,
    source "",
    inputs {
        /// The angle.
        input: generic = 0.0, unit "degrees";
    }
    outputs {
        /// The angle in radians.
        result: generic;
    }
    body |e, i| i.input * (std::f64::consts::PI / 180.0)
}

#[cfg(test)]
mod tests {
    #[test]
    fn half_a_turn_is_pi() {
        assert_eq!(number!(input = 180.0 => result), std::f32::consts::PI);
        assert_eq!(number!(input = -90.0 => result), -std::f32::consts::FRAC_PI_2);
    }
}
