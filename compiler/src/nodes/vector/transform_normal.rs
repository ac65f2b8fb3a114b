use crate::nodes::finite::FACTOR;
use crate::values::Literal;

node! {
    /// Where a normal points after a transform, at unit length: it stays at right angles to a surface
    /// that is transformed, also where the transform scales unevenly or mirrors. By the cofactors of
    /// the transform, so nothing is divided by a determinant that may be zero; a transform that
    /// flattens everything to a line or a point gives the zero vector.
    transform_normal in vector,
    source "mental ray manual, mi_normal_transform; Turkowski 1990, Properties of Surface-Normal Transformations",
    inputs {
        /// The normal, of any length.
        normal: vector = [0.0; 3], in FACTOR;
        /// The transform.
        transform: transform = Literal::IDENTITY, in FACTOR;
    }
    outputs {
        /// The unit normal there.
        result: vector, in -1.0..=1.0;
    }
    body |e, i| Outputs { result: i.transform.normal(i.normal) }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;
    use crate::values::Literal;

    fn scaled(x: f32, y: f32, z: f32) -> Literal {
        Literal::Transform([
            x, 0.0, 0.0, 0.0, //
            0.0, y, 0.0, 0.0, //
            0.0, 0.0, z, 0.0, //
            7.0, 8.0, 9.0, 1.0,
        ])
    }

    #[test]
    fn stays_at_right_angles_to_the_surface() {
        // The plane x + y = 0, flattened to y' = y / 2, has the normal (1, 2).
        let turned =
            numbers!(normal = [1.0, 1.0, 0.0], transform = scaled(1.0, 0.5, 1.0) => result);
        let length = 5.0_f64.sqrt();
        assert_close(&turned, &[1.0 / length, 2.0 / length, 0.0], 2e-7, 0.0);
        let mirrored =
            numbers!(normal = [1.0, 0.0, 0.0], transform = scaled(-1.0, 1.0, 1.0) => result);
        assert_eq!(mirrored, [-1.0, 0.0, 0.0]);
    }

    #[test]
    fn neither_tiny_nor_huge_maps_lose_it() {
        for size in [1e-38, 1e-20, 1.0, 1e19] {
            let up =
                numbers!(normal = [0.0, 0.0, 2.0], transform = scaled(size, size, size) => result);
            assert_eq!(up, [0.0, 0.0, 1.0], "{size}");
        }
        let lost = numbers!(normal = [0.0, 0.0, 1.0], transform = scaled(0.0, 0.0, 0.0) => result);
        assert_eq!(lost, [0.0; 3]);
    }
}
