//! Standard output, standard error and the progress bar.
//!
//! Names, paths and values come from files of strangers, and a terminal obeys what it is sent. So text for people goes
//! through [`print()`] or [`tell`], which show what cannot be seen as escapes; files for programs go through
//! [`print_exactly`].

mod escape;
mod look;
mod progress;
mod write;

pub use escape::{pushed, shown};
pub use look::{Look, Stream};
pub use progress::progress;
pub use write::{answer, complain, print, print_drawn, print_exactly, tell, tell_drawn};
