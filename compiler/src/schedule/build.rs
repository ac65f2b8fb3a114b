//! From a specialised graph to its schedule.

use cranelift_entity::packed_option::PackedOption;
use cranelift_entity::{EntitySet, PrimaryMap, SecondaryMap};

use crate::specialise::{
    EpochId, Instance, InstanceId, InstanceKind, LightTableId, Specialised, Subject, Turns,
};
use crate::storage::Source;

use super::pure::{Pure, PureByLoop};
use super::{
    Item, Loop, LoopId, Region, RegionId, Request, RequestId, Schedule, Segment, SegmentId, Step,
    verify,
};

/// Schedules a specialised graph.
pub fn schedule(graph: &Specialised) -> Schedule {
    let reachable = reachable(graph);
    let effectful = effectful(graph, &reachable);
    let homes = homes(graph, &effectful);
    let mut builder = Builder {
        graph,
        effectful: &effectful,
        homes: &homes,
        regions: PrimaryMap::new(),
        segments: PrimaryMap::new(),
        requests: PrimaryMap::new(),
        loops: PrimaryMap::new(),
        slots: graph.slots,
        loop_of_epoch: SecondaryMap::new(),
        emitted: EntitySet::new(),
    };
    builder.list_loops();
    let pure = builder.pure_by_loop(&reachable);
    let mut pure = Pure::of(graph, &pure, &effectful, &mut builder.slots);
    for (region, head) in &homes.heads {
        let filled = builder.region(region, head, &mut pure);
        builder.regions.push(filled);
    }
    mark_shared(&mut builder.requests);
    let root = graph.instances[graph.root()].output;
    let schedule = Schedule {
        regions: builder.regions,
        segments: builder.segments,
        requests: builder.requests,
        loops: builder.loops,
        fields: graph.fields.clone(),
        slots: builder.slots,
        root,
        tables: graph.tables.clone(),
    };
    if cfg!(debug_assertions)
        && let Err(what) = verify(&schedule)
    {
        panic!("after schedule: {what}");
    }
    schedule
}

/// Marks requests of which others ask the same about the same light sample.
fn mark_shared(requests: &mut PrimaryMap<RequestId, Request>) {
    let table = |request: &Request| match request.subject {
        Subject::Light { table, .. } => Some(table),
        _ => None,
    };
    let mut askers: SecondaryMap<LightTableId, u32> = SecondaryMap::new();
    requests.values().filter_map(table).for_each(|table| askers[table] += 1);
    for request in requests.values_mut() {
        request.again |= table(request).is_some_and(|table| askers[table] > 1);
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
fn reachable(graph: &Specialised) -> EntitySet<InstanceId> {
    let mut reachable = EntitySet::with_capacity(graph.instances.len());
    reachable.insert(graph.root());
    for (id, instance) in graph.instances.iter().rev() {
        if reachable.contains(id) {
            reachable.extend(sources(instance));
        }
    }
    reachable
}

/// What asks something of the renderer, or reads what does.
fn effectful(graph: &Specialised, reachable: &EntitySet<InstanceId>) -> EntitySet<InstanceId> {
    let mut effectful = EntitySet::with_capacity(graph.instances.len());
    for (id, instance) in &graph.instances {
        let asks = !matches!(instance.kind, InstanceKind::Plain(_));
        if reachable.contains(id)
            && (asks || sources(instance).any(|source| effectful.contains(source)))
        {
            effectful.insert(id);
        }
    }
    // The root is a region of its own, whatever it asks.
    effectful.insert(graph.root());
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
    region: SecondaryMap<InstanceId, PackedOption<RegionId>>,
    heads: PrimaryMap<RegionId, Head>,
    /// Per loop instance, the region of its body.
    bodies: SecondaryMap<InstanceId, PackedOption<RegionId>>,
}

/// Finds a region for every effectful instance, users before sources: that of its users if all
/// demand it in one region, without guard and in its own loop; else one of its own.
fn homes(graph: &Specialised, effectful: &EntitySet<InstanceId>) -> Homes {
    #[derive(Clone, Copy, Default, PartialEq)]
    enum Demanded {
        #[default]
        Not,
        In(RegionId),
        Apart,
    }
    let mut demanded: SecondaryMap<InstanceId, Demanded> = SecondaryMap::new();
    let mut homes = Homes {
        region: SecondaryMap::new(),
        heads: PrimaryMap::new(),
        bodies: SecondaryMap::new(),
    };
    // The innermost loop epoch each region runs in.
    let mut region_loops: SecondaryMap<RegionId, Option<EpochId>> = SecondaryMap::new();
    for (id, instance) in graph.instances.iter().rev() {
        if !effectful.contains(id) {
            continue;
        }
        let own_loop = graph.epochs.innermost_loop(instance.epoch);
        let region = match demanded[id] {
            Demanded::In(region) if region_loops[region] == own_loop => region,
            _ => {
                let region = homes.heads.push(Head::Instance(id));
                region_loops[region] = own_loop;
                region
            }
        };
        homes.region[id] = region.into();
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
            let inside = homes.heads.push(Head::Body(id));
            region_loops[inside] = Some(*epoch);
            homes.bodies[id] = inside.into();
            if let Some(body) = body {
                demand(*body, Demanded::In(inside));
            }
        }
    }
    homes
}

struct Builder<'a> {
    graph: &'a Specialised,
    effectful: &'a EntitySet<InstanceId>,
    homes: &'a Homes,
    regions: PrimaryMap<RegionId, Region>,
    segments: PrimaryMap<SegmentId, Segment>,
    requests: PrimaryMap<RequestId, Request>,
    loops: PrimaryMap<LoopId, Loop>,
    slots: u32,
    loop_of_epoch: SecondaryMap<EpochId, PackedOption<LoopId>>,
    /// Effectful instances that stand in their region already.
    emitted: EntitySet<InstanceId>,
}

/// A region being filled.
struct Open {
    items: Vec<Item>,
    pending: Segment,
    stack: Vec<(InstanceId, usize)>,
}

impl Builder<'_> {
    /// Lists the loops. First all get their positions, for requests and loops inside name them.
    fn list_loops(&mut self) {
        let mut bodies: PrimaryMap<LoopId, _> = PrimaryMap::new();
        for (id, instance) in &self.graph.instances {
            let InstanceKind::Loop { epoch, .. } = instance.kind else { continue };
            let Some(region) = self.homes.bodies[id].expand() else { continue };
            self.loop_of_epoch[epoch] = bodies.push((instance, region)).into();
        }
        for &(instance, region) in bodies.values() {
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
        let renewed = self.homes.heads.iter().filter_map(|(region, head)| {
            let Head::Instance(head) = head else { return None };
            inside(self.graph.instances[*head].epoch).then_some(region)
        });
        let tables = self.graph.tables.iter();
        let emptied = tables.filter_map(|(at, table)| inside(table.epoch).then_some(at));
        let turns = match turns {
            Turns::Lights { list } => Turns::Lights { list: *list },
            Turns::Samples { count, site, loops } => {
                Turns::Samples { count: *count, site: *site, loops: self.positions(loops) }
            }
        };
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
    fn positions(&self, epochs: &[EpochId]) -> Vec<LoopId> {
        epochs.iter().filter_map(|epoch| self.loop_of_epoch[*epoch].expand()).collect()
    }

    /// Pure instances by the innermost loop they belong to; those of no loop by the point.
    fn pure_by_loop(&self, reachable: &EntitySet<InstanceId>) -> PureByLoop {
        let mut pure = PureByLoop::new();
        for (id, instance) in &self.graph.instances {
            if reachable.contains(id) && !self.effectful.contains(id) {
                let at = self.graph.epochs.innermost_loop(instance.epoch);
                pure[at.unwrap_or(EpochId::POINT)].push(id);
            }
        }
        pure
    }

    /// Fills one region.
    fn region(&mut self, region: RegionId, head: &Head, pure: &mut Pure<'_>) -> Region {
        let mut open = Open { items: Vec::new(), pending: Segment::default(), stack: Vec::new() };
        let (name, prologue) = match head {
            Head::Instance(id) => {
                open.stack.push((*id, 0));
                let is_root = *id == self.graph.root();
                (self.graph.instances[*id].name.clone(), is_root.then_some(EpochId::POINT))
            }
            Head::Body(id) => {
                let instance = &self.graph.instances[*id];
                let mut prologue = None;
                if let InstanceKind::Loop { epoch, body, .. } = &instance.kind {
                    prologue = Some(*epoch);
                    if let Some(body) = body.filter(|body| self.effectful.contains(*body)) {
                        let forced = self.homes.region[body].expand().unwrap_or(region);
                        if forced == region {
                            open.stack.push((body, 0));
                        } else {
                            open.items.push(Item::Force { region: forced, guard: None });
                        }
                    }
                }
                (format!("{} body", instance.name), prologue)
            }
        };
        let forced_first = std::mem::take(&mut open.items);
        if let Some(of) = prologue {
            open.pending.steps = std::mem::take(&mut pure.steps[of]);
        }
        if !forced_first.is_empty() {
            self.flush(&mut open);
            open.items.extend(forced_first);
        }
        while let Some((id, next)) = open.stack.pop() {
            self.visit(region, &mut open, id, next, pure);
        }
        self.flush(&mut open);
        Region { name, items: open.items }
    }

    /// Goes on with an effectful instance of this region: what it demands first, then itself.
    fn visit(
        &mut self,
        region: RegionId,
        open: &mut Open,
        id: InstanceId,
        mut next: usize,
        pure: &Pure<'_>,
    ) {
        let graph = self.graph;
        let instance = &graph.instances[id];
        while let Some(demand) = instance.demands.get(next) {
            next += 1;
            if !self.effectful.contains(demand.source) {
                continue;
            }
            let home = self.homes.region[demand.source].expand();
            if home == Some(region) {
                if !self.emitted.contains(demand.source) {
                    open.stack.push((id, next));
                    open.stack.push((demand.source, 0));
                    return;
                }
            } else if let Some(forced) = home {
                let guard = demand.guard.as_ref().map(|guard| {
                    if let Some(known) = pure.guard(id, guard) {
                        return Source::Slot(known);
                    }
                    let output = self.slots;
                    self.slots += 1;
                    let demanded = &graph.instances[demand.source].name;
                    let step = Step::of_guard(guard, &instance.name, demanded, output);
                    open.pending.steps.push(step);
                    Source::Slot(output)
                });
                self.flush(open);
                open.items.push(Item::Force { region: forced, guard });
            }
        }
        self.emitted.insert(id);
        match &instance.kind {
            InstanceKind::Plain(_) => open.pending.steps.extend(Step::of(instance)),
            InstanceKind::Request { effect, context, site, loops, subject } => {
                self.flush(open);
                let request = self.requests.push(Request {
                    name: instance.name.clone(),
                    effect: *effect,
                    words: instance.words.clone(),
                    output: instance.output,
                    outputs: instance.outputs,
                    context: context.clone(),
                    site: *site,
                    loops: self.positions(loops),
                    subject: self.subject(*subject),
                    again: self.is_run_anew(instance),
                });
                open.items.push(Item::Request(request));
            }
            InstanceKind::Loop { epoch, .. } => {
                self.flush(open);
                open.items.extend(self.loop_of_epoch[*epoch].expand().map(Item::Loop));
            }
        }
    }

    /// Whether what is asked of a light may be asked again though one request alone asks it. In a single loop it
    /// is not: nothing renews the region of that loop, and a region that is forced twice is run for other points.
    /// A loop round that one runs it anew, with the same light samples.
    fn is_run_anew(&self, instance: &Instance) -> bool {
        self.graph.epochs.0[instance.epoch].loops.len() > 1
    }

    /// What a request is about, a loop by its position in the schedule.
    fn subject(&self, subject: Subject<EpochId>) -> Subject<LoopId> {
        match subject {
            Subject::Light { of, table } => match self.loop_of_epoch[of].expand() {
                Some(of) => Subject::Light { of, table },
                None => unreachable!("what is asked inside a loop is reached through the loop"),
            },
            Subject::Point => Subject::Point,
            Subject::Texture(texture, sampling) => Subject::Texture(texture, sampling),
        }
    }

    fn flush(&mut self, open: &mut Open) {
        if !open.pending.steps.is_empty() {
            let segment = self.segments.push(std::mem::take(&mut open.pending));
            open.items.push(Item::Segment(segment));
        }
    }
}
