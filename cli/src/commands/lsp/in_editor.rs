//! Files as the editor has them, or else as they are on disk.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};

use phenomenon_compiler::check::{Files, OnDisk};
use phenomenon_compiler::diagnostics::{Code, Finding};
use phenomenon_compiler::document::{self, Document};
use phenomenon_runtime::scene_file::Assets;

use super::address::names_of;

/// The texts that are open, and what was asked for of them and of the disk.
#[derive(Default)]
pub struct InEditor<'a> {
    /// Texts by every path of their files.
    texts: BTreeMap<PathBuf, &'a str>,
    used: RefCell<HashSet<PathBuf>>,
    /// What is remembered of pictures; without it they are not looked into.
    assets: Option<&'a Assets>,
    /// The folder of the file that is checked, as findings name it, and as it is, where the two differ: names are
    /// Unicode, paths need not be.
    folder: Option<(PathBuf, PathBuf)>,
}

impl<'a> InEditor<'a> {
    /// For the file at `path`, with these texts.
    pub fn new(
        path: &Path,
        texts: impl Iterator<Item = (PathBuf, &'a str)>,
        assets: &'a Assets,
    ) -> Self {
        let real = path.parent().unwrap_or(Path::new("")).to_owned();
        let named = PathBuf::from(real.display().to_string());
        let folder = (named != real).then_some((named, real));
        let (texts, assets) = (texts.collect(), Some(assets));
        Self { texts, used: RefCell::default(), assets, folder }
    }

    /// Every path of the files that were asked for.
    pub fn used(&self) -> HashSet<PathBuf> {
        self.used.borrow().clone()
    }

    /// The path as it is, which is noted as used.
    fn used_path(&self, path: &Path) -> PathBuf {
        let in_folder = self
            .folder
            .as_ref()
            .and_then(|(named, real)| path.strip_prefix(named).ok().map(|rest| real.join(rest)));
        let path = in_folder.unwrap_or_else(|| path.to_owned());
        self.used.borrow_mut().extend(names_of(&path));
        path
    }
}

impl Files for InEditor<'_> {
    fn read(&self, path: &Path) -> Result<Document, Box<Finding>> {
        let real = self.used_path(path);
        match names_of(&real).iter().find_map(|name| self.texts.get(name)) {
            Some(text) => document::read(&path.display().to_string(), text.as_bytes()),
            None => OnDisk.read(&real),
        }
    }

    fn identity(&self, path: &Path) -> PathBuf {
        OnDisk.identity(&self.used_path(path))
    }

    fn unusable(&self, path: &Path) -> Option<String> {
        OnDisk.unusable(&self.used_path(path))
    }

    fn unusable_picture(&self, path: &Path) -> Option<(Code, String)> {
        let path = self.used_path(path);
        match self.assets {
            Some(assets) => {
                let unusable = assets.unusable_picture(&path)?;
                Some((unusable.code, unusable.message))
            }
            None => OnDisk.unusable_picture(&path),
        }
    }
}
