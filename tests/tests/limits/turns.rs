//! The turns of maps and folds.

use std::path::Path;

use phenomenon_compiler::check::{MAX_TURNS, read_graph_file};
use phenomenon_compiler::nodes::NodeLibrary;

use super::{code, phenomenon};

/// A map over a list of too many numbers.
pub fn many_turns(folder: &Path) -> String {
    let body = r#"{"phenomenon":"p","interface":{"item":{"type":"color","default":0}},
        "roots":{"material":{"interface":"item"}}}"#;
    std::fs::write(folder.join("turn.json"), body).unwrap();
    let with = |name: &str, turns: usize| {
        let zeros = vec!["0"; turns].join(",");
        let nodes = format!(
            r#""m":{{"type":{{"map":{{"file":"turn.json"}}}},"inputs":{{"over":[{zeros}]}}}},
               "n":{{"type":"sum","inputs":{{"values":{{"node":"m"}}}}}}"#
        );
        let path = folder.join(name);
        std::fs::write(&path, phenomenon(&nodes, r#"{"node":"n"}"#)).unwrap();
        read_graph_file(&path, &NodeLibrary::standard())
    };
    assert!(with("most.json", MAX_TURNS).graph.is_some());
    code(&with("more.json", MAX_TURNS + 1))
}
