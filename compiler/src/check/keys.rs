//! The keys of the objects a phenomenon is written with.

/// The keys of a phenomenon.
pub(super) const PHENOMENON: [&str; 10] = [
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
pub(super) const NODE: [&str; 5] = ["type", "version", "doc", "inputs", "editor"];

/// The keys of a parameter with numbers.
pub(super) const NUMERIC: [&str; 9] =
    ["type", "default", "min", "max", "soft_min", "soft_max", "unit", "doc", "editor"];
/// The keys of an integer.
pub(super) const INTEGER: [&str; 10] =
    ["type", "default", "min", "max", "soft_min", "soft_max", "unit", "doc", "editor", "values"];
/// The keys of an enumeration, whose range is that of its names.
pub(super) const ENUMERATION: [&str; 6] = ["type", "default", "values", "unit", "doc", "editor"];
/// The keys of a parameter of any type.
pub(super) const PARAMETER: [&str; 12] = [
    "type", "default", "min", "max", "soft_min", "soft_max", "unit", "doc", "editor", "values",
    "of", "members",
];
/// The keys of a parameter without an order.
pub(super) const PLAIN: [&str; 4] = ["type", "default", "doc", "editor"];
/// The keys of an array.
pub(super) const ARRAY: [&str; 5] = ["type", "of", "default", "doc", "editor"];
/// The keys of a struct.
pub(super) const STRUCT: [&str; 5] = ["type", "members", "default", "doc", "editor"];
