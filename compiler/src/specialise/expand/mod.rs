//! From views of nodes to instances: each (node, epoch) that can be demanded, built once, inputs
//! first. Works off an explicit stack, so that no chain is too long.

mod finish;
mod values;

use cranelift_entity::PrimaryMap;
use rustc_hash::FxHashMap;

use crate::graph::{Graph, Root};
use crate::state::{FieldSet, RayType};
use crate::storage::Source;
use crate::values::Literal;

use super::decisions::{Decisions, Fold};
use super::reads::reads;
use super::views::Views;
use super::{
    Demand, EpochId, Epochs, Guard, Instance, InstanceId, InstanceKind, SpecialiseError,
    Specialised, Uniforms, verify,
};

/// Most instances of one root.
pub const MAX_INSTANCES: usize = 1 << 20;

/// Most loops round an evaluation.
pub const MAX_NESTED_LOOPS: usize = 4;

/// Which inputs are asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Asking {
    /// Those whose guards hold.
    #[default]
    Guarded,
    /// All: what every guard would save is done, and thrown away. No value changes, for no body looks at an
    /// input whose guard does not hold.
    All,
}

/// Specialises `graph` for a root of it, a ray type, and the values of its parameters.
pub fn expand(
    graph: &Graph,
    root: &Root,
    ray_type: RayType,
    values: &[Literal],
) -> Result<Specialised, SpecialiseError> {
    expand_asking(graph, root, ray_type, values, Asking::Guarded)
}

/// The same, asking for all inputs or for those whose guards hold.
pub fn expand_asking(
    graph: &Graph,
    root: &Root,
    ray_type: RayType,
    values: &[Literal],
    asking: Asking,
) -> Result<Specialised, SpecialiseError> {
    let views = Views::new(graph, root)?;
    let reads = reads(&views)?;
    let mut builder = Builder {
        views: &views,
        reads: &reads,
        ray_type,
        values,
        asking,
        built: FxHashMap::default(),
        conversions: FxHashMap::default(),
        result: Specialised {
            instances: PrimaryMap::new(),
            epochs: Epochs::new(),
            uniforms: Uniforms::default(),
            fields: Vec::new(),
            reads_ray_type: false,
            slots: 0,
            light_lists: PrimaryMap::new(),
            tables: PrimaryMap::new(),
            textures: PrimaryMap::new(),
            decisions: Decisions::default(),
        },
    };
    builder.run()?;
    let mut built = vec![false; views.len()];
    builder.built.keys().for_each(|&(view, _)| built[view] = true);
    builder.result.decisions.built = built;
    if cfg!(debug_assertions)
        && let Err(what) = verify(&builder.result)
    {
        panic!("after specialise: {what}");
    }
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
    /// The epoch opened for the scoped input.
    inside: Option<EpochId>,
    /// What a loop takes: its words and demands before those of the body.
    taken: (Vec<Source>, Vec<Demand>),
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
    asking: Asking,
    built: FxHashMap<Key, Built>,
    conversions: FxHashMap<Source, InstanceId>,
    result: Specialised,
}

impl Builder<'_> {
    fn run(&mut self) -> Result<(), SpecialiseError> {
        let mut stack = vec![Frame::new((self.views.root(), EpochId::POINT))];
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
            if to.is_in_code() {
                frame.next += 1;
                continue;
            }
            if signature.inputs[input].fixed {
                let number = self.fixed(view, input)?;
                frame.words.push(self.result.uniforms.constant(number as u32));
                frame.next += 1;
                continue;
            }
            let guard = match &frame.guard {
                Some(guard) => guard.clone(),
                None => self.guard(frame)?,
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
    fn guard(&mut self, frame: &Frame) -> Result<GuardState, SpecialiseError> {
        let view = frame.key.0;
        let Some(code) = self.views.overload(view).guards[frame.next] else {
            return Ok(GuardState::Always);
        };
        if self.asking == Asking::All {
            return Ok(GuardState::Always);
        }
        let code = self.settled(view, code)?;
        let zero = self.result.uniforms.constant(0);
        let mut words = frame.words.clone();
        words.resize(self.views.input_words(view), zero);
        // What it does not look at would only hide that it is known, or known early.
        let reads = code.recorded().reads(words.len());
        for (word, read) in words.iter_mut().zip(&reads) {
            if !*read && matches!(word, Source::Slot(_)) {
                *word = zero;
            }
        }
        let Some(inputs) = Uniforms::positions(&words) else {
            return Ok(GuardState::Where(Guard { code, words }));
        };
        if self.result.uniforms.decide(code, inputs.clone()) {
            return Ok(GuardState::Always);
        }
        let fold = Fold { view, input: frame.next, words: inputs, looks: reads };
        self.result.decisions.folds.push(fold);
        Ok(GuardState::Never)
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
        let instance = Instance { name, kind, epoch, demands, words, output, outputs };
        Ok(self.result.instances.push(instance))
    }
}

impl Frame {
    fn new(key: Key) -> Self {
        Self {
            key,
            next: 0,
            guard: None,
            words: Vec::new(),
            demands: Vec::new(),
            inside: None,
            taken: Default::default(),
        }
    }
}
