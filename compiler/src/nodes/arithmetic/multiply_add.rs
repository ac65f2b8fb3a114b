use crate::emit::Real;
use crate::nodes::finite::FACTOR;

node! {
    /// `a b + c`, per component, rounded once. A colour keeps the alpha of `a`.
    multiply_add in arithmetic per component,
    source "",
    inputs {
        /// First factor.
        a: generic = 0.0, in FACTOR;
        /// Second factor.
        b: generic = 1.0, in FACTOR;
        /// What is added.
        c: generic = 0.0, in FACTOR;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| i.a.mul_add(i.b, i.c)
}

#[cfg(test)]
mod tests {
    #[test]
    fn rounds_once() {
        assert_eq!(number!(a = 3.0, b = 4.0, c = 5.0 => result), 17.0);
        let x = 1.0_f32.next_up();
        assert!(number!(a = x, b = x, c = -(x * x) => result) > 0.0);
    }
}
