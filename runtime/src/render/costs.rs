//! What each effect cost a rendering.

use std::ops::AddAssign;

use super::entry::Entry;
use super::statistics::RayCounts;

/// What one effect cost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// How many of [`Entry::unit`].
    pub count: u64,
    /// Milliseconds, of all threads together; 0 unless [`Settings::every_queue_timed`](super::Settings) asked for them.
    pub milliseconds: f64,
}

/// What the effects cost a rendering.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Costs {
    entries: [Cost; Entry::COUNT],
    /// Places looked up in each texture, by its number.
    textures: Vec<u64>,
}

impl AddAssign for Cost {
    fn add_assign(&mut self, other: Self) {
        self.count += other.count;
        self.milliseconds += other.milliseconds;
    }
}

impl AddAssign<&Costs> for Costs {
    fn add_assign(&mut self, other: &Costs) {
        for (entry, cost) in Entry::ALL.into_iter().zip(&other.entries) {
            *self.of_mut(entry) += *cost;
        }
        for (number, lookups) in other.textures.iter().enumerate() {
            self.look_up(number, *lookups);
        }
    }
}

impl Costs {
    /// What an effect cost.
    pub fn of(&self, entry: Entry) -> Cost {
        self.entries[entry as usize]
    }

    /// Places looked up in the texture of this number.
    pub fn lookups(&self, texture: usize) -> u64 {
        self.textures.get(texture).copied().unwrap_or(0)
    }

    pub(super) fn of_mut(&mut self, entry: Entry) -> &mut Cost {
        &mut self.entries[entry as usize]
    }

    /// Counts places looked up in a texture.
    pub(super) fn look_up(&mut self, texture: usize, lookups: u64) {
        if texture >= self.textures.len() {
            self.textures.resize(texture + 1, 0);
        }
        self.textures[texture] += lookups;
    }

    /// Takes the counts of rays.
    pub(super) fn take_rays(&mut self, rays: &RayCounts) {
        let RayCounts { eye: _, reflection, refraction, transparent, probe, shadow, environment } =
            *rays;
        for (entry, count) in [
            (Entry::Reflection, reflection),
            (Entry::Refraction, refraction),
            (Entry::Transparent, transparent),
            (Entry::Probe, probe),
            (Entry::ShadowRays, shadow),
            (Entry::Environment, environment),
        ] {
            self.of_mut(entry).count += count;
        }
    }
}
