//! The small pictures of nodes on the reference page, `docs/pictures/nodes`.
//!
//! `PHENOMENON_BLESS=1 cargo test --workspace --test node_pictures` renders them all anew. Look at what
//! changed before committing it.

mod graphs;
mod stages;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use phenomenon_compiler::nodes::reference::is_pictured;
use phenomenon_compiler::nodes::{NodeLibrary, Signature};
use phenomenon_runtime::film::{self, Film};

/// Width and height of a picture.
const SIZE: u32 = 112;
/// Most bytes of all pictures together.
const MOST_BYTES: u64 = 2_000_000;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/pictures/nodes")
}

fn pictured(library: &NodeLibrary) -> Vec<&Signature> {
    let signatures = library.iter().map(|(_, definition)| &definition.signature);
    signatures.filter(|signature| is_pictured(signature)).collect()
}

/// The picture of a node as bytes of a PNG.
fn drawn(library: &NodeLibrary, signature: &Signature) -> Result<Vec<u8>, String> {
    let film = stages::picture(library, &graphs::drawing(signature), SIZE)?;
    film::encode(&film, Path::new("node.png"), 1.0).map_err(|error| error.to_string())
}

/// How far the brightest and the darkest pixel of any channel are apart.
fn contrast(film: &Film) -> f32 {
    let mut widest = 0.0_f32;
    for channel in 0..3 {
        let values = film.pixels().iter().map(|pixel| pixel[channel]);
        let (low, high) =
            values.fold((f32::MAX, f32::MIN), |(low, high), x| (low.min(x), high.max(x)));
        widest = widest.max(high - low);
    }
    widest
}

#[test]
fn every_pictured_node_has_a_picture_that_shows_something() {
    let library = NodeLibrary::standard();
    let bless = std::env::var_os("PHENOMENON_BLESS").is_some();
    let nodes = pictured(&library);
    assert!(nodes.len() > 20);
    let mut wrong = Vec::new();
    let mut bytes = 0;
    for signature in nodes {
        let path = folder().join(format!("{}.png", signature.name));
        if bless {
            std::fs::create_dir_all(folder()).expect("the folder can be made");
            match drawn(&library, signature) {
                Ok(bytes) => std::fs::write(&path, bytes).expect("the picture can be written"),
                Err(error) => wrong.push(format!("{}: {error}", signature.name)),
            }
        }
        let Ok(film) = film::read(&path) else {
            wrong.push(format!("{} has no picture", signature.name));
            continue;
        };
        bytes += std::fs::metadata(&path).map_or(0, |file| file.len());
        if (film.width(), film.height()) != (SIZE, SIZE) {
            wrong.push(format!("the picture of {} is of another size", signature.name));
        }
        if contrast(&film) < 0.02 {
            wrong.push(format!("the picture of {} shows nothing", signature.name));
        }
    }
    assert!(wrong.is_empty(), "{}\n`PHENOMENON_BLESS=1` renders them", wrong.join("\n"));
    assert!(bytes <= MOST_BYTES, "{bytes} bytes of pictures");
}

#[test]
fn there_is_no_picture_of_anything_else() {
    let library = NodeLibrary::standard();
    let names: BTreeSet<String> =
        pictured(&library).iter().map(|signature| format!("{}.png", signature.name)).collect();
    let files = std::fs::read_dir(folder()).expect("the folder of pictures");
    for file in files {
        let name = file.expect("a file").file_name().into_string().expect("a name");
        assert!(names.contains(&name), "{name} is no node of the groups with pictures");
    }
}

/// What is rendered now is what lies there: of one node for each stage, since all take long.
#[test]
fn pictures_are_those_of_the_nodes_as_they_are() {
    let library = NodeLibrary::standard();
    for name in ["checker", "worley_noise", "ramp", "screen", "lambert"] {
        let signature = library.signature(library.find(name).expect("a standard node"));
        let path = folder().join(format!("{name}.png"));
        let there = std::fs::read(&path).unwrap_or_default();
        assert!(Ok(there) == drawn(&library, signature), "the picture of {name} is an old one");
    }
}
