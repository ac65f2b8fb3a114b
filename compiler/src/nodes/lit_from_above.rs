//! What every node of light on a surface holds to: from behind, nothing is reflected and nothing is asked for.

use super::NodeLibrary;
use super::harness::{demanded, numbers};
use crate::values::Literal;

const UP: [f32; 3] = [0.0, 0.0, 1.0];
const DOWN: [f32; 3] = [0.0, 0.0, -1.0];
const EDGEWISE: [f32; 3] = [1.0, 0.0, 0.0];

/// Nodes of one light sample, for a light loop.
const SHADING: [&str; 10] = [
    "ashikhmin_shirley",
    "blinn",
    "cook_torrance",
    "ggx",
    "oren_nayar",
    "phong",
    "schlick_anisotropic",
    "sheen",
    "torrance_sparrow",
    "ward",
];
/// Reflectances, and the distribution some are made of.
const REFLECTANCES: [&str; 11] = [
    "ashikhmin_shirley_brdf",
    "cook_torrance_brdf",
    "ggx_brdf",
    "lambert_brdf",
    "microfacet_distribution",
    "oren_nayar_brdf",
    "phong_brdf",
    "schlick_anisotropic_brdf",
    "sheen_brdf",
    "torrance_sparrow_brdf",
    "ward_brdf",
];

/// A surface that faces upwards, light from a direction, and a ray.
fn at(direction: [f32; 3], ray: [f32; 3]) -> Vec<(&'static str, Literal)> {
    let vectors = [("normal", UP), ("direction", direction), ("ray", ray)];
    vectors.map(|(name, vector)| (name, Literal::Vector(vector))).to_vec()
}

#[test]
fn light_from_behind_is_not_asked_for() {
    let library = NodeLibrary::standard();
    for name in SHADING {
        let definition = library.definition(library.find(name).expect(name));
        for (direction, ray, asks) in [
            (UP, DOWN, true),
            ([1.0, 0.0, 1e-45], DOWN, true),
            (DOWN, DOWN, false),
            (EDGEWISE, DOWN, false),
            (UP, EDGEWISE, false),
        ] {
            let given = at(direction, ray);
            assert_eq!(demanded(definition, &given, "light"), asks, "{name} {direction:?} {ray:?}");
        }
        let mut given = at(DOWN, DOWN);
        given.push(("light", Literal::Color([f32::NAN; 4])));
        assert_eq!(numbers(definition, &given, "color"), [0.0, 0.0, 0.0, 1.0], "{name}");
    }
}

#[test]
fn nothing_is_reflected_from_behind() {
    let library = NodeLibrary::standard();
    for name in REFLECTANCES {
        let definition = library.definition(library.find(name).expect(name));
        let from_behind = [DOWN, EDGEWISE, [0.0; 3], [f32::NAN; 3]].map(|light| at(light, DOWN));
        for given in from_behind.into_iter().chain([at(UP, UP)]) {
            let values = numbers(definition, &given, "value");
            let is_dark = values.iter().take(3).all(|&value| value == 0.0);
            assert!(is_dark, "{name} {given:?}: {values:?}");
        }
    }
}
