//! A phenomenon of an open file: the file's own, or one that stands within it.

use phenomenon_compiler::document::{Document, Member, Value};

use super::file::OpenFile;

/// A phenomenon, with those round it.
pub struct Scope<'f> {
    /// The file.
    pub file: &'f OpenFile,
    /// The phenomena, as the file was JSON last, outermost first; none that is not there yet.
    round: Vec<&'f Value>,
    /// How many there are round it, there or not.
    pub depth: usize,
}

impl<'f> Scope<'f> {
    /// The phenomenon that a path of keys leads into, and the rest of the path.
    pub fn of<'p, 'k>(file: &'f OpenFile, path: &'p [&'k str]) -> (Self, &'p [&'k str]) {
        let root = file.document.as_ref().map(|document| &document.root);
        let mut scope = Self { file, round: root.into_iter().collect(), depth: 0 };
        let mut rest = path;
        while let ["phenomena", name, further @ ..] = rest {
            let inner = scope.own().and_then(|of| of.get("phenomena")?.get(name));
            // What is not there has no members, and not those of what is round it.
            scope.round.push(inner.unwrap_or(&NOTHING));
            scope.depth += 1;
            rest = further;
        }
        (scope, rest)
    }

    fn own(&self) -> Option<&'f Value> {
        self.round.last().copied()
    }

    /// The members of a part of it.
    pub fn members(&self, part: &str) -> &'f [Member] {
        self.own().and_then(|of| of.get(part)).map_or(&[], Value::members)
    }

    /// The phenomenon of that name that is known in it.
    pub fn inner(&self, name: &str) -> Option<Document> {
        let document = self.file.document.as_ref()?;
        let known = self.round.iter().rev().find_map(|of| of.get("phenomena")?.get(name));
        Some(Document { root: known?.clone(), ..document.clone() })
    }

    /// The names of the phenomena that are known in it.
    pub fn inner_names(&self) -> Vec<&'f str> {
        let inner = |of: &&'f Value| of.get("phenomena").map_or(&[][..], Value::members);
        self.round.iter().rev().flat_map(inner).map(|member| member.key.as_str()).collect()
    }
}

static NOTHING: Value =
    Value { start: 0, end: 0, kind: phenomenon_compiler::document::ValueKind::Null };
