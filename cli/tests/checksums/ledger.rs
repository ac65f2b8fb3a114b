//! Lists of what is, compared with those checked in.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// A list: of each thing a line, its name and what is known of it.
#[derive(Default)]
pub struct Ledger {
    lines: BTreeMap<String, String>,
}

impl Ledger {
    /// Adds a thing.
    pub fn add(&mut self, name: String, known: String) {
        assert!(!name.contains(SEPARATOR) && !known.contains('\n'), "{name}: {known}");
        let before = self.lines.insert(name, known);
        assert!(before.is_none(), "two things of one name: {before:?}");
    }

    /// Compares the list with the one checked in under this name, or writes it.
    ///
    /// # Panics
    /// They differ.
    pub fn hold(&self, name: &str) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/checksums").join(name);
        if std::env::var_os("PHENOMENON_BLESS").is_some() {
            let mut text = String::new();
            for (name, known) in &self.lines {
                writeln!(text, "{name}{SEPARATOR}{known}").unwrap();
            }
            std::fs::write(&path, text).unwrap();
        }
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        let expected = text.lines().map(|line| line.split_once(SEPARATOR).expect("a line"));
        let differences = self.differences(expected.collect());
        let count = differences.len();
        let shown = differences.into_iter().take(SHOWN).collect::<Vec<_>>().join("\n");
        assert!(count == 0, "{name}: {count} of {} changed\n{shown}", self.lines.len());
    }

    fn differences(&self, expected: BTreeMap<&str, &str>) -> Vec<String> {
        let mut differences = Vec::new();
        for (name, was) in &expected {
            match self.lines.get(*name) {
                Some(is) if is == was => {}
                Some(is) => differences.push(format!("{name}\n  was {was}\n  is  {is}")),
                None => differences.push(format!("{name}\n  was {was}\n  is  gone")),
            }
        }
        let new = self.lines.iter().filter(|(name, _)| !expected.contains_key(name.as_str()));
        differences.extend(new.map(|(name, is)| format!("{name}\n  is  new: {is}")));
        differences
    }
}

/// Between a name and what is known.
const SEPARATOR: &str = " = ";

/// Most differences in a message.
const SHOWN: usize = 40;

/// FNV-1a of 64 bits, which is the same on every machine and in every release.
pub fn checksum(bytes: impl IntoIterator<Item = u8>) -> String {
    let hash = bytes.into_iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    });
    format!("{hash:016x}")
}

/// By the test vectors of its authors: <http://www.isthe.com/chongo/src/fnv/test_fnv.c>.
#[test]
fn the_checksum_is_fnv_1a() {
    assert_eq!(checksum([]), "cbf29ce484222325");
    assert_eq!(checksum(*b"a"), "af63dc4c8601ec8c");
    assert_eq!(checksum(*b"foobar"), "85944171f73967e8");
}

#[test]
fn every_kind_of_difference_is_told() {
    let mut ledger = Ledger::default();
    for (name, known) in [("same", "1"), ("changed", "2"), ("new", "3")] {
        ledger.add(name.to_owned(), known.to_owned());
    }
    let expected = BTreeMap::from([("same", "1"), ("changed", "1"), ("gone", "4")]);
    let told = ["changed\n  was 1\n  is  2", "gone\n  was 4\n  is  gone", "new\n  is  new: 3"];
    assert_eq!(ledger.differences(expected), told);
}
