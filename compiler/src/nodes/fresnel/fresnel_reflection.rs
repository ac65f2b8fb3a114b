use super::fresnel_dielectric::reflectance;
use super::ior_pair::pair;
use crate::nodes::finite::UNIT;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Share of light the surface mirrors towards where the ray came from: `fresnel_dielectric` for
    /// the indices of `ior_pair` and the cosine of the state.
    fresnel_reflection in fresnel,
    source "mental ray manual, mi_fresnel_reflection; Born and Wolf, Principles of Optics, 1.5",
    inputs {
        /// Index of refraction of the material.
        ior: scalar = 1.5, in 0.0..=100.0, soft 1.0..=2.5;
        /// Whether the surface was hit from inside.
        inside: boolean = state(Field::InvNormal);
        /// Index of the medium the ray enters from.
        medium_in: scalar = state(Field::IorIn), in 0.0..=100.0;
        /// Index of the medium the ray leaves into.
        medium_out: scalar = state(Field::Ior), in 0.0..=100.0;
        /// Normal times direction of the ray, at most 0.
        dot_nd: scalar = state(Field::DotNd), in -1.0..=1.0;
    }
    outputs {
        /// Share reflected.
        reflectance: scalar, in UNIT;
    }
    body |e, i| {
        let (n1, n2) = pair(e, i.ior, i.inside, i.medium_in, i.medium_out);
        Outputs { reflectance: reflectance(e, n1, n2, -i.dot_nd) }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn glass_from_both_sides() {
        assert_close(&numbers!(ior = 1.5, dot_nd = -1.0 => reflectance), &[0.04], 1e-6, 0.0);
        assert_close(
            &numbers!(ior = 1.5, dot_nd = -0.5 => reflectance),
            &[0.08918671280221278],
            1e-6,
            0.0,
        );
        let inside = numbers!(ior = 1.5, inside = true, dot_nd = -0.866_025_4 => reflectance);
        assert_close(&inside, &[0.055190167295375896], 1e-6, 0.0);
        assert_eq!(number!(ior = 1.5, inside = true, dot_nd = -0.5 => reflectance), 1.0);
    }

    #[test]
    fn no_boundary_reflects_nothing_and_grazing_all() {
        for dot_nd in [-1.0, -0.5, 0.0, -0.0] {
            assert_eq!(number!(ior = 1.0, dot_nd = dot_nd => reflectance), 0.0);
        }
        assert_eq!(number!(ior = 1.33, medium_in = 1.33, dot_nd = 0.0 => reflectance), 0.0);
        assert_eq!(number!(ior = 1.5, dot_nd = 0.0 => reflectance), 1.0);
        assert_eq!(number!(ior = 1.5, dot_nd = 1e-4 => reflectance), 1.0);
    }
}
