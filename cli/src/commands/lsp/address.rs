//! Addresses of files, as editors give them, and their paths.

use std::path::{Component, Path, PathBuf};

use percent_encoding::percent_decode_str;
use phenomenon_compiler::check::{Files, OnDisk};

use crate::uri;

/// The path of a `file:` address, its escapes undone, whatever bytes they are; another address as it is.
pub fn path_of(uri: &str) -> PathBuf {
    let scheme = uri.get(..5).filter(|scheme| scheme.eq_ignore_ascii_case("file:"));
    let Some(rest) = scheme.and_then(|_| uri.get(5..)) else { return PathBuf::from(uri) };
    let rest = rest.strip_prefix("//").unwrap_or(rest);
    let rest = rest.strip_prefix("localhost").filter(|rest| rest.starts_with('/')).unwrap_or(rest);
    path_of_bytes(percent_decode_str(rest).collect())
}

/// The address of a path.
pub fn uri_of(path: &Path) -> String {
    format!("file://{}", uri::escaped(path.as_os_str().as_encoded_bytes()))
}

#[cfg(unix)]
fn path_of_bytes(bytes: Vec<u8>) -> PathBuf {
    use std::os::unix::ffi::OsStringExt;
    std::ffi::OsString::from_vec(bytes).into()
}

#[cfg(not(unix))]
fn path_of_bytes(bytes: Vec<u8>) -> PathBuf {
    let path = String::from_utf8_lossy(&bytes).into_owned();
    // `/c:/folder`
    let drive = path.strip_prefix('/').filter(|rest| rest.as_bytes().get(1) == Some(&b':'));
    PathBuf::from(drive.unwrap_or(&path))
}

/// The paths a file may be known by: as it is written, and as it is reached through links. A file that does not exist
/// has the latter by its folder, so that it is the same once it does.
pub fn names_of(path: &Path) -> [PathBuf; 2] {
    let plain = without_detours(path);
    let identity = OnDisk.identity(path);
    let reached = match (plain.parent(), plain.file_name()) {
        (Some(folder), Some(name)) if identity == path => OnDisk.identity(folder).join(name),
        _ => identity,
    };
    [plain, reached]
}

/// The path without `.` and `..`, as far as its words go.
fn without_detours(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir if plain.file_name().is_some() => {
                plain.pop();
            }
            other => plain.push(other),
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_become_paths_and_paths_addresses() {
        assert_eq!(path_of("file:///a%20b/%C3%A9.json"), PathBuf::from("/a b/é.json"));
        assert_eq!(path_of("file:///100%"), PathBuf::from("/100%"));
        assert_eq!(path_of("FILE://localhost/a"), PathBuf::from("/a"));
        assert_eq!(path_of("file:/a"), PathBuf::from("/a"));
        for other in ["untitled:1", "", "fil", "é:x", "http://a/b%20c"] {
            assert_eq!(path_of(other), PathBuf::from(other));
        }
        let path = PathBuf::from("/a b/é#?%41:.json");
        assert_eq!(uri_of(&path), "file:///a%20b/%C3%A9%23%3F%2541%3A.json");
        assert_eq!(path_of(&uri_of(&path)), path);
    }

    #[cfg(unix)]
    #[test]
    fn bytes_that_are_no_unicode_are_kept() {
        let path = path_of("file:///caf%E9/%ff.json");
        assert_eq!(path.as_os_str().as_encoded_bytes(), b"/caf\xe9/\xff.json");
        assert_eq!(uri_of(&path), "file:///caf%E9/%FF.json");
    }

    #[test]
    fn a_file_has_the_same_names_before_it_exists() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("in")).unwrap();
        let path = folder.path().join("in/../in/./a.json");
        let before = names_of(&path);
        std::fs::write(&path, "").unwrap();
        assert_eq!(names_of(&path), before);
        assert_eq!(before[0], folder.path().join("in/a.json"));
        assert_eq!(names_of(&before[0]), before);
    }
}
