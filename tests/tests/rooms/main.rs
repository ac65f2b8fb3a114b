//! The house: imports run down only. The rooms of each crate and their floors stand in
//! `docs/architecture.md`; a room imports those of lower floors, a file no file that imports it.

mod edits;
mod gallery;
mod paths;
mod plan;
mod tree;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use petgraph::algo::tarjan_scc;
use petgraph::graph::DiGraph;

use plan::Plan;
use tree::Tree;

const CRATES: [&str; 3] = ["compiler", "runtime", "cli"];

fn workspace() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn tree(name: &str) -> Tree {
    Tree::read(&workspace().join(name).join("src"))
}

/// Which file imports which, each with a name it takes.
fn imports(tree: &Tree) -> BTreeMap<(&str, &str), String> {
    let mut imports = BTreeMap::new();
    for module in tree.modules() {
        for path in &module.paths {
            if let Some(target) = tree.resolve(module, path)
                && target.file != module.file
            {
                let edge = (module.file.as_str(), target.file.as_str());
                imports.entry(edge).or_insert_with(|| path.join("::"));
            }
        }
    }
    imports
}

/// The files of each circle, as the imports that tie them.
fn circles(imports: &BTreeMap<(&str, &str), String>) -> Vec<String> {
    let mut graph = DiGraph::<&str, ()>::new();
    let files: BTreeSet<&str> = imports.keys().flat_map(|&(from, to)| [from, to]).collect();
    let nodes: BTreeMap<_, _> =
        files.into_iter().map(|file| (file, graph.add_node(file))).collect();
    graph.extend_with_edges(imports.keys().map(|(from, to)| (nodes[from], nodes[to])));
    let circles = tarjan_scc(&graph).into_iter().filter(|files| files.len() > 1);
    let ties = circles.map(|circle| {
        let inside: BTreeSet<&str> = circle.iter().map(|&file| graph[file]).collect();
        let tie = |((from, to), by): (&(&str, &str), &String)| {
            let is_tie = inside.contains(from) && inside.contains(to);
            is_tie.then(|| format!("  {from} -> {to}: {by}\n"))
        };
        format!(
            "a circle of {} files:\n{}",
            inside.len(),
            imports.iter().filter_map(tie).collect::<String>()
        )
    });
    ties.collect()
}

#[test]
fn no_files_import_each_other() {
    let mut found = String::new();
    for name in CRATES {
        let tree = tree(name);
        let imports = imports(&tree);
        assert!(imports.len() > 50, "{name}: so few imports cannot be all: {imports:?}");
        circles(&imports).iter().for_each(|circle| found += &format!("{name}: {circle}"));
    }
    assert!(found.is_empty(), "{found}");
}

#[test]
fn a_circle_is_found() {
    let imports = [("a", "b"), ("b", "c"), ("c", "a"), ("c", "d")];
    let imports = imports.into_iter().map(|edge| (edge, "name".to_owned())).collect();
    let found = circles(&imports);
    assert_eq!(found.len(), 1);
    assert!(found[0].contains("c -> a") && !found[0].contains("c -> d"), "{found:?}");
}

#[test]
fn imports_run_down_the_floors_of_the_plan() {
    let plan = Plan::read(&workspace().join("docs/architecture.md"));
    for name in CRATES {
        let tree = tree(name);
        let floors = plan.floors(name);
        let known: BTreeSet<&str> = floors.keys().map(String::as_str).collect();
        let built: BTreeSet<&str> = tree.rooms().collect();
        assert_eq!(built, known, "{name}: rooms built, and rooms of the plan");
        let mut against = Vec::new();
        for ((from, to), by) in imports(&tree) {
            let (Some(above), Some(below)) = (tree::room(from), tree::room(to)) else { continue };
            if above != below && floors[above] <= floors[below] {
                against.push(format!("{from} -> {to}: {by}"));
            }
        }
        assert!(against.is_empty(), "{name}: against the plan:\n{}", against.join("\n"));
    }
}

#[test]
fn the_compiler_knows_no_renderer() {
    let manifest = std::fs::read_to_string(workspace().join("compiler/Cargo.toml")).unwrap();
    let dependencies = manifest.split("[dev-dependencies]").next().unwrap();
    assert!(!dependencies.contains("phenomenon-runtime"), "compiler/Cargo.toml");
}
