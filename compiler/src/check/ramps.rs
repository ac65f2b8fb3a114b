//! A ramp over stops, as the nodes it stands for.
//!
//! Stops are found by halving: `select` nodes over `less` nodes, of depth log2 of their number, with a
//! `ramp_segment` between each two. So a point evaluates one passage and the values of its ends, positions and
//! values may be parameters or be computed, and an edit of one is no new code.

use crate::diagnostics::Code;
use crate::document::Reader;
use crate::graph::{Binding, Node};
use crate::values::{Literal, Type};

use super::draft::Draft;
use super::lists::{List, node, select, truth};

/// Whether each value has its position; a finding where not. Nodes over lists that take no positions have no
/// pairs.
pub(super) fn are_paired(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    node: usize,
    positions: &[Binding],
    values: &[Binding],
) -> bool {
    if positions.is_empty() || positions.len() == values.len() {
        return true;
    }
    let drafted = &draft.nodes[node];
    let of_positions = drafted.inputs.iter().find(|input| input.member.key == "positions");
    let Some(place) = of_positions.map(|input| &input.member.value) else { return true };
    let message = format!(
        "node `{}` has {} positions and {} values",
        draft.told_name(node),
        positions.len(),
        values.len()
    );
    reader.report(Code::WRONG_LENGTH, place, message, "give each value its position");
    false
}

/// The node that takes the place of a ramp, and those that are added; none where the library lacks their
/// types.
pub(super) fn ramp(list: List<'_>) -> Option<(Node, Vec<Node>)> {
    let generic = list.values.generic;
    let [only] = &list.values.values[..] else { return Ramp { added: Vec::new(), list }.nodes() };
    Some((select(list.library, list.name, generic, truth(), only.clone())?, Vec::new()))
}

struct Ramp<'l> {
    list: List<'l>,
    added: Vec<Node>,
}

impl Ramp<'_> {
    fn nodes(mut self) -> Option<(Node, Vec<Node>)> {
        self.order()?;
        // Below the first stop, the passages, and past the last one.
        let top = self.choose(0, self.list.values.values.len())?;
        Some((top, self.added))
    }

    /// A node that is added.
    fn add(&mut self, node: Node) -> Binding {
        self.added.push(node);
        Binding::Node { node: self.list.next + self.added.len() - 1, output: 0 }
    }

    /// Lets no stop stand before an earlier one.
    fn order(&mut self) -> Option<()> {
        for at in 1..self.list.values.positions.len() {
            let before = self.list.values.positions[at - 1].clone();
            let own = self.list.values.positions[at].clone();
            let ordered = match (number(&before), number(&own)) {
                (Some(a), Some(b)) => Binding::Literal(Literal::Scalar(if b > a { b } else { a })),
                _ => {
                    let name = format!("{}.position[{at}]", self.list.name);
                    let inputs = vec![("a", before), ("b", own)];
                    let scalar = Some(Type::Scalar);
                    let node = node(self.list.library, "maximum", name, scalar, inputs)?;
                    self.add(node)
                }
            };
            self.list.values.positions[at] = ordered;
        }
        Some(())
    }

    /// Region `from` to region `to`, of which there are two or more, by a stop in the middle of them.
    fn choose(&mut self, from: usize, to: usize) -> Option<Node> {
        let middle = usize::midpoint(from, to);
        let name = match (from, to) {
            (0, last) if last == self.list.values.values.len() => self.list.name.to_owned(),
            _ => format!("{}[{from} to {to}]", self.list.name),
        };
        let position = self.list.values.positions[middle].clone();
        let inputs = vec![("a", self.list.values.index.clone()), ("b", position)];
        let asked = format!("{name}?");
        let library = self.list.library;
        // Comparisons may be of one type or of several.
        let below = node(library, "less", asked.clone(), Some(Type::Scalar), inputs.clone())
            .or_else(|| node(library, "less", asked, None, inputs))?;
        let below = self.add(below);
        let (left, right) = (self.regions(from, middle)?, self.regions(middle + 1, to)?);
        let inputs = vec![("condition", below), ("if_true", left), ("if_false", right)];
        node(library, "select", name, Some(self.list.values.generic), inputs)
    }

    fn regions(&mut self, from: usize, to: usize) -> Option<Binding> {
        if from < to {
            let chosen = self.choose(from, to)?;
            return Some(self.add(chosen));
        }
        let values = &self.list.values.values;
        if from == 0 || from == values.len() {
            return Some(values[from.saturating_sub(1)].clone());
        }
        self.segment(from)
    }

    /// From the stop before `to` to it.
    fn segment(&mut self, to: usize) -> Option<Binding> {
        let values = &self.list.values;
        let from = to - 1;
        let (before, after) = (from.saturating_sub(1), (to + 1).min(values.values.len() - 1));
        let (positions, stops) = (&values.positions, &values.values);
        let inputs = vec![
            ("input", values.index.clone()),
            ("interpolation", values.interpolation.clone()),
            ("from", positions[from].clone()),
            ("to", positions[to].clone()),
            ("start", stops[from].clone()),
            ("end", stops[to].clone()),
            ("before", positions[before].clone()),
            ("after", positions[after].clone()),
            ("value_before", stops[before].clone()),
            ("value_after", stops[after].clone()),
        ];
        let name = format!("{}[{to}]", self.list.name);
        let segment = node(self.list.library, "ramp_segment", name, Some(values.generic), inputs)?;
        Some(self.add(segment))
    }
}

/// The number a literal position is.
fn number(binding: &Binding) -> Option<f32> {
    match binding {
        Binding::Literal(Literal::Scalar(number)) => Some(*number),
        _ => None,
    }
}
