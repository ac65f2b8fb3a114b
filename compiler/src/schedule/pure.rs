//! The order of pure code: what is wanted under one condition stands together, and is skipped as one.
//!
//! All pure instances of one loop, or of none, are run together. Those under a condition are heavy enough
//! to be skipped, or are run always, as if there were none. Whether a condition holds is found by a step
//! that is always run, from the guard and the word of the condition outside: the guard may read what is
//! stale where that one does not hold.

use std::collections::BTreeMap;

use cranelift_entity::{EntitySet, SecondaryMap};

use crate::specialise::{EpochId, Guard, InstanceId, InstanceKind, Specialised, internal};
use crate::storage::Source;

use super::Step;
use super::conditions::{ConditionId, Conditions, Slots};
use super::queue::{Queue, Task};

/// Fewest operations that are worth asking whether someone wants them: a mask, a test and a jump a
/// block, and code that is fused less.
pub const LEAST_SKIPPED: usize = 32;

/// Pure instances by the innermost loop they belong to; those of no loop by the point.
pub(super) type PureByLoop = SecondaryMap<EpochId, Vec<InstanceId>>;

/// The pure instances of a graph, scheduled.
pub(super) struct Pure<'a> {
    /// The steps of each loop; those of no loop by the point.
    pub(super) steps: SecondaryMap<EpochId, Vec<Step>>,
    conditions: Conditions<'a>,
    words: Words,
}

/// Of each condition that something is skipped by: the slot of its guard, and that of its word.
type Words = SecondaryMap<ConditionId, Option<(u32, u32)>>;

impl<'a> Pure<'a> {
    /// Schedules them. New slots are taken from `slots` on.
    pub(super) fn of(
        graph: &'a Specialised,
        pure: &PureByLoop,
        effectful: &EntitySet<InstanceId>,
        slots: &mut u32,
    ) -> Self {
        let owners = Slots::of(graph);
        let conditions = Conditions::of(graph, &owners, effectful);
        let order = Order { graph, owners: &owners, conditions: &conditions };
        let stretches = order.by_loop(pure);
        let words = order.words(&stretches, slots);
        let of =
            |(turns, stretches): (EpochId, &Vec<Stretch>)| (turns, order.steps(stretches, &words));
        let steps = stretches.iter().map(of).collect();
        Self { steps, conditions, words }
    }

    /// The slot in which the guard of a demand stands already, made by an instance.
    pub(super) fn guard(&self, by: InstanceId, guard: &Guard) -> Option<u32> {
        let condition = self.conditions.find(self.conditions.of_instance(by), guard)?;
        self.words[condition].map(|(guard, _)| guard)
    }
}

/// For each condition of an instance, the one under which it is skipped: itself, or one outside.
type Kept = BTreeMap<ConditionId, ConditionId>;

/// What is run together, where one condition holds.
#[derive(Clone, Default)]
struct Stretch {
    condition: ConditionId,
    weight: usize,
    tasks: Vec<Task>,
}

struct Order<'a> {
    graph: &'a Specialised,
    owners: &'a Slots,
    conditions: &'a Conditions<'a>,
}

impl Order<'_> {
    /// The stretches of each loop.
    fn by_loop(&self, pure: &PureByLoop) -> SecondaryMap<EpochId, Vec<Stretch>> {
        let mut all: SecondaryMap<EpochId, Kept> = SecondaryMap::new();
        let mut found_in: SecondaryMap<EpochId, Vec<ConditionId>> = SecondaryMap::new();
        let mut found = EntitySet::new();
        for (turns, instances) in pure.iter() {
            all[turns] = self.kept(instances);
            for &condition in all[turns].values() {
                self.with_outer(condition, &mut found, |of| {
                    found_in[self.conditions.get(of).turns].push(of);
                });
            }
        }
        let mut stretches: SecondaryMap<EpochId, Vec<Stretch>> = SecondaryMap::new();
        for (turns, kept) in all.iter() {
            // Outer ones first: their positions rise inwards.
            found_in[turns].sort_unstable();
            stretches[turns] = self.stretches(&pure[turns], kept, &found_in[turns]);
        }
        stretches
    }

    /// Which conditions are worth it: those under which enough is to be skipped that is not under
    /// another one inside; what is under too little counts for the one outside.
    fn kept(&self, instances: &[InstanceId]) -> Kept {
        let mut weights: BTreeMap<ConditionId, usize> = BTreeMap::new();
        for &id in instances {
            *weights.entry(self.conditions.of_instance(id)).or_default() += self.weight(id);
        }
        let mut kept: Kept = Kept::new();
        while let Some((of, weight)) = weights.pop_last() {
            let enough = of == ConditionId::ALWAYS || weight >= LEAST_SKIPPED;
            let outside = self.conditions.get(of).outside;
            kept.insert(of, if enough { of } else { outside });
            if !enough {
                *weights.entry(outside).or_default() += weight;
            }
        }
        // From outside inwards: where the one outside went, this one goes too.
        for of in kept.keys().copied().collect::<Vec<_>>() {
            let to = kept[&of];
            let to = kept.get(&to).copied().unwrap_or(to);
            kept.insert(of, to);
        }
        kept
    }

    /// Visits a condition and those outside that were not found yet.
    fn with_outer(
        &self,
        mut condition: ConditionId,
        found: &mut EntitySet<ConditionId>,
        mut visit: impl FnMut(ConditionId),
    ) {
        while condition != ConditionId::ALWAYS && found.insert(condition) {
            visit(condition);
            condition = self.conditions.get(condition).outside;
        }
    }

    fn weight(&self, id: InstanceId) -> usize {
        match &self.graph.instances[id].kind {
            InstanceKind::Plain(code) => code.recorded().weight(),
            InstanceKind::Request { .. } | InstanceKind::Loop { .. } => 0,
        }
    }

    /// The instances in stretches, with what finds out where the conditions hold.
    fn stretches(
        &self,
        instances: &[InstanceId],
        kept: &Kept,
        found: &[ConditionId],
    ) -> Vec<Stretch> {
        let under = |id: InstanceId| kept[&self.conditions.of_instance(id)];
        if found.is_empty() && instances.iter().all(|&id| under(id) == ConditionId::ALWAYS) {
            let tasks = instances.iter().map(|&id| Task::Evaluate(id)).collect();
            return vec![Stretch { condition: ConditionId::ALWAYS, weight: 0, tasks }];
        }
        let finds = found.iter().map(|&of| (Task::Find(of), ConditionId::ALWAYS));
        let evaluations = instances.iter().map(|&id| (Task::Evaluate(id), under(id)));
        let tasks = finds.chain(evaluations).collect();
        let mut queue = Queue::new(self.graph, self.owners, self.conditions, tasks);
        let mut stretches: Vec<Stretch> = Vec::new();
        while let Some((task, condition)) = queue.next() {
            let weight = match task {
                Task::Evaluate(id) => self.weight(id),
                Task::Find(_) => 0,
            };
            append(&mut stretches, Stretch { condition, weight, tasks: vec![task] });
        }
        self.without_small(stretches)
    }

    /// Runs what is too little to be skipped with a neighbour under a condition further out, or always.
    fn without_small(&self, stretches: Vec<Stretch>) -> Vec<Stretch> {
        let mut result: Vec<Stretch> = Vec::new();
        let conditions: Vec<_> = stretches.iter().map(|stretch| stretch.condition).collect();
        for (at, mut stretch) in stretches.into_iter().enumerate() {
            if stretch.weight < LEAST_SKIPPED {
                let before = result.last().map(|stretch| stretch.condition);
                let after = conditions.get(at + 1).copied();
                let outer = |of: &ConditionId| self.conditions.is_within(stretch.condition, *of);
                let neighbours = [before, after].into_iter().flatten().filter(outer);
                let next = neighbours.max_by_key(|of| self.conditions.get(*of).depth);
                stretch.condition = next.unwrap_or(ConditionId::ALWAYS);
            }
            append(&mut result, stretch);
        }
        result
    }

    /// Takes slots for the conditions of stretches, and those outside.
    fn words(&self, stretches: &SecondaryMap<EpochId, Vec<Stretch>>, slots: &mut u32) -> Words {
        let mut found = EntitySet::new();
        let mut needed = Vec::new();
        for stretch in stretches.values().flatten() {
            self.with_outer(stretch.condition, &mut found, |of| needed.push(of));
        }
        needed.sort_unstable();
        let mut words = Words::new();
        for of in needed {
            let condition = self.conditions.get(of);
            let guards = condition.demand.as_ref().map_or(1, |demand| demand.guards.len()) as u32;
            let is_outermost = condition.outside == ConditionId::ALWAYS;
            // Each guard, what becomes of each two, and of that and the word outside.
            let count = 2 * guards - u32::from(is_outermost);
            words[of] = Some((*slots, *slots + count - 1));
            *slots += count;
        }
        words
    }

    fn steps(&self, stretches: &[Stretch], words: &Words) -> Vec<Step> {
        let mut steps = Vec::new();
        for stretch in stretches {
            let wanted = words[stretch.condition].map(|(_, word)| Source::Slot(word));
            for task in &stretch.tasks {
                match *task {
                    Task::Find(condition) => self.find_out(condition, words, &mut steps),
                    Task::Evaluate(id) => {
                        let wanted = wanted.into_iter().collect();
                        let step = Step::of(&self.graph.instances[id]);
                        steps.extend(step.map(|step| Step { wanted, ..step }));
                    }
                }
            }
        }
        steps
    }

    /// The steps that find out where a condition holds, if something is skipped by it.
    fn find_out(&self, condition: ConditionId, words: &Words, steps: &mut Vec<Step>) {
        let Some((first, _)) = words[condition] else { return };
        let condition = self.conditions.get(condition);
        let Some(demand) = &condition.demand else { return };
        let by = &self.graph.instances[demand.by].name;
        let of = &self.graph.instances[demand.of].name;
        let mut next = first;
        let mut slot = || {
            next += 1;
            next - 1
        };
        let guards: Vec<u32> = demand.guards.iter().map(|_| slot()).collect();
        for (guard, at) in demand.guards.iter().zip(&guards) {
            steps.push(Step::of_guard(guard, by, of, *at));
        }
        let mut joined = |code, [a, b]: [u32; 2], name| {
            let words = vec![Source::Slot(a), Source::Slot(b)];
            let output = slot();
            steps.push(Step { name, code, words, output, wanted: Vec::new(), is_guard: true });
            output
        };
        let mut word = guards[0];
        for guard in &guards[1..] {
            let name = format!("{by} demands {of} in some way");
            word = joined(internal::either_code(), [word, *guard], name);
        }
        if let Some((_, outer)) = words[condition.outside] {
            let name = format!("{by} is wanted and demands {of}");
            joined(internal::both_code(), [outer, word], name);
        }
    }
}

/// Puts a stretch behind others; to the last one, if that is under the same condition.
fn append(stretches: &mut Vec<Stretch>, stretch: Stretch) {
    match stretches.last_mut().filter(|last| last.condition == stretch.condition) {
        Some(last) => {
            last.weight += stretch.weight;
            last.tasks.extend(stretch.tasks);
        }
        None => stretches.push(stretch),
    }
}
