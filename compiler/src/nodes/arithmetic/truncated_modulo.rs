use crate::emit::functions::conventions::modulo_or_zero;
use crate::emit::{Mask, Real};

node! {
    /// Remainder `a - b truncate(a / b)`, per component: it has the sign of `a`, as `fmod` of
    /// C, OSL and HLSL and Blender's Modulo have it; `modulo` has that of `b`. A remainder by
    /// zero is 0. A colour keeps the alpha of `a`.
    truncated_modulo in arithmetic per component,
    source "",
    inputs {
        /// What is divided.
        a: generic = 0.0;
        /// The period.
        b: generic = 1.0, avoid zero;
    }
    outputs {
        /// The remainder.
        result: generic;
    }
    body |e, i| {
        let rest = modulo_or_zero(i.a.absolute(), i.b.absolute());
        i.a.less(e.real(0.0)).select(-rest, rest)
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn has_the_sign_of_what_is_divided() {
        for (a, b, rest) in [(-5.5, 2.0, -1.5), (5.5, -2.0, 1.5), (5.5, 2.0, 1.5), (1.0, 0.0, 0.0)]
        {
            assert_eq!(number!(a = a, b = b => result), rest);
            assert!(b == 0.0 || rest == a % b);
        }
    }
}
