use crate::emit::functions::frames::tangent_along;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// The frame of the surface coordinates: the tangent runs with u, `t = u - (u·n) n` at unit length, and
    /// the bitangent is `n × t`. Where u does not move the point, or along the normal (at the poles of a
    /// sphere, where there is no surface), any tangent will do: that of `frame_from_normal`.
    frame_from_derivatives in frames,
    source "mental ray base shaders, mib_illum_ward_deriv",
    inputs {
        /// How the point moves with u, of any length.
        derivative: vector = state(Field::DerivativeU);
        /// Shading normal.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
    }
    outputs {
        /// Along u, at right angles to the normal, unit length.
        tangent: vector, in -1.0..=1.0;
        /// At right angles to both, unit length: the way of v where a picture is not mirrored.
        bitangent: vector, in -1.0..=1.0;
        /// The normal at unit length.
        normal: vector, in -1.0..=1.0;
    }
    body |e, i| {
        let normal = i.normal.normalized();
        let tangent = tangent_along(i.derivative, normal);
        Outputs { tangent, bitangent: normal.cross(tangent).normalized(), normal }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    const UP: [f32; 3] = [0.0, 0.0, 1.0];

    fn dot(a: &[f32], b: &[f32]) -> f64 {
        a.iter().zip(b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
    }

    #[test]
    fn the_tangent_runs_with_u_in_the_surface() {
        for size in [1e-38, 1e-3, 1.0, 1e30] {
            let derivative = [3.0 * size, 4.0 * size, 7.0 * size];
            let tangent = numbers!(derivative = derivative, normal = UP => tangent);
            assert_close(&tangent, &[0.6, 0.8, 0.0], 2e-7, 1e-7);
            let bitangent = numbers!(derivative = derivative, normal = UP => bitangent);
            assert_close(&bitangent, &[-0.8, 0.6, 0.0], 2e-7, 1e-7);
        }
    }

    #[test]
    fn it_is_square_however_near_u_comes_to_the_normal() {
        let normal = [0.48, -0.6, 0.64];
        for apart in [1.0_f32, 1e-2, 1e-4, 3e-6, 1e-7, 1e-9, 0.0] {
            let derivative = [normal[0] + apart, normal[1], normal[2]];
            let tangent = numbers!(derivative = derivative, normal = normal => tangent);
            let bitangent = numbers!(derivative = derivative, normal = normal => bitangent);
            let unit = numbers!(derivative = derivative, normal = normal => normal);
            for (a, b, expected) in [
                (&tangent, &tangent, 1.0),
                (&tangent, &unit, 0.0),
                (&bitangent, &bitangent, 1.0),
                (&bitangent, &tangent, 0.0),
            ] {
                assert!((dot(a, b) - expected).abs() < 3e-7, "{apart}: {a:?} {b:?}");
            }
        }
    }

    #[test]
    fn without_derivative_or_normal_it_is_still_defined() {
        let tangent = numbers!(derivative = [0.0; 3], normal = UP => tangent);
        assert_eq!(tangent, [1.0, 0.0, 0.0]);
        assert_eq!(numbers!(normal = [0.0; 3], derivative = [0.0; 3] => bitangent), [0.0; 3]);
    }
}
