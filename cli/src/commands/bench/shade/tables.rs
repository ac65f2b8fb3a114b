//! The tables of the command, and its rows.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::column::Column;
use super::contender::Contender;
use super::laziness::Saved;
use super::race::Race;
use super::subject::Subject;
use crate::arguments::Precision;

/// Those to whom workloads are compared.
const OF_WORKLOADS: [Column; 4] = [Column::Fused8, Column::Monolith, Column::Batch, Column::Walk];

/// Those to whom materials are compared.
const OF_MATERIALS: [Column; 4] = [Column::Monolith, Column::SameBits, Column::Batch, Column::Walk];

/// The table of the races of workloads; empty without any.
pub fn workloads(races: &[Race]) -> String {
    let is_workload = |race: &&Race| matches!(race.subject, Subject::Workload(_));
    let races: Vec<&Race> = races.iter().filter(is_workload).collect();
    table("workload", &races, &OF_WORKLOADS, false)
}

/// The table of the races of materials; empty without any.
pub fn materials(races: &[Race]) -> String {
    let is_material = |race: &&Race| matches!(race.subject, Subject::Material(_));
    let races: Vec<&Race> = races.iter().filter(is_material).collect();
    table("material", &races, &OF_MATERIALS, true)
}

fn table(first: &str, races: &[&Race], bases: &[Column], compiled: bool) -> String {
    if races.is_empty() {
        return String::new();
    }
    let mut text = format!("| {first} | points a call | engine | ns | spread |");
    bases.iter().for_each(|base| text += &format!(" to {} |", base.name()));
    text += if compiled { " compiling, ms |" } else { "" };
    text += "\n| --- | ---: | --- | ---: | ---: |";
    text += &" ---: |".repeat(bases.len() + usize::from(compiled));
    text.push('\n');
    for race in races {
        for of in &race.contenders {
            text += &line(race, of, bases);
            if compiled {
                let shown =
                    of.compile_milliseconds.map_or_else(String::new, |it| format!("{it:.2}"));
                text += &format!(" {shown} |");
            }
            text.push('\n');
        }
    }
    text
}

fn line(race: &Race, of: &Contender, bases: &[Column]) -> String {
    let (name, batch, engine) = (race.subject.name(), race.batch, of.column.name());
    let mut text =
        format!("| {name} | {batch} | {engine} | {:.1} | {:.3} |", of.nanoseconds(), of.spread());
    for base in bases {
        let base = race.contenders.iter().find(|contender| contender.column == *base);
        let ratio = base.map_or_else(String::new, |base| format!("{:.2}", of.ratio(base)));
        // Writing to a string cannot fail.
        let _ = write!(text, " {ratio} |");
    }
    text
}

/// The table of what laziness saves; empty without any material.
pub fn laziness(saved: &[(Subject, Saved)]) -> String {
    if saved.is_empty() {
        return String::new();
    }
    let mut text = "| material | rays a point | of all | lights a point | of all | evaluations a point | of all |\n\
                    | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n"
        .to_owned();
    for (subject, Saved { lazy, eager }) in saved {
        let _ = writeln!(
            text,
            "| {} | {:.2} | {:.2} | {:.2} | {:.2} | {:.1} | {:.1} |",
            subject.name(),
            lazy.rays,
            eager.rays,
            lazy.lights,
            eager.lights,
            lazy.evaluations,
            eager.evaluations,
        );
    }
    text
}

/// The rows of all races.
pub fn rows(races: &[Race]) -> Vec<Value> {
    let row = |race: &Race, of: &Contender| {
        let mut row = json!({
            "workload": race.subject.name(),
            "batch": race.batch,
            "engine": of.column.name(),
            "precision": Precision::default().name(),
            "ns_per_point": of.nanoseconds(),
            "spread": of.spread(),
        });
        if let Some(milliseconds) = of.compile_milliseconds {
            row["compile_ms"] = json!(milliseconds);
        }
        row
    };
    races.iter().flat_map(|race| race.contenders.iter().map(|of| row(race, of))).collect()
}
