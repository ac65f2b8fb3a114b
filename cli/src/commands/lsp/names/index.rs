//! The names of a file.

use std::ops::Range;

/// What has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NameKind {
    /// A parameter of a phenomenon.
    Parameter,
    /// A node.
    Node,
    /// A phenomenon within the file.
    Phenomenon,
    /// An output of a phenomenon.
    Output,
    /// A preset of parameters.
    Preset,
    /// A name that `where` binds in an expression.
    Bound,
    /// A light of a scene.
    Light,
}

/// A name where it is given.
#[derive(Clone, Debug)]
pub struct Name {
    /// What has it.
    pub kind: NameKind,
    /// The scope it holds in: see [`Index::scopes`].
    pub scope: usize,
    /// The name.
    pub name: String,
    /// The bytes of the name, without quotes.
    pub place: Range<usize>,
}

/// A name where it is used.
#[derive(Clone, Debug)]
pub struct Use {
    /// What it is the name of.
    pub kind: NameKind,
    /// The scope it is used in.
    pub scope: usize,
    /// The name.
    pub name: String,
    /// The bytes of the name, without quotes.
    pub place: Range<usize>,
    /// Whether it stands in the text of an expression.
    pub in_expression: bool,
}

/// The names of a file: of all its scopes, the file itself, the phenomena within it, and in expressions what stands
/// behind each name that `where` binds.
#[derive(Debug, Default)]
pub struct Index {
    /// Of each scope the one round it; the first is the file's.
    pub scopes: Vec<Option<usize>>,
    /// Where names are given, in the order of the file.
    pub names: Vec<Name>,
    /// Where they are used, in the order of the file.
    pub uses: Vec<Use>,
}

impl Index {
    /// The name under a byte, or the one that is used there: where it is given.
    pub fn name_at(&self, at: usize) -> Option<&Name> {
        let given = self.names.iter().find(|name| touches(&name.place, at));
        given.or_else(|| self.given(self.uses.iter().find(|used| touches(&used.place, at))?))
    }

    /// The bytes of the name under a byte, given or used there.
    pub fn place_at(&self, at: usize) -> Option<Range<usize>> {
        let places = self.names.iter().map(|name| &name.place);
        let mut places = places.chain(self.uses.iter().map(|used| &used.place));
        places.find(|place| touches(place, at)).cloned()
    }

    /// Where a name is given that is used: in the scope itself or, of phenomena, round it.
    pub fn given(&self, used: &Use) -> Option<&Name> {
        let mut scope = Some(used.scope);
        while let Some(at) = scope {
            let is_it =
                |name: &&Name| name.scope == at && name.kind == used.kind && name.name == used.name;
            if let Some(name) = self.names.iter().find(is_it) {
                return Some(name);
            }
            scope = match used.kind {
                NameKind::Phenomenon | NameKind::Bound => self.scopes[at],
                _ => None,
            };
        }
        None
    }

    /// Where a name is used, in the order of the file.
    pub fn uses_of<'i>(&'i self, name: &'i Name) -> impl Iterator<Item = &'i Use> {
        self.uses.iter().filter(move |used| {
            used.name == name.name
                && self.given(used).is_some_and(|given| given.place == name.place)
        })
    }
}

/// Whether a cursor before the byte touches the place.
fn touches(place: &Range<usize>, at: usize) -> bool {
    place.start <= at && at <= place.end
}
