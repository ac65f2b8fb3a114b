//! Hard cases that stay stable: no input in range makes a white pixel, or one that is no number. A folder a case.
//!
//! Nodes (`nodes.rs`) and scenes (`scenes.rs`) run in walk, batch and the jit with both generators. What comes out
//! has to be finite, the same bits in all of them, and as near to a formula in 64 bits, written in the case, as
//! `bounds.rs` derives. `docs/numerics.md` lists the cases with what was measured:
//!
//! `cargo test --workspace --test stability -- --nocapture`

mod bounds;
mod glass;
mod nodes;
mod scenes;

#[path = "bright_overlays/case.rs"]
mod bright_overlays;
#[path = "coincident/case.rs"]
mod coincident;
#[path = "conventions/case.rs"]
mod conventions;
#[path = "critical_angle/case.rs"]
mod critical_angle;
#[path = "double_grazing/case.rs"]
mod double_grazing;
#[path = "equal_indices/case.rs"]
mod equal_indices;
#[path = "far_camera/case.rs"]
mod far_camera;
#[path = "grazing/case.rs"]
mod grazing;
#[path = "grazing_light/case.rs"]
mod grazing_light;
#[path = "hue_borders/case.rs"]
mod hue_borders;
#[path = "huge_exponents/case.rs"]
mod huge_exponents;
#[path = "mirror_box/case.rs"]
mod mirror_box;
#[path = "needles/case.rs"]
mod needles;
#[path = "nested_glass/case.rs"]
mod nested_glass;
#[path = "perfect_mirrors/case.rs"]
mod perfect_mirrors;
#[path = "sphere_sizes/case.rs"]
mod sphere_sizes;
#[path = "subnormal/case.rs"]
mod subnormal;
#[path = "vanishing_roughness/case.rs"]
mod vanishing_roughness;
