//! What commands read: files, folders of them, and standard input.

use std::collections::HashSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use phenomenon_compiler::check::{Files, OnDisk};
use phenomenon_compiler::diagnostics::{Code, Finding, Place, SourceFile, listed};
use phenomenon_compiler::document::{Document, read_file, read_from};
use phenomenon_runtime::outputs::is_descriptor;

use crate::failure::Failure;
use crate::ours::Ours;

/// Whether a path stands for standard input.
pub fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// Whether a path stands for something the program was started with, which is no file to write anew.
pub fn is_stream(path: &Path) -> bool {
    is_standard_input(path) || is_descriptor(path)
}

/// The folder where paths in a file start: that of the file, the current one for standard input.
pub fn folder(path: &Path) -> &Path {
    if is_stream(path) { Path::new("") } else { path.parent().unwrap_or(Path::new("")) }
}

/// Reads a graph or a scene from a file, from standard input for `-`, or from what the program was
/// started with, such as `/dev/stdin` or `<(…)`.
///
/// # Errors
/// One finding: it cannot be read, or is not JSON.
pub fn read(path: &Path) -> Result<Document, Box<Finding>> {
    let name = path.display().to_string();
    if is_standard_input(path) {
        static READ: AtomicBool = AtomicBool::new(false);
        if READ.swap(true, Ordering::Relaxed) {
            let message = "standard input is read already";
            return Err(unreadable(&name, message.into(), "give `-` once"));
        }
        return read_from(&name, io::stdin().lock());
    }
    // A pipe the program was started with is written to by somebody; one with a name may not be.
    if is_descriptor(path) && !fs::metadata(path).is_ok_and(|metadata| metadata.is_file()) {
        let help = "pipe it to the program, and write `-`";
        return match fs::File::open(path) {
            Ok(file) => read_from(&name, file),
            Err(error) => Err(unreadable(&name, format!("cannot read `{name}`: {error}"), help)),
        };
    }
    read_file(path)
}

fn unreadable(name: &str, message: String, help: &str) -> Box<Finding> {
    let file = SourceFile::new(name, "").into();
    let place = Place { file, start: 0, end: 0, path: String::new() };
    Box::new(Finding::new(Code::UNREADABLE_FILE, place, message, help))
}

/// A file to look at.
#[derive(Clone, Debug)]
pub struct Input {
    /// Where it is.
    pub path: PathBuf,
    /// Met in a folder, so that a JSON file of another kind is passed over.
    pub in_folder: bool,
}

/// The files of paths.
#[derive(Debug, Default)]
pub struct Found {
    /// The files, those of folders sorted by name.
    pub inputs: Vec<Input>,
    /// Folders that cannot be read.
    pub failures: Vec<Failure>,
}

impl Found {
    /// Leaves out what is the same file as one before it, however it is spelt.
    pub fn once(mut self) -> Self {
        let mut known = HashSet::new();
        // Standard input has no second reading: that is said where it is asked for.
        self.inputs
            .retain(|input| is_stream(&input.path) || known.insert(OnDisk.identity(&input.path)));
        self
    }
}

/// The files of `paths`. Of a folder these are the regular files in it, at any depth, whose names end
/// in `.json`; what is hidden is left out, and so are pipes, devices, links that lead nowhere, and
/// folders reached through links: a link may lead back to where it stands.
pub fn find(paths: &[PathBuf]) -> Found {
    let mut found = Found::default();
    for path in paths {
        if is_standard_input(path) || !path.is_dir() {
            found.inputs.push(Input { path: path.clone(), in_folder: false });
            continue;
        }
        let mut files = Vec::new();
        let mut pending = vec![path.clone()];
        while let Some(folder) = pending.pop() {
            if let Err(error) = search(&folder, &mut files, &mut pending) {
                let message = format!("cannot read the folder `{}`: {error}", folder.display());
                found.failures.push(Failure::new(message, "check its permissions"));
            }
        }
        files.sort();
        found.inputs.extend(files.into_iter().map(|path| Input { path, in_folder: true }));
    }
    found
}

fn search(
    folder: &Path,
    files: &mut Vec<PathBuf>,
    folders: &mut Vec<PathBuf>,
) -> Result<(), io::Error> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_name().to_string_lossy().starts_with('.') {
            continue;
        }
        let path = entry.path();
        let kind = entry.file_type()?;
        if kind.is_dir() {
            folders.push(path);
        } else if path.extension().is_some_and(|extension| extension == "json")
            && (kind.is_file() || kind.is_symlink() && leads_to_file(&path))
        {
            files.push(path);
        }
    }
    Ok(())
}

/// Whether a link leads to a regular file, as far as can be told: what may not be looked at is no
/// reason to say nothing of it.
fn leads_to_file(link: &Path) -> bool {
    match fs::metadata(link) {
        Ok(metadata) => metadata.is_file(),
        Err(error) => error.kind() == io::ErrorKind::PermissionDenied,
    }
}

/// Whether a file met in a folder is a graph or a scene.
pub fn is_ours(document: &Document) -> bool {
    Ours::of(document).is_some()
}

/// Whether a file met in a folder that is no JSON was not meant for us: it does not have the
/// keys that graphs and scenes have. Others allow comments in theirs.
pub fn is_foreign_text(finding: &Finding) -> bool {
    let text = &finding.place.file.text;
    !text.is_empty() && Ours::of_text(text).is_none()
}

/// The failure where folders hold nothing to do something with: it is a mistake in how the program
/// was called, which would pass for ever.
pub fn nothing_in(paths: &[PathBuf], what: &str) -> Failure {
    let names: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
    let names = listed(names.iter().map(String::as_str));
    let message = format!("there is nothing to {what}: no graph or scene in {names}");
    Failure::new(message, "name a file, or a folder with files ending in .json")
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::symlink;

    use super::*;

    #[test]
    fn folders_hold_files_and_nothing_to_wait_for() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        for name in ["b.json", "a.json", ".hidden.json", "c.txt"] {
            fs::write(path(name), "{}").unwrap();
        }
        fs::create_dir_all(path("inner/.git")).unwrap();
        fs::create_dir(path("folder.json")).unwrap();
        fs::write(path("inner/d.json"), "{}").unwrap();
        fs::write(path("inner/.git/e.json"), "{}").unwrap();
        let links =
            [("c.txt", "text.json"), ("absent", "dangling.json"), ("loop.json", "loop.json")];
        for (to, link) in [("..", "inner/up"), ("..", "inner/up.json"), ("/dev/zero", "zero.json")]
            .into_iter()
            .chain(links)
        {
            symlink(to, path(link)).unwrap();
        }
        let made = std::process::Command::new("mkfifo").arg(path("pipe.json")).status().unwrap();
        assert!(made.success());
        symlink("pipe.json", path("linked_pipe.json")).unwrap();
        let found = find(&[folder.path().to_owned(), path("inner"), path("pipe.json")]);
        assert!(found.failures.is_empty());
        let names: Vec<_> = found
            .inputs
            .iter()
            .map(|input| (input.path.strip_prefix(folder.path()).unwrap(), input.in_folder))
            .map(|(path, in_folder)| (path.to_str().unwrap(), in_folder))
            .collect();
        let expected = [
            ("a.json", true),
            ("b.json", true),
            ("inner/d.json", true),
            ("text.json", true),
            ("inner/d.json", true),
            ("pipe.json", false),
        ];
        assert_eq!(names, expected);
        assert_eq!(found.once().inputs.len(), 5);
    }
}
