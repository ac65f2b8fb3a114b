//! `-o FILE`.

use std::fs::{self, OpenOptions};
use std::path::{Path, PathBuf};

use crate::failure::Failure;

/// Reads a path whose extension is that of a picture format.
pub fn picture(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let extension = path.extension().and_then(|extension| extension.to_str());
    match extension.map(str::to_ascii_lowercase).as_deref() {
        Some("png" | "exr" | "hdr") => Ok(path),
        _ => Err("end the name in .png, .exr or .hdr".into()),
    }
}

/// Fails if a file could not be written at `path`; leaves what is there as it is. Asked before
/// long work, so that no render is lost to a misspelt folder.
pub fn require_writable(flag: &str, path: &Path) -> Result<(), Failure> {
    let shown = path.display();
    let refuse =
        |why: String, help: &str| Err(Failure::new(format!("{flag} {shown}: {why}"), help));
    if path.is_dir() {
        return refuse("this is a folder".into(), "name a file in it");
    }
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    if !folder.is_dir() {
        return refuse(
            format!("there is no folder {}", folder.display()),
            "make the folder first, or name another",
        );
    }
    let existed = path.exists();
    match OpenOptions::new().append(true).create(true).open(path) {
        Ok(_) if existed => Ok(()),
        Ok(_) => {
            let _ = fs::remove_file(path);
            Ok(())
        }
        Err(error) => refuse(error.to_string(), "name a file that may be written"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_picture_formats_are_taken() {
        for text in ["a.png", "b/c.EXR", "x.y.hdr"] {
            assert!(picture(text).is_ok(), "{text}");
        }
        for text in ["", "a", "png", ".png", "a.jpg", "a.png/", "a.png.gz", "/dev/stdout"] {
            let refused = picture(text).is_err();
            assert_eq!(refused, text != "a.png/", "{text}");
        }
    }
}
