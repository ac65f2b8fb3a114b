//! Values of parameters under a name.

use std::collections::HashSet;

use super::{Graph, Preset};
use crate::diagnostics::{Advice, listed, nearest, shortened};
use crate::values::Literal;

/// Why a name leads to no preset.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{phenomenon}` has no preset `{name}`")]
pub struct NoSuchPreset {
    /// The phenomenon.
    pub phenomenon: String,
    /// The name that was given.
    pub name: String,
    /// What may be meant, and what there is.
    pub advice: Advice,
}

impl Preset {
    /// Its values with others, which have the last word.
    pub fn with(&self, mut values: Vec<(String, Literal)>) -> Vec<(String, Literal)> {
        let given: HashSet<String> = values.iter().map(|(name, _)| name.clone()).collect();
        let own = self.values.iter().filter(|(name, _)| !given.contains(name));
        values.extend(own.cloned());
        values
    }
}

impl Graph {
    /// The preset called so.
    ///
    /// # Errors
    /// There is none.
    pub fn preset(&self, name: &str) -> Result<&Preset, NoSuchPreset> {
        if let Some(preset) = self.presets.iter().find(|preset| preset.name == name) {
            return Ok(preset);
        }
        let names = || self.presets.iter().map(|preset| preset.name.as_str());
        let all = format!("its presets are {}", listed(names()));
        let advice = match nearest(name, names()) {
            Some(near) => Advice { help: format!("{} {all}", near.help()), fix: near.fix() },
            None if self.presets.is_empty() => String::from("it has no presets at all").into(),
            None => all.into(),
        };
        Err(NoSuchPreset { phenomenon: self.name.clone(), name: shortened(name), advice })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph() -> Graph {
        let preset = |name: &str, values: &[(&str, f32)]| Preset {
            name: name.into(),
            values: values.iter().map(|(of, x)| ((*of).into(), Literal::Scalar(*x))).collect(),
        };
        let presets = vec![preset("clear", &[]), preset("smoke", &[("ior", 1.2), ("depth", 4.0)])];
        Graph { name: "glass".into(), presets, ..Graph::default() }
    }

    #[test]
    fn what_is_set_has_the_last_word() {
        let graph = graph();
        let set = vec![("depth".to_owned(), Literal::Scalar(1.0))];
        let values = graph.preset("smoke").unwrap().with(set);
        let expected = [("depth", 1.0), ("ior", 1.2)];
        assert_eq!(values, expected.map(|(name, x)| (name.to_owned(), Literal::Scalar(x))));
    }

    #[test]
    fn a_name_that_is_not_there_is_told_with_those_that_are() {
        let error = graph().preset("smokey").unwrap_err();
        assert_eq!(error.to_string(), "`glass` has no preset `smokey`");
        assert_eq!(error.advice.help, "did you mean `smoke`? its presets are `clear` and `smoke`");
        let error = Graph::default().preset("smoke").unwrap_err();
        assert_eq!(error.advice.help, "it has no presets at all");
    }
}
