//! Segments as text, one operation a line; the format is kept stable for snapshots.

use std::fmt::{self, Display, Formatter};

use super::{Op, OpSegment};
use crate::storage::Source;

impl Display for OpSegment {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for source in &self.wanted {
            writeln!(f, "where {}", Place(*source))?;
        }
        for (id, &op) in self.ops.iter().enumerate() {
            write!(f, "%{id} = ")?;
            match op {
                Op::Load(n) => match self.sources.get(n as usize) {
                    Some(&source) => writeln!(f, "load {}", Place(source))?,
                    None => writeln!(f, "load missing source {n}")?,
                },
                op => writeln!(f, "{op}")?,
            }
        }
        for (slot, id) in &self.stores {
            writeln!(f, "store slot {slot}, %{id}")?;
        }
        Ok(())
    }
}

/// Where a word lies.
struct Place(Source);

impl Display for Place {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.0 {
            Source::Uniform(at) | Source::Constant { at, .. } => write!(f, "uniform {at}"),
            Source::Slot(slot) => write!(f, "slot {slot}"),
        }
    }
}

impl Display for Op {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())?;
        match *self {
            Op::Load(n) => return write!(f, " {n}"),
            Op::Constant(bits) => return constant(f, bits),
            Op::Number(number) => return write!(f, " {:?}", number.value()),
            Op::Integer(value) => return write!(f, " {value}"),
            Op::Truth(value) => return write!(f, " {value}"),
            _ => {}
        }
        let mut separator = " ";
        let mut result = Ok(());
        self.for_each_operand(|id| {
            result = result.and_then(|()| write!(f, "{separator}%{id}"));
            separator = ", ";
        });
        result?;
        match *self {
            Op::ShiftLeft(_, bits) | Op::ShiftRight(_, bits) | Op::ShiftRightSigned(_, bits) => {
                write!(f, ", {bits}")
            }
            Op::Table(table, _) => write!(f, " of {}", table.numbers().len()),
            _ => Ok(()),
        }
    }
}

/// Truth values by name; small integers, which would be subnormal numbers, as integers; all else as
/// a number, in hexadecimal (exact) and decimal.
fn constant(f: &mut Formatter<'_>, bits: u32) -> fmt::Result {
    let value = f32::from_bits(bits);
    match bits {
        u32::MAX => write!(f, " all"),
        0 => write!(f, " 0"),
        _ if value.is_nan() || value.is_subnormal() => {
            write!(f, " {bits:#010x} (integer {})", bits as i32)
        }
        _ if value.is_infinite() => write!(f, " {value}"),
        0x8000_0000 => write!(f, " -0x0.0p0 (-0)"),
        _ => {
            let sign = if value.is_sign_negative() { "-" } else { "" };
            let exponent = (bits >> 23 & 0xff) as i32 - 127;
            let fraction = format!("{:06x}", (bits & 0x7f_ffff) << 1);
            let fraction = match fraction.trim_end_matches('0') {
                "" => "0",
                digits => digits,
            };
            write!(f, " {sign}0x1.{fraction}p{exponent} ({value:?})")
        }
    }
}
