//! Random numbers of the cells of a lattice, and points scattered over it, one in each.

use super::gradient_noise::cell_of;
use super::hash::{hash, share};
use crate::emit::{Emit, Int, Mask, Real};

/// The random number of a cell, 0..1.
#[inline(always)]
pub fn cell_share<I: Int, const D: usize>(cell: [I; D]) -> I::Real {
    share(hash(&cell))
}

/// Another random number of a cell, 0..1, one for each `number`.
#[inline(always)]
pub fn numbered_share<I: Int, const D: usize>(cell: [I; D], number: i32) -> I::Real {
    let mut numbers = [cell[0].same(number); 5];
    let mut axis = 0;
    while axis < D {
        numbers[axis] = cell[axis];
        axis += 1;
    }
    share(hash(&numbers[..=D]))
}

/// A random number for a number and a seed, 0..1: numbers are told apart in steps of 1/4096, as
/// MaterialX's `randomfloat` does.
#[inline(always)]
pub fn share_of<R: Real>(number: R, seed: R::Int) -> R {
    cell_share([(number * 4096.0).floor().to_int(), seed])
}

/// How far a point is, by number.
pub mod metric {
    /// The length of the straight line.
    pub const EUCLIDEAN: i32 = 0;
    /// The sum of the steps along the axes.
    pub const MANHATTAN: i32 = 1;
}

/// The points scattered next to a place.
pub struct Scattered<I: Int, const D: usize> {
    /// Distances of the nearest three.
    pub distances: [I::Real; 3],
    /// Where the nearest is.
    pub point: [I::Real; D],
    /// The cell the nearest lies in.
    pub cell: [I; D],
}

/// The nearest of the points in the cell of a place and those beside it, each from the middle of its
/// cell by up to half of `jitter`.
///
/// What is kept of the nearest are its cell and its place in the cell, both exact, so that the whole
/// region has one point and one number, however far from the origin.
#[inline(always)]
pub fn scattered<E: Emit, const D: usize>(
    e: E,
    at: [E::Real; D],
    jitter: E::Real,
    measured: i32,
) -> Scattered<E::Int, D> {
    let (mut base, mut near) = ([e.int(0); D], at);
    for axis in 0..D {
        (base[axis], near[axis]) = cell_of(at[axis]);
    }
    let [mut first, mut second, mut third] = [e.real(1e6); 3];
    let (mut cell, mut place) = (base, near);
    for number in 0..3_i32.pow(D as u32) {
        let (mut beside, mut within) = (base, near);
        let mut distance = e.real(0.0);
        for axis in 0..D {
            // The last coordinate changes fastest.
            let step = number / 3_i32.pow((D - 1 - axis) as u32) % 3 - 1;
            beside[axis] = base[axis] + e.int(step);
        }
        for axis in 0..D {
            let step = number / 3_i32.pow((D - 1 - axis) as u32) % 3 - 1;
            let random = numbered_share(beside, axis as i32);
            within[axis] = (random - 0.5) * jitter + 0.5;
            let apart = e.real(f64::from(step)) + within[axis] - near[axis];
            distance = match measured {
                metric::EUCLIDEAN => apart.mul_add(apart, distance),
                metric::MANHATTAN => distance + apart.absolute(),
                _ => distance.maximum(apart.absolute()),
            };
        }
        let nearest = distance.less(first);
        third = distance.less(second).select(second, distance.minimum(third));
        second = nearest.select(first, distance.minimum(second));
        first = nearest.select(distance, first);
        for axis in 0..D {
            cell[axis] = nearest.select(beside[axis], cell[axis]);
            place[axis] = nearest.select(within[axis], place[axis]);
        }
    }
    if measured == metric::EUCLIDEAN {
        [first, second, third] = [first.sqrt(), second.sqrt(), third.sqrt()];
    }
    let mut point = place;
    for axis in 0..D {
        point[axis] = cell[axis].to_real() + place[axis];
        // A jitter above 1 moves points into other cells.
        cell[axis] = cell[axis] + place[axis].floor().to_int();
    }
    Scattered { distances: [first, second, third], point, cell }
}
