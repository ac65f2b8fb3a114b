//! Tables of names as they stand in the text files beside this.

use std::collections::HashMap;

use crate::diagnostics::listed_or;

/// What others call one of our things.
#[derive(Clone, Debug)]
pub struct Called {
    /// Our name.
    pub ours: &'static str,
    /// Names that mean exactly it: one may be put in the place of the other.
    pub exact: Vec<&'static str>,
    /// Names that mostly mean it.
    pub like: Vec<&'static str>,
    /// What somebody who knows it by another name must mind.
    pub mind: &'static str,
}

impl Called {
    /// All foreign names.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.exact.iter().chain(&self.like).copied()
    }
}

/// Names of what we have no single thing for, and what to do instead.
#[derive(Clone, Debug)]
pub struct Absent {
    /// The foreign names.
    pub names: Vec<&'static str>,
    /// What to do, as a help line.
    pub instead: &'static str,
}

/// What a foreign name means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Synonym {
    /// Our names; several where any of them may be meant, none where we have none.
    pub ours: Vec<&'static str>,
    /// Whether it means exactly the one of ours.
    pub exact: bool,
    /// What to mind or to do instead; may be empty.
    pub advice: &'static str,
}

impl Synonym {
    /// The help line.
    pub fn help(&self) -> String {
        let names = listed_or(self.ours.iter().copied());
        match (self.ours.is_empty(), self.advice.is_empty()) {
            (true, _) => self.advice.to_owned(),
            (false, true) => format!("did you mean {names}?"),
            (false, false) => format!("did you mean {names}? {}", self.advice),
        }
    }

    /// The JSON text of our name, where it means just that.
    pub fn fix(&self) -> Option<String> {
        match self.ours.as_slice() {
            [one] if self.exact => Some(format!("\"{one}\"")),
            _ => None,
        }
    }
}

/// A foreign name as the tables know it: without case, `_`, `-` and spaces.
pub(in crate::diagnostics) fn folded(name: &str) -> String {
    // Longer names are no word of any program.
    name.chars()
        .take(64)
        .filter(|c| !matches!(c, '_' | '-' | ' '))
        .flat_map(char::to_lowercase)
        .collect()
}

/// The names of one kind of thing.
pub struct Table {
    /// What others call ours, in the order of the file.
    pub called: Vec<Called>,
    /// What there is nothing for.
    pub absent: Vec<Absent>,
    /// By folded foreign name the rows of `called`, and whether the name means just it.
    meant: HashMap<String, Vec<(usize, bool)>>,
    /// By folded foreign name the rows of `absent`.
    missing: HashMap<String, usize>,
}

impl Table {
    /// Reads the lines `ours | exact | like | mind` and `names | instead`; `#` starts a comment.
    pub(super) fn new(called: &'static str, absent: &'static str) -> Self {
        let called: Vec<Called> = rows(called)
            .map(|[ours, exact, like, mind]| {
                let words = |text: &'static str| text.split_whitespace().collect();
                Called { ours, exact: words(exact), like: words(like), mind }
            })
            .collect();
        let absent: Vec<Absent> = rows(absent)
            .map(|[names, instead]| Absent { names: names.split_whitespace().collect(), instead })
            .collect();
        let mut meant: HashMap<String, Vec<(usize, bool)>> = HashMap::new();
        for (at, row) in called.iter().enumerate() {
            for (names, exact) in [(&row.exact, true), (&row.like, false)] {
                for name in names {
                    meant.entry(folded(name)).or_default().push((at, exact));
                }
            }
        }
        let mut missing = HashMap::new();
        for (at, row) in absent.iter().enumerate() {
            missing.extend(row.names.iter().map(|name| (folded(name), at)));
        }
        Self { called, absent, meant, missing }
    }

    /// What a name means among our names that are `there`.
    pub(super) fn find(&self, name: &str, there: impl Fn(&str) -> bool) -> Option<Synonym> {
        let name = folded(name);
        let rows = self.meant.get(&name).map_or(&[][..], Vec::as_slice).iter();
        let rows: Vec<(&Called, bool)> = rows
            .map(|(at, exact)| (&self.called[*at], *exact))
            .filter(|(row, _)| there(row.ours))
            .collect();
        let ours = rows.iter().map(|(row, _)| row.ours).collect();
        match rows.as_slice() {
            [] => self.missing.get(&name).map(|at| {
                let advice = self.absent[*at].instead;
                Synonym { ours, exact: false, advice }
            }),
            [(row, exact)] => Some(Synonym { ours, exact: *exact, advice: row.mind }),
            // What must be minded of one says nothing of the choice between several.
            _ => Some(Synonym { ours, exact: false, advice: "" }),
        }
    }
}

/// The columns of each line; those that are left out at its end are empty.
fn rows<const N: usize>(text: &'static str) -> impl Iterator<Item = [&'static str; N]> {
    text.lines().filter(|line| !line.is_empty() && !line.starts_with("# ")).map(|line| {
        let mut columns = [""; N];
        for (column, part) in columns.iter_mut().zip(line.split(" |")) {
            *column = part.trim();
        }
        columns
    })
}
