//! A specialised graph as the walk goes through it: in arrays, every word by its place.

use cranelift_entity::{EntityRef, PrimaryMap};

use crate::effects::Effect;
use crate::engine::options::Simd;
use crate::kernels::{BodyForms, NativePoint};
use crate::specialise::{
    Context, EpochId, Instance, InstanceId, InstanceKind, LightTableId, Specialised, Subject, Turns,
};
use crate::state::{Field, Reduction};
use crate::storage::Source;
use crate::values::Type;

/// A graph made ready for the walk. Its file holds the uniform words, then the slots, then a word for
/// the outcome of a guard.
#[derive(Debug)]
pub struct Code {
    pub(super) steps: PrimaryMap<InstanceId, Step>,
    pub(super) demands: Vec<Demand>,
    pub(super) guards: Vec<Guard>,
    /// Places of all the words that are read, span by span.
    pub(super) places: Vec<u32>,
    /// State fields in use, each with the place of its first word.
    pub(super) fields: Vec<(Field, usize)>,
    /// Words of the file.
    pub(super) words: usize,
    /// Most words a body reads.
    pub(super) most_inputs: usize,
    pub(super) epochs: usize,
    uniforms: usize,
    simd: Simd,
}

/// A stretch of an array.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) first: u32,
    pub(super) end: u32,
}

/// One evaluation, small: a walk goes through all of them for each point.
#[derive(Debug)]
pub(super) struct Step {
    pub(super) kind: Kind,
    pub(super) demands: Span,
    pub(super) words: Span,
    /// Place of its first output word.
    pub(super) output: u32,
    pub(super) outputs: u32,
    pub(super) epoch: EpochId,
}

/// How a step is evaluated.
#[derive(Debug)]
pub(super) enum Kind {
    Plain(Body),
    Request(Box<Request>),
    Loop(Box<Loop>),
}

/// A body in the form that is run.
#[derive(Debug)]
pub(super) enum Body {
    Native(NativePoint),
    Portable(Box<BodyForms>),
}

/// A step that may be evaluated first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Demand {
    pub(super) source: InstanceId,
    /// Of the source.
    pub(super) epoch: EpochId,
    /// Position of its guard.
    pub(super) guard: Option<u32>,
}

#[derive(Debug)]
pub(super) struct Guard {
    pub(super) body: Body,
    pub(super) words: Span,
}

/// Something the renderer answers.
#[derive(Debug)]
pub(super) struct Request {
    pub(super) effect: Effect,
    pub(super) subject: Subject<EpochId>,
    /// Where the answer about a light sample is kept, and in which epoch.
    pub(super) kept: Option<(LightTableId, EpochId)>,
    pub(super) site: u64,
    pub(super) loops: Vec<EpochId>,
    pub(super) scope: Scope,
}

/// A loop.
#[derive(Debug)]
pub(super) struct Loop {
    pub(super) epoch: EpochId,
    pub(super) turns: Turns<EpochId>,
    /// Place of the count, of a loop over samples.
    pub(super) count: usize,
    pub(super) reduction: Reduction,
    pub(super) value_type: Type,
    /// Place of the first field a turn provides.
    pub(super) fields: usize,
    pub(super) body: Option<InstanceId>,
    /// The body's words.
    pub(super) words: Span,
    pub(super) scope: Scope,
    /// Its epoch and those inside it.
    pub(super) renewed: Vec<EpochId>,
}

/// State fields that scopes changed, with the places of their words.
#[derive(Debug)]
pub(super) struct Scope(pub(super) Vec<(Field, Span)>);

impl Span {
    /// What it is of `array`.
    #[inline]
    pub(super) fn of<T>(self, array: &[T]) -> &[T] {
        &array[self.first as usize..self.end as usize]
    }
}

impl Code {
    /// Makes `graph` ready.
    pub fn new(graph: &Specialised, simd: Simd) -> Self {
        let uniforms = graph.uniforms.values().len();
        let slot = |(field, slot): &(Field, u32)| (*field, uniforms + *slot as usize);
        let mut code = Self {
            steps: PrimaryMap::with_capacity(graph.instances.len()),
            demands: Vec::new(),
            guards: Vec::new(),
            places: Vec::new(),
            fields: graph.fields.iter().map(slot).collect(),
            words: uniforms + graph.slots as usize + 1,
            most_inputs: 0,
            epochs: graph.epochs.0.len(),
            uniforms,
            simd,
        };
        for instance in graph.instances.values() {
            let step = code.step(graph, instance);
            code.steps.push(step);
        }
        code
    }

    /// The step whose output is that of the graph.
    pub(super) fn root(&self) -> InstanceId {
        InstanceId::new(self.steps.len() - 1)
    }

    /// Place of the outcome of a guard: the last.
    pub(super) fn outcome(&self) -> usize {
        self.words - 1
    }

    fn step(&mut self, graph: &Specialised, instance: &Instance) -> Step {
        let first = self.demands.len() as u32;
        for demand in &instance.demands {
            let guard = demand.guard.as_ref().map(|guard| {
                let guard =
                    Guard { body: self.body(&guard.code), words: self.inputs(&guard.words) };
                self.guards.push(guard);
                (self.guards.len() - 1) as u32
            });
            let epoch = graph.instances[demand.source].epoch;
            self.demands.push(Demand { source: demand.source, epoch, guard });
        }
        Step {
            demands: Span { first, end: self.demands.len() as u32 },
            kind: self.kind(graph, &instance.kind),
            words: self.inputs(&instance.words),
            output: self.uniforms as u32 + instance.output,
            outputs: instance.outputs,
            epoch: instance.epoch,
        }
    }

    fn kind(&mut self, graph: &Specialised, kind: &InstanceKind) -> Kind {
        match kind {
            InstanceKind::Plain(forms) => Kind::Plain(self.body(forms)),
            InstanceKind::Request { effect, context, site, loops, subject } => {
                let kept = match *subject {
                    Subject::Light { table, .. } => Some((table, graph.tables[table].epoch)),
                    Subject::Point | Subject::Texture(..) => None,
                };
                Kind::Request(Box::new(Request {
                    effect: *effect,
                    subject: *subject,
                    kept,
                    site: *site,
                    loops: loops.clone(),
                    scope: self.scope(context),
                }))
            }
            InstanceKind::Loop {
                epoch,
                turns,
                reduction,
                value_type,
                fields,
                body,
                words,
                context,
            } => Kind::Loop(Box::new(Loop {
                epoch: *epoch,
                turns: turns.clone(),
                count: match turns {
                    Turns::Lights { .. } => 0,
                    Turns::Samples { count, .. } => self.place(*count) as usize,
                },
                reduction: *reduction,
                value_type: *value_type,
                fields: self.uniforms + *fields as usize,
                body: *body,
                words: self.span(words),
                scope: self.scope(context),
                renewed: {
                    let inside = graph.epochs.0.keys();
                    inside.filter(|inner| graph.epochs.within(*inner, *epoch)).collect()
                },
            })),
        }
    }

    fn body(&self, forms: &BodyForms) -> Body {
        match forms.native_scalar() {
            Some(native) if self.simd == Simd::Native => Body::Native(native),
            _ => Body::Portable(Box::new(*forms)),
        }
    }

    fn scope(&mut self, context: &Context) -> Scope {
        Scope(context.iter().map(|(field, words)| (*field, self.span(words))).collect())
    }

    /// The words a body reads.
    fn inputs(&mut self, sources: &[Source]) -> Span {
        self.most_inputs = self.most_inputs.max(sources.len());
        self.span(sources)
    }

    fn span(&mut self, sources: &[Source]) -> Span {
        let first = self.places.len() as u32;
        for &source in sources {
            let place = self.place(source);
            self.places.push(place);
        }
        Span { first, end: self.places.len() as u32 }
    }

    /// Where a word stands in the file.
    fn place(&self, source: Source) -> u32 {
        match source {
            Source::Constant { at, .. } | Source::Uniform(at) => at,
            Source::Slot(slot) => self.uniforms as u32 + slot,
        }
    }
}
