//! What names mean: those that `where` binds, nodes, parameters and their parts.

use crate::check::draft::SourceKind;
use crate::check::literals::natural_type;
use crate::check::shape::{element_name, member_name};
use crate::check::sources;
use crate::check::turns::written_name;
use crate::diagnostics::{Advice, Code, Finding, listed, shortened};
use crate::document::{Value, ValueKind};
use crate::values::Type;

use super::operand::{Is, Operand, connection};
use super::writer::{Work, Writer};

/// Numbers with a name.
pub const CONSTANTS: [(&str, &str); 2] = [("pi", "3.1415927"), ("tau", "6.2831855")];

/// What a value under `where` is.
pub(super) fn bound<'d>(work: &mut Work<'_, 'd>, value: &'d Value) -> Operand {
    let json = value.kind.clone();
    match &value.kind {
        ValueKind::Number(_) => match work.reader.finite(value, "a name under `where`") {
            Some(_) => Operand { json, is: Is::Number },
            None => Operand::broken(),
        },
        ValueKind::Boolean(_) => Operand::of(json, Type::Boolean),
        ValueKind::String(_) => Operand { json, is: Is::Text },
        ValueKind::Array(elements) => list(work, value, elements),
        ValueKind::Null => {
            let help = "give a literal, a connection or another expression";
            work.reader.report(Code::WRONG_KIND, value, "a name under `where` is null", help);
            Operand::broken()
        }
        ValueKind::Object(_) => object(work, value),
    }
}

fn list(work: &mut Work<'_, '_>, value: &Value, elements: &[Value]) -> Operand {
    let numbers = elements.iter().all(|it| matches!(it.kind, ValueKind::Number(_)));
    let is = match elements.len() {
        3 => Is::Triple,
        4 => Is::Of(Type::Color),
        16 => Is::Of(Type::Transform),
        _ => Is::Broken,
    };
    if !numbers || is == Is::Broken {
        let message = format!("a name under `where` is one value, not {}", value.describe());
        let help = "give three numbers, `[r, g, b, a]`, or a connection";
        work.reader.report(Code::WRONG_KIND, value, message, help);
        return Operand::broken();
    }
    Operand { json: value.kind.clone(), is }
}

/// A connection, a texture, a light.
fn object<'d>(work: &mut Work<'_, 'd>, value: &'d Value) -> Operand {
    let source = sources::read(work.reader, value, work.draft);
    let draft = work.draft;
    match source.kind {
        SourceKind::Node(node, Some(_)) => {
            let Some(node_type) = draft.nodes[node].node_type else { return Operand::broken() };
            let generic = work.types.generic(node);
            if value.get("output").is_none() {
                let json = connection("node", draft.name(node), None);
                return Operand { json, is: Is::Node(draft.name(node).into(), node_type, generic) };
            }
            match work.types.of(draft, &source) {
                Some(value_type) => Operand::of(value.kind.clone(), value_type),
                None => Operand::broken(),
            }
        }
        SourceKind::Parameter(_) => match work.types.of(draft, &source) {
            Some(value_type) => Operand::of(value.kind.clone(), value_type),
            None => Operand::broken(),
        },
        SourceKind::Compound(at) => Operand { json: value.kind.clone(), is: Is::Compound(at) },
        SourceKind::Literal => {
            let known = match natural_type(value) {
                Some(known) => Some(known),
                None if value.get("texture").is_some() => Some(Type::Texture),
                None if value.get("light").is_some() => Some(Type::Light),
                None => None,
            };
            known.map_or(Operand::broken(), |known| Operand::of(value.kind.clone(), known))
        }
        SourceKind::Node(..) | SourceKind::Broken => Operand::broken(),
    }
}

impl<'w> Writer<'w, '_> {
    /// What a name means.
    pub fn named(&mut self, at: usize, name: &str) -> Operand {
        if let Some(bound) = self.scope.iter().rev().find(|bound| bound.name == name) {
            bound.used.set(true);
            return bound.operand.clone();
        }
        let draft = self.draft;
        let node = draft.node_names.get(name).copied();
        let parameter = draft.parameter_names.get(name).copied();
        let compound = draft.compound_names.get(name).copied();
        match (node, parameter, compound) {
            (None, Some(parameter), _) => self.parameter(parameter),
            (None, None, Some(at)) => {
                Operand { json: connection("interface", name, None), is: Is::Compound(at) }
            }
            (Some(node), None, None) => match draft.nodes[node].node_type {
                Some(node_type) => {
                    self.whole_node(name.into(), node_type, self.types.generic(node))
                }
                None => Operand::broken(),
            },
            (Some(_), ..) => {
                self.ambiguous(at, name);
                Operand::broken()
            }
            (None, None, None) if draft.nodes_named(name).next().is_some() => {
                Operand { json: ValueKind::Null, is: Is::Turns(name.into()) }
            }
            (None, None, None) => {
                if let Some((_, number)) = CONSTANTS.iter().find(|(known, _)| *known == name) {
                    return Operand { json: ValueKind::Number((*number).into()), is: Is::Number };
                }
                self.unknown_name(at, name);
                Operand::broken()
            }
        }
    }

    fn parameter(&self, parameter: usize) -> Operand {
        let drafted = &self.draft.parameters[parameter];
        match drafted.value_type {
            Some(value_type) => {
                Operand::of(connection("interface", &drafted.name, None), value_type)
            }
            None => Operand::broken(),
        }
    }

    fn ambiguous(&mut self, at: usize, name: &str) {
        let shown = shortened(name);
        let message = format!("`{shown}` is a node and a parameter");
        let help = format!(
            "bind one of them: `\"where\": {{ \"{shown}_node\": {{ \"node\": \"{shown}\" }} }}`, or `{{ \"interface\": \"{shown}\" }}`"
        );
        let (start, end) = self.parsed.place(&self.parsed.parts[at].span);
        let document = self.reader.document;
        let place = document.place_of_bytes(start, end);
        let mut finding = Finding::new(Code::AMBIGUOUS_NAME, place, message, help);
        if let Some(&node) = self.draft.node_names.get(name) {
            let declared = document.place_of_key(self.draft.nodes[node].member);
            finding = finding.with_related(declared, "the node");
        }
        if let Some(&parameter) = self.draft.parameter_names.get(name) {
            let declared = document.place_of_key(self.draft.parameters[parameter].member);
            finding = finding.with_related(declared, "the parameter");
        }
        self.reader.findings.push(finding);
    }

    /// The names an expression may use here.
    fn in_reach(&self) -> Vec<&'w str> {
        let bound = self.scope.iter().map(|bound| bound.name);
        let mut nodes: Vec<&str> =
            self.draft.nodes.iter().map(|node| written_name(&node.member.key)).collect();
        nodes.dedup();
        let is_whole = |name: &&str| !name.contains(['.', '[']);
        let parameters = self.draft.parameters.iter().map(|it| it.name.as_str()).filter(is_whole);
        let compounds = self.draft.compounds.iter().map(|(name, _)| name.as_str()).filter(is_whole);
        bound.chain(parameters).chain(compounds).chain(nodes).collect()
    }

    fn unknown_name(&mut self, at: usize, name: &str) {
        let span = self.parsed.parts[at].span.clone();
        if span.start < self.told {
            return;
        }
        let rest = self.parsed.text.get(span.start..).unwrap_or_default();
        let names = self.in_reach();
        // A name with a `-` is a difference here.
        let longer = |known: &&&str| {
            known.len() > name.len() && known.contains('-') && rest.starts_with(**known)
        };
        let advice = match names.iter().find(longer) {
            Some(known) => {
                self.told = span.start + known.len();
                let word = known.replace('-', "_");
                let is_node = self.draft.nodes_named(known).next().is_some();
                let key = if is_node { "node" } else { "interface" };
                Advice::from(format!(
                    "a `-` subtracts here, so bind `{known}` to another name: `\"where\": {{ \"{word}\": {{ \"{key}\": \"{known}\" }} }}`"
                ))
            }
            None => self.reader.advice(name, names.iter().copied(), None, || {
                let mut usable =
                    names.iter().copied().filter(|name| !name.contains('-')).peekable();
                match usable.peek() {
                    None => "declare a parameter or a node, or bind the name under `where`".into(),
                    Some(_) => format!("names in reach are {}", listed(usable)),
                }
            }),
        };
        let message = format!("nothing here is called `{}`", shortened(name));
        self.advise(Code::UNKNOWN_NAME, &span, message, advice);
    }

    /// `.name` behind a part: a member of a struct, an output of a node, or components.
    pub fn member(&mut self, at: usize, of: usize, name: &str) -> Operand {
        match self.operands[of].is.clone() {
            Is::Broken => Operand::broken(),
            Is::Turns(_) => {
                self.arrives(of);
                Operand::broken()
            }
            Is::Compound(compound) => {
                let whole = &self.draft.compounds[compound].0;
                let part = member_name(whole, name);
                self.part_of(at, compound, &part)
            }
            Is::Node(node, node_type, generic) => {
                let signature = self.draft.node_types.signature(node_type);
                match signature.output(name) {
                    Some(output) => self.output_of(&node, (node_type, generic), output),
                    None => self.component(at, of, name),
                }
            }
            _ => self.component(at, of, name),
        }
    }

    /// `[2]` behind a part.
    pub fn element(&mut self, at: usize, of: usize, index: usize) -> Operand {
        match self.operands[of].is.clone() {
            Is::Broken => Operand::broken(),
            Is::Compound(compound) => {
                let part = element_name(&self.draft.compounds[compound].0, index);
                self.part_of(at, compound, &part)
            }
            Is::Turns(map) => self.turn(at, &map, index),
            _ => {
                let Some(arrives) = self.arrives(of) else { return Operand::broken() };
                let message = format!("{}, which has no elements", self.described(of, arrives));
                let help = match arrives.own() {
                    Type::Vector => "name a component: `.x`, `.y` or `.z`",
                    Type::Color => "name a component: `.r`, `.g`, `.b` or `.a`",
                    _ => "only arrays of the interface have them",
                };
                let mark = self.parsed.parts[at].mark.clone();
                self.report(Code::TYPE_MISMATCH, &mark, message, help);
                Operand::broken()
            }
        }
    }

    /// A turn of a map.
    fn turn(&mut self, at: usize, map: &str, index: usize) -> Operand {
        let draft = self.draft;
        let Some(node) = draft.nodes_named(map).nth(index) else {
            let (count, shown) = (draft.nodes_named(map).count(), shortened(map));
            let message =
                format!("the map `{shown}` yields a list of {count}, which has no [{index}]");
            let help = format!("its last is `{shown}[{}]`", count.saturating_sub(1));
            let mark = self.parsed.parts[at].mark.clone();
            self.report(Code::UNKNOWN_NAME, &mark, message, help);
            return Operand::broken();
        };
        match draft.nodes[node].node_type {
            Some(node_type) => {
                self.whole_node(draft.name(node).into(), node_type, self.types.generic(node))
            }
            None => Operand::broken(),
        }
    }

    /// A part of an array or a struct of the interface.
    fn part_of(&mut self, at: usize, whole: usize, part: &str) -> Operand {
        if let Some(&parameter) = self.draft.parameter_names.get(part) {
            return self.parameter(parameter);
        }
        if let Some(&compound) = self.draft.compound_names.get(part) {
            return Operand {
                json: connection("interface", part, None),
                is: Is::Compound(compound),
            };
        }
        let (name, shape) = &self.draft.compounds[whole];
        let own = part.strip_prefix(name.as_str()).unwrap_or(part);
        let message = format!(
            "`{}` has no part `{}`: it is {}",
            shortened(name),
            shortened(own.trim_start_matches('.')),
            shape.describe()
        );
        let mut parts: Vec<String> = Vec::new();
        for (known, _) in shape.parts(name) {
            let own = known.strip_prefix(name.as_str()).unwrap_or(&known).trim_start_matches('.');
            let first = own.split_inclusive([']', '.']).next().unwrap_or(own).trim_end_matches('.');
            if parts.last().is_none_or(|last| last != first) {
                parts.push(first.to_owned());
            }
        }
        let wanted = own.trim_start_matches('.');
        let names = || parts.iter().map(String::as_str);
        let listed = || format!("its parts are {}", listed(names()));
        let advice = match wanted.starts_with('[') {
            true => Advice::from(listed()),
            false => self.reader.advice(wanted, names(), None, listed),
        };
        let mark = self.parsed.parts[at].mark.clone();
        self.advise(Code::UNKNOWN_NAME, &mark, message, advice);
        Operand::broken()
    }
}
