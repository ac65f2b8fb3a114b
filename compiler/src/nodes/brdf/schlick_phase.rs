use crate::emit::Real;
use crate::emit::functions::conventions::not_negative;
use crate::nodes::NOT_NEGATIVE;

node! {
    /// How a cloud of small particles scatters light, by angle: `(1 - k^2) / (4 pi (1 - k cos)^2)`, a cheap stand-in for
    /// Henyey and Greenstein's. It integrates to 1 over all directions. At k = 1 and -1 all light goes one way,
    /// which has no density: the value is 0.
    schlick_phase in brdf,
    source "Blasi, Le Saec and Schlick 1993, A Rendering Algorithm for Discrete Volume Density Objects; mental ray manual, mi_schlick_scatter",
    inputs {
        /// Cosine between the light's way before and after; 1 is straight on.
        cosine: scalar = 1.0, in -1.0..=1.0;
        /// Where most goes: -1 back, 0 everywhere alike, 1 straight on.
        k: scalar = 0.0, in -1.0..=1.0;
    }
    outputs {
        /// The share, per steradian.
        value: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let one = e.real(1.0);
        let k = i.k.clamp_to(-one, one);
        let cosine = i.cosine.clamp_to(-one, one);
        let spread = (-k).mul_add(cosine, one);
        let value = (one - k) * (one + k) * (1.0 / (4.0 * std::f64::consts::PI));
        Outputs { value: not_negative(value.divide_or_zero(spread).divide_or_zero(spread)) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn known_values_and_the_ends() {
        let at = |cosine: f32, k: f32| number!(cosine = cosine, k = k => value);
        let values = [at(1.0, 0.5), at(-1.0, 0.5), at(0.3, 0.0)];
        crate::nodes::harness::assert_close(
            &values,
            &[0.238732414637843, 0.026525823848649224, 0.07957747154594767],
            3e-7,
            0.0,
        );
        for cosine in [-1.0, 0.0, 1.0] {
            assert_eq!([at(cosine, 1.0), at(cosine, -1.0)], [0.0; 2]);
        }
    }
}
