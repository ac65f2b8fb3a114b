//! Making instances of nodes whose inputs are all there, and opening scopes and loops.

use cranelift_entity::{EntityRef, PrimaryMap};

use crate::effects::{Asked, Effect, LightMode, NamedLights, Sampling};
use crate::kernels::BodyForms;
use crate::nodes::Kind;
use crate::specialise::keys::{mix_key, path_key};
use crate::specialise::views::{Resolved, inconsistent};
use crate::specialise::{
    Context, Demand, EpochId, EpochKind, InstanceKind, LightListId, LightTable, SpecialiseError,
    Subject, TexturePosition, Turns, Uniforms,
};
use crate::state::{Field, FieldSet, Iterated, Reduction};
use crate::storage::Source;
use crate::values::Literal;

use super::{Builder, Built, Frame, MAX_NESTED_LOOPS};

impl Builder<'_> {
    /// The epoch in which the frame's scoped input is evaluated; opened the first time.
    pub(super) fn inside(&mut self, frame: &mut Frame) -> Result<EpochId, SpecialiseError> {
        if let Some(inside) = frame.inside {
            return Ok(inside);
        }
        let (view, epoch) = frame.key;
        let name = self.views.name(view).to_owned();
        let inside = match &self.views.signature(view).kind {
            Kind::Scope(fields) => {
                let entered = self.enter(frame, fields)?;
                let changes = fields.iter().copied().collect();
                self.result.epochs.open(epoch, &name, changes, entered)
            }
            Kind::Loop(iterated, _) => {
                if self.result.epochs.0[epoch].loops.len() >= MAX_NESTED_LOOPS {
                    return Err(SpecialiseError::TooManyLoops {
                        limit: MAX_NESTED_LOOPS,
                        node: name,
                    });
                }
                frame.taken =
                    (std::mem::take(&mut frame.words), std::mem::take(&mut frame.demands));
                let list = match iterated {
                    Iterated::Lights => Some(self.light_list(view)?),
                    Iterated::Samples => None,
                };
                let fields = self.slots(iterated.words() as u32);
                let kind = EpochKind::Loop { iterated: *iterated, fields, list };
                self.result.epochs.open(epoch, &name, iterated.provides().collect(), kind)
            }
            _ => return Err(inconsistent(&name, "it has a scoped input but opens no scope")),
        };
        frame.inside = Some(inside);
        Ok(inside)
    }

    /// The body of a scope: an instance, or uniform words, that yields the changed fields.
    fn enter(&mut self, frame: &mut Frame, fields: &[Field]) -> Result<EpochKind, SpecialiseError> {
        let (view, epoch) = frame.key;
        let name = self.views.name(view).to_owned();
        let Some(code) = self.views.overload(view).code else {
            return Err(inconsistent(&name, "a scope has no body"));
        };
        let code = self.settled(view, code)?;
        let zero = self.result.uniforms.constant(0);
        let mut words = std::mem::take(&mut frame.words);
        words.resize(self.views.input_words(view), zero);
        let demands = std::mem::take(&mut frame.demands);
        let changed = match Uniforms::positions(&words) {
            Some(inputs) if demands.is_empty() => {
                Built { words: self.result.uniforms.compute(code, inputs), demand: None }
            }
            _ => {
                let kind = InstanceKind::Plain(code);
                let outputs = code.outputs as u32;
                let id = self.add(&name, kind, epoch, demands, words, outputs)?;
                self.of_instance(id)
            }
        };
        let mut rest = changed.words.as_slice();
        let mut by_field = Vec::new();
        for &field in fields {
            let (words, after) = rest.split_at(field.value_type().width());
            by_field.push((field, words.to_vec()));
            rest = after;
        }
        Ok(EpochKind::Scope { enter: changed.demand, fields: by_field })
    }

    /// What the inputs of a view are given by literals and parameters.
    fn given(&self, view: usize) -> impl Iterator<Item = Literal> {
        (0..self.views.inputs(view)).filter_map(move |input| {
            match self.views.resolve(view, input) {
                Resolved::Literal(literal) => Some(literal),
                Resolved::Parameter(parameter) => Some(self.values[parameter].clone()),
                Resolved::State(_) | Resolved::Node { .. } => None,
            }
        })
    }

    /// The texture a view reads; none where none is given.
    fn texture(&mut self, view: usize) -> Option<TexturePosition> {
        let texture = self.given(view).find_map(|literal| match literal {
            Literal::Texture(texture) => texture,
            _ => None,
        })?;
        Some(found_or_pushed(&mut self.result.textures, texture))
    }

    /// How a view reads a texture. What is known before shading is no argument of its request, and
    /// neither are words that cannot matter then.
    fn sampling(
        &mut self,
        view: usize,
        words: &mut Vec<Source>,
    ) -> Result<Sampling, SpecialiseError> {
        let fixed = self.views.fixed_words(view);
        let mut numbers = Vec::new();
        for &(input, _) in &fixed {
            numbers.push(self.fixed(view, input)?);
        }
        for &(_, word) in fixed.iter().rev() {
            words.remove(word);
        }
        let sampling = Sampling::from_numbers(&numbers);
        if !fixed.is_empty() {
            words.truncate(sampling.words());
        }
        Ok(sampling)
    }

    fn light_list(&mut self, view: usize) -> Result<LightListId, SpecialiseError> {
        let names = self.given(view).find_map(|literal| match literal {
            Literal::Lights(names) => Some(names),
            Literal::Light(name) => Some(vec![name]),
            _ => None,
        });
        let mode = match self.views.fixed_words(view).first() {
            Some(&(input, _)) => LightMode::from_number(self.fixed(view, input)?),
            None => LightMode::default(),
        };
        let lights = NamedLights::new(names.unwrap_or_default(), mode);
        Ok(found_or_pushed(&mut self.result.light_lists, lights))
    }

    /// Makes the node of a frame whose inputs are all there.
    pub(super) fn finish(&mut self, mut frame: Frame) -> Result<(), SpecialiseError> {
        let (view, epoch) = frame.key;
        let name = self.views.name(view).to_owned();
        let is_root = view == self.views.root();
        let built = match &self.views.signature(view).kind {
            Kind::Plain => {
                let Some(code) = self.views.overload(view).code else {
                    return Err(inconsistent(&name, "a plain node has no body"));
                };
                let code = self.settled(view, code)?;
                self.plain(code, frame, &name, is_root)?
            }
            Kind::Request(effect) => self.request(*effect, frame, &name)?,
            Kind::Scope(_) => {
                if frame.inside.is_none() {
                    return Err(inconsistent(&name, "a scope has no scoped input"));
                }
                // What is left in the frame came from the scoped input, which comes last.
                Built {
                    demand: frame.demands.pop().map(|demand| demand.source),
                    words: frame.words,
                }
            }
            Kind::Loop(_, reduction) => self.turns(frame, *reduction, &name)?,
            Kind::List(_) => {
                return Err(inconsistent(
                    &name,
                    "the checker puts other nodes in the place of lists",
                ));
            }
            Kind::Fields(_) => {
                return Err(inconsistent(&name, "the fields of the state are not evaluated"));
            }
        };
        self.built.insert((view, epoch), built);
        Ok(())
    }

    fn plain(
        &mut self,
        code: BodyForms,
        frame: Frame,
        name: &str,
        is_root: bool,
    ) -> Result<Built, SpecialiseError> {
        let foldable = frame.demands.is_empty() && !is_root;
        if let (Some(inputs), true) = (Uniforms::positions(&frame.words), foldable) {
            let words = self.result.uniforms.compute(code, inputs);
            return Ok(Built { words, demand: None });
        }
        let Frame { key: (_, epoch), words, demands, .. } = frame;
        let outputs = code.outputs as u32;
        let id = self.add(name, InstanceKind::Plain(code), epoch, demands, words, outputs)?;
        Ok(self.of_instance(id))
    }

    fn request(
        &mut self,
        effect: Effect,
        frame: Frame,
        name: &str,
    ) -> Result<Built, SpecialiseError> {
        let Frame { key: (view, epoch), mut words, mut demands, .. } = frame;
        let sampling = self.sampling(view, &mut words)?;
        let subject = match effect.asked() {
            Asked::Rays(_) | Asked::LightDensity => Some(Subject::Point),
            Asked::Texels | Asked::TextureSize => {
                self.texture(view).map(|texture| Subject::Texture(texture, sampling))
            }
            Asked::LightColors => self.light(effect, epoch),
        };
        let Some(subject) = subject else {
            self.result.decisions.about_nothing.push(view);
            let words = effect.unasked().into_iter();
            let words = words.map(|word| self.result.uniforms.constant(word)).collect();
            return Ok(Built { words, demand: None });
        };
        let context = self.context(epoch, effect.reads(), &mut demands);
        let key = path_key(self.result.epochs.0[epoch].path_key, name);
        let loops = self.result.epochs.0[epoch].loops.clone();
        let kind = InstanceKind::Request { effect, context, site: mix_key(key), loops, subject };
        let outputs = effect.answer_words() as u32;
        let id = self.add(name, kind, epoch, demands, words, outputs)?;
        Ok(self.of_instance(id))
    }

    /// The light sample asked about in `epoch`, and the table in which its colours are kept.
    fn light(&mut self, effect: Effect, epoch: EpochId) -> Option<Subject<EpochId>> {
        let (of, list) = self.result.epochs.innermost_lights(epoch)?;
        // From the request outwards: a scope inside the loop that moves the point has its own table.
        let reads = effect.reads().iter().copied();
        let reads: FieldSet = reads.filter(|field| field.of_loop().is_none()).collect();
        let table = LightTable { list, epoch: self.result.epochs.effective(epoch, reads) };
        let table = found_or_pushed(&mut self.result.tables, table);
        Some(Subject::Light { of, table })
    }

    /// Fields that scopes round `epoch` changed, among those read; their makers are demanded too.
    fn context(&mut self, epoch: EpochId, reads: &[Field], demands: &mut Vec<Demand>) -> Context {
        let mut context = Vec::new();
        for &field in reads.iter().filter(|field| field.of_loop().is_none()) {
            if self.result.epochs.changed_in(epoch, field).is_none() {
                continue;
            }
            let built = self.field(field, epoch);
            if let Some(source) = built.demand {
                demands.push(Demand { source, guard: None });
            }
            context.push((field, built.words));
        }
        context
    }

    fn turns(
        &mut self,
        mut frame: Frame,
        reduction: Reduction,
        name: &str,
    ) -> Result<Built, SpecialiseError> {
        let inside = self.inside(&mut frame)?;
        let Frame { key: (view, epoch), words, demands: of_body, taken, .. } = frame;
        let (taken, mut demands) = taken;
        let EpochKind::Loop { iterated, fields, list } = self.result.epochs.0[inside].kind else {
            return Err(inconsistent(name, "it opened no loop"));
        };
        let turns = match (iterated, list, taken.first()) {
            (Iterated::Lights, Some(list), _) => Turns::Lights { list },
            (Iterated::Samples, _, Some(&count)) => {
                let outer = &self.result.epochs.0[epoch];
                let site = mix_key(path_key(outer.path_key, name));
                Turns::Samples { count, site, loops: outer.loops.clone() }
            }
            _ => return Err(inconsistent(name, "it lacks what its loop takes")),
        };
        let body = of_body.first().map(|demand| demand.source);
        let value_type = self.views.output_type(view, 0);
        let context = self.context(epoch, iterated.reads(), &mut demands);
        let (epoch_of_body, outputs) = (inside, value_type.width() as u32);
        let kind = InstanceKind::Loop {
            epoch: epoch_of_body,
            turns,
            reduction,
            value_type,
            fields,
            body,
            words,
            context,
        };
        let id = self.add(name, kind, epoch, demands, Vec::new(), outputs)?;
        Ok(self.of_instance(id))
    }
}

/// Where `value` stands, put at the end if it stands nowhere.
fn found_or_pushed<K: EntityRef, V: PartialEq>(all: &mut PrimaryMap<K, V>, value: V) -> K {
    let known = all.iter().find_map(|(at, of)| (*of == value).then_some(at));
    known.unwrap_or_else(|| all.push(value))
}
