//! Values of inputs: literals, parameters, state fields and outputs, converted to the type due.

use crate::kernels::BodyForms;
use crate::nodes::Kind;
use crate::specialise::views::{Resolved, inconsistent};
use crate::specialise::{
    Demand, EpochId, EpochKind, InstanceId, InstanceKind, SpecialiseError, Uniforms, internal,
};
use crate::state::Field;
use crate::storage::Source;
use crate::values::{Literal, Type};

use super::{Builder, Built, Key};

impl Builder<'_> {
    /// The value of an input in an epoch, converted; or the node to build first.
    pub(super) fn value(
        &mut self,
        view: usize,
        input: usize,
        to: Type,
        epoch: EpochId,
    ) -> Result<Result<Built, Key>, SpecialiseError> {
        let (built, from) = match self.views.resolve(view, input) {
            Resolved::Literal(literal) => (self.literal(&literal), literal.value_type()),
            Resolved::Parameter(parameter) => {
                let value = &self.values[parameter];
                let words = self.result.uniforms.parameter(parameter, value);
                (Built { words, demand: None }, value.value_type())
            }
            Resolved::State(field) => (self.read_by(view, field, epoch), field.value_type()),
            Resolved::Node { view: source, output } => {
                let from = self.views.output_type(source, output);
                if let Kind::Fields(fields) = &self.views.signature(source).kind {
                    (self.read_by(view, fields[output], epoch), from)
                } else {
                    let key = (source, self.result.epochs.effective(epoch, self.reads[source]));
                    let Some(built) = self.built.get(&key) else { return Ok(Err(key)) };
                    let first = self.views.output_offset(source, output)?;
                    let words = built.words[first..first + from.width()].to_vec();
                    (Built { words, demand: built.demand }, from)
                }
            }
        };
        self.converted(view, built, from, to).map(Ok)
    }

    /// The number an input known before shading has: the code is for it alone.
    pub(super) fn fixed(&mut self, view: usize, input: usize) -> Result<i32, SpecialiseError> {
        let declared = &self.views.signature(view).inputs[input];
        let literal = match self.views.resolve(view, input) {
            Resolved::Literal(literal) => Some(literal),
            Resolved::Parameter(parameter) => {
                self.result.uniforms.fix(parameter, &self.values[parameter]);
                Some(self.values[parameter].clone())
            }
            Resolved::State(_) | Resolved::Node { .. } => None,
        };
        match literal {
            Some(Literal::Integer(number)) if declared.range.contains(&f64::from(number)) => {
                Ok(number)
            }
            _ => {
                let (name, range) = (&declared.name, &declared.range);
                let problem = format!("input `{name}` must be a known number in {range:?}");
                Err(inconsistent(self.views.name(view), &problem))
            }
        }
    }

    /// A body of a node, recorded for what the node knows before shading.
    pub(super) fn settled(
        &mut self,
        view: usize,
        code: BodyForms,
    ) -> Result<BodyForms, SpecialiseError> {
        let mut fixed = Vec::new();
        for (input, word) in self.views.fixed_words(view) {
            fixed.push((word, self.fixed(view, input)?));
        }
        Ok(code.with_fixed(&fixed))
    }

    fn literal(&mut self, literal: &Literal) -> Built {
        let words = literal.words();
        let words = words.into_iter().map(|word| self.result.uniforms.constant(word)).collect();
        Built { words, demand: None }
    }

    /// The words of a state field as a node reads them in an epoch.
    fn read_by(&mut self, view: usize, field: Field, epoch: EpochId) -> Built {
        // Fields that a scope or a loop gives are not the state's.
        let of_state = self.result.epochs.changed_in(epoch, field).is_none();
        if of_state && field.of_loop().is_none() && field != Field::RayType {
            self.result.decisions.readers.push((field, view));
        }
        self.field(field, epoch)
    }

    /// The words of a state field as seen in an epoch.
    pub(super) fn field(&mut self, field: Field, epoch: EpochId) -> Built {
        let width = field.value_type().width() as u32;
        if let Some(changed) = self.result.epochs.changed_in(epoch, field) {
            return match &self.result.epochs.0[changed].kind {
                EpochKind::Scope { enter, fields } => {
                    let words = fields.iter().find(|(of, _)| *of == field);
                    let words = words.map(|(_, words)| words.clone()).unwrap_or_default();
                    Built { words, demand: *enter }
                }
                EpochKind::Loop { iterated, fields, .. } => {
                    let first = *fields + iterated.offset(field) as u32;
                    let words = (first..first + width).map(Source::Slot).collect();
                    Built { words, demand: None }
                }
                EpochKind::Point => Built { words: Vec::new(), demand: None },
            };
        }
        if field == Field::RayType {
            self.result.reads_ray_type = true;
            let word = self.result.uniforms.constant(self.ray_type as i32 as u32);
            return Built { words: vec![word], demand: None };
        }
        if field.of_loop().is_some() {
            // The checker refuses this; without it the field reads as zero.
            let zero = self.result.uniforms.constant(0);
            return Built { words: vec![zero; width as usize], demand: None };
        }
        let known = self.result.fields.iter().find(|(of, _)| *of == field);
        let first = match known {
            Some(&(_, first)) => first,
            None => {
                let first = self.slots(width);
                self.result.fields.push((field, first));
                first
            }
        };
        Built { words: (first..first + width).map(Source::Slot).collect(), demand: None }
    }

    fn converted(
        &mut self,
        view: usize,
        mut built: Built,
        from: Type,
        to: Type,
    ) -> Result<Built, SpecialiseError> {
        if from == to {
            return Ok(built);
        }
        if !from.converts_to(to) {
            let problem = format!("a {} arrives where a {} is due", from.name(), to.name());
            return Err(inconsistent(self.views.name(view), &problem));
        }
        // A shader is called where its words are read: it is its color.
        if (from, to) == (Type::Color, Type::Shader) {
            return Ok(built);
        }
        if from == Type::Integer {
            built = self.integer_to_scalar(built)?;
        }
        if matches!(to, Type::Color | Type::Shader) {
            let (x, one) = (built.words[0], self.result.uniforms.constant(1.0_f32.to_bits()));
            built.words = vec![x, x, x, one];
        }
        Ok(built)
    }

    fn integer_to_scalar(&mut self, built: Built) -> Result<Built, SpecialiseError> {
        let code = internal::integer_to_scalar_code();
        if let Some(inputs) = Uniforms::positions(&built.words) {
            let words = self.result.uniforms.compute(code, inputs);
            return Ok(Built { words, demand: None });
        }
        let id = match self.conversions.get(&built.words[0]) {
            Some(&id) => id,
            None => {
                let epoch = built.demand.map_or_else(
                    || self.epoch_of_slot(built.words[0]),
                    |source| self.result.instances[source].epoch,
                );
                let demands =
                    built.demand.iter().map(|&source| Demand { source, guard: None }).collect();
                let word = built.words[0];
                let kind = InstanceKind::Plain(code);
                let id = self.add("(integer_to_scalar)", kind, epoch, demands, vec![word], 1)?;
                self.conversions.insert(word, id);
                id
            }
        };
        Ok(self.of_instance(id))
    }

    /// The epoch of a slot no instance writes: a loop's field, or the point's.
    fn epoch_of_slot(&self, word: Source) -> EpochId {
        let Source::Slot(slot) = word else { return EpochId::POINT };
        let mut epochs = self.result.epochs.0.iter();
        epochs
            .find(|(_, epoch)| match epoch.kind {
                EpochKind::Loop { iterated, fields, .. } => {
                    (fields..fields + iterated.words() as u32).contains(&slot)
                }
                EpochKind::Point | EpochKind::Scope { .. } => false,
            })
            .map_or(EpochId::POINT, |(id, _)| id)
    }

    pub(super) fn of_instance(&self, id: InstanceId) -> Built {
        let instance = &self.result.instances[id];
        let words = (instance.output..instance.output + instance.outputs).map(Source::Slot);
        Built { words: words.collect(), demand: Some(id) }
    }
}
