//! Numbers that look like chance, made from integers: the last steps of Jenkins's lookup3, as OSL,
//! MaterialX and Cycles have them, so that their noises and ours have the same values.
//!
//! Source: Jenkins 2006, lookup3. Integers wrap, so every number of 32 bits is taken; the interval
//! analysis knows nothing of the results but their range.

use crate::emit::{Int, Real};

/// Turned to the left by so many bits, 1 to 31.
#[inline(always)]
fn rotated<I: Int>(bits: I, by: u32) -> I {
    bits.shift_left(by) | bits.shift_right(32 - by)
}

/// `(x ^ y) - (y turned)`, the step of the final mix.
#[inline(always)]
fn stepped<I: Int>(x: I, y: I, by: u32) -> I {
    (x ^ y) - rotated(y, by)
}

/// The final mix of three integers.
#[inline(always)]
fn finished<I: Int>(a: I, b: I, c: I) -> I {
    let c = stepped(c, b, 14);
    let a = stepped(a, c, 11);
    let b = stepped(b, a, 25);
    let c = stepped(c, b, 16);
    let a = stepped(a, c, 4);
    let b = stepped(b, a, 14);
    stepped(c, b, 24)
}

/// The mix between blocks of three integers.
#[inline(always)]
fn stirred<I: Int>([a, b, c]: [I; 3]) -> [I; 3] {
    let a = (a - c) ^ rotated(c, 4);
    let c = c + b;
    let b = (b - a) ^ rotated(a, 6);
    let a = a + c;
    let c = (c - b) ^ rotated(b, 8);
    let b = b + a;
    let a = (a - c) ^ rotated(c, 16);
    let c = c + b;
    let b = (b - a) ^ rotated(a, 19);
    let a = a + c;
    let c = (c - b) ^ rotated(b, 4);
    [a, b + a, c]
}

/// One of `numbers` added to the seed, where there is such a one.
#[inline(always)]
fn added<I: Int>(seed: I, numbers: &[I], at: usize) -> I {
    if at < numbers.len() { seed + numbers[at] } else { seed }
}

/// 32 bits from one to five integers: other bits for other numbers, and for another count of them.
#[inline(always)]
pub fn hash<I: Int>(numbers: &[I]) -> I {
    let count = numbers.len() as u32;
    let seed = numbers[0].same(0xdead_beef_u32.wrapping_add(count * 4 + 13) as i32);
    let (a, b, c) = (added(seed, numbers, 0), added(seed, numbers, 1), added(seed, numbers, 2));
    if count <= 3 {
        return finished(a, b, c);
    }
    let [a, b, c] = stirred([a, b, c]);
    finished(added(a, numbers, 3), added(b, numbers, 4), c)
}

/// Bits as a number from 0 to 1, both included: read as unsigned, rounded to 32 bits once, and divided
/// by 2^32.
#[inline(always)]
pub fn share<I: Int>(bits: I) -> I::Real {
    let high = bits.shift_right(16).to_real();
    let low = (bits & bits.same(0xffff)).to_real();
    high.mul_add(high.same(65536.0), low) * high.same(1.0 / 4_294_967_296.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::Emit;
    use crate::emit::scalar::{F32, I32, Scalar};

    /// The values themselves are held by `compiler/tests/noises.rs`.
    #[test]
    fn all_counts_differ_and_are_spread() {
        let mut seen = std::collections::HashSet::new();
        let mut sum = 0.0_f32;
        for x in -20..20 {
            let numbers = [x, 3, -7, 0, 1].map(|number| Scalar.int(number));
            for count in 1..=5 {
                let bits: I32 = hash(&numbers[..count]);
                assert!(seen.insert(bits.0), "{x}, {count}");
                sum += share(bits).0;
            }
        }
        assert!((0.45..0.55).contains(&(sum / 200.0)), "{sum}");
    }

    #[test]
    fn bits_are_unsigned_and_rounded_once() {
        for (bits, exact) in [
            (0, 0.0),
            (1, 2_f32.powi(-32)),
            (i32::MIN, 0.5),
            (-1, 1.0),
            (0x0100_0001, 16_777_216.0 / 4_294_967_296.0),
            (0x0100_0003, 16_777_220.0 / 4_294_967_296.0),
        ] {
            let F32(found) = share(Scalar.int(bits));
            assert_eq!(found, exact, "{bits:x}");
        }
    }
}
