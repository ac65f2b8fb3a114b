//! What a pixel covers of a surface.

use glam::DVec3;
use phenomenon_compiler::state::Footprint;

use super::vector::{single, unit};

/// The least cosine of the ray with the surface: nearer to grazing, an ellipse is no longer.
const GRAZING: f64 = 1e-5;

/// The ellipse that a cone of a width cuts from the plane of a normal: across the ray it is as wide as the cone,
/// along the ray longer by the cosine (Akenine-Möller and others 2021, Improved Shader and Texture Level of Detail Using
/// Ray Cones). Coordinates change with it as far as their derivatives span the surface.
pub fn footprint(
    direction: DVec3,
    normal: DVec3,
    derivatives: [DVec3; 2],
    width: f64,
) -> Footprint {
    let cosine = direction.dot(normal);
    // Straight on, any direction along the surface is as good.
    let along =
        unit(direction - normal * cosine).unwrap_or_else(|| normal.any_orthonormal_vector());
    let axes =
        [along * (width / cosine.abs().max(GRAZING)), normal.cross(along).normalize() * width];
    let [of_u, of_v] = derivatives;
    let area = of_u.cross(of_v);
    let square = area.length_squared();
    let uv = axes.map(|axis| match square > 0.0 {
        true => [axis.cross(of_v).dot(area) / square, of_u.cross(axis).dot(area) / square],
        false => [0.0; 2],
    });
    Footprint { point: axes.map(single), uv: uv.map(|change| change.map(finite)) }
}

/// In 32 bits; what has no number there is the largest.
fn finite(x: f64) -> f32 {
    if x.is_nan() { 0.0 } else { x.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32 }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DERIVATIVES: [DVec3; 2] = [DVec3::new(4.0, 0.0, 0.0), DVec3::new(0.0, 0.0, -2.0)];

    #[test]
    fn a_cone_cuts_an_ellipse_from_a_floor() {
        // Four down on three ahead.
        let direction = DVec3::new(0.0, -0.8, -0.6);
        let found = footprint(direction, DVec3::Y, DERIVATIVES, 0.2);
        let [long, short] = found.point;
        assert!((long[2] + 0.25).abs() < 1e-6 && long[0].abs() < 1e-6, "{long:?}");
        assert!((short[0].abs() - 0.2).abs() < 1e-6 && short[2].abs() < 1e-6, "{short:?}");
        assert!((found.uv[0][1] - 0.125).abs() < 1e-6 && found.uv[0][0].abs() < 1e-6);
        assert!((found.uv[1][0].abs() - 0.05).abs() < 1e-6 && found.uv[1][1].abs() < 1e-6);
    }

    #[test]
    fn straight_on_it_is_a_circle_and_grazing_it_has_an_end() {
        let straight = footprint(DVec3::NEG_Y, DVec3::Y, DERIVATIVES, 0.5);
        for axis in straight.point {
            let length = axis.iter().map(|x| x * x).sum::<f32>().sqrt();
            assert!((length - 0.5).abs() < 1e-6, "{axis:?}");
        }
        let grazing = footprint(DVec3::X, DVec3::Y, DERIVATIVES, 1.0);
        assert!((grazing.point[0][0] / 1e5 - 1.0).abs() < 1e-6, "{grazing:?}");
    }

    #[test]
    fn without_coordinates_there_is_the_ellipse_alone() {
        for derivatives in [[DVec3::ZERO; 2], [DVec3::X; 2], [DVec3::X, DVec3::ZERO]] {
            let found = footprint(DVec3::NEG_Y, DVec3::Y, derivatives, 0.5);
            assert_eq!(found.uv, [[0.0; 2]; 2]);
        }
        let tiny = [DVec3::X * 1e-200, DVec3::Z * 1e-100];
        let found = footprint(DVec3::NEG_Y, DVec3::Y, tiny, 1e30);
        assert!(found.uv.as_flattened().iter().all(|x| x.is_finite()));
    }
}
