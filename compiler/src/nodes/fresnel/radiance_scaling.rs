use super::fresnel_dielectric::index;
use crate::nodes::NOT_NEGATIVE;

node! {
    /// Factor on the radiance of a refracted ray: `(ior_in / ior_out)^2`. Light that enters a denser medium is
    /// gathered into a smaller cone there, and spread again where it leaves; on a way in and out again the
    /// factors cancel. mental ray's `dielectric_material` applies it. Multiply what `trace_refraction` sees by
    /// it where cameras, lights or traced distances lie within media; leave it out where only closed glass in
    /// air is seen from outside, with less noise.
    radiance_scaling in fresnel,
    source "Nicodemus 1963, Radiance; mental ray physics shaders, dielectric_material",
    inputs {
        /// Index of refraction on the side the ray comes from.
        ior_in: scalar = 1.0, in 0.0..=100.0, soft 1.0..=2.5;
        /// Index of refraction beyond the boundary.
        ior_out: scalar = 1.5, in 0.0..=100.0, soft 1.0..=2.5;
    }
    outputs {
        /// The factor.
        factor: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let ratio = index(e, i.ior_in) / index(e, i.ior_out);
        Outputs { factor: ratio * ratio }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn in_and_out_again_cancel() {
        let (into, out) =
            (number!(ior_out = 2.0 => factor), number!(ior_in = 2.0, ior_out = 1.0 => factor));
        assert_eq!((into, out), (0.25, 4.0));
        assert_eq!(number!(ior_in = 0.0, ior_out = f32::NAN => factor), 1.0);
    }
}
