//! Scene files: how scenes are written, read and checked.

mod assets;
mod description;
mod embedded;
mod fields;
mod file;
mod fit;
mod foreign;
mod key_kinds;
mod keys;
mod light_keys;
mod lights;
mod mesh_file;
mod meshes;
mod objects;
mod schema;
mod surroundings;

pub use assets::{Assets, Unusable};
pub use description::{
    BuildError, EnvironmentDescription, GraphUse, MaterialRef, MaterialSource, ObjectDescription,
    PresetRef, SceneDescription, SceneOptions, ShapeDescription,
};
pub use embedded::{default_scene, embedded_file};
pub use file::{
    LightNames, SceneFile, check_scene, check_scene_with, is_scene, read_scene, read_scene_file,
};
pub use fit::{MAX_UNKNOWN_LIGHTS, missing_root, settings, unknown_lights};
pub use key_kinds::{COORDINATES, LENGTHS, LIGHT, LINEAR};
pub use keys::SCENE;
pub use schema::file_schema;
