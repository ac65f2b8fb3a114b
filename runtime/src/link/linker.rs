//! Scenes with their graphs compiled, ready to be rendered.

use std::collections::HashMap;
use std::sync::Arc;

use phenomenon_compiler::engine::Shader;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::specialise::Asking;

use super::by_hand::ByHand;
use super::changes::Changes;
use super::error::LinkError;
use super::materials::{Materials, Remark, ShaderUse, Shading, Subject};
use crate::scene::{Scene, SceneError};
use crate::scene_file::{BuildError, LightNames, MaterialSource, SceneDescription};

/// What a scene is linked with.
pub struct Linker<'a> {
    /// The node types that graphs are made of.
    pub library: &'a NodeLibrary,
    /// What runs graphs.
    pub shading: Shading,
    /// The graph that is looked at, if there is one. Its idle roots were told of by whoever read it.
    pub subject: Option<&'a Subject>,
    /// What is changed about the graphs that the scene uses.
    pub changes: &'a Changes,
    /// Whether the scene is the one built into the program, and so are the files it names.
    pub built_in: bool,
}

/// A scene that was linked.
pub struct Linked {
    /// The scene.
    pub scene: Scene,
    /// Its compiled graphs, one for each use that differs.
    pub shaders: Vec<Arc<Shader>>,
    /// Where each of them is used, in the same order.
    pub uses: Vec<ShaderUse>,
    /// Time spent compiling them, in milliseconds.
    pub compile_milliseconds: f64,
}

impl Linker<'_> {
    /// Compiles the graphs of a scene and builds it. `tell` hears of what is found on the way.
    ///
    /// # Errors
    /// A file that cannot be used, a value that does not suit its parameter, a graph that cannot be
    /// compiled, or an object that cannot be built.
    pub fn link(
        &self,
        scene: &SceneDescription,
        lights: &LightNames,
        tell: &mut dyn FnMut(Remark<'_>),
    ) -> Result<Linked, LinkError> {
        let mut materials = Materials {
            library: self.library,
            shading: self.shading,
            subject: self.subject,
            changes: self.changes,
            lights,
            built_in: self.built_in,
            environment: scene.environment_material().map(|material| material.place.clone()),
            graphs: HashMap::new(),
            idle_told: self.subject.iter().map(|_| MaterialSource::Subject).collect(),
            by_hand: ByHand::default(),
            shaders: Vec::new(),
            uses: Vec::new(),
            milliseconds: 0.0,
            tell,
        };
        let asking = match self.shading {
            Shading::Compiled(options) => options.asking,
            Shading::ByHand(_) => Asking::Guarded,
        };
        let built = scene.build_asking(asking, |material| materials.shader(material));
        let built = built.map_err(|error| match error {
            BuildError::Material(error) => error,
            BuildError::Object { object, source } => LinkError::Object { object, error: source },
            BuildError::Scene(SceneError::Texture(_)) if materials.tell_pictures(scene) => {
                LinkError::Pictures
            }
            BuildError::Scene(error) => LinkError::Scene(error),
        })?;
        let Materials { shaders, uses, milliseconds, by_hand, tell, .. } = materials;
        by_hand.notes()?.for_each(|note| tell(Remark::Note(note)));
        Ok(Linked { scene: built, shaders, uses, compile_milliseconds: milliseconds })
    }
}
