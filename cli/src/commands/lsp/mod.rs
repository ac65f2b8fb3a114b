//! `phenomenon lsp`: a language server, so that editors show findings while one types.

mod address;
mod command;
mod complete;
mod cursor;
mod file;
mod hover;
mod in_editor;
mod open_files;
mod parts;
mod scene_keys;
mod server;
mod transport;

pub use command::{Arguments, run};
