//! The node `either`.

use std::ops::Not;

use phenomenon_compiler::emit::Mask;
use phenomenon_compiler::node;

node! {
    /// One of two vectors, or of two colours; the other is not evaluated.
    either in foreign generic [vector, color],
    source "",
    inputs {
        /// Which.
        first: boolean = true;
        /// The first.
        a: generic = 0.0, when i.first;
        /// The second.
        b: generic = 1.0, when i.first.not();
    }
    outputs {
        /// The one.
        result: generic;
    }
    body |e, i| Outputs { result: i.first.select(i.a, i.b) }
}

#[cfg(test)]
mod tests {
    use phenomenon_compiler::values::Type;
    use phenomenon_compiler::{demanded, numbers};

    #[test]
    fn one_is_taken_and_the_other_not_asked() {
        let (a, b) = ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]);
        assert_eq!(numbers!(first = true, a = a, b = b => result), a);
        assert_eq!(numbers!(first = false, a = a, b = b => result), b);
        assert!(demanded!(first = true, a = a => a) && !demanded!(first = true, a = a => b));
    }

    #[test]
    fn there_is_no_form_for_numbers() {
        let forms = super::definition().overloads.into_iter().map(|form| form.generic);
        assert_eq!(forms.collect::<Vec<_>>(), [Some(Type::Vector), Some(Type::Color)]);
    }
}
