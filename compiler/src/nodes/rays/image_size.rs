use crate::values::Literal;

node! {
    /// How many pixels a texture has: as integers, which become numbers where numbers are due. 0 where no
    /// texture is given. One pixel is `1 / width` of `u` wide. Of
    /// tiles it is the size of the first there is.
    image_size in rays request TextureSize,
    source "OSL 1.13, gettextureinfo: resolution",
    inputs {
        /// The picture.
        texture: texture = Literal::Texture(None);
    }
    outputs {
        /// Columns.
        width: integer, in 0.0..=65_536.0;
        /// Rows.
        height: integer, in 0.0..=65_536.0;
    }
}
