use crate::emit::{Components, Emit};

node! {
    /// Sum `a + b`, per component. A colour keeps the alpha of `a`.
    add in arithmetic generic,
    source "",
    inputs {
        /// First summand.
        a: generic = 0.0;
        /// Second summand.
        b: generic = 0.0;
    }
    outputs {
        /// The sum.
        result: generic;
    }
}

#[inline(always)]
fn body<E: Emit, T: Components<E::Real>>(_: E, i: &Inputs<E, T>) -> Outputs<T> {
    Outputs { result: i.a + i.b }
}
