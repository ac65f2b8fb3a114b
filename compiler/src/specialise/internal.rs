//! Bodies the compiler itself puts into graphs.

use std::sync::LazyLock;

use crate::kernels::BodyForms;
use crate::nodes::Definition;

/// The root of a phenomenon: ok is asked first, and the colour only where it holds.
pub mod root {
    use crate::emit::{Color, Mask};
    use crate::node;
    use crate::nodes::BLACK;

    node! {
        /// The root of a phenomenon: ok is asked first, and the colour only where it holds.
        root in internal,
        source "mental ray manual, return values of shaders",
        inputs {
            /// False for miFALSE.
            ok: boolean = true;
            /// The colour.
            color: color = BLACK, when i.ok;
        }
        outputs {
            /// The colour, zero where not ok.
            color: color;
            /// See the input.
            ok: boolean;
        }
        body |e, i| {
            let zero = e.real(0.0);
            let none = Color { r: zero, g: zero, b: zero, a: zero };
            Outputs { color: i.ok.select(i.color, none), ok: i.ok }
        }
    }
}

/// Whether two things hold.
pub mod both {
    use crate::node;

    node! {
        /// Whether two things hold.
        both in internal,
        source "",
        inputs {
            /// One.
            outer: boolean = true;
            /// The other.
            inner: boolean = true;
        }
        outputs {
            /// Whether they do.
            value: boolean;
        }
        body |e, i| Outputs { value: i.outer & i.inner }
    }
}

/// Whether one of two things holds.
pub mod either {
    use crate::node;

    node! {
        /// Whether one of two things holds.
        either in internal,
        source "",
        inputs {
            /// One.
            one: boolean = true;
            /// The other.
            other: boolean = true;
        }
        outputs {
            /// Whether it does.
            value: boolean;
        }
        body |e, i| Outputs { value: i.one | i.other }
    }
}

/// The implicit conversion of an integer to a scalar.
pub mod integer_to_scalar {
    use crate::emit::Int;
    use crate::node;

    node! {
        /// The implicit conversion of an integer to a scalar, ties to even.
        integer_to_scalar in internal,
        source "",
        inputs {
            /// The integer.
            value: integer = 0;
        }
        outputs {
            /// The nearest number.
            value: scalar;
        }
        body |e, i| Outputs { value: i.value.to_real() }
    }
}

/// The definition of [`root`].
pub fn root_definition() -> &'static Definition {
    static DEFINITION: LazyLock<Definition> = LazyLock::new(root::definition);
    &DEFINITION
}

/// The code of [`both`].
pub fn both_code() -> BodyForms {
    static CODE: LazyLock<Option<BodyForms>> =
        LazyLock::new(|| both::definition().overloads[0].code);
    CODE.expect("a plain node has a body")
}

/// The code of [`either`].
pub fn either_code() -> BodyForms {
    static CODE: LazyLock<Option<BodyForms>> =
        LazyLock::new(|| either::definition().overloads[0].code);
    CODE.expect("a plain node has a body")
}

/// The code of [`integer_to_scalar`].
pub fn integer_to_scalar_code() -> BodyForms {
    static CODE: LazyLock<Option<BodyForms>> =
        LazyLock::new(|| integer_to_scalar::definition().overloads[0].code);
    CODE.expect("a plain node has a body")
}
