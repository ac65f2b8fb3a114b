use crate::nodes::finite::FACTOR;
use crate::nodes::state;
use crate::state::Field;
use crate::values::Literal;

node! {
    /// The colour of a texture at surface coordinates, bilinear between pixels. The picture fills 0 to 1
    /// in both, `v` upwards, and repeats outside. Where no texture is given nothing is read: the colour is
    /// transparent black, and `ok` is false.
    texture_lookup in rays request ReadTexture,
    source "mental ray base shaders, mib_texture_lookup; mi_lookup_color_texture",
    inputs {
        /// The picture.
        texture: texture = Literal::Texture(None);
        /// First coordinate.
        u: scalar = state(Field::U), in FACTOR;
        /// Second coordinate.
        v: scalar = state(Field::V), in FACTOR;
    }
    outputs {
        /// Scene-linear colour, associated: multiplied by the alpha of the picture, which it has.
        color: color;
        /// Whether there is a texture, and both coordinates are finite.
        ok: boolean;
    }
}
