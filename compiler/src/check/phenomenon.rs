//! The check of one phenomenon.

use std::cell::OnceCell;
use std::rc::Rc;

use crate::diagnostics::{Code, Finding, shortened};
use crate::document::{Member, Object, Reader, Value, ValueKind};
use crate::graph::{Graph, Node, Parameter};
use crate::nodes::NodeLibrary;

use super::bind::Bound;
use super::draft::Draft;
use super::expressions::Rewritten;
use super::files::Files;
use super::inner::Inner;
use super::intervals::Intervals;
use super::nested::Nested;
use super::reachable::Named;
use super::used_phenomena::Known;
use super::{
    bind, cycles, dead_inputs, expand, expressions, hazards, interface, keys, loops, names, nodes,
    outputs, presets, ranges, reach, requirements, roots, stations, textures, types, unit_mistakes,
    used_phenomena,
};

/// What the check of a file rests on, besides the file.
#[derive(Clone, Copy)]
pub(super) struct Given<'g> {
    /// The node types there are.
    pub library: &'g NodeLibrary,
    /// Where files come from.
    pub files: &'g dyn Files,
    /// The files that were reached, as far as they are phenomena that can be used.
    pub checked: &'g [Option<Rc<Nested>>],
    /// Keeps what becomes of the expressions of the file and of each phenomenon in it.
    pub written: &'g [OnceCell<Rewritten>],
}

/// What a phenomenon says of itself.
struct Header {
    name: String,
    version: i32,
    doc: String,
}

/// Checks a file, which names other files, with all phenomena in it; the graph has no nested phenomena
/// any more.
pub(super) fn check<'d>(
    reader: &mut Reader<'d>,
    given: Given<'d>,
    named: &mut Named,
) -> Option<Nested> {
    let root = &reader.document.root;
    if !is_graph(reader, root) || !reader.reads_format(root) {
        return None;
    }
    // Keys that stand twice were told: what stands below the second is not known.
    let unresolved = reader.findings.has_errors();
    let mut inner = Inner::of(reader, root);
    let mut check = |reader: &mut Reader<'d>, inner: &Inner<'d>, at: usize| {
        check_one(reader, Standing { given, inner, at, unresolved }, named)
    };
    inner.check(reader, &mut check);
    let phenomenon = check(reader, &inner, 0);
    // A name that is misspelt may be meant for what seems unused.
    if !reader.findings.iter().any(|finding| finding.code == Code::UNKNOWN_PHENOMENON) {
        inner.report_unused(reader);
    }
    phenomenon.filter(|_| !reader.findings.has_errors())
}

/// Where a phenomenon stands.
#[derive(Clone, Copy)]
struct Standing<'i, 'd> {
    given: Given<'d>,
    inner: &'i Inner<'d>,
    /// Its position there: 0 for the file.
    at: usize,
    /// Whether something of the file is not known.
    unresolved: bool,
}

/// Checks a phenomenon, those that it uses being checked.
fn check_one<'d>(
    reader: &mut Reader<'d>,
    standing: Standing<'_, 'd>,
    named: &mut Named,
) -> Option<Nested> {
    let before = reader.findings.errors();
    let Standing { given, inner, at, unresolved } = standing;
    let (value, member) = inner.declaration(at);
    let (section, what) = match member {
        None => (&keys::PHENOMENON, keys::PHENOMENON.what.to_owned()),
        Some(member) => (&keys::INNER, format!("the phenomenon `{}`", shortened(&member.key))),
    };
    let known = Known { named, files: given.checked, inner, scope: at };
    let written = expressions::write_out(reader, value, given.library, known);
    let told = reader.findings.iter().count();
    let written = written.zip(given.written.get(at));
    let written = written.map(|(written, kept)| kept.get_or_init(|| written));
    let value = written.map_or(value, |written| &written.root);
    let object = reader.object(value, &what, &section.names())?;
    let header = read_header(reader, &object, member);
    let mut draft = Draft::new(given.library, unresolved || reader.findings.errors() > before);
    draft.written = written;
    let nodes = object.optional("nodes");
    let known = Known { named, files: given.checked, inner, scope: at };
    used_phenomena::declare(reader, nodes, &mut draft, known);
    interface::read(reader, object.optional("interface"), &mut draft);
    nodes::read(reader, nodes, &mut draft)?;
    outputs::read(reader, object.optional("outputs"), &mut draft);
    roots::read(reader, value, object.optional("roots"), &mut draft);
    let order = cycles::order(reader, &draft);
    let types = types::resolve(&draft, &order);
    let bound = bind::bind(reader, value, &draft, &types);
    let requirements = requirements::check(reader, object.optional("requires"), &draft);
    let outside_loops = loops::check(reader, &draft);
    stations::check(reader, &draft);
    reach::check(reader, &draft);
    let ruled_out = check_values(reader, &draft, &bound.nodes, &order);
    textures::check(reader, given.files);
    let parameters: Option<Vec<Parameter>> =
        draft.parameters.iter_mut().map(|given| given.parameter.take()).collect();
    let Header { name, version, doc } = header;
    if let Some(written) = written {
        written.mend_fixes(&mut reader.findings, told);
    }
    let expressions = written.map_or(Vec::new(), |written| written.expressions.clone());
    let Bound { nodes, roots, outputs } = bound;
    let (library, parameters) = (given.library.clone(), parameters?);
    #[rustfmt::skip]
    let graph = Graph {
        library, name, doc, version, requirements, parameters, presets: Vec::new(), nodes, roots, outputs, ruled_out, expressions,
    };
    // Those of a phenomenon within the file are told to be no key of it.
    let presets = object.optional("presets").filter(|_| member.is_none());
    let presets = presets::read(reader, presets, &graph, given.files);
    let mut uses = draft.phenomena.values().chain(draft.inner.values());
    if uses.any(Option::is_none) || reader.findings.errors() > before {
        return None;
    }
    let graph = Graph { presets, ..graph };
    let graph = match draft.nested.is_empty() {
        true => graph,
        false => expand::expand(reader, value, &draft, graph)?,
    };
    let shapes = draft.compounds.drain(..).filter(|(name, _)| !name.contains(['.', '[']));
    Some(Nested::new(graph, draft.depth, outside_loops, shapes.collect()))
}

/// What it says of itself; one within a file is named by its key.
fn read_header<'d>(
    reader: &mut Reader<'d>,
    object: &Object<'d>,
    member: Option<&'d Member>,
) -> Header {
    let name = match member {
        Some(member) => Some(member.key.as_str()),
        None => object.optional("phenomenon").and_then(|value| {
            let name = reader.string(value, "the name of the phenomenon")?;
            names::check_name(reader, value, "the name of the phenomenon", name);
            Some(name)
        }),
    };
    let version = object
        .optional("version")
        .and_then(|value| reader.integer(value, "`version`", 0..=i32::MAX));
    let doc = object.optional("doc").and_then(|value| reader.string(value, "`doc`"));
    if let (Some(value), None) = (object.optional("$schema"), member) {
        reader.string(value, "`$schema`");
    }
    Header {
        name: name.unwrap_or_default().to_owned(),
        version: version.unwrap_or_default(),
        doc: doc.unwrap_or_default().to_owned(),
    }
}

/// Checks what values the nodes come to have; yields the inputs that are never asked for.
fn check_values(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    nodes: &[Node],
    order: &[usize],
) -> Vec<(usize, usize)> {
    let intervals = Intervals::of(draft, nodes, order);
    let told = unit_mistakes::check(reader, draft);
    ranges::check(reader, draft, &intervals, &told);
    hazards::check(reader, draft, &intervals);
    dead_inputs::check(reader, draft, &intervals);
    intervals.ruled_out()
}

/// Whether the document is meant as a graph; a finding if not.
fn is_graph(reader: &mut Reader<'_>, root: &Value) -> bool {
    let (message, help) = match &root.kind {
        ValueKind::Object(_) if root.get("phenomenon").is_some() => return true,
        ValueKind::Object(_) if root.get("scene").is_some() => (
            "this file is a scene, not a phenomenon".to_owned(),
            "give it where a scene is wanted, or one of the materials it names here",
        ),
        ValueKind::Object(_) => (
            "a phenomenon lacks the key `phenomenon`, its name".to_owned(),
            "add `\"phenomenon\": \"name\"`",
        ),
        _ => (
            format!("a phenomenon is an object, not {}", root.describe()),
            "start with `{ \"phenomenon\": \"name\" … }`",
        ),
    };
    let place = reader.document.place_of_bytes(root.start, root.start + 1);
    reader.findings.push(Finding::new(Code::NOT_A_GRAPH, place, message, help));
    // An object that only lacks its name is still worth checking.
    matches!(root.kind, ValueKind::Object(_)) && root.get("scene").is_none()
}
