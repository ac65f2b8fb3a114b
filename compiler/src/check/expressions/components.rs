//! Components and swizzles: `.x`, `.rgb`, `.zyx`.

use crate::diagnostics::{Advice, Code, listed, shortened};
use crate::document::Value;
use crate::values::Type;

use super::operand::{Is, Operand};
use super::writer::Writer;

/// What letters pick: positions of components, and whether they are those of colours.
fn letters(name: &str) -> Option<(Vec<usize>, bool)> {
    let pick = |of: &str| name.chars().map(|c| of.find(c)).collect::<Option<Vec<usize>>>();
    let found = pick("xyz").map(|at| (at, false)).or_else(|| pick("rgba").map(|at| (at, true)));
    found.filter(|(at, _)| at.len() <= 4)
}

impl Writer<'_, '_> {
    /// The components of a part that a name picks.
    pub fn component(&mut self, at: usize, of: usize, name: &str) -> Operand {
        let Some(arrives) = self.arrives(of) else { return Operand::broken() };
        let own = arrives.own();
        let width = match own {
            Type::Vector => 3,
            Type::Color => 4,
            _ => 0,
        };
        let fits = letters(name).filter(|(picked, _)| picked.iter().all(|at| *at < width));
        match fits {
            None => {
                self.no_component(at, of, name, own);
                Operand::broken()
            }
            Some((picked, of_color)) => self.picked(at, of, own, (&picked, of_color)),
        }
    }

    fn picked(
        &mut self,
        at: usize,
        of: usize,
        own: Type,
        (picked, of_color): (&[usize], bool),
    ) -> Operand {
        let (made, least) = if of_color { (Type::Color, 3) } else { (Type::Vector, 2) };
        let whole = (0..picked.len()).eq(picked.iter().copied());
        match picked {
            [one] => self
                .split(at, of, own)
                .map_or(Operand::broken(), |apart| self.part_at(&apart, *one)),
            // As a whole it is what it was.
            _ if whole && made == own && picked.len() == if of_color { 4 } else { 3 } => {
                self.operands[of].clone()
            }
            _ if picked.len() < least || picked.len() == 4 && !of_color => {
                let mark = self.parsed.parts[at].mark.clone();
                let name = self.quote(&mark);
                let message =
                    format!("`.{name}` has {} components, which is no type", picked.len());
                let help = "a vector has two or three of `xyz` (z is 0 where it is left out), a color three or four of `rgba`";
                self.report(Code::UNKNOWN_NAME, &mark, message, help);
                Operand::broken()
            }
            _ => {
                let Some(apart) = self.split(at, of, own) else { return Operand::broken() };
                let (together, keys) = match made {
                    Type::Color => ("combine_color", ["r", "g", "b", "a"]),
                    _ => ("combine_vector", ["x", "y", "z", ""]),
                };
                let inputs: Vec<(&str, Value)> = keys
                    .into_iter()
                    .zip(picked)
                    .map(|(key, from)| (key, self.at(of, &self.part_at(&apart, *from))))
                    .collect();
                self.first_of(at, together, inputs, made)
            }
        }
    }

    /// A node of a part whose first output is of a type.
    pub fn first_of(
        &mut self,
        at: usize,
        type_name: &str,
        inputs: Vec<(&str, Value)>,
        made: Type,
    ) -> Operand {
        let node = self.node(at, type_name, None, inputs);
        match node.is {
            Is::Broken => node,
            _ => Operand::of(node.json, made),
        }
    }

    /// The node that takes a part apart: the same for equal parts.
    fn split(&mut self, at: usize, of: usize, own: Type) -> Option<Operand> {
        let (type_name, input) = match own {
            Type::Color => ("split_color", "color"),
            _ => ("split_vector", "vector"),
        };
        let key = format!("{type_name} {:?}", self.operands[of].json);
        if let Some(known) = self.splits.get(&key) {
            return Some(known.clone());
        }
        let value = self.value_of(of);
        let node = self.node(at, type_name, None, vec![(input, value)]);
        if node.is == Is::Broken {
            return None;
        }
        self.splits.insert(key, node.clone());
        Some(node)
    }

    /// An output of a node that takes something apart.
    fn part_at(&self, apart: &Operand, output: usize) -> Operand {
        match &apart.is {
            Is::Node(name, node_type, _) => self.output_of(name, (*node_type, None), output),
            _ => Operand::broken(),
        }
    }

    /// Reports a name behind a part that picks nothing.
    fn no_component(&mut self, at: usize, of: usize, name: &str, own: Type) {
        let text = self.text(of);
        let mark = self.parsed.parts[at].mark.clone();
        let shown = shortened(name);
        let components = match own {
            Type::Vector => "its components are `.x`, `.y` and `.z`",
            Type::Color => "its components are `.r`, `.g`, `.b` and `.a`",
            _ => "",
        };
        if let Is::Node(node, node_type, _) = &self.operands[of].is {
            let signature = self.draft.node_types.signature(*node_type);
            let outputs = || signature.outputs.iter().map(|output| &*output.name);
            let advice = self.reader.advice(name, outputs(), None, || {
                let outputs = listed(outputs());
                match components {
                    "" => format!("its outputs are {outputs}"),
                    _ => format!("its outputs are {outputs}; of the first {components}"),
                }
            });
            let kind = &signature.name;
            let what = match self.draft.node_names.get(node.as_str()) {
                Some(&node) => self.draft.described(node),
                None => format!("`{text}` ({kind})"),
            };
            let message = format!("{what} has no output `{shown}`");
            return self.advise(Code::UNKNOWN_NAME, &mark, message, advice);
        }
        let what = crate::check::type_names::with_article(own);
        let message = format!("`{text}` is {what}, which has no component `{shown}`");
        let help = match components {
            "" => "only vectors and colors have components".to_owned(),
            known => known.to_owned(),
        };
        self.advise(Code::UNKNOWN_NAME, &mark, message, Advice::from(help));
    }
}
