//! The ledger as JSON, version 1. Keys are only ever added.

use phenomenon_runtime::render::{Settings, Unit};
use serde_json::{Value, json};

use super::measured::{Measured, MeasuredRow, RowCost, Whole};

/// `{"version":1,"rows":[{"effect","on","reason","rays","milliseconds",…}],…}`.
pub fn text(measured: &Measured) -> String {
    let Settings { width, height, samples, .. } = measured.settings;
    let rows: Vec<Value> = measured.rows.iter().map(row).collect();
    let object = json!({
        "version": 1,
        "size": [width, height],
        "samples": samples,
        "rows": rows,
        "whole": whole(&measured.whole),
        "all_effects": measured.all_effects.as_ref().map(whole),
    });
    format!("{object:#}\n")
}

fn whole(of: &Whole) -> Value {
    json!({ "rays": of.rays, "milliseconds": of.milliseconds })
}

fn row(measured: &MeasuredRow) -> Value {
    let MeasuredRow { row, cost, all_effects } = measured;
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
    let saved = all_effects.as_ref().map(|all| {
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
        "all_effects": all_effects.as_ref().map(costs),
        "saved": saved,
    })
}
