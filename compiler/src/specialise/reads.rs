//! Which fields of the state a node reads, itself or through its inputs: what decides whether it is
//! evaluated anew inside a scope.

use crate::nodes::Kind;
use crate::state::FieldSet;

use super::SpecialiseError;
use super::views::{Resolved, Views};

/// For every view, the fields it reads. Iterative: chains may be long.
pub(super) fn reads(views: &Views<'_>) -> Result<Vec<FieldSet>, SpecialiseError> {
    #[derive(Clone, Copy, PartialEq)]
    enum Mark {
        New,
        Open,
        Done,
    }
    let mut sets = vec![FieldSet::NONE; views.len()];
    let mut marks = vec![Mark::New; views.len()];
    for start in 0..views.len() {
        let mut stack = vec![(start, 0)];
        while let Some((view, input)) = stack.pop() {
            if marks[view] == Mark::Done {
                continue;
            }
            marks[view] = Mark::Open;
            let inputs = views.inputs(view);
            let next = (input..inputs).find_map(|k| {
                let source = views.source(view, k).filter(|&it| marks[it] != Mark::Done);
                source.map(|source| (k, source))
            });
            match next {
                Some((_, source)) if marks[source] == Mark::Open => {
                    return Err(SpecialiseError::Inconsistent {
                        node: views.name(view).to_owned(),
                        problem: "its connections form a cycle".to_owned(),
                    });
                }
                Some((k, source)) => {
                    stack.push((view, k + 1));
                    stack.push((source, 0));
                }
                None => {
                    sets[view] = reads_of(views, &sets, view);
                    marks[view] = Mark::Done;
                }
            }
        }
    }
    Ok(sets)
}

/// What one input reads, given the sets of the views below.
pub(super) fn reads_of_input(
    views: &Views<'_>,
    sets: &[FieldSet],
    view: usize,
    input: usize,
) -> FieldSet {
    match views.resolve(view, input) {
        Resolved::State(field) => field.into(),
        Resolved::Node { view: source, output } => match &views.signature(source).kind {
            Kind::Fields(fields) => fields[output].into(),
            _ => sets[source],
        },
        Resolved::Literal(_) | Resolved::Parameter(_) => FieldSet::NONE,
    }
}

fn reads_of(views: &Views<'_>, sets: &[FieldSet], view: usize) -> FieldSet {
    let signature = views.signature(view);
    let mut set = match &signature.kind {
        Kind::Request(effect) => effect.reads().iter().copied().collect(),
        Kind::Loop(iterated, _) => iterated.reads().iter().copied().collect(),
        Kind::Plain | Kind::Fields(_) | Kind::Scope(_) | Kind::List(_) => FieldSet::NONE,
    };
    let changed = match &signature.kind {
        Kind::Scope(fields) => fields.iter().copied().collect(),
        Kind::Loop(iterated, _) => iterated.provides().collect(),
        _ => FieldSet::NONE,
    };
    for (input, declared) in signature.inputs.iter().enumerate() {
        let below = reads_of_input(views, sets, view, input);
        set |= if declared.scoped { below - changed } else { below };
    }
    set
}
