//! The names of the nodes of others, program by program, with what we have for each: a node, several, something that is
//! no node, or nothing and why. `docs/coverage.md` shows the lists, and whoever looks for one of the names is told.

use super::synonyms::folded;

/// The names of one program.
#[derive(Clone, Copy, Debug)]
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
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Whose it is.
    pub of: &'static str,
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

impl List {
    /// What it is of: its first line.
    ///
    /// # Panics
    /// If it has none.
    pub fn heading(self) -> &'static str {
        self.text.lines().next().and_then(|line| line.strip_prefix("# ")).expect("a heading")
    }

    /// Its lines.
    ///
    /// # Panics
    /// If one cannot be read.
    pub fn entries(self) -> impl Iterator<Item = Entry> {
        let lines = self.text.lines().filter(|line| !line.starts_with("# "));
        lines.map(move |line| {
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
            Entry { of: self.title, name, group, have, what }
        })
    }
}

impl Entry {
    /// What it says between backticks: names of ours, mostly nodes.
    pub fn named(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.what.split('`').skip(1).step_by(2)
    }

    /// What we have for it, as a sentence.
    pub fn answer(&self) -> String {
        let Self { of, name, what, .. } = self;
        let none = if matches!(self.have, Have::No | Have::Later) { "there is none; " } else { "" };
        format!("{of}'s `{name}`: {none}{what}")
    }
}

/// What there is for a name, program by program; case, `_`, `-`, `:` and spaces make no difference.
pub fn called(name: &str) -> Vec<Entry> {
    let plain = |name: &str| folded(&name.replace(':', ""));
    let name = plain(name);
    LISTS.iter().flat_map(|list| list.entries()).filter(|it| plain(it.name) == name).collect()
}
