//! What the command line changes about the graphs a scene uses: `--set OBJECT:PARAMETER=VALUE`,
//! `--preset OBJECT:PRESET` and `--node OBJECT:NODE[.OUTPUT]`.

use phenomenon_runtime::link::{Change, Changes, NoSuchUse, TextValue, objects_in_words};
use phenomenon_runtime::scene_file::SceneDescription;

use super::flags::Flags;
use crate::failure::Failure;

/// Marks the uses of graphs that are changed.
///
/// # Errors
/// A flag that names no object, or one the scene does not have.
pub fn mark(scene: &mut SceneDescription, flags: &Flags<'_>) -> Result<Changes, Failure> {
    let mut changes = Changes::default();
    for TextValue { name, value } in flags.set {
        let flag = format!("--set {name}={value}");
        // No parameter has a colon in its name; an object may.
        let Some((object, parameter)) = name.rsplit_once(':') else {
            return Err(names_no_object(scene, &flag, "OBJECT:PARAMETER=VALUE"));
        };
        let change = change_of(scene, &mut changes, object, &flag)?;
        change.set.push(TextValue { name: parameter.to_owned(), value: value.clone() });
    }
    for preset in flags.preset {
        let flag = format!("--preset {preset}");
        let Some((object, name)) = preset.rsplit_once(':') else {
            return Err(names_no_object(scene, &flag, "OBJECT:PRESET"));
        };
        let change = change_of(scene, &mut changes, object, &flag)?;
        if change.preset.replace(name.to_owned()).is_some() {
            let message = format!("{flag}: the object has a preset already");
            return Err(Failure::new(message, "leave one of them out"));
        }
    }
    if let Some(node) = flags.node {
        let flag = format!("--node {node}");
        let Some((object, node)) = node.within_object() else {
            return Err(names_no_object(scene, &flag, "OBJECT:NODE or OBJECT:NODE.OUTPUT"));
        };
        change_of(scene, &mut changes, &object, &flag)?.node = Some(node);
    }
    Ok(changes)
}

fn names_no_object(scene: &SceneDescription, flag: &str, form: &str) -> Failure {
    let message = format!("{flag}: in a scene, say of which object: {form}");
    Failure::new(message, objects_in_words(scene))
}

fn change_of<'c>(
    scene: &mut SceneDescription,
    changes: &'c mut Changes,
    object: &str,
    flag: &str,
) -> Result<&'c mut Change, Failure> {
    let refused = |error: NoSuchUse| Failure::new(format!("{flag}: {error}"), error.help());
    changes.of(scene, object).map_err(refused)
}
