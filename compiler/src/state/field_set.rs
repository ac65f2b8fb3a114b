//! Sets of state fields.

use std::ops::{BitOr, BitOrAssign, Sub};

use super::field::Field;

/// A set of state fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct FieldSet(u64);

const _: () = assert!(Field::ALL.len() <= u64::BITS as usize, "a bit for each field");

impl FieldSet {
    /// No field.
    pub const NONE: FieldSet = FieldSet(0);

    /// Whether `field` is in it.
    pub fn contains(self, field: Field) -> bool {
        self.meets(field.into())
    }

    /// Whether some field is in both.
    pub fn meets(self, other: FieldSet) -> bool {
        self.0 & other.0 != 0
    }
}

impl From<Field> for FieldSet {
    fn from(field: Field) -> Self {
        FieldSet(1 << field as u64)
    }
}

impl FromIterator<Field> for FieldSet {
    fn from_iter<I: IntoIterator<Item = Field>>(fields: I) -> Self {
        fields.into_iter().fold(FieldSet::NONE, |set, field| set | field.into())
    }
}

impl BitOr for FieldSet {
    type Output = FieldSet;
    fn bitor(self, other: FieldSet) -> FieldSet {
        FieldSet(self.0 | other.0)
    }
}

impl BitOrAssign for FieldSet {
    fn bitor_assign(&mut self, other: FieldSet) {
        self.0 |= other.0;
    }
}

impl Sub for FieldSet {
    type Output = FieldSet;
    fn sub(self, other: FieldSet) -> FieldSet {
        FieldSet(self.0 & !other.0)
    }
}
