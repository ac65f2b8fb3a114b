use crate::nodes::finite::FACTOR;
use crate::nodes::{Kind, ListForm, required};

node! {
    #[doc = "A value by position along any number of stops: numbers, vectors or colours, alpha too. Before \
             the first stop its value, past the last one the last; between two by `interpolation`, as \
             `ramp_segment` has it. Only the two values that show are evaluated (four, if it is monotone), \
             and a value at its stop passes unchanged.\n\nStops may be parameters, or be computed. One \
             that stands before an earlier one counts as standing at that one's position; where several stand at one \
             position there is a step, and at the position itself the last of them counts. For a NaN it is the last value."]
    ramp in ramps structural [Kind::List(ListForm::Ramp)],
    source "Steffen 1990, A Simple Method for Monotonic Interpolation in One Dimension, for monotone",
    inputs {
        /// Where to look.
        input: scalar = required(), in FACTOR;
        /// Where the values stand, in order.
        positions: scalar = required(), in FACTOR, list;
        /// The values, all of one type, one for each position.
        values: generic = required(), in FACTOR, list;
        /// How it goes from stop to stop; constant keeps a value until the next stop.
        interpolation: choice = 0, of ["linear", "smooth", "constant", "monotone"];
    }
    outputs {
        /// The value there.
        result: generic;
    }
}
