//! Tests of the renderer with shaders written by hand.

mod answers;
mod called_for;
mod environment_light;
mod invariance;
mod light_samples;
mod lighting;
mod meshes;
mod polygons;
mod reads;
mod scene_files;
mod self_intersection;
mod shaders;
mod sums;
mod surfaces;
mod tree;
mod tree_shapes;
mod watertight;
