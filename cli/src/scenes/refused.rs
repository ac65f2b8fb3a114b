//! Why a scene cannot be rendered, in terms of the command line.

use std::path::Path;

use phenomenon_runtime::link::LinkError;
use phenomenon_runtime::monoliths::{self, NoMonolith};
use phenomenon_runtime::scene::SceneError;

use crate::failure::Failure;
use crate::graphs;

/// The failure of a file whose scene cannot be linked.
pub fn refused(path: &Path, error: LinkError) -> Failure {
    let of_file =
        |error: &LinkError, help: &str| Failure::new(format!("{}: {error}", path.display()), help);
    match error {
        LinkError::Unusable { file } => graphs::unusable(&file),
        LinkError::Pictures => graphs::unusable(path),
        LinkError::NoSubject { .. } => Failure::new(
            error,
            "render a graph, and give this file with --scene; \
             or name the file of a graph instead of `subject`",
        ),
        LinkError::Value { object, error } => graphs::bad_value(&format!("{object}:"), &error),
        LinkError::Preset { object, error } => graphs::no_preset(&format!("{object}:"), &error),
        LinkError::Node(error) => graphs::not_shown(&error),
        LinkError::Compile { graph, error } => graphs::not_compiled(&graph, &error),
        LinkError::ByHand(NoMonolith::NotWritten(error)) => {
            let help = format!(
                "these are: {}; choose another engine for this graph",
                monoliths::NAMES.join(", ")
            );
            Failure::new(format!("--engine monolith: {error}"), help)
        }
        LinkError::ByHand(NoMonolith::Value(error)) => {
            Failure::new(error, "leave it out, or choose another engine")
        }
        LinkError::Object { .. } => of_file(&error, "change the object"),
        LinkError::Scene(SceneError::Texture(_)) => {
            of_file(&error, "use fewer or smaller pictures")
        }
        LinkError::Scene(_) => of_file(&error, "leave some of its objects out"),
    }
}
