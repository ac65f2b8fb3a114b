//! A segment as a function: its operations in order, as instructions over eight lanes.
//!
//! `rdi` is the file, `rsi` the first block, `rdx` the constants, `rcx` rows for spilled words, `r8` the
//! number of blocks, at least one. It calls nothing, needs no stack, and changes `rax`, `rsi`, `r8`, the
//! vector registers and flags, which a caller in this convention does not rely on.

use super::assembler::{Assembler, Form, Operand, Ymm};
use super::constants::Constants;
use super::registers::{Home, Registers, Uses};
use crate::ops::{Op, OpId, OpSegment};
use crate::storage::{FileShape, Lanes, Source};

/// Fewest registers any instruction can be written with.
pub const FEWEST_REGISTERS: u32 = 5;

/// Writes the function of `segment`, which is well formed and legal, in so many registers. Gives the rows for
/// spilled words it needs.
///
/// # Errors
/// For an operation that [`legalise`](crate::ops::legalise) should have replaced.
pub fn write(
    segment: &OpSegment,
    shape: FileShape,
    assembler: &mut Assembler,
    constants: &mut Constants,
    registers: u32,
) -> Result<usize, &'static str> {
    let ops = &segment.ops;
    let stores = Stores::of(segment);
    let operands: Vec<Operands> = (0..ops.len()).map(|id| Operands::of(ops, id)).collect();
    let live = live(segment, &operands);
    let uses = Uses::of(ops.len(), |use_at| {
        for id in (0..ops.len()).filter(|&id| live[id]) {
            operands[id].distinct(|operand| use_at(operand, id));
        }
        for (at, &(_, id)) in stores.late.iter().enumerate() {
            use_at(id, ops.len() + at);
        }
    });
    let start = assembler.len();
    let registers = Registers::new(assembler, constants, uses, registers);
    let mut writer = Writer { segment, operands: &operands, registers, position: 0 };
    let skip = writer.skip_unwanted();
    for id in (0..ops.len()).filter(|&id| live[id]) {
        writer.operation(id as OpId)?;
        writer.store_early(id as OpId, &stores);
    }
    writer.store_late(&stores);
    let rows = writer.registers.rows();
    if let Some(jump) = skip {
        assembler.land(jump);
    }
    assembler.next_block_or_return(start, (shape.slots * size_of::<Lanes>()) as i32);
    Ok(rows)
}

/// When results are stored: all loads of a slot come before what is stored there.
struct Stores {
    /// By operation: at once, to slots that the segment does not read.
    early: Vec<(OpId, u32)>,
    /// At the end, in order.
    late: Vec<(u32, OpId)>,
}

impl Stores {
    fn of(segment: &OpSegment) -> Self {
        let mut read: Vec<u32> = segment.sources.iter().filter_map(slot).collect();
        read.sort_unstable();
        let mut written: Vec<u32> = segment.stores.iter().map(|store| store.0).collect();
        written.sort_unstable();
        let twice = |slot: u32| {
            let from = written.partition_point(|&other| other < slot);
            written.get(from + 1) == Some(&slot)
        };
        let mut stores = Self { early: Vec::new(), late: Vec::new() };
        for &(slot, id) in &segment.stores {
            let at_once = !segment.ops[id as usize].is_fetch();
            if at_once && read.binary_search(&slot).is_err() && !twice(slot) {
                stores.early.push((id, slot));
            } else {
                stores.late.push((slot, id));
            }
        }
        stores.early.sort_unstable();
        stores
    }
}

fn slot(source: &Source) -> Option<u32> {
    match *source {
        Source::Slot(slot) => Some(slot),
        Source::Uniform(_) | Source::Constant { .. } => None,
    }
}

/// What an instruction reads: the operands of its operation, but those of a fused multiplication without their
/// signs, which it has forms for.
#[derive(Clone, Copy)]
struct Operands {
    ids: [OpId; 3],
    count: usize,
    /// Whether the product, and what is added to it, change their sign.
    signs: [bool; 2],
}

impl Operands {
    fn of(ops: &[Op], id: usize) -> Self {
        let mut all = Self { ids: [0; 3], count: 0, signs: [false; 2] };
        let op = ops[id];
        op.for_each_operand(|operand| {
            all.ids[all.count] = operand;
            all.count += 1;
        });
        if let Op::MulAdd(..) = op {
            for (operand, sign) in all.ids.iter_mut().zip([0, 0, 1]) {
                while let Op::Neg(inner) = ops[*operand as usize] {
                    *operand = inner;
                    all.signs[sign] ^= true;
                }
            }
        }
        all
    }

    /// Calls `visit` once for each word.
    fn distinct(&self, mut visit: impl FnMut(OpId)) {
        for (at, &id) in self.ids[..self.count].iter().enumerate() {
            if !self.ids[..at].contains(&id) {
                visit(id);
            }
        }
    }
}

/// Which operations something stored depends on.
fn live(segment: &OpSegment, operands: &[Operands]) -> Vec<bool> {
    let mut live = vec![false; segment.ops.len()];
    for &(_, id) in &segment.stores {
        live[id as usize] = true;
    }
    for id in (0..segment.ops.len()).rev() {
        if live[id] {
            operands[id].distinct(|operand| live[operand as usize] = true);
        }
    }
    live
}

/// The instructions of a segment being written.
pub(super) struct Writer<'a> {
    pub(super) segment: &'a OpSegment,
    operands: &'a [Operands],
    pub(super) registers: Registers<'a>,
    /// The operation at hand.
    pub(super) position: usize,
}

impl Writer<'_> {
    /// The bits of an operation that is a constant.
    pub(super) fn bits(&self, id: OpId) -> Option<u32> {
        match self.segment.ops[id as usize] {
            Op::Constant(bits) => Some(bits),
            _ => None,
        }
    }

    /// A constant, in memory.
    pub(super) fn constant(&mut self, bits: u32) -> Operand {
        let (base, offset) = Home::Constant(self.registers.constants.row(bits)).place();
        Operand::Memory(base, offset)
    }

    /// Says where what is only fetched lies.
    pub(super) fn fetch(&mut self, id: OpId, op: Op) {
        let home = match op {
            Op::Load(source) => match self.segment.sources[source as usize] {
                Source::Uniform(at) | Source::Constant { at, .. } => Home::Uniform(at),
                Source::Slot(slot) => Home::Slot(slot),
            },
            Op::Constant(bits) => Home::Constant(self.registers.constants.row(bits)),
            _ => unreachable!("nothing else is fetched"),
        };
        self.registers.settle(id, home);
    }

    /// The operands were read, and no other instruction of the operation reads them: a register for its word.
    pub(super) fn result(&mut self, id: OpId, operands: &[OpId]) -> Ymm {
        self.registers.used(operands, self.position);
        self.registers.result(id)
    }

    fn operation(&mut self, id: OpId) -> Result<(), &'static str> {
        self.position = id as usize;
        let Operands { ids, signs, .. } = self.operands[id as usize];
        self.write(id, self.segment.ops[id as usize], ids, signs)?;
        self.registers.end();
        Ok(())
    }

    fn store_early(&mut self, id: OpId, stores: &Stores) {
        let from = stores.early.partition_point(|&(other, _)| other < id);
        for &(_, slot) in stores.early[from..].iter().take_while(|(other, _)| *other == id) {
            let register = self.registers.register(id);
            let (base, offset) = Home::Slot(slot).place();
            self.registers.assembler.store(base, offset, register);
            if self.registers.home(id).is_none() {
                self.registers.settle(id, Home::Slot(slot));
            }
        }
        if self.registers.dies(id, self.position) {
            self.registers.used(&[id], self.position);
        }
        self.registers.end();
    }

    fn store_late(&mut self, stores: &Stores) {
        // What lies in a slot that is about to be overwritten is kept elsewhere first.
        let mut overwritten: Vec<u32> = stores.late.iter().map(|store| store.0).collect();
        overwritten.sort_unstable();
        for &(_, id) in &stores.late {
            let Some(Home::Slot(slot)) = self.registers.home(id) else { continue };
            if overwritten.binary_search(&slot).is_ok() {
                self.registers.register(id);
                self.registers.spill(id);
                self.registers.end();
            }
        }
        for (at, &(slot, id)) in stores.late.iter().enumerate() {
            let register = self.registers.register(id);
            let (base, offset) = Home::Slot(slot).place();
            self.registers.assembler.store(base, offset, register);
            self.registers.used(&[id], self.segment.ops.len() + at);
            self.registers.end();
        }
    }

    /// Skips the block where no point wants what the segment computes.
    fn skip_unwanted(&mut self) -> Option<super::assembler::Jump> {
        let (first, rest) = self.segment.wanted.split_first()?;
        let place = |source: &Source| {
            let (base, offset) = match *source {
                Source::Uniform(at) | Source::Constant { at, .. } => Home::Uniform(at),
                Source::Slot(slot) => Home::Slot(slot),
            }
            .place();
            Operand::Memory(base, offset)
        };
        let assembler = &mut *self.registers.assembler;
        assembler.unary(Form::MOVE, Ymm(0), place(first));
        for source in rest {
            assembler.binary(Form::AND, Ymm(0), Ymm(0), place(source));
        }
        Some(assembler.jump_unless_any(Ymm(0)))
    }
}
