//! Names that are the program's own, or were read from a file.

use std::borrow::Borrow;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::ops::Deref;
use std::sync::Arc;

/// The name of a node type, an input or an output. What the program names itself takes no memory; what a
/// file names is shared by all who hold it, and gone with the last of them.
///
/// ```
/// use phenomenon_compiler::values::Name;
///
/// assert_eq!(Name::from("mix"), Name::from(String::from("mix")));
/// assert_eq!(Name::from("mix"), "mix");
/// ```
#[derive(Clone)]
pub struct Name(Kept);

#[derive(Clone)]
enum Kept {
    Static(&'static str),
    Shared(Arc<str>),
}

impl Name {
    /// Its text.
    pub fn as_str(&self) -> &str {
        match &self.0 {
            Kept::Static(text) => text,
            Kept::Shared(text) => text,
        }
    }
}

impl From<&'static str> for Name {
    fn from(text: &'static str) -> Self {
        Self(Kept::Static(text))
    }
}
impl From<Arc<str>> for Name {
    fn from(text: Arc<str>) -> Self {
        Self(Kept::Shared(text))
    }
}
impl From<String> for Name {
    fn from(text: String) -> Self {
        Self(Kept::Shared(text.into()))
    }
}

impl Deref for Name {
    type Target = str;

    fn deref(&self) -> &str {
        self.as_str()
    }
}
/// Maps keyed by names are asked with text.
impl Borrow<str> for Name {
    fn borrow(&self) -> &str {
        self.as_str()
    }
}

impl PartialEq for Name {
    fn eq(&self, other: &Self) -> bool {
        self.as_str() == other.as_str()
    }
}
impl Eq for Name {}
impl PartialEq<str> for Name {
    fn eq(&self, other: &str) -> bool {
        self.as_str() == other
    }
}
impl PartialEq<&str> for Name {
    fn eq(&self, other: &&str) -> bool {
        self.as_str() == *other
    }
}
/// As of the text, which [`Borrow`] asks for.
impl Hash for Name {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.as_str().hash(state);
    }
}

impl fmt::Display for Name {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self.as_str(), formatter)
    }
}
impl fmt::Debug for Name {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self.as_str(), formatter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_from_a_file_is_gone_with_its_last_name() {
        let text: Arc<str> = "read".into();
        let kept = Arc::downgrade(&text);
        let name = Name::from(text);
        let another = name.clone();
        drop(name);
        assert_eq!(kept.upgrade().as_deref(), Some("read"));
        drop(another);
        assert!(kept.upgrade().is_none());
    }
}
