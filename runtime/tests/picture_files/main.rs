//! Pictures as they are found: made byte by byte, read by the ray tracer.

mod alpha;
mod files;
mod hostile;
mod open_exr;
mod png;
mod radiance;
mod writers;
