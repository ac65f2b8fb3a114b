use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// The nearest surface along a ray; no shader is called. The way to measure thickness: along the
    /// direction of the state, from the point, the distance is that through the object.
    trace_probe in rays request TraceProbe,
    source "mental ray manual, mi_trace_probe",
    inputs {
        /// Direction of the ray, any length.
        direction: vector = state(Field::Direction);
        /// Where it starts.
        origin: vector = state(Field::Point);
    }
    outputs {
        /// Always zero: nothing is shaded.
        color: color, in NOT_NEGATIVE;
        /// Whether some shader the ray caused to run returned true.
        ok: boolean;
        /// Whether the ray hit a surface.
        hit: boolean;
        /// Distance to that surface in scene units; 0 where there is none.
        distance: scalar, in NOT_NEGATIVE;
    }
}
