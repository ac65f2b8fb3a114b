//! The program as its users run it: what it prints and how it ends.

mod bench;
mod check;
mod compare;
mod completions;
mod effects;
mod eval;
mod input;
mod meshes;
mod nodes;
mod numbers;
mod outputs;
mod program;
mod readme;
mod render;
mod scenes;
mod show;
mod sizes;
mod terminal;
mod usage;
