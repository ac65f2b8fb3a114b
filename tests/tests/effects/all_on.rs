//! All effects on: the picture is the same to the bit, and the work is more.

use phenomenon_compiler::engine::{Engine, Options};
use phenomenon_compiler::specialise::Asking;
use phenomenon_runtime::render::Entry;

use crate::linking::{Scene, options, shipped};

fn bits(scene: &Scene) -> Vec<u32> {
    let film = scene.render(16).film;
    film.pixels().iter().flatten().map(|x| x.to_bits()).collect()
}

const FILES: [&str; 14] = [
    "graphs/glass/advanced_glass.json",
    "graphs/constant/constant_simple.json",
    "graphs/aniso/aniso_brdf.json",
    "graphs/sunglasses/sunglasses.json",
    "graphs/xray/xray.json",
    "graphs/silk/silk.json",
    "graphs/cd/cd.json",
    "graphs/snow/snow.json",
    "graphs/painted/painted.json",
    "graphs/frosted/frosted_glass.json",
    "graphs/textures/moss.json",
    "graphs/textures/tiled_wall.json",
    "scenes/soft_shadow.json",
    "graphs/occlusion/ambient_occlusion.json",
];

#[test]
fn no_bit_changes() {
    for file in FILES {
        let scene = shipped(file, &[], options(Asking::Guarded));
        assert!(bits(&scene) == bits(&shipped(file, &[], options(Asking::All))), "{file}");
    }
    // Where an effect is folded away, and in the other engines.
    let glass = FILES[0];
    let opaque = [("opacity", 1.0)];
    let picture = bits(&shipped(glass, &opaque, options(Asking::Guarded)));
    for engine in [Engine::Walk, Engine::Batch, Engine::Jit] {
        let all = Options { engine, ..options(Asking::All) };
        assert!(bits(&shipped(glass, &opaque, all)) == picture, "{engine:?}");
    }
}

#[test]
fn whatever_is_off_is_done() {
    let file = "graphs/constant/constant_simple.json";
    let linked = |asking| shipped(file, &[], options(asking));
    let (few, all) = (linked(Asking::Guarded), linked(Asking::All));
    let (little, much) = (few.render(16), all.render(16));
    for entry in [
        Entry::Reflection,
        Entry::Refraction,
        Entry::Transparent,
        Entry::Probe,
        Entry::Environment,
        Entry::LightLoops,
        Entry::ShadowRays,
        Entry::Coordinates,
        Entry::Derivatives,
        Entry::SecondCoordinates,
        Entry::VertexColors,
        Entry::Footprints,
    ] {
        let counts = (little.costs.of(entry).count, much.costs.of(entry).count);
        assert!(counts.0 < counts.1, "{}: {counts:?}", entry.name());
    }
    assert_eq!(little.statistics.rays.eye, much.statistics.rays.eye);
}
