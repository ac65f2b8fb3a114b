use crate::emit::functions::frames::any_tangent;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// A frame of the normal alone, for what has no direction in the surface: with s the sign of z and
    /// `a = -1 / (s + z)` the tangent is `(1 + s x^2 a, s x y a, -s x)`. It changes smoothly but where z
    /// changes its sign, and no normal is near a pole of it.
    frame_from_normal in frames,
    source "Duff et al. 2017, Building an Orthonormal Basis, Revisited",
    inputs {
        /// Shading normal.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
    }
    outputs {
        /// At right angles to the normal, unit length.
        tangent: vector, in -1.0..=1.0;
        /// At right angles to both, unit length.
        bitangent: vector, in -1.0..=1.0;
        /// The normal at unit length.
        normal: vector, in -1.0..=1.0;
    }
    body |e, i| {
        let normal = i.normal.normalized();
        let tangent = any_tangent(normal).normalized();
        Outputs { tangent, bitangent: normal.cross(tangent).normalized(), normal }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    fn dot(a: &[f32], b: &[f32]) -> f64 {
        a.iter().zip(b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
    }

    #[test]
    fn it_is_square_everywhere_and_at_both_poles() {
        let near = f32::EPSILON;
        for normal in [
            [0.0, 0.0, 1.0],
            [0.0, 0.0, -1.0],
            [near, 0.0, -1.0],
            [-1e-4, 1e-4, -1.0],
            [1.0, 0.0, 0.0],
            [1.0, 0.0, -0.0],
            [0.6, -0.8, -1e-45],
            [0.57, 0.57, -0.59],
        ] {
            let [t, b, n] = [
                numbers!(normal = normal => tangent),
                numbers!(normal = normal => bitangent),
                numbers!(normal = normal => normal),
            ];
            for (a, c, expected) in
                [(&t, &t, 1.0), (&b, &b, 1.0), (&t, &n, 0.0), (&b, &n, 0.0), (&t, &b, 0.0)]
            {
                assert!((dot(a, c) - expected).abs() < 3e-7, "{normal:?}: {a:?} {c:?}");
            }
        }
    }

    #[test]
    fn the_published_form() {
        // x = 0.6, y = 0, z = -0.8: s = -1, a = -1 / -1.8.
        let normal = [0.6, 0.0, -0.8];
        assert_close(&numbers!(normal = normal => tangent), &[0.8, 0.0, 0.6], 2e-7, 0.0);
        assert_close(&numbers!(normal = normal => bitangent), &[0.0, -1.0, 0.0], 2e-7, 1e-7);
    }
}
