//! Rays a shader asks for, and what comes back.

/// How a ray is followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Trace {
    /// Mirrored, from the point.
    Reflection,
    /// Bent, from the point.
    Refraction,
    /// On along the ray that came, unbent.
    Transparent,
    /// To the environment, without geometry.
    Environment,
    /// To the nearest surface, calling no shader.
    Probe,
}

impl Trace {
    /// Every kind.
    pub const ALL: [Trace; 5] = [
        Trace::Reflection,
        Trace::Refraction,
        Trace::Transparent,
        Trace::Environment,
        Trace::Probe,
    ];
}

/// A ray a shader asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Number of the state of the point that asks, among those handed over with it; it has the changes
    /// of the scopes round the request.
    pub point: u32,
    /// Where it starts: the point, or for a probe the given origin.
    pub origin: [f32; 3],
    /// Its direction, of any length (the renderer normalises it; zero misses everything).
    pub direction: [f32; 3],
    /// Key of the random numbers below it: a hash of the asking node's path of names and of the
    /// iterations round it.
    pub site: u64,
}

/// What came back from a ray.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Answer {
    /// Colour r, g, b, a; zero for a probe.
    pub color: [f32; 4],
    /// Whether some shader the ray caused to run returned true.
    pub ok: bool,
    /// Whether it hit a surface.
    pub hit: bool,
    /// Distance to that surface; 0 where it hit nothing.
    pub distance: f32,
}
