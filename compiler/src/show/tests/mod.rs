//! Tests of drawings as a whole.

mod drawings;
mod faults;
mod graphs;
mod well_formed;
