//! Pictures in numbered tiles: a name that stands for many files.

use std::io;
use std::path::{Path, PathBuf};

/// A name with `<UDIM>` or `<UVTILE>` in it, which stands for the tiles that are in its folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TilePattern {
    folder: PathBuf,
    before: String,
    after: String,
    numbering: Numbering,
}

/// A tile: its column and its row, both from 0. It fills 1 in both coordinates from there on.
pub type Tile = [u32; 2];

/// How tiles are numbered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Numbering {
    /// 1001 + column + 10 row, ten columns.
    Udim,
    /// `uU_vV`, both from 1.
    Columns,
}

/// Why a set of tiles cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum TilesError {
    /// Its folder cannot be read.
    #[error("the folder `{folder}` of its tiles cannot be read: {error}")]
    Folder {
        /// The folder.
        folder: String,
        /// Why.
        error: io::Error,
    },
    /// There is not one of them.
    #[error("the folder `{folder}` has none of its tiles, such as `{example}`")]
    None {
        /// The folder.
        folder: String,
        /// What the first of them would be called.
        example: String,
    },
}

impl TilePattern {
    /// The set that a path stands for; none where the name of the file has neither `<UDIM>` nor `<UVTILE>`.
    pub fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?;
        let upper = name.to_ascii_uppercase();
        let marks = [("<UDIM>", Numbering::Udim), ("<UVTILE>", Numbering::Columns)];
        let (at, mark, numbering) = marks
            .into_iter()
            .find_map(|(mark, numbering)| upper.find(mark).map(|at| (at, mark, numbering)))?;
        let mut before = name[..at].to_owned();
        // MaterialX has the underscore in the mark, others before it.
        if numbering == Numbering::Columns && !before.ends_with('_') {
            before.push('_');
        }
        let after = name[at + mark.len()..].to_owned();
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        Some(Self { folder, before, after, numbering })
    }

    /// The tile that a file of this name is; none where it is none of the set.
    pub fn tile(&self, name: &str) -> Option<Tile> {
        let number = name.strip_prefix(&*self.before)?.strip_suffix(&*self.after)?;
        match self.numbering {
            Numbering::Udim => {
                let digits = number.len() == 4 && number.bytes().all(|byte| byte.is_ascii_digit());
                let number = number.parse::<u32>().ok().filter(|_| digits)?.checked_sub(1001)?;
                Some([number % 10, number / 10])
            }
            Numbering::Columns => {
                let (column, row) = number.strip_prefix('u')?.split_once("_v")?;
                Some([from_one(column)?, from_one(row)?])
            }
        }
    }

    /// The name of a tile.
    pub fn name(&self, [column, row]: Tile) -> String {
        let number = match self.numbering {
            Numbering::Udim => (1001 + u64::from(column) + 10 * u64::from(row)).to_string(),
            Numbering::Columns => format!("u{}_v{}", u64::from(column) + 1, u64::from(row) + 1),
        };
        format!("{}{number}{}", self.before, self.after)
    }

    /// The tiles on disk with their files, by row and column; at least one.
    ///
    /// # Errors
    /// There are none, or the folder cannot be read.
    pub fn files(&self) -> Result<Vec<(Tile, PathBuf)>, TilesError> {
        let here = match self.folder.as_os_str().is_empty() {
            true => Path::new("."),
            false => &*self.folder,
        };
        let folder = || here.display().to_string();
        let unreadable = |error| TilesError::Folder { folder: folder(), error };
        let mut files = Vec::new();
        for entry in here.read_dir().map_err(unreadable)? {
            let name = entry.map_err(unreadable)?.file_name();
            if let Some(tile) = name.to_str().and_then(|name| self.tile(name)) {
                files.push((tile, self.folder.join(name)));
            }
        }
        if files.is_empty() {
            return Err(TilesError::None { folder: folder(), example: self.name([0, 0]) });
        }
        files.sort_by_key(|&([column, row], _)| (row, column));
        Ok(files)
    }
}

/// A number from 1, as it is written without zeros before it, counted from 0.
fn from_one(digits: &str) -> Option<u32> {
    let plain = digits.bytes().all(|byte| byte.is_ascii_digit()) && !digits.starts_with('0');
    digits.parse::<u32>().ok().filter(|_| plain)?.checked_sub(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pattern(path: &str) -> TilePattern {
        TilePattern::of(Path::new(path)).unwrap()
    }

    #[test]
    fn names_and_tiles_belong_together() {
        let udim = pattern("maps/skin.<UDIM>.png");
        for (tile, name) in [
            ([0, 0], "skin.1001.png"),
            ([9, 0], "skin.1010.png"),
            ([0, 1], "skin.1011.png"),
            ([8, 899], "skin.9999.png"),
        ] {
            assert_eq!((udim.tile(name), udim.name(tile)), (Some(tile), name.to_owned()));
        }
        for other in ["skin.1000.png", "skin.01001.png", "skin.+100.png", "skin.1001.jpg", "1001"] {
            assert_eq!(udim.tile(other), None, "{other}");
        }
        // Files of MaterialX and of Blender.
        for path in ["a<UVTILE>.png", "a_<uvtile>.png"] {
            let columns = pattern(path);
            assert_eq!(columns.name([0, 11]), "a_u1_v12.png");
            assert_eq!(columns.tile("a_u1_v12.png"), Some([0, 11]));
            for other in ["a_u0_v1.png", "a_u01_v1.png", "a_u1_v.png", "a_u1_v9999999999.png"] {
                assert_eq!(columns.tile(other), None, "{other}");
            }
        }
    }

    #[test]
    fn only_names_of_files_are_patterns() {
        for path in ["a.png", "<UDIM>/a.png", "a.<UDI>.png", ""] {
            assert_eq!(TilePattern::of(Path::new(path)), None, "{path}");
        }
    }

    #[test]
    fn the_tiles_that_there_are_stand_in_order() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a.1012.png", "a.1002.png", "a.1011.png", "a.1000.png", "b.1001.png"] {
            std::fs::write(folder.path().join(name), "").unwrap();
        }
        let files = pattern(folder.path().join("a.<udim>.png").to_str().unwrap()).files().unwrap();
        let tiles: Vec<Tile> = files.iter().map(|(tile, _)| *tile).collect();
        assert_eq!(tiles, [[1, 0], [0, 1], [1, 1]]);
        assert_eq!(files[0].1, folder.path().join("a.1002.png"));
    }

    #[test]
    fn what_is_missing_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let none = TilePattern::of(&folder.path().join("a_<UDIM>.exr")).unwrap();
        let error = none.files().unwrap_err().to_string();
        assert!(
            error.contains("`a_1001.exr`") && error.contains(&*folder.path().to_string_lossy())
        );
        let nowhere = TilePattern::of(&folder.path().join("no/a_<UDIM>.exr")).unwrap();
        assert!(nowhere.files().unwrap_err().to_string().contains("cannot be read"));
    }
}
