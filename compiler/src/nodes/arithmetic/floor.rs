use crate::emit::Real;

node! {
    /// The largest integer not above the value, per component. A colour keeps its alpha.
    floor in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The integer, as a number.
        result: generic;
    }
    body |e, i| i.input.floor()
}

#[cfg(test)]
mod tests {
    #[test]
    fn goes_down() {
        let below_three = 3.0_f32.next_down();
        assert_eq!(numbers!(input = [-0.5, 2.5, below_three] => result), [-1.0, 2.0, 2.0]);
        assert_eq!(number!(input = -0.0 => result).to_bits(), (-0.0_f32).to_bits());
        assert_eq!(number!(input = -1e-45 => result), -1.0);
        assert_eq!(number!(input = 1e30 => result), 1e30);
        assert_eq!(numbers!(input = [-0.5, 2.5, 9.0, 0.5] => result), [-1.0, 2.0, 9.0, 0.5]);
    }
}
