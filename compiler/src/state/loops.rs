//! The fields loops read and provide.

use super::field::Field;
use super::iterated::Iterated;

impl Iterated {
    /// State fields that decide what turns there are, and what they provide.
    pub fn reads(self) -> &'static [Field] {
        match self {
            Iterated::Lights => &[Field::Point, Field::NormalGeom],
            Iterated::Samples => &[],
        }
    }

    /// The fields each turn provides, in the order of their slots.
    pub fn provides(self) -> impl Iterator<Item = Field> {
        Field::ALL.iter().copied().filter(move |field| field.of_loop() == Some(self))
    }

    /// Words of the fields each turn provides.
    pub fn words(self) -> usize {
        self.provides().map(|field| field.value_type().width()).sum()
    }

    /// First word of a field among those each turn provides.
    pub fn offset(self, field: Field) -> usize {
        let before = self.provides().take_while(|other| *other != field);
        before.map(|field| field.value_type().width()).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_turn_provides_fields_one_after_another() {
        for iterated in Iterated::ALL {
            let mut next = 0;
            for field in iterated.provides() {
                assert_eq!(iterated.offset(field), next);
                next += field.value_type().width();
            }
            assert_eq!(iterated.words(), next);
        }
        assert_eq!(Iterated::Lights.words(), 5);
    }
}
