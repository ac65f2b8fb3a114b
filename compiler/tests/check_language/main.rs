//! What the language says beyond single values, and that engines run it: arrays, structs, strings,
//! textures, transforms, integers, shaders, and lists of shaders in roots.

mod components;
mod compounds;
mod files;
mod integers;
mod known_before;
mod outputs;
mod presets;
mod shaders;
mod shading;
mod turns;
mod uniform_values;
