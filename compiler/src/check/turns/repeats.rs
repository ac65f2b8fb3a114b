//! The maps and folds of a phenomenon, and the values of their lists.

use std::collections::{HashMap, HashSet};

use crate::check::draft::Draft;
use crate::check::interface;
use crate::check::limits::MAX_TURNS;
use crate::check::shape::{Shape, element_name};
use crate::diagnostics::{Code, Finding, shortened};
use crate::document::{Document, Member, Reader, Value, ValueKind};
use crate::nodes::NodeLibrary;

use super::form::{ACCUMULATED, Form, INDEX, INITIAL, ITEM, OVER, form_of};

/// A map or a fold.
pub struct Repeat<'v> {
    pub member: &'v Member,
    pub form: Form,
    /// The type of each turn.
    pub body: &'v Value,
    /// The member `over` of its inputs.
    pub over: &'v Member,
    /// The member `initial` of its inputs; of folds only.
    pub initial: Option<&'v Member>,
    /// What each turn is given; none where the list is not understood.
    pub items: Option<Vec<Value>>,
}

/// The maps and folds of a phenomenon, by name; none of those that are not understood.
pub struct Repeats<'v> {
    document: &'v Document,
    library: &'v NodeLibrary,
    phenomenon: &'v Value,
    pub all: HashMap<&'v str, Repeat<'v>>,
    pub findings: Vec<Finding>,
}

impl<'v> Repeats<'v> {
    /// Those of a phenomenon. `left` is how many turns, and values in them, the file may still have.
    pub fn of(
        document: &'v Document,
        library: &'v NodeLibrary,
        phenomenon: &'v Value,
        left: &mut Left,
    ) -> Self {
        let (all, findings) = (HashMap::new(), Vec::new());
        let mut repeats = Self { document, library, phenomenon, all, findings };
        let mut order = Vec::new();
        for member in phenomenon.get("nodes").map_or(&[][..], Value::members) {
            let Some((form, body)) = member.value.get("type").and_then(form_of) else { continue };
            if !repeats.all.contains_key(member.key.as_str())
                && let Some(repeat) = repeats.read(member, form, body)
            {
                order.push(member.key.as_str());
                repeats.all.insert(&member.key, repeat);
            }
        }
        repeats.find_items(&order);
        repeats.keep_within(&order, left);
        repeats
    }

    fn report(&mut self, code: Code, value: &Value, message: String, help: &str) {
        let place = self.document.place(value);
        self.findings.push(Finding::new(code, place, message, help));
    }

    fn report_key(&mut self, code: Code, member: &Member, message: String, help: String) {
        let place = self.document.place_of_key(member);
        self.findings.push(Finding::new(code, place, message, help));
    }

    /// The parts of a map or a fold, or findings.
    fn read(&mut self, member: &'v Member, form: Form, body: &'v Value) -> Option<Repeat<'v>> {
        let what = format!("the {} `{}`", form.name(), shortened(&member.key));
        let before = self.findings.len();
        let node_type = member.value.get("type")?;
        for other in node_type.members().iter().filter(|other| other.key != form.name()) {
            let message = format!("the type of {what} has no key `{}`", shortened(&other.key));
            let help = format!("its one key is `{}`, with the body", form.name());
            self.report_key(Code::UNKNOWN_KEY, other, message, help);
        }
        if body.get("file").is_none() && body.get("phenomenon").is_none() {
            let message =
                format!("the body of {what} must be a phenomenon, not {}", body.describe());
            let help = "write `{ \"file\": \"turn.json\" }`, or `{ \"phenomenon\": \"turn\" }` for one in this file";
            self.report(Code::WRONG_KIND, body, message, help);
        }
        let inputs = member.value.get("inputs").map_or(&[][..], Value::members);
        let given = |key: &str| inputs.iter().find(|input| input.key == key);
        let own = [ITEM, INDEX, ACCUMULATED];
        let own = &own[..if form == Form::Fold { 3 } else { 2 }];
        for input in inputs.iter().filter(|input| own.contains(&input.key.as_str())) {
            let message = format!("{what} is given `{}`, which is each turn's own", input.key);
            let help =
                "remove it; another parameter of the body may have what is the same in all turns";
            self.report_key(Code::UNKNOWN_INPUT, input, message, help.into());
        }
        let (over, initial) = (given(OVER), given(INITIAL));
        let needs = [(OVER, over, true), (INITIAL, initial, form == Form::Fold)];
        for (name, given, needed) in needs {
            if needed && given.is_none() {
                let message = format!("{what} needs its input `{name}`");
                let of = if name == OVER { "a list" } else { "what the first turn is handed" };
                let help = format!("add `\"{name}\": …` to its `inputs`: {of}");
                self.report_key(Code::MISSING_INPUT, member, message, help);
            }
        }
        let initial = initial.filter(|_| form == Form::Fold);
        let over = over?;
        (self.findings.len() == before).then_some(Repeat {
            member,
            form,
            body,
            over,
            initial,
            items: None,
        })
    }

    /// Finds what the turns are given. Maps over maps come after those.
    fn find_items(&mut self, order: &[&'v str]) {
        let lengths = Lengths::of(self);
        for &name in order {
            let mut chain = vec![name];
            // Up to a list that is known. A circle ends where it began, and is told of as one of nodes.
            while let Some(source) = chain.last().and_then(|name| self.list_of(name)) {
                if self.all[source].items.is_some() {
                    break;
                }
                if chain.contains(&source) {
                    break;
                }
                chain.push(source);
            }
            for name in chain.into_iter().rev() {
                if self.all[name].items.is_none() {
                    let items = self.items(name, &lengths);
                    if let Some(repeat) = self.all.get_mut(name) {
                        repeat.items = items;
                    }
                }
            }
        }
        let known: HashSet<&str> =
            order.iter().copied().filter(|name| self.all[name].items.is_some()).collect();
        self.all.retain(|name, _| known.contains(name));
    }

    /// The map that a node goes over, if it is one.
    fn list_of(&self, name: &str) -> Option<&'v str> {
        let source = named(&self.all.get(name)?.over.value)?;
        self.all.get(source).filter(|of| of.form == Form::Map).map(|of| of.member.key.as_str())
    }

    fn items(&mut self, name: &str, lengths: &Lengths) -> Option<Vec<Value>> {
        let over = &self.all[name].over.value;
        let what = format!("input `{OVER}` of node `{}`", shortened(name));
        let help =
            "write `[value, …]`, where a value may be a connection, or connect an array or a map";
        if let ValueKind::Array(elements) = &over.kind {
            if elements.is_empty() {
                let message = format!("{what} is an empty list");
                self.report(Code::WRONG_LENGTH, over, message, "give at least one value");
                return None;
            }
            return Some(elements.clone());
        }
        let not = match (named(over), over.get("interface").map(|name| &name.kind)) {
            (Some(source), _) => match self.all.get(source) {
                Some(of) if of.form == Form::Map => {
                    let count = of.items.as_ref()?.len();
                    return Some((0..count).map(|at| turn_of(over, source, at)).collect());
                }
                _ if self.is_node(source) => "but one value is connected".to_owned(),
                // Whoever reads the node tells of it.
                _ => return Some(vec![over.clone()]),
            },
            (None, Some(ValueKind::String(path))) => match lengths.of_parameter(path) {
                Some(Ok(count)) => {
                    return Some((0..count).map(|at| element_of(over, path, at)).collect());
                }
                Some(Err(is)) => format!("but `{}` is {is}", shortened(path)),
                None => return Some(vec![over.clone()]),
            },
            _ => format!("not {}", over.describe()),
        };
        self.report(Code::TYPE_MISMATCH, over, format!("{what} takes a list, {not}"), help);
        None
    }

    fn is_node(&self, name: &str) -> bool {
        self.phenomenon.get("nodes").is_some_and(|nodes| nodes.get(name).is_some())
    }

    /// Takes the turns from those the file may have; a finding where they are too many.
    fn keep_within(&mut self, order: &[&'v str], left: &mut Left) {
        for name in order {
            let Some(repeat) = self.all.get(name) else { continue };
            let items = repeat.items.as_deref().unwrap_or_default();
            let inputs = repeat.member.value.get("inputs").map_or(&[][..], Value::members).iter();
            let same = inputs.filter(|input| input.key != OVER).map(|input| count(&input.value));
            let values = items.len().saturating_mul(same.sum());
            if left.take(items.len(), values) {
                continue;
            }
            let repeat = self.all.remove(name);
            // Told once: what comes after is as much too much.
            if let Some(repeat) = repeat
                && !std::mem::replace(&mut left.told, true)
            {
                let message = format!(
                    "the maps and folds of a file have at most {MAX_TURNS} turns, which this one goes past"
                );
                let help = "go over shorter lists, or give each turn less";
                self.report(Code::TOO_MANY_NODES, &repeat.over.value, message, help);
            }
        }
    }

    /// Forgets a map that is used where no list can be, and those that go over it.
    pub fn forget(&mut self, name: &str) {
        let mut names = vec![name.to_owned()];
        while let Some(name) = names.pop() {
            self.all.remove(name.as_str());
            let over = |repeat: &&Repeat<'_>| named(&repeat.over.value) == Some(name.as_str());
            names.extend(self.all.values().filter(over).map(|repeat| repeat.member.key.clone()));
        }
    }
}

/// How many turns a file may still have, and values in all of them.
pub struct Left {
    turns: usize,
    values: usize,
    told: bool,
}

impl Left {
    /// For a whole file.
    pub fn of_file() -> Self {
        Self { turns: MAX_TURNS, values: 16 * MAX_TURNS, told: false }
    }

    fn take(&mut self, turns: usize, values: usize) -> bool {
        match (self.turns.checked_sub(turns), self.values.checked_sub(values)) {
            (Some(turns), Some(values)) => {
                (self.turns, self.values) = (turns, values);
                true
            }
            _ => false,
        }
    }
}

/// Values within a value, itself included.
fn count(value: &Value) -> usize {
    1 + match &value.kind {
        ValueKind::Array(elements) => elements.iter().map(count).sum::<usize>(),
        ValueKind::Object(members) => members.iter().map(|member| count(&member.value)).sum(),
        _ => 0,
    }
}

/// The lengths of the arrays of an interface.
struct Lengths {
    /// For each name the length, or what it is in place of an array.
    known: HashMap<String, Result<usize, String>>,
}

impl Lengths {
    fn of(repeats: &Repeats<'_>) -> Self {
        let interface = repeats.phenomenon.get("interface");
        if repeats.all.is_empty() || interface.is_none() {
            return Self { known: HashMap::new() };
        }
        // What is wrong in it is told when it is read for good.
        let mut reader = Reader::of_part(repeats.document);
        let mut draft = Draft::new(repeats.library, true);
        interface::read(&mut reader, interface, &mut draft);
        let single = draft.parameters.iter().filter(|parameter| parameter.value_type.is_some());
        let single = single.map(|one| (one.name.clone(), Err("one value".to_owned())));
        let compounds = draft.compounds.iter().map(|(name, shape)| {
            let length = match shape {
                Shape::Array(elements) => Ok(elements.len()),
                other => Err(other.describe()),
            };
            (name.clone(), length)
        });
        Self { known: single.chain(compounds).collect() }
    }

    /// None for what there is not, or is not understood: whoever reads it tells.
    fn of_parameter(&self, path: &str) -> Option<Result<usize, String>> {
        self.known.get(path).cloned()
    }
}

/// The node that a connection names.
pub fn named(value: &Value) -> Option<&str> {
    match &value.get("node")?.kind {
        ValueKind::String(name) => Some(name),
        _ => None,
    }
}

/// The connection to a turn of a map in place of that to the map.
pub fn turn_of(connection: &Value, name: &str, at: usize) -> Value {
    replaced(connection, "node", element_name(name, at))
}

fn element_of(connection: &Value, path: &str, at: usize) -> Value {
    replaced(connection, "interface", element_name(path, at))
}

fn replaced(connection: &Value, key: &str, name: String) -> Value {
    let mut connection = connection.clone();
    if let ValueKind::Object(members) = &mut connection.kind
        && let Some(member) = members.iter_mut().find(|member| member.key == key)
    {
        member.value.kind = ValueKind::String(name);
    }
    connection
}
