//! Lights as loops see them.

/// A list of lights, resolved by the renderer from the names in a graph; known to that renderer only.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct LightList(pub u32);

/// Which lights of a scene a loop runs over, given some by name: mental ray's modes of a light list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum LightMode {
    /// Those that are named, as often and in the order they are named in; all of the scene where none is.
    #[default]
    Listed,
    /// Those of the scene that are named, in the order of the scene; none where none is named.
    Inclusive,
    /// Those of the scene that are not named, in its order.
    Exclusive,
    /// All of the scene, whatever is named.
    All,
}

impl LightMode {
    /// Their names in graph files, in the order of their numbers.
    pub const NAMES: [&str; 4] = ["listed", "inclusive", "exclusive", "all"];

    const ALL: [LightMode; 4] =
        [LightMode::Listed, LightMode::Inclusive, LightMode::Exclusive, LightMode::All];

    /// The one with this number; the first for a number that none has.
    pub fn from_number(number: i32) -> Self {
        Self::ALL.into_iter().find(|it| *it as i32 == number).unwrap_or_default()
    }
}

/// Lights as a graph gives them: names, and what they stand for.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NamedLights {
    /// The names.
    pub names: Vec<String>,
    /// What they stand for.
    pub mode: LightMode,
}

impl NamedLights {
    /// Names in a mode. What is the same in every scene becomes the same value, so that loops over the
    /// same lights share what they ask for.
    pub fn new(names: Vec<String>, mode: LightMode) -> Self {
        let (names, mode) = match (mode, names.len()) {
            (LightMode::All, _) | (LightMode::Exclusive, 0) => (Vec::new(), LightMode::Listed),
            (LightMode::Inclusive, 1) => (names, LightMode::Listed),
            _ => (names, mode),
        };
        Self { names, mode }
    }
}

/// One of the lights or light samples a loop runs over.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LightSample {
    /// Unit direction from the point towards the light.
    pub direction: [f32; 3],
    /// Distance to it; 0 for a light at infinity.
    pub distance: f32,
    /// How densely the samples of the light lie in its direction, per steradian; infinite for a light that no ray finds.
    pub density: f32,
    /// Whether the point can be lit by it at all (within its cone, not at its centre …).
    pub reachable: bool,
    /// Which sample it is, in the renderer's own words: what comes back where its colour is asked
    /// for, so that a sampled light is the same point both times.
    pub token: u64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modes_have_their_names_in_order() {
        let numbered = (0..).zip(LightMode::NAMES);
        for ((number, name), mode) in numbered.zip(LightMode::ALL) {
            assert_eq!(LightMode::from_number(number), mode);
            assert_eq!(format!("{mode:?}").to_lowercase(), name);
        }
        assert_eq!(LightMode::from_number(4), LightMode::Listed);
    }

    #[test]
    fn the_same_lights_are_the_same_value() {
        let lights = |names: &[&str], mode| {
            NamedLights::new(names.iter().map(|&name| name.to_owned()).collect(), mode)
        };
        let all = NamedLights::default();
        assert_eq!(lights(&["a", "b"], LightMode::All), all);
        assert_eq!(lights(&[], LightMode::Exclusive), all);
        assert_ne!(lights(&[], LightMode::Inclusive), all);
        assert_eq!(lights(&["a"], LightMode::Inclusive), lights(&["a"], LightMode::Listed));
        assert_ne!(
            lights(&["b", "a"], LightMode::Inclusive),
            lights(&["b", "a"], LightMode::Listed)
        );
        assert_ne!(lights(&["a"], LightMode::Exclusive), lights(&["a"], LightMode::Listed));
    }
}
