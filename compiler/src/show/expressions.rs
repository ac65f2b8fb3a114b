//! Expressions as one box each, with their text, in the place of the nodes they became.

use std::collections::HashMap;

use crate::graph::Graph;

use super::diagram::{Card, Diagram, Given, InputSocket, OutputSocket, Role, Wire};

/// The expression of the graph that each card was written for, if one was.
pub(super) fn groups(diagram: &Diagram<'_>, graph: &Graph) -> Vec<Option<usize>> {
    let known: HashMap<&str, usize> =
        graph.expressions.iter().enumerate().map(|(at, it)| (it.name.as_str(), at)).collect();
    let group_of = |card: &Card<'_>| match card.role {
        Role::Node => {
            let base = card.title.rsplit_once('#').map_or(card.title, |(base, _)| base);
            known.get(base).copied()
        }
        Role::Parameter | Role::Root => None,
    };
    diagram.cards.iter().map(group_of).collect()
}

/// Puts a box in the place of the nodes of each expression the graph knows.
pub(super) fn close<'a>(diagram: &Diagram<'a>, graph: &'a Graph) -> Diagram<'a> {
    let groups = groups(diagram, graph);
    let mut closing = Closing::of(diagram, &groups, graph);
    for wire in &diagram.wires {
        closing.wire(diagram, &groups, wire);
    }
    Diagram {
        name: diagram.name,
        nodes: closing.cards.len() - diagram.parameters - graph.roots.len(),
        parameters: diagram.parameters,
        wires: closing.wires,
        cards: closing.cards.into_iter().map(|(card, _)| card).collect(),
    }
}

/// The diagram with boxes that are closed, as it grows.
struct Closing<'a> {
    /// Each with where its inputs come from; of closed ones only.
    cards: Vec<(Card<'a>, Vec<(usize, usize)>)>,
    /// Where the cards went.
    places: Vec<usize>,
    /// The outputs of closed ones, by card and output before.
    outputs: HashMap<(usize, usize), usize>,
    wires: Vec<Wire>,
}

impl<'a> Closing<'a> {
    fn of(diagram: &Diagram<'a>, groups: &[Option<usize>], graph: &'a Graph) -> Self {
        let mut boxes: HashMap<usize, usize> = HashMap::new();
        let mut closing = Self {
            cards: Vec::new(),
            places: Vec::with_capacity(groups.len()),
            outputs: HashMap::new(),
            wires: Vec::new(),
        };
        for (card, group) in diagram.cards.iter().zip(groups) {
            let next = closing.cards.len();
            let Some(group) = *group else {
                closing.places.push(next);
                closing.cards.push((card.clone(), Vec::new()));
                continue;
            };
            let at = *boxes.entry(group).or_insert(next);
            closing.places.push(at);
            if at == next {
                let text = graph.expressions[group].text.as_str();
                let card = Card {
                    title: text,
                    subtitle: "expression",
                    doc: "",
                    inputs: Vec::new(),
                    outputs: Vec::new(),
                    opens: Some(group),
                    ..card.clone()
                };
                closing.cards.push((card, Vec::new()));
                continue;
            }
            // It lives as long as one of its nodes does, and asks what any of them asks.
            let (closed, _) = &mut closing.cards[at];
            closed.dead = closed.dead.and(card.dead);
            if closed.badge.is_none() {
                closed.badge.clone_from(&card.badge);
            }
        }
        closing
    }

    fn wire(&mut self, diagram: &Diagram<'a>, groups: &[Option<usize>], wire: &Wire) {
        let ((from, output), (to, input)) = (wire.from, wire.to);
        if groups[from].is_some() && groups[from] == groups[to] {
            return;
        }
        let source = (self.places[from], self.output(diagram, groups, (from, output)));
        let target = self.places[to];
        if groups[to].is_none() {
            self.wires.push(Wire { from: source, to: (target, input), ..*wire });
            return;
        }
        let socket = &diagram.cards[to].inputs[input];
        let (card, sources) = &mut self.cards[target];
        if let Some(at) = sources.iter().position(|known| *known == source) {
            // One wire for all that reads the same: it is dead where all of them are.
            card.inputs[at].guarded &= socket.guarded;
            card.inputs[at].ruled_out &= socket.ruled_out;
            let same = self.wires.iter_mut().find(|it| it.to == (target, at));
            if let Some(same) = same {
                same.dead &= wire.dead;
                same.ruled_out &= wire.ruled_out;
            }
            return;
        }
        sources.push(source);
        let of = &diagram.cards[from];
        let name = match &of.outputs[output].name {
            _ if of.role == Role::Parameter => of.title.to_owned(),
            _ if groups[from].is_some() => "expression".to_owned(),
            name => format!("{}.{name}", of.title),
        };
        card.inputs.push(InputSocket {
            name: name.into(),
            value_type: of.outputs[output].value_type,
            guarded: socket.guarded,
            scoped: false,
            ruled_out: socket.ruled_out,
            given: Given::Wire,
        });
        let to = (target, card.inputs.len() - 1);
        self.wires.push(Wire { from: source, to, converts: false, ..*wire });
    }

    /// Where an output went.
    fn output(
        &mut self,
        diagram: &Diagram<'a>,
        groups: &[Option<usize>],
        from: (usize, usize),
    ) -> usize {
        if groups[from.0].is_none() {
            return from.1;
        }
        let (card, _) = &mut self.cards[self.places[from.0]];
        *self.outputs.entry(from).or_insert_with(|| {
            let value_type = diagram.cards[from.0].outputs[from.1].value_type;
            card.outputs.push(OutputSocket { name: "value", value_type });
            card.outputs.len() - 1
        })
    }
}
