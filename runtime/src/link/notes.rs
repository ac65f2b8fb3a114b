//! What of a graph no picture shows, said rather than passed over.

use std::fmt;

use phenomenon_compiler::diagnostics::{Place, listed};
use phenomenon_compiler::graph::{Graph, RootKind};

use crate::monoliths::NotWrittenByHand;
use crate::render::CALLED_ROOTS;

/// Something about a graph that keeps nothing from being rendered.
#[derive(Clone, Debug, PartialEq)]
pub enum Note {
    /// It has roots that this renderer does not call.
    IdleRoots {
        /// The graph.
        graph: String,
        /// The roots.
        roots: Vec<RootKind>,
    },
    /// It requires what this renderer does not do.
    Unmet {
        /// The graph.
        graph: String,
        /// What it requires.
        requirements: Vec<String>,
    },
    /// It is there to be seen, and has neither a material nor an environment root.
    Unseen {
        /// The graph.
        graph: String,
        /// The roots it has.
        roots: Vec<RootKind>,
        /// The outputs it has.
        outputs: Vec<String>,
    },
    /// It lacks the root that is called, and what it is used for is black.
    Black {
        /// The graph.
        graph: String,
        /// The root that is called.
        root: RootKind,
        /// Where it is used.
        place: Place,
    },
    /// It is compiled although monoliths are asked for: others of the scene are written by hand.
    Compiled {
        /// Why there is no monolith of it.
        why: NotWrittenByHand,
    },
}

impl Note {
    /// Which roots and which requirements of a graph no picture depends on.
    pub fn idle(graph: &Graph) -> Vec<Note> {
        let name = || graph.name.clone();
        let mut notes = Vec::new();
        let roots = graph.roots.iter().map(|root| root.kind);
        let roots: Vec<RootKind> = roots.filter(|kind| !CALLED_ROOTS.contains(kind)).collect();
        if !roots.is_empty() {
            notes.push(Note::IdleRoots { graph: name(), roots });
        }
        let requirements = unmet(graph);
        if !requirements.is_empty() {
            notes.push(Note::Unmet { graph: name(), requirements });
        }
        notes
    }

    /// Whether a graph that is to be seen is shown nowhere.
    pub fn unseen(graph: &Graph) -> Option<Note> {
        let has = |kind| graph.root(kind).is_some();
        if has(RootKind::Material) || has(RootKind::Environment) {
            return None;
        }
        let roots = graph.roots.iter().map(|root| root.kind).collect();
        let outputs = graph.outputs.iter().map(|output| output.name.clone()).collect();
        Some(Note::Unseen { graph: graph.name.clone(), roots, outputs })
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Note::IdleRoots { graph, roots } => write!(
                f,
                "`{graph}` is checked whole, but this renderer does not call shaders of type {}; it calls {}",
                listed(roots.iter().map(|kind| kind.name())),
                listed(CALLED_ROOTS.iter().map(|kind| kind.name())),
            ),
            Note::Unmet { graph, requirements } => write!(
                f,
                "`{graph}` requires {}, which this renderer does not do",
                requirements.join(", ")
            ),
            Note::Unseen { graph, roots, outputs } => {
                write!(
                    f,
                    "nothing is seen of `{graph}`, for it has neither a material nor an environment root; "
                )?;
                match roots.as_slice() {
                    [] if !outputs.is_empty() => write!(
                        f,
                        "`--node` shows one of its outputs: {}",
                        listed(outputs.iter().map(String::as_str))
                    ),
                    [] => f.write_str("it has no roots at all"),
                    roots => {
                        write!(f, "its roots are {}", listed(roots.iter().map(|kind| kind.name())))
                    }
                }
            }
            Note::Black { graph, root, place } => {
                let what = match root {
                    RootKind::Environment => "the environment",
                    _ => "the object",
                };
                let (at, root) = (line_of(place), root.name());
                write!(f, "{at}: `{graph}` has no `{root}` root, so {what} is black")
            }
            Note::Compiled { why } => write!(f, "{why}, so it is compiled; other objects are"),
        }
    }
}

/// A place in a line of text: file, line and column.
pub(super) fn line_of(place: &Place) -> String {
    let (line, column) = place.line_column();
    format!("{}:{line}:{column}", place.file.name)
}

/// Which requirements of a graph this renderer does not meet.
fn unmet(graph: &Graph) -> Vec<String> {
    let requirements = &graph.requirements;
    let choices = requirements.choices.iter().filter(|choice| !MET.contains(choice));
    let mut unmet: Vec<String> =
        choices.map(|(key, value)| format!("`{key}` to be `{value}`")).collect();
    if requirements.texture > 1 {
        unmet.push(format!("{} texture spaces", requirements.texture));
    }
    if requirements.bump > 0 {
        unmet.push(format!("{} bump bases", requirements.bump));
    }
    if !requirements.derivative.is_empty() {
        unmet.push("surface derivatives".into());
    }
    if requirements.volume_level > 0 {
        unmet.push("volumes in order".into());
    }
    unmet
}

/// What this renderer does anyway: it traces all rays, casts shadows and hits both faces.
const MET: [(&&str, &&str); 4] =
    [(&"face", &"both"), (&"scanline", &"off"), (&"shadow", &"on"), (&"trace", &"on")];
