//! The renderer as engines see it.

use crate::state::{Objects, State};
use crate::values::Texture;

use super::lights::{LightList, LightMode, LightSample};
use super::points::Points;
use super::rays::{Answer, Ray, Trace};
use super::sampling::{Lookup, Sampling};

/// A texture, resolved by the renderer from the file in a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TextureId(pub u32);

impl TextureId {
    /// A texture that is not there.
    pub const NONE: Self = Self(u32::MAX);
}

/// The renderer as engines see it. Every call carries many points; an engine that runs one point
/// at a time passes one. Answers may depend on the arguments only, never on order or grouping; of a
/// state only the fields that [`Effect::reads`](super::Effect::reads) names may matter, and what the
/// renderer itself keeps there.
///
/// A renderer without textures need not implement the calls for textures, one without lights not
/// those for lights.
pub trait Renderer {
    /// Traces `rays`, each from one of the `states`, and writes one answer each.
    fn trace(&mut self, trace: Trace, states: &[State], rays: &[Ray], answers: &mut [Answer]);

    /// The objects that states name, their surfaces, and the camera.
    fn objects(&self) -> Objects<'_> {
        Objects::default()
    }

    /// The texture of a file. A renderer opens all of [`crate::engine::Shade::textures`] beforehand and
    /// refuses to start where it cannot; it makes [`crate::engine::Shade::filtered_textures`] ready for
    /// footprints.
    fn texture(&mut self, _texture: &Texture) -> TextureId {
        TextureId::NONE
    }

    /// The colour (r, g, b, a) of `texture` at each place, read as `sampling` says; none where a
    /// coordinate is not finite, or there is no such texture. Of a place only what the sampling looks at
    /// may matter.
    fn read_texture(
        &mut self,
        _texture: TextureId,
        _sampling: Sampling,
        _lookups: &[Lookup],
        colors: &mut [Option<[f32; 4]>],
    ) {
        colors.fill(None);
    }

    /// Columns and rows of `texture`; none if there is no such texture.
    fn texture_size(&mut self, _texture: TextureId) -> Option<[u32; 2]> {
        None
    }

    /// The list of the lights that `names` stand for in a mode.
    fn light_list(&mut self, _names: &[String], _mode: LightMode) -> LightList {
        LightList(0)
    }

    /// How many iterations a loop over `list` takes: its lights, each with its samples.
    fn light_count(&mut self, _list: LightList) -> usize {
        0
    }

    /// Where sample `iteration` of `list` lies as seen from each point. Casts no ray.
    fn light_samples(
        &mut self,
        _list: LightList,
        _iteration: usize,
        _points: Points<'_>,
        samples: &mut [LightSample],
    ) {
        samples.fill(LightSample::default());
    }

    /// How densely the environment light draws each direction, per steradian and of all its samples: what
    /// [`LightSample::density`] would be there. 0 without such a light, where it lights nothing, and for a direction that is zero
    /// or not finite; of others the length does not matter.
    fn light_density(&mut self, _directions: &[[f32; 3]], densities: &mut [f32]) {
        densities.fill(0.0);
    }

    /// What the light sample with each point's token sends there, after shadows (r, g, b), divided by
    /// the number of samples of its light: a loop only adds. The token is one that
    /// [`Renderer::light_samples`] gave out for the point as the loop sees it; a scope inside the loop may
    /// have moved it since.
    fn light_colors(&mut self, _points: Points<'_>, _tokens: &[u64], colors: &mut [[f32; 3]]) {
        colors.fill([0.0; 3]);
    }
}
