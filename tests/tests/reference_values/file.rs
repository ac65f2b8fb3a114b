//! The file of values.

use std::collections::BTreeMap;

use serde_json::Value;

/// What a case is to give.
#[derive(Clone, Debug)]
pub enum Expected {
    /// These numbers.
    Numbers(Vec<f64>),
    /// No result: total reflection.
    Nothing,
}

/// A case of a model.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its name, for messages only.
    pub id: String,
    /// Numbers and vectors, by name.
    pub inputs: BTreeMap<String, Vec<f64>>,
    /// What it is to give.
    pub expected: Expected,
    /// Relative tolerance in 64 bits.
    pub relative: f64,
    /// Absolute tolerance in 64 bits.
    pub absolute: f64,
}

impl Case {
    /// An input.
    ///
    /// # Panics
    /// If the case has none of that name and length.
    pub fn input(&self, name: &str, length: usize) -> &[f64] {
        let found = self.inputs.get(name).filter(|numbers| numbers.len() == length);
        found.unwrap_or_else(|| panic!("{} has no input `{name}` of {length} numbers", self.id))
    }

    /// Whether all inputs lie within 0 and 1.
    pub fn within_unit(&self) -> bool {
        self.inputs.values().flatten().all(|number| (0.0..=1.0).contains(number))
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(values) => values.iter().flat_map(numbers).collect(),
        value => vec![value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))],
    }
}

fn case(value: &Value) -> Case {
    let id = value["id"].as_str().expect("a case has an id").to_owned();
    let inputs = value["inputs"].as_object().unwrap_or_else(|| panic!("{id} has no inputs"));
    let expected = match &value["expected"] {
        Value::Null => Expected::Nothing,
        value => Expected::Numbers(numbers(value)),
    };
    let tolerance = |name: &str| value.get(name).map(|value| numbers(value)[0]);
    let (relative, absolute) = (tolerance("tol_rel"), tolerance("tol_abs"));
    assert!(relative.or(absolute).is_some(), "{id} has no tolerance");
    Case {
        inputs: inputs.iter().map(|(name, value)| (name.clone(), numbers(value))).collect(),
        id,
        expected,
        relative: relative.unwrap_or(0.0),
        absolute: absolute.unwrap_or(0.0),
    }
}

/// The file that is checked in, or the one `REFERENCE_VALUES` names.
pub fn text() -> String {
    std::env::var_os("REFERENCE_VALUES").map_or_else(
        || include_str!("values.json").to_owned(),
        |path| std::fs::read_to_string(path).expect("REFERENCE_VALUES names a file"),
    )
}

/// The models with their cases.
pub fn read(text: &str) -> Vec<(String, Vec<Case>)> {
    let file: Value = serde_json::from_str(text).expect("the file is JSON");
    let models = file["models"].as_object().expect("the file has models");
    let cases = |model: &Value| {
        model["cases"].as_array().expect("a model has cases").iter().map(case).collect()
    };
    models.iter().map(|(name, model)| (name.clone(), cases(model))).collect()
}
