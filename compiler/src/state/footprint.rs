//! What a pixel covers of a surface.

/// A cone round a ray: what its pixel sees. Two numbers follow a path where the derivatives of a ray, by both
/// directions of the film, would be twelve, and they ask nothing of shaders that bend rays as they like.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cone {
    /// Its width at the point, in scene units.
    pub width: f32,
    /// By how much it widens with each unit of length.
    pub spread: f32,
}

/// The ellipse that the cone of a ray cuts from the surface at a point. Of each axis, the longer one first, what a
/// step across the whole pixel is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Footprint {
    /// How the point moves, in scene units.
    pub point: [[f32; 3]; 2],
    /// How the surface coordinates change.
    pub uv: [[f32; 2]; 2],
}
