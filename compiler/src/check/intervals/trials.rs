//! What outputs surely come to be: the body is run at the ends of what its inputs reach.

use crate::emit::interval::Word;
use crate::kernels::BodyForms;

use super::value::{Reached, Value, number};

/// Words that are varied independently at most; more are varied together.
const INDEPENDENT: usize = 5;
/// Up to so many also take a value between their ends.
const WITH_MIDDLE: usize = 3;

/// For each output word what it reaches; none where that is not known. `sets` are the outputs of the
/// body's intervals, which tell what each of them reads.
pub fn reached(code: &BodyForms, inputs: &[Value], sets: &[Word]) -> Vec<Option<Reached>> {
    let mut found = vec![None; sets.len()];
    if sets.iter().all(|set| lacks(inputs, set.reads())) {
        return found;
    }
    let known: Vec<bool> = sets.iter().map(|set| is_independent(inputs, set.reads())).collect();
    if !known.contains(&true) {
        return found;
    }
    let ranks = ranks(inputs, sets, &known);
    let count = ranks.iter().flatten().max().map_or(0, |&rank| rank + 1).min(INDEPENDENT);
    let levels: usize = if count <= WITH_MIDDLE { 3 } else { 2 };
    let mut point = vec![0; inputs.len()];
    let mut outputs = vec![0; code.outputs];
    // What fails once, by not being finite, is known no more.
    let mut known = known;
    for trial in 0..levels.pow(count as u32) {
        for (at, (word, input)) in point.iter_mut().zip(inputs).enumerate() {
            let digit = ranks[at]
                .map_or(0, |rank| trial / levels.pow((rank % INDEPENDENT) as u32) % levels);
            *word = input.level(digit);
        }
        code.scalar(&point, &mut outputs);
        for (at, set) in sets.iter().enumerate() {
            match number(set, outputs[at]) {
                Some(x) if known[at] => include(&mut found[at], x),
                _ => known[at] = false,
            }
        }
    }
    for (at, set) in sets.iter().enumerate() {
        if !known[at] {
            found[at] = None;
        }
        if let Some(reached) = &mut found[at] {
            reached.connected = is_connected(inputs, set);
            reached.zero |= reached.connected && reached.low <= 0.0 && reached.high >= 0.0;
        }
    }
    found
}

/// The positions of the input words among `reads`. The last bit stands for many.
fn positions(inputs: &[Value], reads: u64) -> impl Iterator<Item = usize> {
    (0..inputs.len()).filter(move |&at| reads >> at.min(63) & 1 != 0)
}

/// Whether one of the input words reaches nothing: most often all there is to see.
fn lacks(inputs: &[Value], reads: u64) -> bool {
    positions(inputs, reads).any(|at| inputs[at].reached.is_none())
}

/// Whether all the input words reach something, and those that vary do so whatever the others are.
fn is_independent(inputs: &[Value], reads: u64) -> bool {
    let mut seen = 0;
    let mut names: Vec<u64> = Vec::new();
    for at in positions(inputs, reads) {
        let input = &inputs[at];
        let Some(reached) = input.reached else { return false };
        // One value that arrives twice varies once.
        if !reached.varies() || names.contains(&input.word.identity()) {
            continue;
        }
        if seen & input.sources != 0 {
            return false;
        }
        seen |= input.sources;
        names.push(input.word.identity());
    }
    true
}

/// For each input word that varies, which of the independent ones it is; those read by one output
/// differ where they can.
fn ranks(inputs: &[Value], sets: &[Word], known: &[bool]) -> Vec<Option<usize>> {
    let mut ranks: Vec<Option<usize>> = vec![None; inputs.len()];
    for (set, _) in sets.iter().zip(known).filter(|(_, known)| **known) {
        let varying = || positions(inputs, set.reads()).filter(|&at| inputs[at].varies());
        for at in varying() {
            if ranks[at].is_some() {
                continue;
            }
            let name = inputs[at].word.identity();
            let twin = (0..inputs.len())
                .find(|&other| ranks[other].is_some() && inputs[other].word.identity() == name);
            ranks[at] = match twin {
                Some(twin) => ranks[twin],
                None => (0..).find(|&rank| varying().all(|other| ranks[other] != Some(rank))),
            };
        }
    }
    ranks
}

fn include(found: &mut Option<Reached>, x: f32) {
    match found {
        Some(reached) => {
            reached.low = if x < reached.low { x } else { reached.low };
            reached.high = if x > reached.high { x } else { reached.high };
            reached.zero |= x == 0.0;
        }
        None => *found = Some(Reached::all(x, x)),
    }
}

/// Whether an output has no gap, because nothing it is made of has one.
fn is_connected(inputs: &[Value], set: &Word) -> bool {
    let smooth = matches!(set, Word::Number(number) if number.smooth);
    let whole = |at: usize| inputs[at].reached.is_some_and(|reached| reached.connected);
    smooth && positions(inputs, set.reads()).all(whole)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::intervals::given;
    use crate::nodes::NodeLibrary;
    use crate::values::Type;

    /// What the first output of a scalar node reaches for inputs in these ranges, `sources` being
    /// what they depend on.
    fn of(node: &str, ranges: &[(f64, f64)], sources: &[u64]) -> Option<Reached> {
        let library = NodeLibrary::standard();
        let definition = library.definition(library.find(node).expect("the node"));
        let code = definition.overloads[0].code.expect("a body");
        let inputs: Vec<Value> = (ranges.iter().zip(sources).enumerate())
            .map(|(at, (&(low, high), &sources))| {
                let known = given::within(Type::Scalar, &(low..=high));
                Value { sources, word: known.word.known_as(at as u64 + 1), ..known }
            })
            .collect();
        let words: Vec<Word> =
            (inputs.iter().enumerate()).map(|(at, input)| input.word.read_from(1 << at)).collect();
        let mut sets = vec![Word::UNKNOWN; code.outputs];
        code.intervals(&words, &mut sets);
        reached(&code, &inputs, &sets)[0]
    }

    #[test]
    fn independent_inputs_reach_the_corners() {
        let difference = of("subtract", &[(0.0, 1.0), (0.0, 2.0)], &[1, 2]);
        assert_eq!(difference, Some(Reached::all(-2.0, 1.0)));
        let mixed = of("mix", &[(0.0, 1.0), (1.0, 2.0), (3.0, 5.0)], &[1, 2, 4]).unwrap();
        // No wider, as intervals have it.
        assert_eq!((mixed.low, mixed.high), (1.0, 5.0));
        let floor = of("floor", &[(-0.5, 2.5)], &[1]).unwrap();
        assert_eq!((floor.low, floor.high, floor.connected, floor.zero), (-1.0, 2.0, false, true));
        let gap = of("select", &[(0.0, 0.0), (1.0, 1.0), (-1.0, -1.0)], &[1, 2, 4]);
        assert!(gap.is_none_or(|gap| !gap.zero), "{gap:?}");
    }

    #[test]
    fn inputs_with_a_common_source_reach_nothing_together() {
        assert_eq!(of("subtract", &[(0.0, 1.0), (0.0, 2.0)], &[1, 3]), None);
        // A constant depends on nothing.
        let moved = of("subtract", &[(0.0, 1.0), (0.5, 0.5)], &[1, 0]);
        assert_eq!(moved, Some(Reached::all(-0.5, 0.5)));
    }

    #[test]
    fn what_is_not_finite_is_not_reached() {
        assert_eq!(of("multiply", &[(1e30, 1e38), (1e30, 1e38)], &[1, 2]), None);
    }
}
