//! Bodies the compiler itself puts into graphs.

use std::sync::LazyLock;

use crate::kernels::BodyForms;
use crate::nodes::Definition;

/// The root of a phenomenon: ok is asked first, and the colour only where it holds.
pub mod root {
    use crate::emit::{Color, Emit, Mask};
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
            color: color = BLACK, when is_ok;
        }
        outputs {
            /// The colour, zero where not ok.
            color: color;
            /// See the input.
            ok: boolean;
        }
    }

    #[inline(always)]
    fn is_ok<E: Emit>(_: E, i: &Inputs<E>) -> E::Mask {
        i.ok
    }

    #[inline(always)]
    fn body<E: Emit>(e: E, i: &Inputs<E>) -> Outputs<E> {
        let zero = e.real(0.0);
        let none = Color { r: zero, g: zero, b: zero, a: zero };
        Outputs { color: i.ok.select(i.color, none), ok: i.ok }
    }
}

/// The implicit conversion of an integer to a scalar.
pub mod integer_to_scalar {
    use crate::emit::{Emit, Int};
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
    }

    #[inline(always)]
    fn body<E: Emit>(_: E, i: &Inputs<E>) -> Outputs<E> {
        Outputs { value: i.value.to_real() }
    }
}

/// The definition of [`root`].
pub fn root_definition() -> &'static Definition {
    static DEFINITION: LazyLock<Definition> = LazyLock::new(root::definition);
    &DEFINITION
}

/// The code of [`integer_to_scalar`].
pub fn integer_to_scalar_code() -> BodyForms {
    static CODE: LazyLock<Option<BodyForms>> =
        LazyLock::new(|| integer_to_scalar::definition().overloads[0].code);
    CODE.expect("a plain node has a body")
}
