//! Ray tracer that shades with compiled shader graphs.
//!
//! A [`scene::SceneBuilder`] takes geometry, materials (anything that implements
//! [`phenomenon_compiler::engine::Shade`]), lights, an environment and a camera and makes a
//! [`scene::Scene`]; [`render::render`] turns that into a [`film::Film`]. [`scene_file`] reads scenes
//! from files, and [`link`] compiles the graphs they use. No picture depends on the number of threads, the tiles, the batch size or the shape of the BVH.

pub mod bvh;
pub mod camera;
pub mod film;
pub mod geometry;
pub mod lights;
pub mod link;
pub mod monoliths;
pub mod outputs;
pub mod render;
pub mod sampling;
pub mod scene;
pub mod scene_file;
pub mod texture;
