//! The reference page of the nodes, written from their list.

use std::fmt::Write;
use std::ops::RangeInclusive;

use crate::state::Iterated;
use crate::values::Type;

use super::{
    Avoid, DefaultValue, Definition, FINITE, Implied, Input, Kind, NOT_NEGATIVE, NodeLibrary,
    Signature,
};

/// Groups of nodes that are seen rather than read about.
const PICTURED: &[&str] = &["color", "noise", "patterns", "ramps", "shading", "textures"];

/// Whether the page shows a picture of a node: `pictures/nodes/NAME.png`, rendered by the test
/// `node_pictures`.
pub fn is_pictured(signature: &Signature) -> bool {
    PICTURED.contains(&signature.group) || signature.name == "texture_lookup"
}

/// `docs/nodes.md`: every node of `library` in Markdown, by group.
pub fn reference(library: &NodeLibrary) -> String {
    let mut page = String::from(
        "# Nodes\n\nWritten from the list of nodes by `compiler/src/nodes/reference.rs`; a test holds \
         the two together.\n`PHENOMENON_BLESS=1 cargo test -p phenomenon-compiler reference` writes \
         it anew. How to add one: [adding-a-node.md](adding-a-node.md).\n\nAn input without a default \
         must be given. An input *demanded only where …* is not evaluated elsewhere.\nRanges hold per \
         component (of a colour: red, green and blue) for the values that arrive.\n",
    );
    page.push_str("`phenomenon nodes --search WORD` finds nodes by what they do and by what others call them.\n");
    page.push_str(
        "Pictures of nodes that change a colour show it above, and below what becomes of it.\n\n",
    );
    for group in library.groups() {
        let nodes = library.iter().map(|(_, definition)| &definition.signature);
        let nodes = nodes.filter(|node| node.group == group.name);
        let links: Vec<String> = nodes.map(|node| format!("[{0}](#{0})", node.name)).collect();
        let _ = writeln!(page, "* [**{0}**](#{0}): {1}", group.name, links.join(", "));
    }
    for group in library.groups() {
        let _ = write!(page, "\n## {}\n\n{}\n", group.name, group.doc);
        for (_, definition) in library.iter() {
            if definition.signature.group == group.name {
                write_node(&mut page, definition);
            }
        }
    }
    page
}

fn write_node(page: &mut String, definition: &Definition) {
    let signature = &definition.signature;
    let _ = write!(page, "\n### {}\n\n", signature.name);
    if is_pictured(signature) {
        let name = &signature.name;
        let _ = write!(page, "![What `{name}` looks like](pictures/nodes/{name}.png)\n\n");
    }
    let _ = writeln!(page, "{}", signature.doc);
    let _ = write!(page, "{}{}", kind(signature), types(definition));
    if !signature.inputs.is_empty() {
        page.push_str(
            "\n| input | type | default | range | meaning |\n| --- | --- | --- | --- | --- |\n",
        );
    }
    for input in &signature.inputs {
        let mut doc = cell(&input.doc);
        if input.guarded {
            doc.push_str(" *Demanded only where it shows.*");
        }
        if input.scoped {
            doc.push_str(" *Evaluated inside.*");
        }
        if !input.choices.is_empty() {
            let _ = write!(doc, " One of `{}`.", input.choices.join("`, `"));
        }
        if let Some(Implied { scope, of, slope }) = input.implied {
            let what = if slope { "how it changes" } else { "its value" };
            let _ = write!(doc, " Where `{of}` is connected, {what} under [`{scope}`](#{scope}).");
        }
        if !input.unit.is_empty() {
            let _ = write!(doc, " *In {}.*", input.unit);
        }
        if input.fixed {
            doc.push_str(" *Known before shading.*");
        }
        match input.avoid {
            Some(Avoid::Zero) => doc.push_str(" *Should not be 0.*"),
            Some(Avoid::Negative) => doc.push_str(" *Should not be negative.*"),
            None => {}
        }
        let _ = writeln!(
            page,
            "| `{}` | {} | {} | {} | {doc} |",
            input.name,
            cell(&type_name(definition, input.value_type)),
            default(&input.default),
            usual_range(input),
        );
    }
    if let Some(list) = &signature.or_list {
        let (name, doc) = (&list.name, cell(&list.doc));
        let of = cell(&type_name(definition, list.value_type));
        let _ = writeln!(page, "| `{name}` | list of {of} |  |  | {doc} |");
    }
    page.push_str("\n| output | type | range | meaning |\n| --- | --- | --- | --- |\n");
    for output in &signature.outputs {
        let _ = writeln!(
            page,
            "| `{}` | {} | {} | {} |",
            output.name,
            cell(&type_name(definition, output.value_type)),
            range(&output.range, output.value_type.is_numeric()),
            cell(&output.doc),
        );
    }
    if !signature.source.is_empty() {
        let _ = write!(page, "\nSource: {}.\n", signature.source);
    }
}

/// What a reader must know of how it is evaluated.
fn kind(signature: &Signature) -> String {
    let names = |fields: &[crate::state::Field]| {
        let names: Vec<String> = fields.iter().map(|field| format!("`{}`", field.name())).collect();
        names.join(", ")
    };
    match &signature.kind {
        Kind::Request(effect) => format!("\nAsks the renderer: effect `{}`.\n", effect.name()),
        Kind::Scope(fields) => format!("\nChanges, for its scoped input: {}.\n", names(fields)),
        Kind::Loop(Iterated::Lights, _) => "\nA loop over light samples.\n".into(),
        Kind::Loop(Iterated::Samples, _) => "\nA loop over samples.\n".into(),
        Kind::List(_) => {
            "\nTakes a list of any length: `[value, …]` or an array of the interface.\n".into()
        }
        Kind::Plain | Kind::Fields(_) => String::new(),
    }
}

/// What `generic` stands for, where that is not every type it may stand for.
fn types(definition: &Definition) -> String {
    let types: Vec<&str> =
        definition.overloads.iter().filter_map(|form| Some(form.generic?.name())).collect();
    // Where there are others, each input and output tells.
    let told = !definition.signature.generic.iter().all(|of| Type::GENERIC.contains(of));
    if types.is_empty() || types.len() == Type::GENERIC.len() || told {
        return String::new();
    }
    format!("\nIts values are of the types {} only.\n", types.join(" and "))
}

/// The type of an input or an output; what `generic` stands for where that is more than numbers, vectors
/// and colours.
fn type_name(definition: &Definition, value_type: Type) -> String {
    let generic = &definition.signature.generic;
    if value_type != Type::Generic || generic.iter().all(|of| Type::GENERIC.contains(of)) {
        return value_type.name().into();
    }
    generic.iter().map(|of| of.name()).collect::<Vec<_>>().join(" | ")
}

/// The range, and what is usual within it.
fn usual_range(input: &Input) -> String {
    let range_of = |of| range(of, input.value_type.is_numeric());
    match input.narrower() {
        Some(soft) => format!("{}; usually {}", range_of(&input.range), range_of(soft)),
        None => range_of(&input.range),
    }
}

fn cell(text: &str) -> String {
    text.replace('\n', " ").replace('|', "\\|")
}

fn default(default: &DefaultValue) -> String {
    match default {
        DefaultValue::Required => String::new(),
        DefaultValue::Literal(literal) => format!("`{literal}`"),
        DefaultValue::State(field) => format!("state: `{}`", field.name()),
        DefaultValue::Node(name) => format!("[`{name}`](#{name})"),
    }
}

fn range(range: &RangeInclusive<f64>, shown: bool) -> String {
    if !shown {
        return String::new();
    }
    if *range == FINITE {
        return "finite".into();
    }
    if *range == NOT_NEGATIVE || *range == (0.0..=f64::from(i32::MAX)) {
        return "0 or more".into();
    }
    format!("{} to {}", bound(*range.start()), bound(*range.end()))
}

/// A bound as people write it.
fn bound(value: f64) -> String {
    let rounded = value as f32;
    if value == f64::INFINITY {
        "infinity".into()
    } else if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checked_in_reference_is_in_sync() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/nodes.md");
        let page = reference(&NodeLibrary::standard());
        if std::env::var_os("PHENOMENON_BLESS").is_some() {
            std::fs::write(path, &page).expect("the page can be written");
        }
        let checked_in = std::fs::read_to_string(path).unwrap_or_default();
        assert!(
            checked_in == page,
            "docs/nodes.md does not show the nodes as they are: run \
             `PHENOMENON_BLESS=1 cargo test -p phenomenon-compiler reference`"
        );
    }

    #[test]
    fn every_node_has_its_heading_once() {
        let library = NodeLibrary::standard();
        let page = reference(&library);
        for (_, definition) in library.iter() {
            let heading = format!("\n### {}\n", definition.signature.name);
            assert_eq!(page.matches(&heading).count(), 1, "{heading}");
        }
        let headings = page.matches("\n### ").count();
        assert_eq!(headings, library.iter().count());
    }

    #[test]
    fn cells_and_bounds() {
        assert_eq!(cell("a | b\nc"), "a \\| b c");
        assert_eq!(range(&(-1.0..=1.0), true), "-1 to 1");
        assert_eq!(range(&(0.0..=1e19), true), "0 to 1e19");
        assert_eq!(range(&(0.0..=f64::INFINITY), true), "0 to infinity");
        assert_eq!(range(&NOT_NEGATIVE, true), "0 or more");
        assert_eq!(range(&(0.0..=f64::from(i32::MAX)), true), "0 or more");
        assert_eq!(range(&FINITE, true), "finite");
        assert_eq!(range(&FINITE, false), "");
    }
}
