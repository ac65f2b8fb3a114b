//! How deep rays are traced.

/// Largest of each number of a trace depth.
pub const DEPTH_LIMIT: i32 = 32;

/// mental ray's trace depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TraceDepth {
    /// Most reflections on a path.
    pub reflection: i32,
    /// Most refractions and transparencies on a path.
    pub refraction: i32,
    /// Most of both together.
    pub sum: i32,
}

impl Default for TraceDepth {
    /// 6 reflections, 6 refractions, 6 together.
    fn default() -> Self {
        Self { reflection: 6, refraction: 6, sum: 6 }
    }
}

impl TraceDepth {
    /// From one to three numbers, as mental ray reads them: `a` is a reflections, a refractions and
    /// 2a together; `a b` a + b together; `a b c` c together. None for another count, or numbers
    /// out of 0..=[`DEPTH_LIMIT`].
    pub fn from_numbers(numbers: &[i32]) -> Option<Self> {
        let (reflection, refraction, sum) = match *numbers {
            [a] => (a, a, a.checked_mul(2)?),
            [a, b] => (a, b, a.checked_add(b)?),
            [a, b, c] => (a, b, c),
            _ => return None,
        };
        let range = 0..=DEPTH_LIMIT;
        let fits = range.contains(&reflection) && range.contains(&refraction) && sum >= 0;
        fits.then_some(Self { reflection, refraction, sum: sum.min(2 * DEPTH_LIMIT) })
    }

    /// Whether a path with these levels may be reflected once more.
    #[inline]
    pub fn allows_reflection(&self, reflections: i32, refractions: i32) -> bool {
        reflections < self.reflection && reflections.saturating_add(refractions) < self.sum
    }

    /// Whether a path with these levels may be refracted, or go on unbent, once more.
    #[inline]
    pub fn allows_refraction(&self, reflections: i32, refractions: i32) -> bool {
        refractions < self.refraction && reflections.saturating_add(refractions) < self.sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_two_and_three_numbers() {
        let depth = |numbers: &[i32]| TraceDepth::from_numbers(numbers);
        assert_eq!(depth(&[3]), Some(TraceDepth { reflection: 3, refraction: 3, sum: 6 }));
        assert_eq!(depth(&[3, 1]), Some(TraceDepth { reflection: 3, refraction: 1, sum: 4 }));
        assert_eq!(depth(&[3, 1, 2]), Some(TraceDepth { reflection: 3, refraction: 1, sum: 2 }));
        for wrong in [&[][..], &[-1], &[33], &[i32::MAX], &[1, 1, -1], &[1, 1, 1, 1]] {
            assert_eq!(depth(wrong), None, "{wrong:?}");
        }
    }

    #[test]
    fn levels_are_held_against_both_limits() {
        let depth = TraceDepth::from_numbers(&[2, 1, 2]).unwrap();
        assert!(depth.allows_reflection(1, 0) && !depth.allows_reflection(2, 0));
        assert!(!depth.allows_reflection(1, 1));
        assert!(depth.allows_refraction(1, 0) && !depth.allows_refraction(0, 1));
        assert!(!TraceDepth::from_numbers(&[0]).unwrap().allows_reflection(0, 0));
        assert!(!depth.allows_reflection(i32::MAX, i32::MAX));
    }
}
