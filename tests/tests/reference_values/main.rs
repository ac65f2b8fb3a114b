//! Values of models from outside: `values.json`, computed with 60 digits by a program that shares nothing with
//! this one. Each *model* is a graph of nodes, each case a point it is shaded at; a file with other cases of
//! the same models takes its place without a change here, and a model that is not known is named.
//!
//! **In 64 bits** the operations that the nodes recorded are evaluated on the case's inputs, and have to meet
//! the value within the tolerance of the file: the formulas are right, and in a stable form.
//!
//! **In 32 bits** every engine shades the case, inputs rounded. An algorithm as stable as its problem allows
//! gives the exact result of inputs a few roundings away, rounded a few times. So the error has to stay below
//! four units in the last place of the value, and what the value changes by when each input is moved by
//! `roundings` units of relative rounding (2^-24), one by one, both ways, in 64 bits, summed up: the condition
//! of the case, not linearised. To it comes what the value changes by when inputs are rounded to 32 bits: next to
//! a lobe narrower than that, steps of whole roundings lead past the peak. The number of roundings is the model's and follows from how often inputs are
//! rounded on their way into the ill-conditioned part (an exponent, a difference), as said at each model.
//! Values below `FAINT` times the largest input are free: exponentials underflow.

mod double;
mod file;
mod models;

use phenomenon_compiler::engine::{Shade, Shaded};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;
use phenomenon_compiler::testing::build::every_engine;
use phenomenon_compiler::testing::mock::MockRenderer;

use double::{Fields, evaluate};
use file::{Case, Expected};
use models::{Model, model};

/// Below it, 32-bit exponentials times peaks of lobes have lost digits to underflow.
const FAINT: f64 = 1e-30;
/// Half a unit in the last place, relatively.
const ROUNDING: f64 = 1.0 / 16_777_216.0;

/// The numbers of a result; none where the model says there is no result.
fn numbers(model: &Model, fields: &Fields) -> Option<Vec<f64>> {
    let (color, ok) = evaluate(&model.built.graph, fields);
    ok.then(|| color[..model.width].to_vec())
}

/// How far a component may be off in 32 bits: see above.
fn allowed(model: &Model, fields: &Fields, component: usize, expected: f64) -> f64 {
    let at = |fields: &Fields| numbers(model, fields).map_or(f64::NAN, |all| all[component]);
    let here = at(fields);
    let rounded = fields
        .iter()
        .map(|(&field, words)| (field, words.iter().map(|&word| f64::from(word as f32)).collect()));
    let by_rounding = (at(&rounded.collect()) - here).abs();
    let mut allowed = 8.0 * ROUNDING * expected.abs() + FAINT;
    if by_rounding.is_finite() {
        allowed += by_rounding;
    }
    for (field, words) in fields {
        for word in 0..words.len() {
            let moved = |by: f64| {
                let mut fields = fields.clone();
                fields.get_mut(field).expect("the field is there")[word] *= 1.0 + by;
                let change = (at(&fields) - here).abs();
                if change.is_finite() { change } else { 0.0 }
            };
            let by = model.roundings * ROUNDING;
            allowed += moved(by).max(moved(-by));
        }
    }
    allowed
}

fn state(fields: &Fields) -> State {
    let mut state = State::default();
    for (field, words) in fields {
        let words: Vec<u32> = words.iter().map(|&word| (word as f32).to_bits()).collect();
        field.write(&mut state, &words);
    }
    state
}

/// What the 64-bit evaluation misses the file's values by.
fn misses(name: &str, model: &Model, cases: &[Case]) -> Vec<String> {
    let mut found = Vec::new();
    for case in cases {
        let result = numbers(model, &(model.fields)(case));
        let expected = match (&case.expected, &result) {
            (Expected::Nothing, None) => continue,
            (Expected::Numbers(expected), Some(_)) => expected,
            _ => {
                found.push(format!("{name} {}: {result:?} for {:?}", case.id, case.expected));
                continue;
            }
        };
        for (value, &expected) in result.unwrap_or_default().iter().zip(expected) {
            let error = (value - expected).abs();
            if !(error <= case.relative * expected.abs() || error <= case.absolute.max(1e-300)) {
                found.push(format!("{name} {}: {value:e} for {expected:e} in 64 bits", case.id));
            }
        }
    }
    found
}

/// What the engines miss the file's values by.
fn misses_in_engines(name: &str, model: &Model, cases: &[Case], worst: &mut f64) -> Vec<String> {
    let all: Vec<Fields> = cases.iter().map(|case| (model.fields)(case)).collect();
    let points: Vec<State> = all.iter().map(state).collect();
    let mut results: Vec<Vec<Shaded>> = Vec::new();
    for options in every_engine() {
        let shader = model.built.shader(&[], options);
        let mut shaded = vec![Shaded::default(); points.len()];
        shader.shade(RootKind::Material, &points, &mut MockRenderer::default(), &mut shaded);
        results.push(shaded);
    }
    let mut found = Vec::new();
    for (at, case) in cases.iter().enumerate() {
        let Expected::Numbers(expected) = &case.expected else {
            let all_fail = results.iter().all(|shaded| !shaded[at].ok);
            if !all_fail {
                found.push(format!("{name} {}: a result where there is none", case.id));
            }
            continue;
        };
        for (component, &expected) in expected.iter().enumerate() {
            let allowed = allowed(model, &all[at], component, expected);
            for shaded in &results {
                let value = f64::from(shaded[at].color[component]);
                let error = (value - expected).abs();
                *worst = worst.max(error / allowed);
                if !(shaded[at].ok && error <= allowed) {
                    found.push(format!(
                        "{name} {}: {value:e} for {expected:e}, off by {error:e} of {allowed:e}",
                        case.id
                    ));
                    break;
                }
            }
        }
    }
    found
}

#[test]
fn every_model_meets_its_values() {
    let mut found = Vec::new();
    let mut count = 0;
    for (name, cases) in file::read(&file::text()) {
        let Some(model) = model(&name) else {
            found.push(format!("no graph stands for the model `{name}`: add it to `models`"));
            continue;
        };
        count += cases.len();
        let mut worst = 0.0;
        found.extend(misses(&name, &model, &cases));
        found.extend(misses_in_engines(&name, &model, &cases, &mut worst));
        println!("{name}: {} cases, at most {worst:.2} of what is allowed", cases.len());
    }
    assert!(count > 0, "the file has no cases");
    assert!(found.is_empty(), "{} values missed:\n{}", found.len(), found.join("\n"));
}

/// The nodes that continue a formula outside its domain keep to it within.
#[test]
fn blends_are_the_formulas_from_zero_to_one() {
    for (name, node) in
        [("screen", models::screen_node()), ("overlay_thesis", models::overlay_node())]
    {
        let cases = file::read(&file::text());
        let cases: Vec<Case> =
            cases.into_iter().filter(|(of, _)| of == name).flat_map(|(_, it)| it).collect();
        let within: Vec<Case> = cases.into_iter().filter(|case| case.within_unit()).collect();
        let mut worst = 0.0;
        let mut found = misses(name, &node, &within);
        found.extend(misses_in_engines(name, &node, &within, &mut worst));
        assert!(found.is_empty(), "{}", found.join("\n"));
    }
}

#[test]
fn a_model_that_is_not_known_has_no_graph() {
    assert!(model("no_such_model").is_none());
}
