//! One segment as one Cranelift function: a loop over half-blocks of four lanes.
//!
//! Cranelift has 128-bit vectors only. Words are untyped on the tape; here each has a form as
//! `f32x4` and one as `i32x4`, made when first asked for (a bitcast between them is no
//! instruction). Patterns x86-64 instruction selection knows, and that are kept to here:
//! * `bitselect(bitcast(fcmp lt a b), a, b)` on `f32x4` is `minps`, and with `fcmp lt b a` `maxps`
//!   (`fmin` and `fmax` have other NaN rules and take ten instructions);
//! * `bitselect` is one blend where its condition is seen to be a comparison: a float comparison
//!   through a bitcast, an integer comparison only directly. For any other mask `blendv` is.
//! * Loads that are `readonly`, `notrap` and `can_move` are values like any other: placed where
//!   they are used, often as the memory operand of the instruction. A slot of the segment's own
//!   stores is not `readonly`; its loads stay in order, before all stores.
//! * Uniforms would be moved out of the loop too. With more of them than registers that only
//!   exchanges loads for reloads of spilled values: as fast, with 1.5 times the code and twice the
//!   compile time. So their address is made to depend on the turn of the loop.

use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::types::{F32X4, I32, I32X4, I64};
use cranelift_codegen::ir::{
    AbiParam, BlockArg, ConstantData, Function, InstBuilder, MemFlagsData, Signature, Type, Value,
};
use cranelift_codegen::isa::TargetFrontendConfig;
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};

use crate::ops::{Op, OpId, OpSegment};
use crate::storage::{FileShape, Lanes, Source};

/// Bytes of a word of a block.
const WORD: usize = size_of::<Lanes>();
/// Bytes of half a word: four lanes.
const HALF: i64 = 16;

/// Writes the function of `segment` into `function`. Sizes are below 2^31 bytes, and the segment is
/// well formed.
pub fn lower(
    segment: &OpSegment,
    shape: FileShape,
    config: TargetFrontendConfig,
    function: &mut Function,
    context: &mut FunctionBuilderContext,
) {
    let mut signature = Signature::new(config.default_call_conv);
    signature.params.extend([AbiParam::new(I64), AbiParam::new(I64)]);
    function.signature = signature;
    let mut builder = FunctionBuilder::new(function, context);
    let entry = builder.create_block();
    builder.append_block_params_for_function_params(entry);
    builder.switch_to_block(entry);
    let &[file, blocks] = builder.block_params(entry) else { return };
    let before = builder.ins().iconst(I64, (shape.uniforms * WORD) as i64);
    let first = builder.ins().iadd(file, before);
    let size = builder.ins().imul_imm_s(blocks, (shape.slots * WORD) as i64);
    let end = builder.ins().iadd(first, size);
    // From a first half to its second it is 16 bytes, on to the next block the rest of a block:
    // the step alternates between the two, whose sum is a block.
    let step = builder.ins().iconst(I64, HALF);
    let body = builder.create_block();
    let exit = builder.create_block();
    builder.ins().jump(body, &[first, before, step].map(BlockArg::Value));

    let [at, before, step] = [(); 3].map(|()| builder.append_block_param(body, I64));
    builder.switch_to_block(body);
    // The start of the file, found anew in every turn: see the module's words on uniforms.
    let file = builder.ins().isub(at, before);
    Lowering { builder: &mut builder, segment, file, at, words: Vec::new() }.run();
    let next = builder.ins().iadd(at, step);
    let next_before = builder.ins().iadd(before, step);
    let whole = builder.ins().iconst(I64, (shape.slots * WORD) as i64);
    let next_step = builder.ins().isub(whole, step);
    let more = builder.ins().icmp(IntCC::NotEqual, next, end);
    let arguments = [next, next_before, next_step].map(BlockArg::Value);
    builder.ins().brif(more, body, &arguments, exit, &[]);

    builder.switch_to_block(exit);
    builder.ins().return_(&[]);
    builder.seal_all_blocks();
    builder.finalize(config);
}

/// The forms of one word that were asked for.
#[derive(Clone, Copy, Default)]
struct Word {
    real: Option<Value>,
    bits: Option<Value>,
    /// Which comparison made it, if one did.
    mask: Comparison,
}

#[derive(Clone, Copy, Default, PartialEq)]
enum Comparison {
    #[default]
    None,
    Real,
    Int,
}

struct Lowering<'a, 'b> {
    builder: &'a mut FunctionBuilder<'b>,
    segment: &'a OpSegment,
    /// Start of the file.
    file: Value,
    /// First word of the half-block.
    at: Value,
    words: Vec<Word>,
}

impl Lowering<'_, '_> {
    fn run(mut self) {
        self.words.reserve(self.segment.ops.len());
        for &op in &self.segment.ops {
            let word = self.op(op);
            self.words.push(word);
        }
        for &(slot, id) in &self.segment.stores {
            let word = self.words[id as usize];
            let value = word.real.or(word.bits).unwrap_or_else(|| self.bits(id));
            let flags = MemFlagsData::new().with_notrap().with_aligned();
            self.builder.ins().store(flags, value, self.at, (slot as usize * WORD) as i32);
        }
    }

    fn op(&mut self, op: Op) -> Word {
        match op {
            Op::Load(source) => self.load(source),
            // Made in the form, or forms, asked for.
            Op::Constant(_) => Word::default(),
            Op::Less(a, b) => self.compare(FloatCC::LessThan, a, b),
            Op::LessEqual(a, b) => self.compare(FloatCC::LessThanOrEqual, a, b),
            Op::Equal(a, b) => self.compare(FloatCC::Equal, a, b),
            Op::NotEqual(a, b) => self.compare(FloatCC::NotEqual, a, b),
            Op::IntEqual(a, b) => self.compare_bits(IntCC::Equal, a, b),
            Op::IntLess(a, b) => self.compare_bits(IntCC::SignedLessThan, a, b),
            Op::Select(mask, a, b) => self.select(mask, a, b),
            Op::ToInt(..)
            | Op::IntAdd(..)
            | Op::IntSub(..)
            | Op::IntMul(..)
            | Op::And(..)
            | Op::Or(..)
            | Op::Xor(..)
            | Op::Not(..)
            | Op::ShiftLeft(..)
            | Op::ShiftRight(..)
            | Op::ShiftRightSigned(..) => Word { bits: Some(self.int_op(op)), ..Word::default() },
            _ => Word { real: Some(self.real_op(op)), ..Word::default() },
        }
    }

    /// Operations that yield a number.
    fn real_op(&mut self, op: Op) -> Value {
        if let Op::ToReal(a) = op {
            let a = self.bits(a);
            return self.builder.ins().fcvt_from_sint(F32X4, a);
        }
        let mut operands = [None; 3];
        let mut count = 0;
        op.for_each_operand(|id| {
            operands[count] = Some(id);
            count += 1;
        });
        let [a, b, c] = operands.map(|id| id.map(|id| self.real(id)));
        let ins = self.builder.ins();
        match (op, a, b, c) {
            (Op::Add(..), Some(a), Some(b), _) => ins.fadd(a, b),
            (Op::Sub(..), Some(a), Some(b), _) => ins.fsub(a, b),
            (Op::Mul(..), Some(a), Some(b), _) => ins.fmul(a, b),
            (Op::Div(..), Some(a), Some(b), _) => ins.fdiv(a, b),
            (Op::MulAdd(..), Some(a), Some(b), Some(c)) => ins.fma(a, b, c),
            (Op::Minimum(..), Some(a), Some(b), _) => self.pick(a, b, a, b),
            (Op::Maximum(..), Some(a), Some(b), _) => self.pick(b, a, a, b),
            (Op::Neg(..), Some(a), ..) => ins.fneg(a),
            (Op::Absolute(..), Some(a), ..) => ins.fabs(a),
            (Op::Sqrt(..), Some(a), ..) => ins.sqrt(a),
            (Op::Floor(..), Some(a), ..) => ins.floor(a),
            (Op::Ceil(..), Some(a), ..) => ins.ceil(a),
            (Op::Truncate(..), Some(a), ..) => ins.trunc(a),
            (Op::RoundEven(..), Some(a), ..) => ins.nearest(a),
            _ => unreachable!("{op} does not yield a number"),
        }
    }

    /// Operations that yield an integer, or a truth value from truth values.
    fn int_op(&mut self, op: Op) -> Value {
        match op {
            Op::ToInt(a) => {
                let a = self.real(a);
                self.builder.ins().fcvt_to_sint_sat(I32X4, a)
            }
            Op::Not(a) => {
                let a = self.bits(a);
                self.builder.ins().bnot(a)
            }
            Op::ShiftLeft(a, bits) | Op::ShiftRight(a, bits) | Op::ShiftRightSigned(a, bits) => {
                let a = self.bits(a);
                let bits = self.builder.ins().iconst(I32, i64::from(bits & 31));
                let ins = self.builder.ins();
                match op {
                    Op::ShiftLeft(..) => ins.ishl(a, bits),
                    Op::ShiftRight(..) => ins.ushr(a, bits),
                    _ => ins.sshr(a, bits),
                }
            }
            Op::IntAdd(a, b)
            | Op::IntSub(a, b)
            | Op::IntMul(a, b)
            | Op::And(a, b)
            | Op::Or(a, b)
            | Op::Xor(a, b) => {
                let (a, b) = (self.bits(a), self.bits(b));
                let ins = self.builder.ins();
                match op {
                    Op::IntAdd(..) => ins.iadd(a, b),
                    Op::IntSub(..) => ins.isub(a, b),
                    Op::IntMul(..) => ins.imul(a, b),
                    Op::And(..) => ins.band(a, b),
                    Op::Or(..) => ins.bor(a, b),
                    _ => ins.bxor(a, b),
                }
            }
            _ => unreachable!("{op} does not yield an integer"),
        }
    }

    /// `if less < than { if_true } else { if_false }`, of numbers.
    fn pick(&mut self, less: Value, than: Value, if_true: Value, if_false: Value) -> Value {
        let mask = self.builder.ins().fcmp(FloatCC::LessThan, less, than);
        let mask = self.cast(F32X4, mask);
        self.builder.ins().bitselect(mask, if_true, if_false)
    }

    fn compare(&mut self, condition: FloatCC, a: OpId, b: OpId) -> Word {
        let (a, b) = (self.real(a), self.real(b));
        let bits = Some(self.builder.ins().fcmp(condition, a, b));
        Word { bits, mask: Comparison::Real, ..Word::default() }
    }

    fn compare_bits(&mut self, condition: IntCC, a: OpId, b: OpId) -> Word {
        let (a, b) = (self.bits(a), self.bits(b));
        let bits = Some(self.builder.ins().icmp(condition, a, b));
        Word { bits, mask: Comparison::Int, ..Word::default() }
    }

    fn select(&mut self, mask: OpId, a: OpId, b: OpId) -> Word {
        match self.words[mask as usize].mask {
            Comparison::Real => {
                let mask = self.real(mask);
                let (a, b) = (self.real(a), self.real(b));
                let real = Some(self.builder.ins().bitselect(mask, a, b));
                Word { real, ..Word::default() }
            }
            comparison => {
                let mask = self.bits(mask);
                let (a, b) = (self.bits(a), self.bits(b));
                let ins = self.builder.ins();
                let bits = Some(match comparison {
                    Comparison::Int => ins.bitselect(mask, a, b),
                    _ => ins.blendv(mask, a, b),
                });
                Word { bits, ..Word::default() }
            }
        }
    }

    fn load(&mut self, source: u32) -> Word {
        let source = self.segment.sources[source as usize];
        let (base, word) = match source {
            Source::Uniform(at) | Source::Constant { at, .. } => (self.file, at),
            Source::Slot(slot) => (self.at, slot),
        };
        let mut flags = MemFlagsData::new().with_notrap().with_aligned();
        let written = |&(slot, _): &(u32, OpId)| source == Source::Slot(slot);
        if !self.segment.stores.iter().any(written) {
            flags = flags.with_readonly().with_can_move();
        }
        let offset = (word as usize * WORD) as i32;
        let real = Some(self.builder.ins().load(F32X4, flags, base, offset));
        Word { real, ..Word::default() }
    }

    /// The word as numbers.
    fn real(&mut self, id: OpId) -> Value {
        let word = self.words[id as usize];
        let value = word.real.unwrap_or_else(|| match word.bits {
            Some(bits) => self.cast(F32X4, bits),
            None => self.constant(F32X4, id),
        });
        self.words[id as usize].real = Some(value);
        value
    }

    /// The word as integers.
    fn bits(&mut self, id: OpId) -> Value {
        let word = self.words[id as usize];
        let value = word.bits.unwrap_or_else(|| match (word.real, self.segment.ops[id as usize]) {
            (_, Op::Constant(_)) | (None, _) => self.constant(I32X4, id),
            (Some(real), _) => self.cast(I32X4, real),
        });
        self.words[id as usize].bits = Some(value);
        value
    }

    fn cast(&mut self, to: Type, value: Value) -> Value {
        self.builder.ins().bitcast(to, MemFlagsData::new(), value)
    }

    fn constant(&mut self, to: Type, id: OpId) -> Value {
        let Op::Constant(bits) = self.segment.ops[id as usize] else {
            unreachable!("only constants are made late");
        };
        let data = ConstantData::from(&[bits.to_le_bytes(); 4].concat()[..]);
        let constant = self.builder.func.dfg.constants.insert(data);
        self.builder.ins().vconst(to, constant)
    }
}

#[cfg(test)]
mod tests {
    use cranelift_codegen::Context;
    use cranelift_codegen::control::ControlPlane;

    use super::*;
    use crate::engine::jit::JitCode;
    use crate::engine::jit::code::target;

    /// The loop body of two loads, `op` on them and what follows, as assembly.
    fn assembly(ops: &[Op]) -> String {
        let mut list = vec![Op::Load(0), Op::Load(1), Op::Load(2)];
        list.extend(ops);
        let stores = vec![(3, list.len() as u32 - 1)];
        let sources = vec![Source::Slot(0), Source::Slot(1), Source::Slot(2)];
        let segment = OpSegment { ops: list, sources, stores };
        let isa = target("backtracking").expect("the host is x86-64");
        let mut context = Context::new();
        let shape = FileShape { uniforms: 0, slots: 4 };
        let config = isa.frontend_config();
        lower(&segment, shape, config, &mut context.func, &mut FunctionBuilderContext::new());
        context.set_disasm(true);
        let code = context.compile(&*isa, &mut ControlPlane::default()).expect("compiles");
        code.vcode.clone().expect("was asked for")
    }

    /// The patterns instruction selection knows may change with Cranelift: a slip costs time only,
    /// so nothing else would show it.
    #[test]
    fn operations_become_the_instructions_meant() {
        if JitCode::available().is_err() {
            return;
        }
        for (ops, instruction) in [
            (&[Op::Minimum(0, 1)][..], "vminps"),
            (&[Op::Maximum(0, 1)], "vmaxps"),
            (&[Op::MulAdd(0, 1, 2)], "vfmadd"),
            (&[Op::Floor(0)], "vroundps"),
            (&[Op::RoundEven(0)], "vroundps"),
            (&[Op::ToInt(0)], "vcvttps2dq"),
            (&[Op::IntMul(0, 1)], "vpmulld"),
            (&[Op::Less(0, 1), Op::Select(3, 2, 0)], "blendv"),
            (&[Op::IntLess(0, 1), Op::Select(3, 2, 0)], "blendv"),
            (&[Op::Select(0, 1, 2)], "blendv"),
        ] {
            let text = assembly(ops);
            assert!(text.contains(instruction), "{ops:?} without {instruction}:\n{text}");
            assert!(!text.contains("call"), "{ops:?} calls:\n{text}");
            // Loads, the loop's own and one or two for each operation, not a software sequence.
            let lines = text.lines().filter(|line| line.contains("%xmm")).count();
            assert!(lines <= 12, "{ops:?} takes {lines} vector instructions:\n{text}");
        }
    }
}
