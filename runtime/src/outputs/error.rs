//! Why a file could not be written, and what to do.

use std::fmt;
use std::io::{self, ErrorKind};
use std::path::PathBuf;

/// A file that could not be written; what was there before is untouched.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {path}: {cause}", path = path.display())]
pub struct WriteError {
    /// The file, as it was named.
    pub path: PathBuf,
    /// Why.
    pub cause: WriteCause,
}

/// Why a file could not be written.
#[derive(Debug)]
pub enum WriteCause {
    /// The name is that of a folder.
    IsFolder,
    /// There is no folder for it.
    NoFolder(PathBuf),
    /// There is something that is no regular file, of this kind.
    NotRegular(&'static str),
    /// No temporary file can be made in the folder.
    ClosedFolder(PathBuf, io::Error),
    /// Links lead round in a circle.
    LinksInCircle,
    /// What the system says.
    System(io::Error),
}

impl fmt::Display for WriteCause {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WriteCause::IsFolder => formatter.write_str("this is a folder"),
            WriteCause::NoFolder(folder) => {
                write!(formatter, "there is no folder {}", folder.display())
            }
            WriteCause::NotRegular(kind) => {
                write!(formatter, "this is no ordinary file but {kind}")
            }
            WriteCause::ClosedFolder(folder, error) => {
                let (folder, why) = (folder.display(), said(error));
                write!(formatter, "no file can be made in the folder {folder}: {why}")
            }
            WriteCause::LinksInCircle => formatter.write_str("its links lead round in a circle"),
            WriteCause::System(error) => formatter.write_str(&said(error)),
        }
    }
}

impl WriteCause {
    /// What to do.
    pub fn help(&self) -> &'static str {
        let error = match self {
            WriteCause::IsFolder => return "name a file in it",
            WriteCause::NoFolder(_) => return "make the folder first, or name another",
            WriteCause::NotRegular(_) => return "name a file",
            WriteCause::LinksInCircle => return "remove the links, or name another file",
            WriteCause::ClosedFolder(_, error) | WriteCause::System(error) => error,
        };
        match (self, error.kind()) {
            (_, ErrorKind::StorageFull | ErrorKind::QuotaExceeded) => {
                "free some space, or name a file on another disk"
            }
            (_, ErrorKind::FileTooLarge) => "raise the limit: `ulimit -f unlimited`",
            (_, ErrorKind::ReadOnlyFilesystem) => "name a file on a disk that may be written",
            (_, ErrorKind::InvalidFilename) => "choose a shorter name",
            (WriteCause::ClosedFolder(..), _) => {
                "allow writing in the folder, or name a file in another: files are written beside and renamed"
            }
            _ => "check its permissions, or name another file",
        }
    }
}

/// An error of the system in words a user knows; in the system's own where we have none.
fn said(error: &io::Error) -> String {
    let known = match error.kind() {
        ErrorKind::StorageFull => "the disk is full",
        ErrorKind::QuotaExceeded => "the quota of the disk is used up",
        ErrorKind::FileTooLarge => "the file would pass the file size limit",
        ErrorKind::PermissionDenied => "permission denied",
        ErrorKind::ReadOnlyFilesystem => "the disk is read-only",
        ErrorKind::InvalidFilename => "the name is too long",
        ErrorKind::NotADirectory => "a part of the path is no folder",
        _ => return error.to_string(),
    };
    known.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_disk_is_named_with_what_to_do() {
        let full = WriteCause::System(ErrorKind::StorageFull.into());
        assert_eq!(full.to_string(), "the disk is full");
        assert!(full.help().starts_with("free some space"));
        let folder = WriteCause::ClosedFolder("a".into(), ErrorKind::StorageFull.into());
        assert_eq!(folder.to_string(), "no file can be made in the folder a: the disk is full");
        assert!(folder.help().starts_with("free some space"));
    }
}
