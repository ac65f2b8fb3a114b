use crate::effects::{Filter, Wrap};
use crate::nodes::finite::FACTOR;
use crate::nodes::{FINITE, state};
use crate::state::Field;
use crate::values::Literal;

node! {
    /// The colour of a texture at surface coordinates. The picture fills 0 to 1 in both, `v` upwards. What
    /// lies outside is chosen for each axis: the picture again (`periodic`), its outermost pixels
    /// (`clamp`), the picture mirrored at each edge (`mirror`), or the input `default` (`constant`). Where no
    /// texture is given nothing is read: the colour is transparent black, and `ok` is false.
    ///
    /// Filters: `linear` is bilinear between the middles of pixels, `closest` takes the pixel the place
    /// lies in, `cubic` weights sixteen by a uniform B-spline, which is smooth in its slopes, never leaves the
    /// range of the pixels, and blurs a little. `footprint` averages what a pixel of the image covers, so
    /// that patterns do not flicker far away: coarser versions of the picture are made, each half as
    /// wide, and up to sixteen probes between two of them are laid along the longer axis of the ellipse
    /// that the vectors (du_dx, dv_dx) and (du_dy, dv_dy) span: those of the surface, or, where coordinates are
    /// computed, how these change with it. Where that covers less than a pixel of the picture it is `linear`. Data, such as a normal map or a height, are read as they are where the texture says
    /// `"space": "linear"`.
    ///
    /// A picture may be a set of tiles, `file.<UDIM>.png` or `file<UVTILE>.png`: tile 1001 + u + 10 v fills the square from
    /// (u, v) on, and a lookup reads the tile its place lies in up to that tile's edges, whatever the modes. Where
    /// there is no tile the colour is transparent black, and `ok` is false.
    ///
    /// MaterialX's `image` has the same names of modes, its `default` also for files that are not there.
    texture_lookup in rays request ReadTexture,
    source "mental ray base shaders, mib_texture_lookup, mib_texture_filter_lookup; mi_lookup_color_texture; \
            MaterialX 1.39, image; Williams 1983, Pyramidal Parametrics; McCormack, Perry, Farkas and Jouppi \
            1999, Feline",
    inputs |e, i| {
        /// The picture.
        texture: texture = Literal::Texture(None);
        /// First coordinate.
        u: scalar = state(Field::U), in FACTOR;
        /// Second coordinate.
        v: scalar = state(Field::V), in FACTOR;
        /// What lies to the left and right of the picture.
        wrap_u: choice = 0, of Wrap::NAMES;
        /// What lies below and above the picture.
        wrap_v: choice = 0, of Wrap::NAMES;
        /// What becomes of the pixels there.
        filter: choice = 0, of Filter::NAMES;
        /// Colour outside of the picture.
        default: color = [0.0; 4], when e.mask(i.wrap_u == Wrap::CONSTANT || i.wrap_v == Wrap::CONSTANT), in FINITE;
        /// Change of `u` along the longer axis of the footprint.
        du_dx: scalar = state(Field::DuDx), when e.mask(i.filter == Filter::FOOTPRINT), slope ("shifted_x", "u");
        /// Change of `v` along the longer axis of the footprint.
        dv_dx: scalar = state(Field::DvDx), when e.mask(i.filter == Filter::FOOTPRINT), slope ("shifted_x", "v");
        /// Change of `u` along the shorter axis of the footprint.
        du_dy: scalar = state(Field::DuDy), when e.mask(i.filter == Filter::FOOTPRINT), slope ("shifted_y", "u");
        /// Change of `v` along the shorter axis of the footprint.
        dv_dy: scalar = state(Field::DvDy), when e.mask(i.filter == Filter::FOOTPRINT), slope ("shifted_y", "v");
    }
    outputs {
        /// Scene-linear colour, associated: multiplied by the alpha of the picture, which it has.
        color: color;
        /// Whether there is a texture, with a tile there, and both coordinates are finite.
        ok: boolean;
    }
}
