//! Maps and folds: nodes whose body is a phenomenon, with a turn for each value of a list. They exist in
//! files only: before anything else is looked at they are written out as nodes, one for each turn, so
//! that checks, engines and laziness know nothing of them.

mod form;
mod repeats;
mod unrolled;
mod uses;

pub(super) use form::written_name;
pub(super) use unrolled::{is_implied, unroll};

pub use form::{ACCUMULATED, Form, INDEX, INITIAL, ITEM, OVER, form_of};
