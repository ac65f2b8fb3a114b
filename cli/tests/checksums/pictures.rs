//! Small pictures of every graph and scene that is shipped, from every engine.

use phenomenon_runtime::film;
use serde_json::Value;

use crate::files;
use crate::ledger::{Ledger, checksum};
use crate::program::run;

/// Those that agree to the bit.
const ENGINES: [&str; 3] = ["walk", "batch", "jit"];

/// What stands on the command line before the flags, by name.
fn subjects() -> Vec<(String, Vec<String>)> {
    let of_graph = |graph: String| (graph.clone(), vec![graph]);
    let of_scene = |scene: String| {
        // Some scenes are there to show a graph.
        if files::text(&scene).contains("\"subject\": true") {
            let arguments = ["graphs/glass/advanced_glass.json", "--scene", &scene];
            (scene.clone(), arguments.map(str::to_owned).to_vec())
        } else {
            of_graph(scene)
        }
    };
    let graphs = files::graphs().into_iter().map(of_graph);
    graphs.chain(files::scenes().into_iter().map(of_scene)).collect()
}

/// The film and the rays of a picture, or why there is none.
fn picture(subject: &[String], engine: &str) -> Result<String, String> {
    let folder = tempfile::tempdir().unwrap();
    let [film, stats] = ["film.exr", "stats.json"].map(|name| folder.path().join(name));
    let mut arguments: Vec<&str> = vec!["render"];
    arguments.extend(subject.iter().map(String::as_str));
    arguments.extend(["--engine", engine, "--size", "40x30", "--spp", "2", "--quiet"]);
    arguments.extend(["-o", film.to_str().unwrap(), "--stats", stats.to_str().unwrap()]);
    let run = run(&arguments);
    if run.code != 0 {
        return Err(run.refusal().to_owned());
    }
    let film = film::read(&film).unwrap();
    let stats: Value = serde_json::from_slice(&std::fs::read(stats).unwrap()).unwrap();
    let rays: Vec<String> = (stats["rays"].as_object().unwrap().iter())
        .map(|(kind, count)| format!("{kind} {count}"))
        .collect();
    Ok(format!("{}, {}", bits(film.pixels()), rays.join(", ")))
}

/// The checksum of all bits, with one NaN for all: what their payloads are is left to the machine.
fn bits(pixels: &[[f32; 4]]) -> String {
    let canonical = |x: &f32| if x.is_nan() { f32::NAN } else { *x };
    checksum(pixels.as_flattened().iter().flat_map(|x| canonical(x).to_bits().to_le_bytes()))
}

#[test]
fn pictures_keep_every_bit_and_every_ray() {
    let mut ledger = Ledger::default();
    let mut apart = Vec::new();
    for (name, subject) in subjects() {
        let [walk, others @ ..] = ENGINES.map(|engine| (engine, picture(&subject, engine)));
        for (engine, other) in others {
            if walk.1 != other {
                apart.push(format!("{name}\n  walk {:?}\n  {engine} {other:?}", walk.1));
            }
        }
        let walk = walk.1.unwrap_or_else(|why| panic!("{name}: {why}"));
        ledger.add(format!("{name} {}", ENGINES.join(" ")), walk);
        let monolith = picture(&subject, "monolith");
        if let Err(why) = &monolith {
            assert!(why.ends_with("is not written by hand"), "{name}: {why}");
        }
        ledger.add(format!("{name} monolith"), monolith.unwrap_or_else(|why| why));
    }
    assert!(apart.is_empty(), "engines differ\n{}", apart.join("\n"));
    ledger.hold("pictures.txt");
}

#[test]
fn one_bit_or_another_nan_is_told_apart_as_it_should() {
    let pixels = |x: f32| [[1.0, -0.0, 0.5, 1.0], [0.0, x, 0.0, 1.0]];
    assert_ne!(bits(&pixels(0.0)), bits(&pixels(-0.0)));
    assert_ne!(bits(&pixels(0.3)), bits(&pixels(0.3_f32.next_up())));
    assert_eq!(bits(&pixels(f32::NAN)), bits(&pixels(f32::from_bits(0xffc0_0123))));
}
