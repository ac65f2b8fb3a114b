//! The digits of every root and every node, at several points.

use serde_json::{Map, Value};

use crate::files;
use crate::ledger::Ledger;
use crate::program::run;

/// What is held against the walk, in turn: with three points each node meets both.
const OTHERS: [&str; 2] = ["batch", "jit"];

/// Where graphs are evaluated: a name for it, and the fields.
const POINTS: [(&str, &[&str]); 3] = [
    ("default", &[]),
    (
        "aslant",
        &[
            "direction=0.6,0,-0.8",
            "normal=0,0.6,0.8",
            "normal_geom=0.36,0.48,0.8",
            "point=1.25,-0.5,3.5",
            "origin=-2,-0.5,7.75",
            "dist=5.5",
            "u=0.3",
            "v=0.7",
            "time=0.25",
            "raster_x=11.5",
            "raster_y=3.5",
        ],
    ),
    (
        "inside",
        &[
            "direction=0.28,-0.96,0",
            "normal=-0.6,0.8,0",
            "point=-30.5,0.0625,7.1",
            "dist=0.375",
            "inv_normal=true",
            "ior=1.2",
            "ior_in=1.5",
            "u=-1.75",
            "v=12.3",
            "ray_type=refraction",
            "reflection_level=1",
            "refraction_level=2",
        ],
    ),
];

/// The values as they are printed, or why there are none.
fn values(what: &[&str], state: &[&str], engine: &str) -> String {
    let mut arguments = vec!["eval", "--format", "json", "--engine", engine];
    arguments.extend(what);
    arguments.extend(state.iter().flat_map(|field| ["--state", field]));
    let run = run(&arguments);
    match run.code {
        0 => run.output.trim_end().to_owned(),
        _ => run.refusal().to_owned(),
    }
}

#[test]
fn values_keep_every_digit() {
    let mut ledger = Ledger::default();
    let mut apart = Vec::new();
    for graph in files::graphs() {
        let document: Value = serde_json::from_str(&files::text(&graph)).unwrap();
        let names = |key: &str| document[key].as_object().into_iter().flat_map(Map::keys);
        let roots = names("roots").map(|name| ("--root", name));
        for (flag, name) in roots.chain(names("nodes").map(|name| ("--node", name))) {
            for ((point, state), engine) in POINTS.into_iter().zip(OTHERS.into_iter().cycle()) {
                let what = [graph.as_str(), flag, name];
                let [walk, other] = ["walk", engine].map(|engine| values(&what, state, engine));
                let name = format!("{} {point}", what.join(" "));
                if walk != other {
                    apart.push(format!("{name}\n  walk {walk}\n  {engine} {other}"));
                }
                ledger.add(name, walk);
            }
        }
    }
    assert!(apart.is_empty(), "engines differ\n{}", apart.join("\n"));
    ledger.hold("values.txt");
}
