//! Vectors between single and double precision.

use glam::DVec3;

/// A vector in double precision.
#[inline(always)]
pub fn double(v: [f32; 3]) -> DVec3 {
    DVec3::new(v[0].into(), v[1].into(), v[2].into())
}

/// A vector rounded to single precision.
#[inline(always)]
pub fn single(v: DVec3) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}

/// The vector made unit; none if it is zero or not finite.
pub(super) fn unit(v: DVec3) -> Option<DVec3> {
    let length = v.length();
    (length > 0.0 && length.is_finite()).then(|| v / length)
}
