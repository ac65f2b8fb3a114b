//! Numbers that bodies look up.

use std::fmt;
use std::hash::{Hash, Hasher};

/// Numbers that are the same for all points, looked up by position: see
/// [`Emit::table`](super::Emit::table).
#[derive(Clone, Copy)]
pub struct Table(&'static [f32]);

impl Table {
    /// A table of these numbers.
    ///
    /// # Panics
    ///
    /// If there are none, or more than positions of 32 bits.
    pub const fn new(numbers: &'static [f32]) -> Self {
        assert!(!numbers.is_empty() && numbers.len() <= i32::MAX as usize);
        Self(numbers)
    }

    /// The numbers.
    pub const fn numbers(self) -> &'static [f32] {
        self.0
    }

    /// The last position.
    pub const fn last(self) -> i32 {
        self.0.len() as i32 - 1
    }

    /// The number at a position; outside the table that of its nearer end.
    #[inline(always)]
    pub fn at(self, index: i32) -> f32 {
        self.0[index.clamp(0, self.last()) as usize]
    }
}

/// Two tables are one where they lie in one place.
impl PartialEq for Table {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.0, other.0)
    }
}

impl Eq for Table {}

impl Hash for Table {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.as_ptr().hash(state);
        self.0.len().hash(state);
    }
}

impl fmt::Debug for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Table({} numbers)", self.0.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_outside_take_the_nearer_end() {
        static NUMBERS: [f32; 3] = [1.0, 2.0, 4.0];
        let table = Table::new(&NUMBERS);
        let found = [i32::MIN, -1, 0, 1, 2, 3, i32::MAX].map(|index| table.at(index));
        assert_eq!(found, [1.0, 1.0, 1.0, 2.0, 4.0, 4.0, 4.0]);
        assert!(table == Table::new(&NUMBERS) && table != Table::new(&NUMBERS[..2]));
    }
}
