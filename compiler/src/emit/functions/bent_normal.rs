//! Normals that are bent by maps and heights.

use super::conventions::clamp_finite;
use super::frames::any_tangent;
use crate::emit::{Mask, Real, Vector};

/// How far a mirrored ray is kept above the geometric surface: the sine of its angle.
const ABOVE: f64 = 1e-3;

/// Sine of the angle below which two directions of a surface are taken for one.
const APART: f64 = 1e-3;

/// The unit normal next to a bent one in which a mirror throws the ray that comes along `direction` above
/// the geometric surface: below it there is nothing to see, and what was bent so far turns black. The
/// mirrored ray is lifted to the surface; the vector halfway between it and the ray that came is the
/// normal. One that faces away from the ray is first turned to stand across it. What is bent less stays
/// as it is, to the bit; no normal gives the geometric one.
#[inline(always)]
pub fn facing_out<R: Real>(
    bent: Vector<R>,
    direction: Vector<R>,
    normal_geom: Vector<R>,
) -> Vector<R> {
    let zero = bent.x.same(0.0);
    let unit = bent.normalized();
    let away = unit.dot(direction).maximum(zero);
    let facing = unit - direction * away;
    let mirrored = direction - facing * (facing.dot(direction) * 2.0);
    let missing = bent.x.same(ABOVE) - mirrored.dot(normal_geom);
    let lifted = (mirrored + normal_geom * missing).normalized();
    let halfway = (lifted - direction).normalized();
    let fits = missing.less_equal(zero) & away.less_equal(zero);
    let none = unit.largest().equal(zero) | halfway.largest().equal(zero);
    fits.select(unit, none.select(normal_geom, halfway))
}

/// What is above a frame: `tangent x + bitangent y + normal z` of a map whose three numbers are stored as 0 to 1,
/// with x and y scaled. A map of nothing is flat.
#[inline(always)]
pub fn mapped<R: Real>(
    map: Vector<R>,
    strength: R,
    (tangent, bitangent, normal): (Vector<R>, Vector<R>, Vector<R>),
) -> Vector<R> {
    let (zero, one) = (strength.same(0.0), strength.same(1.0));
    let nothing = map.largest().equal(zero);
    let x = nothing.select(zero, map.x.mul_add(one + one, -one) * strength);
    let y = nothing.select(zero, map.y.mul_add(one + one, -one) * strength);
    let z = nothing.select(one, map.z.mul_add(one + one, -one));
    Vector {
        x: tangent.x.mul_add(x, bitangent.x.mul_add(y, normal.x * z)),
        y: tangent.y.mul_add(x, bitangent.y.mul_add(y, normal.y * z)),
        z: tangent.z.mul_add(x, bitangent.z.mul_add(y, normal.z * z)),
    }
}

/// Two unit vectors along a surface, and how far surface coordinates go with a unit of length along each.
#[derive(Clone, Copy, Debug)]
pub struct Along<R: Real> {
    /// The way of u.
    pub across: Vector<R>,
    /// The way of v.
    pub up: Vector<R>,
    /// How far u goes along the first.
    pub du: R,
    /// How far v goes along the second.
    pub dv: R,
}

/// The ways of both coordinates; any two, along which the coordinates stay, where these do not span the surface.
#[inline(always)]
pub fn along_surface<R: Real>(
    derivative_u: Vector<R>,
    derivative_v: Vector<R>,
    normal: Vector<R>,
) -> Along<R> {
    let (zero, one) = (normal.x.same(0.0), normal.x.same(1.0));
    let (across, up) = (derivative_u.normalized(), derivative_v.normalized());
    let spans = across.cross(up).dot(normal).absolute().greater(zero + APART);
    let any = any_tangent(normal);
    let du = clamp_finite(one.divide_or_zero(derivative_u.length()));
    let dv = clamp_finite(one.divide_or_zero(derivative_v.length()));
    Along {
        across: spans.select(across, any),
        up: spans.select(up, normal.cross(any)),
        du: spans.select(du, zero),
        dv: spans.select(dv, zero),
    }
}

/// The normal of a surface that is raised along its normal by heights whose slopes along two unit vectors in
/// it are these; of any length, and zero for no normal (Mikkelsen 2010, equation 4: with `r_u = b × n`, `r_v = n × a` and
/// `d = a · r_u`, it is `|d| n - sign(d) (slope_u r_u + slope_v r_v)`).
#[inline(always)]
pub fn raised<R: Real>(
    [across, up]: [Vector<R>; 2],
    [slope_across, slope_up]: [R; 2],
    normal: Vector<R>,
) -> Vector<R> {
    let (to_across, to_up) = (up.cross(normal), normal.cross(across));
    let determinant = across.dot(to_across);
    let gradient = to_across * slope_across + to_up * slope_up;
    let mirrored = determinant.less(determinant.same(0.0));
    normal * determinant.absolute() - mirrored.select(-gradient, gradient)
}

/// The slope between two heights a step apart, finite; a step of 0 has none.
#[inline(always)]
pub fn slope<R: Real>([here, there]: [R; 2], step: R, scale: R) -> R {
    let slope = ((there - here) * scale).divide_or_zero(step);
    // A billion is straight up: beyond it squares would overflow.
    slope.equal(slope).select(slope, slope.same(0.0)).clamp_to(slope.same(-1e9), slope.same(1e9))
}
