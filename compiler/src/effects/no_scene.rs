//! A renderer without a scene.

use super::rays::{Answer, Ray, Trace};
use super::renderer::Renderer;
use crate::state::State;

/// A renderer without a scene: rays hit nothing and return black, not ok, no light shines, and there
/// are no textures.
///
/// Enough to evaluate a graph at a point of no place, as tests and editors do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NoScene;

impl Renderer for NoScene {
    fn trace(&mut self, _: Trace, _: &[State], _: &[Ray], answers: &mut [Answer]) {
        answers.fill(Answer::default());
    }
}
