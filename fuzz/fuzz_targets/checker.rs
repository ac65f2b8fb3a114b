//! Graphs and scenes through the checker, and what is right through fixes, drawings and engines.

#![no_main]

use libfuzzer_sys::{fuzz_mutator, fuzz_target};

fuzz_target!(|bytes: &[u8]| phenomenon_fuzz::check_anything(bytes));

fuzz_mutator!(|bytes: &mut [u8], size: usize, most: usize, seed: u32| {
    phenomenon_fuzz::mutate(bytes, size, most, seed)
});
