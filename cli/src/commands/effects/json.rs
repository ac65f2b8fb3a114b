//! The ledger as JSON, version 1. Keys are only ever added.

use phenomenon_runtime::link::Row;
use phenomenon_runtime::render::{Settings, Unit};
use serde_json::{Value, json};

use super::measured::{AllEffects, Measured, RowCost, Whole};

/// `{"version":1,"rows":[{"effect","on","reason","rays","milliseconds",…}],…}`.
pub fn text(measured: &Measured) -> String {
    let Settings { width, height, samples, .. } = measured.settings;
    let all = measured.all_costs();
    let costs = measured.rows.iter().zip(&measured.costs.rows).enumerate();
    let rows: Vec<Value> =
        costs.map(|(at, (of, cost))| row(of, cost, all.map(|all| &all.rows[at]))).collect();
    let given_up = match measured.all_effects {
        AllEffects::TooManyRays(limit) => Some(limit),
        AllEffects::NotAsked | AllEffects::Measured(_) => None,
    };
    let object = json!({
        "version": 1,
        "size": [width, height],
        "samples": samples,
        "rows": rows,
        "whole": whole(&measured.costs.whole),
        "all_effects": all.map(|all| whole(&all.whole)),
        "given_up_after_rays": given_up,
    });
    format!("{object:#}\n")
}

fn whole(of: &Whole) -> Value {
    json!({ "rays": of.rays, "milliseconds": of.milliseconds })
}

fn row(row: &Row, cost: &RowCost, all_effects: Option<&RowCost>) -> Value {
    let unit = row.entry.unit();
    let counted = |count: u64| (unit != Unit::None).then_some(count);
    let asked = row.asked.as_ref();
    let place = asked.and_then(|asked| asked.place.as_ref()).map(|place| {
        let (line, column) = place.line_column();
        json!({ "file": place.file.name, "line": line, "column": column })
    });
    let costs = |of: &RowCost| {
        json!({
            "count": counted(of.cost.count),
            "milliseconds": of.cost.milliseconds,
            "bytes": of.bytes.0,
        })
    };
    let saved = all_effects.map(|all| {
        json!({
            "count": counted(all.cost.count).map(|all| all as i64 - cost.cost.count as i64),
            "milliseconds": all.cost.milliseconds - cost.cost.milliseconds,
            "bytes": all.bytes.0 as i64 - cost.bytes.0 as i64,
        })
    });
    json!({
        "effect": row.entry.name(),
        "doc": row.entry.doc(),
        "file": row.file,
        "on": row.on,
        "reason": row.reason,
        "material": asked.map(|asked| &asked.graph),
        "node": asked.map(|asked| &asked.node),
        "node_type": asked.map(|asked| &asked.node_type),
        "place": place,
        "rays": (unit == Unit::Rays).then_some(cost.cost.count),
        "unit": (unit != Unit::None).then(|| unit.name(2)),
        "count": counted(cost.cost.count),
        "milliseconds": cost.cost.milliseconds,
        "bytes": cost.bytes.0,
        "all_effects": all_effects.map(costs),
        "saved": saved,
    })
}
