//! The constants of a program.

use rustc_hash::FxHashMap;

use crate::storage::{LANES, Lanes};

/// Rows of constants, each there once. An operand in memory is 32 bytes wide, so a constant is, too.
#[derive(Debug, Default)]
pub struct Constants {
    rows: Vec<Lanes>,
    known: FxHashMap<u32, u32>,
}

impl Constants {
    /// The row of these bits.
    pub fn row(&mut self, bits: u32) -> u32 {
        *self.known.entry(bits).or_insert_with(|| {
            self.rows.push(Lanes([bits; LANES]));
            self.rows.len() as u32 - 1
        })
    }

    /// All rows.
    pub fn into_rows(self) -> Vec<Lanes> {
        self.rows
    }
}
