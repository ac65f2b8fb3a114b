//! A scene of nothing: rays hit nothing, the environment is black and not ok, no light shines.

use phenomenon_compiler::effects::{Answer, Effect, LightList, LightSample, Ray, Renderer};
use phenomenon_compiler::state::State;

/// See the module.
pub struct EmptyScene;

impl Renderer for EmptyScene {
    fn trace(&mut self, _: Effect, _: &[Ray], answers: &mut [Answer]) {
        answers.fill(Answer::default());
    }

    fn light_list(&mut self, _: &[String]) -> LightList {
        LightList(0)
    }

    fn light_count(&mut self, _: LightList) -> usize {
        0
    }

    fn light_samples(&mut self, _: LightList, _: usize, _: &[State], samples: &mut [LightSample]) {
        samples.fill(LightSample::default());
    }

    fn light_colors(&mut self, _: LightList, _: usize, _: &[State], colors: &mut [[f32; 3]]) {
        colors.fill([0.0; 3]);
    }
}
