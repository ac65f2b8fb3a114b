//! Which file a path leads to, however it is spelt.

use std::ffi::OsString;
use std::fs::{self, Metadata};
use std::path::Path;

use super::target::{Target, target};

/// A regular file, or one that could be made. Two paths have equal identities where writing to one
/// changes what the other leads to: through links, hard links, `.` and `..`, and the case of names.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct FileIdentity {
    /// Of the file; of its folder where there is no file yet.
    number: Number,
    /// In that folder.
    name: Option<OsString>,
}

#[cfg(unix)]
type Number = (u64, u64);

#[cfg(not(unix))]
type Number = std::path::PathBuf;

#[cfg(unix)]
fn number(_: &Path, metadata: &Metadata) -> Option<Number> {
    use std::os::unix::fs::MetadataExt;
    Some((metadata.dev(), metadata.ino()))
}

#[cfg(not(unix))]
fn number(path: &Path, _: &Metadata) -> Option<Number> {
    fs::canonicalize(path).ok()
}

impl FileIdentity {
    /// The identity of what is at `path`, or would be. None for devices, pipes and the like, which
    /// hold nothing that could be lost, and where no file is possible.
    pub fn of(path: &Path) -> Option<Self> {
        match fs::metadata(path) {
            Ok(metadata) => {
                let number = number(path, &metadata).filter(|_| metadata.is_file())?;
                Some(Self { number, name: None })
            }
            Err(_) => {
                let Ok(Target::File(path)) = target(path) else { return None };
                let folder = super::target::folder(&path);
                let number = number(folder, &fs::metadata(folder).ok()?)?;
                Some(Self { number, name: Some(path.file_name()?.to_owned()) })
            }
        }
    }
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::symlink;

    use super::*;

    #[test]
    fn spelling_and_links_make_no_other_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::write(path("a"), "a").unwrap();
        fs::write(path("b"), "a").unwrap();
        fs::create_dir(path("folder")).unwrap();
        fs::hard_link(path("a"), path("hard")).unwrap();
        symlink("a", path("soft")).unwrap();
        symlink("absent", path("dangling")).unwrap();
        symlink(".", path("here")).unwrap();
        let of = |name: &str| FileIdentity::of(&path(name));
        let a = of("a");
        assert!(a.is_some());
        for same in ["./a", "folder/../a", "hard", "soft", "here/a", "here/here/soft"] {
            assert_eq!(of(same), a, "{same}");
        }
        assert_ne!(of("b"), a);
        assert_ne!(of("absent"), a);
        for same in ["./absent", "here/absent", "dangling", "here/dangling"] {
            assert_eq!(of(same), of("absent"), "{same}");
            assert!(of(same).is_some());
        }
        assert_ne!(of("absent"), of("other"));
        for none in ["folder", "nowhere/a", ""] {
            assert_eq!(of(none), None, "{none}");
        }
        assert_eq!(FileIdentity::of(Path::new("/dev/null")), None);
    }
}
