//! What of a diagram is never evaluated.

use super::diagram::{Dead, Diagram, Wire};

/// Finds what is evaluated: what a root reaches through inputs that no constant rules out.
pub(super) fn mark_dead(diagram: &mut Diagram<'_>) {
    let mut incoming: Vec<Vec<usize>> = vec![Vec::new(); diagram.cards.len()];
    for (at, wire) in diagram.wires.iter().enumerate() {
        incoming[wire.to.0].push(at);
    }
    let reached = reached(diagram, &incoming, |_| true);
    let evaluated = self::reached(diagram, &incoming, |wire| !wire.ruled_out);
    for (card, (reached, evaluated)) in diagram.cards.iter_mut().zip(reached.iter().zip(&evaluated))
    {
        card.dead = match (reached, evaluated) {
            (_, true) => None,
            (true, false) => Some(Dead::RuledOut),
            (false, false) => Some(Dead::Unreached),
        };
    }
    for wire in &mut diagram.wires {
        wire.dead = wire.ruled_out || !evaluated[wire.to.0];
    }
}

/// The cards from which such wires lead to a root. Iterative: chains may be long.
fn reached(
    diagram: &Diagram<'_>,
    incoming: &[Vec<usize>],
    follows: impl Fn(&Wire) -> bool,
) -> Vec<bool> {
    let first_root = diagram.parameters + diagram.nodes;
    let mut reached: Vec<bool> = (0..diagram.cards.len()).map(|card| card >= first_root).collect();
    let mut open: Vec<usize> = (first_root..diagram.cards.len()).collect();
    while let Some(card) = open.pop() {
        for wire in incoming[card].iter().map(|&at| &diagram.wires[at]).filter(|it| follows(it)) {
            if !std::mem::replace(&mut reached[wire.from.0], true) {
                open.push(wire.from.0);
            }
        }
    }
    reached
}
