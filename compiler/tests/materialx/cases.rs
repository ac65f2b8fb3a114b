//! The cases of the file.

use std::collections::BTreeMap;
use std::fmt;

use serde_json::Value;

/// One node, evaluated once by MaterialX.
pub struct Case {
    /// Its definition, such as `ND_add_color3FA`.
    pub nodedef: String,
    /// Which of its outputs.
    pub output: String,
    /// The type of that.
    pub value_type: String,
    /// Its inputs, as numbers; truth is 0 and 1.
    pub numbers: BTreeMap<String, Vec<f32>>,
    /// Those of its inputs that are truth.
    pub truths: Vec<String>,
    /// Whether a renderer computed it, and not an evaluator in 64 bits.
    pub is_rendered: bool,
    /// What came out.
    pub value: Vec<f64>,
}

impl Case {
    /// Whether numbers in threes and fours are colours.
    pub fn is_of_colors(&self) -> bool {
        self.nodedef.contains("color") || self.value_type.contains("color")
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{} of {:?} is {:?}", self.nodedef, self.output, self.numbers, self.value)
    }
}

/// All cases: of the file that is checked in, or the one `MATERIALX_VALUES` names.
pub fn cases() -> Vec<Case> {
    let text = std::env::var_os("MATERIALX_VALUES").map_or_else(
        || include_str!("node-values.json").to_owned(),
        |path| std::fs::read_to_string(path).expect("MATERIALX_VALUES names a file"),
    );
    let all: Vec<Value> = serde_json::from_str(&text).expect("a list of cases");
    all.iter().map(case).collect()
}

fn case(case: &Value) -> Case {
    let text = |key: &str| case[key].as_str().expect(key).to_owned();
    // Where the renderer was too coarse, the value is that of the numbers as they are written.
    let is_rendered = case.get("agree").is_none_or(|agree| agree == true);
    let mut numbers = BTreeMap::new();
    let mut truths = Vec::new();
    for (name, value) in case["inputs"].as_object().expect("inputs") {
        let written = value.as_str().expect("inputs are text");
        if matches!(written, "true" | "false") {
            truths.push(name.clone());
        }
        // Strings are no input of what is tried here.
        if let Some(read) =
            written.split(',').map(|part| number(part.trim(), is_rendered)).collect()
        {
            numbers.insert(name.clone(), read);
        }
    }
    let value = case["value"].as_array().expect("a list of numbers");
    Case {
        nodedef: text("nodedef"),
        output: text("output"),
        value_type: text("type"),
        numbers,
        truths,
        is_rendered,
        value: value.iter().map(|it| it.as_f64().expect("a number")).collect(),
    }
}

/// A number as it is written, or as MaterialX hands it to GLSL: with six decimals.
fn number(text: &str, is_rendered: bool) -> Option<f32> {
    match text {
        "true" => Some(1.0),
        "false" => Some(0.0),
        _ => {
            let read: f32 = text.parse().ok()?;
            if is_rendered { format!("{read:.6}").parse().ok() } else { Some(read) }
        }
    }
}
