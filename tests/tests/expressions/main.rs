//! Expressions: what they compute, what they become, and what is said of broken ones.

mod broken;
mod build;
mod inner;
mod random;
mod written;
