//! What a walk works in.

use cranelift_entity::{EntityRef, SecondaryMap};

use super::code::Code;
use crate::engine::evaluations::Evaluations;
use crate::engine::requests::Asking;
use crate::engine::turns::Turning;
use crate::specialise::{EpochId, InstanceId, LightTableId};

/// What a walk works in; kept between walks so that nothing is allocated per point. The cache is
/// indexed, and stamped rather than emptied.
#[derive(Debug, Default)]
pub struct Memory {
    /// The file: uniform words, then slots, then one for the outcome of a guard.
    pub(super) words: Vec<u32>,
    /// Words of a body that is run.
    pub(super) inputs: Vec<u32>,
    /// Per step, the pass through its epoch in which it was evaluated.
    pub(super) done: SecondaryMap<InstanceId, u64>,
    /// Per epoch, the current pass.
    pub(super) pass: SecondaryMap<EpochId, u64>,
    pub(super) passes: u64,
    /// Per epoch that is a loop: where it stands.
    pub(super) loops: SecondaryMap<EpochId, LoopPosition>,
    pub(super) tables: SecondaryMap<LightTableId, Kept>,
    pub(super) stack: Vec<Frame>,
    pub(super) asking: Asking,
    pub(super) turning: Turning,
    pub(super) evaluations: Evaluations,
}

/// Where a loop stands.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LoopPosition {
    pub(super) next: usize,
    pub(super) count: usize,
    pub(super) running: bool,
    /// Of the light sample.
    pub(super) token: u64,
}

/// A step that waits for what it demands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub(super) step: InstanceId,
    /// The next of its demands.
    pub(super) next: u32,
}

/// Answers about the samples of a light list, and for each the pass in which it was asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Kept {
    passes: Vec<u64>,
    words: Vec<u32>,
}

impl Memory {
    /// Makes room for a graph, with the uniform words in place.
    pub(super) fn fit(&mut self, code: &Code, uniforms: &[u32]) {
        self.evaluations = Evaluations::default();
        self.words.resize(code.words.max(self.words.len()), 0);
        self.words[..uniforms.len()].copy_from_slice(uniforms);
        self.inputs.resize(code.most_inputs.max(self.inputs.len()), 0);
        // Stamps another graph left behind do not count: every pass number is used once.
        grow(&mut self.done, code.steps.len());
        grow(&mut self.pass, code.epochs);
    }
}

/// Makes room for the first `count` keys; what is there stays.
fn grow<K: EntityRef>(map: &mut SecondaryMap<K, u64>, count: usize) {
    map.resize(count.max(map.as_values_slice().len()));
}

impl Kept {
    /// The answer about a turn, if it was asked for in this pass.
    pub(super) fn known(&self, turn: usize, pass: u64, width: usize) -> Option<&[u32]> {
        let is_known = self.passes.get(turn) == Some(&pass);
        is_known.then(|| &self.words[turn * width..][..width])
    }

    /// Keeps the answer about a turn.
    pub(super) fn keep(&mut self, turn: usize, pass: u64, words: &[u32]) {
        let turns = self.passes.len().max(turn + 1);
        self.passes.resize(turns, 0);
        self.words.resize(turns * words.len(), 0);
        self.passes[turn] = pass;
        self.words[turn * words.len()..][..words.len()].copy_from_slice(words);
    }
}
