use crate::emit::functions::cos;
use crate::emit::{Components, Emit};

node! {
    /// Cosine of an angle in radians, per component. A colour keeps its alpha.
    cosine in arithmetic generic,
    source "",
    inputs {
        /// The angle in radians.
        input: generic = 0.0;
    }
    outputs {
        /// The value.
        result: generic, in -1.0..=1.0;
    }
}

#[inline(always)]
fn body<E: Emit, T: Components<E::Real>>(_: E, i: &Inputs<E, T>) -> Outputs<T> {
    let mut words = i.input.to_words();
    for component in &mut words[..3] {
        *component = cos(*component);
    }
    Outputs { result: T::from_words(words) }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn known_values() {
        for input in [0.5_f32, -0.5, 1.0, 3.0, 100.0, -1e3, 1e-20] {
            let exact = f64::from(input).cos();
            assert_close(&numbers!(input = input => result), &[exact], 3e-7, 0.0);
        }
        assert_eq!(number!(input = 0.0 => result), 1.0);
    }

    #[test]
    fn huge_angles_stay_on_the_circle() {
        for input in [1e6, 1e10, -1e30, f32::MAX, f32::MIN] {
            let value = number!(input = input => result);
            assert!((-1.0..=1.0).contains(&value), "{input}: {value}");
        }
    }

    #[test]
    fn a_colour_keeps_its_alpha() {
        let color = numbers!(input = [0.0, 1.0, 2.0, 0.25] => result);
        let exact = [0.0_f64, 1.0, 2.0].map(f64::cos);
        assert_close(&color, &[exact[0], exact[1], exact[2], 0.25], 3e-7, 0.0);
    }
}
