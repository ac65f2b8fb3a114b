//! Epochs: the stretches of time over which a node has one value.

use cranelift_entity::PrimaryMap;

use super::keys::{PATH_KEY, path_key};
use super::{EpochId, InstanceId, LightListId};
use crate::state::{Field, FieldSet, Iterated};
use crate::storage::Source;

/// Most names of a path that are shown.
const SHOWN_NAMES: usize = 8;

/// What opened an epoch.
#[derive(Clone, Debug, PartialEq)]
pub enum EpochKind {
    /// The point itself.
    Point,
    /// A scope: these fields have other words inside, computed by an instance outside (none if the
    /// words are uniform).
    Scope {
        /// Which computes the words.
        enter: Option<InstanceId>,
        /// The words of each field.
        fields: Vec<(Field, Vec<Source>)>,
    },
    /// A loop; each turn is a new pass through the epoch.
    Loop {
        /// What it runs over.
        iterated: Iterated,
        /// First of the slots of the fields a turn provides.
        fields: u32,
        /// Position of the light list, of a loop over lights.
        list: Option<LightListId>,
    },
}

/// An epoch.
#[derive(Clone, Debug)]
pub struct Epoch {
    /// The one outside; of the outermost, itself.
    pub parent: EpochId,
    /// Fields that differ from outside.
    pub changes: FieldSet,
    /// What opened it.
    pub kind: EpochKind,
    /// Name of the scope or loop.
    pub name: String,
    /// Hash of the names down to here, each followed by `/`. Whole paths are not kept: those of a
    /// nest take the square of its depth in memory.
    pub path_key: u64,
    /// Loop epochs down to here, this one included, outermost first.
    pub loops: Vec<EpochId>,
}

/// The tree of epochs; the first is the point itself.
#[derive(Clone, Debug)]
pub struct Epochs(pub PrimaryMap<EpochId, Epoch>);

impl Epochs {
    /// Only the point itself.
    pub fn new() -> Self {
        let point = Epoch {
            parent: EpochId::POINT,
            changes: FieldSet::NONE,
            kind: EpochKind::Point,
            name: String::new(),
            path_key: PATH_KEY,
            loops: Vec::new(),
        };
        Self(PrimaryMap::from_iter([point]))
    }

    /// Opens an epoch inside `parent`.
    pub fn open(
        &mut self,
        parent: EpochId,
        name: &str,
        changes: FieldSet,
        kind: EpochKind,
    ) -> EpochId {
        let id = self.0.next_key();
        let outer = &self.0[parent];
        let mut loops = outer.loops.clone();
        if matches!(kind, EpochKind::Loop { .. }) {
            loops.push(id);
        }
        let path_key = path_key(path_key(outer.path_key, name), "/");
        let name = name.to_owned();
        self.0.push(Epoch { parent, changes, kind, name, path_key, loops })
    }

    /// The names of scopes and loops down to `epoch`, each followed by `/`; of a deep nest the
    /// innermost only.
    pub fn path(&self, mut epoch: EpochId) -> String {
        let mut names = Vec::new();
        while epoch != EpochId::POINT && names.len() < SHOWN_NAMES {
            names.push(self.0[epoch].name.as_str());
            epoch = self.0[epoch].parent;
        }
        let mut path = if epoch == EpochId::POINT { String::new() } else { "…/".to_owned() };
        for name in names.iter().rev() {
            path.push_str(name);
            path.push('/');
        }
        path
    }

    /// The outermost epoch in which something that reads `fields` has the value it has in `epoch`.
    pub fn effective(&self, mut epoch: EpochId, fields: FieldSet) -> EpochId {
        while epoch != EpochId::POINT && !self.0[epoch].changes.meets(fields) {
            epoch = self.0[epoch].parent;
        }
        epoch
    }

    /// Where a field has its words in `epoch`: the nearest epoch outwards that changes it.
    pub fn changed_in(&self, mut epoch: EpochId, field: Field) -> Option<EpochId> {
        while epoch != EpochId::POINT {
            if self.0[epoch].changes.contains(field) {
                return Some(epoch);
            }
            epoch = self.0[epoch].parent;
        }
        None
    }

    /// The innermost loop round `epoch`, itself included.
    pub fn innermost_loop(&self, epoch: EpochId) -> Option<EpochId> {
        self.0[epoch].loops.last().copied()
    }

    /// The innermost loop over lights round `epoch`, itself included, and the position of its list.
    pub fn innermost_lights(&self, epoch: EpochId) -> Option<(EpochId, LightListId)> {
        self.0[epoch].loops.iter().rev().find_map(|&of| match self.0[of].kind {
            EpochKind::Loop { list, .. } => list.map(|list| (of, list)),
            EpochKind::Point | EpochKind::Scope { .. } => None,
        })
    }

    /// Whether `inner` is `outer` or lies within it.
    pub fn within(&self, mut inner: EpochId, outer: EpochId) -> bool {
        loop {
            if inner == outer {
                return true;
            }
            if inner == EpochId::POINT {
                return false;
            }
            inner = self.0[inner].parent;
        }
    }
}

impl Default for Epochs {
    fn default() -> Self {
        Self::new()
    }
}
