use crate::emit::functions::conventions::{clamp_finite, sqrt_or_zero};
use crate::emit::{Mask, Real, Vector};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// A direction bent at a plane by Snell's law, `eta input - (eta c + sqrt(k)) normal` with
    /// `c = input . normal` and `k = 1 - eta^2 (1 - c^2)`; the zero vector where k is negative,
    /// which is total reflection. As GLSL, OSL and MaterialX have it, `eta` is the ratio of the
    /// index of refraction on the side of the normal to the one beyond. `refraction_direction`
    /// does it for the ray from two indices, and mirrors under total reflection.
    refract in vector,
    source "",
    inputs {
        /// What is bent: a unit vector towards the plane.
        input: vector = state(Field::Direction), in -1e9..=1e9;
        /// Unit normal on the side the input comes from.
        normal: vector = state(Field::Normal), in -1e9..=1e9;
        /// Index of refraction here over that beyond.
        eta: scalar = 1.0, in -1e9..=1e9;
    }
    outputs {
        /// The bent direction, or zero.
        result: vector;
    }
    body |e, i| {
        let (zero, one) = (e.real(0.0), e.real(1.0));
        let cosine = i.input.dot(i.normal);
        // 1 - c^2 as a product: exact where c is near 1.
        let square = (one - cosine) * (one + cosine);
        let k = one - i.eta * i.eta * square;
        let along = i.eta.mul_add(cosine, sqrt_or_zero(k));
        let bent = i.input * i.eta - i.normal * along;
        let none = Vector { x: zero, y: zero, z: zero };
        let bent = Vector { x: clamp_finite(bent.x), y: clamp_finite(bent.y), z: clamp_finite(bent.z) };
        Outputs { result: k.less(zero).select(none, bent) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn obeys_snell() {
        let (sine, normal) = (0.6_f32, [0.0, 0.0, 1.0]);
        let bent =
            numbers!(input = [sine, 0.0, -0.8], normal = normal, eta = 1.0_f32 / 1.5 => result);
        let expected = [0.4, 0.0, -(1.0_f64 - 0.16).sqrt()];
        crate::nodes::harness::assert_close(&bent, &expected, 3e-7, 0.0);
        let total = numbers!(input = [0.8, 0.0, -0.6], normal = normal, eta = 1.5 => result);
        assert_eq!(total, [0.0; 3]);
        let straight = numbers!(input = [0.0, 0.0, -1.0], normal = normal, eta = 1.5 => result);
        assert_eq!(straight, [0.0, 0.0, -1.0]);
    }
}
