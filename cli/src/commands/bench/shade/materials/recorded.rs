//! A renderer that answers from a table.

use std::sync::Arc;

use phenomenon_compiler::effects::{
    Answer, LightList, LightMode, LightSample, Points, Ray, Renderer, TextureId, Trace,
};
use phenomenon_compiler::state::{Camera, Object, Objects, State};
use phenomenon_compiler::values::Texture;

use super::table::Table;

/// Answers from a table, and counts what the table does not know.
#[derive(Clone)]
pub struct Recorded {
    /// What it answers.
    pub table: Arc<Table>,
    /// The objects of the scene.
    pub objects: Arc<[Object]>,
    /// Its camera.
    pub camera: Camera,
    /// How much was asked that the table does not know.
    pub unknown: u64,
}

impl Recorded {
    /// What is known, or nothing, which is counted.
    #[inline]
    fn known<T: Default>(unknown: &mut u64, answer: Option<T>) -> T {
        answer.unwrap_or_else(|| {
            *unknown += 1;
            T::default()
        })
    }
}

impl Renderer for Recorded {
    fn trace(&mut self, trace: Trace, states: &[State], rays: &[Ray], answers: &mut [Answer]) {
        let Self { table, unknown, .. } = self;
        for (ray, answer) in rays.iter().zip(answers) {
            let from = &states[ray.point as usize];
            *answer = Self::known(unknown, table.ray(trace, from, ray));
        }
    }

    fn objects(&self) -> Objects<'_> {
        Objects { objects: &self.objects, surfaces: &*self.table, camera: &self.camera }
    }

    /// None of the materials reads a texture, or asks a direction for its density.
    fn texture(&mut self, _: &Texture) -> TextureId {
        self.unknown += 1;
        TextureId::NONE
    }

    fn light_density(&mut self, directions: &[[f32; 3]], densities: &mut [f32]) {
        self.unknown += directions.len() as u64;
        densities.fill(0.0);
    }

    fn light_list(&mut self, names: &[String], mode: LightMode) -> LightList {
        let list = self.table.list(names, mode);
        self.unknown += u64::from(list.is_none());
        list.unwrap_or(LightList(u32::MAX))
    }

    fn light_count(&mut self, list: LightList) -> usize {
        self.table.count(list)
    }

    fn light_samples(
        &mut self,
        list: LightList,
        iteration: usize,
        points: Points<'_>,
        samples: &mut [LightSample],
    ) {
        let Self { table, unknown, .. } = self;
        for (point, sample) in points.iter().zip(samples) {
            *sample = Self::known(unknown, table.light(list, iteration, point));
        }
    }

    fn light_colors(&mut self, _: Points<'_>, tokens: &[u64], colors: &mut [[f32; 3]]) {
        let Self { table, unknown, .. } = self;
        for (token, color) in tokens.iter().zip(colors) {
            *color = Self::known(unknown, table.sample(*token).and_then(|sample| sample.color));
        }
    }
}
