//! The list of nodes as a value: another crate can extend it.

use std::collections::HashMap;
use std::fmt;
use std::sync::Arc;

use crate::kernels::BodyForms;
use crate::state::Field;
use crate::values::{Name, Type};

use super::{Kind, Output, Signature};

/// A node for one type of its generic inputs, or the only form of a node without them.
#[derive(Clone, Debug)]
pub struct Overload {
    /// The type [`Type::Generic`] stands for.
    pub generic: Option<Type>,
    /// The body; none for requests and loops.
    pub code: Option<BodyForms>,
    /// Per input, the guard under which it is demanded.
    pub guards: Vec<Option<BodyForms>>,
}

/// All there is to know of a node type.
#[derive(Clone, Debug)]
pub struct Definition {
    /// What users and the checker see.
    pub signature: Signature,
    /// What engines run.
    pub overloads: Vec<Overload>,
    /// Whether each component of the one output comes from those components of the inputs, and a
    /// colour has the alpha of the first.
    pub per_component: bool,
}

impl Overload {
    /// Words of a value of this type, as the overload has it.
    pub fn width(&self, value_type: Type) -> usize {
        match (value_type, self.generic) {
            (Type::Generic, Some(generic)) => generic.width(),
            (known, _) => known.width(),
        }
    }
}

impl Definition {
    /// A node the engines or the checker evaluate without a body: in one form for each type of its
    /// generic inputs.
    pub fn without_body(signature: Signature) -> Self {
        let guards = vec![None; signature.inputs.len()];
        Self::with_code(signature, None, guards)
    }

    /// A node whose code reads no generic input, and so is the same in the forms for all types.
    pub fn with_code(
        signature: Signature,
        code: Option<BodyForms>,
        guards: Vec<Option<BodyForms>>,
    ) -> Self {
        let overload = |generic| Overload { generic, code, guards: guards.clone() };
        let overloads = if signature.is_generic() {
            signature.generic.iter().map(|known| overload(Some(*known))).collect()
        } else {
            vec![overload(None)]
        };
        Self { signature, overloads, per_component: false }
    }

    /// A node that has a body for each type its generic inputs may have, and no conditions.
    pub fn of_bodies(signature: Signature, bodies: &[BodyForms]) -> Self {
        let guards = vec![None; signature.inputs.len()];
        let forms = signature.generic.iter().zip(bodies);
        let overload = |(of, code): (&Type, &BodyForms)| Overload {
            generic: Some(*of),
            code: Some(*code),
            guards: guards.clone(),
        };
        let overloads = forms.map(overload).collect();
        Self { signature, overloads, per_component: false }
    }

    /// The words of the inputs known before shading, as an overload has them: each with its input.
    pub fn fixed_words(&self, overload: &Overload) -> impl Iterator<Item = (usize, usize)> {
        let width = |value_type: Type| overload.width(value_type);
        let mut next = 0;
        let inputs = self.signature.inputs.iter().enumerate();
        inputs.filter_map(move |(at, input)| {
            let word = next;
            next += width(input.value_type);
            input.fixed.then_some((at, word))
        })
    }

    /// The node for ways to give what is known before shading, as tests go through them: each choice,
    /// and of counts the least, the next and the most. The ranges of those inputs are one number, and
    /// the code is for it.
    pub fn settled(&self) -> Vec<Self> {
        let mut all = vec![self.clone()];
        for at in (0..self.signature.inputs.len()).filter(|&at| self.signature.inputs[at].fixed) {
            let each = |definition: Self| {
                let range = definition.signature.inputs[at].range.clone();
                let (least, most) = (*range.start() as i32, *range.end() as i32);
                let choice = !definition.signature.inputs[at].choices.is_empty();
                let numbers = (least..=most)
                    .filter(move |&number| choice || number <= least + 1 || number == most);
                numbers.map(move |number| {
                    let mut settled = definition.clone();
                    settled.signature.inputs[at].range = number.into()..=number.into();
                    settled
                })
            };
            all = all.into_iter().flat_map(each).collect();
        }
        all.iter().map(Self::for_its_ranges).collect()
    }

    fn for_its_ranges(&self) -> Self {
        let mut settled = self.clone();
        for overload in &mut settled.overloads {
            let number = |at: usize| *self.signature.inputs[at].range.start() as i32;
            let fixed: Vec<_> =
                self.fixed_words(overload).map(|(at, word)| (word, number(at))).collect();
            overload.code = overload.code.map(|code| code.with_fixed(&fixed));
            for guard in overload.guards.iter_mut().flatten() {
                *guard = guard.with_fixed(&fixed);
            }
        }
        settled
    }

    /// A node whose outputs are fields of the state, by these names, with the ranges they have there.
    pub fn of_fields(
        name: impl Into<Name>,
        doc: &str,
        fields: impl IntoIterator<Item = (&'static str, Field)>,
    ) -> Self {
        let (names, fields): (Vec<_>, Vec<_>) = fields.into_iter().unzip();
        let output = |(&name, field): (&&'static str, &Field)| {
            let output = Output::new(name, &[field.doc()], field.value_type());
            match field.range() {
                Some(range) => output.within(range),
                None => output,
            }
        };
        Self::without_body(Signature {
            name: name.into(),
            group: "state",
            doc: doc.into(),
            source: "mental ray manual, miState",
            inputs: Vec::new(),
            outputs: names.iter().zip(&fields).map(output).collect(),
            kind: Kind::Fields(fields),
            generic: Type::GENERIC.into(),
            or_list: None,
        })
    }
}

/// Position of a node type in its [`NodeLibrary`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeType(pub usize);

/// A group of node types.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// Name: lower case, words joined by `_`.
    pub name: &'static str,
    /// What its nodes have in common: a sentence.
    pub doc: &'static str,
}

/// The node types graphs can use. A clone shares them; what is added to it is its own.
#[derive(Clone, Default)]
pub struct NodeLibrary {
    shared: Arc<Shared>,
}

#[derive(Clone, Default)]
struct Shared {
    definitions: Vec<Arc<Definition>>,
    by_name: HashMap<Name, NodeType>,
    groups: Vec<Group>,
}

impl NodeLibrary {
    /// Adds a group, after those there are, or replaces the doc of the one of the same name.
    pub fn add_group(&mut self, group: Group) {
        let groups = &mut Arc::make_mut(&mut self.shared).groups;
        match groups.iter_mut().find(|known| known.name == group.name) {
            Some(known) => *known = group,
            None => groups.push(group),
        }
    }

    /// Adds a node type, or replaces the one of the same name. Its group is added before.
    ///
    /// # Panics
    /// If engines could not run it; [`Definition::check`] tells beforehand. If there is no such group.
    pub fn add(&mut self, definition: Definition) {
        if let Err(error) = definition.check() {
            panic!("{error}");
        }
        let Signature { name, group, .. } = &definition.signature;
        let known = self.groups().iter().any(|known| known.name == *group);
        assert!(known, "`{name}` is of the group `{group}`, which the library does not have");
        let name = name.clone();
        let Shared { definitions, by_name, .. } = Arc::make_mut(&mut self.shared);
        let next = NodeType(definitions.len());
        let NodeType(at) = *by_name.entry(name).or_insert(next);
        if at == next.0 {
            definitions.push(Arc::new(definition));
        } else {
            definitions[at] = Arc::new(definition);
        }
    }

    /// The groups, in order.
    pub fn groups(&self) -> &[Group] {
        &self.shared.groups
    }

    /// The node type called `name`.
    pub fn find(&self, name: &str) -> Option<NodeType> {
        self.shared.by_name.get(name).copied()
    }

    /// The definition of a node type of this library.
    pub fn definition(&self, node_type: NodeType) -> &Definition {
        &self.shared.definitions[node_type.0]
    }

    /// The signature of a node type of this library.
    pub fn signature(&self, node_type: NodeType) -> &Signature {
        &self.definition(node_type).signature
    }

    /// Every node type with its definition, in the order of the list.
    pub fn iter(&self) -> impl Iterator<Item = (NodeType, &Definition)> {
        let definitions = self.shared.definitions.iter().enumerate();
        definitions.map(|(at, definition)| (NodeType(at), &**definition))
    }
}

/// How many there are: graphs hold their library, and their text should not.
impl fmt::Debug for NodeLibrary {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "NodeLibrary of {} nodes", self.shared.definitions.len())
    }
}
