//! What a body recorded, once, for all that evaluates operations instead of running it.

use std::collections::{BTreeSet, HashMap};
use std::sync::{LazyLock, Mutex, OnceLock, PoisonError, RwLock};

use crate::emit::Body;
use crate::ops::legalise::replay;
use crate::ops::{Op, OpId, Tape, TapeInputs};

/// Runs a body over a tape.
pub(super) type Recorder = fn(inputs: &TapeInputs<'_>, outputs: &mut [OpId]);

/// The recorder of `B`.
pub(super) fn recorder<B: Body>(inputs: &TapeInputs<'_>, mut outputs: &mut [OpId]) {
    B::run(inputs.tape(), inputs, &mut outputs);
}

/// Input words known before shading, with their numbers.
pub(super) type Fixed = &'static [(usize, i32)];

/// These, each different list kept once, for as long as the program runs: there are as many as ways to
/// give nodes their counts and choices.
pub(super) fn kept(fixed: &[(usize, i32)]) -> Fixed {
    static ALL: Mutex<BTreeSet<Fixed>> = Mutex::new(BTreeSet::new());
    let mut all = ALL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = all.get(fixed) {
        return known;
    }
    let leaked: Fixed = Box::leak(fixed.into());
    all.insert(leaked);
    leaked
}

/// The operations of a body. `Load(n)` is its input word `n`.
#[derive(Debug)]
pub struct Recorded {
    /// The operations, functions among them.
    pub ops: Vec<Op>,
    /// Which of them the outputs are.
    pub outputs: Vec<OpId>,
    weight: OnceLock<usize>,
}

impl Recorded {
    /// What this recorder records, for that many output words. It is recorded when first asked for, and
    /// kept as long as the program runs: there are as many as bodies.
    ///
    /// It is known by its address. Compilers fold functions only where their code is the same, which
    /// then records the same; several addresses of one function cost nothing but memory.
    pub(super) fn of(recorder: Recorder, outputs: usize, fixed: Fixed) -> &'static Self {
        type All = HashMap<(usize, usize, Fixed), &'static Recorded>;
        static ALL: LazyLock<RwLock<All>> = LazyLock::new(RwLock::default);
        let key = (recorder as usize, outputs, fixed);
        let known = ALL.read().unwrap_or_else(PoisonError::into_inner).get(&key).copied();
        known.unwrap_or_else(|| {
            // Before the lock is taken: a body may be anybody's.
            let recorded = Self::new(recorder, outputs, fixed);
            let mut all = ALL.write().unwrap_or_else(PoisonError::into_inner);
            all.entry(key).or_insert_with(|| Box::leak(Box::new(recorded)))
        })
    }

    fn new(recorder: Recorder, outputs: usize, fixed: Fixed) -> Self {
        let tape = Tape::new();
        let mut ids = vec![0; outputs];
        recorder(&TapeInputs::loads(&tape).with_fixed(fixed), &mut ids);
        Self { ops: tape.into_ops(), outputs: ids, weight: OnceLock::new() }
    }

    /// Records the operations on another tape, for these inputs there.
    pub fn replay(&self, tape: &Tape, inputs: &[OpId], outputs: &mut [OpId]) {
        let ids = replay(&self.ops, tape, |word| inputs[word as usize]);
        for (output, &id) in outputs.iter_mut().zip(&self.outputs) {
            *output = ids[id as usize];
        }
    }

    /// Number of operations once functions are expanded, those that only fetch a word aside.
    pub fn weight(&self) -> usize {
        *self.weight.get_or_init(|| {
            let tape = Tape::standard();
            replay(&self.ops, &tape, |word| tape.push(Op::Load(word)));
            tape.into_ops().iter().filter(|op| !op.is_fetch()).count()
        })
    }
}
