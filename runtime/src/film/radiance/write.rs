//! Pixels to a file.

use std::io::{self, Write};

use super::pixel::encoded;
use super::scanline::RUN_WIDTHS;
use crate::film::Film;

/// Shortest run that is written as one: two bytes, and perhaps one more for literals that go on.
const SHORTEST_RUN: usize = 4;

/// Writes a film without its alpha: what is seen over black. Scanlines have run lengths where the format has
/// them, from 8 to 32,767 pixels.
pub(in crate::film) fn write(film: &Film, to: &mut impl Write) -> io::Result<()> {
    let (width, height) = (film.width(), film.height());
    write!(to, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n")?;
    let mut line = Vec::new();
    let mut component = Vec::new();
    for pixels in film.pixels().chunks_exact(width as usize) {
        line.clear();
        line.extend(pixels.iter().map(|&[red, green, blue, _]| encoded([red, green, blue])));
        if !RUN_WIDTHS.contains(&line.len()) {
            // No pixel can be taken for a run: all but black have a mantissa of 128 or more.
            to.write_all(line.as_flattened())?;
            continue;
        }
        to.write_all(&[2, 2, (width >> 8) as u8, width as u8])?;
        for k in 0..4 {
            component.clear();
            component.extend(line.iter().map(|pixel| pixel[k]));
            runs(&component, to)?;
        }
    }
    Ok(())
}

/// One component of a scanline.
fn runs(mut bytes: &[u8], to: &mut impl Write) -> io::Result<()> {
    while !bytes.is_empty() {
        let (begin, length) = next_run(bytes);
        for literals in bytes[..begin].chunks(128) {
            to.write_all(&[literals.len() as u8])?;
            to.write_all(literals)?;
        }
        for run in bytes[begin..begin + length].chunks(127) {
            to.write_all(&[128 + run.len() as u8, run[0]])?;
        }
        bytes = &bytes[begin + length..];
    }
    Ok(())
}

/// Begin and length of the first run that is worth it; an empty one at the end where there is none.
fn next_run(bytes: &[u8]) -> (usize, usize) {
    let mut begin = 0;
    for run in bytes.chunk_by(|a, b| a == b) {
        if run.len() >= SHORTEST_RUN {
            return (begin, run.len());
        }
        begin += run.len();
    }
    (begin, 0)
}
