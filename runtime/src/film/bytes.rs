//! The bytes of a file, in memory.

use std::io::{self, ErrorKind, Seek, SeekFrom, Write};

/// Bytes that are written anywhere, as in a file. Where there is not enough memory for more, that is an
/// error of writing rather than the end of the program.
#[derive(Debug, Default)]
pub(super) struct Bytes {
    bytes: Vec<u8>,
    /// Where the next byte goes.
    position: usize,
}

impl Bytes {
    pub(super) fn into_inner(self) -> Vec<u8> {
        self.bytes
    }
}

impl Write for Bytes {
    fn write(&mut self, new: &[u8]) -> io::Result<usize> {
        let end = self.position + new.len();
        if let Some(more) = end.checked_sub(self.bytes.len()) {
            self.bytes.try_reserve(more).map_err(|_| ErrorKind::OutOfMemory)?;
            self.bytes.resize(end, 0);
        }
        self.bytes[self.position..end].copy_from_slice(new);
        self.position = end;
        Ok(new.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for Bytes {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let (from, by) = match to {
            SeekFrom::Start(at) => (at, 0),
            SeekFrom::Current(by) => (self.position as u64, by),
            SeekFrom::End(by) => (self.bytes.len() as u64, by),
        };
        let position = from.checked_add_signed(by).ok_or(ErrorKind::InvalidInput)?;
        self.position = usize::try_from(position).map_err(|_| ErrorKind::InvalidInput)?;
        Ok(position)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_overwritten_appended_and_left_out() {
        let mut bytes = Bytes::default();
        bytes.write_all(b"abcdef").unwrap();
        assert_eq!(bytes.seek(SeekFrom::Start(4)).unwrap(), 4);
        bytes.write_all(b"XYZ").unwrap();
        assert_eq!(bytes.seek(SeekFrom::Current(-6)).unwrap(), 1);
        bytes.write_all(b"-").unwrap();
        assert_eq!(bytes.seek(SeekFrom::End(2)).unwrap(), 9);
        bytes.write_all(b"!").unwrap();
        assert!(bytes.seek(SeekFrom::Current(-11)).is_err());
        assert_eq!(bytes.into_inner(), b"a-cdXYZ\0\0!"[..].to_vec());
    }
}
