//! What is known of an object as a whole.

/// What is the same at every point of an object. States do not carry it: they name their object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object {
    /// Its number, from 1 in the order of the scene; 0 for none.
    pub id: i32,
    /// A number of its own, 0 to below 1, without order from one object to the next.
    pub random: f32,
    /// From its own space to that of the scene.
    pub to_world: [f32; 16],
    /// From the space of the scene to its own.
    pub to_object: [f32; 16],
}

/// The map that moves nothing: rows are where the axes go, the last is the translation.
#[rustfmt::skip]
pub const IDENTITY: [f32; 16] = [
    1.0, 0.0, 0.0, 0.0,
    0.0, 1.0, 0.0, 0.0,
    0.0, 0.0, 1.0, 0.0,
    0.0, 0.0, 0.0, 1.0,
];

impl Default for Object {
    fn default() -> Self {
        Self::NONE
    }
}

impl Object {
    /// What stands for the object where there is none: its space is that of the scene.
    pub const NONE: Self = Self { id: 0, random: 0.0, to_world: IDENTITY, to_object: IDENTITY };

    /// The object at a position in a scene, in its own place.
    pub fn at(position: u32) -> Self {
        // The finaliser of MurmurHash3: each bit of the position turns half of the bits.
        let mut hash = position.wrapping_add(1);
        hash = (hash ^ hash >> 16).wrapping_mul(0x85eb_ca6b);
        hash = (hash ^ hash >> 13).wrapping_mul(0xc2b2_ae35);
        hash ^= hash >> 16;
        let random = (hash >> 8) as f32 / 16_777_216.0;
        let id = position.saturating_add(1).min(i32::MAX as u32) as i32;
        Self { id, random, ..Self::NONE }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_objects_are_spread_evenly() {
        let all: Vec<f32> = (0..4096).map(|at| Object::at(at).random).collect();
        assert!(all.iter().all(|number| (0.0..1.0).contains(number)));
        let mut bins = [0; 16];
        all.iter().for_each(|number| bins[(number * 16.0) as usize] += 1);
        // 256 are due in each; six standard deviations are 93.
        assert!(bins.iter().all(|bin| (163..=349).contains(bin)), "{bins:?}");
        let rises = all.windows(2).filter(|pair| pair[0] < pair[1]).count();
        assert!((1848..=2247).contains(&rises), "{rises} of 4095 rise");
        assert_eq!(Object::at(u32::MAX).id, i32::MAX);
    }
}
