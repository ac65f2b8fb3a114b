//! The plan: the table of rooms in `docs/architecture.md`.

use std::collections::BTreeMap;
use std::path::Path;

/// Rooms with their floors, by crate.
pub struct Plan(BTreeMap<String, BTreeMap<String, usize>>);

impl Plan {
    /// Reads the rows `| crate | floor | rooms | … |`, each room in backticks.
    pub fn read(page: &Path) -> Self {
        let text = std::fs::read_to_string(page).expect("the page is there");
        let mut crates: BTreeMap<String, BTreeMap<String, usize>> = BTreeMap::new();
        for line in text.lines().filter(|line| line.starts_with("| `")) {
            let cells: Vec<&str> = line.split('|').map(str::trim).collect();
            let &[_, name, floor, rooms, ..] = cells.as_slice() else { continue };
            let Ok(floor) = floor.parse() else { continue };
            let floors = crates.entry(name.trim_matches('`').to_owned()).or_default();
            for room in rooms.split('`').skip(1).step_by(2) {
                let twice = floors.insert(room.to_owned(), floor);
                assert!(twice.is_none(), "{name}: `{room}` stands on two floors");
            }
        }
        Self(crates)
    }

    pub fn floors(&self, name: &str) -> &BTreeMap<String, usize> {
        self.0.get(name).unwrap_or_else(|| panic!("the plan has no rooms of `{name}`"))
    }
}
