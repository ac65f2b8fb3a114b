use crate::emit::functions::distributions::{DISTRIBUTIONS, roughness, spread};
use crate::emit::functions::facets::Facets;
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// How the normals of small facets are spread, at the half vector of two directions:
    /// `beckmann`: `exp(-tan^2 / m^2) / (pi m^2 cos^4)`; `ellipsoid`: `(m^2 / (m^2 cos^2 + sin^2))^2`, 1 at the peak, which
    /// over `pi m^2` is GGX; `power`: `(n + 2) / (2 pi) cos^n` with `n = 2 / m^2 - 2`; `gaussian`: `exp(-(angle / m)^2)`, 1 at
    /// the peak. Once normalised, they integrate to 1 over the hemisphere when multiplied by the cosine, the last
    /// one as far as m is small.
    ///
    /// The sine is never had from the cosine, nor the angle by an arc cosine, so that narrow lobes keep their
    /// accuracy. A roughness below 10^-6 counts as that.
    microfacet_distribution in brdf,
    source "Blinn 1977, Models of Light Reflection for Computer Synthesized Pictures; Cook and Torrance 1982",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Roughness m; Blinn calls it the eccentricity of the ellipsoids.
        roughness: scalar = 0.3, in UNIT;
        /// Which distribution.
        distribution: choice = 0, of DISTRIBUTIONS;
    }
    outputs {
        /// The density of normals, per steradian.
        value: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let value = spread(i.distribution, facets.slope_squared(), roughness(i.roughness));
        Outputs { value: facets.where_above(value) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn the_peaks_are_known() {
        let peak = |distribution: i32| number!(normal = UP, direction = UP, ray = DOWN, roughness = 0.3, distribution = distribution => value);
        let normalised = 3.53677651315323;
        let expected = [normalised, 1.0, normalised, 1.0];
        crate::nodes::harness::assert_close(
            &[peak(0), peak(1), peak(2), peak(3)],
            &expected,
            1e-6,
            0.0,
        );
    }
}
