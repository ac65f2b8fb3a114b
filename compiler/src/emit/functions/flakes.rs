//! Flakes scattered in space: squares of random tilt, one at most in each cell of the lattice of whole
//! numbers.
//!
//! Source: MaterialX 1.39, whose flakes these are; the tilt of the squares by Arvo 1992.

use super::cells::{cell_share, numbered_share};
use super::conventions::sqrt_or_zero;
use super::frames::any_tangent;
use super::gradient_noise::cell_of;
use super::hash::{hash, share};
use crate::emit::{Emit, Int, Mask, Real, Vector};

/// Half of a flake's edge, of the edge of its cell.
const REACH: f64 = 1.5 / 1.732_050_807_568_877_2;

/// The flake on top.
pub struct Flake<I: Int> {
    /// How far above the others, 0 where there is none.
    pub presence: I::Real,
    /// The cell it belongs to.
    pub cell: [I; 3],
}

/// How often a cell has a flake, for a share of the surface to be covered: a rational function that
/// MaterialX fits to what its flakes cover.
#[inline(always)]
fn frequency<R: Real>(coverage: R) -> R {
    let x = coverage.saturate();
    let above = (x * -26.197_718 + 26.396_639) * x;
    let below = ((x * 85.538_57 - 102.350_694) * x - 101.426_348) * x + 118.450_823;
    above / below
}

/// The topmost flake at a place, of those in its cell and the cells beside it.
#[inline(always)]
pub fn flake_at<E: Emit>(e: E, at: [E::Real; 3], coverage: E::Real) -> Flake<E::Int> {
    let often = frequency(coverage);
    let (mut base, mut near) = ([e.int(0); 3], at);
    for axis in 0..3 {
        (base[axis], near[axis]) = cell_of(at[axis]);
    }
    let (mut presence, mut cell) = (e.real(0.0), base);
    for number in 0..27 {
        let steps = [number / 9 - 1, number / 3 % 3 - 1, number % 3 - 1];
        let (mut beside, mut from) = (base, near);
        for axis in 0..3 {
            beside[axis] = base[axis] + e.int(steps[axis]);
            from[axis] = near[axis] - e.real(f64::from(steps[axis]) + 0.5);
        }
        let there = cell_share(beside).less_equal(often);
        let priority = numbered_share(beside, 3);
        let covers = in_square(beside, from);
        let on_top = there & priority.greater_equal(presence) & covers;
        presence = on_top.select(priority, presence);
        for axis in 0..3 {
            cell[axis] = on_top.select(beside[axis], cell[axis]);
        }
    }
    Flake { presence, cell }
}

/// Whether the cube that a cell's random rotation turns contains a place, given from its middle.
#[inline(always)]
fn in_square<I: Int>(cell: [I; 3], from: [I::Real; 3]) -> I::Mask {
    let turn = numbered_share(cell, 0) * std::f64::consts::TAU;
    let round = numbered_share(cell, 1) * std::f64::consts::TAU;
    let up = numbered_share(cell, 2) * 2.0;
    let out = sqrt_or_zero(up);
    let (x, y) = (round.sin() * out, round.cos() * out);
    let z = sqrt_or_zero(up.same(2.0) - up);
    let (sine, cosine) = (turn.sin(), turn.cos());
    let (along, across) = (x * cosine - y * sine, x * sine + y * cosine);
    // The rows of a rotation about z and a reflection at (x, y, z).
    let first = [x * along - cosine, y * along + sine, z * along];
    let second = [x * across - sine, y * across - cosine, z * across];
    let third = [x * z, y * z, up.same(1.0) - up];
    within(first, from) & within(second, from) & within(third, from)
}

/// Whether a place lies between two sides.
#[inline(always)]
fn within<R: Real>(axis: [R; 3], from: [R; 3]) -> R::Mask {
    let along = axis[0] * from[0] + axis[1] * from[1] + axis[2] * from[2];
    along.absolute().less_equal(along.same(REACH))
}

/// Tangent, bitangent and normal; where tangent and bitangent are zero, two that stand on the normal.
#[inline(always)]
pub fn completed<R: Real>(
    normal: Vector<R>,
    tangent: Vector<R>,
    bitangent: Vector<R>,
) -> [Vector<R>; 3] {
    let zero = normal.x.same(0.0);
    let first = any_tangent(normal);
    let given = tangent.largest().greater(zero) | bitangent.largest().greater(zero);
    [given.select(tangent, first), given.select(bitangent, normal.cross(first)), normal]
}

/// A flake's random number and normal.
pub struct Tilted<R> {
    /// The random number, 0..1.
    pub random: R,
    /// Of unit length.
    pub normal: Vector<R>,
}

/// The tilt of a cell's flake: of a GGX facet, in a frame of tangent, bitangent and normal.
#[inline(always)]
pub fn tilted<I: Int>(
    [x, y, z]: [I; 3],
    roughness: I::Real,
    frame: [Vector<I::Real>; 3],
) -> Tilted<I::Real> {
    let two = x.same(2);
    let numbered = [
        share(hash(&[x, y, z, two, x.same(0)])),
        share(hash(&[x, y, z, two, x.same(1)])),
        share(hash(&[x, y, z, two, x.same(2)])),
    ];
    let round = numbered[0] * std::f64::consts::TAU;
    let one = round.same(1.0);
    // tan^2 of the tilt is alpha^2 xi / (1 - xi); sine and cosine without the quotient.
    let alpha = roughness * roughness;
    let sine = alpha * sqrt_or_zero(numbered[1]);
    let cosine = sqrt_or_zero(one - numbered[1]);
    let [tangent, bitangent, normal] = frame;
    let (out, across) = (round.cos() * sine, round.sin() * sine);
    let tilted = tangent * out + bitangent * across + normal * cosine;
    Tilted { random: numbered[2], normal: tilted.normalized() }
}
