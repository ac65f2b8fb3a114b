//! Pure code in an order in which all that a task reads stands before it.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap, HashMap};

use crate::specialise::{InstanceId, Specialised};
use crate::storage::Source;

use super::conditions::{ConditionId, Conditions, Slots};

/// What is to be done.
#[derive(Clone, Copy)]
pub(super) enum Task {
    /// Find out where a condition holds.
    Find(ConditionId),
    /// Evaluate an instance.
    Evaluate(InstanceId),
}

/// Tasks, and what each waits for.
pub(super) struct Queue<'a> {
    graph: &'a Specialised,
    owners: &'a Slots,
    conditions: &'a Conditions<'a>,
    tasks: Vec<(Task, ConditionId)>,
    /// For how many others each waits.
    waits: Vec<u32>,
    /// Who waits for each.
    waiting: Vec<Vec<u32>>,
    /// By depth and condition: first what is wanted more widely, so that the rest stands together.
    ready: BTreeMap<(u32, ConditionId), BinaryHeap<Reverse<u32>>>,
    current: (u32, ConditionId),
}

impl<'a> Queue<'a> {
    /// These tasks, each with the condition under which it is done. Of those that are ready under one
    /// condition, the first is taken.
    pub(super) fn new(
        graph: &'a Specialised,
        owners: &'a Slots,
        conditions: &'a Conditions<'a>,
        tasks: Vec<(Task, ConditionId)>,
    ) -> Self {
        let mut queue = Self {
            graph,
            owners,
            conditions,
            waits: vec![0; tasks.len()],
            waiting: vec![Vec::new(); tasks.len()],
            tasks,
            ready: BTreeMap::new(),
            current: (0, ConditionId::ALWAYS),
        };
        queue.link();
        queue
    }

    /// Finds who waits for whom.
    fn link(&mut self) {
        let (mut evaluations, mut findings) = (HashMap::new(), HashMap::new());
        for (at, (task, _)) in (0..).zip(&self.tasks) {
            match *task {
                Task::Evaluate(id) => evaluations.insert(id, at),
                Task::Find(condition) => findings.insert(condition, at),
            };
        }
        for at in 0..self.tasks.len() {
            let (task, under) = self.tasks[at];
            let (words, condition): (Vec<&[Source]>, _) = match task {
                Task::Evaluate(id) => (vec![&self.graph.instances[id].words], under),
                Task::Find(condition) => {
                    let condition = self.conditions.get(condition);
                    let guards = condition.demand.iter().flat_map(|demand| &demand.guards);
                    (guards.map(|guard| guard.words.as_slice()).collect(), condition.outside)
                }
            };
            let writers = words.into_iter().flat_map(|words| self.owners.writers(words));
            let mut before: Vec<u32> =
                writers.filter_map(|id| evaluations.get(&id).copied()).collect();
            before.extend(findings.get(&condition));
            before.sort_unstable();
            before.dedup();
            self.waits[at] = before.len() as u32;
            before.iter().for_each(|of| self.waiting[*of as usize].push(at as u32));
        }
        for at in 0..self.tasks.len() {
            if self.waits[at] == 0 {
                self.free(at as u32);
            }
        }
    }

    /// What is to be done next: as long as there is something, under the same condition.
    pub(super) fn next(&mut self) -> Option<(Task, ConditionId)> {
        let key = match self.ready.contains_key(&self.current) {
            true => self.current,
            false => *self.ready.first_key_value()?.0,
        };
        self.current = key;
        let ready = self.ready.get_mut(&key)?;
        let Reverse(at) = ready.pop()?;
        if ready.is_empty() {
            self.ready.remove(&key);
        }
        for of in std::mem::take(&mut self.waiting[at as usize]) {
            self.waits[of as usize] -= 1;
            if self.waits[of as usize] == 0 {
                self.free(of);
            }
        }
        Some(self.tasks[at as usize])
    }

    /// It waits for nothing more.
    fn free(&mut self, at: u32) {
        let (_, condition) = self.tasks[at as usize];
        let depth = self.conditions.get(condition).depth;
        self.ready.entry((depth, condition)).or_default().push(Reverse(at));
    }
}
