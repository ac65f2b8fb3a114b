//! Which graph a monolith was written for: it belongs to what the graph computes, not to its name.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use phenomenon_compiler::check::{Files, OnDisk, check_graph_with};
use phenomenon_compiler::diagnostics::Finding;
use phenomenon_compiler::document::{Document, read};
use phenomenon_compiler::graph::{Binding, Graph};
use phenomenon_compiler::nodes::{NodeLibrary, NodeType};

use super::library::NAMES;

/// A graph file as it is built into the program: its path, and its text.
macro_rules! built_in {
    ($($path:literal),+ $(,)?) => {
        [$(($path, include_str!(concat!("../../../", $path)))),+]
    };
}

/// The shipped graphs there are monoliths of, in the order of their names.
const SHIPPED: [(&str, &str); 12] = built_in![
    "graphs/glass/advanced_glass.json",
    "graphs/aniso/aniso_brdf.json",
    "graphs/cd/cd.json",
    "graphs/floor/checker_floor.json",
    "graphs/constant/constant_simple.json",
    "graphs/sky/gradient_sky.json",
    "graphs/rainbow/rainbow.json",
    "graphs/silk/silk.json",
    "graphs/snow/snow.json",
    "graphs/sunglasses/sunglasses.json",
    "graphs/mirror/tinted_mirror.json",
    "graphs/xray/xray.json",
];

/// Those that they use.
const USED: [(&str, &str); 1] = built_in!["graphs/snow/glitter.json"];

/// The files that are built into the program, wherever it runs.
struct BuiltIn;

impl Files for BuiltIn {
    fn read(&self, path: &Path) -> Result<Document, Box<Finding>> {
        match USED.iter().find(|(used, _)| path == Path::new(used)) {
            Some((name, text)) => read(name, text.as_bytes()),
            None => OnDisk.read(path),
        }
    }

    fn identity(&self, path: &Path) -> PathBuf {
        path.to_owned()
    }

    fn unusable(&self, path: &Path) -> Option<String> {
        OnDisk.unusable(path)
    }
}

/// Why no monolith stands for a graph.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotWrittenByHand {
    /// None is of a graph that computes this.
    #[error("`{0}` is not written by hand")]
    Unknown(String),
    /// One is of a graph that has the name alone in common.
    #[error("this `{name}` is not the one that is written by hand: {difference}")]
    Another {
        /// The name.
        name: String,
        /// The first thing in which it differs.
        difference: String,
    },
}

/// The name of the monolith that computes what `graph` does, whatever the graph is called and where
/// its file is. Docs, ranges, units and the order of nodes change nothing that is computed, and
/// defaults are values like any other: whoever uses the monolith gives it those of the graph.
///
/// # Errors
/// There is no such monolith.
pub fn recognise(graph: &Graph) -> Result<&'static str, NotWrittenByHand> {
    let own = Content::of(graph);
    let shipped = shipped();
    if let Some((name, _)) = shipped.iter().find(|(_, content)| *content == own) {
        return Ok(name);
    }
    let name = graph.name.clone();
    Err(match shipped.iter().find(|(shipped, _)| *shipped == name) {
        Some((_, content)) => {
            NotWrittenByHand::Another { name, difference: own.difference(content) }
        }
        None => NotWrittenByHand::Unknown(name),
    })
}

/// The shipped graph that the monolith called `name` was written for; none if there is no such monolith.
pub fn graph_by_hand(name: &str, library: &NodeLibrary) -> Option<Graph> {
    let at = NAMES.iter().position(|known| *known == name)?;
    let (path, text) = SHIPPED.get(at)?;
    let document = read(path, text.as_bytes()).ok()?;
    check_graph_with(&document, library, &BuiltIn).graph
}

fn shipped() -> &'static [(&'static str, Content)] {
    static KNOWN: OnceLock<Vec<(&'static str, Content)>> = OnceLock::new();
    KNOWN.get_or_init(|| {
        let library = NodeLibrary::standard();
        let contents = NAMES
            .iter()
            .filter_map(|name| Some((*name, Content::of(&graph_by_hand(name, &library)?))));
        contents.collect()
    })
}

/// What a graph computes, by names: the order in its file means nothing.
#[derive(Debug, PartialEq)]
struct Content {
    /// Types of the parameters.
    parameters: HashMap<String, String>,
    /// Type and inputs of every node.
    nodes: HashMap<String, String>,
    /// What the roots are connected to.
    roots: HashMap<String, String>,
}

impl Content {
    fn of(graph: &Graph) -> Self {
        let binding = |binding: &Binding| match binding {
            Binding::Default => "default".to_owned(),
            // Debug shows every digit a number has, and the sign of zero.
            Binding::Literal(literal) => format!("{literal:?}"),
            Binding::Parameter(at) => format!("parameter {}", graph.parameters[*at].name),
            Binding::Node { node, output } => {
                format!("output {output} of node {}", graph.nodes[*node].name)
            }
        };
        let type_name = |node_type: NodeType| &graph.library.signature(node_type).name;
        Self {
            parameters: graph
                .parameters
                .iter()
                .map(|of| (of.name.clone(), format!("{:?} {:?}", of.value_type, of.labels)))
                .collect(),
            nodes: graph
                .nodes
                .iter()
                .map(|node| {
                    let inputs: Vec<String> = node.inputs.iter().map(binding).collect();
                    let (of, form) = (type_name(node.node_type), node.overload);
                    (node.name.clone(), format!("{of} {form} {inputs:?}"))
                })
                .collect(),
            roots: graph
                .roots
                .iter()
                .map(|root| {
                    let value = format!("{} {}", binding(&root.color), binding(&root.ok));
                    (root.kind.name().to_owned(), value)
                })
                .collect(),
        }
    }

    /// The first thing, by name, in which it is not what another is.
    fn difference(&self, wanted: &Content) -> String {
        let kinds = [
            ("parameter", &self.parameters, &wanted.parameters),
            ("node", &self.nodes, &wanted.nodes),
            ("root", &self.roots, &wanted.roots),
        ];
        for (kind, own, wanted) in kinds {
            let mut names: Vec<&String> = own.keys().chain(wanted.keys()).collect();
            names.sort_unstable();
            for name in names {
                match (own.get(name), wanted.get(name)) {
                    (Some(own), Some(wanted)) if own == wanted => {}
                    (Some(_), Some(_)) => return format!("its {kind} `{name}` is another"),
                    (None, _) => return format!("it lacks the {kind} `{name}`"),
                    (_, None) => return format!("it has a {kind} `{name}` of its own"),
                }
            }
        }
        "it computes something else".into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn recognised(text: &str) -> Result<&'static str, String> {
        let library = NodeLibrary::standard();
        let document = read("graphs/folder/a.json", text.as_bytes()).unwrap();
        let checked = check_graph_with(&document, &library, &BuiltIn);
        let graph = checked.graph.unwrap_or_else(|| panic!("{:?}", checked.findings));
        recognise(&graph).map_err(|error| error.to_string())
    }

    fn shipped_text(name: &str) -> &'static str {
        let at = NAMES.iter().position(|shipped| *shipped == name).unwrap();
        SHIPPED[at].1
    }

    #[test]
    fn every_monolith_has_its_graph() {
        assert_eq!(SHIPPED.len(), NAMES.len());
        for (name, (path, text)) in NAMES.iter().zip(SHIPPED) {
            assert!(path.ends_with(&format!("/{name}.json")), "{path}");
            let document = read(path, text.as_bytes()).unwrap();
            let checked = check_graph_with(&document, &NodeLibrary::standard(), &BuiltIn);
            assert_eq!(recognise(&checked.graph.unwrap()), Ok(*name));
        }
    }

    #[test]
    fn another_name_doc_or_default_changes_nothing() {
        let text = shipped_text("tinted_mirror");
        let renamed = text.replace("\"tinted_mirror\"", "\"my_own\"");
        assert_eq!(recognised(&renamed), Ok("tinted_mirror"));
        let changed = text
            .replace("\"default\": 1.5", "\"default\": 2")
            .replace("colour of the reflection", "another doc")
            // Nodes in another order.
            .replace("    \"mirror\": { \"type\": \"trace_reflection\" },\n", "")
            .replace(
                "\"nodes\": {",
                "\"nodes\": { \"mirror\": { \"type\": \"trace_reflection\" },",
            );
        assert_eq!(changed.matches("trace_reflection").count(), 1);
        assert!(!changed.contains("1.5") && changed.contains("another doc"));
        assert_eq!(recognised(&changed), Ok("tinted_mirror"));
    }

    #[test]
    fn the_name_alone_is_not_enough() {
        let red = r#"{ "phenomenon": "rainbow", "roots": { "material": [1, 0, 0] } }"#;
        let told = recognised(red).unwrap_err();
        assert!(told.contains("`rainbow`") && told.contains("it lacks the parameter"), "{told}");
        let text = shipped_text("tinted_mirror");
        let root = text.replace("{ \"material\": { \"node\": \"shade\" } }", "{ \"material\": 1 }");
        let told = recognised(&root).unwrap_err();
        assert!(told.contains("its root `material` is another"), "{told}");
        let node = text.replace("\"a\": [0, 0, 0]", "\"a\": [0, 0, 1e-9]");
        let told = recognised(&node).unwrap_err();
        assert!(told.contains("its node `shade` is another"), "{told}");
        // What an inner phenomenon computes counts as well.
        let film = shipped_text("sunglasses").replace("\"saturation\": 1.0", "\"saturation\": 0.5");
        let told = recognised(&film).unwrap_err();
        assert!(told.contains("its node `filmed/film` is another"), "{told}");
        let own = r#"{ "phenomenon": "own", "roots": { "material": [1, 0, 0] } }"#;
        assert_eq!(recognised(own), Err("`own` is not written by hand".into()));
    }
}
