//! What holds of a schedule: what the executor and the jit rely on. Asked after each one is made in debug builds.

use cranelift_entity::{EntityRef, EntitySet, PrimaryMap, SecondaryMap};

use crate::ops::verify::masks;
use crate::specialise::{Subject, Turns};
use crate::state::Iterated;
use crate::storage::Source;

use super::{Item, Loop, LoopId, RegionId, Request, Schedule, Step};

/// Whether each segment, request and loop stands in one region, once; whether each region but the root's is
/// forced, or the body of one loop, by regions before it; whether each slot is written by one; whether each
/// slot that is read is a field or written, in the same region before; whether masks are masks; whether
/// all that is named exists.
///
/// # Errors
/// What is wrong, and where.
pub fn verify(schedule: &Schedule) -> Result<(), String> {
    let mut check = Check {
        schedule,
        writers: vec![None; schedule.slots as usize],
        bodies: SecondaryMap::new(),
        forced: EntitySet::new(),
    };
    check.places()?;
    check.regions()?;
    for (region, of) in &schedule.regions {
        let mut place = Place { region, item: 0, step: 0 };
        for (at, item) in of.items.iter().enumerate() {
            place.item = at;
            check.item(item, place).map_err(|what| format!("{region} ({}): {what}", of.name))?;
        }
    }
    let root: Vec<Source> = (schedule.root..schedule.root + 5).map(Source::Slot).collect();
    let end = Place { region: RegionId::ROOT, item: usize::MAX, step: 0 };
    check.reads(root.iter().copied(), end)
}

/// Where something is run.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
struct Place {
    region: RegionId,
    item: usize,
    step: usize,
}

#[derive(Clone, Copy)]
enum Writer<'a> {
    /// A field of the state, or of a turn.
    Field,
    Step(Place, &'a Step),
    Other(Place),
}

struct Check<'a> {
    schedule: &'a Schedule,
    writers: Vec<Option<Writer<'a>>>,
    /// How many loops have the region as their body.
    bodies: SecondaryMap<RegionId, u32>,
    forced: EntitySet<RegionId>,
}

impl<'a> Check<'a> {
    /// Finds who writes each slot, and that all that is run is run in one place.
    fn places(&mut self) -> Result<(), String> {
        let schedule = self.schedule;
        for &(field, first) in &schedule.fields {
            self.write(first, field.value_type().width(), Writer::Field)?;
        }
        let mut segments = once(&schedule.segments);
        let mut requests = once(&schedule.requests);
        let mut loops = once(&schedule.loops);
        for (region, of) in &schedule.regions {
            for (item, it) in of.items.iter().enumerate() {
                let place = Place { region, item, step: 0 };
                match it {
                    Item::Segment(at) => {
                        take(&mut segments, *at)?;
                        for (step, of) in schedule.segments[*at].steps.iter().enumerate() {
                            let writer = Writer::Step(Place { step, ..place }, of);
                            self.write(of.output, of.code.outputs, writer)?;
                        }
                    }
                    Item::Request(at) => {
                        take(&mut requests, *at)?;
                        let of = &schedule.requests[*at];
                        self.write(of.output, of.outputs as usize, Writer::Other(place))?;
                    }
                    Item::Loop(at) => {
                        take(&mut loops, *at)?;
                        self.loops(&schedule.loops[*at], place)?;
                    }
                    Item::Force { region: forced, .. } => {
                        if !schedule.regions.is_valid(*forced) || *forced <= region {
                            return Err(format!("{region} forces {forced}, not one after it"));
                        }
                        self.forced.insert(*forced);
                    }
                }
            }
        }
        let left = segments.values().chain(requests.values()).chain(loops.values());
        match left.copied().any(|left| left) {
            true => Err("something is run in no region".to_owned()),
            false => Ok(()),
        }
    }

    fn loops(&mut self, of: &'a Loop, place: Place) -> Result<(), String> {
        self.write(of.output, of.value_type.width(), Writer::Other(place))?;
        let iterated = match &of.turns {
            Turns::Lights { .. } => Iterated::Lights,
            Turns::Samples { .. } => Iterated::Samples,
        };
        self.write(of.fields, iterated.words(), Writer::Field)?;
        if !self.schedule.regions.is_valid(of.region) || of.region <= place.region {
            return Err(format!("the body of {} is {}, not one after it", of.name, of.region));
        }
        self.bodies[of.region] += 1;
        Ok(())
    }

    fn write(&mut self, first: u32, count: usize, writer: Writer<'a>) -> Result<(), String> {
        for slot in first..first + count as u32 {
            match self.writers.get_mut(slot as usize) {
                None => return Err(format!("slot {slot} is written and is none")),
                Some(Some(_)) => return Err(format!("slot {slot} is written by two")),
                Some(of) => *of = Some(writer),
            }
        }
        Ok(())
    }

    fn regions(&self) -> Result<(), String> {
        for (region, of) in &self.schedule.regions {
            let ways = self.bodies[region] + u32::from(self.forced.contains(region));
            if ways != u32::from(region != RegionId::ROOT) {
                return Err(format!("{region} ({}) is run in {ways} ways", of.name));
            }
        }
        Ok(())
    }

    fn item(&self, item: &Item, place: Place) -> Result<(), String> {
        match item {
            Item::Segment(at) => {
                for (step, of) in self.schedule.segments[*at].steps.iter().enumerate() {
                    let place = Place { step, ..place };
                    self.reads(of.words.iter().copied(), place)?;
                    of.wanted.iter().try_for_each(|mask| self.mask(*mask, place))?;
                }
                Ok(())
            }
            Item::Force { guard, .. } => {
                guard.iter().try_for_each(|guard| self.mask(*guard, place))
            }
            Item::Request(at) => self.request(&self.schedule.requests[*at], place),
            Item::Loop(at) => self.turns(&self.schedule.loops[*at], place),
        }
    }

    fn request(&self, of: &Request, place: Place) -> Result<(), String> {
        self.reads(of.reads(), place)?;
        self.positions(&of.loops)?;
        let schedule = self.schedule;
        let is_there = match of.subject {
            // Textures, and the lists of lights, are linked, whatever is scheduled.
            Subject::Point | Subject::Texture(..) => true,
            Subject::Light { of, table } => {
                schedule.loops.is_valid(of) && schedule.tables.is_valid(table)
            }
        };
        if is_there { Ok(()) } else { Err(format!("{} asks about {:?}", of.name, of.subject)) }
    }

    /// What a loop reads: before it, and of its body, which is run between.
    fn turns(&self, of: &Loop, place: Place) -> Result<(), String> {
        let schedule = self.schedule;
        self.reads(of.reads(), Place { step: 1, ..place })?;
        match &of.turns {
            Turns::Lights { .. } => {}
            Turns::Samples { loops, .. } => self.positions(loops)?,
        }
        let regions = of.renewed.iter().all(|of| schedule.regions.is_valid(*of));
        let tables = of.emptied.iter().all(|of| schedule.tables.is_valid(*of));
        match regions && tables {
            true => Ok(()),
            false => Err(format!("{} forgets what is none", of.name)),
        }
    }

    fn positions(&self, loops: &[LoopId]) -> Result<(), String> {
        match loops.iter().find(|of| !self.schedule.loops.is_valid(**of)) {
            Some(of) => Err(format!("{of} is none")),
            None => Ok(()),
        }
    }

    /// Whether words are there when something is run.
    fn reads(&self, words: impl Iterator<Item = Source>, by: Place) -> Result<(), String> {
        for word in words {
            let Source::Slot(slot) = word else { continue };
            let is_there = match self.writers.get(slot as usize).copied().flatten() {
                None => false,
                Some(Writer::Field) => true,
                Some(Writer::Step(place, _) | Writer::Other(place)) => {
                    place.region != by.region || place < by
                }
            };
            if !is_there {
                return Err(format!("slot {slot} is read before it is written"));
            }
        }
        Ok(())
    }

    /// Whether a word is a mask that a guard found before, for all points.
    fn mask(&self, mask: Source, by: Place) -> Result<(), String> {
        self.reads([mask].into_iter(), by)?;
        let Source::Slot(slot) = mask else { return Ok(()) };
        match self.writers[slot as usize] {
            Some(Writer::Step(_, step)) if step.is_guard && step.wanted.is_empty() => {
                let recorded = step.code.recorded();
                match recorded.outputs.as_slice() {
                    [of] if masks(&recorded.ops)[*of as usize] => Ok(()),
                    _ => Err(format!("slot {slot} is no mask")),
                }
            }
            _ => Err(format!("slot {slot} is a mask that no guard found")),
        }
    }
}

/// Each is left to be found.
fn once<K: EntityRef, V>(all: &PrimaryMap<K, V>) -> PrimaryMap<K, bool> {
    all.values().map(|_| true).collect()
}

fn take<K: EntityRef + std::fmt::Display>(
    left: &mut PrimaryMap<K, bool>,
    id: K,
) -> Result<(), String> {
    match left.get_mut(id) {
        Some(left) if *left => {
            *left = false;
            Ok(())
        }
        Some(_) => Err(format!("{id} is run in two places")),
        None => Err(format!("{id} is none")),
    }
}
