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
use cranelift_codegen::ir::types::{F32, F32X4, I32, I32X4, I64};
use cranelift_codegen::ir::{
    AbiParam, BlockArg, ConstantData, Function, InstBuilder, MemFlagsData, Signature, Type, Value,
};
use cranelift_codegen::isa::TargetFrontendConfig;
use cranelift_frontend::{FuncInstBuilder, FunctionBuilder, FunctionBuilderContext};

use crate::emit::Table;
use crate::ops::{Op, OpId, OpSegment};
use crate::storage::{FileShape, Lanes, Source};

/// Bytes of a word of a block.
const WORD: usize = size_of::<Lanes>();
/// Bytes of half a word: four lanes.
const HALF: i64 = 16;

/// Writes the function of `segment` into `function`. Sizes are below 2^31 bytes, and the segment is
/// well formed.
///
/// # Errors
/// For an operation that [`legalise`](crate::ops::legalise) should have replaced.
pub fn lower(
    segment: &OpSegment,
    shape: FileShape,
    config: TargetFrontendConfig,
    function: &mut Function,
    context: &mut FunctionBuilderContext,
) -> Result<(), &'static str> {
    let mut signature = Signature::new(config.default_call_conv);
    signature.params.extend([AbiParam::new(I64); 3]);
    function.signature = signature;
    let mut builder = FunctionBuilder::new(function, context);
    let entry = builder.create_block();
    builder.append_block_params_for_function_params(entry);
    builder.switch_to_block(entry);
    let &[file, before, blocks] = builder.block_params(entry) else {
        return Err("a function has not its three parameters");
    };
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
    Lowering { builder: &mut builder, segment, file, at, words: Vec::new() }.run()?;
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
    Ok(())
}

/// The forms of one word that were asked for.
#[derive(Clone, Copy, Default)]
struct Word {
    real: Option<Value>,
    bits: Option<Value>,
    /// The bits it always has, if it is a constant.
    constant: Option<u32>,
    /// Which comparison made it, if one did.
    mask: Comparison,
}

impl Word {
    fn of_real(value: Value) -> Self {
        Self { real: Some(value), ..Self::default() }
    }

    fn of_bits(value: Value) -> Self {
        Self { bits: Some(value), ..Self::default() }
    }
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
    /// The turn of a half-block: all of it, or nothing where no lane wants it.
    fn run(mut self) -> Result<(), &'static str> {
        let Some(wanted) = self.wanted() else { return self.work() };
        let [work, on] = [(); 2].map(|()| self.builder.create_block());
        let any = self.builder.ins().vany_true(wanted);
        self.builder.ins().brif(any, work, &[], on, &[]);
        self.builder.switch_to_block(work);
        self.work()?;
        self.builder.ins().jump(on, &[]);
        self.builder.switch_to_block(on);
        Ok(())
    }

    /// The lanes that want the segment; none if all do.
    fn wanted(&mut self) -> Option<Value> {
        let mut wanted = None;
        for &mask in &self.segment.wanted {
            let mask = self.row(I32X4, mask);
            wanted = Some(match wanted {
                Some(all) => self.builder.ins().band(all, mask),
                None => mask,
            });
        }
        wanted
    }

    fn work(&mut self) -> Result<(), &'static str> {
        self.words.reserve(self.segment.ops.len());
        for &op in &self.segment.ops {
            let word = self.op(op)?;
            self.words.push(word);
        }
        for &(slot, id) in &self.segment.stores {
            let word = self.words[id as usize];
            let value = word.real.or(word.bits).unwrap_or_else(|| self.bits(id));
            let flags = MemFlagsData::new().with_notrap().with_aligned();
            self.builder.ins().store(flags, value, self.at, (slot as usize * WORD) as i32);
        }
        Ok(())
    }

    /// The word of an operation. Those that [`legalise`](crate::ops::legalise) replaces have none here.
    fn op(&mut self, op: Op) -> Result<Word, &'static str> {
        Ok(match op {
            Op::Load(source) => self.load(source),
            // Made in the form, or forms, asked for.
            Op::Constant(bits) => Word { constant: Some(bits), ..Word::default() },
            Op::Add(a, b) => self.reals([a, b], |ins, [a, b]| ins.fadd(a, b)),
            Op::Sub(a, b) => self.reals([a, b], |ins, [a, b]| ins.fsub(a, b)),
            Op::Mul(a, b) => self.reals([a, b], |ins, [a, b]| ins.fmul(a, b)),
            Op::Div(a, b) => self.reals([a, b], |ins, [a, b]| ins.fdiv(a, b)),
            Op::MulAdd(a, b, c) => self.reals([a, b, c], |ins, [a, b, c]| ins.fma(a, b, c)),
            Op::Minimum(a, b) => self.pick([a, b], [a, b]),
            Op::Maximum(a, b) => self.pick([b, a], [a, b]),
            Op::Neg(a) => self.reals([a], |ins, [a]| ins.fneg(a)),
            Op::Absolute(a) => self.reals([a], |ins, [a]| ins.fabs(a)),
            Op::Sqrt(a) => self.reals([a], |ins, [a]| ins.sqrt(a)),
            Op::Floor(a) => self.reals([a], |ins, [a]| ins.floor(a)),
            Op::Ceil(a) => self.reals([a], |ins, [a]| ins.ceil(a)),
            Op::Truncate(a) => self.reals([a], |ins, [a]| ins.trunc(a)),
            Op::RoundEven(a) => self.reals([a], |ins, [a]| ins.nearest(a)),
            Op::ToReal(a) => {
                let a = self.bits(a);
                Word::of_real(self.builder.ins().fcvt_from_sint(F32X4, a))
            }
            Op::ToInt(a) => {
                let a = self.real(a);
                Word::of_bits(self.builder.ins().fcvt_to_sint_sat(I32X4, a))
            }
            Op::IntAdd(a, b) => self.ints([a, b], |ins, [a, b]| ins.iadd(a, b)),
            Op::IntSub(a, b) => self.ints([a, b], |ins, [a, b]| ins.isub(a, b)),
            Op::IntMul(a, b) => self.ints([a, b], |ins, [a, b]| ins.imul(a, b)),
            Op::And(a, b) => self.ints([a, b], |ins, [a, b]| ins.band(a, b)),
            Op::Or(a, b) => self.ints([a, b], |ins, [a, b]| ins.bor(a, b)),
            Op::Xor(a, b) => self.ints([a, b], |ins, [a, b]| ins.bxor(a, b)),
            Op::Not(a) => self.ints([a], |ins, [a]| ins.bnot(a)),
            Op::ShiftLeft(a, by) => self.shift(a, by, |ins, a, by| ins.ishl(a, by)),
            Op::ShiftRight(a, by) => self.shift(a, by, |ins, a, by| ins.ushr(a, by)),
            Op::ShiftRightSigned(a, by) => self.shift(a, by, |ins, a, by| ins.sshr(a, by)),
            Op::Less(a, b) => self.compare(FloatCC::LessThan, a, b),
            Op::LessEqual(a, b) => self.compare(FloatCC::LessThanOrEqual, a, b),
            Op::Equal(a, b) => self.compare(FloatCC::Equal, a, b),
            Op::NotEqual(a, b) => self.compare(FloatCC::NotEqual, a, b),
            Op::IntEqual(a, b) => self.compare_bits(IntCC::Equal, a, b),
            Op::IntLess(a, b) => self.compare_bits(IntCC::SignedLessThan, a, b),
            Op::Select(mask, a, b) => self.select(mask, a, b),
            Op::Table(table, index) => self.table(table, index),
            Op::Number(_) | Op::Integer(_) | Op::Truth(_) => return Err("a constant has a type"),
            Op::Sin(_)
            | Op::Cos(_)
            | Op::Tan(_)
            | Op::Asin(_)
            | Op::Acos(_)
            | Op::Atan(_)
            | Op::Atan2(..)
            | Op::Exp(_)
            | Op::Exp2(_)
            | Op::Expm1(_)
            | Op::Sinh(_)
            | Op::Cosh(_)
            | Op::Tanh(_)
            | Op::Ln(_)
            | Op::Log2(_)
            | Op::Log1p(_)
            | Op::Pow(..) => {
                return Err("a function is not expanded");
            }
        })
    }

    /// From numbers a number.
    fn reals<const N: usize>(
        &mut self,
        operands: [OpId; N],
        make: impl FnOnce(FuncInstBuilder<'_, '_>, [Value; N]) -> Value,
    ) -> Word {
        let operands = operands.map(|id| self.real(id));
        Word::of_real(make(self.builder.ins(), operands))
    }

    /// From integers an integer, or from truth values one.
    fn ints<const N: usize>(
        &mut self,
        operands: [OpId; N],
        make: impl FnOnce(FuncInstBuilder<'_, '_>, [Value; N]) -> Value,
    ) -> Word {
        let operands = operands.map(|id| self.bits(id));
        Word::of_bits(make(self.builder.ins(), operands))
    }

    fn shift(
        &mut self,
        a: OpId,
        by: u32,
        make: impl FnOnce(FuncInstBuilder<'_, '_>, Value, Value) -> Value,
    ) -> Word {
        let a = self.bits(a);
        let by = self.builder.ins().iconst(I32, i64::from(by & 31));
        Word::of_bits(make(self.builder.ins(), a, by))
    }

    /// `if less < than { a } else { b }`, of numbers.
    fn pick(&mut self, [less, than]: [OpId; 2], [a, b]: [OpId; 2]) -> Word {
        let (a, b) = (self.real(a), self.real(b));
        let (less, than) = (self.real(less), self.real(than));
        let mask = self.builder.ins().fcmp(FloatCC::LessThan, less, than);
        let mask = self.cast(F32X4, mask);
        Word::of_real(self.builder.ins().bitselect(mask, a, b))
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
                Word::of_real(self.builder.ins().bitselect(mask, a, b))
            }
            comparison => {
                let mask = self.bits(mask);
                let (a, b) = (self.bits(a), self.bits(b));
                let ins = self.builder.ins();
                Word::of_bits(match comparison {
                    Comparison::Int => ins.bitselect(mask, a, b),
                    Comparison::Real | Comparison::None => ins.blendv(mask, a, b),
                })
            }
        }
    }

    /// Lane by lane: there is no gather of 128 bits to be had.
    fn table(&mut self, table: Table, index: OpId) -> Word {
        let index = self.bits(index);
        let (first, last) = (self.constant(I32X4, 0), self.constant(I32X4, table.last() as u32));
        let index = self.builder.ins().smax(index, first);
        let index = self.builder.ins().smin(index, last);
        let numbers = self.builder.ins().iconst(I64, table.numbers().as_ptr() as i64);
        let flags =
            MemFlagsData::new().with_notrap().with_aligned().with_readonly().with_can_move();
        let mut found = self.constant(F32X4, 0);
        for lane in 0..4 {
            let at = self.builder.ins().extractlane(index, lane);
            let at = self.builder.ins().uextend(I64, at);
            let bytes = self.builder.ins().ishl_imm_u(at, 2);
            let place = self.builder.ins().iadd(numbers, bytes);
            let number = self.builder.ins().load(F32, flags, place, 0);
            found = self.builder.ins().insertlane(found, number, lane);
        }
        Word::of_real(found)
    }

    fn load(&mut self, source: u32) -> Word {
        Word::of_real(self.row(F32X4, self.segment.sources[source as usize]))
    }

    /// The words of the half-block that lie there.
    fn row(&mut self, form: Type, source: Source) -> Value {
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
        self.builder.ins().load(form, flags, base, offset)
    }

    /// The word as numbers.
    fn real(&mut self, id: OpId) -> Value {
        let word = self.words[id as usize];
        let value = word.real.unwrap_or_else(|| match (word.constant, word.bits) {
            (None, Some(bits)) => self.cast(F32X4, bits),
            (constant, _) => self.constant(F32X4, constant.unwrap_or_default()),
        });
        self.words[id as usize].real = Some(value);
        value
    }

    /// The word as integers.
    fn bits(&mut self, id: OpId) -> Value {
        let word = self.words[id as usize];
        let value = word.bits.unwrap_or_else(|| match (word.constant, word.real) {
            (None, Some(real)) => self.cast(I32X4, real),
            (constant, _) => self.constant(I32X4, constant.unwrap_or_default()),
        });
        self.words[id as usize].bits = Some(value);
        value
    }

    fn cast(&mut self, to: Type, value: Value) -> Value {
        self.builder.ins().bitcast(to, MemFlagsData::new(), value)
    }

    fn constant(&mut self, to: Type, bits: u32) -> Value {
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
    use crate::engine::jit::Generator;
    use crate::engine::jit::cranelift::code::target;

    /// The loop body of two loads, `op` on them and what follows, as assembly.
    fn assembly(ops: &[Op]) -> String {
        let mut list = vec![Op::Load(0), Op::Load(1), Op::Load(2)];
        list.extend(ops);
        let stores = vec![(3, list.len() as u32 - 1)];
        let sources = vec![Source::Slot(0), Source::Slot(1), Source::Slot(2)];
        let segment = OpSegment { ops: list, sources, stores, wanted: vec![] };
        let isa = target("backtracking").expect("the host is x86-64");
        let mut context = Context::new();
        let shape = FileShape { uniforms: 0, slots: 4 };
        let config = isa.frontend_config();
        lower(&segment, shape, config, &mut context.func, &mut FunctionBuilderContext::new())
            .expect("is legal");
        context.set_disasm(true);
        let code = context.compile(&*isa, &mut ControlPlane::default()).expect("compiles");
        code.vcode.clone().expect("was asked for")
    }

    /// The patterns instruction selection knows may change with Cranelift: a slip costs time only,
    /// so nothing else would show it.
    #[test]
    fn operations_become_the_instructions_meant() {
        if Generator::Cranelift.available().is_err() {
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
