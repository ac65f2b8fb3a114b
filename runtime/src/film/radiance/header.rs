//! The lines before the pixels.

use std::io::Read;

use crate::film::fault::Fault;
use crate::film::format::{Channels, Format, PictureHeader};
use crate::film::input::array;

/// Most bytes of one line.
const LINE_LIMIT: usize = 1 << 16;

/// What the lines before the pixels say.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::film) struct Header {
    /// What the values of each colour are divided by: all exposures and colour corrections.
    pub(super) divisor: [f64; 3],
    /// In which order the pixels come.
    pub(super) order: Order,
}

/// In which order the pixels come: the two axes of the resolution string.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Order {
    /// From one scanline to the next.
    pub(super) lines: Axis,
    /// From one pixel to the next.
    pub(super) pixels: Axis,
}

/// A way through the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Axis {
    /// Along rows (x) rather than columns (y).
    pub(super) horizontal: bool,
    /// To the left, or upwards.
    pub(super) reversed: bool,
    /// How many there are.
    pub(super) count: u32,
}

impl Order {
    fn sides(self) -> (u32, u32) {
        match self.lines.horizontal {
            true => (self.lines.count, self.pixels.count),
            false => (self.pixels.count, self.lines.count),
        }
    }

    /// Column and row of a pixel of a scanline.
    pub(super) fn place(self, line: u32, pixel: u32) -> (u32, u32) {
        let along = |axis: Axis, at: u32| if axis.reversed { axis.count - 1 - at } else { at };
        let (line, pixel) = (along(self.lines, line), along(self.pixels, pixel));
        if self.lines.horizontal { (line, pixel) } else { (pixel, line) }
    }
}

impl Header {
    pub(in crate::film) fn summary(&self) -> PictureHeader {
        let (width, height) = self.order.sides();
        PictureHeader { format: Format::Hdr, width, height, channels: Channels::Color }
    }
}

/// Reads up to the first pixel, where `#?` has been read.
///
/// The word after it is the program that made the file: any may stand there, if `FORMAT` says what
/// follows. Without `FORMAT` only `#?RADIANCE` and `#?RGBE` are believed.
pub(in crate::film) fn read_header(read: &mut impl Read) -> Result<Header, Fault> {
    let program = line(read)?;
    let mut format = None;
    let mut divisor = [1.0; 3];
    loop {
        let text = line(read)?;
        if text.is_empty() {
            break;
        }
        let Some((name, value)) = text.split_once('=').filter(|_| !text.starts_with('#')) else {
            // A comment, or the command that made the picture.
            continue;
        };
        let value = value.trim();
        match name.trim() {
            "FORMAT" => format = Some(value.to_owned()),
            "EXPOSURE" => {
                let [exposure] = numbers(name, value)?;
                divisor = divisor.map(|factor| factor * exposure);
            }
            "COLORCORR" => {
                let correction: [f64; 3] = numbers(name, value)?;
                divisor = std::array::from_fn(|k| divisor[k] * correction[k]);
            }
            "GAMMA" if numbers(name, value)? != [1.0] => {
                return Err(Fault::Malformed(format!(
                    "GAMMA={value}: only linear values are read; write it again with GAMMA=1"
                )));
            }
            _ => {}
        }
    }
    match format.as_deref() {
        Some("32-bit_rle_rgbe") => {}
        Some("32-bit_rle_xyze") => {
            return Err(Fault::malformed(
                "its colors are XYZ (FORMAT=32-bit_rle_xyze); only red, green and blue are read: convert it, such as by `ra_xyze -r`",
            ));
        }
        None if matches!(program.as_str(), "RADIANCE" | "RGBE") => {}
        None => return Err(Fault::malformed("no line FORMAT=32-bit_rle_rgbe is in its header")),
        Some(other) => {
            return Err(Fault::Malformed(format!(
                "FORMAT={other} is not read; 32-bit_rle_rgbe is"
            )));
        }
    }
    if !divisor.iter().all(|factor| factor.is_normal()) {
        return Err(Fault::malformed("its EXPOSURE and COLORCORR come to no usable factor"));
    }
    let text = line(read)?;
    let order = order(&text).ok_or_else(|| {
        Fault::Malformed(format!("`{text}` is no resolution; it looks like `-Y 512 +X 1024`"))
    })?;
    Ok(Header { divisor, order })
}

/// A line without its end.
fn line(read: &mut impl Read) -> Result<String, Fault> {
    let mut bytes = Vec::new();
    loop {
        match array(read)? {
            [b'\n'] => break,
            _ if bytes.len() == LINE_LIMIT => {
                return Err(Fault::malformed("a line of its header does not end"));
            }
            [byte] => bytes.push(byte),
        }
    }
    let text = String::from_utf8_lossy(&bytes);
    Ok(text.trim_end_matches('\r').to_owned())
}

/// Positive numbers with white space between.
fn numbers<const COUNT: usize>(name: &str, text: &str) -> Result<[f64; COUNT], Fault> {
    let bad =
        || Fault::Malformed(format!("{name}={text}: {COUNT} numbers above 0 are to stand here"));
    let mut words = text.split_whitespace();
    let mut numbers = [0.0; COUNT];
    for number in &mut numbers {
        let word = words.next().ok_or_else(bad)?;
        *number = word.parse().ok().filter(|x: &f64| x.is_finite() && *x > 0.0).ok_or_else(bad)?;
    }
    match words.next() {
        None => Ok(numbers),
        Some(_) => Err(bad()),
    }
}

/// The resolution string: two axes, one of each kind.
fn order(text: &str) -> Option<Order> {
    let mut words = text.split_whitespace();
    let mut axis = || {
        let (horizontal, reversed) = match words.next()? {
            "+X" => (true, false),
            "-X" => (true, true),
            // Radiance's y points up, rows are counted down.
            "-Y" => (false, false),
            "+Y" => (false, true),
            _ => return None,
        };
        let count = words.next()?.parse().ok()?;
        Some(Axis { horizontal, reversed, count })
    };
    let (lines, pixels) = (axis()?, axis()?);
    let both = lines.horizontal != pixels.horizontal;
    (both && words.next().is_none()).then_some(Order { lines, pixels })
}
