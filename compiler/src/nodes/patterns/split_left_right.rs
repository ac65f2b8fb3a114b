use crate::emit::{Mask, Real};
use crate::nodes::finite::{SUMMAND, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Two values with a hard edge: `left` where u is below `center`, else `right`. Only the value that is
    /// due is evaluated. MaterialX's `splitlr`, which in some renderers softens the edge by a pixel.
    split_left_right in patterns generic,
    source "MaterialX 1.39, splitlr",
    inputs {
        /// Where to look.
        u: scalar = state(Field::U);
        /// Where the edge is.
        center: scalar = 0.5, soft UNIT;
        /// Value on the left.
        left: generic = 0.0, in SUMMAND, when i.u.less(i.center);
        /// Value on the right.
        right: generic = 1.0, in SUMMAND, when !i.u.less(i.center);
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| Outputs { result: i.u.less(i.center).select(i.left, i.right) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_edge_belongs_to_the_right() {
        for (u, value) in [(0.5_f32.next_down(), 0.0), (0.5, 1.0), (-1e9, 0.0), (f32::NAN, 1.0)] {
            assert_eq!(number!(u = u => result), value, "{u}");
            assert_eq!(demanded!(u = u => left), value == 0.0);
            assert_eq!(demanded!(u = u => right), value == 1.0);
        }
    }
}
