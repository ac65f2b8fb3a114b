//! The lists of lights that shaders loop over.

use phenomenon_compiler::effects::{LightList, LightMode, NamedLights};

use crate::lights::Light;

/// Lists of lights that were asked for. Shaders link once in each context, so no thread waits for another.
#[derive(Default)]
pub(super) struct LightLists(Vec<(NamedLights, Vec<ListedSample>)>);

/// A sample of a light: what a loop is at in one of its turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ListedSample {
    /// Position of the light in the scene.
    pub(super) light: u32,
    /// Which of its samples.
    pub(super) sample: u32,
}

impl ListedSample {
    /// A number by which it is known to shaders.
    pub(super) fn token(self) -> u64 {
        u64::from(self.sample) << 32 | u64::from(self.light)
    }

    /// The sample known by a token; of no light of any scene where the token is none.
    pub(super) fn of_token(token: u64) -> Self {
        Self { light: token as u32, sample: (token >> 32) as u32 }
    }
}

impl LightLists {
    /// The list of the lights that names stand for in a mode: each light with all of its samples. Asked
    /// again, it is the same.
    pub(super) fn find(
        &mut self,
        names: &[String],
        mode: LightMode,
        lights: &[Light],
    ) -> LightList {
        let named = NamedLights::new(names.to_vec(), mode);
        let known = self.0.iter().position(|(of, _)| *of == named);
        let at = known.unwrap_or_else(|| {
            let samples = chosen(&named, lights).into_iter().flat_map(|light| {
                let samples = lights[light as usize].kind.samples();
                (0..samples).map(move |sample| ListedSample { light, sample })
            });
            let samples = samples.collect();
            self.0.push((named, samples));
            self.0.len() - 1
        });
        LightList(at as u32)
    }

    /// What a loop over a list runs through.
    pub(super) fn samples(&self, list: LightList) -> &[ListedSample] {
        self.0.get(list.0 as usize).map_or(&[], |(_, samples)| samples)
    }
}

/// The positions of the lights that names stand for.
fn chosen(named: &NamedLights, lights: &[Light]) -> Vec<u32> {
    let numbered = || (0_u32..).zip(lights);
    let is_named = |light: &Light| named.names.contains(&light.name);
    let of_scene = |holds: &dyn Fn(&Light) -> bool| {
        numbered().filter(|(_, light)| holds(light)).map(|(number, _)| number).collect()
    };
    match named.mode {
        LightMode::All => of_scene(&|_| true),
        LightMode::Listed if named.names.is_empty() => of_scene(&|_| true),
        LightMode::Listed => {
            let find = |name: &String| numbered().find(|(_, light)| light.name == *name);
            named.names.iter().filter_map(find).map(|(number, _)| number).collect()
        }
        LightMode::Inclusive => of_scene(&is_named),
        LightMode::Exclusive => of_scene(&|light| !is_named(light)),
    }
}
