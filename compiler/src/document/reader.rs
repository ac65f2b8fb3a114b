//! Typed reading of documents: objects with known keys, numbers in range, choices. Every mistake
//! becomes a finding, and reading goes on.

use std::collections::HashMap;
use std::ops::RangeInclusive;

use crate::diagnostics::synonyms::{self, Synonym};
use crate::diagnostics::{
    Advice, Code, Finding, Findings, Suggestions, is_near, listed, shortened, shown,
};

use super::numbers::{self, Whole};
use super::{Document, Member, Value, ValueKind};

/// Reads values of a document and collects findings.
#[derive(Debug)]
pub struct Reader<'d> {
    /// The document.
    pub document: &'d Document,
    /// What was found so far.
    pub findings: Findings,
    /// Strings that name files which are opened as they are, for whoever can look.
    pub files: Vec<&'d Value>,
    /// What misspelt names of the document may mean.
    pub suggestions: Suggestions,
}

/// An object whose keys are known.
#[derive(Clone, Debug)]
pub struct Object<'d> {
    /// The object.
    pub value: &'d Value,
    /// What it is, for messages: "the camera", "node `shade`".
    pub what: String,
}

impl<'d> Object<'d> {
    /// An object whose keys are looked at later, or a finding.
    pub fn unchecked(reader: &mut Reader<'d>, value: &'d Value, what: &str) -> Option<Self> {
        if matches!(value.kind, ValueKind::Object(_)) {
            return Some(Self { value, what: what.to_owned() });
        }
        reader.wrong_kind(value, what, "an object");
        None
    }

    /// The value of a key; the first where there are several.
    pub fn optional(&self, key: &str) -> Option<&'d Value> {
        self.value.get(key)
    }

    /// The value of a key, or a finding that it is missing.
    pub fn required(&self, reader: &mut Reader<'d>, key: &str) -> Option<&'d Value> {
        let value = self.value.get(key);
        if value.is_none() {
            reader.missing(self.value, &self.what, key);
        }
        value
    }
}

impl<'d> Reader<'d> {
    /// A reader of `document` that has already reported its duplicate keys.
    pub fn new(document: &'d Document) -> Self {
        let mut reader = Self::of_part(document);
        reader.duplicates(&document.root);
        reader
    }

    /// A reader of `document`, which is part of one whose duplicate keys were reported.
    pub fn of_part(document: &'d Document) -> Self {
        let (findings, suggestions) = (Findings::default(), Suggestions::default());
        Self { document, findings, files: Vec::new(), suggestions }
    }

    /// What to say of a name that is none of `names`, or else of what it means elsewhere.
    pub fn advice<'a>(
        &self,
        wrong: &str,
        names: impl ExactSizeIterator<Item = &'a str>,
        synonym: Option<Synonym>,
        otherwise: impl FnOnce() -> String,
    ) -> Advice {
        Advice::of(synonym, self.suggestions.nearest(wrong, names), otherwise)
    }

    /// Reports a mistake at a value.
    pub fn report(
        &mut self,
        code: Code,
        value: &Value,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        let finding = Finding::new(code, self.document.place(value), message, help);
        self.findings.push(finding);
    }

    /// Reports a mistake at a key.
    pub fn report_key(
        &mut self,
        code: Code,
        member: &Member,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        let finding = Finding::new(code, self.document.place_of_key(member), message, help);
        self.findings.push(finding);
    }

    /// Reports a value of the wrong kind; `expected` has its article: "an object".
    pub fn wrong_kind(&mut self, value: &Value, what: &str, expected: &str) {
        let message = format!("{what} must be {expected}, not {}", value.describe());
        self.report(Code::WRONG_KIND, value, message, format!("write {expected} here"));
    }

    /// Reports that an object lacks a key.
    pub fn missing(&mut self, value: &Value, what: &str, key: &str) {
        // A misspelt key, or what it is called elsewhere, was reported as the unknown one it is.
        let misspelt = |member: &Member| {
            member.key != key
                && (is_near(&member.key, key)
                    || synonyms::key(&member.key, |ours| ours == key).is_some())
        };
        if value.members().iter().any(misspelt) {
            return;
        }
        // The opening bracket is place enough: the object may be the whole file.
        let place = self.document.place_of_bytes(value.start, value.start + 1);
        self.findings.push(Finding::new(
            Code::MISSING_KEY,
            place,
            format!("{what} lacks the key `{key}`"),
            format!("add `\"{key}\": …`"),
        ));
    }

    /// An object, or a finding; each member not in `keys` is a finding, with the nearest key.
    pub fn object(&mut self, value: &'d Value, what: &str, keys: &[&str]) -> Option<Object<'d>> {
        let mut free: Option<Vec<&str>> = None;
        for member in self.members(value, what)? {
            if !keys.contains(&member.key.as_str()) {
                // What is there already is not meant once more.
                let is_free = |key: &&str| value.get(key).is_none();
                let free =
                    free.get_or_insert_with(|| keys.iter().copied().filter(is_free).collect());
                self.unknown_key_among(member, what, keys, free);
            }
        }
        Some(Object { value, what: what.to_owned() })
    }

    /// The members of an object with free keys, each key once; or a finding.
    pub fn members(
        &mut self,
        value: &'d Value,
        what: &str,
    ) -> Option<impl Iterator<Item = &'d Member> + use<'d>> {
        let ValueKind::Object(members) = &value.kind else {
            self.wrong_kind(value, what, "an object");
            return None;
        };
        let mut seen = std::collections::HashSet::with_capacity(members.len());
        Some(members.iter().filter(move |member| seen.insert(member.key.as_str())))
    }

    /// Reports a key that is not one of `keys`.
    pub fn unknown_key(&mut self, member: &Member, what: &str, keys: &[&str]) {
        self.unknown_key_among(member, what, keys, keys);
    }

    fn unknown_key_among(&mut self, member: &Member, what: &str, keys: &[&str], free: &[&str]) {
        let message = format!("{what} has no key `{}`", shortened(&member.key));
        let synonym = synonyms::key(&member.key, |ours| free.contains(&ours));
        let advice = self.advice(&member.key, free.iter().copied(), synonym, || {
            format!("its keys are {}", listed(keys.iter().copied()))
        });
        let place = self.document.place_of_key(member);
        self.findings.push(Finding::misspelt(Code::UNKNOWN_KEY, place, message, advice));
    }

    /// A string, or a finding.
    pub fn string(&mut self, value: &'d Value, what: &str) -> Option<&'d str> {
        match &value.kind {
            ValueKind::String(text) => Some(text),
            _ => {
                self.wrong_kind(value, what, "a string");
                None
            }
        }
    }

    /// True or false, or a finding.
    pub fn boolean(&mut self, value: &'d Value, what: &str) -> Option<bool> {
        match value.kind {
            ValueKind::Boolean(value) => Some(value),
            _ => {
                self.wrong_kind(value, what, "true or false");
                None
            }
        }
    }

    /// The elements of a list, or a finding.
    pub fn list(&mut self, value: &'d Value, what: &str) -> Option<&'d [Value]> {
        match &value.kind {
            ValueKind::Array(elements) => Some(elements),
            _ => {
                self.wrong_kind(value, what, "a list");
                None
            }
        }
    }

    /// A number that is finite in 32 bits, or a finding.
    pub fn finite(&mut self, value: &'d Value, what: &str) -> Option<f64> {
        let ValueKind::Number(text) = &value.kind else {
            self.wrong_kind(value, what, "a number");
            return None;
        };
        // Whoever rounds it to 32 bits gets the single nearest to the decimal: nothing is rounded twice.
        match numbers::double(text) {
            Some(number) if (number as f32).is_finite() => Some(number),
            _ => {
                let message = format!("{what} is {}, too large for 32 bits", shortened(text));
                self.report(Code::NOT_FINITE, value, message, "the largest scalar is 3.4028235e38");
                None
            }
        }
    }

    /// A finite number within `range`, or a finding.
    pub fn number(
        &mut self,
        value: &'d Value,
        what: &str,
        range: RangeInclusive<f64>,
    ) -> Option<f64> {
        let number = self.finite(value, what)?;
        if range.contains(&number) {
            return Some(number);
        }
        self.out_of_range(value, what, &shown(&range));
        None
    }

    /// A whole number within `range`, or a finding. `2.0` and `1e3` are whole; every digit counts.
    pub fn integer<T: TryFrom<i128> + Into<i128> + Copy>(
        &mut self,
        value: &'d Value,
        what: &str,
        range: RangeInclusive<T>,
    ) -> Option<T> {
        let ValueKind::Number(text) = &value.kind else {
            self.wrong_kind(value, what, "a number");
            return None;
        };
        let (low, high): (i128, i128) = ((*range.start()).into(), (*range.end()).into());
        match numbers::whole(text) {
            Whole::Number(number) if (low..=high).contains(&number) => T::try_from(number).ok(),
            // Told in one way, whatever the number is that is too large.
            Whole::Number(_) if self.finite(value, what).is_none() => None,
            Whole::Number(_) => {
                self.out_of_range(value, what, &format!("{low} to {high}"));
                None
            }
            Whole::Fraction | Whole::NoNumber => {
                self.wrong_kind(value, what, "a whole number");
                None
            }
        }
    }

    fn out_of_range(&mut self, value: &Value, what: &str, range: &str) {
        let given = match &value.kind {
            ValueKind::Number(text) => shortened(text),
            _ => value.describe(),
        };
        let message = format!("{what} is {given}, outside {range}");
        let help = format!("give a number in {range}");
        self.report(Code::NUMBER_OUT_OF_RANGE, value, message, help);
    }

    /// A list of exactly `N` numbers within `range`, or a finding.
    pub fn numbers<const N: usize>(
        &mut self,
        value: &'d Value,
        what: &str,
        range: RangeInclusive<f64>,
    ) -> Option<[f64; N]> {
        let elements = match &value.kind {
            ValueKind::Array(elements) if elements.len() == N => elements,
            _ => {
                self.wrong_kind(value, what, &format!("a list of {N} numbers"));
                return None;
            }
        };
        let mut numbers = [0.0; N];
        let mut complete = true;
        for (number, element) in numbers.iter_mut().zip(elements) {
            match self.number(element, what, range.clone()) {
                Some(value) => *number = value,
                None => complete = false,
            }
        }
        complete.then_some(numbers)
    }

    /// One of a few words, or a finding with the nearest.
    pub fn choice<T: Copy>(
        &mut self,
        value: &'d Value,
        what: &str,
        choices: &[(&str, T)],
    ) -> Option<T> {
        self.choice_or(value, what, choices, |_| None)
    }

    /// The same for words that others have names for.
    pub fn choice_or<T: Copy>(
        &mut self,
        value: &'d Value,
        what: &str,
        choices: &[(&str, T)],
        synonym: impl Fn(&str) -> Option<Synonym>,
    ) -> Option<T> {
        let text = self.string(value, what)?;
        if let Some((_, choice)) = choices.iter().find(|(name, _)| *name == text) {
            return Some(*choice);
        }
        let names = || choices.iter().map(|(name, _)| *name);
        let advice = self
            .advice(text, names(), synonym(text), || format!("write one of {}", listed(names())));
        let message = format!("{what} cannot be `{}`", shortened(text));
        let place = self.document.place(value);
        self.findings.push(Finding::misspelt(Code::UNKNOWN_CHOICE, place, message, advice));
        None
    }

    /// Reports every key that stands more than once in one object. The nesting is bounded by
    /// [`super::MAX_DEPTH`], and so is this recursion.
    fn duplicates(&mut self, value: &'d Value) {
        match &value.kind {
            ValueKind::Array(elements) => {
                elements.iter().for_each(|element| self.duplicates(element))
            }
            ValueKind::Object(members) => {
                let mut seen: HashMap<&str, (&Member, usize)> =
                    HashMap::with_capacity(members.len());
                let mut repeated: Vec<&Member> = Vec::new();
                for member in members {
                    let entry = seen.entry(&member.key).or_insert((member, 0));
                    entry.1 += 1;
                    if entry.1 == 2 {
                        repeated.push(member);
                    }
                    // What stands under a repeated key is ignored, so it is not searched.
                    if entry.1 == 1 {
                        self.duplicates(&member.value);
                    }
                }
                for second in repeated {
                    let (first, count) = seen[second.key.as_str()];
                    self.duplicate(first, second, count);
                }
            }
            _ => {}
        }
    }

    fn duplicate(&mut self, first: &Member, second: &Member, count: usize) {
        let times = if count == 2 { "twice".into() } else { format!("{count} times") };
        let finding = Finding::new(
            Code::DUPLICATE_KEY,
            self.document.place_of_key(second),
            format!("the key `{}` stands {times} in one object", shortened(&second.key)),
            "rename or remove all but one",
        )
        .with_related(self.document.place_of_key(first), "first given here");
        self.findings.push(finding);
    }
}
