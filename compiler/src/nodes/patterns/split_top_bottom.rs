use crate::emit::{Mask, Real};
use crate::nodes::finite::{SUMMAND, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Two values with a hard edge: `bottom` where v is below `center`, else `top`. Only the value that is
    /// due is evaluated. MaterialX's `splittb`, which in some renderers softens the edge by a pixel.
    split_top_bottom in patterns generic,
    source "MaterialX 1.39, splittb",
    inputs {
        /// Where to look.
        v: scalar = state(Field::V);
        /// Where the edge is.
        center: scalar = 0.5, soft UNIT;
        /// Value above.
        top: generic = 1.0, in SUMMAND, when !i.v.less(i.center);
        /// Value below.
        bottom: generic = 0.0, in SUMMAND, when i.v.less(i.center);
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| Outputs { result: i.v.less(i.center).select(i.bottom, i.top) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_edge_belongs_to_the_top() {
        for (v, value) in [(0.5_f32.next_down(), 0.0), (0.5, 1.0), (-1e9, 0.0), (f32::NAN, 1.0)] {
            assert_eq!(number!(v = v => result), value, "{v}");
            assert_eq!(demanded!(v = v => top), value == 1.0);
            assert_eq!(demanded!(v = v => bottom), value == 0.0);
        }
    }
}
