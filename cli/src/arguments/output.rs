//! `-o FILE`.

use std::path::PathBuf;

/// Reads a path whose extension is that of a picture format.
pub fn picture(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let extension = path.extension().and_then(|extension| extension.to_str());
    match extension.map(str::to_ascii_lowercase).as_deref() {
        Some("png" | "exr" | "hdr") => Ok(path),
        _ => Err("end the name in .png, .exr or .hdr".into()),
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
