//! What a node body may do: the operations every back end agrees on, bit for bit.
//!
//! A body is generic over [`Emit`]. Its implementations are the back ends: [`scalar`] runs one
//! point (walk), [`avx2`] eight at once (batch kernels), [`crate::ops::Tape`] records operations for all that
//! evaluates them: the JIT, portable forms, [`interval`]. `docs/numerics.md` defines each operation
//! as an expression; `tests` holds every back end to it over hard inputs.
//!
//! Rules for code generic over `E: Emit`: mark every function `#[inline(always)]`, take no closure,
//! use no Rust `if` on a shading value (use [`Mask::select`]), and call none of std's float maths.

#[cfg(target_arch = "x86_64")]
pub mod avx2;
mod back_end;
mod body;
pub mod functions;
pub mod interval;
mod methods;
mod ordered;
pub mod scalar;
mod shapes;
pub mod standard;
mod table;
mod words;

pub use back_end::{Bits, Emit, Int, Mask, Real, Select};
pub use body::{Body, MAX_OUTPUTS};
pub use ordered::Ordered;
pub use shapes::{Color, Components, One, Transform, Vector};
pub use table::Table;
pub use words::{Sink, Words, read_color, read_transform, read_vector, write_color, write_vector};
