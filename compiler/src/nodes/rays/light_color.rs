use crate::nodes::NOT_NEGATIVE;

node! {
    /// The colour the light sample of the loop round this node sends to the point, after shadows and
    /// falloff. Asking for it casts the shadow ray, once per point and sample however many loops run
    /// over the light; only inside a light loop.
    light_color in rays request LightColor,
    source "mental ray manual, mi_sample_light",
    inputs {}
    outputs {
        /// Colour of the arriving light, alpha 1.
        color: color, in NOT_NEGATIVE;
    }
}
