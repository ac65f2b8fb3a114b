use crate::nodes::{NOT_NEGATIVE, required};

node! {
    /// Traces a refraction ray from the point and yields what it sees; past the trace depth, or
    /// where it hits nothing, the environment. Under total internal reflection the direction of
    /// `refraction_direction` points back inside, and the ray still counts as refracted.
    trace_refraction in rays request TraceRefraction,
    source "mental ray manual, mi_trace_refraction",
    inputs {
        /// Direction of the ray, any length.
        direction: vector = required();
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
