//! The ledger for people.

use std::fmt::Write as _;

use phenomenon_compiler::diagnostics::grouped;
use phenomenon_runtime::link::{Asked, Row};
use phenomenon_runtime::render::{Settings, Unit};

use super::measured::{AllEffects, Measured, RowCost, Whole};

/// Columns of names.
const NAMES: usize = 24;
/// Smaller costs in milliseconds are not told: they are below what reading the clock costs.
const LEAST_MILLISECONDS: f64 = 0.05;

/// The ledger: a line for each effect with its cost, and below it why.
pub fn text(what: &str, measured: &Measured) -> String {
    let Settings { width, height, samples, .. } = measured.settings;
    let plural = if samples == 1 { "" } else { "s" };
    let costs = &measured.costs;
    let mut text =
        format!("{what}, {width}x{height}, {samples} sample{plural}: {}", whole(&costs.whole));
    match &measured.all_effects {
        AllEffects::NotAsked => {}
        AllEffects::Measured(all) => {
            text += &format!("; with all effects on {}", whole(&all.whole))
        }
        AllEffects::TooManyRays(limit) => {
            text += "; what is saved is not measured: with all effects on it takes more than ";
            text += &format!("{} rays (--most-rays)", grouped(*limit));
        }
    }
    text += "\n";
    let all = measured.all_costs();
    for (at, row) in measured.rows.iter().enumerate() {
        let text_of_row = of_row(row, &costs.rows[at], all.map(|all| &all.rows[at]));
        let _ = write!(text, "\n{text_of_row}");
    }
    text
}

fn whole(of: &Whole) -> String {
    format!("{} rays, {:.1} ms", grouped(of.rays), of.milliseconds)
}

fn of_row(row: &Row, cost: &RowCost, all_effects: Option<&RowCost>) -> String {
    let unit = row.entry.unit();
    let name = match &row.file {
        Some(file) => format!("{} {file}", row.entry.name()),
        None => row.entry.name().to_owned(),
    };
    let state = if row.on { "on " } else { "off" };
    let mut costs: Vec<String> = Vec::new();
    if row.on {
        costs.push(listed(cost, unit));
    }
    if let Some(saved) = all_effects.and_then(|all| saved(all, cost, unit)) {
        costs.push(format!("saves {saved}"));
    }
    costs.retain(|cost| !cost.is_empty());
    let mut text = format!("{state}  {name:NAMES$}  {}", costs.join("; "));
    text.truncate(text.trim_end().len());
    let _ = writeln!(text, "\n     {}{}", row.reason, place(row));
    text
}

/// Where the node stands, unless the reason has said so.
fn place(row: &Row) -> String {
    match &row.asked {
        Some(Asked { place: Some(place), .. }) => {
            let (line, column) = place.line_column();
            format!("\n     {}:{line}:{column}", place.file.name)
        }
        _ => String::new(),
    }
}

fn listed(of: &RowCost, unit: Unit) -> String {
    let mut parts = Vec::new();
    if unit != Unit::None {
        parts.push(format!("{} {}", grouped(of.cost.count), unit.name(of.cost.count)));
    }
    if of.cost.milliseconds >= LEAST_MILLISECONDS {
        parts.push(format!("{:.1} ms", of.cost.milliseconds));
    }
    if of.bytes.0 > 0 {
        parts.push(format!("{} bytes", grouped(of.bytes.0)));
    }
    parts.join(", ")
}

/// What was saved against all effects on; none where it was nothing.
fn saved(all: &RowCost, cost: &RowCost, unit: Unit) -> Option<String> {
    let mut parts = Vec::new();
    let count = all.cost.count.saturating_sub(cost.cost.count);
    if unit != Unit::None && count > 0 {
        parts.push(format!("{} {}", grouped(count), unit.name(count)));
    }
    let milliseconds = all.cost.milliseconds - cost.cost.milliseconds;
    if milliseconds >= LEAST_MILLISECONDS {
        parts.push(format!("{milliseconds:.1} ms"));
    }
    let bytes = all.bytes.0.saturating_sub(cost.bytes.0);
    if bytes > 0 {
        parts.push(format!("{} bytes", grouped(bytes)));
    }
    (!parts.is_empty()).then(|| parts.join(", "))
}
