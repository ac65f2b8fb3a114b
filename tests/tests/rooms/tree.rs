//! The modules of a crate, from its files.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::paths::Named;

/// A module in a file of its own.
#[derive(Debug)]
pub struct Module {
    /// The file, from `src` on.
    pub file: String,
    /// The path of the module.
    pub path: Vec<String>,
    /// Paths it names.
    pub paths: Vec<Vec<String>>,
    /// What its imports call things.
    names: BTreeMap<String, Vec<String>>,
}

#[derive(Debug)]
pub struct Tree {
    modules: BTreeMap<Vec<String>, Module>,
}

/// The room of a file: its folder under `src`, or a file there without one; none for the roots of crates.
pub fn room(file: &str) -> Option<&str> {
    let room = file.split('/').next().unwrap_or(file);
    (!matches!(room, "lib.rs" | "main.rs")).then(|| room.trim_end_matches(".rs"))
}

impl Tree {
    /// Reads every file below `src` that is not compiled for tests alone.
    pub fn read(src: &Path) -> Self {
        let mut modules = BTreeMap::new();
        let mut folders = vec![src.to_owned()];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(&folder).expect("a folder of the crate") {
                let path = entry.expect("an entry").path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|extension| extension == "rs") {
                    let file = path.strip_prefix(src).unwrap().to_str().unwrap().to_owned();
                    let text = std::fs::read_to_string(&path).expect("a source file");
                    let module = Module::new(file, &text);
                    modules.insert(module.path.clone(), module);
                }
            }
        }
        let of_tests = of_tests_alone(src, &modules);
        modules.retain(|path, _| !of_tests.iter().any(|of| path.starts_with(of)));
        Self { modules }
    }

    pub fn modules(&self) -> impl Iterator<Item = &Module> {
        self.modules.values()
    }

    /// The rooms there are.
    pub fn rooms(&self) -> impl Iterator<Item = &str> {
        self.modules.values().filter_map(|module| room(&module.file))
    }

    /// The module that defines what `path` names in `from`; none outside of this crate.
    pub fn resolve(&self, from: &Module, path: &[String]) -> Option<&Module> {
        self.follow(from, path, 0)
    }

    fn follow(&self, from: &Module, path: &[String], depth: usize) -> Option<&Module> {
        assert!(depth < 16, "names of {path:?} lead in a circle");
        let (mut at, mut rest) = match path.first().map(String::as_str)? {
            "crate" => (Vec::new(), &path[1..]),
            "self" => (from.path.clone(), &path[1..]),
            "super" => (from.path.clone(), path),
            // A module of this one, or another crate.
            first => {
                let child = [from.path.as_slice(), &[first.to_owned()]].concat();
                self.modules.get(&child)?;
                (from.path.clone(), path)
            }
        };
        while rest.first().is_some_and(|segment| segment == "super") {
            at.pop();
            rest = &rest[1..];
        }
        self.descend(at, rest, depth)
    }

    /// Goes down from a module along names: modules in it, or what its imports lend it.
    fn descend(&self, mut at: Vec<String>, names: &[String], depth: usize) -> Option<&Module> {
        for (position, name) in names.iter().enumerate() {
            at.push(name.clone());
            if self.modules.contains_key(&at) {
                continue;
            }
            at.pop();
            let module = self.modules.get(&at)?;
            return match module.names.get(name) {
                Some(path) => {
                    let path = [path.as_slice(), &names[position + 1..]].concat();
                    self.follow(module, &path, depth + 1)
                }
                None => Some(module),
            };
        }
        self.modules.get(&at)
    }
}

impl Module {
    fn new(file: String, text: &str) -> Self {
        let mut path: Vec<String> =
            file.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
        if matches!(path.last().map(String::as_str), Some("mod" | "lib" | "main")) {
            path.pop();
        }
        let Named { paths, names } = Named::of(text);
        let names =
            names.into_iter().filter(|(name, path)| path.first() != Some(name) || path.len() > 1);
        Self { file, path, paths, names: names.collect() }
    }
}

/// Modules declared under `#[cfg(test)]`.
fn of_tests_alone(src: &Path, modules: &BTreeMap<Vec<String>, Module>) -> BTreeSet<Vec<String>> {
    let mut found = BTreeSet::new();
    for module in modules.values() {
        let text = std::fs::read_to_string(src.join(&module.file)).expect("it was read before");
        let mut is_test = false;
        for line in text.lines().map(str::trim) {
            match line.split_once("mod ") {
                Some((_, name)) if is_test && name.ends_with(';') => {
                    let name = name.trim_end_matches(';').to_owned();
                    found.insert([module.path.as_slice(), &[name]].concat());
                }
                _ => {}
            }
            is_test = line == "#[cfg(test)]" || is_test && line.starts_with("#[");
        }
    }
    found
}
