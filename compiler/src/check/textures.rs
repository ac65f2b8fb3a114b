//! Pictures a graph names: each must be there.

use std::path::Path;

use crate::diagnostics::{Code, shortened};
use crate::document::{Reader, ValueKind};
use crate::values::TilePattern;

use super::files::Files;
use super::literals::beside;

/// Reports every picture that was named so far and cannot be opened.
pub(super) fn check(reader: &mut Reader<'_>, files: &dyn Files) {
    for value in std::mem::take(&mut reader.files) {
        let ValueKind::String(file) = &value.kind else { continue };
        let path = beside(&reader.document.file.name, file);
        let pattern = TilePattern::of(&path);
        let unusable = match &pattern {
            Some(pattern) => unusable_tiles(files, pattern),
            None => files.unusable_picture(&path),
        };
        if let Some((code, why)) = unusable {
            let message = format!("the texture `{}` cannot be used: {why}", shortened(file));
            let help = match (code, pattern) {
                (Code::UNREADABLE_FILE, Some(_)) => {
                    "`<UDIM>` stands for the numbers 1001 + u + 10 v, `<UVTILE>` for `_u1_v1` and so on; \
                     paths are relative to the folder of this file"
                }
                (Code::UNREADABLE_FILE, None) => "paths are relative to the folder of this file",
                _ => "write the picture again, smaller if need be, or name another",
            };
            reader.report(code, value, message, help);
        }
    }
}

/// Why tiles cannot be used: there are none, or the first that cannot.
fn unusable_tiles(files: &dyn Files, pattern: &TilePattern) -> Option<(Code, String)> {
    let tiles = match files.tiles(pattern) {
        Ok(tiles) => tiles,
        Err(error) => return Some((Code::UNREADABLE_FILE, error.to_string())),
    };
    tiles.iter().find_map(|(_, path)| {
        let (code, why) = files.unusable_picture(path)?;
        let name = path.file_name().unwrap_or(Path::new("").as_os_str());
        Some((code, format!("its tile `{}`: {why}", shortened(&name.to_string_lossy()))))
    })
}
