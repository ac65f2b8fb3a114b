//! Where the bytes for a path go.

use std::fs::{self, FileType};
use std::path::{Path, PathBuf};

use super::error::WriteCause;

/// Where the bytes for a path go.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Target {
    /// To a regular file, or one that can be made: no link.
    File(PathBuf),
    /// To a device such as `/dev/null`, or to a descriptor the program was started with.
    Stream(PathBuf),
}

/// Most links that are followed, as many as Linux does.
const LINK_LIMIT: usize = 40;

/// Follows the links at the end of a path. Nothing is opened: a pipe would wait for its reader.
pub(super) fn target(path: &Path) -> Result<Target, WriteCause> {
    let mut path = path.to_owned();
    for _ in 0..LINK_LIMIT {
        if is_descriptor(&path) {
            return Ok(Target::Stream(path));
        }
        if let Ok(link) = fs::read_link(&path) {
            path = folder(&path).join(link);
            continue;
        }
        return match fs::metadata(&path) {
            Ok(metadata) if metadata.is_file() => Ok(Target::File(path)),
            Ok(metadata) if metadata.is_dir() => Err(WriteCause::IsFolder),
            Ok(metadata) => match special(metadata.file_type()) {
                "a device" => Ok(Target::Stream(path)),
                kind => Err(WriteCause::NotRegular(kind)),
            },
            Err(_) if !folder(&path).is_dir() => {
                Err(WriteCause::NoFolder(folder(&path).to_owned()))
            }
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
                // `new/` names a folder that is not there.
                match path.file_name() {
                    Some(_) if !ends_in_separator(&path) => Ok(Target::File(path)),
                    _ => Err(WriteCause::IsFolder),
                }
            }
            Err(error) => Err(WriteCause::System(error)),
        };
    }
    Err(WriteCause::LinksInCircle)
}

/// The folder a path lies in.
pub(super) fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

fn ends_in_separator(path: &Path) -> bool {
    path.as_os_str()
        .as_encoded_bytes()
        .last()
        .is_some_and(|&last| std::path::is_separator(char::from(last)))
}

/// Whether a path leads to what the program was started with: `/dev/stdin`, `/dev/stdout`,
/// `/dev/fd/63`, as shells write for `<(…)` and `>(…)`. Opening one never waits.
pub fn is_descriptor(path: &Path) -> bool {
    let mut path = path.to_owned();
    for _ in 0..LINK_LIMIT {
        if let Ok(folder) = fs::canonicalize(folder(&path))
            && (folder == Path::new("/dev/fd")
                || (folder.starts_with("/proc") && folder.ends_with("fd")))
        {
            return true;
        }
        match fs::read_link(&path) {
            Ok(link) => path = folder(&path).join(link),
            Err(_) => return false,
        }
    }
    false
}

/// What something is that is neither a file nor a folder.
#[cfg(unix)]
fn special(kind: FileType) -> &'static str {
    use std::os::unix::fs::FileTypeExt;
    if kind.is_char_device() {
        "a device"
    } else if kind.is_block_device() {
        // Bytes written to it would be lost to the file system on it.
        "a disk"
    } else if kind.is_fifo() {
        "a pipe, which may have no reader"
    } else if kind.is_socket() {
        "a socket"
    } else {
        "something else"
    }
}

#[cfg(not(unix))]
fn special(_: FileType) -> &'static str {
    "a device"
}
