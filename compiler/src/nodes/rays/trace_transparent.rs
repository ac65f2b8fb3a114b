use crate::nodes::NOT_NEGATIVE;

node! {
    /// Follows the ray on behind the point, unbent, and yields what it sees; past the trace depth, or
    /// where it hits nothing, the environment. Counts as a refraction.
    trace_transparent in rays request TraceTransparent,
    source "mental ray manual, mi_trace_transparent",
    inputs {}
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
