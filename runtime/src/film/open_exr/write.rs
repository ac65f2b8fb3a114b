//! Pixels to a file.

use std::io::{Seek, Write};

use exr::prelude::{
    Blocks, Compression, Encoding, Image, Layer, LayerAttributes, LineOrder, SpecificChannels,
    Vec2, WritableImage,
};

use super::read::fault;
use crate::film::Film;
use crate::film::fault::Fault;

/// Writes a film as it is: scene-linear, 32 bits a channel, alpha associated as the format asks. Files
/// without chromaticities have those of Rec. 709, as films have.
pub(in crate::film) fn write(film: &Film, to: &mut (impl Write + Seek)) -> Result<(), Fault> {
    let pixel = |at: Vec2<usize>| {
        let [r, g, b, a] = film.pixel(at.x() as u32, at.y() as u32);
        (r, g, b, a)
    };
    let encoding = Encoding {
        compression: Compression::ZIP16,
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let layer = Layer::new(
        (film.width() as usize, film.height() as usize),
        LayerAttributes::default(),
        encoding,
        SpecificChannels::rgba(pixel),
    );
    Image::from_layer(layer).write().non_parallel().to_buffered(to).map_err(fault)
}
