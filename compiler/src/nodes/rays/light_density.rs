use crate::nodes::{NOT_NEGATIVE, required};

node! {
    /// How densely the environment light of the scene draws a direction: what `density` of `light` would be, were that direction
    /// its sample. 0 where the scene has no such light, in the graph of the environment, which it does not light, and for the
    /// direction zero. A ray that leaves the scene in a direction found otherwise sees what the light shows there too;
    /// `power_heuristic` shares it between both. It knows no list of lights: beside a loop whose `lights` leave the environment
    /// light out, what such a ray sees counts whole, and this share would lose light.
    light_density in rays request LightDensity,
    source "Veach 1997, Robust Monte Carlo Methods for Light Transport Simulation, 9.2",
    inputs {
        /// The direction, of any length but zero.
        direction: vector = required();
    }
    outputs {
        /// Samples per steradian.
        density: scalar, in NOT_NEGATIVE;
    }
}
