//! How a picture is read: what lies beyond its edges, and what becomes of its pixels.

/// What lies beyond the edges of a picture, along one of its axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Wrap {
    /// The picture again.
    #[default]
    Periodic,
    /// Its outermost pixels.
    Clamp,
    /// The picture mirrored, then the picture again.
    Mirror,
    /// A colour that is given.
    Constant,
}

/// What becomes of the pixels round a place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Filter {
    /// The four nearest, bilinear between their middles.
    #[default]
    Linear,
    /// The one the place lies in.
    Closest,
    /// Sixteen, weighted as a uniform cubic B-spline has it.
    Cubic,
    /// All that a footprint covers.
    Footprint,
}

/// How a picture is read; known before shading.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Sampling {
    /// Along the first coordinate, then along the second.
    pub wrap: [Wrap; 2],
    /// What becomes of the pixels there.
    pub filter: Filter,
}

/// Where a picture is read.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lookup {
    /// The place: the picture fills 0 to 1 in both, the second upwards.
    pub uv: [f32; 2],
    /// The colour beyond the edges, along axes where it is [`Wrap::Constant`].
    pub default: [f32; 4],
    /// What a pixel covers: two vectors across it, for [`Filter::Footprint`].
    pub footprint: [[f32; 2]; 2],
}

impl Wrap {
    /// Their names in graph files, in the order of their numbers.
    pub const NAMES: [&str; 4] = ["periodic", "clamp", "mirror", "constant"];
    /// Number of [`Wrap::Constant`].
    pub const CONSTANT: i32 = Wrap::Constant as i32;

    const ALL: [Wrap; 4] = [Wrap::Periodic, Wrap::Clamp, Wrap::Mirror, Wrap::Constant];

    /// The one with this number; the first for a number that none has.
    fn from_number(number: i32) -> Self {
        Self::ALL.into_iter().find(|it| *it as i32 == number).unwrap_or_default()
    }
}

impl Filter {
    /// Their names in graph files, in the order of their numbers.
    pub const NAMES: [&str; 4] = ["linear", "closest", "cubic", "footprint"];
    /// Number of [`Filter::Footprint`].
    pub const FOOTPRINT: i32 = Filter::Footprint as i32;

    const ALL: [Filter; 4] = [Filter::Linear, Filter::Closest, Filter::Cubic, Filter::Footprint];

    /// The one with this number; the first for a number that none has.
    fn from_number(number: i32) -> Self {
        Self::ALL.into_iter().find(|it| *it as i32 == number).unwrap_or_default()
    }
}

impl Sampling {
    /// From the numbers of the choices `wrap_u`, `wrap_v` and `filter`, in this order; 0 for each that
    /// is not there.
    pub fn from_numbers(numbers: &[i32]) -> Self {
        let number = |at: usize| numbers.get(at).copied().unwrap_or_default();
        Self {
            wrap: [0, 1].map(|axis| Wrap::from_number(number(axis))),
            filter: Filter::from_number(number(2)),
        }
    }

    /// Whether the colour beyond the edges may show.
    pub fn has_default(self) -> bool {
        self.wrap.contains(&Wrap::Constant)
    }

    /// Whether coarser versions of the picture are read too.
    pub fn is_filtered(self) -> bool {
        self.filter == Filter::Footprint
    }

    /// How many of the words that describe a [`Lookup`], in their order, can matter: the place, the
    /// colour beyond the edges, the footprint.
    pub(crate) fn words(self) -> usize {
        match (self.is_filtered(), self.has_default()) {
            (true, _) => 10,
            (false, true) => 6,
            (false, false) => 2,
        }
    }
}

impl Lookup {
    /// From words in their order, as many as there are.
    pub(crate) fn from_words(words: &[u32]) -> Self {
        let number = |at: usize| f32::from_bits(words.get(at).copied().unwrap_or_default());
        Self {
            uv: [number(0), number(1)],
            default: [number(2), number(3), number(4), number(5)],
            footprint: [[number(6), number(7)], [number(8), number(9)]],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_in_the_order_of_the_numbers() {
        for (at, name) in Wrap::NAMES.iter().enumerate() {
            let wrap = Wrap::from_number(at as i32);
            assert_eq!(
                (wrap as usize, format!("{wrap:?}").to_lowercase()),
                (at, (*name).to_owned())
            );
        }
        for (at, name) in Filter::NAMES.iter().enumerate() {
            let filter = Filter::from_number(at as i32);
            let told = format!("{filter:?}").to_lowercase();
            assert_eq!((filter as usize, told), (at, (*name).to_owned()));
        }
        assert_eq!(
            (Wrap::from_number(4), Filter::from_number(-1)),
            (Wrap::Periodic, Filter::Linear)
        );
    }

    #[test]
    fn only_words_that_matter_are_carried() {
        let words: Vec<u32> = (1..=10).map(|x| (x as f32).to_bits()).collect();
        let of = |numbers: &[i32]| {
            let words = &words[..Sampling::from_numbers(numbers).words()];
            let Lookup { uv, default, footprint } = Lookup::from_words(words);
            (uv, default[0], footprint[1][1])
        };
        assert_eq!(of(&[]), ([1.0, 2.0], 0.0, 0.0));
        assert_eq!(of(&[0, 3, 1]), ([1.0, 2.0], 3.0, 0.0));
        assert_eq!(of(&[1, 2, 3]), ([1.0, 2.0], 3.0, 10.0));
    }
}
