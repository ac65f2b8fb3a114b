//! What a state holds, as words.

use super::ray_type::RayType;

/// Something a state holds under a field.
pub(super) trait Held {
    /// Writes its words, as many as the field is wide.
    fn read(&self, words: &mut [u32]);
    /// Takes the value of words.
    fn write(&mut self, words: &[u32]);
}

impl Held for f32 {
    fn read(&self, words: &mut [u32]) {
        words[0] = self.to_bits();
    }
    fn write(&mut self, words: &[u32]) {
        *self = f32::from_bits(words[0]);
    }
}

impl<const N: usize> Held for [f32; N] {
    fn read(&self, words: &mut [u32]) {
        for (word, x) in words[..N].iter_mut().zip(self) {
            *word = x.to_bits();
        }
    }
    fn write(&mut self, words: &[u32]) {
        for (x, word) in self.iter_mut().zip(&words[..N]) {
            *x = f32::from_bits(*word);
        }
    }
}

impl Held for i32 {
    fn read(&self, words: &mut [u32]) {
        words[0] = *self as u32;
    }
    fn write(&mut self, words: &[u32]) {
        *self = words[0] as i32;
    }
}

impl Held for bool {
    fn read(&self, words: &mut [u32]) {
        words[0] = if *self { u32::MAX } else { 0 };
    }
    fn write(&mut self, words: &[u32]) {
        *self = words[0] != 0;
    }
}

impl Held for RayType {
    fn read(&self, words: &mut [u32]) {
        words[0] = *self as i32 as u32;
    }
    fn write(&mut self, words: &[u32]) {
        *self = RayType::from_number(words[0] as i32);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_is_held_as_sixteen_words() {
        let matrix: [f32; 16] = std::array::from_fn(|at| at as f32 - 7.5);
        let (mut words, mut back) = ([0; 16], [0.0_f32; 16]);
        matrix.read(&mut words);
        back.write(&words);
        assert_eq!(back, matrix);
        assert_eq!(words[15], 7.5_f32.to_bits());
    }
}
