//! The tables of foreign names against what there is: every target exists, no foreign name is one of
//! ours, and none means two things unless it is listed so.

use std::collections::{HashMap, HashSet};

use phenomenon_compiler::diagnostics::synonyms::{
    self, INPUTS, KEYS, NODES, OUTPUTS, ROOTS, SEVERAL, TYPES,
};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::Type;

fn folded(name: &str) -> String {
    name.chars().filter(|c| !matches!(c, '_' | '-' | ' ')).collect::<String>().to_lowercase()
}

#[test]
fn every_node_has_a_row_and_every_row_a_node() {
    let library = NodeLibrary::standard();
    let ours: HashSet<&str> =
        library.iter().map(|(_, definition)| &*definition.signature.name).collect();
    let rows: HashSet<&str> = NODES.called.iter().map(|row| row.ours).collect();
    assert_eq!(rows.len(), NODES.called.len(), "a node has two rows");
    assert_eq!(rows, ours);
    let mut meant: HashMap<String, usize> = HashMap::new();
    for row in &NODES.called {
        for name in row.names() {
            assert!(!ours.contains(name), "`{name}` is a node of ours");
            *meant.entry(folded(name)).or_default() += 1;
            let found = synonyms::node(name).unwrap();
            assert!(found.ours.contains(&row.ours), "`{name}` does not lead to `{}`", row.ours);
        }
    }
    let several: HashSet<String> = SEVERAL.iter().map(|name| folded(name)).collect();
    assert_eq!(several.len(), SEVERAL.len());
    for (name, count) in &meant {
        assert_eq!(*count > 1, several.contains(name), "`{name}` means {count} nodes");
    }
    for name in NODES.absent.iter().flat_map(|row| &row.names) {
        assert!(!ours.contains(name), "`{name}` is a node of ours");
        assert_eq!(meant.insert(folded(name), 0), None, "`{name}` stands twice");
        assert_eq!(synonyms::node(name).unwrap().ours, [""; 0], "{name}");
    }
    // What the advice names between backticks exists, as a node, an input, an output or a key.
    let mut known: HashSet<&str> = ours.clone();
    for (_, definition) in library.iter() {
        known.extend(definition.signature.inputs.iter().map(|input| &*input.name));
        known.extend(definition.signature.outputs.iter().map(|output| &*output.name));
    }
    known.extend(["interface", "roots", "doc", "[r, g, b]", "bg", "fg", "minus", "fmod"]);
    known.insert("file.<UDIM>.png");
    let advice =
        NODES.called.iter().map(|row| row.mind).chain(NODES.absent.iter().map(|row| row.instead));
    for text in advice {
        for quoted in text.split('`').skip(1).step_by(2) {
            assert!(quoted.contains('{') || known.contains(quoted), "`{quoted}` in: {text}");
        }
    }
}

#[test]
fn every_type_has_a_row() {
    let mut ours: HashSet<&str> = Type::ALL.iter().map(|it| it.name()).collect();
    ours.extend(["array", "struct"]);
    assert_eq!(TYPES.called.iter().map(|row| row.ours).collect::<HashSet<_>>(), ours);
    for row in &TYPES.called {
        for name in row.names() {
            assert!(!ours.contains(name), "`{name}` is a type of ours");
        }
        for name in &row.exact {
            assert_eq!(synonyms::value_type(name).unwrap().ours, [row.ours], "{name}");
        }
    }
}

#[test]
fn inputs_and_outputs_exist() {
    let library = NodeLibrary::standard();
    let signatures = || library.iter().map(|(_, definition)| &definition.signature);
    let inputs: HashSet<&str> =
        signatures().flat_map(|it| &it.inputs).map(|input| &*input.name).collect();
    let outputs: HashSet<&str> =
        signatures().flat_map(|it| &it.outputs).map(|output| &*output.name).collect();
    for (table, known) in [(&INPUTS, &inputs), (&OUTPUTS, &outputs)] {
        for row in &table.called {
            assert!(known.contains(row.ours), "`{}` exists nowhere", row.ours);
            assert!(row.names().all(|name| name != row.ours), "{}", row.ours);
        }
    }
    // What may be put in unasked is one thing only, in every node.
    for signature in signatures() {
        let has = |name: &str| signature.inputs.iter().any(|input| input.name == name);
        for row in INPUTS.called.iter().filter(|row| has(row.ours)) {
            for name in row.exact.iter().filter(|name| !has(name)) {
                let found = synonyms::input(name, has).unwrap();
                assert!(found.ours.contains(&row.ours), "{name} of {}", signature.name);
                assert!(!found.exact || found.ours.len() == 1);
            }
        }
    }
}

#[test]
fn keys_are_of_some_object() {
    let schema = include_str!("../../graphs/schema.json");
    for row in KEYS.called.iter().chain(&ROOTS.called) {
        assert!(schema.contains(&format!("\"{}\"", row.ours)), "no object has `{}`", row.ours);
        assert!(row.names().all(|name| name != row.ours), "{}", row.ours);
    }
}

#[test]
fn names_are_found_however_they_are_written() {
    let ours = |name: &str| synonyms::node(name).map(|found| found.ours).unwrap_or_default();
    for name in ["dotproduct", "dotProduct", "dot_product", "DOT-PRODUCT", "ND_dotproduct_vector3"]
    {
        assert_eq!(ours(name), ["dot"], "{name}");
    }
    assert_eq!(ours("lerp"), ["mix"]);
    assert_eq!(ours("mix_float"), ["mix"]);
    assert_eq!(ours("max"), ["maximum"]);
    assert_eq!(ours("fresnel"), ["fresnel_dielectric", "fresnel_reflection"]);
    assert_eq!(synonyms::node("mixx"), None);
    assert_eq!(ours("noise"), ["gradient_noise"]);
    assert_eq!(ours("voronoi"), ["worley_noise"]);
    let finite = synonyms::node("isnan").unwrap();
    assert!(finite.ours.is_empty() && finite.help().starts_with("results are always finite"));
    assert!(synonyms::node("lerp").unwrap().help().contains("`a` is the background"));
    assert_eq!(synonyms::key("spp", |key| key == "samples").unwrap().ours, ["samples"]);
    assert_eq!(synonyms::key("spp", |key| key == "size"), None);
    assert!(synonyms::of_node("maximum").any(|name| name == "max"));
}
