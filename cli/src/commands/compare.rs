//! `phenomenon compare`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use phenomenon_runtime::film;

use crate::arguments;
use crate::failure::{Failure, Outcome};
use crate::outputs::{self, Output};
use crate::terminal;

/// Measure how far two pictures are apart.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A picture: png, exr or hdr
    #[arg(value_hint = ValueHint::FilePath)]
    a: PathBuf,

    /// Another, of the same size
    #[arg(value_hint = ValueHint::FilePath)]
    b: PathBuf,

    /// Largest root mean square allowed, of sRGB-encoded values; 0 allows only the same bits
    #[arg(long, value_name = "RMS", value_parser = arguments::tolerance,
          allow_hyphen_values = true)]
    tolerance: Option<f64>,

    /// Write a picture of the differences
    #[arg(short, value_name = "DIFF.png", value_parser = arguments::picture,
          value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Encoded values are what a screen shows: sRGB-encoded and clamped to 0..1. Raw values are those of
the file, for a PNG decoded to scene-linear ones. Alpha counts only for whether all bits agree.

Examples:
  phenomenon compare walk.exr jit.exr --tolerance 0
  phenomenon compare before.png after.png --tolerance 5e-3 -o difference.png

Exit codes:
  0  no tolerance was given, or the difference is within it
  1  the difference is above the tolerance
  2  a picture cannot be read or written, or the sizes differ";

/// Runs the command.
///
/// # Errors
/// A picture that cannot be read or written, or two of different sizes.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let output = arguments.output.as_deref().map(|path| Output { flag: "-o", path });
    output.map_or(Ok(()), Output::require_writable)?;
    let read = |path| {
        film::read(path).map_err(|error| Failure::new(error, "give a .png, .exr or .hdr picture"))
    };
    let (a, b) = (read(&arguments.a)?, read(&arguments.b)?);
    outputs::require_apart(output.as_slice())?;
    let comparison = film::compare(&a, &b)
        .map_err(|error| Failure::new(error, "compare pictures of one size"))?;
    if let Some(output) = output {
        let picture = film::encode(&comparison.picture, output.path, 1.0)
            .map_err(|error| Failure::new(error, "name another file with -o"))?;
        output.write(picture)?;
    }
    let line = |name, difference: film::Difference| {
        format!("{name}  rms {:e}  maximum {:e}\n", difference.rms, difference.maximum)
    };
    let mut text = line("encoded", comparison.encoded) + &line("raw    ", comparison.raw);
    text += if comparison.identical { "all bits agree\n" } else { "not all bits agree\n" };
    terminal::print(&text)?;
    let within = match arguments.tolerance {
        None => true,
        Some(0.0) => comparison.identical,
        Some(tolerance) => comparison.encoded.rms <= tolerance,
    };
    Ok(if within { Outcome::Fine } else { Outcome::Found })
}
