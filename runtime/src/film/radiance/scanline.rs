//! How scanlines are written.

use std::ops::RangeInclusive;

/// Widths of scanlines whose run lengths are by component.
pub(super) const RUN_WIDTHS: RangeInclusive<usize> = 8..=0x7fff;
