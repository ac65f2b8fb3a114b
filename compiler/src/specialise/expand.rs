//! From views of nodes to instances: each (node, epoch) that can be demanded, built once, inputs
//! first. Works off an explicit stack, so that no chain is too long.

use std::collections::HashMap;

use crate::effects::Effect;
use crate::engine::lanes::Source;
use crate::graph::{Graph, Root};
use crate::nodes::{Code, Kind, Literal, NodeLibrary, Type};
use crate::state::{Field, RayType};

use super::epochs::path_key;
use super::reads::{LIGHT_LOOP_READS, light_fields, reads};
use super::views::{Resolved, Views, inconsistent};
use super::{
    Context, Demand, EpochId, EpochKind, Epochs, FieldSet, Guard, Instance, InstanceId,
    InstanceKind, LightTable, SpecialiseError, Specialised, Uniforms, internal,
};

/// Most instances of one root.
pub const MAX_INSTANCES: usize = 1 << 20;

/// Most light loops round an evaluation.
pub const MAX_NESTED_LOOPS: usize = 4;

/// Specialises `graph` for a root of it, a ray type, and the values of its parameters.
pub fn expand(
    graph: &Graph,
    library: &NodeLibrary,
    root: &Root,
    ray_type: RayType,
    values: &[Literal],
) -> Result<Specialised, SpecialiseError> {
    let views = Views::new(graph, library, root)?;
    let reads = reads(&views)?;
    let mut builder = Builder {
        views: &views,
        reads: &reads,
        ray_type,
        values,
        built: HashMap::new(),
        conversions: HashMap::new(),
        result: Specialised {
            instances: Vec::new(),
            epochs: Epochs::new(),
            uniforms: Uniforms::default(),
            fields: Vec::new(),
            reads_ray_type: false,
            slots: 0,
            light_lists: Vec::new(),
            tables: Vec::new(),
        },
    };
    builder.run()?;
    Ok(builder.result)
}

/// A node in an epoch.
type Key = (usize, EpochId);

/// A node that is built: its output words, and the instance to demand before reading them.
#[derive(Clone)]
struct Built {
    words: Vec<Source>,
    demand: Option<InstanceId>,
}

/// A node being built: what is known of its inputs so far.
struct Frame {
    key: Key,
    next: usize,
    /// The guard of input `next`, once it was looked at.
    guard: Option<GuardState>,
    words: Vec<Source>,
    demands: Vec<Demand>,
    /// The epoch opened for the scoped input, with the scope's or loop's own words.
    inside: Option<EpochId>,
}

#[derive(Clone)]
enum GuardState {
    Never,
    Always,
    Where(Guard),
}

struct Builder<'a> {
    views: &'a Views<'a>,
    reads: &'a [FieldSet],
    ray_type: RayType,
    values: &'a [Literal],
    built: HashMap<Key, Built>,
    conversions: HashMap<Source, InstanceId>,
    result: Specialised,
}

impl Builder<'_> {
    fn run(&mut self) -> Result<(), SpecialiseError> {
        let mut stack = vec![Frame::new((self.views.root(), 0))];
        while let Some(frame) = stack.last_mut() {
            if self.built.contains_key(&frame.key) {
                stack.pop();
                continue;
            }
            match self.advance(frame)? {
                Some(missing) => stack.push(Frame::new(missing)),
                None => {
                    let done = stack.pop();
                    if let Some(frame) = done {
                        self.finish(frame)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// Gathers inputs until one is missing, which is returned, or all are there.
    fn advance(&mut self, frame: &mut Frame) -> Result<Option<Key>, SpecialiseError> {
        let (view, epoch) = frame.key;
        let signature = self.views.signature(view);
        while frame.next < signature.inputs.len() {
            let input = frame.next;
            let to = self.views.input_type(view, input);
            if to == Type::Lights {
                frame.next += 1;
                continue;
            }
            let guard = match &frame.guard {
                Some(guard) => guard.clone(),
                None => self.guard(frame),
            };
            frame.guard = Some(guard.clone());
            if matches!(guard, GuardState::Never) {
                let zero = self.result.uniforms.constant(0);
                frame.words.extend(std::iter::repeat_n(zero, to.width()));
            } else {
                let scoped = signature.inputs[input].scoped;
                let at = if scoped { self.inside(frame)? } else { epoch };
                let value = match self.value(view, input, to, at)? {
                    Ok(value) => value,
                    Err(missing) => return Ok(Some(missing)),
                };
                frame.words.extend(&value.words);
                if let Some(source) = value.demand {
                    let guard = match guard {
                        GuardState::Where(guard) => Some(guard),
                        GuardState::Always | GuardState::Never => None,
                    };
                    frame.demands.push(Demand { source, guard });
                }
            }
            frame.next += 1;
            frame.guard = None;
        }
        Ok(None)
    }

    /// The guard of the frame's next input; decided now if it looks at uniform words only.
    fn guard(&mut self, frame: &Frame) -> GuardState {
        let view = frame.key.0;
        let Some(code) = self.views.overload(view).guards[frame.next] else {
            return GuardState::Always;
        };
        let zero = self.result.uniforms.constant(0);
        let mut words = frame.words.clone();
        words.resize(self.views.input_words(view), zero);
        let Some(inputs) = Uniforms::positions(&words) else {
            return GuardState::Where(Guard { code, words });
        };
        if self.result.uniforms.decide(code, inputs) {
            GuardState::Always
        } else {
            GuardState::Never
        }
    }

    /// The value of an input in an epoch, converted; or the node to build first.
    fn value(
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
            Resolved::State(field) => (self.field(field, epoch), field.value_type()),
            Resolved::Node { view: source, output } => {
                let from = self.views.output_type(source, output);
                if let Kind::Fields(fields) = &self.views.signature(source).kind {
                    (self.field(fields[output], epoch), from)
                } else {
                    let key = (source, self.result.epochs.effective(epoch, self.reads[source]));
                    let Some(built) = self.built.get(&key) else { return Ok(Err(key)) };
                    let first = self.views.output_offset(source, output);
                    let words = built.words[first..first + from.width()].to_vec();
                    (Built { words, demand: built.demand }, from)
                }
            }
        };
        self.converted(view, built, from, to).map(Ok)
    }

    fn literal(&mut self, literal: &Literal) -> Built {
        let words = literal.words();
        let words = words.into_iter().map(|word| self.result.uniforms.constant(word)).collect();
        Built { words, demand: None }
    }

    /// The words of a state field as seen in an epoch.
    fn field(&mut self, field: Field, epoch: EpochId) -> Built {
        let width = field.value_type().width() as u32;
        if let Some(changed) = self.result.epochs.changed_in(epoch, field) {
            return match &self.result.epochs.0[changed].kind {
                EpochKind::Scope { enter, fields } => {
                    let words = fields.iter().find(|(of, _)| *of == field);
                    let words = words.map(|(_, words)| words.clone()).unwrap_or_default();
                    Built { words, demand: *enter }
                }
                EpochKind::Loop { fields, .. } => {
                    let first = if field == Field::LightDistance { *fields + 3 } else { *fields };
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
        if field.is_of_light() {
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
        if from == Type::Integer {
            built = self.integer_to_scalar(built)?;
        }
        if to == Type::Color {
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
        let Source::Slot(slot) = word else { return 0 };
        let epochs = self.result.epochs.0.iter();
        epochs
            .enumerate()
            .find(|(_, epoch)| match epoch.kind {
                EpochKind::Loop { fields, .. } => (fields..fields + 4).contains(&slot),
                EpochKind::Point | EpochKind::Scope { .. } => false,
            })
            .map_or(0, |(id, _)| id)
    }

    fn of_instance(&self, id: InstanceId) -> Built {
        let instance = &self.result.instances[id];
        let words = (instance.output..instance.output + instance.outputs).map(Source::Slot);
        Built { words: words.collect(), demand: Some(id) }
    }

    fn slots(&mut self, count: u32) -> u32 {
        self.result.slots += count;
        self.result.slots - count
    }

    fn add(
        &mut self,
        name: &str,
        kind: InstanceKind,
        epoch: EpochId,
        demands: Vec<Demand>,
        words: Vec<Source>,
        outputs: u32,
    ) -> Result<InstanceId, SpecialiseError> {
        if self.result.instances.len() >= MAX_INSTANCES {
            let node = name.to_owned();
            return Err(SpecialiseError::TooManyInstances { limit: MAX_INSTANCES, node });
        }
        let name = format!("{}{name}", self.result.epochs.path(epoch));
        let output = self.slots(outputs);
        self.result.instances.push(Instance { name, kind, epoch, demands, words, output, outputs });
        Ok(self.result.instances.len() - 1)
    }

    /// The epoch in which the frame's scoped input is evaluated; opened the first time.
    fn inside(&mut self, frame: &mut Frame) -> Result<EpochId, SpecialiseError> {
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
            Kind::LightLoop => {
                if self.result.epochs.0[epoch].loops.len() >= MAX_NESTED_LOOPS {
                    return Err(SpecialiseError::TooManyLoops {
                        limit: MAX_NESTED_LOOPS,
                        node: name,
                    });
                }
                let list = self.light_list(view);
                let fields = self.slots(4);
                let kind = EpochKind::Loop { fields, list };
                self.result.epochs.open(epoch, &name, light_fields(), kind)
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

    fn light_list(&mut self, view: usize) -> usize {
        let names =
            (0..self.views.inputs(view)).find_map(|input| match self.views.resolve(view, input) {
                Resolved::Literal(Literal::Lights(names)) => Some(names),
                Resolved::Parameter(parameter) => match &self.values[parameter] {
                    Literal::Lights(names) => Some(names.clone()),
                    _ => None,
                },
                _ => None,
            });
        let names = names.unwrap_or_default();
        let known = self.result.light_lists.iter().position(|list| *list == names);
        known.unwrap_or_else(|| {
            self.result.light_lists.push(names);
            self.result.light_lists.len() - 1
        })
    }

    /// Makes the node of a frame whose inputs are all there.
    fn finish(&mut self, mut frame: Frame) -> Result<(), SpecialiseError> {
        let (view, epoch) = frame.key;
        let name = self.views.name(view).to_owned();
        let is_root = view == self.views.root();
        let built = match &self.views.signature(view).kind {
            Kind::Plain => {
                let Some(code) = self.views.overload(view).code else {
                    return Err(inconsistent(&name, "a plain node has no body"));
                };
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
            Kind::LightLoop => self.light_loop(frame, &name)?,
            Kind::Fields(_) => {
                return Err(inconsistent(&name, "the fields of the state are not evaluated"));
            }
        };
        self.built.insert((view, epoch), built);
        Ok(())
    }

    fn plain(
        &mut self,
        code: Code,
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
        let Frame { key: (view, epoch), words, mut demands, .. } = frame;
        let context = self.context(epoch, effect.reads(), &mut demands);
        let table = (effect == Effect::LightColor).then(|| self.table(epoch)).flatten();
        let key = path_key(self.result.epochs.0[epoch].path_key, name);
        let loops = self.result.epochs.0[epoch].loops.clone();
        let kind = InstanceKind::Request { effect, context, site: mix_key(key), loops, table };
        let outputs = (0..self.views.signature(view).outputs.len())
            .map(|output| self.views.output_type(view, output).width())
            .sum::<usize>();
        let id = self.add(name, kind, epoch, demands, words, outputs as u32)?;
        Ok(self.of_instance(id))
    }

    /// The table in which light colours asked for in `epoch` are kept.
    fn table(&mut self, epoch: EpochId) -> Option<usize> {
        let in_loop = self.result.epochs.innermost_loop(epoch)?;
        let EpochKind::Loop { list, .. } = self.result.epochs.0[in_loop].kind else { return None };
        // From the request outwards: a scope inside the loop that moves the point has its own table.
        let reads: FieldSet = LIGHT_LOOP_READS.into_iter().collect();
        let table = LightTable { list, epoch: self.result.epochs.effective(epoch, reads) };
        let known = self.result.tables.iter().position(|of| *of == table);
        Some(known.unwrap_or_else(|| {
            self.result.tables.push(table);
            self.result.tables.len() - 1
        }))
    }

    /// Fields that scopes round `epoch` changed, among those read; their makers are demanded too.
    fn context(&mut self, epoch: EpochId, reads: &[Field], demands: &mut Vec<Demand>) -> Context {
        let mut context = Vec::new();
        for &field in reads.iter().filter(|field| !field.is_of_light()) {
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

    fn light_loop(&mut self, mut frame: Frame, name: &str) -> Result<Built, SpecialiseError> {
        let inside = self.inside(&mut frame)?;
        let Frame { key: (_, epoch), words, mut demands, .. } = frame;
        let EpochKind::Loop { fields, list } = self.result.epochs.0[inside].kind else {
            return Err(inconsistent(name, "it opened no loop"));
        };
        let body = demands.pop().map(|demand| demand.source);
        let context = self.context(epoch, &LIGHT_LOOP_READS, &mut demands);
        let kind = InstanceKind::Loop { epoch: inside, list, fields, body, words, context };
        let id = self.add(name, kind, epoch, demands, Vec::new(), 4)?;
        Ok(self.of_instance(id))
    }
}

impl Frame {
    fn new(key: Key) -> Self {
        Self { key, next: 0, guard: None, words: Vec::new(), demands: Vec::new(), inside: None }
    }
}

/// A bijective mix of 64 bits in which every input bit moves half of the output's.
pub fn mix_key(mut key: u64) -> u64 {
    key ^= key >> 32;
    key = key.wrapping_mul(0xe9846af9b1a615d);
    key ^= key >> 32;
    key = key.wrapping_mul(0xe9846af9b1a615d);
    key ^ (key >> 28)
}
