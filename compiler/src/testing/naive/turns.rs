//! Loops, turn by turn.

use crate::effects::{LightMode, LightSample};
use crate::graph::Binding;
use crate::specialise::mix_key;
use crate::state::{Field, Iterated, MOST_TURNS, Reduction};
use crate::values::{Literal, Type};

use super::evaluation::Evaluation;
use super::nodes::TooLong;
use super::surroundings::{Inside, SurroundingsId};

impl Evaluation<'_> {
    /// The names of the lights a loop runs over.
    fn lights(&self, node: usize) -> Vec<String> {
        let naive = self.naive;
        let of = &naive.nodes[node];
        let inputs = &naive.library.signature(of.node_type).inputs;
        let lights = inputs.iter().position(|input| input.value_type == Type::Lights);
        match lights.map(|input| &of.inputs[input]) {
            Some(Binding::Literal(Literal::Lights(names))) => names.clone(),
            Some(Binding::Parameter(parameter)) => match &naive.parameters[*parameter] {
                Literal::Lights(names) => names.clone(),
                Literal::Light(name) => vec![name.clone()],
                other => panic!("{other:?} for lights"),
            },
            _ => Vec::new(),
        }
    }

    /// What each turn of a loop is, as far as the point takes part in it; and how many turns there are.
    fn all_turns(
        &mut self,
        node: usize,
        iterated: Iterated,
        at: SurroundingsId,
    ) -> Result<(Vec<Inside>, usize), TooLong> {
        let mut turns = Vec::new();
        let number = |x: f32| vec![x.to_bits()];
        if iterated == Iterated::Samples {
            let count = (self.input(node, 0, at)?[0] as i32).clamp(0, MOST_TURNS) as usize;
            let site = self.site(&self.naive.nodes[node].name, at);
            for turn in 0..count {
                let key = mix_key(site ^ mix_key(turn as u64 + 1));
                let key = mix_key(self.point.path ^ key);
                let drawn = |bits: u64| number((bits & 0xff_ffff) as f32 / 16_777_216.0);
                let fields = vec![
                    (Field::SampleIndex, vec![turn as u32]),
                    (Field::SampleU, drawn(key >> 40)),
                    (Field::SampleV, drawn(key >> 16)),
                ];
                turns.push(Inside::Turn { number: turn, light: None, fields });
            }
            return Ok((turns, count));
        }
        let mode = LightMode::from_number(self.input(node, 1, at)?[0] as i32);
        let list = self.renderer.light_list(&self.lights(node), mode);
        let state = self.state(&[Field::Point, Field::NormalGeom], at)?;
        let count = self.renderer.light_count(list);
        for turn in 0..count {
            let mut samples = [LightSample::default()];
            self.renderer.light_samples(list, turn, [state][..].into(), &mut samples);
            let [sample] = samples;
            if sample.reachable {
                let fields = vec![
                    (Field::LightDirection, sample.direction.map(f32::to_bits).to_vec()),
                    (Field::LightDistance, number(sample.distance)),
                    (Field::LightDensity, number(sample.density)),
                ];
                turns.push(Inside::Turn {
                    number: turn,
                    light: Some((list, sample.token)),
                    fields,
                });
            }
        }
        Ok((turns, count))
    }

    /// The value of a loop.
    pub(super) fn turns(
        &mut self,
        node: usize,
        iterated: Iterated,
        reduction: Reduction,
        at: SurroundingsId,
    ) -> Result<Vec<u32>, TooLong> {
        let naive = self.naive;
        let signature = naive.library.signature(naive.nodes[node].node_type);
        let body = signature.inputs.iter().position(|input| input.scoped);
        let body = body.expect("a loop has a body");
        let (turns, count) = self.all_turns(node, iterated, at)?;
        let mut values = Vec::new();
        for turn in turns {
            let inside = self.open(node, at, turn);
            let words = self.input(node, body, inside)?;
            values.push(words.into_iter().map(f32::from_bits).collect::<Vec<f32>>());
        }
        let value_type = naive.value_type(&naive.nodes[node], signature.outputs[0].value_type);
        let mut all: Vec<f32> = (0..value_type.width())
            .map(|at| {
                let each = values.iter().map(|value| value[at]);
                match reduction {
                    Reduction::Sum => each.fold(0.0, |sum, x| sum + x),
                    Reduction::Mean if count == 0 => 0.0,
                    Reduction::Mean => each.fold(0.0, |sum, x| sum + x) / count as f32,
                    Reduction::Maximum => {
                        let greatest =
                            each.fold(f32::NEG_INFINITY, |most, x| if x > most { x } else { most });
                        if greatest == f32::NEG_INFINITY { 0.0 } else { greatest }
                    }
                    Reduction::Over => {
                        let (mut sum, mut alpha) = (0.0_f32, 0.0_f32);
                        for value in &values {
                            sum += (1.0 - alpha) * value[at];
                            alpha += (1.0 - alpha) * value[3];
                        }
                        sum
                    }
                }
            })
            .collect();
        if value_type == Type::Color && reduction != Reduction::Over {
            all[3] = 1.0;
        }
        Ok(all.into_iter().map(f32::to_bits).collect())
    }
}
