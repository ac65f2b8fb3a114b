use crate::nodes::{NOT_NEGATIVE, required};

node! {
    /// How densely the environment light of the scene draws a direction: what `density` of `light` would be, were that direction
    /// its sample. 0 where the scene has no such light. A ray that leaves the scene in a direction found otherwise sees what
    /// the light shows there too; `power_heuristic` shares it between both.
    light_density in rays request LightDensity,
    source "Veach 1997, Robust Monte Carlo Methods for Light Transport Simulation, 9.2",
    inputs {
        /// The direction, unit length.
        direction: vector = required();
    }
    outputs {
        /// Samples per steradian.
        density: scalar, in NOT_NEGATIVE;
    }
}
