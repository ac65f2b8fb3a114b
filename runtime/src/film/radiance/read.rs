//! Pixels from a file.

use std::io::Read;

use super::header::Header;
use super::pixel::decoded;
use super::scanline::RUN_WIDTHS;
use crate::film::Film;
use crate::film::fault::Fault;
use crate::film::input::array;

/// Reads the pixels that follow a header. The values are divided by the exposures and colour corrections of
/// the header; one that is too large becomes the largest f32.
pub(in crate::film) fn read(header: &Header, read: &mut impl Read) -> Result<Film, Fault> {
    let summary = header.summary();
    let mut film = Film::new(summary.width, summary.height)?;
    // At most 65,536 pixels, by the limits of films.
    let mut line = vec![[0; 4]; header.order.pixels.count as usize];
    for at in 0..header.order.lines.count {
        scanline(read, &mut line)?;
        for (pixel, coded) in line.iter().enumerate() {
            let color = decoded(*coded);
            let value = |k: usize| ((color[k] / header.divisor[k]) as f32).min(f32::MAX);
            let (column, row) = header.order.place(at, pixel as u32);
            film.set(column, row, [value(0), value(1), value(2), 1.0]);
        }
    }
    Ok(film)
}

fn scanline(read: &mut impl Read, line: &mut [[u8; 4]]) -> Result<(), Fault> {
    if !RUN_WIDTHS.contains(&line.len()) {
        return old_runs(read, line, None);
    }
    match array(read)? {
        [2, 2, high @ 0..0x80, low] => {
            let length = usize::from(high) << 8 | usize::from(low);
            if length != line.len() {
                return Err(Fault::Malformed(format!(
                    "a scanline of {length} pixels in a picture whose scanlines have {}",
                    line.len()
                )));
            }
            (0..4).try_for_each(|component| new_runs(read, line, component))
        }
        first => old_runs(read, line, Some(first)),
    }
}

/// One component of a scanline: literals, and runs of at most 127.
fn new_runs(read: &mut impl Read, line: &mut [[u8; 4]], component: usize) -> Result<(), Fault> {
    let mut rest = line;
    while !rest.is_empty() {
        let [code] = array(read)?;
        let count = usize::from(if code > 128 { code & 127 } else { code });
        if count == 0 || count > rest.len() {
            return Err(Fault::malformed("a run of pixels does not fit into its scanline"));
        }
        let (now, later) = rest.split_at_mut(count);
        if code > 128 {
            let [value] = array(read)?;
            now.iter_mut().for_each(|pixel| pixel[component] = value);
        } else {
            for pixel in now {
                [pixel[component]] = array(read)?;
            }
        }
        rest = later;
    }
    Ok(())
}

/// Whole pixels. One whose mantissas are 1, 1, 1 repeats the pixel before it as often as its exponent
/// says; one right after it counts the next 8 bits of that number.
fn old_runs(
    read: &mut impl Read,
    line: &mut [[u8; 4]],
    mut first: Option<[u8; 4]>,
) -> Result<(), Fault> {
    let (mut at, mut shift) = (0, 0);
    while at < line.len() {
        let pixel = match first.take() {
            Some(pixel) => pixel,
            None => array(read)?,
        };
        let [1, 1, 1, count] = pixel else {
            line[at] = pixel;
            at += 1;
            shift = 0;
            continue;
        };
        let count = match shift {
            0..=24 => usize::from(count) << shift,
            _ => usize::MAX,
        };
        if at == 0 || count > line.len() - at {
            return Err(Fault::malformed("a run of pixels does not fit into its scanline"));
        }
        let before = line[at - 1];
        line[at..at + count].fill(before);
        at += count;
        shift += 8;
    }
    Ok(())
}
