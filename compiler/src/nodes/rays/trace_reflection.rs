use crate::nodes::{NOT_NEGATIVE, node};

node! {
    /// Traces a reflection ray from the point and yields what it sees; past the trace depth, or
    /// where it hits nothing, the environment.
    trace_reflection in rays request TraceReflection,
    source "mental ray manual, mi_trace_reflection",
    inputs {
        /// Direction of the ray, any length.
        direction: vector = node("reflection_direction");
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
