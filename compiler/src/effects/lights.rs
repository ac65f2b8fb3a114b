//! Lights as loops see them.

/// A list of lights, resolved by the renderer from the names in a graph; known to that renderer only.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct LightList(pub u32);

/// One of the lights or light samples a loop runs over.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LightSample {
    /// Unit direction from the point towards the light.
    pub direction: [f32; 3],
    /// Distance to it; 0 for a light at infinity.
    pub distance: f32,
    /// Whether the point can be lit by it at all (within its cone, not at its centre …).
    pub reachable: bool,
    /// Which sample it is, in the renderer's own words: what comes back where its colour is asked
    /// for, so that a sampled light is the same point both times.
    pub token: u64,
}
