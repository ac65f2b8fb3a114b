//! What is known of one word of a value.

use crate::diagnostics::shown;
use crate::emit::Emit;
use crate::emit::interval::{Interval, Intervals, Truth, Whole, Word, derived};
use crate::values::Type;

/// Every source there is: of what nothing is known, not even what it depends on.
pub const ANY_SOURCE: u64 = u64::MAX;

/// Whole numbers up to here are numbers of 32 bits.
const EXACT: i32 = 1 << 24;

/// What is known of one word.
#[derive(Clone, Copy, Debug)]
pub struct Value {
    /// All it may be.
    pub word: Word,
    /// What it surely comes to be; none where that is not known.
    pub reached: Option<Reached>,
    /// What it depends on, a bit for each source. Where there are many sources, some share a bit and
    /// count as one.
    pub sources: u64,
}

/// Values that are surely taken, each for some values of the sources.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// The smallest of them. Of truth: 0 for false, 1 for true.
    pub low: f32,
    /// The largest of them.
    pub high: f32,
    /// Whether all between is reached, too.
    pub connected: bool,
    /// Whether zero is among them.
    pub zero: bool,
}

impl Reached {
    /// All numbers between.
    pub fn all(low: f32, high: f32) -> Self {
        Self { low, high, connected: true, zero: low <= 0.0 && high >= 0.0 }
    }

    /// Whether it is more than one value.
    pub fn varies(&self) -> bool {
        self.low != self.high
    }
}

impl Value {
    /// Nothing is known of it.
    pub fn unknown(value_type: Type) -> Self {
        let word = match value_type {
            Type::Boolean => Word::Truth(Truth::OPEN),
            Type::Integer => Word::Integer(Whole::ANYTHING),
            _ => Word::UNKNOWN,
        };
        Self { word, reached: None, sources: ANY_SOURCE }
    }

    /// Whether it comes to be more than one value.
    pub fn varies(&self) -> bool {
        self.reached.is_some_and(|reached| reached.varies())
    }

    /// A constant, from its bits.
    pub fn constant(value_type: Type, bits: u32) -> Self {
        let word = match value_type {
            Type::Boolean => Word::Truth(Intervals.mask(bits != 0)),
            Type::Integer => Word::Integer(Intervals.int(bits as i32)),
            _ => Word::Number(Interval::constant(f32::from_bits(bits))),
        };
        let reached = number(&word, bits).map(|x| Reached::all(x, x));
        Self { word, reached, sources: 0 }
    }

    /// Bits of a value that is reached: of the first three the smallest, the largest, one between.
    pub fn level(&self, level: usize) -> u32 {
        let Some(Reached { low, high, connected, .. }) = self.reached else { return 0 };
        let x = match level {
            0 => low,
            1 => high,
            _ if !connected => low,
            _ if low < 0.0 && high > 0.0 => 0.0,
            _ => low / 2.0 + high / 2.0,
        };
        match self.word {
            Word::Number(_) => x.to_bits(),
            Word::Integer(_) => x.floor() as i32 as u32,
            Word::Truth(_) if x > 0.5 => u32::MAX,
            Word::Truth(_) => 0,
        }
    }

    /// The same value under another name, where it has none.
    pub fn named(self, identity: u64) -> Self {
        match self.word.identity() {
            0 => Self { word: self.word.known_as(identity), ..self },
            _ => self,
        }
    }

    /// An integer as a number.
    pub fn to_real(self) -> Self {
        match self.word {
            Word::Integer(whole) => {
                use crate::emit::Int;
                Self { word: Word::Number(whole.to_real()), ..self }
            }
            _ => self,
        }
    }

    /// All it may be, in words: "0 to 1", "is always true".
    pub fn described(&self) -> String {
        match self.word {
            Word::Number(Interval { nan: true, .. }) => "any number".into(),
            Word::Number(Interval { low, high, .. }) => described(low.into(), high.into()),
            Word::Integer(Whole { low, high, .. }) => described(low.into(), high.into()),
            Word::Truth(truth) => match truth.decided() {
                Some(true) => "always true".into(),
                Some(false) => "always false".into(),
                None => "true or false".into(),
            },
        }
    }
}

/// The bits of a word of this type as a number; none for what is not exactly one, or not finite.
pub fn number(word: &Word, bits: u32) -> Option<f32> {
    match word {
        Word::Number(_) => Some(f32::from_bits(bits)).filter(|x| x.is_finite()),
        Word::Integer(_) => {
            let whole = bits as i32;
            (-EXACT..=EXACT).contains(&whole).then_some(whole as f32)
        }
        Word::Truth(_) => Some(if bits == 0 { 0.0 } else { 1.0 }),
    }
}

/// One of the names of values that are not made by nodes.
pub fn name_of(kind: u64, at: usize, component: usize) -> u64 {
    derived(kind, &[at as u64 + 1, component as u64 + 1])
}

/// A range in words, its ends to six digits: bounds are known no better.
pub fn described(low: f64, high: f64) -> String {
    let (low, high) = (rounded(low), rounded(high));
    if low == high { low.to_string() } else { shown(&(low..=high)) }
}

fn rounded(x: f64) -> f64 {
    let text = format!("{x:.5e}");
    // Adding zero takes the sign off -0.
    text.parse::<f64>().unwrap_or(x) + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::interval::tag;

    #[test]
    fn ranges_are_told_to_six_digits() {
        assert_eq!(described(-0.0, f64::from(0.1_f32)), "0 to 0.1");
        assert_eq!(described(-1.000_000_4, 1.0), "-1 to 1");
        assert_eq!(described(2.0, 2.0), "2");
        assert_eq!(described(0.0, f64::INFINITY), "0 and above");
        assert_eq!(described(-123_456_789.0, 0.5), "-123457000 to 0.5");
    }

    #[test]
    fn levels_are_values_that_are_reached() {
        let name = name_of(tag("test"), 0, 0);
        let of = |low: f32, high: f32| Value {
            word: Word::Number(Interval::between(low, high, 0, name)),
            reached: Some(Reached::all(low, high)),
            sources: 1,
        };
        let levels = |value: Value| [0, 1, 2].map(|level| f32::from_bits(value.level(level)));
        assert_eq!(levels(of(-1.0, 3.0)), [-1.0, 3.0, 0.0]);
        assert_eq!(levels(of(1.0, 3.0)), [1.0, 3.0, 2.0]);
        let constant = Value::constant(Type::Integer, -7_i32 as u32);
        assert_eq!([0, 1, 2].map(|level| constant.level(level) as i32), [-7; 3]);
        // Past 2^24 not every integer is a number.
        assert_eq!(Value::constant(Type::Integer, i32::MAX as u32).reached, None);
        assert_eq!(Value::constant(Type::Scalar, f32::NAN.to_bits()).reached, None);
    }
}
