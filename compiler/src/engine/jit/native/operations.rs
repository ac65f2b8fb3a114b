//! Each operation as instructions.

use super::assembler::{Form, Operand, Shift, Ymm};
use super::function::Writer;
use crate::emit::Table;
use crate::ops::{Op, OpId};

/// Conditions of `vcmpps`; those that hold of numbers only are false for NaN.
const EQUAL: u8 = 0x00;
const NOT_EQUAL_OR_NAN: u8 = 0x04;
const BOTH_NUMBERS: u8 = 0x07;
const LESS: u8 = 0x11;
const LESS_OR_EQUAL: u8 = 0x12;
const GREATER_OR_EQUAL: u8 = 0x1d;
const GREATER: u8 = 0x1e;

/// Modes of `vroundps`, without raising "inexact".
const TO_EVEN: u8 = 8;
const DOWN: u8 = 9;
const UP: u8 = 10;
const TOWARDS_ZERO: u8 = 11;

const SIGN: u32 = 0x8000_0000;
const ALL: u32 = u32::MAX;
/// 2^31, the first number that no integer has.
const PAST_INTEGERS: u32 = 0x4f00_0000;

impl Writer<'_> {
    /// Writes operation `id`, whose operands are `ids`, those of a fused multiplication with these signs.
    pub(super) fn write(
        &mut self,
        id: OpId,
        op: Op,
        ids: [OpId; 3],
        signs: [bool; 2],
    ) -> Result<(), &'static str> {
        match op {
            Op::Load(_) | Op::Constant(_) => self.fetch(id, op),
            Op::Add(a, b) => self.commutative(Form::ADD, id, a, b),
            Op::Sub(a, b) => self.ordered(Form::SUB, id, a, b),
            Op::Mul(a, b) => self.commutative(Form::MUL, id, a, b),
            Op::Div(a, b) => self.ordered(Form::DIV, id, a, b),
            Op::MulAdd(..) => self.mul_add(id, ids, signs),
            // These yield their second source for NaN and for equal zeros, as defined.
            Op::Minimum(a, b) => self.ordered(Form::MIN, id, a, b),
            Op::Maximum(a, b) => self.ordered(Form::MAX, id, a, b),
            Op::Neg(a) => self.with_constant(Form::XOR, id, a, SIGN),
            Op::Absolute(a) => self.with_constant(Form::AND, id, a, !SIGN),
            Op::Sqrt(a) => self.unary(Form::SQRT, id, a),
            Op::Floor(a) => self.round(DOWN, id, a),
            Op::Ceil(a) => self.round(UP, id, a),
            Op::Truncate(a) => self.round(TOWARDS_ZERO, id, a),
            Op::RoundEven(a) => self.round(TO_EVEN, id, a),
            Op::ToReal(a) => self.unary(Form::TO_REAL, id, a),
            Op::ToInt(a) => self.integer(id, a),
            Op::IntAdd(a, b) => self.commutative(Form::INT_ADD, id, a, b),
            Op::IntSub(a, b) => self.ordered(Form::INT_SUB, id, a, b),
            Op::IntMul(a, b) => self.commutative(Form::INT_MUL, id, a, b),
            Op::And(a, b) => self.commutative(Form::AND, id, a, b),
            Op::Or(a, b) => self.commutative(Form::OR, id, a, b),
            Op::Xor(a, b) => self.commutative(Form::XOR, id, a, b),
            Op::Not(a) => self.with_constant(Form::XOR, id, a, ALL),
            Op::ShiftLeft(a, bits) => self.shift(Shift::Left, id, a, bits),
            Op::ShiftRight(a, bits) => self.shift(Shift::Right, id, a, bits),
            Op::ShiftRightSigned(a, bits) => self.shift(Shift::RightSigned, id, a, bits),
            Op::Less(a, b) => self.compare([LESS, GREATER], id, a, b),
            Op::LessEqual(a, b) => self.compare([LESS_OR_EQUAL, GREATER_OR_EQUAL], id, a, b),
            Op::Equal(a, b) => self.compare([EQUAL; 2], id, a, b),
            Op::NotEqual(a, b) => self.compare([NOT_EQUAL_OR_NAN; 2], id, a, b),
            Op::IntEqual(a, b) => self.commutative(Form::INT_EQUAL, id, a, b),
            Op::IntLess(a, b) => self.ordered(Form::INT_GREATER, id, b, a),
            Op::Select(mask, a, b) => self.select(id, mask, a, b),
            Op::Table(table, index) => self.table(id, table, index),
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
            | Op::Pow(..) => return Err("a function is not expanded"),
        }
        Ok(())
    }

    fn unary(&mut self, form: Form, id: OpId, a: OpId) {
        let from = self.registers.operand(a);
        let to = self.result(id, &[a]);
        self.registers.assembler.unary(form, to, from);
    }

    fn round(&mut self, mode: u8, id: OpId, a: OpId) {
        let from = self.registers.operand(a);
        let to = self.result(id, &[a]);
        self.registers.assembler.round(mode, to, from);
    }

    fn shift(&mut self, shift: Shift, id: OpId, a: OpId, bits: u32) {
        let from = self.registers.register(a);
        let to = self.result(id, &[a]);
        self.registers.assembler.shift(shift, to, from, (bits & 31) as u8);
    }

    fn ordered(&mut self, form: Form, id: OpId, a: OpId, b: OpId) {
        let first = self.registers.register(a);
        let second = self.registers.operand(b);
        let to = self.result(id, &[a, b]);
        self.registers.assembler.binary(form, to, first, second);
    }

    /// Only the last operand of an instruction may be in memory.
    fn commutative(&mut self, form: Form, id: OpId, a: OpId, b: OpId) {
        match self.registers.has_register(a) || !self.registers.has_register(b) {
            true => self.ordered(form, id, a, b),
            false => self.ordered(form, id, b, a),
        }
    }

    fn with_constant(&mut self, form: Form, id: OpId, a: OpId, bits: u32) {
        let first = self.registers.register(a);
        let second = self.constant(bits);
        let to = self.result(id, &[a]);
        self.registers.assembler.binary(form, to, first, second);
    }

    /// The second condition is the first with its sides exchanged.
    fn compare(&mut self, [condition, exchanged]: [u8; 2], id: OpId, a: OpId, b: OpId) {
        let keeps = self.registers.has_register(a) || !self.registers.has_register(b);
        let (condition, a, b) = if keeps { (condition, a, b) } else { (exchanged, b, a) };
        let first = self.registers.register(a);
        let second = self.registers.operand(b);
        let to = self.result(id, &[a, b]);
        self.registers.assembler.compare(condition, to, first, second);
    }

    /// A mask is all bits or none in each lane, so that beside a side of no bits, or all, it does not take a blend.
    fn select(&mut self, id: OpId, mask: OpId, a: OpId, b: OpId) {
        match (self.bits(a), self.bits(b)) {
            (_, Some(0)) => return self.commutative_of(Form::AND, id, [mask, a], b),
            (Some(ALL), _) => return self.commutative_of(Form::OR, id, [mask, b], a),
            (Some(0), _) => {
                let first = self.registers.register(mask);
                let second = self.registers.operand(b);
                let to = self.result(id, &[mask, a, b]);
                self.registers.assembler.binary(Form::AND_NOT, to, first, second);
                return;
            }
            _ => {}
        }
        let by = self.registers.register(mask);
        let if_false = self.registers.register(b);
        let if_true = self.registers.operand(a);
        let to = self.result(id, &[mask, a, b]);
        self.registers.assembler.blend(to, if_false, if_true, by);
    }

    /// The same of two operands, where a third is not looked at.
    fn commutative_of(&mut self, form: Form, id: OpId, of: [OpId; 2], third: OpId) {
        let exchange = !self.registers.has_register(of[0]) && self.registers.has_register(of[1]);
        let [a, b] = if exchange { [of[1], of[0]] } else { of };
        let first = self.registers.register(a);
        let second = self.registers.operand(b);
        let to = self.result(id, &[a, b, third]);
        self.registers.assembler.binary(form, to, first, second);
    }

    /// The instruction yields `i32::MIN` for whatever does not fit: flipped to `i32::MAX` above the range,
    /// cleared for NaN.
    fn integer(&mut self, id: OpId, a: OpId) {
        let from = self.registers.register(a);
        let kept = self.registers.temporary();
        let past = self.constant(PAST_INTEGERS);
        let to = self.registers.result(id);
        let assembler = &mut *self.registers.assembler;
        assembler.unary(Form::TO_INT, to, from.into());
        assembler.compare(GREATER_OR_EQUAL, kept, from, past);
        assembler.binary(Form::XOR, to, to, kept.into());
        assembler.compare(BOTH_NUMBERS, kept, from, from.into());
        assembler.binary(Form::AND, to, to, kept.into());
        self.registers.release(kept);
        self.registers.used(&[a], self.position);
    }

    fn table(&mut self, id: OpId, table: Table, index: OpId) {
        let from = self.registers.register(index);
        let (within, mask) = (self.registers.temporary(), self.registers.temporary());
        let (first, last) = (self.constant(0), self.constant(table.last() as u32));
        let to = self.registers.result(id);
        let assembler = &mut *self.registers.assembler;
        assembler.binary(Form::INT_MAX, within, from, first);
        assembler.binary(Form::INT_MIN, within, within, last);
        assembler.binary(Form::INT_EQUAL, mask, mask, mask.into());
        assembler.gather(to, table.numbers().as_ptr() as u64, within, mask);
        self.registers.release(within);
        self.registers.release(mask);
        self.registers.used(&[index], self.position);
    }

    /// The instruction overwrites one operand: one that is not needed any more, else one that has to be fetched
    /// from memory anyway, else a copy.
    fn mul_add(&mut self, id: OpId, [a, b, c]: [OpId; 3], signs: [bool; 2]) {
        let forms = forms(signs);
        let ids = [a, b, c];
        for (at, &operand) in ids.iter().enumerate() {
            // What is in a register stays there; of what comes twice only one could be in memory.
            if self.registers.has_register(operand) || ids[..at].contains(&operand) {
                self.registers.register(operand);
            }
        }
        let dying =
            ids.map(|id| self.registers.has_register(id) && self.registers.dies(id, self.position));
        let absent = ids.map(|id| !self.registers.has_register(id));
        // Which operand is overwritten, and whether it is fetched into the result's register.
        let (over, fetched) = match (dying, absent) {
            ([_, _, true], _) => (2, false),
            ([true, ..], _) => (0, false),
            ([_, true, _], _) => (1, false),
            (_, [_, _, true]) => (2, true),
            (_, [true, ..]) => (0, true),
            (_, [_, true, _]) => (1, true),
            _ => (2, true),
        };
        // The others: the second may stay in memory.
        let (form, mut second, mut third) = match over {
            2 => (forms[2], a, b),
            0 => (forms[1], b, c),
            _ => (forms[1], a, c),
        };
        let mut form = form;
        if !self.registers.has_register(second) && self.registers.has_register(third) {
            (second, third) = (third, second);
            // d * third + second.
            form = if over == 2 { form } else { forms[0] };
        }
        let first_source = self.registers.register(second);
        let last = self.registers.operand(third);
        let to = self.overwritten(ids[over], fetched);
        self.registers.assembler.binary(form, to, first_source, last);
        self.registers.used(&ids, self.position);
        self.registers.hold(to, id);
    }

    /// The register that an operand is overwritten in.
    fn overwritten(&mut self, operand: OpId, fetched: bool) -> Ymm {
        let from = self.registers.operand(operand);
        match from {
            Operand::Register(register) if !fetched => register,
            from => {
                let to = self.registers.temporary();
                self.registers.assembler.unary(Form::MOVE, to, from);
                to
            }
        }
    }
}

/// The forms 132, 213 and 231 of a fused multiplication whose product, and what is added, have these signs.
fn forms([product, addend]: [bool; 2]) -> [Form; 3] {
    match (product, addend) {
        (false, false) => [Form::MUL_ADD_132, Form::MUL_ADD_213, Form::MUL_ADD_231],
        (false, true) => [Form::MUL_SUB_132, Form::MUL_SUB_213, Form::MUL_SUB_231],
        (true, false) => [Form::NEG_MUL_ADD_132, Form::NEG_MUL_ADD_213, Form::NEG_MUL_ADD_231],
        (true, true) => [Form::NEG_MUL_SUB_132, Form::NEG_MUL_SUB_213, Form::NEG_MUL_SUB_231],
    }
}
