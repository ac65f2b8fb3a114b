//! What bounds the sizes of things.

/// Largest magnitude of a world coordinate. Squares and products of coordinates up to here stay
/// finite wherever the renderer forms them.
pub const COORDINATE_LIMIT: f32 = 1e12;

/// Largest OBJ file that is read, in bytes.
pub const OBJ_BYTES_LIMIT: u64 = 1 << 30;
