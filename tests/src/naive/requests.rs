//! What nodes ask of the renderer, and the loop over its lights.

use phenomenon_compiler::effects::{Answer, Effect, LightSample, Ray, Trace};
use phenomenon_compiler::graph::Binding;
use phenomenon_compiler::state::Field;
use phenomenon_compiler::values::{Literal, Type};

use super::evaluation::Evaluation;
use super::nodes::TooLong;
use super::surroundings::{Inside, SurroundingsId};

impl Evaluation<'_> {
    pub(super) fn trace(
        &mut self,
        node: usize,
        trace: Trace,
        at: SurroundingsId,
    ) -> Result<Vec<u32>, TooLong> {
        let mut words = Vec::new();
        for input in 0..self.naive.nodes[node].inputs.len() {
            words.extend(self.input(node, input, at)?);
        }
        let state = self.state(Effect::from(trace).reads(), at)?;
        let vector = |from: usize| std::array::from_fn(|k| f32::from_bits(words[from + k]));
        let (origin, direction) = match trace {
            Trace::Transparent => (state.point, state.direction),
            Trace::Probe => (vector(3), vector(0)),
            _ => (state.point, vector(0)),
        };
        let site = self.site(&self.naive.nodes[node].name, at);
        let mut answers = [Answer::default()];
        self.renderer.trace(trace, &[Ray { state, origin, direction, site }], &mut answers);
        let [Answer { color, ok, hit, distance }] = answers;
        let truth = |value: bool| if value { u32::MAX } else { 0 };
        let [r, g, b, a] = color.map(f32::to_bits);
        Ok(vec![r, g, b, a, truth(ok), truth(hit), distance.to_bits()])
    }

    pub(super) fn read_texture(
        &mut self,
        node: usize,
        at: SurroundingsId,
    ) -> Result<Vec<u32>, TooLong> {
        let naive = self.naive;
        let of = &naive.nodes[node];
        let given = of.inputs.iter().find_map(|binding| match binding {
            Binding::Literal(Literal::Texture(texture)) => Some(texture),
            Binding::Parameter(parameter) => match &naive.parameters[*parameter] {
                Literal::Texture(texture) => Some(texture),
                _ => None,
            },
            _ => None,
        });
        let Some(Some(texture)) = given else { return Ok(vec![0; 5]) };
        let texture = self.renderer.texture(texture);
        let mut coordinates = [0.0; 2];
        for (k, coordinate) in coordinates.iter_mut().enumerate() {
            *coordinate = f32::from_bits(self.input(node, k + 1, at)?[0]);
        }
        let mut colors = [None];
        self.renderer.read_texture(texture, &[coordinates], &mut colors);
        let [r, g, b, a] = colors[0].unwrap_or_default().map(f32::to_bits);
        Ok(vec![r, g, b, a, if colors[0].is_some() { u32::MAX } else { 0 }])
    }

    pub(super) fn light_color(&mut self, at: SurroundingsId) -> Result<Vec<u32>, TooLong> {
        let innermost = self.way_to(at).into_iter().rev().find_map(|of| {
            match self.surroundings[of].inside_of {
                Inside::Iteration { list, number, sample } => {
                    Some((of, list, number, sample.token))
                }
                Inside::Point | Inside::Scope { .. } => None,
            }
        });
        let (iteration, list, number, token) =
            innermost.expect("random graphs ask inside loops only");
        let outside = self.surroundings[iteration].outside;
        let shared = self.effective(outside, &[Field::Point, Field::NormalGeom].into());
        let color = match self.light_colors.get(&(list, number, shared)) {
            Some(color) => *color,
            None => {
                let state = self.state(&[Field::Point, Field::NormalGeom], at)?;
                let mut colors = [[0.0; 3]];
                self.renderer.light_colors(&[state], &[token], &mut colors);
                self.light_colors.insert((list, number, shared), colors[0]);
                colors[0]
            }
        };
        let [r, g, b] = color.map(f32::to_bits);
        Ok(vec![r, g, b, 1.0_f32.to_bits()])
    }

    pub(super) fn light_loop(
        &mut self,
        node: usize,
        at: SurroundingsId,
    ) -> Result<Vec<u32>, TooLong> {
        let naive = self.naive;
        let of = &naive.nodes[node];
        let inputs = &naive.library.signature(of.node_type).inputs;
        let lights = inputs.iter().position(|input| input.value_type == Type::Lights);
        let names = match lights.map(|input| &of.inputs[input]) {
            Some(Binding::Literal(Literal::Lights(names))) => names.clone(),
            Some(Binding::Parameter(parameter)) => match &naive.parameters[*parameter] {
                Literal::Lights(names) => names.clone(),
                Literal::Light(name) => vec![name.clone()],
                other => panic!("{other:?} for lights"),
            },
            _ => Vec::new(),
        };
        let body = inputs.iter().position(|input| input.scoped).expect("a loop has a body");
        let list = self.renderer.light_list(&names);
        let state = self.state(&[Field::Point, Field::NormalGeom], at)?;
        let mut sum = [0.0_f32; 3];
        for number in 0..self.renderer.light_count(list) {
            let mut samples = [LightSample::default()];
            self.renderer.light_samples(list, number, &[state], &mut samples);
            let [sample] = samples;
            if sample.reachable {
                let inside = self.open(node, at, Inside::Iteration { list, number, sample });
                let color = self.input(node, body, inside)?;
                for (sum, word) in sum.iter_mut().zip(color) {
                    *sum += f32::from_bits(word);
                }
            }
        }
        let [r, g, b] = sum.map(f32::to_bits);
        Ok(vec![r, g, b, 1.0_f32.to_bits()])
    }
}
