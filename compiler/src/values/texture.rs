//! Pictures as values.

/// A picture, and how its numbers become colours.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Texture {
    /// Path of the file, relative to the working folder or absolute; or of tiles, as [`TilePattern`](super::TilePattern) has it.
    pub file: String,
    /// What its numbers mean.
    pub space: Space,
}

/// What the numbers of a picture mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Space {
    /// Encoded as IEC 61966-2-1 has it: decoded to scene-linear when read. Alpha is linear.
    Srgb,
    /// Taken as they are: scene-linear colours, or data.
    Linear,
}

impl Space {
    /// Every space with its name in graph files.
    pub const ALL: [(&str, Space); 2] = [("srgb", Space::Srgb), ("linear", Space::Linear)];

    /// The space of a file that does not say: EXR and HDR are linear, all others sRGB.
    pub fn of_file(file: &str) -> Space {
        let lower = file.to_ascii_lowercase();
        let linear = lower.ends_with(".exr") || lower.ends_with(".hdr");
        if linear { Space::Linear } else { Space::Srgb }
    }

    /// Name in graph files.
    pub fn name(self) -> &'static str {
        match self {
            Space::Srgb => "srgb",
            Space::Linear => "linear",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_does_not_say_has_the_space_of_its_kind() {
        assert_eq!(Space::of_file("a.EXR"), Space::Linear);
        assert_eq!(Space::of_file("a.exr.png"), Space::Srgb);
    }
}
