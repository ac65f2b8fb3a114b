use crate::nodes::finite::FACTOR;
use crate::nodes::{Kind, ListForm, required};

node! {
    #[doc = "A number from a number, by a curve through any number of points: a `ramp` of numbers that is \
             smooth if nothing else is said. Monotone, it has no kinks and never goes past a point: where points rise, it \
             rises. It is constant before the first point and past the last; see `ramp` for points out of order."]
    curve in ramps structural [Kind::List(ListForm::Ramp)],
    source "Steffen 1990, A Simple Method for Monotonic Interpolation in One Dimension",
    inputs {
        /// Where to look.
        input: scalar = required(), in FACTOR;
        /// Where the points stand, in order.
        positions: scalar = required(), in FACTOR, list;
        /// The values of the points, one for each position.
        values: scalar = required(), in FACTOR, list;
        /// How it goes from point to point; constant keeps a value until the next point.
        interpolation: choice = 3, of ["linear", "smooth", "constant", "monotone"];
    }
    outputs {
        /// The value there.
        result: scalar;
    }
}
