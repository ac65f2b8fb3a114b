//! The lists of names.

/// The names of one program.
#[derive(Clone, Copy)]
pub struct List {
    /// Whose they are.
    pub title: &'static str,
    /// A line for each.
    text: &'static str,
}

/// What we have for a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Have {
    /// A node.
    Node,
    /// Several nodes together.
    Made,
    /// Something that is no node: a root, a literal, the scene.
    Other,
    /// Nothing, on purpose.
    No,
    /// Nothing yet.
    Later,
}

/// A name, and what we have for it.
pub struct Entry {
    /// The name.
    pub name: &'static str,
    /// The group it stands in there.
    pub group: &'static str,
    /// What we have.
    pub have: Have,
    /// Which, or why not.
    pub what: &'static str,
}

/// The lists, in the order of the page.
pub const LISTS: [List; 4] = [
    List { title: "MaterialX", text: include_str!("materialx.txt") },
    List { title: "Open Shading Language", text: include_str!("osl.txt") },
    List { title: "mental ray", text: include_str!("mental_ray.txt") },
    List { title: "Blender", text: include_str!("blender.txt") },
];

/// What a list is of: its first line.
pub fn heading(list: List) -> &'static str {
    list.text.lines().next().and_then(|line| line.strip_prefix("# ")).expect("a heading")
}

/// The lines of a list.
///
/// # Panics
/// If one cannot be read.
pub fn entries(list: List) -> Vec<Entry> {
    let lines = list.text.lines().filter(|line| !line.starts_with("# "));
    lines
        .map(|line| {
            let columns: Vec<&str> = line.split(" | ").collect();
            let [name, group, have, what] = columns[..] else { panic!("four columns: {line}") };
            let have = match have {
                "node" => Have::Node,
                "made" => Have::Made,
                "other" => Have::Other,
                "no" => Have::No,
                "later" => Have::Later,
                _ => panic!("node, made, other, no or later: {line}"),
            };
            Entry { name, group, have, what }
        })
        .collect()
}
