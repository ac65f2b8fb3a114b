//! Schedules as text.

use std::fmt;

use crate::storage::Source;

use super::{Item, Schedule};

struct Words<'a>(&'a [Source]);

impl fmt::Display for Words<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, word) in self.0.iter().enumerate() {
            let gap = if at == 0 { "" } else { " " };
            match word {
                Source::Constant { bits, .. } => write!(f, "{gap}#{bits:08x}")?,
                Source::Uniform(at) => write!(f, "{gap}u{at}")?,
                Source::Slot(slot) => write!(f, "{gap}s{slot}")?,
            }
        }
        Ok(())
    }
}

impl fmt::Display for Schedule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (field, first) in &self.fields {
            writeln!(f, "s{first} = state {}", field.name())?;
        }
        for (at, region) in &self.regions {
            writeln!(f, "region {} ({}):", at.as_u32(), region.name)?;
            for item in &region.items {
                self.item(f, item)?;
            }
        }
        writeln!(f, "root s{}", self.root)
    }
}

impl Schedule {
    fn item(&self, f: &mut fmt::Formatter<'_>, item: &Item) -> fmt::Result {
        match item {
            Item::Segment(at) => {
                writeln!(f, "  segment {}", at.as_u32())?;
                for step in &self.segments[*at].steps {
                    write!(f, "    s{} = {} ({})", step.output, step.name, Words(&step.words))?;
                    match step.wanted.as_slice() {
                        [] => writeln!(f)?,
                        wanted => writeln!(f, " where {}", Words(wanted))?,
                    }
                }
                Ok(())
            }
            Item::Force { region, guard } => {
                let (name, region) = (&self.regions[*region].name, region.as_u32());
                match guard {
                    Some(guard) => {
                        let guard = [*guard];
                        writeln!(f, "  force region {region} ({name}) where {}", Words(&guard))
                    }
                    None => writeln!(f, "  force region {region} ({name})"),
                }
            }
            Item::Request(at) => {
                let request = &self.requests[*at];
                let effect = request.effect.name();
                let words = Words(&request.words);
                writeln!(f, "  s{} = request {effect} {} ({words})", request.output, request.name)
            }
            Item::Loop(at) => {
                let of = &self.loops[*at];
                let (output, name, region) = (of.output, &of.name, of.region.as_u32());
                writeln!(f, "  s{output} = loop {name} over region {region}")
            }
        }
    }
}
