//! The back ends under test, each as a function from rows of inputs to rows of outputs.

use phenomenon_compiler::engine::jit::{Generator, JitCode};
use phenomenon_compiler::ops::{OpSegment, dead, fold, legalise, split};
use phenomenon_compiler::storage::{FileShape, LANES, Lanes, Placement, Source};

use crate::cases::Case;
use crate::reference;

/// A table of words.
pub struct Rows {
    width: usize,
    words: Vec<u32>,
}

impl Rows {
    pub fn new(width: usize) -> Self {
        Self { width, words: vec![] }
    }

    pub fn push(&mut self, row: &[u32]) {
        assert_eq!(row.len(), self.width);
        self.words.extend_from_slice(row);
    }

    pub fn count(&self) -> usize {
        self.words.len() / self.width
    }

    pub fn row(&self, row: usize) -> &[u32] {
        &self.words[row * self.width..][..self.width]
    }
}

/// Runs a case over rows of inputs.
pub type Run = fn(&Case, &Rows) -> Rows;

/// Every back end there is on this machine.
pub fn all() -> impl Iterator<Item = &'static (&'static str, Run)> {
    let native = if Generator::Native.available().is_ok() { NATIVE } else { &[] };
    let cranelift = if Generator::Cranelift.available().is_ok() { CRANELIFT } else { &[] };
    ALWAYS.iter().chain(native).chain(cranelift)
}

const ALWAYS: &[(&str, Run)] = &[
    ("scalar", |case, inputs| {
        point_by_point(&|point, outputs| case.code.scalar(point, outputs), case, inputs)
    }),
    ("scalar, portable", |case, inputs| {
        point_by_point(&|point, outputs| case.code.scalar_portable(point, outputs), case, inputs)
    }),
    ("wide", |case, inputs| {
        blocks(&|lanes, placement| case.code.wide(lanes, placement), case, inputs)
    }),
    ("wide, portable", |case, inputs| {
        blocks(&|lanes, placement| case.code.wide_portable(lanes, placement), case, inputs)
    }),
];

/// The forms of machine code of a generator.
macro_rules! machine_code {
    ($name:literal, $generator:expr) => {
        &[
            (concat!($name, " code"), |case, inputs| {
                compiled($generator, case, inputs, |segment| vec![segment])
            }),
            (concat!($name, " code, folded"), |case, inputs| {
                compiled($generator, case, inputs, |segment| {
                    vec![dead::remove(&fold::fold(&segment))]
                })
            }),
            (concat!($name, " code, split"), |case, inputs| {
                let scratch = (inputs.width + case.outputs.len()) as u32;
                compiled($generator, case, inputs, |segment| {
                    split::split(&segment, 7, scratch).parts
                })
            }),
        ]
    };
}

const NATIVE: &[(&str, Run)] = machine_code!("native", Generator::Native);
const CRANELIFT: &[(&str, Run)] = machine_code!("Cranelift's", Generator::Cranelift);

fn point_by_point(run: &dyn Fn(&[u32], &mut [u32]), case: &Case, inputs: &Rows) -> Rows {
    let mut rows = Rows::new(case.outputs.len());
    let mut outputs = vec![0; case.outputs.len()];
    for row in 0..inputs.count() {
        run(inputs.row(row), &mut outputs);
        rows.push(&outputs);
    }
    rows
}

/// Slots past inputs and outputs, for values that cross the cuts of a split segment.
const SCRATCH: usize = 64;

/// Records the case, legalises and prepares the segment, compiles it, and runs its parts.
fn compiled(
    generator: Generator,
    case: &Case,
    inputs: &Rows,
    prepare: impl Fn(OpSegment) -> Vec<OpSegment>,
) -> Rows {
    let sources: Vec<Source> = (0..inputs.width as u32).map(Source::Slot).collect();
    let (ops, results) = reference::tape(case);
    let first = inputs.width as u32;
    let stores = (first..).zip(results).collect();
    let segment = OpSegment { ops, sources: sources.clone(), stores, wanted: vec![] };
    let parts = prepare(legalise::legalise(&segment));
    let slots = inputs.width + case.outputs.len() + SCRATCH;
    let shape = FileShape { uniforms: UNIFORMS, slots };
    let code = JitCode::compile(generator, &parts, shape).expect("compiles");
    let run = |file: &mut [Lanes], placement: &Placement<'_>| {
        code.run(0..parts.len(), file, 0..placement.blocks);
    };
    placed(run, case, inputs, &sources, slots, first)
}

/// Uniform words no case reads, so that slots do not start at 0.
const UNIFORMS: usize = 3;

fn blocks(run: &dyn Fn(&mut [Lanes], &Placement<'_>), case: &Case, inputs: &Rows) -> Rows {
    let sources: Vec<Source> = (0..inputs.width as u32).map(Source::Slot).collect();
    let output = inputs.width as u32;
    placed(run, case, inputs, &sources, inputs.width + case.outputs.len(), output)
}

/// Writes the outputs over the inputs.
pub fn in_place(case: &Case, inputs: &Rows) -> Rows {
    let sources: Vec<Source> = (0..inputs.width as u32).map(Source::Slot).collect();
    placed(
        |lanes, placement| case.code.wide(lanes, placement),
        case,
        inputs,
        &sources,
        inputs.width,
        0,
    )
}

/// Reads the first input, the same in all rows, from a uniform word.
pub fn with_uniform(case: &Case, inputs: &Rows) -> Rows {
    let mut sources: Vec<Source> = (0..inputs.width as u32).map(Source::Slot).collect();
    sources[0] = Source::Uniform(1);
    let output = inputs.width as u32;
    placed(
        |lanes, placement| case.code.wide(lanes, placement),
        case,
        inputs,
        &sources,
        inputs.width + case.outputs.len(),
        output,
    )
}

fn placed(
    run: impl Fn(&mut [Lanes], &Placement<'_>),
    case: &Case,
    inputs: &Rows,
    sources: &[Source],
    slots: usize,
    output: u32,
) -> Rows {
    let blocks = inputs.count().div_ceil(LANES);
    let placement = Placement {
        shape: FileShape { uniforms: UNIFORMS, slots },
        first: 0,
        blocks,
        sources,
        output,
    };
    let mut file = vec![Lanes::default(); UNIFORMS + blocks * slots];
    for row in 0..inputs.count() {
        for (word, &bits) in inputs.row(row).iter().enumerate() {
            let at = placement.input(word, row / LANES);
            match sources[word] {
                Source::Uniform(_) | Source::Constant { .. } => file[at] = Lanes([bits; LANES]),
                Source::Slot(_) => file[at].0[row % LANES] = bits,
            }
        }
    }
    run(&mut file, &placement);
    let mut rows = Rows::new(case.outputs.len());
    for row in 0..inputs.count() {
        let words = 0..case.outputs.len();
        let outputs: Vec<u32> =
            words.map(|word| file[placement.output(word, row / LANES)].0[row % LANES]).collect();
        rows.push(&outputs);
    }
    rows
}
