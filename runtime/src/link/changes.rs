//! What whoever looks at a scene changes about the graphs it uses.

use phenomenon_compiler::diagnostics::{listed, nearest};

use super::node_path::NodePath;
use super::values::TextValue;
use crate::scene_file::{EnvironmentDescription, MaterialRef, SceneDescription};

/// What is changed about one use of a graph.
#[derive(Clone, Debug)]
pub struct Change {
    /// The object, as it is named: by its name, as `objects[2]`, or `environment`.
    pub object: String,
    /// The preset whose values come before those the scene sets.
    pub preset: Option<String>,
    /// Parameters and their values, which come before those the scene sets.
    pub set: Vec<TextValue>,
    /// The node that is shown instead of the graph.
    pub node: Option<NodePath>,
}

/// The changes to a scene; uses of graphs that are changed are marked in it.
#[derive(Clone, Debug, Default)]
pub struct Changes(Vec<Change>);

/// Why a name leads to no use of a graph.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoSuchUse {
    /// The scene has no object with this name.
    #[error("the scene has no object `{object}`")]
    Unknown {
        /// The name that was given.
        object: String,
        /// What may be meant, or what there is.
        help: String,
    },
    /// The scene has fewer objects.
    #[error("the scene has {count} objects")]
    PastTheLast {
        /// How many it has.
        count: usize,
        /// What there is.
        help: String,
    },
    /// The environment is none, or built in.
    #[error("the environment of this scene is no graph")]
    EnvironmentIsNoGraph,
    /// Several objects have this name.
    #[error("{} objects are called `{object}`", positions.len())]
    Several {
        /// The name that was given.
        object: String,
        /// Where they stand among the objects.
        positions: Vec<usize>,
    },
}

impl NoSuchUse {
    /// What to do about it.
    pub fn help(&self) -> String {
        match self {
            NoSuchUse::Unknown { help, .. } | NoSuchUse::PastTheLast { help, .. } => help.clone(),
            NoSuchUse::EnvironmentIsNoGraph => {
                "give it one: \"environment\": { \"file\": \"graph.json\" }".into()
            }
            NoSuchUse::Several { positions, .. } => {
                let places: Vec<String> =
                    positions.iter().map(|at| format!("objects[{at}]")).collect();
                format!("say which: {}", listed(places.iter().map(String::as_str)))
            }
        }
    }
}

impl Changes {
    /// The change of the use of a graph that `object` names; an empty one where there is none yet.
    ///
    /// # Errors
    /// The scene has no such object, or several.
    pub fn of(
        &mut self,
        scene: &mut SceneDescription,
        object: &str,
    ) -> Result<&mut Change, NoSuchUse> {
        let material = material(scene, object)?;
        let at = *material.change.get_or_insert_with(|| {
            let object = object.to_owned();
            self.0.push(Change { object, preset: None, set: Vec::new(), node: None });
            self.0.len() - 1
        });
        Ok(&mut self.0[at])
    }

    /// The change that a use of a graph is marked with.
    pub(super) fn marked(&self, material: &MaterialRef) -> Option<&Change> {
        material.change.and_then(|at| self.0.get(at))
    }
}

/// The graph of the object with that name, at that position (`objects[2]`), or of the environment.
fn material<'s>(
    scene: &'s mut SceneDescription,
    object: &str,
) -> Result<&'s mut MaterialRef, NoSuchUse> {
    let named = scene.objects.iter().enumerate().filter(|(_, it)| it.name == object);
    let named: Vec<usize> = named.map(|(at, _)| at).collect();
    let at = match (named.as_slice(), position(object)) {
        ([one], _) => *one,
        ([], Some(at)) if at < scene.objects.len() => at,
        ([], Some(_)) => {
            let count = scene.objects.len();
            return Err(NoSuchUse::PastTheLast { count, help: objects_in_words(scene) });
        }
        ([], None) if object == "environment" => {
            return match &mut scene.environment {
                Some(EnvironmentDescription::Shader(material)) => Ok(material),
                _ => Err(NoSuchUse::EnvironmentIsNoGraph),
            };
        }
        ([], None) => {
            let names = scene.objects.iter().map(|object| object.name.as_str());
            let help = match nearest(object, names) {
                Some(near) => near.help(),
                None => objects_in_words(scene),
            };
            return Err(NoSuchUse::Unknown { object: object.to_owned(), help });
        }
        _ => return Err(NoSuchUse::Several { object: object.to_owned(), positions: named }),
    };
    Ok(&mut scene.objects[at].material)
}

/// The number in `objects[2]`.
fn position(object: &str) -> Option<usize> {
    object.strip_prefix("objects[")?.strip_suffix(']')?.parse().ok()
}

/// The first objects of a scene, for messages: "what there is: …".
pub fn objects_in_words(scene: &SceneDescription) -> String {
    let mut names: Vec<&str> = Vec::new();
    for object in &scene.objects {
        if !names.contains(&object.name.as_str()) && names.len() < 20 {
            names.push(&object.name);
        }
    }
    if scene.environment_material().is_some() {
        names.push("environment");
    }
    match names.as_slice() {
        [] => "the scene has no objects".into(),
        names => format!("what there is: {}", listed(names.iter().copied())),
    }
}
