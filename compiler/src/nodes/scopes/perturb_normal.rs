use crate::emit::{Mask, Real};
use crate::nodes::{BLACK, NOT_NEGATIVE, required, state};
use crate::state::Field;

node! {
    /// Evaluates `input` with another shading normal. Nodes that read the normal, directly or
    /// through others, are evaluated anew under it; all others are shared with the outside.
    perturb_normal in scopes scope [Normal, DotNd],
    source "mental ray base shaders, mib_bump_map; here the state is not written but scoped",
    inputs {
        /// The normal to use; need not be of unit length, zero keeps the old one.
        normal: vector = required();
        /// The normal outside.
        outer: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction of the ray.
        direction: vector = state(Field::Direction), in -1.0..=1.0;
    }
    scoped {
        /// What is evaluated under that normal.
        input: color = BLACK, in NOT_NEGATIVE;
    }
    changes { normal: vector; dot_nd: scalar; }
    outputs {
        /// The value of `input` under that normal.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let given = i.normal.normalized();
        let none = given.largest().equal(given.x.same(0.0));
        let normal = none.select(i.outer, given);
        Changes { normal, dot_nd: normal.dot(i.direction) }
    }
}
