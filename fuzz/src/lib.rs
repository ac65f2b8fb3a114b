//! What the fuzz targets do with an input. An input is a file, or several with a NUL between them:
//! the first is read, and names the others `1.json`, `2.json` …

mod checker;
mod files;
mod library;
mod mutate;
mod reader;
mod shading;
mod tree;

pub use checker::check_anything;
pub use mutate::mutate;
pub use reader::read_anything;
