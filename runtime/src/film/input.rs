//! The bytes of a file, one after the other.

use std::io::{self, Read};

use super::fault::Fault;

/// The next bytes.
pub(super) fn array<const COUNT: usize>(read: &mut impl Read) -> Result<[u8; COUNT], Fault> {
    let mut bytes = [0; COUNT];
    read.read_exact(&mut bytes)?;
    Ok(bytes)
}

/// Passes over bytes.
pub(super) fn skip(read: &mut impl Read, count: u64) -> Result<(), Fault> {
    match io::copy(&mut read.take(count), &mut io::sink())? == count {
        true => Ok(()),
        false => Err(io::Error::from(io::ErrorKind::UnexpectedEof).into()),
    }
}
