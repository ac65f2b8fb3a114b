use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// What the environment shows in a direction. No geometry is looked at: `hit` is false.
    trace_environment in rays request TraceEnvironment,
    source "mental ray manual, mi_trace_environment",
    inputs {
        /// Where to look, any length.
        direction: vector = state(Field::Direction);
    }
    outputs {
        /// Colour seen along the ray.
        color: color, in NOT_NEGATIVE;
        /// Whether some shader the ray caused to run returned true.
        ok: boolean;
        /// Whether the ray hit a surface.
        hit: boolean;
        /// Distance to that surface in scene units; 0 where there is none.
        distance: scalar, in NOT_NEGATIVE;
    }
}
