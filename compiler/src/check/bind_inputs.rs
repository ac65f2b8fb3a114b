//! Binding every input and root to its source, with the types checked.

use crate::diagnostics::synonyms;
use crate::diagnostics::{Code, Finding, is_near};
use crate::document::{Member, Reader, Value, ValueKind};
use crate::graph::{Binding, Node, Root};
use crate::nodes::{DefaultValue, Input, Kind, ListForm, NodeType, Signature};
use crate::values::{Literal, Type};

use super::draft::{Draft, DraftInput, DraftRoot, Source, SourceKind};
use super::literals::Room;
use super::type_names::with_article;
use super::types::{Types, literal_type, overload};
use super::{components, fixed_inputs, lists, literals, mismatch, ramps, ranges, references};

/// The nodes and the roots, and how many of the nodes are the file's own. Nodes of unknown type are left
/// out: they made a finding, and then there is no graph. Nodes that lists stand for come after those of the
/// file.
pub(super) fn bind<'d>(
    reader: &mut Reader<'d>,
    draft: &Draft<'d>,
    types: &Types,
) -> (Vec<Node>, Vec<Root>, usize) {
    let mut nodes = Vec::with_capacity(draft.nodes.len());
    let mut added = Vec::new();
    for (at, node) in draft.nodes.iter().enumerate() {
        let Some(node_type) = node.node_type else { continue };
        if let Kind::List(form) = draft.node_types.signature(node_type).kind {
            let Some(values) = bind_list(reader, draft, types, at, node_type) else { continue };
            let next = draft.nodes.len() + added.len();
            let list = lists::List {
                library: draft.node_types.library,
                name: &node.member.key,
                values,
                next,
            };
            let nodes_of_list = match form {
                ListForm::Element => list.element(),
                ListForm::Sum => list.sum(),
                ListForm::Ramp => ramps::ramp(list),
            };
            match nodes_of_list {
                Some((own, others)) => {
                    nodes.push(own);
                    added.extend(others);
                }
                None => needs(
                    reader,
                    node.member,
                    "select`, `less_equal`, `add` and `ramp_segment",
                    "a list",
                ),
            }
            continue;
        }
        nodes.push(Node {
            name: node.member.key.clone(),
            node_type,
            overload: overload(draft.node_types.definition(node_type), types.generic(at)),
            inputs: bind_node(reader, draft, types, at, node_type),
        });
    }
    let own = nodes.len();
    nodes.append(&mut added);
    let roots =
        draft.roots.iter().filter_map(|root| bind_root(reader, draft, types, root, &mut nodes));
    let roots = roots.collect();
    (nodes, roots, own)
}

/// A root with its list of shaders as `chain` nodes, which are added to `nodes`.
fn bind_root<'d>(
    reader: &mut Reader<'d>,
    draft: &Draft<'d>,
    types: &Types,
    root: &DraftRoot<'d>,
    nodes: &mut Vec<Node>,
) -> Option<Root> {
    let (kind, name) = (root.kind, root.kind.name());
    let what = || format!("root `{name}`");
    let mut colors = Vec::with_capacity(root.colors.len());
    for source in &root.colors {
        colors.push(bind_source(reader, draft, types, source, kind.value_type(), false, &what));
    }
    let what = || format!("`ok` of root `{name}`");
    let ok = root
        .ok
        .as_ref()
        .map(|source| bind_source(reader, draft, types, source, Type::Boolean, false, &what));
    let mut color: Option<Binding> = None;
    for (at, next) in colors.into_iter().enumerate() {
        let next = next?;
        color = Some(match color {
            None => next,
            Some(before) => {
                let inputs = [("first", before), ("second", next)];
                chained(reader, draft, root, format!("{name}[{at}]"), inputs, nodes)?
            }
        });
    }
    Some(Root { kind, color: color?, ok: ok.unwrap_or(Some(Binding::Default))? })
}

/// What the shader before hands on, and this one makes of it, as a `chain` node.
fn chained(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    root: &DraftRoot<'_>,
    name: String,
    given: [(&str, Binding); 2],
    nodes: &mut Vec<Node>,
) -> Option<Binding> {
    let Some(node_type) = draft.node_types.library.find("chain") else {
        needs(reader, root.member, "chain", "a list of shaders");
        return None;
    };
    let signature = draft.node_types.signature(node_type);
    let mut inputs = vec![Binding::Default; signature.inputs.len()];
    for (input, binding) in given {
        inputs[signature.input(input)?] = match binding {
            Binding::Literal(literal) => {
                Binding::Literal(literal.converted_to(Type::Color).unwrap_or(literal))
            }
            other => other,
        };
    }
    nodes.push(Node { name, node_type, overload: 0, inputs });
    Some(Binding::Node { node: nodes.len() - 1, output: 0 })
}

fn needs(reader: &mut Reader<'_>, member: &Member, names: &str, what: &str) {
    let message = format!("the node library lacks `{names}`, which {what} takes");
    reader.report_key(Code::UNKNOWN_NODE_TYPE, member, message, "add them to the library");
}

/// What a node over a list is given: the index, if it takes one, and the values.
fn bind_list<'d>(
    reader: &mut Reader<'d>,
    draft: &Draft<'d>,
    types: &Types,
    node: usize,
    node_type: NodeType,
) -> Option<lists::Values> {
    let signature = draft.node_types.signature(node_type);
    let generic = types.generic(node);
    let (mut values, mut positions) = (Vec::new(), Vec::new());
    let mut index = Binding::Literal(Literal::Integer(0));
    let mut interpolation = fixed_inputs::default(signature);
    let mut complete = true;
    let mut given = vec![false; signature.inputs.len()];
    for input in &draft.nodes[node].inputs {
        let Some(at) = input.input else { continue };
        given[at] = true;
        let declared = &signature.inputs[at];
        let to = due(&input.source, declared, signature, generic);
        let what = || format!("input `{}` of {}", declared.name, draft.described(node));
        let Some(to) = to else {
            complete = false;
            continue;
        };
        if declared.fixed {
            match bind_fixed(reader, draft, types, (&input.source, declared), &what) {
                Some(binding) => interpolation = binding,
                None => complete = false,
            }
            continue;
        }
        match bind_source(reader, draft, types, &input.source, to, declared.list, &what) {
            Some(binding) if declared.list && declared.name == "positions" => {
                positions.push(binding);
            }
            Some(binding) if declared.list => values.push(binding),
            Some(binding) => index = binding,
            None => complete = false,
        }
    }
    missing_inputs(reader, draft, node, signature, &given);
    let is_complete = |(input, given): (&Input, &bool)| {
        *given || !matches!(input.default, DefaultValue::Required)
    };
    complete &= signature.inputs.iter().zip(&given).all(is_complete);
    complete &= !values.is_empty() && ramps::are_paired(reader, draft, node, &positions, &values);
    // A curve is of numbers.
    let generic = if signature.is_generic() { generic } else { Some(Type::Scalar) };
    let generic = generic.filter(|_| complete)?;
    Some(lists::Values { index, interpolation, positions, values, generic })
}

/// A choice that a node over a list has.
fn bind_fixed<'d>(
    reader: &mut Reader<'d>,
    draft: &Draft<'d>,
    types: &Types,
    (source, input): (&Source<'d>, &Input),
    what: &dyn Fn() -> String,
) -> Option<Binding> {
    if !fixed_inputs::suits(reader, draft, source, (input, input.choices), what) {
        return None;
    }
    if source.kind == SourceKind::Literal && matches!(source.value.kind, ValueKind::String(_)) {
        return bind_choice(reader, draft, source.value, input.choices, what);
    }
    bind_source(reader, draft, types, source, Type::Integer, false, what)
}

/// The number of a name among those of a choice, unless it was meant to be a reference.
fn bind_choice<'d>(
    reader: &mut Reader<'d>,
    draft: &Draft<'d>,
    value: &'d Value,
    labels: &[&str],
    what: &dyn Fn() -> String,
) -> Option<Binding> {
    let ValueKind::String(text) = &value.kind else { return None };
    let choices: Vec<(&str, i32)> = (0..).zip(labels).map(|(at, it)| (*it, at)).collect();
    // A node may have the name of a choice, and stands beside it all the same.
    let is_choice = choices.iter().any(|(label, _)| label == text);
    if !is_choice && references::report(reader, draft, value, None, what) {
        return None;
    }
    let label = reader.choice(value, &what(), &choices)?;
    Some(Binding::Literal(Literal::Integer(label)))
}

fn bind_node<'d>(
    reader: &mut Reader<'d>,
    draft: &Draft<'d>,
    types: &Types,
    node: usize,
    node_type: NodeType,
) -> Vec<Binding> {
    let signature = draft.node_types.signature(node_type);
    let mut bindings = vec![Binding::Default; signature.inputs.len()];
    let mut given = vec![false; signature.inputs.len()];
    for input in &draft.nodes[node].inputs {
        let Some(at) = input.input else { continue };
        given[at] = true;
        let generic = signature.inputs[at].value_type == Type::Generic;
        let to = due(&input.source, &signature.inputs[at], signature, types.generic(node));
        let what = || format!("input `{}` of {}", signature.inputs[at].name, draft.described(node));
        let Some(to) = to else { continue };
        let declared = &signature.inputs[at];
        let labels = labels(draft, node_type, at);
        let words = labels.as_deref().unwrap_or_default();
        if declared.fixed
            && !fixed_inputs::suits(reader, draft, &input.source, (declared, words), &what)
        {
            continue;
        }
        let value = input.source.value;
        if let (Some(labels), ValueKind::String(_)) = (&labels, &value.kind)
            && input.source.kind == SourceKind::Literal
        {
            if let Some(label) = bind_choice(reader, draft, value, labels, &what) {
                bindings[at] = label;
            }
            continue;
        }
        let is_literal = input.source.kind == SourceKind::Literal;
        if is_literal
            && ranges::is_enforced(draft, node_type, declared)
            && ranges::is_huge(reader, value, declared, &what)
        {
            continue;
        }
        if let Some(binding) = bind_source(reader, draft, types, &input.source, to, generic, &what)
        {
            bindings[at] = binding;
        }
    }
    missing_inputs(reader, draft, node, signature, &given);
    bindings
}

/// The type an input takes; none where that is not known. A literal that is of no type a generic input
/// could have is refused by all of them.
fn due(
    source: &Source<'_>,
    input: &Input,
    signature: &Signature,
    generic: Option<Type>,
) -> Option<Type> {
    if input.value_type != Type::Generic {
        return Some(input.value_type);
    }
    let hopeless = source.kind == SourceKind::Literal
        && literal_type(source.value, &signature.generic).is_none();
    if hopeless { Some(Type::Generic) } else { generic }
}

/// The names of the enumeration that an input is: a choice, or a parameter of a phenomenon.
fn labels<'a>(draft: &'a Draft<'_>, node_type: NodeType, input: usize) -> Option<Vec<&'a str>> {
    let labels: Vec<&str> = match draft.nested.get(&node_type) {
        Some(nested) => nested.graph.parameters[input].labels.iter().map(String::as_str).collect(),
        None => draft.node_types.signature(node_type).inputs[input].choices.into(),
    };
    (!labels.is_empty()).then_some(labels)
}

/// Reports inputs that must be given and are not, unless a misspelt one was surely meant for it.
fn missing_inputs(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    node: usize,
    signature: &Signature,
    given: &[bool],
) {
    let drafted = &draft.nodes[node];
    for (at, input) in signature.inputs.iter().enumerate() {
        let required = matches!(input.default, DefaultValue::Required) && !given[at];
        let meant = |given: &DraftInput<'_>| {
            given.input.is_none()
                && (is_near(&given.member.key, &input.name)
                    || synonyms::input(&given.member.key, |name| input.name == name).is_some())
        };
        // What stands beside `type` was told to be a level too high.
        let misplaced = drafted.member.value.get(&input.name).is_some();
        if !required || misplaced || drafted.inputs.iter().any(meant) {
            continue;
        }
        let message = format!("{} needs its input `{}`", draft.described(node), input.name);
        let help =
            format!("add `\"{}\"` to its `inputs`: {}", input.name, with_article(input.value_type));
        let place = reader.document.place_of_key(drafted.member);
        reader.findings.push(Finding::new(Code::MISSING_INPUT, place, message, help));
    }
}

/// The binding for a source, or none after a finding.
pub(super) fn bind_source<'d>(
    reader: &mut Reader<'d>,
    draft: &Draft<'d>,
    types: &Types,
    source: &Source<'d>,
    to: Type,
    repeat: bool,
    what: &dyn Fn() -> String,
) -> Option<Binding> {
    let binding = match source.kind {
        SourceKind::Broken => return None,
        SourceKind::Compound(at) => {
            mismatch::compound(reader, source.value, &draft.compounds[at], to, what);
            return None;
        }
        SourceKind::Literal if references::report(reader, draft, source.value, Some(to), what) => {
            return None;
        }
        SourceKind::Literal => {
            let room = if repeat { Room::Generic } else { Room::Input };
            return literals::read(reader, source.value, to, room, what).map(Binding::Literal);
        }
        SourceKind::Parameter(parameter) => Binding::Parameter(parameter),
        SourceKind::Node(node, output) => Binding::Node { node, output: output? },
    };
    let from = types.of(draft, source)?;
    if source.component.is_some() {
        let component = components::bind(reader, draft, types, source, binding)?;
        if !from.converts_to(to) {
            mismatch::connection(reader, draft, source, (from, to), what);
            return None;
        }
        return Some(component);
    }
    // A shader is what makes a color; a parameter of type color is no more than the color.
    let unmade = to == Type::Shader
        && from != Type::Shader
        && matches!(source.kind, SourceKind::Parameter(_));
    if !from.converts_to(to) || unmade {
        mismatch::connection(reader, draft, source, (from, to), what);
        return None;
    }
    Some(binding)
}
