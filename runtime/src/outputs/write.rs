//! Writing.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;

use tempfile::{Builder, NamedTempFile};

use super::error::{WriteCause, WriteError};
use super::target::{Target, folder, target};

/// Writes a file whole, or leaves what is there as it is. A link stays a link, and what it leads to
/// is replaced; permissions stay as they are. A file of several names (hard links) gets its new
/// content under the one that is written, and keeps the old one under the others.
///
/// Devices such as `/dev/null` and what the program was started with, such as `/dev/stdout`, are
/// written to. Any other pipe, socket or disk is refused.
///
/// # Errors
/// It cannot be written; what was there is untouched, and nothing else is left behind.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    let written = target(path).and_then(|target| match target {
        Target::File(file) => replace(&file, bytes),
        Target::Stream(stream) => append(&stream, bytes).map_err(WriteCause::System),
    });
    written.map_err(|cause| WriteError { path: path.to_owned(), cause })
}

/// Fails if [`write()`] could not write a file of one byte. Asked before long work, so that none is
/// lost to a misspelt folder.
///
/// # Errors
/// Why it could not be written.
pub fn require_writable(path: &Path) -> Result<(), WriteError> {
    let possible = target(path).and_then(|target| match target {
        Target::Stream(stream) => open_stream(&stream).map(|_| ()).map_err(WriteCause::System),
        Target::File(file) => {
            // The name could be taken from a file that may not be written, but that is not meant.
            match OpenOptions::new().append(true).open(&file) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(WriteCause::System(error));
                }
                _ => {}
            }
            temporary(&file).map(|_| ())
        }
    });
    possible.map_err(|cause| WriteError { path: path.to_owned(), cause })
}

/// A file beside `path` that is removed unless it is renamed.
fn temporary(path: &Path) -> Result<NamedTempFile, WriteCause> {
    let mut builder = Builder::new();
    // A hidden name, which searches of folders pass over, of a length that every disk takes.
    builder.prefix(".phenomenon-").suffix(".tmp");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As any new file has them: the system takes away what the user's mask says.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let folder = folder(path);
    builder
        .tempfile_in(folder)
        .map_err(|error| WriteCause::ClosedFolder(folder.to_owned(), unwrapped(error)))
}

/// `tempfile` wraps errors to name its file, which says nothing to a user.
fn unwrapped(error: io::Error) -> io::Error {
    match error.raw_os_error() {
        Some(number) => io::Error::from_raw_os_error(number),
        None => io::Error::from(error.kind()),
    }
}

fn replace(path: &Path, bytes: &[u8]) -> Result<(), WriteCause> {
    let old = fs::metadata(path).ok();
    if old.is_some() {
        OpenOptions::new().append(true).open(path).map_err(WriteCause::System)?;
    }
    let temporary = temporary(path)?;
    let mut file: &File = temporary.as_file();
    // A disk may find only when its buffers are written that it is full.
    file.write_all(bytes).and_then(|()| file.sync_all()).map_err(WriteCause::System)?;
    if let Some(old) = old {
        keep_permissions(file, &old).map_err(WriteCause::System)?;
    }
    temporary.persist(path).map_err(|error| WriteCause::System(unwrapped(error.error)))?;
    Ok(())
}

#[cfg(unix)]
fn keep_permissions(file: &File, old: &fs::Metadata) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
    let new = file.metadata()?;
    if (new.uid(), new.gid()) != (old.uid(), old.gid()) {
        // Only root may give files away; that the writer owns the new one is no reason to fail.
        let _ = fchown(file, Some(old.uid()), Some(old.gid()));
    }
    file.set_permissions(fs::Permissions::from_mode(old.mode() & 0o777))
}

#[cfg(not(unix))]
fn keep_permissions(file: &File, old: &fs::Metadata) -> io::Result<()> {
    file.set_permissions(old.permissions())
}

/// Behind what is there: `>> log` must not lose the log.
fn open_stream(path: &Path) -> io::Result<File> {
    OpenOptions::new().append(true).open(path)
}

fn append(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut stream = open_stream(path)?;
    stream.write_all(bytes)?;
    stream.flush()
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
    use std::path::PathBuf;

    use super::*;

    /// Names in a folder, sorted.
    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).unwrap().permissions().mode() & 0o777
    }

    #[test]
    fn a_file_is_replaced_with_its_permissions() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        for permissions in [0o600, 0o640, 0o755, 0o666] {
            fs::write(&path, "old").unwrap();
            fs::set_permissions(&path, fs::Permissions::from_mode(permissions)).unwrap();
            write(&path, b"new").unwrap();
            assert_eq!(fs::read(&path).unwrap(), b"new");
            assert_eq!(mode(&path), permissions);
        }
        // A new file has those any other new file has.
        fs::write(folder.path().join("b"), "").unwrap();
        write(&folder.path().join("c"), b"").unwrap();
        assert_eq!(mode(&folder.path().join("c")), mode(&folder.path().join("b")));
        assert_eq!(names(folder.path()), ["a", "b", "c"]);
    }

    #[test]
    fn a_link_stays_a_link() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("inner")).unwrap();
        fs::write(path("inner/target"), "old").unwrap();
        symlink("inner/target", path("one")).unwrap();
        symlink("one", path("two")).unwrap();
        symlink("inner/absent", path("dangling")).unwrap();
        write(&path("two"), b"new").unwrap();
        write(&path("dangling"), b"made").unwrap();
        assert_eq!(fs::read(path("inner/target")).unwrap(), b"new");
        assert_eq!(fs::read(path("inner/absent")).unwrap(), b"made");
        for link in ["one", "two", "dangling"] {
            assert!(fs::symlink_metadata(path(link)).unwrap().is_symlink(), "{link}");
        }
        symlink("round", path("round")).unwrap();
        let cause = write(&path("round"), b"").unwrap_err().cause;
        assert!(matches!(cause, WriteCause::LinksInCircle), "{cause}");
    }

    /// A new pipe that nobody has open.
    fn pipe(folder: &Path) -> PathBuf {
        let path = folder.join("pipe");
        let made = std::process::Command::new("mkfifo").arg(&path).status().unwrap();
        assert!(made.success());
        path
    }

    #[test]
    fn what_is_no_regular_file_is_refused_at_once() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = pipe(folder.path());
        let socket = folder.path().join("socket");
        let _listener = std::os::unix::net::UnixListener::bind(&socket).unwrap();
        symlink("pipe", folder.path().join("link")).unwrap();
        for (name, kind) in [("pipe", "a pipe"), ("link", "a pipe"), ("socket", "a socket")] {
            let path = folder.path().join(name);
            for error in [write(&path, b"x").unwrap_err(), require_writable(&path).unwrap_err()] {
                assert!(error.to_string().contains(kind), "{error}");
            }
        }
        assert!(fs::metadata(pipe).unwrap().file_type().is_fifo());
        for (path, part) in [("", "folder"), ("nowhere/a", "no folder"), ("new/", "folder")] {
            let path = folder.path().join(path);
            let error = require_writable(&path).unwrap_err();
            assert!(error.to_string().contains(part), "{error}");
            assert_eq!(error.to_string(), write(&path, b"").unwrap_err().to_string());
        }
        assert_eq!(names(folder.path()), ["link", "pipe", "socket"]);
    }

    #[test]
    fn devices_take_what_they_are_given() {
        write(Path::new("/dev/null"), b"nothing").unwrap();
        require_writable(Path::new("/dev/null")).unwrap();
        assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_full_device_is_named() {
        let error = write(Path::new("/dev/full"), b"x").unwrap_err();
        assert_eq!(error.to_string(), "cannot write /dev/full: the disk is full");
    }

    #[test]
    fn asking_changes_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        require_writable(&path).unwrap();
        assert!(names(folder.path()).is_empty());
        fs::write(&path, "old").unwrap();
        let before = fs::metadata(&path).unwrap().modified().unwrap();
        require_writable(&path).unwrap();
        assert_eq!(fs::metadata(&path).unwrap().modified().unwrap(), before);
        assert_eq!(fs::read(&path).unwrap(), b"old");
    }
}
