//! The pictures and meshes that scenes name, and what is remembered of them by whoever checks the same scenes time and
//! again.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::hash::Hash;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use phenomenon_compiler::diagnostics::Code;

use super::mesh_file::{MeshRefusal, ReadMesh, read_mesh};
use crate::film::{self, Film, FilmError};
use crate::geometry::Normals;

/// Most files of which something is remembered; past them all is forgotten.
const REMEMBERED_FILES: usize = 4096;

/// Where the pictures and meshes of scenes come from. By default they are read whenever a scene names them.
#[derive(Debug, Default)]
pub struct Assets {
    /// None where nothing is remembered.
    known: Option<Known>,
    reads: Cell<usize>,
}

/// What is remembered of files, by their one paths.
#[derive(Debug, Default)]
struct Known {
    /// Whether a picture can be used, and if not, why.
    pictures: Remembered<PathBuf, Result<(), Unusable>>,
    /// Columns and rows of a picture; none where its header cannot be read.
    sizes: Remembered<PathBuf, Option<[u32; 2]>>,
    /// The box round a mesh, or why it cannot be used.
    meshes: Remembered<(PathBuf, Normals), Result<ReadMesh, MeshRefusal>>,
}

type Remembered<K, T> = RefCell<HashMap<K, (Stamp, T)>>;

/// Why a file that a scene names cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unusable {
    /// The code of the finding.
    pub code: Code,
    /// What is wrong, with the name of the file.
    pub message: String,
}

/// What tells a file from the same one after it was written again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Stamp {
    bytes: u64,
    modified: Option<SystemTime>,
}

impl Stamp {
    fn of(path: &Path) -> Option<Self> {
        let metadata = std::fs::metadata(path).ok()?;
        Some(Self { bytes: metadata.len(), modified: metadata.modified().ok() })
    }
}

impl Assets {
    /// Remembers of each file whether it can be used, as long as its size and time stay the same, but not what is in
    /// it: a scene read with it is for its findings only, for its pictures are black and its meshes are boxes.
    pub fn remembered() -> Self {
        Self { known: Some(Known::default()), reads: Cell::default() }
    }

    /// How many files were read.
    pub fn reads(&self) -> usize {
        self.reads.get()
    }

    /// Forgets what is remembered of a file.
    pub fn forget(&self, path: &Path) {
        if let Some(known) = &self.known {
            let path = reached(path);
            known.pictures.borrow_mut().remove(&path);
            known.sizes.borrow_mut().remove(&path);
            known.meshes.borrow_mut().retain(|(known, _), _| *known != path);
        }
    }

    /// Why a picture cannot be used; none where it can.
    pub fn unusable_picture(&self, path: &Path) -> Option<Unusable> {
        self.picture(path).err()
    }

    /// Columns and rows of a picture; none where its header cannot be read. Nothing but the header is.
    pub fn size(&self, path: &Path) -> Option<[u32; 2]> {
        let read = || {
            let header = film::read_header(path).ok()?;
            Some([header.width, header.height])
        };
        let (Some(known), Some(stamp)) = (&self.known, Stamp::of(path)) else { return read() };
        remembered(&known.sizes, reached(path), stamp, read)
    }

    /// A picture; a black one of one pixel where only its outcome is remembered.
    pub(super) fn picture(&self, path: &Path) -> Result<Film, Unusable> {
        let read = || {
            self.reads.set(self.reads.get() + 1);
            film::read(path).map_err(|error| Unusable::from(&error))
        };
        let (Some(known), Some(stamp)) = (&self.known, Stamp::of(path)) else { return read() };
        let outcome = remembered(&known.pictures, reached(path), stamp, || read().map(drop));
        outcome.and_then(|()| black())
    }

    /// A mesh; the box round it where only its outcome is remembered.
    pub(super) fn mesh(&self, path: &Path, normals: Normals) -> Result<ReadMesh, MeshRefusal> {
        let read = || {
            self.reads.set(self.reads.get() + 1);
            read_mesh(path, normals)
        };
        let (Some(known), Some(stamp)) = (&self.known, Stamp::of(path)) else { return read() };
        let boxed = || read().map(ReadMesh::boxed);
        remembered(&known.meshes, (reached(path), normals), stamp, boxed)
    }
}

/// What is remembered under a key since the file has that stamp, or what is read now.
fn remembered<K: Eq + Hash, T: Clone>(
    known: &Remembered<K, T>,
    key: K,
    stamp: Stamp,
    read: impl FnOnce() -> T,
) -> T {
    if let Some((before, outcome)) = known.borrow().get(&key)
        && *before == stamp
    {
        return outcome.clone();
    }
    let outcome = read();
    let mut known = known.borrow_mut();
    if known.len() >= REMEMBERED_FILES {
        known.clear();
    }
    known.insert(key, (stamp, outcome.clone()));
    outcome
}

/// The one path of a file, however it is named.
fn reached(path: &Path) -> PathBuf {
    std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned())
}

fn black() -> Result<Film, Unusable> {
    Film::new(1, 1)
        .map_err(|error| Unusable { code: Code::UNUSABLE_FILE, message: error.to_string() })
}

impl From<&FilmError> for Unusable {
    fn from(error: &FilmError) -> Self {
        let code = match error {
            FilmError::Unreadable { .. } => Code::UNREADABLE_FILE,
            FilmError::TooManyBytes { .. } => Code::FILE_TOO_LARGE,
            _ => Code::UNUSABLE_FILE,
        };
        Self { code, message: error.to_string() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_again_once_it_has_changed() {
        let folder = tempfile::tempdir().unwrap();
        let (path, absent) = (folder.path().join("a.hdr"), folder.path().join("absent.hdr"));
        film::write(&Film::new(4, 2).unwrap(), &path, 1.0).unwrap();
        let assets = Assets::remembered();
        for _ in 0..3 {
            assert_eq!(assets.picture(&path).map(|film| film.width()), Ok(1));
        }
        assert_eq!(assets.reads(), 1);
        std::fs::write(&path, "no picture at all").unwrap();
        for _ in 0..3 {
            assert_eq!(assets.unusable_picture(&path).unwrap().code, Code::UNUSABLE_FILE);
        }
        assert_eq!(assets.reads(), 2);
        assets.forget(&path);
        assert!(assets.unusable_picture(&path).is_some());
        assert_eq!(assets.reads(), 3);
        // What is not there may come.
        assert_eq!(assets.unusable_picture(&absent).unwrap().code, Code::UNREADABLE_FILE);
        film::write(&Film::new(4, 2).unwrap(), &absent, 1.0).unwrap();
        assert_eq!(assets.unusable_picture(&absent), None);
    }

    #[test]
    fn by_default_nothing_is_remembered() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.hdr");
        film::write(&Film::new(4, 2).unwrap(), &path, 1.0).unwrap();
        let assets = Assets::default();
        assert_eq!(assets.picture(&path).map(|film| film.width()), Ok(4));
        assert_eq!(assets.picture(&path).map(|film| film.width()), Ok(4));
        assert_eq!(assets.reads(), 2);
    }
}
