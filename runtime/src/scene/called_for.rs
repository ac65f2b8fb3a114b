//! What the shaders of a scene call for, joined: the renderer does that and no more.

use phenomenon_compiler::engine::Shade;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{Field, FieldSet, Holder};

/// What the shaders of a scene call for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct CalledFor {
    /// The fields of the state they may read.
    fields: FieldSet,
    /// Whether hits have surface coordinates.
    pub(crate) coordinates: bool,
    /// Whether rays have cones.
    pub(crate) footprints: bool,
}

impl CalledFor {
    /// All there is.
    pub(crate) fn everything() -> Self {
        let all = Field::ALL.iter().copied().collect();
        Self { fields: all, coordinates: true, footprints: true }
    }

    /// Also what a root of a shader calls for.
    pub(crate) fn join(&mut self, shader: &dyn Shade, root: RootKind) {
        self.fields |= shader.fields(root);
        let reads = |fields: &[Field]| fields.iter().any(|field| self.fields.contains(*field));
        use Field::{DpDx, DpDy, DuDx, DuDy, DvDx, DvDy, SecondU, SecondV, U, V};
        // Where there is no second set, the first stands for it.
        self.coordinates = reads(&[U, V, SecondU, SecondV]);
        self.footprints = reads(&[DpDx, DpDy, DuDx, DuDy, DvDx, DvDy]);
    }

    /// Whether anything is asked of objects.
    pub(crate) fn objects(&self) -> bool {
        let of_objects = |field: &&Field| field.holder() == Holder::Object;
        Field::ALL.iter().filter(of_objects).any(|field| self.fields.contains(*field))
    }
}
