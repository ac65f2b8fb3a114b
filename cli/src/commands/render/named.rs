//! Pictures named after the file they are of.
//!
//! Such a name was not chosen, so it must not cost anybody a file: a photograph `wood.png` may lie
//! beside `wood.json`, or a texture that other graphs use. The picture carries a mark, and only a
//! picture with the mark is replaced by the next.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::inputs;

/// Signature and header of a PNG, which the mark stands behind.
const HEAD: usize = 8 + 25;

/// A text chunk, with its length and its checksum: <https://www.w3.org/TR/png-3/#11tEXt>.
const MARK: &[u8] =
    b"\0\0\0\x30tEXtSoftware\0phenomenon render, named after its file\xab\x71\x10\xf3";

/// The name of the picture of a file: `NAME.png` here, for a file called `NAME.json`.
///
/// # Errors
/// The file has no name.
pub fn name(file: &Path) -> Result<PathBuf, Failure> {
    if inputs::is_stream(file) {
        return Err(Failure::new(
            "a picture of standard input has no name",
            "give one with -o, such as -o picture.png",
        ));
    }
    let Some(name) = file.file_stem() else {
        let message = format!("{} is no file", file.display());
        return Err(Failure::new(message, "give a graph or scene file"));
    };
    let mut name = name.to_os_string();
    name.push(".png");
    Ok(name.into())
}

/// Fails where something is under the name that is no picture named so.
///
/// # Errors
/// There is.
pub fn require_replaceable(path: &Path) -> Result<(), Failure> {
    // A pipe must not be opened; that it is none of ours is said where it is written.
    if !path.is_file() {
        return Ok(());
    }
    let mut start = Vec::new();
    let read = File::open(path)
        .and_then(|file| file.take((HEAD + MARK.len()) as u64).read_to_end(&mut start));
    if read.is_ok() && start.get(HEAD..) == Some(MARK) {
        return Ok(());
    }
    let path = path.display();
    Err(Failure::new(
        format!("{path} exists, and is no picture that was named after its file"),
        format!("name another file with -o, or replace it with -o {path}"),
    ))
}

/// A PNG with the mark.
pub fn marked(mut png: Vec<u8>) -> Vec<u8> {
    png.splice(HEAD..HEAD, MARK.iter().copied());
    png
}

#[cfg(test)]
mod tests {
    use phenomenon_runtime::film::{Film, compare, encode, read};

    use super::*;

    /// The checksum of a chunk, by the definition: <https://www.w3.org/TR/png-3/#5CRC-algorithm>.
    fn checksum(bytes: &[u8]) -> u32 {
        !bytes.iter().fold(u32::MAX, |sum, &byte| {
            (0..8).fold(sum ^ u32::from(byte), |sum, _| {
                if sum & 1 == 1 { (sum >> 1) ^ 0xedb8_8320 } else { sum >> 1 }
            })
        })
    }

    #[test]
    fn the_mark_is_a_chunk() {
        let (length, rest) = MARK.split_at(4);
        let (chunk, sum) = rest.split_at(rest.len() - 4);
        assert_eq!(length, ((chunk.len() - 4) as u32).to_be_bytes());
        assert_eq!(sum, checksum(chunk).to_be_bytes());
    }

    #[test]
    fn a_marked_picture_is_the_same_picture() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        let mut film = Film::new(3, 2).unwrap();
        film.set(1, 1, [0.5, 0.25, 1.0, 1.0]);
        let plain = encode(&film, &path, 1.0).unwrap();
        std::fs::write(&path, &plain).unwrap();
        let before = read(&path).unwrap();
        let refused = require_replaceable(&path).unwrap_err();
        assert!(refused.to_string().contains("a.png"), "{refused}");
        std::fs::write(&path, marked(plain)).unwrap();
        require_replaceable(&path).unwrap();
        assert!(compare(&before, &read(&path).unwrap()).unwrap().identical);
        for other in [&b""[..], b"\x89PNG\r\n\x1a\n", b"a photograph", MARK] {
            std::fs::write(&path, other).unwrap();
            assert!(require_replaceable(&path).is_err());
        }
        require_replaceable(&folder.path().join("absent.png")).unwrap();
    }
}
