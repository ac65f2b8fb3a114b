//! Truth that may be open.

use std::ops::{BitAnd, BitOr, BitXor, Not};

use super::{derived, tag};
use crate::emit::{Mask, Select};

/// What a condition may be: true, false, or either.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Truth {
    /// Whether it may be true.
    pub may_hold: bool,
    /// Whether it may be false.
    pub may_fail: bool,
    /// See [`Word::reads`](super::Word::reads).
    pub reads: u64,
    /// See [`Word::identity`](super::Word::identity).
    pub identity: u64,
}

impl Truth {
    /// Either, of unknown origin.
    pub const OPEN: Truth = Truth { may_hold: true, may_fail: true, reads: 0, identity: 0 };

    /// One truth value.
    pub fn constant(value: bool) -> Self {
        let identity = derived(const { tag("truth") }, &[u64::from(value) + 1]);
        Self { may_hold: value, may_fail: !value, reads: 0, identity }
    }

    /// The value, where it is decided.
    pub fn decided(self) -> Option<bool> {
        (self.may_hold != self.may_fail).then_some(self.may_hold)
    }

    /// What a comparison yields: decided ones are constants, whatever was compared.
    pub(super) fn of_comparison(may_hold: bool, may_fail: bool, reads: u64, identity: u64) -> Self {
        let truth = Self { may_hold, may_fail, reads, identity };
        truth.decided().map_or(truth, Self::constant)
    }

    fn joined(self, other: Self, operation: u64, truth: impl Fn(bool, bool) -> bool) -> Self {
        let possible = |mask: Self| [mask.may_fail, mask.may_hold];
        let (mut may_hold, mut may_fail) = (false, false);
        for (a, a_possible) in possible(self).into_iter().enumerate() {
            for (b, b_possible) in possible(other).into_iter().enumerate() {
                let consistent = a == b || !same(self.identity, other.identity);
                if a_possible && b_possible && consistent {
                    match truth(a == 1, b == 1) {
                        true => may_hold = true,
                        false => may_fail = true,
                    }
                }
            }
        }
        let identity = derived(operation, &[self.identity, other.identity]);
        Self::of_comparison(may_hold, may_fail, self.reads | other.reads, identity)
    }
}

/// Whether two identities tell of one value; 0 is that of what is unknown.
pub(super) fn same(a: u64, b: u64) -> bool {
    a == b && a != 0
}

impl BitAnd for Truth {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        self.joined(other, const { tag("and") }, |a, b| a & b)
    }
}

impl BitOr for Truth {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        self.joined(other, const { tag("or") }, |a, b| a | b)
    }
}

impl BitXor for Truth {
    type Output = Self;
    fn bitxor(self, other: Self) -> Self {
        self.joined(other, const { tag("xor") }, |a, b| a ^ b)
    }
}

impl Not for Truth {
    type Output = Self;
    fn not(self) -> Self {
        self.joined(Self::constant(true), const { tag("xor") }, |a, b| a ^ b)
    }
}

impl Select<Truth> for Truth {
    fn select(mask: Truth, if_true: Self, if_false: Self) -> Self {
        match mask.decided() {
            Some(true) => if_true,
            Some(false) => if_false,
            None => {
                let operands = [mask.identity, if_true.identity, if_false.identity];
                Self::of_comparison(
                    if_true.may_hold | if_false.may_hold,
                    if_true.may_fail | if_false.may_fail,
                    mask.reads | if_true.reads | if_false.reads,
                    derived(const { tag("select") }, &operands),
                )
            }
        }
    }
}

impl Mask for Truth {}
