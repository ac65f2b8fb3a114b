use crate::emit::{Mask, Real};
use crate::nodes::{NOT_NEGATIVE, required};

node! {
    /// The share in which a sample counts that could have been found in two ways: `a^2 / (a^2 + b^2)`, a being how densely it is found in
    /// its own way, b in the other. Shares of both ways sum to 1, so nothing is counted twice, and each way counts most
    /// where it finds more: light samples on what is rough and under small lights, those of the surface on what is glossy.
    ///
    /// Densities are samples per steradian: the density of a lobe times the count of its loop, and `density` of `light`. That of a
    /// lamp no ray can find is infinite, and its share 1.
    power_heuristic in samples,
    source "Veach 1997, Robust Monte Carlo Methods for Light Transport Simulation, 9.2",
    inputs {
        /// How densely the sample is found in its own way, per steradian.
        density: scalar = required(), in NOT_NEGATIVE;
        /// How densely it is found in the other way, per steradian.
        other: scalar = required(), in NOT_NEGATIVE;
    }
    outputs {
        /// The share.
        weight: scalar, in 0.0..=1.0;
    }
    body |e, i| {
        let one = e.real(1.0);
        let ratio = i.density.minimum(i.other) / i.density.maximum(i.other);
        // Two zeros or two infinities are alike.
        let ratio = i.density.equal(i.other).select(one, ratio);
        let square = ratio * ratio;
        let larger = one / (square + 1.0);
        Outputs { weight: i.density.less(i.other).select(square * larger, larger).saturate() }
    }
}

#[cfg(test)]
mod tests {
    fn weight(density: f32, other: f32) -> f32 {
        number!(density = density, other = other => weight)
    }

    #[test]
    fn shares_of_both_ways_sum_to_one() {
        for (a, b) in [
            (1.0, 3.0),
            (0.0, 2.0),
            (1e30, 1e-30),
            (f32::MAX, f32::MAX),
            (0.0, 0.0),
            (0.1, f32::INFINITY),
        ] {
            assert!((weight(a, b) + weight(b, a) - 1.0).abs() < 1e-6, "{a} {b}");
        }
        assert!((weight(3.0, 1.0) - 0.9).abs() < 1e-6);
    }

    #[test]
    fn what_no_ray_finds_counts_whole() {
        assert_eq!([weight(f32::INFINITY, 1e30), weight(f32::INFINITY, 0.0)], [1.0, 1.0]);
        assert_eq!(
            [weight(0.0, 1.0), weight(1.0, 0.0), weight(1.0, f32::INFINITY)],
            [0.0, 1.0, 0.0]
        );
    }
}
