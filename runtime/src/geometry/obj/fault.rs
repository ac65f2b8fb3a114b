//! What may be wrong with an OBJ file.

use std::path::PathBuf;

use crate::geometry::limits::OBJ_BYTES_LIMIT;
use crate::geometry::mesh::MeshError;
use crate::geometry::polygon::CONCAVE_CORNERS_LIMIT;

/// Why an OBJ file could not be used.
#[derive(Debug, thiserror::Error)]
pub enum ObjError {
    /// It could not be opened or is no file.
    #[error("cannot read {path}: {source}", path = path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// It is too large.
    #[error("{path} has {bytes} bytes; the limit is {OBJ_BYTES_LIMIT}", path = path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// Its size.
        bytes: u64,
    },
    /// What it holds is not usable.
    #[error("{path}{at}: {fault}", path = path.display(), at = after_colon(*line))]
    Malformed {
        /// The file.
        path: PathBuf,
        /// The line, from 1; none where it is the whole file.
        line: Option<usize>,
        /// What is wrong.
        fault: ObjFault,
    },
}

fn after_colon(line: Option<usize>) -> String {
    line.map_or(String::new(), |line| format!(":{line}"))
}

/// What is wrong in a line of an OBJ file, or with all of it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ObjFault {
    /// A word should be a number.
    #[error("`{0}` is no number")]
    NotANumber(String),
    /// A number is infinite, not a number, or past what 32 bits hold.
    #[error("`{0}` is no finite number of 32 bits")]
    NotFinite(String),
    /// A coordinate is too far out.
    #[error("the coordinate `{0}` is past the limit of 1e12")]
    TooFar(String),
    /// A statement has too few numbers.
    #[error("`{keyword}` needs {least} numbers and has {count}")]
    TooFewNumbers {
        /// The statement.
        keyword: &'static str,
        /// How many it needs.
        least: usize,
        /// How many there are.
        count: usize,
    },
    /// A face has no area whatever its corners are.
    #[error("a face needs 3 corners and has {0}")]
    TooFewCorners(usize),
    /// A corner is not what a face has.
    #[error("`{0}` is no corner: it is written as 1, 1/2, 1//3 or 1/2/3")]
    NotACorner(String),
    /// An index is 0.
    #[error("`{0}` has the index 0: the first is 1, the last -1")]
    IndexZero(String),
    /// An index names nothing.
    #[error("`{word}` names a {what} that does not exist: there are {count}")]
    IndexOutOfRange {
        /// The corner.
        word: String,
        /// What is named.
        what: &'static str,
        /// How many there are; for a negative index, so far.
        count: usize,
    },
    /// A face that is no fan has too many corners.
    #[error(
        "a concave face of {0} corners; the limit is {CONCAVE_CORNERS_LIMIT}: cut it into smaller ones"
    )]
    TooManyCorners(usize),
    /// A surface that is not made of faces.
    #[error("`{0}` is not read: save curved surfaces, and what other files hold, as polygons")]
    NotRead(String),
    /// The file is in an encoding of two bytes a character.
    #[error("the file is UTF-16: save it as UTF-8 or ASCII")]
    Utf16,
    /// There is no face, and a line that belongs to no OBJ file.
    #[error("`{0}` starts no statement of an OBJ file, and there is no face in it")]
    NoStatement(String),
    /// No triangle has an area.
    #[error("no triangle of it has an area ({0} without)")]
    NothingLeft(usize),
    /// The mesh is not usable.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

impl ObjFault {
    /// A word as it is shown: not too long, and without control characters.
    pub(super) fn shown(word: &[u8]) -> String {
        const MOST: usize = 40;
        let text = String::from_utf8_lossy(&word[..word.len().min(4 * MOST)]);
        let mut shown: String = text.chars().take(MOST).flat_map(char::escape_debug).collect();
        if text.chars().nth(MOST).is_some() {
            shown.push('…');
        }
        shown
    }
}
