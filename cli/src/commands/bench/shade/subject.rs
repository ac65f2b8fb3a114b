//! What is shaded: a workload or a material.

use clap::ValueEnum;
use clap::builder::PossibleValue;

use super::materials::Material;
use crate::commands::bench::workloads::Workload;

/// A workload or a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A graph that asks nothing of a renderer.
    Workload(Workload),
    /// A material of the thesis.
    Material(Material),
}

impl Subject {
    /// Name on the command line and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Workload(workload) => workload.name(),
            Self::Material(material) => material.name(),
        }
    }
}

/// Workloads, then materials.
const ALL: [Subject; Workload::ALL.len() + Material::ALL.len()] = {
    let mut all = [Subject::Workload(Workload::Ten); Workload::ALL.len() + Material::ALL.len()];
    let mut at = 0;
    while at < all.len() {
        all[at] = match at < Workload::ALL.len() {
            true => Subject::Workload(Workload::ALL[at]),
            false => Subject::Material(Material::ALL[at - Workload::ALL.len()]),
        };
        at += 1;
    }
    all
};

impl ValueEnum for Subject {
    fn value_variants<'a>() -> &'a [Self] {
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::Workload(workload) => workload.to_possible_value(),
            Self::Material(material) => material.to_possible_value(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_on_the_command_line_are_those_of_results() {
        for subject in Subject::value_variants() {
            let value = subject.to_possible_value().expect("no subject is hidden");
            assert_eq!(value.get_name(), subject.name());
        }
    }
}
