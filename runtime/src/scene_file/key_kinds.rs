//! What the keys of scene files take: kinds of values, their ranges and units.

use std::ops::RangeInclusive;

use phenomenon_compiler::document::{Given, Key, Kind};

/// What coordinates and factors of scale may be.
pub const COORDINATES: RangeInclusive<f64> = -1e12..=1e12;
/// What lengths may be.
pub const LENGTHS: RangeInclusive<f64> = 1e-12..=1e12;
/// What colours and intensities of light may be.
pub const LIGHT: RangeInclusive<f64> = 0.0..=1e12;

/// A point, direction or three angles.
pub(super) const VECTOR: Kind = Kind::Several(&Kind::Number(COORDINATES), 3..=3);
/// Red, green and blue, or a colour in a space that is named.
pub(super) const COLOR: Kind = Kind::Either(
    &Kind::Value { text: "colour of a named space", definition: "color_of_space" },
    &Kind::Several(&Kind::Number(LIGHT), 3..=3),
);
pub(super) const LENGTH: Kind = Kind::Number(LENGTHS);

pub(super) const SCENE_UNITS: &str = "scene units";
pub(super) const DEGREES: &str = "degrees";
/// The unit of colours.
pub const LINEAR: &str = "linear Rec. 709";

/// A key without a unit.
pub(super) const fn key(name: &'static str, kind: Kind, given: Given, doc: &'static str) -> Key {
    measured(name, kind, given, "", doc)
}

pub(super) const fn measured(
    name: &'static str,
    kind: Kind,
    given: Given,
    unit: &'static str,
    doc: &'static str,
) -> Key {
    Key { name, kind, only: &[], given, unit, doc }
}
