//! Opening files: the one gate through which all are read.

use std::collections::BTreeSet;
use std::fs::{self, File, Metadata};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Kept where files are opened, so that none is forgotten: graphs name textures, scenes name meshes,
/// phenomena name one another.
static OPENED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// The paths of all files this process has opened through [`open_file`]. A program that writes files
/// asks for them, so as to replace none that it has read.
pub fn opened_files() -> Vec<PathBuf> {
    let opened = OPENED.lock().unwrap_or_else(PoisonError::into_inner);
    opened.iter().cloned().collect()
}

/// Opens a regular file; yields its size in bytes too. Anything else is refused before it is opened:
/// a pipe nobody writes to would be waited for, and a device may never end.
///
/// # Errors
/// There is no such file, it may not be read, or it is no regular file.
pub fn open_file(path: &Path) -> io::Result<(File, u64)> {
    let metadata = fs::metadata(path)?;
    if metadata.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    if let Some(what) = irregular(&metadata) {
        return Err(io::Error::new(ErrorKind::InvalidInput, what));
    }
    let file = File::open(path)?;
    OPENED.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_owned());
    Ok((file, metadata.len()))
}

/// What something is that is neither a regular file nor a folder; none where it is.
pub(crate) fn irregular(metadata: &Metadata) -> Option<String> {
    if metadata.is_file() || metadata.is_dir() {
        return None;
    }
    Some(format!("it is no ordinary file{}", kind(metadata)))
}

#[cfg(unix)]
fn kind(metadata: &Metadata) -> &'static str {
    use std::os::unix::fs::FileTypeExt;
    let kind = metadata.file_type();
    if kind.is_fifo() {
        " but a pipe"
    } else if kind.is_socket() {
        " but a socket"
    } else if kind.is_char_device() || kind.is_block_device() {
        " but a device"
    } else {
        ""
    }
}

#[cfg(not(unix))]
fn kind(_: &Metadata) -> &'static str {
    ""
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn only_regular_files_are_opened() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::write(path("file"), "four").unwrap();
        std::os::unix::fs::symlink("file", path("link")).unwrap();
        assert_eq!(open_file(&path("link")).unwrap().1, 4);
        assert!(opened_files().contains(&path("link")));
        let made = std::process::Command::new("mkfifo").arg(path("pipe")).status().unwrap();
        assert!(made.success());
        let _listener = std::os::unix::net::UnixListener::bind(path("socket")).unwrap();
        let refused = |path: &Path| open_file(path).unwrap_err().to_string();
        assert_eq!(refused(&path("pipe")), "it is no ordinary file but a pipe");
        assert_eq!(refused(&path("socket")), "it is no ordinary file but a socket");
        assert_eq!(refused(Path::new("/dev/zero")), "it is no ordinary file but a device");
        assert_eq!(open_file(folder.path()).unwrap_err().kind(), ErrorKind::IsADirectory);
        assert_eq!(open_file(&path("absent")).unwrap_err().kind(), ErrorKind::NotFound);
        assert!(!opened_files().contains(&path("pipe")));
    }
}
