//! `phenomenon compare`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use phenomenon_runtime::film::{self, CompareError, Comparison, Difference, NotFinite};
use serde_json::{Value, json};

use crate::arguments::{self, Format};
use crate::failure::{Failure, Outcome};
use crate::numbers::{digits, number};
use crate::outputs::{self, Output};
use crate::terminal;

/// Measure how far two pictures are apart.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A picture: png, jpg, exr or hdr
    #[arg(value_hint = ValueHint::FilePath)]
    a: PathBuf,

    /// Another, of the same size
    #[arg(value_hint = ValueHint::FilePath)]
    b: PathBuf,

    /// Largest root mean square allowed, of sRGB-encoded values; 0 allows only the same bits
    #[arg(long, value_name = "RMS", value_parser = arguments::tolerance)]
    tolerance: Option<f64>,

    /// Write a picture of the differences
    #[arg(short, value_name = "DIFF.png", value_parser = arguments::picture,
          value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,

    /// How to print
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

const EXAMPLES: &str = "\
Encoded values are what a screen shows: sRGB-encoded and clamped to 0..1. Raw values are scene-linear,
multiplied by alpha. The tolerance is one for red, green and blue; alpha counts only for whether all
bits agree. NaN or infinity agrees with nothing but itself, whatever the tolerance.

JSON, version 1: rms and maximum of the encoded values, raw and alpha with the same two, identical,
within (whether the exit code is 0), tolerance or null, width, height, and not_finite: how many pixels
disagree about NaN or infinity, and the first: column, row, channel, a and b. A number that is not
finite is the string NaN, inf or -inf.

Examples:
  phenomenon compare walk.exr jit.exr --tolerance 0
  phenomenon compare before.png after.png --tolerance 5e-3 -o difference.png
  phenomenon compare a.exr b.exr --format json

Exit codes:
  0  no tolerance was given, or the difference is within it
  1  the difference is above the tolerance, or NaN or infinity is in one picture only
  2  a picture cannot be read or written, or the sizes differ";

/// Runs the command.
///
/// # Errors
/// A picture that cannot be read or written, or two of different sizes.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let output = arguments.output.as_deref().map(|path| Output { flag: "-o", path });
    output.map_or(Ok(()), Output::require_writable)?;
    let read = |path| {
        film::read(path).map_err(|error| {
            let help = error.help();
            Failure::new(error, help)
        })
    };
    let (a, b) = (read(&arguments.a)?, read(&arguments.b)?);
    outputs::require_apart(output.as_slice())?;
    let refused = |error: CompareError| {
        let help = match error {
            CompareError::SizesDiffer { .. } => "compare pictures of one size",
            CompareError::Size(_) => "leave -o out, or compare smaller pictures",
        };
        Failure::new(error, help)
    };
    let comparison = film::compare(&a, &b).map_err(refused)?;
    if let Some(output) = output {
        let picture = film::difference_picture(&a, &b).map_err(refused)?;
        let picture = film::encode(&picture, output.path, 1.0).map_err(|error| {
            let help = error.help();
            Failure::new(error, help)
        })?;
        output.write(picture)?;
    }
    let within = comparison.not_finite == 0
        && match arguments.tolerance {
            None => true,
            Some(0.0) => comparison.identical,
            Some(tolerance) => comparison.encoded.rms <= tolerance,
        };
    match arguments.format {
        Format::Human => terminal::print(&human(&comparison))?,
        Format::Json => {
            let object = object(&comparison, (a.width(), a.height()), arguments.tolerance, within);
            terminal::print_exactly(&format!("{object}\n"))?;
        }
    }
    Ok(if within { Outcome::Fine } else { Outcome::Found })
}

const CHANNELS: [&str; 4] = ["red", "green", "blue", "alpha"];

fn human(comparison: &Comparison) -> String {
    let line = |name, difference: Difference| {
        format!("{name}  rms {:e}  maximum {:e}\n", difference.rms, difference.maximum)
    };
    let mut text = line("encoded", comparison.encoded)
        + &line("raw    ", comparison.raw)
        + &line("alpha  ", comparison.alpha);
    text += if comparison.identical { "all bits agree\n" } else { "not all bits agree\n" };
    if let Some(NotFinite { column, row, channel, values: [a, b] }) = comparison.first_not_finite {
        let count = comparison.not_finite;
        let pixels = if count == 1 { "pixel has" } else { "pixels have" };
        text += &format!(
            "{count} {pixels} NaN or infinity in one picture and not in the other; the first, column {column} and row {row} from the top left at 0: {} is {} and {}\n",
            CHANNELS[channel],
            digits(a),
            digits(b)
        );
    }
    text
}

/// Keys are documented under `--help`; a change that breaks readers has a new version.
fn object(
    comparison: &Comparison,
    (width, height): (u32, u32),
    tolerance: Option<f64>,
    within: bool,
) -> Value {
    let both = |Difference { rms, maximum }: Difference| (wide_number(rms), wide_number(maximum));
    let (rms, maximum) = both(comparison.encoded);
    let (raw_rms, raw_maximum) = both(comparison.raw);
    let (alpha_rms, alpha_maximum) = both(comparison.alpha);
    let first = comparison.first_not_finite.map(|first| {
        let [a, b] = first.values.map(number);
        let channel = CHANNELS[first.channel];
        json!({ "column": first.column, "row": first.row, "channel": channel, "a": a, "b": b })
    });
    json!({
        "version": 1,
        "width": width,
        "height": height,
        "rms": rms,
        "maximum": maximum,
        "raw": { "rms": raw_rms, "maximum": raw_maximum },
        "alpha": { "rms": alpha_rms, "maximum": alpha_maximum },
        "identical": comparison.identical,
        "not_finite": { "pixels": comparison.not_finite, "first": first },
        "tolerance": tolerance,
        "within": within,
    })
}

/// A number of 64 bits; what is not finite is named, as those of 32 bits are.
fn wide_number(x: f64) -> Value {
    if x.is_finite() { x.into() } else { x.to_string().into() }
}
