//! What can be compared: numbers, and integers without becoming numbers.

use super::{Int, One, Real, Select};

/// Values in an order, compared lane by lane.
pub trait Ordered<M>: Copy + Select<M> {
    /// `self < other`; false where either is NaN.
    fn less(self, other: Self) -> M;
    /// `self <= other`; false where either is NaN.
    fn less_equal(self, other: Self) -> M;
    /// `self == other`; false where either is NaN; -0 equals 0.
    fn equal(self, other: Self) -> M;
}

impl<R: Real> Ordered<R::Mask> for One<R> {
    #[inline(always)]
    fn less(self, other: Self) -> R::Mask {
        self.x.less(other.x)
    }
    #[inline(always)]
    fn less_equal(self, other: Self) -> R::Mask {
        self.x.less_equal(other.x)
    }
    #[inline(always)]
    fn equal(self, other: Self) -> R::Mask {
        self.x.equal(other.x)
    }
}

impl<I: Int> Ordered<I::Mask> for I {
    #[inline(always)]
    fn less(self, other: Self) -> I::Mask {
        Int::less(self, other)
    }
    #[inline(always)]
    fn less_equal(self, other: Self) -> I::Mask {
        !Int::less(other, self)
    }
    #[inline(always)]
    fn equal(self, other: Self) -> I::Mask {
        Int::equal(self, other)
    }
}
