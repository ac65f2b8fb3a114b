//! The tables, and the questions asked of them.

use std::collections::HashSet;
use std::sync::LazyLock;

use super::table::{Called, Synonym, Table, folded};

/// Nodes.
pub static NODES: LazyLock<Table> =
    LazyLock::new(|| Table::new(include_str!("nodes.txt"), include_str!("absent.txt")));
/// Types of values.
pub static TYPES: LazyLock<Table> =
    LazyLock::new(|| Table::new(include_str!("types.txt"), include_str!("absent_types.txt")));
/// Inputs of nodes. A foreign name may mean several of ours; a node mostly has one of them only.
pub static INPUTS: LazyLock<Table> = LazyLock::new(|| Table::new(include_str!("inputs.txt"), ""));
/// Outputs of nodes, fields of the state among them.
pub static OUTPUTS: LazyLock<Table> = LazyLock::new(|| Table::new(include_str!("outputs.txt"), ""));
/// Keys of objects, in graphs and in scenes.
pub static KEYS: LazyLock<Table> = LazyLock::new(|| Table::new(include_str!("keys.txt"), ""));
/// Kinds of roots.
pub static ROOTS: LazyLock<Table> = LazyLock::new(|| Table::new(include_str!("roots.txt"), ""));

/// Names of several nodes each, on purpose: more than one of ours may be meant.
pub const SEVERAL: &[&str] = &[
    "constant",
    "const",
    "magnitude",
    "projection",
    "mib_texture_vector",
    "triplanar",
    "shift_along_surface",
    "box_mapping",
    "box_projection",
    "hex_tiling",
    "fresnel",
    "trace",
    "split",
    "extract",
    "separate",
    "separate3",
    "unpack",
    "swizzle",
    "combine",
    "vector_transform",
    "transformmatrix",
    "atan",
    "saturate",
    "hsl",
    "lighten",
    "darken",
    "difference",
];

/// What the name of a node of another program means here; none where it is not known.
pub fn node(name: &str) -> Option<Synonym> {
    let found = |name: &str| NODES.find(name, |_| true);
    found(name).or_else(|| {
        // `ND_mix_color3`, `mix_float`: MaterialX names its definitions with their types.
        let bare = name.strip_prefix("ND_").unwrap_or(name);
        let (front, last) = bare.rsplit_once('_')?;
        let last = folded(last);
        let is_type = TYPES.called.iter().any(|row| {
            std::iter::once(row.ours).chain(row.names()).any(|known| folded(known) == last)
        });
        let front = if is_type { front } else { bare };
        match NODES.called.iter().find(|row| row.ours == front) {
            Some(row) => Some(Synonym { ours: vec![row.ours], exact: false, advice: "" }),
            None => found(front).map(|synonym| Synonym { exact: false, ..synonym }),
        }
    })
}

/// The names other programs have for a node of ours.
pub fn of_node(ours: &str) -> impl Iterator<Item = &'static str> + use<> {
    let row = NODES.called.iter().find(|row| row.ours == ours);
    row.into_iter().flat_map(Called::names)
}

/// What else the name of a node of ours means in other programs, such as `gain`.
pub fn also(ours: &str) -> impl Iterator<Item = &'static str> + use<> {
    let rows = include_str!("also.txt").lines().filter(|line| !line.starts_with("# "));
    let mut rows = rows.filter_map(|line| line.split_once(" | "));
    let row = rows.find(|(name, _)| *name == ours);
    row.into_iter().flat_map(|(_, others)| others.split_whitespace())
}

/// What the name of a type of another program means here; none where it is not known.
pub fn value_type(name: &str) -> Option<Synonym> {
    TYPES.find(name, |_| true)
}

/// What a foreign name of an input means among those a node has.
pub fn input(name: &str, has: impl Fn(&str) -> bool) -> Option<Synonym> {
    INPUTS.find(name, has)
}

/// What a foreign name of an output means among those a node has.
pub fn output(name: &str, has: impl Fn(&str) -> bool) -> Option<Synonym> {
    OUTPUTS.find(name, has)
}

/// What a foreign key means among those an object may have.
pub fn key(name: &str, has: impl Fn(&str) -> bool) -> Option<Synonym> {
    KEYS.find(name, has)
}

/// What the name of a kind of shader of another program means among our roots.
pub fn root(name: &str) -> Option<Synonym> {
    ROOTS.find(name, |_| true)
}

/// Whether a word means something somewhere: here, or in a program that others come from. Such a word
/// is not misspelt, so it is never changed into another one.
pub fn is_word(name: &str) -> bool {
    static WORDS: LazyLock<HashSet<String>> = LazyLock::new(|| {
        let tables = [&NODES, &TYPES, &INPUTS, &OUTPUTS, &KEYS, &ROOTS];
        let rows = tables.iter().flat_map(|table| &table.called);
        let called = rows.flat_map(|row| std::iter::once(row.ours).chain(row.names()));
        let absent = tables.iter().flat_map(|table| &table.absent).flat_map(|row| &row.names);
        called.chain(absent.copied()).map(str::to_lowercase).collect()
    });
    WORDS.contains(&name.to_lowercase())
}
