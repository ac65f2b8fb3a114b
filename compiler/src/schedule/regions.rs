//! The parts of a schedule.

use cranelift_entity::PrimaryMap;

use crate::effects::Effect;
use crate::kernels::BodyForms;
use crate::specialise::{
    Context, EpochId, Guard, Instance, InstanceKind, LightTable, LightTableId, Subject, Turns,
};
use crate::state::{Field, Reduction};
use crate::storage::Source;
use crate::values::Type;

use super::{LoopId, RegionId, RequestId, SegmentId};

/// A program for batches of points.
#[derive(Clone, Debug)]
pub struct Schedule {
    /// Regions; the first is the root's.
    pub regions: PrimaryMap<RegionId, Region>,
    /// Segments.
    pub segments: PrimaryMap<SegmentId, Segment>,
    /// Requests.
    pub requests: PrimaryMap<RequestId, Request>,
    /// Loops.
    pub loops: PrimaryMap<LoopId, Loop>,
    /// State fields in use, each with the first of its slots.
    pub fields: Vec<(Field, u32)>,
    /// Slots of a block.
    pub slots: u32,
    /// First of the root's slots: colour, then ok.
    pub root: u32,
    /// Tables of light colours.
    pub tables: PrimaryMap<LightTableId, LightTable>,
}

impl Schedule {
    /// The segment that is all there is to run: nothing is asked, forced or repeated.
    pub fn only_segment(&self) -> Option<SegmentId> {
        let mut regions = self.regions.values();
        match (regions.next()?.items.as_slice(), regions.next()) {
            ([Item::Segment(at)], None) => Some(*at),
            _ => None,
        }
    }
}

/// What is demanded under one mask.
#[derive(Clone, Debug, Default)]
pub struct Region {
    /// The node at its head, for printing.
    pub name: String,
    /// In order.
    pub items: Vec<Item>,
}

/// A step of a region.
#[derive(Clone, Debug)]
pub enum Item {
    /// Evaluate a segment for all points.
    Segment(SegmentId),
    /// Run a region where the mask holds, the guard holds, and it was not run yet.
    Force {
        /// Which.
        region: RegionId,
        /// A word that is a mask; none: always.
        guard: Option<Source>,
    },
    /// Ask the renderer, where the mask holds.
    Request(RequestId),
    /// Run a loop, where the mask holds.
    Loop(LoopId),
}

/// Pure code: steps in order, each reading only what is ready.
#[derive(Clone, Debug, Default)]
pub struct Segment {
    /// Bodies and guards.
    pub steps: Vec<Step>,
}

/// A body or guard to evaluate.
#[derive(Clone, Debug)]
pub struct Step {
    /// The node, for printing.
    pub name: String,
    /// Its code.
    pub code: BodyForms,
    /// Its input words.
    pub words: Vec<Source>,
    /// First slot of its output words.
    pub output: u32,
    /// Masks: a point wants the step where all of them hold. A block in which none does is left out. Empty
    /// where that is not asked.
    pub wanted: Vec<Source>,
    /// Whether it finds out who wants something, rather than being the evaluation of a node.
    pub is_guard: bool,
}

impl Step {
    /// The evaluation of an instance that has a body.
    pub fn of(instance: &Instance) -> Option<Self> {
        let InstanceKind::Plain(code) = instance.kind else { return None };
        Some(Self {
            name: instance.name.clone(),
            code,
            words: instance.words.clone(),
            output: instance.output,
            wanted: Vec::new(),
            is_guard: false,
        })
    }

    /// The guard of a demand, of one node by another.
    pub fn of_guard(guard: &Guard, by: &str, of: &str, output: u32) -> Self {
        Self {
            name: format!("{by} demands {of}"),
            code: guard.code,
            words: guard.words.clone(),
            output,
            wanted: Vec::new(),
            is_guard: true,
        }
    }
}

/// A request to the renderer.
#[derive(Clone, Debug)]
pub struct Request {
    /// The node, for printing.
    pub name: String,
    /// What is asked.
    pub effect: Effect,
    /// Argument words.
    pub words: Vec<Source>,
    /// First slot of the answer.
    pub output: u32,
    /// Words of the answer.
    pub outputs: u32,
    /// State fields that scopes changed.
    pub context: Context,
    /// Key of its random numbers.
    pub site: u64,
    /// The loops round it, outermost first.
    pub loops: Vec<LoopId>,
    /// What it is about.
    pub subject: Subject<LoopId>,
    /// Whether it may be asked again about the same light sample of a point, by itself or by others: answers are
    /// kept then.
    pub again: bool,
}

/// A loop.
#[derive(Clone, Debug)]
pub struct Loop {
    /// The node, for printing.
    pub name: String,
    /// What it runs over.
    pub turns: Turns<LoopId>,
    /// How the body's values become one.
    pub reduction: Reduction,
    /// Type of the body's values, and of what they become.
    pub value_type: Type,
    /// The epoch of its body.
    pub epoch: EpochId,
    /// First of the slots of the fields a turn provides.
    pub fields: u32,
    /// The body.
    pub region: RegionId,
    /// The body's words.
    pub words: Vec<Source>,
    /// First slot of what they become.
    pub output: u32,
    /// State fields that scopes changed.
    pub context: Context,
    /// Regions whose heads belong to an iteration: to be run anew in each.
    pub renewed: Vec<RegionId>,
    /// Tables that belong to an iteration.
    pub emptied: Vec<LightTableId>,
}

impl Request {
    /// Every word it reads.
    pub fn reads(&self) -> impl Iterator<Item = Source> {
        self.words.iter().chain(scoped(&self.context)).copied()
    }
}

impl Loop {
    /// Every word it reads.
    pub fn reads(&self) -> impl Iterator<Item = Source> {
        let count = match self.turns {
            Turns::Lights { .. } => None,
            Turns::Samples { count, .. } => Some(count),
        };
        self.words.iter().chain(scoped(&self.context)).copied().chain(count)
    }
}

/// The words of the fields that scopes changed.
fn scoped(context: &Context) -> impl Iterator<Item = &Source> {
    context.iter().flat_map(|(_, words)| words)
}
