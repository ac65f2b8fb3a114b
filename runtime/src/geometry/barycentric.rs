//! Where on a triangle a point lies.

use glam::DVec3;

/// How far from a triangle, in parts of its size, a point may lie to be taken for one of it.
const OFF_TRIANGLE: f64 = 1e-5;

/// The barycentric weights of a point of a triangle; none for other points.
pub(super) fn weights([a, b, c]: [DVec3; 3], point: DVec3) -> Option<[f64; 3]> {
    let normal = (b - a).cross(c - a);
    let squared = normal.length_squared();
    let v = (point - a).cross(c - a).dot(normal) / squared;
    let w = (b - a).cross(point - a).dot(normal) / squared;
    let weights = [1.0 - v - w, v, w];
    let [x, y, z] = weights;
    let off = (a * x + b * y + c * z - point).length();
    let within = weights.iter().all(|weight| *weight >= -OFF_TRIANGLE);
    let size = (b - a).length().max((c - a).length());
    (within && off <= size * OFF_TRIANGLE).then_some(weights)
}
