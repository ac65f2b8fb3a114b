//! Arbitrary bytes through the reader and the canonical form.

#![no_main]

use libfuzzer_sys::{fuzz_mutator, fuzz_target};

fuzz_target!(|bytes: &[u8]| phenomenon_fuzz::read_anything(bytes));

fuzz_mutator!(|bytes: &mut [u8], size: usize, most: usize, seed: u32| {
    phenomenon_fuzz::mutate(bytes, size, most, seed)
});
