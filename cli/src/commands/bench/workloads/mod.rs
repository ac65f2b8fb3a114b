//! What `bench shade` shades: graphs of four kinds, each written by hand as well, and the points.

mod batches;
mod blending;
mod branchy;
#[cfg(target_arch = "x86_64")]
mod eight;
mod fused;
mod light;
mod mixed;
mod states;
mod ten;
mod workload;

pub use states::STATES;
pub use workload::Workload;
