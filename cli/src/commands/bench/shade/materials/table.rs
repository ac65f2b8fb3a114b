//! What a renderer answered, by point.

use phenomenon_compiler::effects::{Answer, LightList, LightMode, LightSample, Ray, Trace};
use phenomenon_compiler::state::{Footprint, State, Surface, Surfaces};

/// All answers about some points. A point is known by its path, which is its number here.
#[derive(Debug, Default)]
pub struct Table {
    /// Of each point, the answers to its rays: a handful, looked through in order.
    rays: Vec<Vec<(Trace, u64, Answer)>>,
    /// Of each point, its surface.
    surfaces: Vec<Surface>,
    lists: Vec<List>,
    /// The samples of lights; what shaders hand back is a position here.
    samples: Vec<Sample>,
}

/// A list of lights.
#[derive(Debug)]
struct List {
    names: Vec<String>,
    mode: LightMode,
    /// What the renderer calls it.
    list: LightList,
    count: usize,
    /// Of each point and each of the samples, where it stands in the table.
    samples: Vec<Option<u32>>,
}

#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// As shaders see it.
    pub sample: LightSample,
    /// The renderer's word for it.
    pub token: u64,
    /// What it sends to the point, if that was asked.
    pub color: Option<[f32; 3]>,
}

impl Table {
    /// Nothing is known yet, but the surfaces of the points.
    pub fn of(surfaces: Vec<Surface>) -> Self {
        Self { rays: vec![Vec::new(); surfaces.len()], surfaces, ..Self::default() }
    }

    /// The answer to a ray of a point.
    #[inline]
    pub fn ray(&self, trace: Trace, from: &State, ray: &Ray) -> Option<Answer> {
        let of_point = self.rays.get(from.path as usize)?;
        let mut known = of_point.iter().filter(|(of, site, _)| *of == trace && *site == ray.site);
        known.next().map(|(_, _, answer)| *answer)
    }

    /// Keeps the answer to a ray.
    pub fn keep_ray(&mut self, trace: Trace, from: &State, ray: &Ray, answer: Answer) {
        if let Some(of_point) = self.rays.get_mut(from.path as usize) {
            of_point.push((trace, ray.site, answer));
        }
    }

    /// The list of lights with these names in a mode.
    pub fn list(&self, names: &[String], mode: LightMode) -> Option<LightList> {
        let at = self.lists.iter().position(|list| list.names == names && list.mode == mode);
        at.map(|at| LightList(at as u32))
    }

    /// Keeps what a renderer calls a list, and how long it is.
    pub fn keep_list(
        &mut self,
        names: &[String],
        mode: LightMode,
        list: LightList,
        count: usize,
    ) -> LightList {
        let samples = vec![None; count * self.surfaces.len()];
        self.lists.push(List { names: names.to_vec(), mode, list, count, samples });
        LightList(self.lists.len() as u32 - 1)
    }

    /// What the renderer calls a list.
    pub fn real_list(&self, list: LightList) -> LightList {
        self.lists.get(list.0 as usize).map_or(LightList(0), |list| list.list)
    }

    /// How many samples the lights of a list have together.
    pub fn count(&self, list: LightList) -> usize {
        self.lists.get(list.0 as usize).map_or(0, |list| list.count)
    }

    /// A sample of a list for a point.
    #[inline]
    pub fn light(&self, list: LightList, iteration: usize, point: &State) -> Option<LightSample> {
        let list = self.lists.get(list.0 as usize)?;
        let at = *list.samples.get(point.path as usize * list.count + iteration)?;
        Some(self.samples[at? as usize].sample)
    }

    /// Keeps a sample of a list, under a token of the table's own.
    pub fn keep_light(
        &mut self,
        list: LightList,
        iteration: usize,
        point: &State,
        real: LightSample,
    ) -> LightSample {
        let at = self.samples.len() as u32;
        let sample = LightSample { token: at.into(), ..real };
        if let Some(list) = self.lists.get_mut(list.0 as usize)
            && let Some(slot) = list.samples.get_mut(point.path as usize * list.count + iteration)
        {
            *slot = Some(at);
            self.samples.push(Sample { sample, token: real.token, color: None });
        }
        sample
    }

    /// The sample with a token.
    #[inline]
    pub fn sample(&self, token: u64) -> Option<Sample> {
        self.samples.get(token as usize).copied()
    }

    /// Keeps what a sample sends.
    pub fn keep_color(&mut self, token: u64, color: [f32; 3]) {
        if let Some(sample) = self.samples.get_mut(token as usize) {
            sample.color = Some(color);
        }
    }

    #[inline]
    fn surface(&self, state: &State) -> &Surface {
        self.surfaces.get(state.path as usize).unwrap_or(&Surface::NONE)
    }
}

/// As they were at the points.
impl Surfaces for Table {
    fn derivative_u(&self, state: &State) -> [f32; 3] {
        self.surface(state).derivative_u
    }
    fn derivative_v(&self, state: &State) -> [f32; 3] {
        self.surface(state).derivative_v
    }
    fn vertex_color(&self, state: &State) -> [f32; 4] {
        self.surface(state).vertex_color
    }
    fn second_uv(&self, state: &State) -> [f32; 2] {
        self.surface(state).second_uv
    }
    fn footprint(&self, state: &State) -> Footprint {
        self.surface(state).footprint
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_those_of_the_point_the_kind_and_the_site() {
        let mut table = Table::of(vec![Surface::NONE; 2]);
        let at = |path| State { path, ..State::default() };
        let ray = |site| Ray { point: 0, origin: [0.0; 3], direction: [0.0; 3], site };
        let answer = |distance| Answer { distance, ..Answer::default() };
        table.keep_ray(Trace::Probe, &at(1), &ray(7), answer(2.0));
        table.keep_ray(Trace::Probe, &at(1), &ray(8), answer(3.0));
        let known = |trace, path, site| {
            table.ray(trace, &at(path), &ray(site)).map(|answer| answer.distance)
        };
        assert_eq!(known(Trace::Probe, 1, 7), Some(2.0));
        assert_eq!(known(Trace::Probe, 1, 8), Some(3.0));
        for (trace, path, site) in
            [(Trace::Probe, 0, 7), (Trace::Reflection, 1, 7), (Trace::Probe, 1, 9)]
        {
            assert_eq!(known(trace, path, site), None);
        }
        assert_eq!(known(Trace::Probe, 2, 7), None);
    }

    #[test]
    fn lights_are_known_by_tokens_of_the_table() {
        let mut table = Table::of(vec![Surface::NONE; 2]);
        let all = table.keep_list(&[], LightMode::All, LightList(4), 3);
        let some = table.keep_list(&["sun".to_owned()], LightMode::Listed, LightList(9), 1);
        assert_eq!(table.list(&["sun".to_owned()], LightMode::Listed), Some(some));
        assert_eq!(table.list(&["sun".to_owned()], LightMode::Exclusive), None);
        assert_eq!((table.real_list(all), table.count(all)), (LightList(4), 3));
        let point = State { path: 1, ..State::default() };
        let real = LightSample { token: 1 << 40, distance: 2.0, ..LightSample::default() };
        let kept = table.keep_light(all, 2, &point, real);
        assert_eq!(table.light(all, 2, &point), Some(kept));
        assert_eq!(table.light(all, 1, &point), None);
        assert_eq!(table.light(some, 0, &point), None);
        assert_eq!(table.sample(kept.token).map(|it| (it.token, it.color)), Some((1 << 40, None)));
        table.keep_color(kept.token, [1.0, 2.0, 3.0]);
        assert_eq!(table.sample(kept.token).and_then(|it| it.color), Some([1.0, 2.0, 3.0]));
    }
}
