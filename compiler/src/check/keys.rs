//! The keys of the objects a phenomenon is written with: what its reader knows, and editors offer.

use crate::values::Type;

/// The keys of a phenomenon.
pub const PHENOMENON: [&str; 10] = [
    "$schema",
    "format",
    "phenomenon",
    "version",
    "doc",
    "requires",
    "interface",
    "nodes",
    "roots",
    "editor",
];

/// The keys of a node.
pub const NODE: [&str; 5] = ["type", "version", "doc", "inputs", "editor"];

/// The keys of a connection, of which `output` goes with `node`.
pub const CONNECTION: [&str; 3] = ["node", "output", "interface"];

/// The keys of `requires`.
pub const REQUIRES: [&str; 11] = [
    "scanline",
    "trace",
    "shadow",
    "face",
    "space",
    "texture",
    "bump",
    "volume_level",
    "derivative",
    "parallel",
    "apply",
];

/// Types of parameters that are made of others.
pub const COMPOUNDS: [&str; 2] = ["array", "struct"];

/// What the type of a parameter may be.
pub fn declared_types() -> Vec<&'static str> {
    Type::ALL.iter().map(|of| of.name()).chain(COMPOUNDS).collect()
}

/// The keys of a declaration by what it says its type is, as far as that is known.
pub fn of_declaration(type_name: Option<&str>, has_values: bool) -> &'static [&'static str] {
    match type_name {
        Some("array") => &ARRAY,
        Some("struct") => &STRUCT,
        Some("integer") if has_values => &ENUMERATION,
        Some("integer") => &INTEGER,
        Some("scalar" | "color" | "vector") => &NUMERIC,
        Some(name) if Type::ALL.iter().any(|of| of.name() == name) => &PLAIN,
        // What it may be is not known, so any of them may be right.
        _ => &PARAMETER,
    }
}

/// The keys of a parameter with numbers.
const NUMERIC: [&str; 9] =
    ["type", "default", "min", "max", "soft_min", "soft_max", "unit", "doc", "editor"];
/// The keys of an integer.
const INTEGER: [&str; 10] =
    ["type", "default", "min", "max", "soft_min", "soft_max", "unit", "doc", "editor", "values"];
/// The keys of an enumeration, whose range is that of its names.
const ENUMERATION: [&str; 6] = ["type", "default", "values", "unit", "doc", "editor"];
/// The keys of a parameter of any type.
const PARAMETER: [&str; 12] = [
    "type", "default", "min", "max", "soft_min", "soft_max", "unit", "doc", "editor", "values",
    "of", "members",
];
/// The keys of a parameter without an order.
const PLAIN: [&str; 4] = ["type", "default", "doc", "editor"];
/// The keys of an array.
const ARRAY: [&str; 5] = ["type", "of", "default", "doc", "editor"];
/// The keys of a struct.
const STRUCT: [&str; 5] = ["type", "members", "default", "doc", "editor"];
