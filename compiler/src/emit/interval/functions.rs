//! Functions of intervals, by where they rise and fall.
//!
//! What is computed lies within two units in the last place of the exact function (`docs/numerics.md`,
//! held by `tests/accuracy.rs`), and has its sign; it need not rise and fall as that does. So bounds found
//! at the ends are moved outward by [`SLACK`] units, but not past zero. Values are not taken to be
//! without gaps: what the checker says to be reached does not rest on functions.

use std::f32::consts::{FRAC_PI_2, PI};
use std::f64::consts;

use super::arithmetic::bounds;
use super::number::Made;
use super::{Interval, derived, tag};
use crate::emit::Real;
use crate::emit::scalar::F32;
use crate::emit::standard::LARGEST_ANGLE;

/// Units in the last place by which computed bounds are moved outward: twice two of the function at the
/// end and between, and as much again where a power of two, at which units halve, lies in the way.
const SLACK: usize = 8;

fn below(x: f32) -> f32 {
    let moved = (0..SLACK).fold(x, |x, _| x.next_down());
    if x >= 0.0 { moved.max(0.0) } else { moved }
}

fn above(x: f32) -> f32 {
    -below(-x)
}

/// What is made from one operand, bounds aside.
fn made(x: Interval, name: u64) -> Made {
    Made { nan: x.nan, smooth: false, reads: x.reads, identity: derived(name, &[x.identity]) }
}

/// A function that rises everywhere.
fn rising(x: Interval, name: u64, each: impl Fn(F32) -> F32) -> Interval {
    if let Some(point) = x.point() {
        return Interval::constant(each(F32(point)).0);
    }
    if x.is_empty() {
        return Interval::nothing(x.reads);
    }
    Interval::made(below(each(F32(x.low)).0), above(each(F32(x.high)).0), made(x, name))
}

/// A function that rises where it is defined, from `low` to `high`, and is NaN elsewhere.
fn rising_within(
    x: Interval,
    (low, high): (f32, f32),
    name: u64,
    each: impl Fn(F32) -> F32,
) -> Interval {
    if x.high < low || x.low > high {
        return Interval::nothing(x.reads);
    }
    rising(defined(x, low, high), name, each)
}

/// The part of it between the bounds, with NaN for the rest.
fn defined(x: Interval, low: f32, high: f32) -> Interval {
    let nan = x.nan || x.low < low || x.high > high;
    let from = if x.low < low { low } else { x.low };
    let to = if x.high > high { high } else { x.high };
    Interval { low: from, high: to, nan, ..x }
}

macro_rules! rising {
    ($($function:ident)+) => {$(
        pub fn $function(x: Interval) -> Interval {
            rising(x, const { tag(stringify!($function)) }, F32::$function)
        }
    )+};
}
rising! { exp exp2 expm1 sinh tanh atan }

macro_rules! rising_within {
    ($($function:ident $low:literal $high:expr;)+) => {$(
        pub fn $function(x: Interval) -> Interval {
            rising_within(x, ($low, $high), const { tag(stringify!($function)) }, F32::$function)
        }
    )+};
}
rising_within! {
    ln 0.0 f32::INFINITY;
    log2 0.0 f32::INFINITY;
    log1p -1.0 f32::INFINITY;
    asin -1.0 1.0;
}

pub fn acos(x: Interval) -> Interval {
    if let Some(point) = x.point() {
        return Interval::constant(F32(point).acos().0);
    }
    if x.is_empty() || x.high < -1.0 || x.low > 1.0 {
        return Interval::nothing(x.reads);
    }
    let x = defined(x, -1.0, 1.0);
    let (low, high) = (F32(x.high).acos().0, F32(x.low).acos().0);
    Interval::made(below(low), above(high), made(x, const { tag("acos") }))
}

pub fn cosh(x: Interval) -> Interval {
    rising(x.absolute(), const { tag("cosh") }, F32::cosh)
}

pub fn sin(x: Interval) -> Interval {
    wave(x, const { tag("sin") }, consts::FRAC_PI_2, F32::sin)
}

pub fn cos(x: Interval) -> Interval {
    wave(x, const { tag("cos") }, 0.0, F32::cos)
}

/// Whether one of the numbers `at + k period` lies in it, or so near that it may.
fn meets(x: Interval, at: f64, period: f64) -> bool {
    // Far more than angles up to the largest are rounded by here.
    const NEAR: f64 = 1e-6;
    let (low, high) = (f64::from(x.low) - NEAR, f64::from(x.high) + NEAR);
    at + ((low - at) / period).ceil() * period <= high
}

/// Whether it reaches where an angle counts as 0.
fn is_beyond(x: Interval) -> bool {
    f64::from(x.low) < -LARGEST_ANGLE || f64::from(x.high) > LARGEST_ANGLE
}

/// A sine with a peak at this angle.
fn wave(x: Interval, name: u64, peak: f64, each: impl Fn(F32) -> F32) -> Interval {
    if let Some(point) = x.point() {
        return Interval::constant(each(F32(point)).0);
    }
    if x.is_empty() {
        return Interval::nothing(x.reads);
    }
    let beyond = is_beyond(x);
    let (a, b) = (each(F32(x.low)).0, each(F32(x.high)).0);
    let low = match beyond || meets(x, peak + consts::PI, consts::TAU) {
        true => -1.0,
        false => below(a.min(b)).max(-1.0),
    };
    let high = match beyond || meets(x, peak, consts::TAU) {
        true => 1.0,
        false => above(a.max(b)).min(1.0),
    };
    Interval::made(low, high, made(x, name))
}

pub fn tan(x: Interval) -> Interval {
    let name = const { tag("tan") };
    if x.point().is_none()
        && !x.is_empty()
        && (is_beyond(x) || meets(x, consts::FRAC_PI_2, consts::PI))
    {
        return Interval::made(f32::NEG_INFINITY, f32::INFINITY, made(x, name));
    }
    rising(x, name, F32::tan)
}

/// The least and the greatest at the corners of a box, with slack.
fn corners(a: Interval, b: Interval, each: impl Fn(F32, F32) -> F32) -> (f32, f32) {
    let (low, high) = bounds(a, b, |a, b| [each(F32(a), F32(b)).0; 2]);
    (below(low), above(high))
}

pub fn atan2(y: Interval, x: Interval) -> Interval {
    if let (Some(y), Some(x)) = (y.point(), x.point()) {
        return Interval::constant(F32(y).atan2(F32(x)).0);
    }
    let made = Made { smooth: false, ..y.with(const { tag("atan2") }, x) };
    if y.is_empty() || x.is_empty() {
        return Interval::nothing(made.reads);
    }
    // In a half plane that does not touch the cut it rises or falls along each axis.
    let (low, high) = if x.low > 0.0 || y.low > 0.0 || y.high < 0.0 {
        corners(y, x, |y, x| y.atan2(x))
    } else {
        (-PI, PI)
    };
    let (low, high) = (low.max(-PI), high.min(PI));
    match x.low > 0.0 {
        true => Interval::made(low.max(-FRAC_PI_2), high.min(FRAC_PI_2), made),
        false => Interval::made(low, high, made),
    }
}

pub fn pow(x: Interval, y: Interval) -> Interval {
    if let (Some(x), Some(y)) = (x.point(), y.point()) {
        return Interval::constant(F32(x).pow(F32(y)).0);
    }
    let mut made = Made { smooth: false, ..x.with(const { tag("pow") }, y) };
    // NaN to the power 0, and 1 to the power NaN, are 1.
    let one = x.nan && y.has_zero() || y.nan && x.low <= 1.0 && x.high >= 1.0;
    if x.is_empty() || y.is_empty() {
        return match one {
            true => Interval::made(1.0, 1.0, Made { nan: true, ..made }),
            false => Interval::nothing(made.reads),
        };
    }
    let (mut low, mut high) = corners(x.absolute(), y, |x, y| x.pow(y));
    if x.low < 0.0 {
        let whole = y.point().filter(|y| y.floor() == *y);
        let even = whole.is_some_and(|y| (y / 2.0).floor() == y / 2.0);
        low = if even { low } else { -high };
        made.nan |= whole.is_none();
    } else if x.low == 0.0 && y.low < 0.0 {
        // Of -0.
        low = f32::NEG_INFINITY;
    }
    if one {
        (low, high) = (low.min(1.0), high.max(1.0));
    }
    Interval::made(low, high, made)
}
