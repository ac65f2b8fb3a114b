//! Where a ray that leaves a surface starts.

/// The origin of a ray that leaves `point`, whose components are known to within `error`, towards
/// `direction`: moved along the geometric normal by just the bound, then one step further, so that
/// it lies surely on the side of the surface the ray leaves to. No scene-wide epsilon. After Pharr
/// et al., Physically Based Rendering 4th ed., 6.8.6.
#[inline]
pub fn spawn_origin(
    point: [f32; 3],
    error: [f32; 3],
    normal_geom: [f32; 3],
    direction: [f32; 3],
) -> [f32; 3] {
    let distance = normal_geom[0].abs() * error[0]
        + normal_geom[1].abs() * error[1]
        + normal_geom[2].abs() * error[2];
    let cosine = normal_geom[0] * direction[0]
        + normal_geom[1] * direction[1]
        + normal_geom[2] * direction[2];
    let signed = if cosine < 0.0 { -distance } else { distance };
    [0, 1, 2].map(|k| {
        let offset = signed * normal_geom[k];
        let moved = point[k] + offset;
        if offset > 0.0 {
            moved.next_up()
        } else if offset < 0.0 {
            moved.next_down()
        } else {
            moved
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moves_past_the_error_to_the_side_it_leaves_to() {
        let error = [1e-7; 3];
        let up = spawn_origin([1.0; 3], error, [0.0, 1.0, 0.0], [0.3, 0.1, 0.0]);
        assert_eq!((up[0], up[2]), (1.0, 1.0));
        assert!(up[1] >= 1.0 + 1e-7);
        let down = spawn_origin([1.0; 3], error, [0.0, 1.0, 0.0], [0.3, -0.1, 0.0]);
        assert!(down[1] <= 1.0 - 1e-7);
    }

    #[test]
    fn a_subnormal_error_still_moves() {
        let tiny = f32::from_bits(1);
        let up = spawn_origin([0.0; 3], [tiny; 3], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]);
        assert!(up[1] > tiny);
    }
}
