//! How the turns of a loop become one value.

use crate::values::Type;

/// How the values of turns become one. Each word by itself; the alpha of a colour is 1, except that
/// [`Reduction::Over`] makes one of those that arrive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reduction {
    /// Their sum, in order, in 32 bits.
    Sum,
    /// Their sum, divided by the number of turns, those included that do not reach the point; zero
    /// without any.
    Mean,
    /// The greatest, where a NaN is never the greater one; zero without any above minus infinity.
    Maximum,
    /// Each over those after it: colours that are multiplied by their alpha.
    Over,
}

impl Reduction {
    /// Words of the widest type that is reduced: a colour.
    pub const MOST_WORDS: usize = 4;

    /// What is there before the first turn.
    pub fn start(self, value_type: Type, words: &mut [u32]) {
        let none = match self {
            Reduction::Sum | Reduction::Mean | Reduction::Over => 0.0_f32,
            Reduction::Maximum => f32::NEG_INFINITY,
        };
        words.fill(none.to_bits());
        if let Some(alpha) = self.fixed_alpha(value_type) {
            words[alpha] = 1.0_f32.to_bits();
        }
    }

    /// Takes the value of one more turn.
    pub fn take(self, value_type: Type, so_far: &mut [u32], value: &[u32]) {
        let behind = 1.0 - so_far.get(3).map_or(0.0, |alpha| f32::from_bits(*alpha));
        let components = self.fixed_alpha(value_type).unwrap_or(so_far.len());
        for (so_far, value) in so_far[..components].iter_mut().zip(value) {
            let (x, y) = (f32::from_bits(*so_far), f32::from_bits(*value));
            let taken = match self {
                Reduction::Sum | Reduction::Mean => x + y,
                Reduction::Maximum => match y > x {
                    true => y,
                    false => x,
                },
                Reduction::Over => x + behind * y,
            };
            *so_far = taken.to_bits();
        }
    }

    /// What is left to do once `turns` were taken; nothing for most.
    pub fn finish(self, value_type: Type, turns: usize, words: &mut [u32]) {
        let components = self.fixed_alpha(value_type).unwrap_or(words.len());
        for word in &mut words[..components] {
            let x = f32::from_bits(*word);
            let done = match self {
                Reduction::Mean if turns > 0 => x / turns as f32,
                Reduction::Maximum if x == f32::NEG_INFINITY => 0.0,
                _ => x,
            };
            *word = done.to_bits();
        }
    }

    /// Whether [`Reduction::finish`] changes anything.
    pub fn has_end(self) -> bool {
        matches!(self, Reduction::Mean | Reduction::Maximum)
    }

    /// Position of the alpha that stays 1.
    fn fixed_alpha(self, value_type: Type) -> Option<usize> {
        (value_type == Type::Color && self != Reduction::Over).then_some(3)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reduced(reduction: Reduction, turns: &[[f32; 4]]) -> [f32; 4] {
        let mut words = [7; 4];
        reduction.start(Type::Color, &mut words);
        for turn in turns {
            reduction.take(Type::Color, &mut words, &turn.map(f32::to_bits));
        }
        reduction.finish(Type::Color, turns.len(), &mut words);
        words.map(f32::from_bits)
    }

    #[test]
    fn turns_become_one_value() {
        let turns = [[1.0, -2.0, 0.25, 0.5], [3.0, -6.0, 0.5, 0.25]];
        assert_eq!(reduced(Reduction::Sum, &turns), [4.0, -8.0, 0.75, 1.0]);
        assert_eq!(reduced(Reduction::Mean, &turns), [2.0, -4.0, 0.375, 1.0]);
        assert_eq!(reduced(Reduction::Maximum, &turns), [3.0, -2.0, 0.5, 1.0]);
        assert_eq!(reduced(Reduction::Over, &turns), [2.5, -5.0, 0.5, 0.625]);
    }

    #[test]
    fn no_turn_is_zero() {
        for reduction in [Reduction::Sum, Reduction::Mean, Reduction::Maximum] {
            assert_eq!(reduced(reduction, &[]), [0.0, 0.0, 0.0, 1.0], "{reduction:?}");
        }
        assert_eq!(reduced(Reduction::Over, &[]), [0.0; 4]);
    }
}
