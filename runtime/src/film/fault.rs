//! What can be wrong with a picture, and with its file.

use std::io;
use std::path::{Path, PathBuf};

use super::size::{FILE_BYTES_LIMIT, SizeError};
use crate::outputs::WriteError;

/// Why a picture could not be written or read.
#[derive(Debug, thiserror::Error)]
pub enum FilmError {
    /// The file's ending names no format that is written.
    #[error("{}: the ending must be .png, .exr or .hdr", path.display())]
    UnknownFormat {
        /// The file.
        path: PathBuf,
    },
    /// The file's ending names no format that is read.
    #[error("{}: the ending must be .png, .jpg, .exr or .hdr", path.display())]
    NoPicture {
        /// The file.
        path: PathBuf,
    },
    /// It cannot be written.
    #[error(transparent)]
    Unwritable(#[from] WriteError),
    /// It cannot be read.
    #[error("cannot read {path}: {source}", path = path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// It has more bytes than any picture within the limits needs.
    #[error("{path} has {bytes} bytes; of a picture at most {FILE_BYTES_LIMIT} are read", path = path.display())]
    TooManyBytes {
        /// The file.
        path: PathBuf,
        /// How many it has.
        bytes: u64,
    },
    /// It is not a picture of its format, or one of a kind that is not read.
    #[error("{path} is not a usable picture: {message}", path = path.display())]
    Malformed {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        message: String,
    },
    /// Its size is not possible, or not with this little memory.
    #[error("{path}: {source}", path = path.display())]
    Size {
        /// The file.
        path: PathBuf,
        /// Which size.
        source: SizeError,
    },
}

impl FilmError {
    /// What to do about it.
    pub fn help(&self) -> &'static str {
        match self {
            FilmError::UnknownFormat { .. } => "end the name in .png, .exr or .hdr",
            FilmError::NoPicture { .. } => "give a .png, .jpg, .exr or .hdr picture",
            FilmError::Unwritable(error) => error.cause.help(),
            FilmError::Unreadable { .. } => "check its name and its permissions",
            FilmError::TooManyBytes { .. } => "give a smaller picture",
            FilmError::Malformed { .. } => "write it again, or give another picture",
            FilmError::Size { source: SizeError::Limit { .. }, .. } => "scale it down",
            FilmError::Size { source: SizeError::Memory { .. }, .. } => {
                "scale it down, or let the program have more memory"
            }
        }
    }
}

/// Why bytes are no usable picture.
#[derive(Debug)]
pub(super) enum Fault {
    /// The system cannot read them, or hold more of them.
    System(io::Error),
    /// They are not what the format asks for, or of a kind that is not read.
    Malformed(String),
    /// Their picture is too large.
    Size(SizeError),
}

impl Fault {
    pub(super) fn malformed(message: impl Into<String>) -> Self {
        Fault::Malformed(message.into())
    }

    /// Of a file.
    pub(super) fn of(self, path: &Path) -> FilmError {
        let path = path.to_owned();
        match self {
            Fault::System(source) => FilmError::Unreadable { path, source },
            Fault::Malformed(message) => FilmError::Malformed { path, message },
            Fault::Size(source) => FilmError::Size { path, source },
        }
    }
}

impl From<io::Error> for Fault {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::UnexpectedEof => Fault::malformed("the file ends too early"),
            _ => Fault::System(error),
        }
    }
}

impl From<SizeError> for Fault {
    fn from(error: SizeError) -> Self {
        Fault::Size(error)
    }
}
