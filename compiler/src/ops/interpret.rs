//! What the operations mean, one word at a time: the oracle the JIT is tested against.
//!
//! Functions aside it shares nothing with [`crate::emit::scalar`], so that a slip in one shows against the other.

use super::{Op, OpId, OpSegment};
use crate::emit::Real;
use crate::emit::scalar::F32;
use crate::storage::{LANES, Lanes, Source};

/// The word `op` yields. `load` gives the words of sources, `value` those of operands.
pub fn evaluate(op: Op, load: impl Fn(u32) -> u32, value: impl Fn(OpId) -> u32) -> u32 {
    let real = |id| f32::from_bits(value(id));
    let int = |id| value(id) as i32;
    let mask = |truth: bool| if truth { u32::MAX } else { 0 };
    match op {
        Op::Load(source) => load(source),
        Op::Constant(bits) => bits,
        Op::Number(number) => (number.value() as f32).to_bits(),
        Op::Integer(value) => value as u32,
        Op::Truth(value) => mask(value),
        Op::Table(table, index) => {
            let last = table.numbers().len() as i64 - 1;
            table.numbers()[i64::from(int(index)).clamp(0, last) as usize].to_bits()
        }
        Op::Add(a, b) => (real(a) + real(b)).to_bits(),
        Op::Sub(a, b) => (real(a) - real(b)).to_bits(),
        Op::Mul(a, b) => (real(a) * real(b)).to_bits(),
        Op::Div(a, b) => (real(a) / real(b)).to_bits(),
        Op::Neg(a) => value(a) ^ 0x8000_0000,
        Op::MulAdd(a, b, c) => fused(real(a), real(b), real(c)).to_bits(),
        Op::Minimum(a, b) => value(if real(a) < real(b) { a } else { b }),
        Op::Maximum(a, b) => value(if real(b) < real(a) { a } else { b }),
        Op::Absolute(a) => value(a) & 0x7fff_ffff,
        Op::Sqrt(a) => real(a).sqrt().to_bits(),
        Op::Floor(a) => real(a).floor().to_bits(),
        Op::Ceil(a) => real(a).ceil().to_bits(),
        Op::Truncate(a) => real(a).trunc().to_bits(),
        Op::RoundEven(a) => real(a).round_ties_even().to_bits(),
        Op::Less(a, b) => mask(real(a) < real(b)),
        Op::LessEqual(a, b) => mask(real(a) <= real(b)),
        Op::Equal(a, b) => mask(real(a) == real(b)),
        Op::NotEqual(a, b) => mask(real(a) != real(b)),
        Op::ToInt(a) => to_int(real(a)) as u32,
        Op::IntAdd(a, b) => value(a).wrapping_add(value(b)),
        Op::IntSub(a, b) => value(a).wrapping_sub(value(b)),
        Op::IntMul(a, b) => value(a).wrapping_mul(value(b)),
        Op::And(a, b) => value(a) & value(b),
        Op::Or(a, b) => value(a) | value(b),
        Op::Xor(a, b) => value(a) ^ value(b),
        Op::Not(a) => !value(a),
        Op::ShiftLeft(a, bits) => value(a) << (bits & 31),
        Op::ShiftRight(a, bits) => value(a) >> (bits & 31),
        Op::ShiftRightSigned(a, bits) => (int(a) >> (bits & 31)) as u32,
        Op::IntEqual(a, b) => mask(value(a) == value(b)),
        Op::IntLess(a, b) => mask(int(a) < int(b)),
        Op::ToReal(a) => (int(a) as f32).to_bits(),
        Op::Select(mask, a, b) => value(if value(mask) != 0 { a } else { b }),
        // What a function is, its expansion says, in the operations above.
        Op::Sin(a) => F32(real(a)).sin().0.to_bits(),
        Op::Cos(a) => F32(real(a)).cos().0.to_bits(),
        Op::Tan(a) => F32(real(a)).tan().0.to_bits(),
        Op::Asin(a) => F32(real(a)).asin().0.to_bits(),
        Op::Acos(a) => F32(real(a)).acos().0.to_bits(),
        Op::Atan(a) => F32(real(a)).atan().0.to_bits(),
        Op::Exp(a) => F32(real(a)).exp().0.to_bits(),
        Op::Exp2(a) => F32(real(a)).exp2().0.to_bits(),
        Op::Expm1(a) => F32(real(a)).expm1().0.to_bits(),
        Op::Sinh(a) => F32(real(a)).sinh().0.to_bits(),
        Op::Cosh(a) => F32(real(a)).cosh().0.to_bits(),
        Op::Tanh(a) => F32(real(a)).tanh().0.to_bits(),
        Op::Ln(a) => F32(real(a)).ln().0.to_bits(),
        Op::Log2(a) => F32(real(a)).log2().0.to_bits(),
        Op::Log1p(a) => F32(real(a)).log1p().0.to_bits(),
        Op::Atan2(y, x) => F32(real(y)).atan2(F32(real(x))).0.to_bits(),
        Op::Pow(a, b) => F32(real(a)).pow(F32(real(b))).0.to_bits(),
    }
}

/// Runs a segment over `blocks` blocks of a file, those aside in which no lane wants it.
///
/// # Panics
/// If the file is smaller than `uniforms + blocks * slots`, or the segment reaches outside.
pub fn run(segment: &OpSegment, uniforms: usize, slots: usize, lanes: &mut [Lanes], blocks: usize) {
    let mut values = vec![0; segment.ops.len()];
    for block in 0..blocks {
        let first = uniforms + block * slots;
        let at = |source| match source {
            Source::Uniform(at) | Source::Constant { at, .. } => at as usize,
            Source::Slot(slot) => first + slot as usize,
        };
        let wants = |lane: usize| segment.wanted.iter().all(|&mask| lanes[at(mask)].0[lane] != 0);
        if !(0..LANES).any(wants) {
            continue;
        }
        for lane in 0..LANES {
            for (id, &op) in segment.ops.iter().enumerate() {
                let load = |n: u32| lanes[at(segment.sources[n as usize])].0[lane];
                values[id] = evaluate(op, load, |id| values[id as usize]);
            }
            for &(slot, id) in &segment.stores {
                lanes[first + slot as usize].0[lane] = values[id as usize];
            }
        }
    }
}

/// Rust's `as i32`, spelled out.
fn to_int(value: f32) -> i32 {
    if value.is_nan() {
        0
    } else if value >= 2_147_483_648.0 {
        i32::MAX
    } else if value < -2_147_483_648.0 {
        i32::MIN
    } else {
        // In range, hence exact: the conversion of an integer that fits.
        f64::from(value).trunc() as i32
    }
}

/// `a * b + c` rounded once, without a fused instruction: the product is exact in `f64`, the sum is
/// rounded to odd there (Boldo and Melquiond, "Emulation of FMA and correctly rounded sums: proved
/// algorithms using rounding to odd", 2008), which makes the second rounding harmless.
fn fused(a: f32, b: f32, c: f32) -> f32 {
    let product = f64::from(a) * f64::from(b);
    let c = f64::from(c);
    let sum = product + c;
    if !sum.is_finite() || sum == 0.0 {
        return sum as f32;
    }
    // Knuth's two-sum: the exact error of `product + c`.
    let c_part = sum - product;
    let error = (product - (sum - c_part)) + (c - c_part);
    let bits = sum.to_bits();
    if error == 0.0 || bits & 1 == 1 {
        return sum as f32;
    }
    let away_from_zero = (error > 0.0) == (sum > 0.0);
    f64::from_bits(if away_from_zero { bits + 1 } else { bits - 1 }) as f32
}
