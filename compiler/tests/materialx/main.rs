//! What MaterialX computes, computed by our nodes.
//!
//! `node-values.json` has cases of single nodes: `nodedef`, `output`, `type`, `inputs` as MaterialX writes
//! them, and `value`, from the GLSL that MaterialX 1.39.5 generates. `categories.txt` says what of ours is
//! the same, a row for each category of nodedefs, or why there is nothing. Nothing depends on a single
//! case: another file of the kind may take the place of this one. `MATERIALX_VALUES` names one.

mod bound;
mod cases;
mod evaluate;
mod expression;
mod rows;

use std::collections::{BTreeMap, BTreeSet};

use phenomenon_compiler::diagnostics::peers;
use phenomenon_compiler::engine::Engine;
use phenomenon_compiler::nodes::NodeLibrary;

use cases::{Case, cases};
use evaluate::Evaluator;
use rows::{How, Row, row_of, rows};

/// The nodes of MaterialX, by category.
fn categories() -> BTreeSet<&'static str> {
    peers::LISTS[0].entries().map(|entry| entry.name).collect()
}

/// A case with the row it belongs to, if any does.
fn with_rows<'a>(cases: &'a [Case], rows: &'a [Row]) -> Vec<(&'a Case, Option<&'a Row>)> {
    cases.iter().map(|case| (case, row_of(rows, case))).collect()
}

/// How many cases of a category there are.
#[derive(Default)]
struct Counts {
    /// With a row of ours.
    mapped: usize,
    /// Of those, how many agree.
    agreed: usize,
    /// Without one.
    unmapped: usize,
    /// Why not.
    reasons: BTreeSet<&'static str>,
}

#[test]
fn cases_agree_or_their_category_is_listed_with_a_reason() {
    let (cases, rows, library) = (cases(), rows(), NodeLibrary::standard());
    let mut wrong = Vec::new();
    let mut counts = BTreeMap::<&str, Counts>::new();
    for (case, row) in with_rows(&cases, &rows) {
        let Some(row) = row else {
            wrong.push(format!("{}: no row of categories.txt is for it", case.nodedef));
            continue;
        };
        let counts = counts.entry(row.category).or_default();
        if row.how == How::No {
            counts.unmapped += 1;
            counts.reasons.insert(row.text);
            continue;
        }
        counts.mapped += 1;
        let evaluator = Evaluator::new(case, row, &library, Engine::Walk);
        match evaluator.and_then(|evaluator| bound::hold(case, row.coarse, &evaluator)) {
            Ok(()) => counts.agreed += 1,
            Err(error) => wrong.push(format!("{case}\n  {error}")),
        }
    }
    let agreed: usize = counts.values().map(|counts| counts.agreed).sum();
    println!("{agreed} of {} cases agree", cases.len());
    for (category, Counts { mapped, agreed, unmapped, reasons }) in &counts {
        println!("{category}: {mapped} mapped, {agreed} agree, {unmapped} not ours {reasons:?}");
    }
    assert!(wrong.is_empty(), "{} cases differ\n{}", wrong.len(), wrong.join("\n"));
    assert!(agreed * 2 > cases.len(), "{agreed} of {} cases are tried", cases.len());
}

#[test]
fn engines_agree_on_a_sample() {
    let (cases, rows, library) = (cases(), rows(), NodeLibrary::standard());
    let mut tried = BTreeSet::new();
    for (case, row) in with_rows(&cases, &rows) {
        let Some(row) = row.filter(|row| row.how != How::No && tried.insert(row.key())) else {
            continue;
        };
        let bits = |engine| -> Result<Vec<u32>, String> {
            let values = Evaluator::new(case, row, &library, engine)?.values(&case.numbers)?;
            Ok(values.into_iter().map(f32::to_bits).collect())
        };
        let walk = bits(Engine::Walk).unwrap_or_else(|error| panic!("{case}\n  {error}"));
        for engine in [Engine::Batch, Engine::Jit] {
            assert_eq!(bits(engine).as_ref(), Ok(&walk), "{engine:?}: {case}");
        }
    }
    assert!(tried.len() >= 60, "{} rows are tried", tried.len());
}

#[test]
fn rows_are_of_categories_that_there_are_and_none_stands_twice() {
    let categories = categories();
    assert!(categories.len() >= 200);
    let mut seen = BTreeSet::new();
    for row in rows() {
        let category = row.category.strip_prefix("logical_").unwrap_or(row.category);
        assert!(categories.contains(category), "MaterialX has no node `{}`", row.category);
        assert!(seen.insert(row.key()), "`{}` stands twice", row.key());
        assert!(row.text.len() >= 2, "`{}` gives no reason", row.key());
    }
}
