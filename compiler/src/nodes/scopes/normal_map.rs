use crate::emit::functions::bent_normal::{facing_out, mapped};
use crate::emit::functions::frames::tangent_along;
use crate::emit::{Mask, Real, Vector};
use crate::nodes::{FINITE, required, state};
use crate::state::Field;

node! {
    /// Evaluates `input` under the normal of a map in tangent space, as a `texture_lookup` with
    /// `"space": "linear"` yields it: red is the part along u, green along v, blue along the normal, each
    /// stored as 0 to 1, so (0.5, 0.5, 1) is flat; so is a map of nothing, black. The frame is that of the
    /// surface coordinates at the point, square and mirrored where these are.
    ///
    /// Of what is hit from inside dents become bumps. A normal bent so far that a mirror would throw rays below
    /// the geometric surface is bent less; everywhere else it is as the map has it, at unit length.
    normal_map in scopes scope [Normal, DotNd],
    source "MaterialX 1.39, normalmap; Blender manual, Normal Map Node; Keller and others 2017, The Iray Light \
            Transport Simulation, appendix A, for the mirrored ray",
    inputs {
        /// The map, its numbers as they are in the file.
        map: color = [0.5, 0.5, 1.0, 1.0], in FINITE;
        /// Factor on the parts along the surface; 0 is flat.
        strength: scalar = 1.0, in -100.0..=100.0, soft 0.0..=2.0;
        /// Whether green runs downwards, as in maps made for DirectX.
        flip_green: boolean = false;
        /// How the point moves with u, of any length.
        derivative_u: vector = state(Field::DerivativeU);
        /// How the point moves with v, of any length.
        derivative_v: vector = state(Field::DerivativeV);
        /// The normal outside.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Geometric normal.
        normal_geom: vector = state(Field::NormalGeom), in -1.0..=1.0;
        /// Direction of the ray.
        direction: vector = state(Field::Direction), in -1.0..=1.0;
        /// Whether the surface was hit from inside: the normal is turned.
        inside: boolean = state(Field::InvNormal);
    }
    scoped {
        /// What is evaluated under that normal.
        input: generic = required();
    }
    changes { normal: vector; dot_nd: scalar; }
    outputs {
        /// The value of `input` under that normal.
        result: generic;
    }
    body |e, i| {
        let (zero, one) = (e.real(0.0), e.real(1.0));
        let tangent = tangent_along(i.derivative_u, i.normal);
        let bitangent = i.normal.cross(tangent);
        let mirrored = bitangent.dot(i.derivative_v).less(zero);
        let green = i.flip_green.select(one - i.map.g, i.map.g);
        let empty = i.map.r.equal(zero) & i.map.g.equal(zero) & i.map.b.equal(zero);
        let green = empty.select(zero, mirrored.select(one - green, green));
        let map = Vector { x: i.map.r, y: green, z: i.map.b };
        let strength = i.inside.select(-i.strength, i.strength);
        let bent = mapped(map, strength, (tangent, bitangent, i.normal));
        let normal = facing_out(bent, i.direction, i.normal_geom);
        Changes { normal, dot_nd: normal.dot(i.direction) }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::{assert_close, changed};

    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    /// A macro would hide which inputs there are: the normal for a map over the plane of x and y.
    fn bent(given: &[(&str, crate::values::Literal)]) -> Vec<f32> {
        let direction = ("direction", crate::values::Literal::Vector(DOWN));
        // What is given first counts.
        let given = [given, &[direction]].concat();
        changed(&super::definition(), &given)[..3].to_vec()
    }

    fn color(r: f32, g: f32, b: f32) -> (&'static str, crate::values::Literal) {
        ("map", crate::values::Literal::Color([r, g, b, 1.0]))
    }

    #[test]
    fn red_leans_along_u_and_green_along_v() {
        use crate::values::Literal::{Boolean, Scalar, Vector};
        assert_eq!(bent(&[color(0.5, 0.5, 1.0)]), [0.0, 0.0, 1.0]);
        assert_eq!(bent(&[color(0.0, 0.0, 0.0)]), [0.0, 0.0, 1.0]);
        assert_close(&bent(&[color(0.8, 0.5, 0.9)]), &[0.6, 0.0, 0.8], 1e-6, 1e-6);
        assert_close(&bent(&[color(0.5, 0.8, 0.9)]), &[0.0, 0.6, 0.8], 1e-6, 1e-6);
        let flipped = bent(&[color(0.5, 0.8, 0.9), ("flip_green", Boolean(true))]);
        assert_close(&flipped, &[0.0, -0.6, 0.8], 1e-6, 1e-6);
        // Half as steep.
        let weak = bent(&[color(0.8, 0.5, 0.9), ("strength", Scalar(0.5))]);
        assert_close(&weak, &[0.351_123_4, 0.0, 0.936_329_2], 1e-6, 1e-6);
        // Coordinates that are mirrored, turned and stretched.
        let along =
            [("derivative_u", Vector([0.0, 3.0, 0.0])), ("derivative_v", Vector([0.2, 0.0, 0.0]))];
        let turned = bent(&[&[color(0.8, 0.5, 0.9)], &along[..]].concat());
        assert_close(&turned, &[0.0, 0.6, 0.8], 1e-6, 1e-6);
        let turned = bent(&[&[color(0.5, 0.8, 0.9)], &along[..]].concat());
        assert_close(&turned, &[0.6, 0.0, 0.8], 1e-6, 1e-6);
        // From below, where the normal is turned, the surface is the same.
        let below = [
            ("normal", Vector(DOWN)),
            ("normal_geom", Vector(DOWN)),
            ("inside", Boolean(true)),
            ("direction", Vector([0.0, 0.0, 1.0])),
        ];
        let below = bent(&[&[color(0.8, 0.5, 0.9)], &below[..]].concat());
        assert_close(&below, &[-0.6, 0.0, -0.8], 1e-6, 1e-6);
    }

    #[test]
    fn mirrored_rays_stay_above_the_surface() {
        use crate::values::Literal::Vector;
        for along in [[0.8, 0.0, -0.6], [0.0, 0.999_95, -0.01], [-0.6, 0.64, -0.48]] {
            for (r, g, b) in [(0.0, 0.5, 0.5), (1.0, 0.5, 0.6), (0.5, 1.0, 0.5), (0.3, 0.9, 0.2)] {
                let normal = bent(&[color(r, g, b), ("direction", Vector(along))]);
                let dot = normal.iter().zip(along).map(|(a, b)| a * b).sum::<f32>();
                let up = along[2] - 2.0 * dot * normal[2];
                assert!(up > 0.0 && dot <= 1e-6, "{along:?} {r} {g} {b}: {normal:?} {up}");
                let length: f32 = normal.iter().map(|x| x * x).sum();
                assert!((length - 1.0).abs() < 1e-5);
            }
        }
    }
}
