//! `phenomena`: the phenomena that stand in a file and are private to it. Each may use those that stand
//! beside it or round it, and may have others within itself.

use std::collections::HashMap;
use std::rc::Rc;

use crate::diagnostics::{Advice, Code, Finding, listed, shortened};
use crate::document::{Member, Reader, Value, ValueKind};

use super::limits::{MAX_INNER, MAX_NODES};
use super::names::check_key;
use super::nested::Nested;
use super::turns::form_of;

/// The file, and all phenomena that stand in it.
pub(super) struct Inner<'d> {
    /// The file first, outer ones before inner ones.
    scopes: Vec<Scope<'d>>,
    /// How many nodes they may have in all, once each is checked.
    nodes_left: usize,
    /// Whether none was left out, past the limit.
    is_whole: bool,
}

/// The file, or a phenomenon in it.
struct Scope<'d> {
    /// None for the file.
    member: Option<&'d Member>,
    value: &'d Value,
    /// Position of the one it stands in; that of the file is its own.
    outer: usize,
    /// Those that stand in it, by name.
    own: HashMap<&'d str, usize>,
    /// Those it uses as types of nodes, each where it does so first.
    uses: Vec<(usize, &'d Value)>,
    /// Those it names where that is a mistake, as if they were of the library.
    named: Vec<usize>,
    found: Found,
}

/// What a name turned out to be.
#[derive(Clone)]
pub(super) enum Found {
    /// A phenomenon that is right.
    Nested(Rc<Nested>),
    /// One with mistakes that were told.
    Broken,
}

/// The phenomenon a node's type names in the file, if it names one.
pub(super) fn inner_of(value: &Value) -> Option<&str> {
    match &value.get("phenomenon")?.kind {
        ValueKind::String(name) if value.get("file").is_none() => Some(name),
        _ => None,
    }
}

impl<'d> Inner<'d> {
    /// Those of a file, not checked yet.
    pub fn of(reader: &mut Reader<'d>, root: &'d Value) -> Self {
        let file = Scope::new(None, root, 0);
        let mut inner = Self { scopes: vec![file], nodes_left: MAX_NODES, is_whole: true };
        let mut at = 0;
        while at < inner.scopes.len() {
            let value = inner.scopes[at].value.get("phenomena");
            let members = value.and_then(|value| reader.members(value, "`phenomena`"));
            for member in members.into_iter().flatten() {
                if inner.scopes.len() > MAX_INNER {
                    return inner.too_many(reader, member);
                }
                check_key(reader, member, "the name of a phenomenon");
                let position = inner.scopes.len();
                inner.scopes[at].own.insert(&member.key, position);
                inner.scopes.push(Scope::new(Some(member), &member.value, at));
            }
            at += 1;
        }
        inner.find_uses();
        inner
    }

    /// Reports the first past the limit; those before it are known.
    fn too_many(mut self, reader: &mut Reader<'_>, member: &Member) -> Self {
        let message = format!("a file has at most {MAX_INNER} phenomena within it");
        let help = "give some of them files of their own";
        reader.report_key(Code::TOO_MANY_PARTS, member, message, help);
        self.is_whole = false;
        self.find_uses();
        self
    }

    fn find_uses(&mut self) {
        for at in 0..self.scopes.len() {
            let (uses, named) = self.uses(at);
            let scope = &mut self.scopes[at];
            (scope.uses, scope.named) = (uses, named);
        }
    }

    /// Those a phenomenon uses, and those it only names.
    fn uses(&self, at: usize) -> (Vec<(usize, &'d Value)>, Vec<usize>) {
        let (mut uses, mut named): (Vec<(usize, &Value)>, Vec<usize>) = Default::default();
        let mut seen: HashMap<&str, ()> = HashMap::new();
        for node in self.scopes[at].value.get("nodes").map_or(&[][..], Value::members) {
            let Some(value) = node.value.get("type") else {
                // A type is missing, and that is told.
                named.extend(inner_of(&node.value).and_then(|name| self.position(at, name)));
                continue;
            };
            // A turn that could not be written out was told too.
            let turned = form_of(value).and_then(|(_, body)| inner_of(body));
            named.extend(turned.and_then(|name| self.position(at, name)));
            if let ValueKind::String(name) = &value.kind {
                named.extend(self.position(at, name));
            }
            let Some(name) = inner_of(value).filter(|name| seen.insert(name, ()).is_none()) else {
                continue;
            };
            if let Some(used) = self.position(at, name) {
                uses.push((used, value.get("phenomenon").unwrap_or(value)));
            }
        }
        (uses, named)
    }

    /// The phenomenon called so where another stands: the nearest, from the inside out.
    fn position(&self, mut at: usize, name: &str) -> Option<usize> {
        loop {
            if let Some(found) = self.scopes[at].own.get(name) {
                return Some(*found);
            }
            if at == 0 {
                return None;
            }
            at = self.scopes[at].outer;
        }
    }

    /// What is called so in a phenomenon, by its position; none where nothing is.
    pub fn find(&self, at: usize, name: &str) -> Option<Found> {
        match self.position(at, name) {
            Some(found) => Some(self.scopes[found].found.clone()),
            // It may be one of those past the limit.
            None if !self.is_whole => Some(Found::Broken),
            None => None,
        }
    }

    /// What to say of a name that nothing is called by in a phenomenon.
    pub fn advice(&self, reader: &Reader<'_>, mut at: usize, name: &str) -> Advice {
        let mut names: Vec<&str> = Vec::new();
        loop {
            let mut own: Vec<(usize, &str)> =
                self.scopes[at].own.iter().map(|(name, at)| (*at, *name)).collect();
            own.sort_unstable();
            names.extend(own.into_iter().map(|(_, name)| name));
            if at == 0 {
                break;
            }
            at = self.scopes[at].outer;
        }
        reader.advice(name, names.iter().copied(), None, || match names.is_empty() {
            true => "declare it under `phenomena`, or name a file: `{ \"file\": \"…\" }`".into(),
            false => format!("those there are {}", listed(names.iter().copied())),
        })
    }

    /// Checks all of them, those first that use no other; `check` is the check of one, by its
    /// position.
    pub fn check(
        &mut self,
        reader: &mut Reader<'d>,
        mut check: impl FnMut(&mut Reader<'d>, &Self, usize) -> Option<Nested>,
    ) {
        for at in self.order(reader) {
            if at == 0 {
                continue;
            }
            let Some(nested) = check(reader, self, at) else { continue };
            match self.nodes_left.checked_sub(nested.graph.nodes.len()) {
                Some(left) => {
                    self.nodes_left = left;
                    self.scopes[at].found = Found::Nested(Rc::new(nested));
                }
                None => self.too_many_nodes(reader, at),
            }
        }
    }

    fn too_many_nodes(&mut self, reader: &mut Reader<'d>, at: usize) {
        // Told once: whatever comes after is as much too much.
        if let (Some(member), true) = (self.scopes[at].member, self.nodes_left > 0) {
            let message = format!(
                "the phenomena of the file have more than {MAX_NODES} nodes in all, with those \
                 they use"
            );
            let help = "use fewer phenomena, or smaller ones";
            reader.report_key(Code::TOO_MANY_NODES, member, message, help);
        }
        self.nodes_left = 0;
    }

    /// The value of a phenomenon and the member it is.
    pub fn declaration(&self, at: usize) -> (&'d Value, Option<&'d Member>) {
        (self.scopes[at].value, self.scopes[at].member)
    }

    /// All positions, those that are used before those that use them. Circles are findings; they come
    /// last, with what uses them.
    fn order(&self, reader: &mut Reader<'_>) -> Vec<usize> {
        let count = self.scopes.len();
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); count];
        let mut waiting_for: Vec<usize> = Vec::with_capacity(count);
        for (at, scope) in self.scopes.iter().enumerate() {
            scope.uses.iter().for_each(|(used, _)| users[*used].push(at));
            waiting_for.push(scope.uses.len());
        }
        let mut order: Vec<usize> = (0..count).filter(|&at| waiting_for[at] == 0).collect();
        let mut next = 0;
        while let Some(&at) = order.get(next) {
            next += 1;
            for &user in &users[at] {
                waiting_for[user] -= 1;
                if waiting_for[user] == 0 {
                    order.push(user);
                }
            }
        }
        if order.len() < count {
            self.report_circles(reader, &waiting_for);
            order.extend((0..count).filter(|&at| waiting_for[at] > 0));
        }
        order
    }

    /// Follows from each phenomenon that waits the first that waits too, until it was seen before.
    fn report_circles(&self, reader: &mut Reader<'_>, waiting_for: &[usize]) {
        let mut walk_of: Vec<Option<usize>> = vec![None; self.scopes.len()];
        for start in (0..self.scopes.len()).filter(|&at| waiting_for[at] > 0) {
            let mut path: Vec<(usize, &Value)> = Vec::new();
            let mut at = start;
            while walk_of[at].is_none() {
                walk_of[at] = Some(start);
                let mut uses = self.scopes[at].uses.iter();
                let Some(&(next, place)) = uses.find(|(next, _)| waiting_for[*next] > 0) else {
                    break;
                };
                path.push((at, place));
                at = next;
            }
            if walk_of[at] == Some(start)
                && let Some(first) = path.iter().position(|(on_path, _)| *on_path == at)
            {
                self.report_circle(reader, &path[first..]);
            }
        }
    }

    fn report_circle(&self, reader: &mut Reader<'_>, circle: &[(usize, &Value)]) {
        let name = |at: usize| {
            let name = self.scopes[at].member.map_or("", |member| member.key.as_str());
            format!("`{}`", shortened(name))
        };
        let names: Vec<String> = circle.iter().map(|(at, _)| name(*at)).collect();
        let message = match names.as_slice() {
            [one] => format!("the phenomenon {one} uses itself"),
            many => format!("phenomena use one another: {} → {}", many.join(" → "), many[0]),
        };
        let help =
            "a phenomenon must not be a part of itself; break the circle at one of its nodes";
        let place = reader.document.place(circle[0].1);
        let mut finding = Finding::new(Code::RECURSION, place, message, help);
        for (_, place) in circle.iter().skip(1).take(super::limits::MAX_CYCLE_SHOWN) {
            let place = reader.document.place(place);
            finding = finding.with_related(place, "uses the next one here");
        }
        reader.findings.push(finding);
    }

    /// Reports those that the file does not use, directly or through others. Only the outermost of
    /// what is unused is told.
    pub fn report_unused(&self, reader: &mut Reader<'_>) {
        if !self.is_whole {
            return;
        }
        let mut used = vec![false; self.scopes.len()];
        let mut pending = vec![0];
        while let Some(at) = pending.pop() {
            if !std::mem::replace(&mut used[at], true) {
                let scope = &self.scopes[at];
                pending.extend(scope.uses.iter().map(|(used, _)| *used).chain(scope.named.clone()));
            }
        }
        let mut explained = vec![false; self.scopes.len()];
        for (at, scope) in self.scopes.iter().enumerate().filter(|(at, _)| !used[*at]) {
            scope.uses.iter().for_each(|(used, _)| explained[*used] |= *used != at);
            scope.own.values().for_each(|inner| explained[*inner] = true);
        }
        for (at, scope) in self.scopes.iter().enumerate() {
            let Some(member) = scope.member.filter(|_| !used[at] && !explained[at]) else {
                continue;
            };
            let name = shortened(&member.key);
            let message = format!("no node is the phenomenon `{name}`, so it is never evaluated");
            let help = format!(
                "use it as the type of a node, `{{ \"phenomenon\": \"{name}\" }}`, or remove it"
            );
            reader.report_key(Code::UNUSED_PHENOMENON, member, message, help);
        }
    }
}

impl<'d> Scope<'d> {
    fn new(member: Option<&'d Member>, value: &'d Value, outer: usize) -> Self {
        let (own, uses, named) = (HashMap::new(), Vec::new(), Vec::new());
        Self { member, value, outer, own, uses, named, found: Found::Broken }
    }
}
