//! Changes that leave JSON: most of what they make reaches the checker.

use std::sync::LazyLock;

use libfuzzer_sys::fuzzer_mutate;
use phenomenon_compiler::document::{Document, Value, ValueKind, read};
use phenomenon_runtime::scene_file::file_schema;
use serde_json::Value as Json;

use super::files::SEPARATOR;
use super::library::LIBRARY;
use super::tree::{at, count, member, strings, value, write};

/// Every word that means something in a graph or a scene, out of the schema.
static WORDS: LazyLock<Vec<String>> = LazyLock::new(|| {
    let schema: Json = serde_json::from_str(&file_schema(&LIBRARY)).expect("the schema is JSON");
    let mut words = Vec::new();
    collect(&schema, &mut words);
    for output in LIBRARY.iter().flat_map(|(_, definition)| &definition.signature.outputs) {
        words.push(output.name.to_string());
    }
    words.sort();
    words.dedup();
    words
});

fn collect(schema: &Json, words: &mut Vec<String>) {
    match schema {
        Json::Array(elements) => elements.iter().for_each(|element| collect(element, words)),
        Json::Object(members) => {
            for (key, value) in members {
                match (key.as_str(), value) {
                    ("properties", Json::Object(properties)) => {
                        words.extend(properties.keys().cloned());
                    }
                    ("const", Json::String(word)) => words.push(word.clone()),
                    ("enum", Json::Array(choices)) => {
                        words.extend(choices.iter().filter_map(Json::as_str).map(str::to_owned));
                    }
                    _ => {}
                }
                collect(value, words);
            }
        }
        _ => {}
    }
}

const NUMBERS: [&str; 16] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "0.5",
    "2",
    "3",
    "1e39",
    "-1e400",
    "1e-46",
    "3.4028235e38",
    "2147483648",
    "-2147483649",
    "16777217",
    "0.1",
    "1e0",
];

/// Numbers by chance, all from the seed libFuzzer gives (xorshift64*).
struct Chance(u64);

impl Chance {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let mixed = self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 33;
        mixed as usize % end.max(1)
    }

    fn of<'t, T: ?Sized>(&mut self, choices: &[&'t T]) -> Option<&'t T> {
        choices.get(self.below(choices.len())).copied()
    }
}

/// Changes the `size` first bytes of an input in place, to at most `most`; the new size.
pub fn mutate(bytes: &mut [u8], size: usize, most: usize, seed: u32) -> usize {
    let mut chance = Chance(u64::from(seed) << 1 | 1);
    if chance.below(4) == 0 {
        return fuzzer_mutate(bytes, size, most);
    }
    let mut files: Vec<Vec<u8>> =
        bytes[..size].split(|byte| *byte == SEPARATOR).map(<[u8]>::to_vec).collect();
    let at = chance.below(files.len());
    // Another file, for a node to use.
    if chance.below(50) == 0 && files.len() < 5 {
        files.push(files[at].clone());
    }
    let Ok(mut document) = read("file.json", &files[at]) else {
        return fuzzer_mutate(bytes, size, most);
    };
    for _ in 0..=chance.below(4) {
        change(&mut document, &mut chance);
    }
    let mut text = String::new();
    write(&document.root, &mut text);
    files[at] = text.into_bytes();
    let all = files.join(&SEPARATOR);
    if all.len() > most {
        return fuzzer_mutate(bytes, size, most);
    }
    bytes[..all.len()].copy_from_slice(&all);
    all.len()
}

fn change(document: &mut Document, chance: &mut Chance) {
    let before = document.root.clone();
    let mut own = Vec::new();
    strings(&before, &mut own);
    let total = count(&before);
    let Some(target) = at(&mut document.root, &mut chance.below(total)) else { return };
    match (chance.below(3), &mut target.kind) {
        (1.., ValueKind::Object(members)) if !members.is_empty() => {
            let one = chance.below(members.len());
            let two = chance.below(members.len());
            match chance.below(6) {
                0 => drop(members.remove(one)),
                1 => members[one].key = word(&own, chance),
                2 => {
                    let mut copy = members[one].clone();
                    if chance.below(4) > 0 {
                        copy.key = format!("{}{}", copy.key, chance.below(10));
                    }
                    members.insert(two, copy);
                }
                3 => members.swap(one, two),
                4 => members[two].value = members[one].value.clone(),
                _ => members.insert(one, member(&word(&own, chance), piece(&before, &own, chance))),
            }
        }
        (1.., ValueKind::Array(elements)) if !elements.is_empty() => {
            let one = chance.below(elements.len());
            match chance.below(3) {
                0 => drop(elements.remove(one)),
                1 => elements.insert(one, piece(&before, &own, chance)),
                _ => elements.insert(one, elements[one].clone()),
            }
        }
        (1.., ValueKind::String(text)) => {
            *text =
                if chance.below(4) == 0 { expression(&own, chance) } else { word(&own, chance) };
        }
        _ => *target = piece(&before, &own, chance),
    }
}

/// A word of the language, one of the document, or one misspelt.
fn word(own: &[&str], chance: &mut Chance) -> String {
    let words: Vec<&str> = WORDS.iter().map(String::as_str).collect();
    let from = if chance.below(2) == 0 { own } else { words.as_slice() };
    let mut word = chance.of(from).unwrap_or("").to_owned();
    if chance.below(6) == 0 {
        let letters: Vec<char> = word.chars().collect();
        let at = chance.below(letters.len());
        let place: usize = letters.iter().take(at).map(|letter| letter.len_utf8()).sum();
        match chance.below(3) {
            0 if at < letters.len() => drop(word.remove(place)),
            1 => word.insert(place, 'é'),
            _ => word.insert(place, 'e'),
        }
    }
    word
}

fn piece(tree: &Value, own: &[&str], chance: &mut Chance) -> Value {
    let number = |chance: &mut Chance| {
        value(ValueKind::Number(chance.of(&NUMBERS).unwrap_or("0").to_owned()))
    };
    let string = |chance: &mut Chance| value(ValueKind::String(word(own, chance)));
    let object = |members| value(ValueKind::Object(members));
    match chance.below(11) {
        0 => {
            let mut tree = tree.clone();
            let total = count(&tree);
            let found = at(&mut tree, &mut chance.below(total));
            found.map_or(value(ValueKind::Null), |found| found.clone())
        }
        1 => value(ValueKind::Boolean(chance.below(2) == 0)),
        2 => string(chance),
        3 => {
            let length = chance.below(6);
            value(ValueKind::Array((0..length).map(|_| number(chance)).collect()))
        }
        4 => {
            let mut members = vec![member("node", string(chance))];
            if chance.below(2) == 0 {
                members.push(member("output", string(chance)));
            }
            object(members)
        }
        5 => object(vec![member("interface", string(chance))]),
        6 => {
            let input = member(&word(own, chance), number(chance));
            let inputs = member("inputs", object(vec![input]));
            object(vec![member("type", string(chance)), inputs])
        }
        7 => {
            let file = format!("{}.json", chance.below(4));
            object(vec![member("file", value(ValueKind::String(file)))])
        }
        8 => object(vec![member("light", string(chance))]),
        9 => {
            let text = value(ValueKind::String(expression(own, chance)));
            let mut members = vec![member("expression", text)];
            if chance.below(2) == 0 {
                let bound = member(&word(own, chance), piece(tree, own, chance));
                members.push(member("where", object(vec![bound])));
            }
            object(members)
        }
        _ => number(chance),
    }
}

/// What stands between the names of an expression.
const SIGNS: [&str; 24] = [
    " + ", " - ", " * ", " / ", " ** ", " % ", " < ", " == ", " && ", " or ", "!", "-", "(", ")",
    "[", "]", ", ", ": ", " ? ", ".", ".x", ".rgb", "'", "vector(",
];

/// An expression, more or less.
fn expression(own: &[&str], chance: &mut Chance) -> String {
    let mut text = String::new();
    for _ in 0..=chance.below(12) {
        match chance.below(4) {
            0 => text.push_str(chance.of(&NUMBERS).unwrap_or("0")),
            1 => text.push_str(&word(own, chance)),
            _ => text.push_str(chance.of(&SIGNS).unwrap_or("")),
        }
    }
    text
}
