use crate::emit::functions::flakes::{completed, flake_at, tilted};
use crate::emit::{Mask, Real, Vector};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Metallic flakes as in car paint: little tilted squares scattered in space, one at most in each
    /// cube of `size`. Where flakes overlap, the one of the highest presence shows. Its normal is tilted at random, as the facets of
    /// a GGX surface of this roughness are. Where there is no flake, the normal is the surface's, and number and presence
    /// are 0. MaterialX's `flake3d` has the same flakes; its `flake2d` are these at (u, v, 0).
    flakes in patterns,
    source "MaterialX 1.39, flake3d; Arvo 1992, Fast Random Rotation Matrices; Walter et al. 2007 for the tilt",
    inputs {
        /// Where to look.
        position: vector = state(Field::Point), in FACTOR;
        /// Edge of the cubes, in units of the position.
        size: scalar = 0.01, in -1e9..=1e9, avoid zero, soft 0.001..=1.0;
        /// Roughness of the tilt: 0 flat, 1 every way.
        roughness: scalar = 0.1, in -16.0..=16.0, soft UNIT;
        /// Share of the surface that flakes cover, about; below 0 counts as 0, above 1 as 1.
        coverage: scalar = 0.5, soft UNIT;
        /// The surface's normal, of unit length.
        normal: vector = state(Field::Normal), in -1e6..=1e6;
        /// A direction in the surface; zero takes one that the normal gives.
        tangent: vector = [0.0; 3], in -1e6..=1e6;
        /// The direction in the surface across the tangent; zero takes one that the normal gives.
        bitangent: vector = [0.0; 3], in -1e6..=1e6;
    }
    outputs {
        /// Number of the flake, 0 to 16777215; 0 where there is none.
        id: integer;
        /// A random number of the flake, 0 to 1.
        random: scalar, in 0.0..=1.0;
        /// How far above the others it lies, 0 to 1; 0 where there is none.
        presence: scalar, in 0.0..=1.0;
        /// The flake's normal, of unit length, or the surface's as it was given.
        normal: vector;
    }
    body |e, i| {
        let Vector { x, y, z } = i.position;
        let scaled =
            [x.divide_or_zero(i.size), y.divide_or_zero(i.size), z.divide_or_zero(i.size)];
        let flake = flake_at(e, scaled, i.coverage);
        let frame = completed(i.normal, i.tangent, i.bitangent);
        let there = flake.presence.greater(e.real(0.0));
        let tilted = tilted(flake.cell, i.roughness, frame);
        let none = e.real(0.0);
        let random = there.select(tilted.random, none);
        Outputs {
            id: (random * 16_777_215.0).to_int(),
            random,
            presence: flake.presence,
            normal: there.select(tilted.normal, i.normal),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn flakes_of_materialx() {
        macro_rules! flake {
            ($output:ident) => {
                numbers!(
                    position = [2.16894, -1.11013, -0.715635], size = -1.68161, roughness = 0.967804,
                    coverage = 0.967623, normal = [2.54043, -0.797067, 0.225806],
                    tangent = [-0.438915, 0.831179, 2.68534], bitangent = [0.281358, 1.55313, 0.315966]
                        => $output
                )
            };
        }
        assert_close(&flake!(random), &[0.588767231], 1e-6, 0.0);
        assert_close(&flake!(presence), &[0.883400977], 1e-6, 0.0);
        assert_close(&flake!(normal), &[0.957028627, -0.245369896, -0.154563382], 0.0, 2e-5);
        assert_eq!(flake!(id)[0].to_bits(), 9_877_874);
    }

    #[test]
    fn without_coverage_there_are_none() {
        for step in 0..50 {
            let position = [step as f32 * 0.37, 1.0, -2.0];
            let presence = number!(position = position, size = 1.0, coverage = 0.0 => presence);
            assert_eq!(presence, 0.0);
            let normal =
                numbers!(position = position, normal = [0.0, 0.0, 1.0], coverage = -1.0 => normal);
            assert_eq!(normal, [0.0, 0.0, 1.0]);
        }
    }

    #[test]
    fn coverage_is_about_the_share_and_normals_are_of_unit_length() {
        for coverage in [0.25, 0.5, 0.9] {
            let mut covered = 0;
            for step in 0..900 {
                let position = [(step % 30) as f32 * 0.73, (step / 30) as f32 * 0.61, 0.2];
                let presence =
                    number!(position = position, size = 1.0, coverage = coverage => presence);
                covered += usize::from(presence > 0.0);
                let normal =
                    numbers!(position = position, size = 1.0, coverage = coverage => normal);
                let length = normal.iter().map(|x| x * x).sum::<f32>();
                assert!((length - 1.0).abs() < 1e-5 && normal[2] > 0.0, "{normal:?}");
            }
            let share = covered as f32 / 900.0;
            assert!((share - coverage).abs() < 0.08, "{share} for {coverage}");
        }
    }
}
