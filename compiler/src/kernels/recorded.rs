//! What a body recorded, once, for all that evaluates operations instead of running it.

use std::sync::{LazyLock, OnceLock, PoisonError, RwLock};

use rustc_hash::FxHashMap;

use crate::emit::Body;
use crate::ops::legalise::legalise;
use crate::ops::{Op, OpId, OpSegment, Tape, TapeInputs};

/// Runs a body over a tape.
pub(super) type Recorder = fn(inputs: &TapeInputs<'_>, outputs: &mut [OpId]);

/// The recorder of `B`.
pub(super) fn recorder<B: Body>(inputs: &TapeInputs<'_>, mut outputs: &mut [OpId]) {
    B::run(inputs.tape(), inputs, &mut outputs);
}

/// Input words known before shading, with their numbers.
type Fixed = Box<[(usize, i32)]>;

/// A body that records when it is first asked to, and the place where that is kept as long as the
/// program runs: there are as many as bodies, and ways to give them their counts and choices.
pub(super) struct Kept {
    recorder: Recorder,
    outputs: usize,
    fixed: Fixed,
    recorded: OnceLock<Recorded>,
}

impl Kept {
    /// The place of this recorder, for that many output words. Whoever has it asks no lock again.
    ///
    /// It is known by its address. Compilers fold functions only where their code is the same, which
    /// then records the same; several addresses of one function cost nothing but memory.
    pub fn of(recorder: Recorder, outputs: usize, fixed: &[(usize, i32)]) -> &'static Self {
        type All = FxHashMap<(usize, usize, Fixed), &'static Kept>;
        static ALL: LazyLock<RwLock<All>> = LazyLock::new(RwLock::default);
        let key = (recorder as usize, outputs, Fixed::from(fixed));
        let known = ALL.read().unwrap_or_else(PoisonError::into_inner).get(&key).copied();
        known.unwrap_or_else(|| {
            let mut all = ALL.write().unwrap_or_else(PoisonError::into_inner);
            all.entry(key).or_insert_with(|| {
                let fixed = fixed.into();
                Box::leak(Box::new(Self { recorder, outputs, fixed, recorded: OnceLock::new() }))
            })
        })
    }

    /// The place of the same body where these words are known.
    pub fn with_fixed(&self, fixed: &[(usize, i32)]) -> &'static Self {
        Self::of(self.recorder, self.outputs, fixed)
    }

    /// What it records.
    pub fn recorded(&self) -> &Recorded {
        self.recorded.get_or_init(|| {
            let tape = Tape::new();
            let mut ids = vec![0; self.outputs];
            (self.recorder)(&TapeInputs::loads(&tape).with_fixed(&self.fixed), &mut ids);
            Recorded { ops: tape.into_ops(), outputs: ids, legal: OnceLock::new() }
        })
    }

    /// Runs it over a tape, for these inputs there.
    pub fn record_anew(&self, tape: &Tape, inputs: &[OpId], outputs: &mut [OpId]) {
        (self.recorder)(&TapeInputs::given(tape, inputs).with_fixed(&self.fixed), outputs);
    }
}

/// The operations of a body. `Load(n)` is its input word `n`.
#[derive(Debug)]
pub struct Recorded {
    /// The operations, functions among them.
    pub ops: Vec<Op>,
    /// Which of them the outputs are.
    pub outputs: Vec<OpId>,
    legal: OnceLock<Legal>,
}

/// The same in operations of 32 bits.
#[derive(Debug)]
struct Legal {
    /// Output word `n` is stored to slot `n`.
    segment: OpSegment,
    weight: usize,
}

impl Recorded {
    /// The operations of 32 bits that machines have: functions expanded, constants rounded. `Load(n)` is
    /// input word `n`, and output word `n` is stored to slot `n`.
    pub fn legal(&self) -> &OpSegment {
        &self.legalised().segment
    }

    /// Of that many input words, which the outputs depend on.
    pub fn reads(&self, words: usize) -> Vec<bool> {
        let mut live = vec![false; self.ops.len()];
        let mut reads = vec![false; words];
        self.outputs.iter().for_each(|id| live[*id as usize] = true);
        for (id, op) in self.ops.iter().enumerate().rev() {
            match *op {
                _ if !live[id] => {}
                Op::Load(word) => reads[word as usize] = true,
                op => op.for_each_operand(|operand| live[operand as usize] = true),
            }
        }
        reads
    }

    /// Number of operations once functions are expanded, those that only fetch a word aside.
    pub fn weight(&self) -> usize {
        self.legalised().weight
    }

    fn legalised(&self) -> &Legal {
        self.legal.get_or_init(|| {
            let stores = (0..).zip(self.outputs.iter().copied()).collect();
            let ops = self.ops.clone();
            let segment = legalise(&OpSegment { ops, stores, ..OpSegment::default() });
            let weight = segment.ops.iter().filter(|op| !op.is_fetch()).count();
            Legal { segment, weight }
        })
    }
}
