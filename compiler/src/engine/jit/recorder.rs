//! Steps of a schedule as one segment of operations, legal and folded as they are recorded.

use crate::ops::{Op, OpId, OpSegment, Tape};
use crate::schedule::Step;
use crate::storage::Source;

/// Records stretches of steps. What it knows of words is kept from stretch to stretch, with the number
/// of the stretch it is true of, so that nothing is cleared.
#[derive(Debug)]
pub struct Recorder {
    stretch: u32,
    slots: Vec<Known>,
    uniforms: Vec<Known>,
    ids: Vec<OpId>,
    inputs: Vec<OpId>,
    outputs: Vec<OpId>,
}

/// The operation that has a word, in a stretch.
type Known = (u32, OpId);

impl Recorder {
    /// A recorder of a schedule of that many slots.
    pub fn new(slots: u32) -> Self {
        Self {
            stretch: 0,
            slots: vec![(0, 0); slots as usize],
            uniforms: Vec::new(),
            ids: Vec::new(),
            inputs: Vec::new(),
            outputs: Vec::new(),
        }
    }

    /// Records steps, wanted by the same points, as one segment that stores the slots for which `stored` holds.
    pub fn record(&mut self, steps: &[Step], stored: impl Fn(u32) -> bool) -> OpSegment {
        self.stretch += 1;
        let most = steps.iter().map(|step| step.code.recorded().legal().ops.len()).sum();
        let tape = Tape::with_capacity(most);
        let mut sources = Vec::new();
        let mut stores = Vec::new();
        for step in steps {
            self.inputs.clear();
            for &source in &step.words {
                let id = self.word(source, &tape, &mut sources);
                self.inputs.push(id);
            }
            self.outputs.clear();
            self.outputs.resize(step.code.outputs(), 0);
            step.code.record(&tape, &self.inputs, &mut self.outputs, &mut self.ids);
            for (slot, &id) in (step.output..).zip(&self.outputs) {
                self.slots[slot as usize] = (self.stretch, id);
                if stored(slot) {
                    stores.push((slot, id));
                }
            }
        }
        let wanted = steps.first().map(|step| step.wanted.clone()).unwrap_or_default();
        OpSegment { ops: tape.into_ops(), sources, stores, wanted }
    }

    /// The operation that has the word of a source.
    fn word(&mut self, source: Source, tape: &Tape, sources: &mut Vec<Source>) -> OpId {
        let known = match source {
            Source::Constant { bits, .. } => return tape.push(Op::Constant(bits)),
            Source::Slot(slot) => &mut self.slots[slot as usize],
            Source::Uniform(at) => {
                let at = at as usize;
                self.uniforms.resize(self.uniforms.len().max(at + 1), (0, 0));
                &mut self.uniforms[at]
            }
        };
        if known.0 != self.stretch {
            sources.push(source);
            *known = (self.stretch, tape.push(Op::Load(sources.len() as u32 - 1)));
        }
        known.1
    }
}
