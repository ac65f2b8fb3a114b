//! `phenomenon lsp`: a language server, so that editors show findings while one types.

mod address;
mod answers;
mod command;
mod complete;
mod cursor;
mod expression;
mod file;
mod hover;
mod in_editor;
mod keys;
mod names;
mod offers;
mod open_files;
mod parameters;
mod part;
mod parts;
mod paths;
mod scope;
mod server;
mod told;
mod transport;

pub use command::{Arguments, run};
