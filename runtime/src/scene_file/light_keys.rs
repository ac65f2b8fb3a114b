//! The keys of lights in scene files.

use std::ops::RangeInclusive;

use phenomenon_compiler::document::{Given, Key, Kind, Section};

use super::key_kinds::{COLOR, DEGREES, LIGHT, LINEAR, SCENE_UNITS, VECTOR, key, measured};

/// What the sizes of lights may be.
pub const EXTENTS: RangeInclusive<f64> = 0.0..=1e12;
/// How many samples a light with extent may have.
pub const LIGHT_SAMPLES: RangeInclusive<i32> = 1..=256;
/// At which angles off the axis of a spot light its light may start to fade.
pub const INNER_ANGLES: RangeInclusive<f64> = 0.0..=180.0;
/// At which angles off the axis of a spot light its light may end.
pub const OUTER_ANGLES: RangeInclusive<f64> = 1e-3..=180.0;

const EXTENT: Kind = Kind::Number(EXTENTS);

const MIDDLE: Key = measured("position", VECTOR, Given::Required, SCENE_UNITS, "Its middle");

const FACING: Key = key(
    "direction",
    VECTOR,
    Given::Required,
    "Where it shines, square to itself, of any length but 0",
);

const SAMPLES: Key = key(
    "samples",
    Kind::Whole(*LIGHT_SAMPLES.start() as i128..=*LIGHT_SAMPLES.end() as i128),
    Given::Default("4"),
    "Places on it at which each point looks, their light averaged; each costs a shadow ray",
);

/// A light.
pub static LIGHT_SOURCE: Section = Section {
    name: "light",
    what: "a light",
    keys: &[
        key(
            "name",
            Kind::Text,
            Given::Required,
            "What graphs call it; no two lights have the same",
        ),
        key(
            "point",
            Kind::Object(&POINT),
            Given::Choice,
            "It shines from a point in all directions",
        ),
        key("spot", Kind::Object(&SPOT), Given::Choice, "It shines from a point into a cone"),
        key(
            "directional",
            Kind::Object(&DIRECTIONAL),
            Given::Choice,
            "It shines from infinitely far, everywhere alike",
        ),
        key(
            "rectangle",
            Kind::Object(&RECTANGLE_LIGHT),
            Given::Choice,
            "It shines from one side of a rectangle",
        ),
        key("disc", Kind::Object(&DISC), Given::Choice, "It shines from one side of a disc"),
        key(
            "sphere",
            Kind::Object(&SPHERE_LIGHT),
            Given::Choice,
            "It shines from the outside of a sphere",
        ),
        key(
            "environment",
            Kind::Object(&ENVIRONMENT_LIGHT),
            Given::Choice,
            "It shines from all around, as the environment of the scene does; one of them at most",
        ),
        measured("color", COLOR, Given::Default("[1, 1, 1]"), LINEAR, "Its colour"),
        key("intensity", Kind::Number(LIGHT), Given::Default("1"), "Factor on its colour"),
    ],
    one_of: &["point", "spot", "directional", "rectangle", "disc", "sphere", "environment"],
};

/// A point light.
pub static POINT: Section = Section {
    name: "point",
    what: "a point light",
    keys: &[measured("position", VECTOR, Given::Required, SCENE_UNITS, "Where it stands")],
    one_of: &[],
};

/// A spot light.
pub static SPOT: Section = Section {
    name: "spot",
    what: "a spot light",
    keys: &[
        measured("position", VECTOR, Given::Required, SCENE_UNITS, "Where it stands"),
        key(
            "direction",
            VECTOR,
            Given::Required,
            "The axis of its cone, of any length but 0: where it shines",
        ),
        measured(
            "inner_angle",
            Kind::Number(INNER_ANGLES),
            Given::Default("0"),
            DEGREES,
            "Angle off the axis up to which all of its light arrives; at most `outer_angle`",
        ),
        measured(
            "outer_angle",
            Kind::Number(OUTER_ANGLES),
            Given::Default("45"),
            DEGREES,
            "Angle off the axis from which no light arrives: half of the cone's opening",
        ),
    ],
    one_of: &[],
};

/// A directional light.
pub static DIRECTIONAL: Section = Section {
    name: "directional",
    what: "a directional light",
    keys: &[key(
        "direction",
        VECTOR,
        Given::Required,
        "The direction its light travels in, of any length but 0",
    )],
    one_of: &[],
};

/// A rectangle light.
pub static RECTANGLE_LIGHT: Section = Section {
    name: "rectangle_light",
    what: "a rectangle light",
    keys: &[
        MIDDLE,
        FACING,
        key(
            "up",
            VECTOR,
            Given::Optional,
            "A direction its height is turned to, of any length but 0, and not along `direction`. By default [0, 1, 0], or [0, 0, -1] where it shines straight up or down",
        ),
        measured("width", EXTENT, Given::Required, SCENE_UNITS, "Its size across `up`"),
        measured("height", EXTENT, Given::Required, SCENE_UNITS, "Its size along `up`"),
        SAMPLES,
    ],
    one_of: &[],
};

/// A disc light.
pub static DISC: Section = Section {
    name: "disc",
    what: "a disc light",
    keys: &[
        MIDDLE,
        FACING,
        measured("radius", EXTENT, Given::Required, SCENE_UNITS, "Its radius"),
        SAMPLES,
    ],
    one_of: &[],
};

/// A sphere light.
pub static SPHERE_LIGHT: Section = Section {
    name: "sphere_light",
    what: "a sphere light",
    keys: &[
        MIDDLE,
        measured("radius", EXTENT, Given::Required, SCENE_UNITS, "Its radius"),
        SAMPLES,
    ],
    one_of: &[],
};

/// The environment as a light.
pub static ENVIRONMENT_LIGHT: Section = Section {
    name: "environment_light",
    what: "an environment light",
    keys: &[SAMPLES],
    one_of: &[],
};
