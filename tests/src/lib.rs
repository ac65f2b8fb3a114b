//! Tests across crates. What they share is the compiler's feature `testing`.
