//! What nodes ask of the renderer.

use crate::effects::{Answer, Effect, Lookup, Ray, Sampling, TextureId, Trace};
use crate::graph::Binding;
use crate::state::Field;
use crate::values::Literal;

use super::evaluation::Evaluation;
use super::nodes::TooLong;
use super::surroundings::{Inside, SurroundingsId};

/// What the colour of a light sample depends on.
const LIGHT_READS: [Field; 3] = [Field::Point, Field::NormalGeom, Field::InvNormal];

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
        let ray = Ray { point: 0, origin, direction, site };
        self.renderer.trace(trace, &[state], &[ray], &mut answers);
        let [Answer { color, ok, hit, distance }] = answers;
        let truth = |value: bool| if value { u32::MAX } else { 0 };
        let [r, g, b, a] = color.map(f32::to_bits);
        Ok(vec![r, g, b, a, truth(ok), truth(hit), distance.to_bits()])
    }

    /// What a node is given for an input that is known before shading; none where that is its default.
    fn known_before(&self, node: usize, input: usize) -> Option<&Literal> {
        match &self.naive.nodes[node].inputs[input] {
            Binding::Literal(literal) => Some(literal),
            Binding::Parameter(parameter) => Some(&self.naive.parameters[*parameter]),
            Binding::Default | Binding::Node { .. } => None,
        }
    }

    /// The texture a node is given as its first input.
    fn texture(&mut self, node: usize) -> Option<TextureId> {
        match self.known_before(node, 0) {
            Some(Literal::Texture(Some(texture))) => {
                let texture = texture.clone();
                Some(self.renderer.texture(&texture))
            }
            _ => None,
        }
    }

    pub(super) fn light_density(
        &mut self,
        node: usize,
        at: SurroundingsId,
    ) -> Result<Vec<u32>, TooLong> {
        let words = self.input(node, 0, at)?;
        let direction = std::array::from_fn(|k| f32::from_bits(words[k]));
        let mut densities = [0.0];
        self.renderer.light_density(&[direction], &mut densities);
        Ok(densities.map(f32::to_bits).to_vec())
    }

    pub(super) fn texture_size(&mut self, node: usize) -> Vec<u32> {
        let texture = self.texture(node);
        let size = texture.and_then(|texture| self.renderer.texture_size(texture));
        size.unwrap_or_default().to_vec()
    }

    pub(super) fn read_texture(
        &mut self,
        node: usize,
        at: SurroundingsId,
    ) -> Result<Vec<u32>, TooLong> {
        let number = |input: usize| match self.known_before(node, input) {
            Some(Literal::Integer(number)) => *number,
            _ => 0,
        };
        let sampling = Sampling::from_numbers(&[3, 4, 5].map(number));
        let Some(texture) = self.texture(node) else { return Ok(vec![0; 5]) };
        let mut lookup = Lookup::default();
        for (axis, place) in lookup.uv.iter_mut().enumerate() {
            *place = f32::from_bits(self.input(node, 1 + axis, at)?[0]);
        }
        if sampling.has_default() {
            let words = self.input(node, 6, at)?;
            lookup.default = std::array::from_fn(|k| f32::from_bits(words[k]));
        }
        if sampling.is_filtered() {
            for (k, number) in lookup.footprint.as_flattened_mut().iter_mut().enumerate() {
                *number = f32::from_bits(self.input(node, 7 + k, at)?[0]);
            }
        }
        let mut colors = [None];
        self.renderer.read_texture(texture, sampling, &[lookup], &mut colors);
        let [r, g, b, a] = colors[0].unwrap_or_default().map(f32::to_bits);
        Ok(vec![r, g, b, a, if colors[0].is_some() { u32::MAX } else { 0 }])
    }

    pub(super) fn light_color(&mut self, at: SurroundingsId) -> Result<Vec<u32>, TooLong> {
        let innermost = self.way_to(at).into_iter().rev().find_map(|of| {
            match self.surroundings[of].inside_of {
                Inside::Turn { number, light: Some((list, token)), .. } => {
                    Some((list, number, token))
                }
                Inside::Point | Inside::Scope { .. } | Inside::Turn { .. } => None,
            }
        });
        let (list, number, token) = innermost.expect("random graphs ask inside loops only");
        // A scope inside the loop that moves the point asks for itself.
        let shared = self.effective(at, &LIGHT_READS.into());
        let color = match self.light_colors.get(&(list, number, shared)) {
            Some(color) => *color,
            None => {
                let state = self.state(&LIGHT_READS, at)?;
                let mut colors = [[0.0; 3]];
                self.renderer.light_colors([state][..].into(), &[token], &mut colors);
                self.light_colors.insert((list, number, shared), colors[0]);
                colors[0]
            }
        };
        let [r, g, b] = color.map(f32::to_bits);
        Ok(vec![r, g, b, 1.0_f32.to_bits()])
    }
}
