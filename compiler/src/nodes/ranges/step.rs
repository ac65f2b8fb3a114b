use crate::emit::{Mask, Real};
use crate::nodes::finite::UNIT;

node! {
    /// 1 where the input has reached the edge, 0 below it, per component. GLSL, HLSL and OSL
    /// name the edge first. A colour keeps its alpha.
    step in ranges per component,
    source "RenderMan Interface Specification, step",
    inputs {
        /// Where to look.
        input: generic = 0.0;
        /// Where it goes up.
        edge: generic = 0.5;
    }
    outputs {
        /// 0 or 1.
        result: generic, in UNIT;
    }
    body |e, i| i.input.less(i.edge).select(e.real(0.0), e.real(1.0))
}

#[cfg(test)]
mod tests {
    #[test]
    fn goes_up_at_the_edge() {
        assert_eq!(number!(input = 0.5, edge = 0.5 => result), 1.0);
        assert_eq!(number!(input = 0.5_f32.next_down(), edge = 0.5 => result), 0.0);
    }
}
