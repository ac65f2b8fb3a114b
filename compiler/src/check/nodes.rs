//! Reading `nodes`: types, inputs and connections by name.

use std::collections::{HashMap, HashSet};

use crate::diagnostics::synonyms::{self, Synonym};
use crate::diagnostics::{Advice, Code, Finding, is_near, listed, listed_or, shortened};
use crate::document::{Member, Reader, Value, ValueKind};
use crate::nodes::{NodeType, Signature};

use super::draft::{Draft, DraftInput, DraftNode};
use super::inner::inner_of;
use super::keys::NODE_KEYS;
use super::limits::MAX_NODES;
use super::names::check_key_as;
use super::reachable::file_of;
use super::references::quoted;
use super::shape::Shape;
use super::turns::{self, Form, form_of, is_implied, written_name};
use super::{compounds, sources};

/// Reads all nodes, then their inputs, which may name any of them. None where there are too many.
pub(super) fn read<'d>(
    reader: &mut Reader<'d>,
    value: Option<&'d Value>,
    draft: &mut Draft<'d>,
) -> Option<()> {
    let Some(value) = value else { return Some(()) };
    let Some(members) = reader.members(value, "`nodes`") else { return Some(()) };
    let members: Vec<&Member> = members.collect();
    if members.len() > MAX_NODES {
        let message = format!("a graph has at most {MAX_NODES} nodes, this one {}", members.len());
        reader.report(Code::TOO_MANY_NODES, value, message, "split it into several phenomena");
        return None;
    }
    for (at, member) in members.iter().enumerate() {
        if !draft.is_written(&member.key) {
            let name = match is_implied(reader.document, member) {
                true => written_name(&member.key),
                false => &member.key,
            };
            check_key_as(reader, member, "the name of a node", name);
        }
        draft.node_names.insert(&member.key, at);
        let node_type = read_header(reader, member, draft);
        draft.nodes.push(DraftNode { member, node_type, inputs: Vec::new() });
    }
    for (at, member) in members.iter().enumerate() {
        if let Some(value) = member.value.get("inputs") {
            draft.nodes[at].inputs = read_inputs(reader, value, draft, at);
        }
    }
    Some(())
}

/// Checks the keys of a node and finds its type.
fn read_header<'d>(
    reader: &mut Reader<'d>,
    member: &'d Member,
    draft: &Draft<'d>,
) -> Option<NodeType> {
    let what = || format!("node `{}`", shortened(written_name(&member.key)));
    let mut node_type = None;
    let mut has_type = false;
    let mut version = None;
    let mut unknown = Vec::new();
    let members = reader.members(&member.value, "a node")?;
    for part in members {
        match part.key.as_str() {
            "type" => {
                has_type = true;
                node_type = read_type(reader, &part.value, draft);
            }
            "doc" => {
                reader.string(&part.value, "`doc`");
            }
            "version" => {
                version = reader
                    .integer(&part.value, "`version`", 0..=i32::MAX)
                    .map(|it| (it, &part.value))
            }
            "inputs" | "editor" => {}
            _ => unknown.push(part),
        }
    }
    if has_type {
        unknown_keys(reader, draft, member, node_type, unknown);
    } else if !type_as_key(reader, draft, member, &unknown) {
        unknown_keys(reader, draft, member, None, unknown);
        reader.missing(&member.value, &what(), "type");
    }
    if let (Some(node_type), Some((version, value))) = (node_type, version) {
        check_version(reader, draft, node_type, version, value);
    }
    let list = &draft.node_types.signature(node_type?).or_list;
    let inputs = member.value.get("inputs");
    match list.as_ref().and_then(|list| inputs?.get(&list.name)) {
        Some(_) => draft.node_types.over_list(node_type?),
        None => node_type,
    }
}

/// Reports a node without `type` that says what it is by a key that belongs into one, or is an expression; false
/// where it is none of these.
fn type_as_key(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    node: &Member,
    unknown: &[&Member],
) -> bool {
    let says_what_it_is = |key: &str| {
        ["expression", "phenomenon", "file"].contains(&key) || Form::of_name(key).is_some()
    };
    let Some(key) = unknown.iter().find(|member| says_what_it_is(&member.key)) else {
        return false;
    };
    // What it names or connects is not looked at where it stands.
    draft.unresolved.set(true);
    let name = shortened(&node.key);
    let (message, help) = match (key.key.as_str(), &key.value.kind) {
        ("expression", _) => (
            format!("node `{name}` is an expression, which is no node"),
            "write it where it is used, or as the `value` of a `constant_scalar`, `constant_vector` or \
             `constant_color`"
                .to_owned(),
        ),
        (form, ValueKind::String(of)) => (
            format!("node `{name}` has `{form}` in the place of its `type`"),
            format!("write `\"type\": {{ \"{form}\": {} }}`", shortened(&quoted(of))),
        ),
        (form, _) => (
            format!("node `{name}` has `{form}` in the place of its `type`"),
            format!("write `\"type\": {{ \"{form}\": … }}`"),
        ),
    };
    reader.report_key(Code::MISSING_KEY, key, message, help);
    true
}

/// Reports the keys a node does not have. Those that are inputs of its type stand a level too high, which
/// is one mistake.
fn unknown_keys<'d>(
    reader: &mut Reader<'d>,
    draft: &Draft<'d>,
    node: &'d Member,
    node_type: Option<NodeType>,
    unknown: Vec<&'d Member>,
) {
    let signature = node_type.map(|node_type| draft.node_types.signature(node_type));
    let inputs = node.value.get("inputs");
    let is_input = |member: &Member| match signature {
        Some(signature) => {
            let key = &member.key;
            signature.input(key).is_some()
                || synonyms::input(key, |name| signature.input(name).is_some()).is_some()
                    && synonyms::key(key, |ours| NODE_KEYS.contains(&ours)).is_none()
        }
        // Of a type that is not known nothing but inputs can be meant.
        None => inputs.is_none() && !NODE_KEYS.iter().any(|key| is_near(&member.key, key)),
    };
    let (misplaced, others): (Vec<&Member>, Vec<&Member>) =
        unknown.into_iter().partition(|member| is_input(member));
    let name = shortened(&node.key);
    for member in others {
        reader.unknown_key(member, &format!("node `{name}`"), &NODE_KEYS);
    }
    let Some(first) = misplaced.first() else { return };
    // What they connect is not looked at where they stand.
    draft.unresolved.set(true);
    let names = || misplaced.iter().map(|member| member.key.as_str());
    let message = match misplaced.len() {
        1 => format!("node `{name}` has its input {} beside `type`", listed(names())),
        _ => format!("node `{name}` has its inputs {} beside `type`", listed(names())),
    };
    let form: Vec<String> =
        names().take(3).map(|key| format!("\"{}\": …", shortened(key))).collect();
    let help = match inputs {
        Some(_) => "move them into its `inputs`".to_owned(),
        None => format!("put them under `inputs`: `\"inputs\": {{ {} }}`", form.join(", ")),
    };
    reader.report_key(Code::UNKNOWN_KEY, first, message, help);
}

/// Version of every node type of the library.
const LIBRARY_VERSION: i32 = 1;

/// Reports a version that is not that of what is used; 0 asks for none.
fn check_version(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    node_type: NodeType,
    wanted: i32,
    value: &Value,
) {
    let nested = draft.nested.get(&node_type);
    let version = nested.map_or(LIBRARY_VERSION, |nested| nested.graph.version);
    if wanted == 0 || wanted == version {
        return;
    }
    let name = &draft.node_types.signature(node_type).name;
    let message = format!("`{name}` has version {version}, not {wanted}");
    let help = format!("check what changed in it, then write `\"version\": {version}`");
    reader.report(Code::VERSION_MISMATCH, value, message, help);
}

fn read_type<'d>(reader: &mut Reader<'d>, value: &'d Value, draft: &Draft<'d>) -> Option<NodeType> {
    if let Some(file) = file_of(value) {
        return draft.phenomena.get(file).copied().flatten();
    }
    // What is wrong with a map or a fold that was not written out was told.
    if form_of(value).is_some() {
        return None;
    }
    if let Some(name) = inner_of(value) {
        return draft.inner.get(name).copied().flatten();
    }
    if let (Some(name), None) = (value.get("phenomenon"), value.get("file")) {
        return reader.string(name, "`phenomenon`").and(None);
    }
    if matches!(value.kind, ValueKind::Object(_)) {
        let object = reader.object(value, "the type of a node", &["file"])?;
        let file = object.required(reader, "file")?;
        return reader.string(file, "`file`").and(None);
    }
    let name = reader.string(value, "the type of a node")?;
    let found = draft.node_types.library.find(name);
    if found.is_none() {
        let names: Vec<&str> =
            draft.node_types.library.iter().map(|(_, it)| &*it.signature.name).collect();
        // A library of another crate may lack what the tables name.
        let synonym = synonyms::node(name).filter(|found| {
            found.ours.iter().all(|ours| draft.node_types.library.find(ours).is_some())
        });
        let advice = match draft.inner.contains_key(name) {
            true => {
                let form = format!("{{ \"phenomenon\": {} }}", quoted(name));
                Advice { help: format!("write `{}`", shortened(&form)), fix: Some(form) }
            }
            false if Form::of_name(name).is_some() => Advice::from(format!(
                "write `{{ \"{name}\": {{ \"file\": … }} }}`, or `\"phenomenon\"` for one in this file"
            )),
            false => reader.advice(name, names.iter().copied(), synonym, || {
                "`phenomenon nodes` lists every type".into()
            }),
        };
        let message = format!("there is no node type `{}`", shortened(name));
        let place = reader.document.place(value);
        reader.findings.push(Finding::misspelt(Code::UNKNOWN_NODE_TYPE, place, message, advice));
    }
    found
}

/// Positions of the parameters of the phenomenon a node is.
fn signature_positions<'a>(
    draft: &'a Draft<'_>,
    node: usize,
) -> Option<&'a HashMap<String, usize>> {
    Some(&draft.nested.get(&draft.nodes[node].node_type?)?.positions)
}

/// Reports parts that are given by themselves and within a whole, which leaves open what counts.
fn check_given_twice(reader: &mut Reader<'_>, signature: &Signature, inputs: &[DraftInput<'_>]) {
    let mut given: HashMap<usize, &Member> = HashMap::new();
    let mut told: HashSet<usize> = HashSet::new();
    for input in inputs {
        let Some(at) = input.input.filter(|at| !signature.inputs[*at].list) else { continue };
        let Some(first) = given.insert(at, input.member) else { continue };
        if first.key_start != input.member.key_start && told.insert(input.member.key_start) {
            let part = shortened(&signature.inputs[at].name);
            let message = format!(
                "`{}` gives the part `{part}`, which `{}` gives too",
                shortened(&input.member.key),
                shortened(&first.key)
            );
            let place = reader.document.place_of_key(input.member);
            let finding = Finding::new(Code::DUPLICATE_KEY, place, message, "remove one of them");
            let first = reader.document.place_of_key(first);
            reader.findings.push(finding.with_related(first, "first given here"));
        }
    }
}

/// The array or struct an input of a phenomenon is.
fn shape_of<'a>(draft: &'a Draft<'_>, node: usize, member: &Member) -> Option<&'a Shape> {
    let nested = draft.nested.get(&draft.nodes[node].node_type?)?;
    nested.shapes.iter().find(|(name, _)| *name == member.key).map(|(_, shape)| shape)
}

/// Reports an input the node does not have.
fn unknown_input(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    node: usize,
    (signature, given): (&Signature, &[bool]),
    member: &Member,
) {
    let names = || signature.inputs.iter().map(|input| &*input.name);
    let near = reader.suggestions.nearest(&member.key, names());
    // What is given already is not meant once more.
    let is_given = |name: &str| signature.input(name).is_some_and(|at| given[at]);
    let is_free = |name: &str| signature.input(name).is_some() && !is_given(name);
    let mut advice = match synonyms::input(&member.key, is_free) {
        _ if let Some(help) = list_in_place(draft, node, member) => help.into(),
        // Whose `in1` is whose `fg`: the order of a mix is what others differ in.
        Some(Synonym { ours, .. }) if signature.name == "mix" && ours != ["weight"] => {
            let ours = listed_or(ours);
            Advice::from(format!(
                "did you mean {ours}? `a` is the background, there at `weight` 0, and `b` the foreground"
            ))
        }
        synonym => Advice::of(synonym, near, || match signature.inputs.is_empty() {
            true => "it has no inputs".into(),
            false => format!("its inputs are {}", listed(names())),
        }),
    };
    if near.is_some_and(|near| is_given(near.name)) {
        advice.fix = None;
    }
    let place = reader.document.place_of_key(member);
    let message = format!("{} has no input `{}`", draft.described(node), shortened(&member.key));
    reader.findings.push(Finding::misspelt(Code::UNKNOWN_INPUT, place, message, advice));
}

/// Reports what each turn of a map or a fold is given and its body does not take.
fn lacks_own(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    node: usize,
    signature: &Signature,
    member: &Member,
) {
    let (key, body) = (&member.key, shortened(&signature.name));
    let message = format!(
        "node `{}` gives its body `{body}` the parameter `{key}`, which that does not have",
        draft.told_name(node)
    );
    let help = format!(
        "declare it there: `\"interface\": {{ \"{key}\": {{ \"type\": …, \"default\": … }} }}`"
    );
    reader.report_key(Code::UNKNOWN_INPUT, member, message, help);
}

/// What to do about an input that a node does not have for the list it takes, or might.
fn list_in_place(draft: &Draft<'_>, node: usize, member: &Member) -> Option<String> {
    let signature = draft.node_types.signature(draft.nodes[node].node_type?);
    if let Some(list) = &signature.or_list {
        let numbered = member.key.ends_with(|last: char| last.is_ascii_digit());
        return numbered
            .then(|| format!("give any number of values as `\"{}\": [ … ]`", list.name));
    }
    let of_library = draft.node_types.signature(draft.node_types.library.find(&signature.name)?);
    let list = of_library.or_list.as_ref()?;
    of_library.input(&member.key)?;
    Some(format!("its values are those of `{}`: move it there", list.name))
}

fn read_inputs<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    draft: &Draft<'d>,
    node: usize,
) -> Vec<DraftInput<'d>> {
    let Some(members) = reader.members(value, "`inputs`") else { return Vec::new() };
    let signature = draft.nodes[node].node_type.map(|it| draft.node_types.signature(it));
    let mut has_parts = false;
    let mut inputs = Vec::new();
    // Which inputs are given at all, once it matters.
    let mut given: Option<Vec<bool>> = None;
    for member in members {
        let input = signature.and_then(|signature| signature.input(&member.key));
        let what = || format!("input `{}` of {}", shortened(&member.key), draft.described(node));
        if let (Some(at), Some(signature)) = (input, signature)
            && signature.inputs[at].list
        {
            let values = compounds::list(reader, draft, &member.value, &what());
            inputs.extend(values.into_iter().map(|source| DraftInput { member, input, source }));
            continue;
        }
        if let (None, Some(shape)) = (input, shape_of(draft, node, member)) {
            let given = (&member.value, member.key.as_str());
            let parts = compounds::spread(reader, draft, shape, given, &what());
            has_parts = true;
            let nested = signature_positions(draft, node);
            for (part, source) in parts {
                let input = nested.and_then(|positions| positions.get(&part).copied());
                inputs.push(DraftInput { member, input, source });
            }
            continue;
        }
        let implied = input.is_none() && is_implied(reader.document, member);
        if implied && member.key == turns::INDEX {
            continue;
        }
        if let Some(signature) = signature
            && implied
        {
            lacks_own(reader, draft, node, signature, member);
        } else if let Some(signature) = signature
            && input.is_none()
        {
            let given = given.get_or_insert_with(|| {
                let mut given = vec![false; signature.inputs.len()];
                for at in value.members().iter().filter_map(|it| signature.input(&it.key)) {
                    given[at] = true;
                }
                given
            });
            unknown_input(reader, draft, node, (signature, given), member);
        }
        let source = sources::read(reader, &member.value, draft);
        inputs.push(DraftInput { member, input, source });
    }
    // Only parts of arrays and structs can be given in two ways: keys were looked at when read.
    if let (Some(signature), true) = (signature, has_parts) {
        check_given_twice(reader, signature, &inputs);
    }
    inputs
}
