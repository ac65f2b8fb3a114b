use crate::emit::{Components, Emit};

node! {
    /// Complement `1 - input`, per component. A colour keeps its alpha.
    one_minus in arithmetic generic,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The complement.
        result: generic;
    }
}

#[inline(always)]
fn body<E: Emit, T: Components<E::Real>>(e: E, i: &Inputs<E, T>) -> Outputs<T> {
    let mut complement = i.input.to_words();
    for component in &mut complement[..3] {
        *component = e.real(1.0) - *component;
    }
    Outputs { result: T::from_words(complement) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn complements_all_but_alpha() {
        assert_eq!(number!(input = 0.25 => result), 0.75);
        assert_eq!(numbers!(input = [0.0, 1.0, 2.0] => result), [1.0, 0.0, -1.0]);
        assert_eq!(numbers!(input = [0.0, 1.0, 2.0, 0.3] => result), [1.0, 0.0, -1.0, 0.3]);
    }
}
