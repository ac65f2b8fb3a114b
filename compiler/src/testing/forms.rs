//! What bodies and conditions keep to, in all their forms.

use std::collections::HashMap;

use crate::kernels::BodyForms;
use crate::nodes::{Definition, Input, Kind, Overload, harness::settled};
use crate::values::Type;

use super::subjects::Subjects;
use super::trial::{Trial, canonical_words};

fn each_body(subjects: &Subjects, mut visit: impl FnMut(&Definition, &Overload, &BodyForms)) {
    subjects.each_form(|definition, overload| {
        if let Some(code) = &overload.code {
            visit(definition, overload, code);
        }
    });
}

/// Inputs in range give outputs in range, and all forms agree.
///
/// # Panics
/// If that does not hold.
pub fn in_range_inputs_give_outputs_in_range_and_all_forms_agree(subjects: &Subjects) {
    each_body(subjects, |definition, overload, code| {
        let trial = Trial::new(definition, overload, false);
        let outputs = trial.run(code);
        if matches!(definition.signature.kind, Kind::Scope(_)) {
            return;
        }
        for (point, words) in trial.points.iter().zip(&outputs) {
            let mut at = 0;
            for output in &definition.signature.outputs {
                let value_type = settled(output.value_type, overload);
                let values = &words[at..at + value_type.width()];
                at += value_type.width();
                if matches!(value_type, Type::Boolean | Type::Integer) {
                    continue;
                }
                for (component, &word) in values.iter().enumerate() {
                    let value = f64::from(f32::from_bits(word));
                    let alpha = value_type == Type::Color && component == 3;
                    assert!(
                        if alpha { value.is_finite() } else { output.range.contains(&value) },
                        "{}: output `{}` is {value:e}, outside {:?}, for {:?}",
                        trial.name,
                        output.name,
                        output.range,
                        point.iter().map(|&word| f32::from_bits(word)).collect::<Vec<_>>()
                    );
                }
            }
        }
    });
}

/// Any bits do not trap, and all forms agree.
///
/// # Panics
/// If that does not hold.
pub fn out_of_range_inputs_do_not_trap_and_all_forms_agree(subjects: &Subjects) {
    each_body(subjects, |definition, overload, code| {
        Trial::new(definition, overload, true).run(code);
    });
}

/// Conditions agree in all forms, and look at earlier inputs only.
///
/// # Panics
/// If that does not hold.
pub fn guards_agree_in_all_forms_and_look_at_earlier_inputs_only(subjects: &Subjects) {
    each_body(subjects, |definition, overload, _| {
        for anywhere in [false, true] {
            let mut trial = Trial::new(definition, overload, anywhere);
            let guards = overload.guards.clone();
            for (at, guard) in guards.iter().enumerate() {
                let Some(guard) = guard else { continue };
                let before = trial.run(guard);
                let kept = std::mem::take(&mut trial.points);
                trial.points = kept.clone();
                for point in &mut trial.points {
                    point[trial.places[at].0..].fill(f32::NAN.to_bits());
                }
                assert_eq!(trial.run(guard), before, "{} input {at}", trial.name);
                trial.points = kept;
            }
        }
    });
}

/// Inputs that were not demanded leave no trace; and conditions do fail.
///
/// # Panics
/// If that does not hold.
pub fn undemanded_inputs_do_not_show(subjects: &Subjects) {
    let mut closes: HashMap<(String, Option<Type>, bool), bool> = HashMap::new();
    each_body(subjects, |definition, overload, code| {
        for anywhere in [false, true] {
            let mut trial = Trial::new(definition, overload, anywhere);
            let before =
                trial.points_by(|point, outputs| code.scalar(point, outputs), code.outputs);
            let mut hidden = 0;
            for (at, guard) in overload.guards.iter().enumerate() {
                let Some(guard) = guard else { continue };
                let demanded = trial.points_by(|point, outputs| guard.scalar(point, outputs), 1);
                let (first, width) = trial.places[at];
                for (point, demanded) in trial.points.iter_mut().zip(&demanded) {
                    if demanded[0] == 0 {
                        point[first..first + width].fill(0x7fc0_1234);
                        hidden += 1;
                    }
                }
            }
            let after = trial.points_by(|point, outputs| code.scalar(point, outputs), code.outputs);
            for (at, (before, after)) in before.iter().zip(&after).enumerate() {
                assert_eq!(before, after, "{} at {:x?}", trial.name, trial.points[at]);
            }
            // What is known before shading may hold a condition open in one form and close it in another.
            let guarded = overload.guards.iter().any(Option::is_some);
            let name = definition.signature.name.to_string();
            let closes = closes.entry((name, overload.generic, anywhere)).or_insert(!guarded);
            *closes |= hidden > 0;
            assert!(guarded || hidden == 0, "{}", trial.name);
        }
    });
    for (of, closes) in closes {
        assert!(closes, "{of:?}: its guards never close");
    }
}

/// The inputs of one component: of generic ones that word, of others all.
fn alone(definition: &Definition, trial: &Trial, point: &[u32], component: usize) -> Vec<u32> {
    let inputs = definition.signature.inputs.iter().zip(&trial.places);
    inputs
        .flat_map(|(input, &(first, width))| match input.value_type {
            Type::Generic => &point[first + component..][..1],
            _ => &point[first..][..width],
        })
        .copied()
        .collect()
}

/// Nodes per component take each component alone, and keep the alpha of the first input. How many forms
/// there were.
///
/// # Panics
/// If that does not hold.
pub fn nodes_per_component_take_each_alone_and_keep_the_alpha_of_the_first(
    subjects: &Subjects,
) -> usize {
    let mut tried = 0;
    each_body(subjects, |definition, overload, code| {
        if !definition.per_component {
            return;
        }
        tried += 1;
        let name = &definition.signature.name;
        let generic = |input: &Input| input.value_type == Type::Generic;
        assert!(generic(&definition.signature.inputs[0]), "{name}: alpha comes from there");
        let of_one = (definition.overloads.iter())
            .find(|form| form.generic == Some(Type::Scalar))
            .and_then(|form| form.code)
            .expect("numbers have a form");
        for anywhere in [false, true] {
            let trial = Trial::new(definition, overload, anywhere);
            let outputs =
                trial.points_by(|point, outputs| code.scalar(point, outputs), code.outputs);
            for (point, words) in trial.points.iter().zip(&outputs) {
                for component in 0..words.len().min(3) {
                    let mut result = [0];
                    of_one.scalar(&alone(definition, &trial, point, component), &mut result);
                    let word = &words[component..][..1];
                    assert_eq!(
                        canonical_words(word),
                        canonical_words(&result),
                        "{name} at {point:x?}"
                    );
                }
                assert_eq!(words.get(3), (words.len() == 4).then(|| &point[3]), "{name}: alpha");
            }
        }
    });
    tried
}
