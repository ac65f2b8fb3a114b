//! The standard tier: transcendental functions expanded to operations of [`Real`](super::Real) and to
//! bits, the same for every 32-bit back end.
//!
//! They follow IEEE 754 where their argument has no result: NaN, or an infinity. Those of
//! [`conventions`](super::functions::conventions) take any number and give a finite one.
//! `docs/numerics.md` lists domains and measured errors. Coefficients are our own minimax fits
//! (Remez exchange at 50 digits, the lowest coefficient rounded first and the others fitted again).
//!
//! Node bodies know nothing of tiers: they call the methods of [`Real`](super::Real).

mod exponential;
mod inverse;
mod logarithm;
mod parts;
mod power;
mod trigonometry;

pub use exponential::{cosh, exp, exp2, expm1, sinh, tanh};
pub use inverse::{acos, asin, atan, atan2};
pub use logarithm::{ln, log1p, log2};
pub use power::pow;
pub use trigonometry::{LARGEST_ANGLE, cos, sin, sin_cos, tan};
