//! The arrays and structs of an interface, found again from the names of their parts: a graph keeps
//! the parts alone, called `layers[2].tint`.

use std::collections::HashMap;

use crate::diagnostics::{listed, nearest, shortened};

use super::Parameter;

/// What the parameters of a graph are by name, their parts included.
#[derive(Debug)]
pub(crate) struct Parts<'g> {
    by_name: HashMap<&'g str, Part<'g>>,
    /// Names as the file gives them, in its order.
    whole: Vec<&'g str>,
}

/// What has a name of its own.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Part<'g> {
    /// A value: the position of its parameter.
    One(usize),
    /// An array with so many elements.
    Array(usize),
    /// A struct with these members, in file order.
    Struct(Vec<&'g str>),
}

impl<'g> Parts<'g> {
    pub fn of(parameters: &'g [Parameter]) -> Self {
        let mut parts = Self { by_name: HashMap::new(), whole: Vec::new() };
        for (at, parameter) in parameters.iter().enumerate() {
            parts.add(at, &parameter.name);
        }
        parts
    }

    fn add(&mut self, at: usize, name: &'g str) {
        let end = name.find(['.', '[']).unwrap_or(name.len());
        // The parts of one parameter stand side by side.
        if self.whole.last() != Some(&&name[..end]) {
            self.whole.push(&name[..end]);
        }
        for (end, _) in name.match_indices(['.', '[']) {
            let (of, rest) = name.split_at(end);
            let next = rest[1..].find(['.', '[']).map_or(rest.len(), |next| next + 1);
            if rest.starts_with('[') {
                let element = rest[1..next].trim_end_matches(']').parse().unwrap_or(0);
                match self.by_name.entry(of).or_insert(Part::Array(0)) {
                    Part::Array(count) => *count = (*count).max(element + 1),
                    Part::One(_) | Part::Struct(_) => {}
                }
            } else {
                let member = &rest[1..next];
                match self.by_name.entry(of).or_insert(Part::Struct(Vec::new())) {
                    Part::Struct(members) if members.last() != Some(&member) => {
                        members.push(member);
                    }
                    _ => {}
                }
            }
        }
        self.by_name.insert(name, Part::One(at));
    }

    pub fn get(&self, name: &str) -> Option<&Part<'g>> {
        self.by_name.get(name)
    }

    /// What to write instead of a name that no parameter has.
    pub fn remedy(&self, name: &str) -> String {
        if let Some(part) = self.get(name) {
            return whole_remedy(name, part);
        }
        // As far as the name is right, what it names says what could follow.
        let ends = name.match_indices(['.', '[']).map(|(end, _)| end);
        let known = ends.filter_map(|end| Some((end, self.get(&name[..end])?))).next_back();
        if let Some((end, part)) = known {
            return beyond(&name[..end], part, &name[end..]);
        }
        match nearest(name, self.names()) {
            Some(near) => near.help(),
            None if self.whole.is_empty() => "it has no parameters at all".into(),
            None => format!("its parameters are {}", listed(self.whole.iter().copied())),
        }
    }

    /// Every name that a value can be given to: parameters, and the parts of arrays and structs.
    pub fn names(&self) -> impl Iterator<Item = &'g str> {
        let mut parts: Vec<(usize, &str)> = self
            .by_name
            .iter()
            .filter_map(|(name, part)| match part {
                // A parameter that is one value stands among the whole ones already.
                Part::One(at) if name.contains(['.', '[']) => Some((*at, *name)),
                Part::One(_) | Part::Array(_) | Part::Struct(_) => None,
            })
            .collect();
        parts.sort_unstable();
        self.whole.clone().into_iter().chain(parts.into_iter().map(|(_, name)| name))
    }
}

/// How a value is given to an array or a struct as a whole, or to a part of it.
fn whole_remedy(name: &str, part: &Part<'_>) -> String {
    let name = shortened(name);
    match part {
        Part::One(_) => format!("write `{name}`"),
        Part::Array(count) => {
            format!("`{name}` is an array of {count}: write `[…]` with all, or set `{name}[0]`")
        }
        Part::Struct(members) => format!(
            "`{name}` is a struct: write `{{ \"struct\": {{ … }} }}`, or set `{name}.{}`",
            members.first().unwrap_or(&"…")
        ),
    }
}

/// What is wrong with `rest`, which follows the name `of` of a part.
fn beyond(of: &str, part: &Part<'_>, rest: &str) -> String {
    let of = shortened(of);
    let step = &rest[1..];
    let step = &step[..step.find(['.', '[']).unwrap_or(step.len())];
    match part {
        Part::One(_) => format!("`{of}` is one value and has no parts"),
        Part::Array(1) => format!("`{of}` has 1 value: `{of}[0]`"),
        Part::Array(count) => {
            format!("`{of}` has {count} values, 0 to {}", count - 1)
        }
        Part::Struct(members) => match nearest(step, members.iter().copied()) {
            Some(near) if rest.starts_with('.') => format!("did you mean `{of}.{}`?", near.name),
            _ => format!("the members of `{of}` are {}", listed(members.iter().copied())),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::values::Literal;

    fn parameters() -> Vec<Parameter> {
        let names = [
            "tint",
            "layers[0].kind",
            "layers[0].color",
            "layers[1].kind",
            "layers[1].color",
            "layers[2].kind",
            "layers[2].color",
            "grid[0][0]",
            "grid[0][1]",
            "fog.near.start",
        ];
        names.map(|name| Parameter::new(name, Literal::Integer(0))).into()
    }

    #[test]
    fn arrays_and_structs_are_found_again() {
        let parameters = parameters();
        let parts = Parts::of(&parameters);
        assert_eq!(parts.get("tint"), Some(&Part::One(0)));
        assert_eq!(parts.get("layers"), Some(&Part::Array(3)));
        assert_eq!(parts.get("layers[1]"), Some(&Part::Struct(vec!["kind", "color"])));
        assert_eq!(parts.get("grid"), Some(&Part::Array(1)));
        assert_eq!(parts.get("grid[0]"), Some(&Part::Array(2)));
        assert_eq!(parts.get("fog.near"), Some(&Part::Struct(vec!["start"])));
        assert_eq!(parts.whole, ["tint", "layers", "grid", "fog"]);
    }

    #[test]
    fn what_is_wrong_with_a_name_is_told() {
        let parameters = parameters();
        let parts = Parts::of(&parameters);
        let told = |name: &str, part: &str| {
            let help = parts.remedy(name);
            assert!(help.contains(part), "{name}: {help}");
        };
        told("layers[5].kind", "`layers` has 3 values, 0 to 2");
        told("layers[-1]", "`layers` has 3 values");
        told("layers[3]", "`layers` has 3 values");
        told("layers.kind", "`layers` has 3 values");
        told("grid[1]", "`grid` has 1 value: `grid[0]`");
        told("grid[0][2]", "`grid[0]` has 2 values, 0 to 1");
        told("layers[2].colour", "did you mean `layers[2].color`?");
        told("layers[2].xyz", "the members of `layers[2]` are `kind` and `color`");
        told("layers[2][0]", "the members of `layers[2]` are");
        told("tint.r", "`tint` is one value");
        told("tint[0]", "`tint` is one value");
        told("layers", "an array of 3");
        told("fog", "is a struct");
        told("tnit", "did you mean `tint`?");
        assert!(nearest("tnit", parts.names()).is_some_and(|near| near.sure), "each name once");
        told("anything_else", "its parameters are `tint`, `layers`, `grid` and `fog`");
    }
}
