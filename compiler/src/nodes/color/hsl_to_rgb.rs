use crate::emit::functions::colors::pure_hue;
use crate::emit::{Color, Real};
use crate::nodes::finite::{FACTOR, UNIT};

node! {
    /// Colour from hue, saturation and lightness: `lightness + c (pure - 1/2)` for the
    /// components of the pure hue, with `c = saturation (1 - |2 lightness - 1|)`. Hue is in
    /// turns and wraps. Alpha is 1.
    hsl_to_rgb in color,
    source "Joblove and Greenberg 1978, Color Spaces for Computer Graphics",
    inputs {
        /// Hue.
        hue: scalar = 0.0, unit "turns", soft UNIT;
        /// Saturation: 0 grey, 1 pure.
        saturation: scalar = 1.0, in FACTOR, soft UNIT;
        /// Lightness: 0 black, 1 white.
        lightness: scalar = 0.5, in FACTOR, soft UNIT;
    }
    outputs {
        /// The colour.
        color: color;
    }
    body |e, i| {
        let chroma = i.saturation * (e.real(1.0) - (i.lightness * 2.0 - 1.0).absolute());
        let [r, g, b] = pure_hue(i.hue);
        let color = Color {
            r: chroma.mul_add(r - 0.5, i.lightness),
            g: chroma.mul_add(g - 0.5, i.lightness),
            b: chroma.mul_add(b - 0.5, i.lightness),
            a: e.real(1.0),
        };
        Outputs { color }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_the_way_back() {
        let close = crate::nodes::harness::assert_close;
        let back = numbers!(hue = 11.0_f32 / 12.0, saturation = 0.5, lightness = 0.5 => color);
        close(&back, &[0.75, 0.25, 0.5, 1.0], 1e-6, 0.0);
        assert_eq!(numbers!(hue = -1.0, lightness = 0.5 => color), [1.0, 0.0, 0.0, 1.0]);
        assert_eq!(numbers!(hue = 0.3, lightness = 1.0 => color), [1.0; 4]);
        // Brighter than 1: largest 3, smallest 1.
        assert_eq!(
            numbers!(hue = 0.0, saturation = -1.0, lightness = 2.0 => color),
            [3.0, 1.0, 1.0, 1.0]
        );
    }
}
