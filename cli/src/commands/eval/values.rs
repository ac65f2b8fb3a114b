//! What was evaluated, as text.

use phenomenon_compiler::values::Type;
use serde_json::{Map, Value};

use crate::numbers::{digits, number};

/// Values of outputs, in order.
#[derive(Debug, Default)]
pub struct Evaluation {
    values: Vec<(String, Type, [f32; 4])>,
    /// What a root said beside its colour.
    pub ok: Option<bool>,
}

impl Evaluation {
    /// Adds a value; of `components`, those of the type count.
    pub fn add(&mut self, name: String, value_type: Type, components: [f32; 4]) {
        self.values.push((name, value_type, components));
    }

    /// A line each.
    pub fn human(&self) -> String {
        let longest = self.values.iter().map(|(name, ..)| name.chars().count()).max();
        let column = longest.unwrap_or(0);
        let mut text = String::new();
        for (name, value_type, components) in &self.values {
            let shown: Vec<String> = match value_type {
                Type::Boolean => vec![(components[0] != 0.0).to_string()],
                Type::Integer => vec![(components[0] as i64).to_string()],
                _ => components[..value_type.width()].iter().map(|x| digits(*x)).collect(),
            };
            text += &format!("{name:column$}  {}\n", shown.join(" "));
        }
        if let Some(ok) = self.ok {
            text += &format!("{:column$}  {ok}\n", "ok");
        }
        text
    }

    /// `{"values":{"node.output":[…]},"ok":true}`, `ok` for roots only.
    pub fn json(&self) -> String {
        let mut values = Map::new();
        for (name, value_type, components) in &self.values {
            let value: Value = match value_type {
                Type::Boolean => vec![components[0] != 0.0].into(),
                Type::Integer => vec![components[0] as i64].into(),
                _ => components[..value_type.width()].iter().map(|x| number(*x)).collect(),
            };
            values.insert(name.clone(), value);
        }
        let mut object = Map::new();
        object.insert("values".into(), Value::Object(values));
        if let Some(ok) = self.ok {
            object.insert("ok".into(), ok.into());
        }
        format!("{}\n", Value::Object(object))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn evaluation() -> Evaluation {
        let mut evaluation = Evaluation::default();
        evaluation.add("a.color".into(), Type::Color, [0.1, -0.0, f32::NAN, 1.0]);
        evaluation.add("b.truth".into(), Type::Boolean, [1.0, 1.0, 1.0, 1.0]);
        evaluation.add("c.level".into(), Type::Integer, [3.0, 3.0, 3.0, 1.0]);
        evaluation.add("long.vector".into(), Type::Vector, [1e-40, 1.0, 2.0, 1.0]);
        evaluation.ok = Some(false);
        evaluation
    }

    #[test]
    fn json_keeps_every_bit_and_type() {
        let expected = concat!(
            r#"{"values":{"a.color":[0.1,-0.0,"NaN",1.0],"b.truth":[true],"c.level":[3],"#,
            r#""long.vector":[1e-40,1.0,2.0]},"ok":false}"#,
            "\n"
        );
        assert_eq!(evaluation().json(), expected);
    }

    #[test]
    fn lines_are_aligned() {
        let expected = "a.color      0.1 -0 NaN 1\nb.truth      true\nc.level      3\n\
                        long.vector  1e-40 1 2\nok           false\n";
        assert_eq!(evaluation().human(), expected);
    }
}
