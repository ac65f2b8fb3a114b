use crate::emit::Mask;
use crate::nodes::BLACK;

node! {
    /// What a trace yields where it succeeded, else something instead:
    /// `trace_reflection(…) || trace_environment(…)` as shaders write it. Only the colour taken is
    /// evaluated, and it passes unchanged.
    fallback in rays,
    source "mental ray base shaders, mib_reflect",
    inputs {
        /// Whether the first succeeded: the `ok` of a trace.
        ok: boolean = true;
        /// Taken where it did.
        primary: color = BLACK, when i.ok;
        /// Taken where it did not.
        alternative: color = BLACK, when !i.ok;
    }
    outputs {
        /// The colour taken.
        color: color;
    }
    body |e, i| Outputs { color: i.ok.select(i.primary, i.alternative) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn takes_and_demands_one_side() {
        let (a, b) = ([0.1, 0.2, 0.3, 0.4], [f32::NAN; 4]);
        assert_eq!(numbers!(ok = true, primary = a, alternative = b => color), a);
        assert_eq!(numbers!(ok = false, primary = b, alternative = a => color), a);
        for ok in [false, true] {
            assert_eq!(demanded!(ok = ok => primary), ok);
            assert_eq!(demanded!(ok = ok => alternative), !ok);
        }
    }
}
