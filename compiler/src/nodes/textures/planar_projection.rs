use crate::emit::functions::placing::place;
use crate::emit::{Real, Vector};
use crate::nodes::finite::FACTOR;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Throws a picture straight onto what lies before it: `u = ((p - origin) · across) / |across|^2`, and
    /// `v` alike with `up`. The picture has its lower left corner at `origin` and its edges along
    /// `across` and `up`; a vector of length 0 gives 0.
    planar_projection in textures,
    source "mental ray base shaders, mib_texture_vector: planar projections",
    inputs {
        /// What the picture falls on.
        position: vector = state(Field::Point), in FACTOR;
        /// Its lower left corner.
        origin: vector = [0.0; 3], in FACTOR;
        /// Its lower edge, from left to right.
        across: vector = [1.0, 0.0, 0.0], in FACTOR;
        /// Its left edge, upwards.
        up: vector = [0.0, 1.0, 0.0], in FACTOR;
    }
    outputs {
        /// Where to read, as a vector whose z is 0.
        uv: vector;
        /// Its first coordinate.
        u: scalar;
        /// Its second coordinate.
        v: scalar;
    }
    body |e, i| {
        let from = i.position - i.origin;
        let uv = place(lengths_along(from, i.across), lengths_along(from, i.up));
        Outputs { uv, u: uv.x, v: uv.y }
    }
}

/// How many lengths of an axis a vector goes along it. By the unit vector: squares of long vectors
/// overflow.
#[inline(always)]
fn lengths_along<R: Real>(vector: Vector<R>, axis: Vector<R>) -> R {
    vector.dot(axis.normalized()).divide_or_zero(axis.length())
}

#[cfg(test)]
mod tests {
    #[test]
    fn edges_of_the_picture_are_where_it_was_put() {
        let (origin, across, up) = ([1.0, 2.0, 3.0], [0.0, 0.0, -2.0], [0.0, 4.0, 0.0]);
        let at = |position: [f32; 3]| numbers!(position = position, origin = origin, across = across, up = up => uv);
        assert_eq!(at(origin), [0.0; 3]);
        assert_eq!(at([1.0, 6.0, 1.0]), [1.0, 1.0, 0.0]);
        // Straight: what lies along the line of sight is the same.
        assert_eq!(at([-7.0, 4.0, 2.0]), [0.5, 0.5, 0.0]);
    }

    #[test]
    fn edges_without_length_and_far_points_are_finite() {
        for across in [[0.0; 3], [1e-45, 0.0, 0.0], [1e19, -1e19, 1e19]] {
            let uv = numbers!(position = [1e19, 1e19, -1e19], across = across => uv);
            assert!(uv.iter().all(|x| x.is_finite()), "{across:?}: {uv:?}");
        }
    }
}
