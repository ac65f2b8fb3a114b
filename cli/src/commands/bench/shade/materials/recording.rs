//! A renderer that asks another and keeps its answers.

use phenomenon_compiler::effects::{
    Answer, LightList, LightMode, LightSample, Points, Ray, Renderer, Trace,
};
use phenomenon_compiler::state::{Objects, State};

use super::table::Table;

/// Answers from a table where it knows, and else asks another and keeps the answer.
pub struct Recording<'a> {
    /// What is known.
    pub table: &'a mut Table,
    /// Who is asked.
    pub real: &'a mut dyn Renderer,
    /// How much was asked so far.
    pub asked: Asked,
}

/// How much was asked.
#[derive(Clone, Copy, Debug, Default)]
pub struct Asked {
    /// Rays.
    pub rays: u64,
    /// Colours of light samples.
    pub lights: u64,
}

impl Renderer for Recording<'_> {
    fn trace(&mut self, trace: Trace, states: &[State], rays: &[Ray], answers: &mut [Answer]) {
        self.asked.rays += rays.len() as u64;
        for (ray, answer) in rays.iter().zip(answers) {
            let from = &states[ray.point as usize];
            *answer = self.table.ray(trace, from, ray).unwrap_or_else(|| {
                let alone = [Ray { point: 0, ..*ray }];
                let mut answers = [Answer::default()];
                self.real.trace(trace, std::slice::from_ref(from), &alone, &mut answers);
                self.table.keep_ray(trace, from, ray, answers[0]);
                answers[0]
            });
        }
    }

    fn objects(&self) -> Objects<'_> {
        self.real.objects()
    }

    fn light_list(&mut self, names: &[String], mode: LightMode) -> LightList {
        self.table.list(names, mode).unwrap_or_else(|| {
            let list = self.real.light_list(names, mode);
            let count = self.real.light_count(list);
            self.table.keep_list(names, mode, list, count)
        })
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
        for (point, sample) in points.iter().zip(samples) {
            *sample = self.table.light(list, iteration, point).unwrap_or_else(|| {
                let mut real = [LightSample::default()];
                let alone = Points::from(std::slice::from_ref(point));
                let of = self.table.real_list(list);
                self.real.light_samples(of, iteration, alone, &mut real);
                self.table.keep_light(list, iteration, point, real[0])
            });
        }
    }

    fn light_colors(&mut self, points: Points<'_>, tokens: &[u64], colors: &mut [[f32; 3]]) {
        self.asked.lights += tokens.len() as u64;
        for ((point, &token), color) in points.iter().zip(tokens).zip(colors) {
            let Some(sample) = self.table.sample(token) else { continue };
            *color = sample.color.unwrap_or_else(|| {
                let mut real = [[0.0; 3]];
                let alone = Points::from(std::slice::from_ref(point));
                self.real.light_colors(alone, &[sample.token], &mut real);
                self.table.keep_color(token, real[0]);
                real[0]
            });
        }
    }
}
