//! The page.

use std::fmt::Write;

use phenomenon_compiler::diagnostics::peers::{Entry, Have, LISTS};

use crate::is_pattern;

/// What stands above the tables.
const HEAD: &str = "\
# What we have of the nodes of others

Made from the lists in `compiler/src/diagnostics/peers`, which a test holds to the library;
`PHENOMENON_BLESS=1 cargo test --workspace --test coverage` writes it anew. What a name means here is also told by
`phenomenon nodes --search NAME`. `compiler/tests/materialx` runs what MaterialX computes.

## Types

MaterialX has types that we lack, on purpose: each further type multiplies the compiled forms of every generic node and
the words an author must choose between, and no material needs one.

| theirs | here |
| --- | --- |
| vector2 | `vector` with z = 0; uv stand in x and y |
| vector4 | `vector` and a scalar beside it; noise of four dimensions takes the fourth as an input of its own |
| color3, color4 | `color`, which has four components; arithmetic keeps the alpha of the left operand, and only the nodes of the group compositing compute with it |
| matrix33 | `transform` without translation |
| matrix44 | `transform`, which is affine |
| surfaceshader, BSDF, EDF, VDF | colours: a node traces its rays and is given their light, so layers are `mix` and `add` |
| displacementshader, volumeshader, lightshader, material | roots of a phenomenon |
| filename | `texture` |
| arrays | lists of any length, given in the file |
";

fn mark(have: Have) -> &'static str {
    match have {
        Have::Node => "node",
        Have::Made => "made of nodes",
        Have::Other => "no node",
        Have::No => "no",
        Have::Later => "not yet",
    }
}

/// The whole page.
pub fn page() -> String {
    let mut page = HEAD.to_owned();
    page.push_str(
        "\n## Counts\n\n| of | names | a node | made of nodes | no node | no | not yet |\n",
    );
    page.push_str("| --- | --- | --- | --- | --- | --- | --- |\n");
    for list in LISTS {
        counts(&mut page, list.title, &list.entries().collect::<Vec<_>>());
        if list.title == "MaterialX" {
            let patterns: Vec<_> = list.entries().filter(is_pattern).collect();
            counts(&mut page, "MaterialX: nodes that compute values", &patterns);
        }
    }
    for list in LISTS {
        let _ = write!(page, "\n## {}\n\n{}\n", list.title, list.heading());
        let mut group = "";
        for entry in list.entries() {
            if entry.group != group {
                group = entry.group;
                let _ = write!(page, "\n| {group} | here | |\n| --- | --- | --- |\n");
            }
            let name = entry.name.split_once(':').map_or(entry.name, |(_, mode)| mode);
            let _ = writeln!(page, "| {} | {} | {} |", name, mark(entry.have), entry.what);
        }
    }
    page
}

fn counts(page: &mut String, title: &str, entries: &[Entry]) {
    let _ = write!(page, "| {title} | {} |", entries.len());
    for have in [Have::Node, Have::Made, Have::Other, Have::No, Have::Later] {
        let _ = write!(page, " {} |", entries.iter().filter(|entry| entry.have == have).count());
    }
    page.push('\n');
}
