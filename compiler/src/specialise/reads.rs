//! Which fields of the state a node reads, itself or through its inputs: what decides whether it is
//! evaluated anew inside a scope.

use std::ops::{BitOr, BitOrAssign, Sub};

use crate::nodes::Kind;
use crate::state::Field;

use super::SpecialiseError;
use super::views::{Resolved, Views};

/// A set of state fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct FieldSet(u32);

impl FieldSet {
    /// No field.
    pub const NONE: FieldSet = FieldSet(0);

    /// Whether `field` is in it.
    pub fn contains(self, field: Field) -> bool {
        self.0 & (1 << field as u32) != 0
    }

    /// Whether some field is in both.
    pub fn meets(self, other: FieldSet) -> bool {
        self.0 & other.0 != 0
    }
}

impl From<Field> for FieldSet {
    fn from(field: Field) -> Self {
        FieldSet(1 << field as u32)
    }
}

impl FromIterator<Field> for FieldSet {
    fn from_iter<I: IntoIterator<Item = Field>>(fields: I) -> Self {
        fields.into_iter().fold(FieldSet::NONE, |set, field| set | field.into())
    }
}

impl BitOr for FieldSet {
    type Output = FieldSet;
    fn bitor(self, other: FieldSet) -> FieldSet {
        FieldSet(self.0 | other.0)
    }
}

impl BitOrAssign for FieldSet {
    fn bitor_assign(&mut self, other: FieldSet) {
        self.0 |= other.0;
    }
}

impl Sub for FieldSet {
    type Output = FieldSet;
    fn sub(self, other: FieldSet) -> FieldSet {
        FieldSet(self.0 & !other.0)
    }
}

/// The fields of a light sample.
pub(super) fn light_fields() -> FieldSet {
    Field::ALL.iter().copied().filter(|field| field.is_of_light()).collect()
}

/// What a light loop itself reads to find its samples.
pub(super) const LIGHT_LOOP_READS: [Field; 2] = [Field::Point, Field::NormalGeom];

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
            let next = (input..inputs).find_map(|k| match views.resolve(view, k) {
                Resolved::Node { view: source, .. } if marks[source] != Mark::Done => {
                    Some((k, source))
                }
                _ => None,
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
        Kind::LightLoop => LIGHT_LOOP_READS.into_iter().collect(),
        Kind::Plain | Kind::Fields(_) | Kind::Scope(_) | Kind::List(_) => FieldSet::NONE,
    };
    let changed = match &signature.kind {
        Kind::Scope(fields) => fields.iter().copied().collect(),
        Kind::LightLoop => light_fields(),
        _ => FieldSet::NONE,
    };
    for (input, declared) in signature.inputs.iter().enumerate() {
        let below = reads_of_input(views, sets, view, input);
        set |= if declared.scoped { below - changed } else { below };
    }
    set
}
