//! Random segments: every operation, constants, uniforms, slots.

use phenomenon_compiler::ops::{Op, OpId, OpSegment};
use phenomenon_compiler::storage::{LANES, Lanes, Source};
use phenomenon_compiler::testing::random::Random;

use crate::samples::{File, Kind, yields};

/// A random segment, and what it expects of its file.
pub struct Case {
    pub segment: OpSegment,
    pub uniforms: Vec<Kind>,
    /// Kinds of the slots: first those that are read, then those that are written.
    pub slots: Vec<Kind>,
    inputs: usize,
}

impl Case {
    /// A segment of about `size` operations.
    pub fn new(random: &mut Random, size: usize) -> Self {
        let kinds = [Kind::Real, Kind::Real, Kind::Int, Kind::Mask];
        let mut sources = Vec::new();
        let mut uniforms = Vec::new();
        let mut slots = Vec::new();
        let mut ops = Ops::default();
        // One of each kind, so that every operation finds operands.
        for n in 0..6 + random.below(6) {
            let kind = kinds[n % 4];
            let uniform = random.below(2) == 0;
            let list = if uniform { &mut uniforms } else { &mut slots };
            let position = list.len() as u32;
            list.push(kind);
            ops.add(Op::Load(sources.len() as u32), kind);
            sources.push(if uniform { Source::Uniform(position) } else { Source::Slot(position) });
        }
        while ops.list.len() < size {
            ops.grow(random);
        }
        let inputs = slots.len();
        let mut stores = Vec::new();
        for _ in 0..1 + random.below(12) {
            let recent = ops.list.len().min(40);
            let id = ops.list.len() - 1 - random.below(recent);
            stores.push((slots.len() as u32, id as OpId));
            slots.push(ops.kinds[id]);
        }
        let segment = OpSegment { ops: ops.list, sources, stores, wanted: vec![] };
        Self { segment, uniforms, slots, inputs }
    }

    /// A file for it with random words, and room for `scratch` slots more.
    pub fn file(&self, random: &mut Random, scratch: u32, blocks: usize) -> File {
        let mut file = File::new(self.uniforms.len(), self.slots.len() + scratch as usize, blocks);
        for (at, &kind) in self.uniforms.iter().enumerate() {
            file.lanes[at] = Lanes([kind.word(random); LANES]);
        }
        for block in 0..blocks {
            for slot in 0..self.inputs {
                let words = [(); LANES].map(|()| self.slots[slot].word(random));
                *file.slot(block, slot as u32) = Lanes(words);
            }
        }
        file
    }
}

#[derive(Default)]
struct Ops {
    list: Vec<Op>,
    kinds: Vec<Kind>,
}

impl Ops {
    fn add(&mut self, op: Op, kind: Kind) -> OpId {
        self.list.push(op);
        self.kinds.push(kind);
        self.list.len() as OpId - 1
    }

    /// An operand of the kind: recent ones are likelier, so that chains get deep.
    fn operand(&self, random: &mut Random, kind: Kind) -> OpId {
        let all: Vec<_> = (0..self.list.len())
            .filter(|&id| self.kinds[id] == kind)
            .map(|id| id as OpId)
            .collect();
        let from = if random.below(3) == 0 { 0 } else { all.len().saturating_sub(12) };
        random.pick(&all[from..])
    }

    fn grow(&mut self, random: &mut Random) {
        let kind = random.pick(&[Kind::Real, Kind::Real, Kind::Real, Kind::Int, Kind::Mask]);
        if random.below(8) == 0 {
            let word = kind.word(random);
            self.add(Op::Constant(word), kind);
            return;
        }
        let choice = random.below(64);
        let mut operand = |kind| self.operand(random, kind);
        let op = match kind {
            Kind::Real => real(choice, &mut operand),
            Kind::Int => int(choice, &mut operand),
            Kind::Mask => mask(choice, &mut operand),
        };
        if op == Op::Not(OpId::MAX) {
            return self.guarded_bits(random);
        }
        let kind = yields(op, |id| self.kinds[id as usize]);
        // The bits of an integer as a number, now and then.
        let kind = if kind == Kind::Int && choice < 6 { Kind::Real } else { kind };
        self.add(op, kind);
    }

    /// The bits of a number as an integer. NaNs are one class, so theirs must not get there.
    fn guarded_bits(&mut self, random: &mut Random) {
        let value = self.operand(random, Kind::Real);
        let number = self.add(Op::Equal(value, value), Kind::Mask);
        let zero = self.add(Op::Constant(0), Kind::Int);
        self.add(Op::Select(number, value, zero), Kind::Int);
    }
}

fn real(choice: usize, operand: &mut impl FnMut(Kind) -> OpId) -> Op {
    use Kind::{Int, Mask, Real};
    match choice % 17 {
        0 => Op::Add(operand(Real), operand(Real)),
        1 => Op::Sub(operand(Real), operand(Real)),
        2 => Op::Mul(operand(Real), operand(Real)),
        3 => Op::Div(operand(Real), operand(Real)),
        4 => Op::Neg(operand(Real)),
        5 | 6 => Op::MulAdd(operand(Real), operand(Real), operand(Real)),
        7 => Op::Minimum(operand(Real), operand(Real)),
        8 => Op::Maximum(operand(Real), operand(Real)),
        9 => Op::Absolute(operand(Real)),
        10 => Op::Sqrt(operand(Real)),
        11 => Op::Floor(operand(Real)),
        12 => Op::Ceil(operand(Real)),
        13 => Op::Truncate(operand(Real)),
        14 => Op::RoundEven(operand(Real)),
        15 => Op::ToReal(operand(Int)),
        _ => Op::Select(operand(Mask), operand(Real), operand(Real)),
    }
}

fn int(choice: usize, operand: &mut impl FnMut(Kind) -> OpId) -> Op {
    use Kind::{Int, Mask, Real};
    let bits = (choice % 32) as u32;
    match choice % 13 {
        0 => Op::ToInt(operand(Real)),
        1 => Op::IntAdd(operand(Int), operand(Int)),
        2 => Op::IntSub(operand(Int), operand(Int)),
        3 => Op::IntMul(operand(Int), operand(Int)),
        4 => Op::And(operand(Int), operand(Int)),
        5 => Op::Or(operand(Int), operand(Int)),
        6 => Op::Xor(operand(Int), operand(Int)),
        7 => Op::Not(operand(Int)),
        8 => Op::ShiftLeft(operand(Int), bits),
        9 => Op::ShiftRight(operand(Int), bits),
        10 => Op::ShiftRightSigned(operand(Int), bits),
        11 => Op::Select(operand(Mask), operand(Int), operand(Int)),
        // Stands for the bits of a number.
        _ => Op::Not(OpId::MAX),
    }
}

fn mask(choice: usize, operand: &mut impl FnMut(Kind) -> OpId) -> Op {
    use Kind::{Int, Mask, Real};
    match choice % 11 {
        0 => Op::Less(operand(Real), operand(Real)),
        1 => Op::LessEqual(operand(Real), operand(Real)),
        2 => Op::Equal(operand(Real), operand(Real)),
        3 => Op::NotEqual(operand(Real), operand(Real)),
        4 => Op::IntEqual(operand(Int), operand(Int)),
        5 => Op::IntLess(operand(Int), operand(Int)),
        6 => Op::And(operand(Mask), operand(Mask)),
        7 => Op::Or(operand(Mask), operand(Mask)),
        8 => Op::Xor(operand(Mask), operand(Mask)),
        9 => Op::Not(operand(Mask)),
        _ => Op::Select(operand(Mask), operand(Mask), operand(Mask)),
    }
}
