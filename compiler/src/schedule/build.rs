//! From a specialised graph to its schedule.

use crate::specialise::{EpochId, Instance, InstanceId, InstanceKind, Specialised, Subject, Turns};
use crate::storage::Source;

use super::{Item, Loop, Region, RegionId, Request, Schedule, Segment, Step};

/// Schedules a specialised graph.
pub fn schedule(graph: &Specialised) -> Schedule {
    let reachable = reachable(graph);
    let effectful = effectful(graph, &reachable);
    let homes = homes(graph, &reachable, &effectful);
    let mut builder = Builder {
        graph,
        effectful: &effectful,
        homes: &homes,
        regions: vec![Region::default(); homes.count],
        segments: Vec::new(),
        requests: Vec::new(),
        loops: Vec::new(),
        slots: graph.slots,
        loop_of_epoch: vec![None; graph.epochs.0.len()],
        emitted: vec![false; graph.instances.len()],
    };
    builder.list_loops(&reachable);
    let pure = builder.pure_by_loop(&reachable);
    for (region, head) in homes.heads.iter().enumerate() {
        builder.region(region, head, &pure);
    }
    let root = graph.instances[graph.root()].output;
    Schedule {
        regions: builder.regions,
        segments: builder.segments,
        requests: builder.requests,
        loops: builder.loops,
        fields: graph.fields.clone(),
        slots: builder.slots,
        root,
        light_lists: graph.light_lists.clone(),
        tables: graph.tables.clone(),
        textures: graph.textures.clone(),
    }
}

/// Everything an instance may demand, the body of a loop included.
fn sources(instance: &Instance) -> impl Iterator<Item = InstanceId> {
    let body = match &instance.kind {
        InstanceKind::Loop { body, .. } => *body,
        InstanceKind::Plain(_) | InstanceKind::Request { .. } => None,
    };
    instance.demands.iter().map(|demand| demand.source).chain(body)
}

/// What the root may demand. Sources come before their users, so one pass from the end suffices.
fn reachable(graph: &Specialised) -> Vec<bool> {
    let mut reachable = vec![false; graph.instances.len()];
    reachable[graph.root()] = true;
    for id in (0..graph.instances.len()).rev() {
        if reachable[id] {
            sources(&graph.instances[id]).for_each(|source| reachable[source] = true);
        }
    }
    reachable
}

/// What asks something of the renderer, or reads what does.
fn effectful(graph: &Specialised, reachable: &[bool]) -> Vec<bool> {
    let mut effectful = vec![false; graph.instances.len()];
    for (id, instance) in graph.instances.iter().enumerate() {
        let asks = !matches!(instance.kind, InstanceKind::Plain(_));
        effectful[id] =
            reachable[id] && (asks || sources(instance).any(|source| effectful[source]));
    }
    // The root is a region of its own, whatever it asks.
    effectful[graph.root()] = true;
    effectful
}

/// What a region is run for.
#[derive(Clone, Copy, Debug)]
enum Head {
    /// An instance, demanded from several places or under a guard.
    Instance(InstanceId),
    /// The body of this loop instance, once per iteration.
    Body(InstanceId),
}

/// The region each effectful instance is run in.
struct Homes {
    region: Vec<Option<RegionId>>,
    heads: Vec<Head>,
    /// Per loop instance, the region of its body.
    bodies: Vec<Option<RegionId>>,
    count: usize,
}

/// Finds a region for every effectful instance, users before sources: that of its users if all
/// demand it in one region, without guard and in its own loop; else one of its own.
fn homes(graph: &Specialised, reachable: &[bool], effectful: &[bool]) -> Homes {
    #[derive(Clone, Copy, PartialEq)]
    enum Demanded {
        Not,
        In(RegionId),
        Apart,
    }
    let count = graph.instances.len();
    let mut demanded = vec![Demanded::Not; count];
    let mut homes =
        Homes { region: vec![None; count], heads: Vec::new(), bodies: vec![None; count], count: 0 };
    // The innermost loop epoch each region runs in.
    let mut region_loops: Vec<Option<EpochId>> = Vec::new();
    for id in (0..count).rev() {
        if !reachable[id] || !effectful[id] {
            continue;
        }
        let instance = &graph.instances[id];
        let own_loop = graph.epochs.innermost_loop(instance.epoch);
        let region = match demanded[id] {
            Demanded::In(region) if region_loops[region] == own_loop => region,
            _ => {
                homes.heads.push(Head::Instance(id));
                region_loops.push(own_loop);
                homes.heads.len() - 1
            }
        };
        homes.region[id] = Some(region);
        let mut demand = |source: InstanceId, place: Demanded| {
            demanded[source] = match demanded[source] {
                Demanded::Not => place,
                already if already == place => place,
                _ => Demanded::Apart,
            };
        };
        for edge in &instance.demands {
            let apart = edge.guard.is_some();
            demand(edge.source, if apart { Demanded::Apart } else { Demanded::In(region) });
        }
        if let InstanceKind::Loop { epoch, body, .. } = &instance.kind {
            homes.heads.push(Head::Body(id));
            region_loops.push(Some(*epoch));
            let inside = homes.heads.len() - 1;
            homes.bodies[id] = Some(inside);
            if let Some(body) = body {
                demand(*body, Demanded::In(inside));
            }
        }
    }
    homes.count = homes.heads.len();
    homes
}

struct Builder<'a> {
    graph: &'a Specialised,
    effectful: &'a [bool],
    homes: &'a Homes,
    regions: Vec<Region>,
    segments: Vec<Segment>,
    requests: Vec<Request>,
    loops: Vec<Loop>,
    slots: u32,
    loop_of_epoch: Vec<Option<usize>>,
    /// Effectful instances that stand in their region already.
    emitted: Vec<bool>,
}

/// A region being filled.
struct Open {
    items: Vec<Item>,
    pending: Segment,
    stack: Vec<(InstanceId, usize)>,
}

impl Builder<'_> {
    /// Lists the loops. First all get their positions, for requests and loops inside name them.
    fn list_loops(&mut self, reachable: &[bool]) {
        let mut bodies = Vec::new();
        for (id, instance) in self.graph.instances.iter().enumerate() {
            let InstanceKind::Loop { epoch, .. } = instance.kind else { continue };
            let Some(region) = self.homes.bodies[id].filter(|_| reachable[id]) else { continue };
            self.loop_of_epoch[epoch] = Some(bodies.len());
            bodies.push((instance, region));
        }
        for (instance, region) in bodies {
            self.loops.extend(self.new_loop(instance, region));
        }
    }

    /// The loop of a loop instance, with the region of its body.
    fn new_loop(&self, instance: &Instance, region: RegionId) -> Option<Loop> {
        let InstanceKind::Loop {
            epoch, turns, reduction, value_type, fields, words, context, ..
        } = &instance.kind
        else {
            return None;
        };
        let inside = |of: EpochId| self.graph.epochs.within(of, *epoch);
        let renewed = self.homes.heads.iter().enumerate().filter_map(|(region, head)| {
            let Head::Instance(head) = head else { return None };
            inside(self.graph.instances[*head].epoch).then_some(region)
        });
        let tables = self.graph.tables.iter().enumerate();
        let emptied = tables.filter_map(|(at, table)| inside(table.epoch).then_some(at));
        let mut turns = turns.clone();
        if let Turns::Samples { loops, .. } = &mut turns {
            *loops = self.positions(loops);
        }
        Some(Loop {
            name: instance.name.clone(),
            turns,
            reduction: *reduction,
            value_type: *value_type,
            epoch: *epoch,
            fields: *fields,
            region,
            words: words.clone(),
            output: instance.output,
            context: context.clone(),
            renewed: renewed.collect(),
            emptied: emptied.collect(),
        })
    }

    /// The positions of the loops of epochs.
    fn positions(&self, epochs: &[EpochId]) -> Vec<usize> {
        epochs.iter().filter_map(|epoch| self.loop_of_epoch[*epoch]).collect()
    }

    /// Pure instances by the innermost loop they belong to: first those of no loop.
    fn pure_by_loop(&self, reachable: &[bool]) -> Vec<Vec<InstanceId>> {
        let mut pure = vec![Vec::new(); self.graph.epochs.0.len() + 1];
        for (id, instance) in self.graph.instances.iter().enumerate() {
            if reachable[id] && !self.effectful[id] {
                let at = self.graph.epochs.innermost_loop(instance.epoch);
                pure[at.map_or(0, |epoch| epoch + 1)].push(id);
            }
        }
        pure
    }

    /// Fills one region.
    fn region(&mut self, region: RegionId, head: &Head, pure: &[Vec<InstanceId>]) {
        let mut open = Open { items: Vec::new(), pending: Segment::default(), stack: Vec::new() };
        let (name, prologue) = match head {
            Head::Instance(id) => {
                open.stack.push((*id, 0));
                let is_root = *id == self.graph.root();
                (self.graph.instances[*id].name.clone(), is_root.then_some(0))
            }
            Head::Body(id) => {
                let instance = &self.graph.instances[*id];
                let mut prologue = None;
                if let InstanceKind::Loop { epoch, body, .. } = &instance.kind {
                    prologue = Some(epoch + 1);
                    if let Some(body) = body.filter(|body| self.effectful[*body]) {
                        if self.homes.region[body] == Some(region) {
                            open.stack.push((body, 0));
                        } else {
                            let forced = self.homes.region[body].unwrap_or(region);
                            open.items.push(Item::Force { region: forced, guard: None });
                        }
                    }
                }
                (format!("{} body", instance.name), prologue)
            }
        };
        let forced_first = std::mem::take(&mut open.items);
        for &id in prologue.map_or(&[][..], |at| &pure[at]) {
            self.evaluate(&mut open, id);
        }
        if !forced_first.is_empty() {
            self.flush(&mut open);
            open.items.extend(forced_first);
        }
        while let Some((id, next)) = open.stack.pop() {
            self.visit(region, &mut open, id, next);
        }
        self.flush(&mut open);
        self.regions[region] = Region { name, items: open.items };
    }

    /// Goes on with an effectful instance of this region: what it demands first, then itself.
    fn visit(&mut self, region: RegionId, open: &mut Open, id: InstanceId, mut next: usize) {
        let graph = self.graph;
        let instance = &graph.instances[id];
        while let Some(demand) = instance.demands.get(next) {
            next += 1;
            if !self.effectful[demand.source] {
                continue;
            }
            let home = self.homes.region[demand.source];
            if home == Some(region) {
                if !self.emitted[demand.source] {
                    open.stack.push((id, next));
                    open.stack.push((demand.source, 0));
                    return;
                }
            } else if let Some(forced) = home {
                let guard = demand.guard.as_ref().map(|guard| {
                    let output = self.slots;
                    self.slots += 1;
                    open.pending.steps.push(Step {
                        name: format!(
                            "{} demands {}",
                            instance.name, graph.instances[demand.source].name
                        ),
                        code: guard.code,
                        words: guard.words.clone(),
                        output,
                    });
                    Source::Slot(output)
                });
                self.flush(open);
                open.items.push(Item::Force { region: forced, guard });
            }
        }
        self.emitted[id] = true;
        match &instance.kind {
            InstanceKind::Plain(_) => self.evaluate(open, id),
            InstanceKind::Request { effect, context, site, loops, subject } => {
                self.flush(open);
                open.items.push(Item::Request(self.requests.len()));
                let loops = self.positions(loops);
                self.requests.push(Request {
                    name: instance.name.clone(),
                    effect: *effect,
                    words: instance.words.clone(),
                    output: instance.output,
                    outputs: instance.outputs,
                    context: context.clone(),
                    site: *site,
                    loops,
                    subject: self.subject(*subject),
                });
            }
            InstanceKind::Loop { epoch, .. } => {
                self.flush(open);
                open.items.extend(self.loop_of_epoch[*epoch].map(Item::Loop));
            }
        }
    }

    /// What a request is about, a loop by its position in the schedule.
    fn subject(&self, subject: Subject) -> Subject {
        match subject {
            Subject::Light { of, table } => match self.loop_of_epoch[of] {
                Some(of) => Subject::Light { of, table },
                None => unreachable!("what is asked inside a loop is reached through the loop"),
            },
            Subject::Point | Subject::Texture(_) => subject,
        }
    }

    fn evaluate(&self, open: &mut Open, id: InstanceId) {
        let instance = &self.graph.instances[id];
        if let InstanceKind::Plain(code) = &instance.kind {
            open.pending.steps.push(Step {
                name: instance.name.clone(),
                code: *code,
                words: instance.words.clone(),
                output: instance.output,
            });
        }
    }

    fn flush(&mut self, open: &mut Open) {
        if !open.pending.steps.is_empty() {
            open.items.push(Item::Segment(self.segments.len()));
            self.segments.push(std::mem::take(&mut open.pending));
        }
    }
}
