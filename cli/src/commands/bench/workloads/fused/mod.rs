//! The workloads as one body each, of the bodies of their nodes: what rustc makes of them, eight lanes
//! wide, is the bound for any code generator with this mathematics.

mod branchy;
mod light;
mod mixed;
mod shade;
mod ten;
mod values;

pub use branchy::Branchy;
pub use light::Light;
pub use mixed::Mixed;
pub use shade::shader;
pub use ten::Ten;
