//! What the command line changes about the graphs a scene uses: `--set OBJECT:PARAMETER=VALUE` and
//! `--node OBJECT:NODE[.OUTPUT]`.

use phenomenon_compiler::diagnostics::{listed, nearest};
use phenomenon_runtime::scene_file::{EnvironmentDescription, MaterialRef, SceneDescription};

use super::Change;
use crate::arguments::{Assignment, NodePath};
use crate::failure::Failure;

/// What is changed about one use of a graph.
#[derive(Clone, Debug)]
pub struct Changed {
    /// The object, as the command line names it.
    pub object: String,
    /// Parameters and their values.
    pub set: Vec<Assignment>,
    /// The node that is shown.
    pub node: Option<NodePath>,
}

/// Marks the uses of graphs that are changed; each mark is a position in what is returned.
///
/// # Errors
/// A flag that names no object, or one the scene does not have.
pub fn mark(scene: &mut SceneDescription, change: &Change<'_>) -> Result<Vec<Changed>, Failure> {
    let mut changes: Vec<Changed> = Vec::new();
    for assignment in change.set {
        let flag = format!("--set {}={}", assignment.name, assignment.value);
        // No parameter has a colon in its name; an object may.
        let Some((object, parameter)) = assignment.name.rsplit_once(':') else {
            return Err(names_no_object(scene, &flag, "OBJECT:PARAMETER=VALUE"));
        };
        let at = change_of(scene, &mut changes, object, &flag)?;
        let (name, value) = (parameter.to_owned(), assignment.value.clone());
        changes[at].set.push(Assignment { name, value });
    }
    if let Some(node) = change.node {
        let flag = format!("--node {node}");
        let Some((object, node)) = node.within_object() else {
            return Err(names_no_object(scene, &flag, "OBJECT:NODE or OBJECT:NODE.OUTPUT"));
        };
        let at = change_of(scene, &mut changes, &object, &flag)?;
        changes[at].node = Some(node);
    }
    Ok(changes)
}

fn names_no_object(scene: &SceneDescription, flag: &str, form: &str) -> Failure {
    let message = format!("{flag}: in a scene, say of which object: {form}");
    Failure::new(message, objects(scene))
}

/// The change of the use of a graph that `object` names; a new one where there is none yet.
fn change_of(
    scene: &mut SceneDescription,
    changes: &mut Vec<Changed>,
    object: &str,
    flag: &str,
) -> Result<usize, Failure> {
    let material = material(scene, object, flag)?;
    Ok(*material.change.get_or_insert_with(|| {
        changes.push(Changed { object: object.to_owned(), set: Vec::new(), node: None });
        changes.len() - 1
    }))
}

/// The graph of the object with that name, at that position (`objects[2]`), or of the environment.
fn material<'s>(
    scene: &'s mut SceneDescription,
    object: &str,
    flag: &str,
) -> Result<&'s mut MaterialRef, Failure> {
    let named = scene.objects.iter().enumerate().filter(|(_, it)| it.name == object);
    let named: Vec<usize> = named.map(|(at, _)| at).collect();
    let refuse = |why: String, help: String| Err(Failure::new(format!("{flag}: {why}"), help));
    let at = match (named.as_slice(), position(object)) {
        ([one], _) => *one,
        ([], Some(at)) if at < scene.objects.len() => at,
        ([], Some(_)) => {
            let count = scene.objects.len();
            return refuse(format!("the scene has {count} objects"), objects(scene));
        }
        ([], None) if object == "environment" => {
            return match &mut scene.environment {
                Some(EnvironmentDescription::Shader(material)) => Ok(material),
                _ => refuse(
                    "the environment of this scene is no graph".into(),
                    "give it one: \"environment\": { \"file\": \"graph.json\" }".into(),
                ),
            };
        }
        ([], None) => {
            let names = scene.objects.iter().map(|object| object.name.as_str());
            let help = match nearest(object, names) {
                Some(near) => near.help(),
                None => objects(scene),
            };
            return refuse(format!("the scene has no object `{object}`"), help);
        }
        (many, _) => {
            let places = many.iter().map(|at| format!("objects[{at}]")).collect::<Vec<_>>();
            let help = format!("say which: {}", listed(places.iter().map(String::as_str)));
            return refuse(format!("{} objects are called `{object}`", many.len()), help);
        }
    };
    Ok(&mut scene.objects[at].material)
}

/// The number in `objects[2]`.
fn position(object: &str) -> Option<usize> {
    object.strip_prefix("objects[")?.strip_suffix(']')?.parse().ok()
}

/// The objects of a scene, for messages.
fn objects(scene: &SceneDescription) -> String {
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
