//! Roots at a point.

use std::collections::HashMap;

use crate::effects::Renderer;
use crate::engine::Shaded;
use crate::graph::{Binding, Root};
use crate::state::State;
use crate::values::{Literal, Type};

use super::evaluation::Evaluation;
use super::nodes::{Naive, TooLong};
use super::surroundings::{Inside, Surroundings};
use crate::testing::reads::Fields;

impl Naive<'_> {
    /// Shades one point, in at most so many evaluations.
    pub fn shade(
        &self,
        root: &Root,
        point: &State,
        renderer: &mut dyn Renderer,
        steps: &mut usize,
    ) -> Result<Shaded, TooLong> {
        let point_itself = Surroundings {
            outside: 0,
            changes: Fields::new(),
            name: String::new(),
            inside_of: Inside::Point,
        };
        let mut evaluation = Evaluation {
            naive: self,
            point,
            renderer,
            surroundings: vec![point_itself],
            kept: HashMap::new(),
            light_colors: HashMap::new(),
            steps,
        };
        let ok = match &root.ok {
            Binding::Default => vec![u32::MAX],
            given => evaluation.given(given, Type::Boolean, 0)?,
        };
        if ok[0] == 0 {
            return Ok(Shaded { color: [0.0; 4], ok: false });
        }
        let color = match &root.color {
            Binding::Default => Literal::Color([0.0, 0.0, 0.0, 1.0]).words(),
            given => evaluation.given(given, Type::Color, 0)?,
        };
        Ok(Shaded { color: std::array::from_fn(|at| f32::from_bits(color[at])), ok: true })
    }
}
