//! Where instances are wanted: the guards common to all ways from the root to each.
//!
//! A *condition* is a guard below another condition; they make a tree, at whose root nothing is asked.
//! Demands with the same guard below the same condition share one. What is demanded in several ways has
//! the condition that these have in common, which holds wherever a point wants it, and maybe elsewhere.
//! Guards that cannot be known when pure code is run are left out: those over answers of the renderer,
//! and those over the turn of a loop that the instance does not belong to.

use std::collections::HashMap;

use cranelift_entity::packed_option::PackedOption;
use cranelift_entity::{EntitySet, PrimaryMap, SecondaryMap, entity_impl};

use crate::specialise::{EpochId, EpochKind, Guard, InstanceId, InstanceKind, Specialised};
use crate::storage::Source;

/// Position in [`Conditions`].
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct ConditionId(u32);
entity_impl!(ConditionId, "condition");

impl ConditionId {
    /// The root of the tree, which always holds.
    pub(super) const ALWAYS: Self = Self(0);
}

/// A guard, or one of several, below another condition.
#[derive(Clone)]
pub(super) struct Condition<'a> {
    /// The one outside; of the root, itself.
    pub(super) outside: ConditionId,
    /// Who demands whom where it holds. None for the root.
    pub(super) demand: Option<Demanded<'a>>,
    /// The innermost loop of whose turns it or those outside speak; the point where they speak of none.
    pub(super) turns: EpochId,
    pub(super) depth: u32,
    /// One further out, so that any is reached in few steps.
    jump: ConditionId,
}

/// What an instance demands of another, in one way or several.
#[derive(Clone)]
pub(super) struct Demanded<'a> {
    /// One of them holds.
    pub(super) guards: Vec<&'a Guard>,
    pub(super) by: InstanceId,
    pub(super) of: InstanceId,
    /// The innermost loop of whose turns the guards speak, or the point.
    turns: EpochId,
}

/// What guards do, and over which words.
type Key<'a> = Vec<(usize, &'a [Source])>;

/// The tree of conditions, and where each instance stands in it.
pub(super) struct Conditions<'a> {
    graph: &'a Specialised,
    all: PrimaryMap<ConditionId, Condition<'a>>,
    known: HashMap<(ConditionId, Key<'a>), ConditionId>,
    seen_from: HashMap<(ConditionId, EpochId), ConditionId>,
    of: SecondaryMap<InstanceId, PackedOption<ConditionId>>,
}

impl<'a> Conditions<'a> {
    /// Those of the instances that the root may demand.
    pub(super) fn of(
        graph: &'a Specialised,
        slots: &Slots,
        effectful: &EntitySet<InstanceId>,
    ) -> Self {
        let root = Condition {
            outside: ConditionId::ALWAYS,
            demand: None,
            turns: EpochId::POINT,
            depth: 0,
            jump: ConditionId::ALWAYS,
        };
        let mut conditions = Self {
            graph,
            all: PrimaryMap::from_iter([root]),
            known: HashMap::new(),
            seen_from: HashMap::new(),
            of: SecondaryMap::new(),
        };
        conditions.of[graph.root()] = ConditionId::ALWAYS.into();
        for (id, instance) in graph.instances.iter().rev() {
            let Some(met) = conditions.of[id].expand() else { continue };
            let turns = graph.epochs.innermost_loop(instance.epoch).unwrap_or(EpochId::POINT);
            let at = conditions.seen_from(met, turns);
            conditions.of[id] = at.into();
            for position in 0..instance.demands.len() {
                let source = instance.demands[position].source;
                let place = match slots.demanded(graph, id, position, effectful) {
                    Some(demanded) => conditions.below(at, demanded),
                    None => at,
                };
                conditions.meet(source, place);
            }
            if let InstanceKind::Loop { body: Some(body), .. } = &instance.kind {
                conditions.meet(*body, at);
            }
        }
        conditions
    }

    /// The condition of an instance; of what is never demanded, the one that always holds.
    pub(super) fn of_instance(&self, id: InstanceId) -> ConditionId {
        self.of[id].expand().unwrap_or(ConditionId::ALWAYS)
    }

    /// A condition.
    pub(super) fn get(&self, id: ConditionId) -> &Condition<'a> {
        &self.all[id]
    }

    /// Whether all that holds in `inner` holds in `outer`.
    pub(super) fn is_within(&self, inner: ConditionId, outer: ConditionId) -> bool {
        self.common(inner, outer) == outer
    }

    /// One more way in which an instance is demanded.
    fn meet(&mut self, id: InstanceId, place: ConditionId) {
        let met = self.of[id].expand().map_or(place, |met| self.common(met, place));
        self.of[id] = met.into();
    }

    /// The condition of a demand that is made where `outside` holds.
    fn below(&mut self, outside: ConditionId, demand: Demanded<'a>) -> ConditionId {
        let key = (outside, key(&demand.guards));
        if let Some(&known) = self.known.get(&key) {
            return known;
        }
        let turns = demand.turns;
        let outer = &self.all[outside];
        let jump = &self.all[outer.jump];
        let far = outer.depth - jump.depth == jump.depth - self.all[jump.jump].depth;
        let loops = |of: EpochId| self.graph.epochs.0[of].loops.len();
        let condition = Condition {
            outside,
            demand: Some(demand),
            turns: if loops(turns) > loops(outer.turns) { turns } else { outer.turns },
            depth: outer.depth + 1,
            jump: if far { jump.jump } else { outside },
        };
        let id = self.all.push(condition);
        self.known.insert(key, id);
        id
    }

    /// The condition of demands with this guard that are made where `outside` holds, if there is one.
    pub(super) fn find(&self, outside: ConditionId, guard: &Guard) -> Option<ConditionId> {
        self.known.get(&(outside, key(&[guard]))).copied()
    }

    /// The innermost condition round both.
    fn common(&self, a: ConditionId, b: ConditionId) -> ConditionId {
        let depth = |of: ConditionId| self.all[of].depth;
        let up = |mut from: ConditionId, to: u32| {
            while depth(from) > to {
                let Condition { outside, jump, .. } = &self.all[from];
                let (outside, jump) = (*outside, *jump);
                from = if depth(jump) >= to { jump } else { outside };
            }
            from
        };
        let (mut a, mut b) = (up(a, depth(b)), up(b, depth(a)));
        while a != b {
            let (of_a, of_b) = (&self.all[a], &self.all[b]);
            (a, b) = match of_a.jump == of_b.jump {
                true => (of_a.outside, of_b.outside),
                false => (of_a.jump, of_b.jump),
            };
        }
        a
    }

    /// What is left of a condition where of all loops only `turns` and those round it are known.
    fn seen_from(&mut self, condition: ConditionId, turns: EpochId) -> ConditionId {
        let mut unseen = Vec::new();
        let mut at = condition;
        let mut seen = loop {
            let Condition { outside, turns: spoken_of, .. } = self.all[at].clone();
            if self.knows(turns, spoken_of) {
                break at;
            }
            if let Some(&seen) = self.seen_from.get(&(at, turns)) {
                break seen;
            }
            unseen.push(at);
            at = outside;
        };
        for of in unseen.into_iter().rev() {
            if let Some(demand) = self.all[of].demand.clone()
                && self.knows(turns, demand.turns)
            {
                seen = self.below(seen, demand);
            }
            self.seen_from.insert((of, turns), seen);
        }
        seen
    }

    /// Whether the turns of a loop are known inside another, or the same.
    fn knows(&self, inside: EpochId, turns: EpochId) -> bool {
        turns == EpochId::POINT || self.graph.epochs.0[inside].loops.contains(&turns)
    }
}

/// What bodies record is kept, and known by its address.
fn key<'a>(guards: &[&'a Guard]) -> Key<'a> {
    let of = |guard: &&'a Guard| {
        (std::ptr::from_ref(guard.code.recorded()) as usize, guard.words.as_slice())
    };
    guards.iter().map(of).collect()
}

/// Who writes each slot.
pub(super) struct Slots(Vec<Owner>);

#[derive(Clone, Copy)]
enum Owner {
    /// The point, or whoever uses the slot besides.
    Point,
    /// The turns of a loop.
    Loop(EpochId),
    Instance(InstanceId),
}

impl Slots {
    /// Those of a graph.
    pub(super) fn of(graph: &Specialised) -> Self {
        let mut slots = Self(vec![Owner::Point; graph.slots as usize]);
        for (id, epoch) in &graph.epochs.0 {
            if let EpochKind::Loop { iterated, fields, .. } = epoch.kind {
                slots.own(fields, iterated.words() as u32, Owner::Loop(id));
            }
        }
        for (id, instance) in &graph.instances {
            slots.own(instance.output, instance.outputs, Owner::Instance(id));
        }
        slots
    }

    fn own(&mut self, first: u32, count: u32, owner: Owner) {
        self.0[first as usize..(first + count) as usize].fill(owner);
    }

    /// The instances that write these words.
    pub(super) fn writers(&self, words: &[Source]) -> impl Iterator<Item = InstanceId> {
        words.iter().filter_map(|word| match *word {
            Source::Slot(slot) => match self.0[slot as usize] {
                Owner::Instance(id) => Some(id),
                Owner::Point | Owner::Loop(_) => None,
            },
            Source::Uniform(_) | Source::Constant { .. } => None,
        })
    }

    /// What the instance demands where it demands what it demands at that position. None if it does so
    /// always, or where that cannot be known: all ways are over words that are there before the first.
    fn demanded<'a>(
        &self,
        graph: &'a Specialised,
        by: InstanceId,
        position: usize,
        effectful: &EntitySet<InstanceId>,
    ) -> Option<Demanded<'a>> {
        let demands = &graph.instances[by].demands;
        let of = demands[position].source;
        let first = demands.iter().position(|demand| demand.source == of)?;
        let ready = &demands[..first];
        let mut guards = Vec::new();
        let mut turns = EpochId::POINT;
        for demand in demands[first..].iter().filter(|demand| demand.source == of) {
            let guard = demand.guard.as_ref()?;
            let is_ready = |id| ready.iter().any(|demand| demand.source == id);
            if !self.are_pure(&guard.words, effectful) || !self.writers(&guard.words).all(is_ready)
            {
                return None;
            }
            let own = self.turns(graph, &guard.words);
            let loops = |of: EpochId| graph.epochs.0[of].loops.len();
            turns = if loops(own) > loops(turns) { own } else { turns };
            guards.push(guard);
        }
        guards.dedup_by_key(|guard| key(&[*guard]));
        Some(Demanded { guards, by, of, turns })
    }

    /// Whether no word is written by what asks the renderer or reads the answer.
    fn are_pure(&self, words: &[Source], effectful: &EntitySet<InstanceId>) -> bool {
        self.writers(words).all(|id| !effectful.contains(id))
    }

    /// The innermost loop of whose turns these words speak, or the point.
    fn turns(&self, graph: &Specialised, words: &[Source]) -> EpochId {
        let slots = words.iter().filter_map(|word| match *word {
            Source::Slot(slot) => Some(self.0[slot as usize]),
            Source::Uniform(_) | Source::Constant { .. } => None,
        });
        let turns = slots.filter_map(|owner| match owner {
            Owner::Point => None,
            Owner::Loop(of) => Some(of),
            Owner::Instance(id) => graph.epochs.innermost_loop(graph.instances[id].epoch),
        });
        turns.max_by_key(|of| graph.epochs.0[*of].loops.len()).unwrap_or(EpochId::POINT)
    }
}
