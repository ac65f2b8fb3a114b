//! What changes between two texts.

use similar::TextDiff;

/// The lines that change, as `patch` takes them; empty where none do.
pub fn unified(name: &str, old: &str, new: &str) -> String {
    if old == new {
        return String::new();
    }
    TextDiff::from_lines(old, new).unified_diff().header(name, name).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_changes_is_shown() {
        assert_eq!(unified("a", "1\n", "1\n"), "");
        let told = unified("a.json", "1\n2\n3\n", "1\n4\n3\n");
        assert_eq!(told, "--- a.json\n+++ a.json\n@@ -1,3 +1,3 @@\n 1\n-2\n+4\n 3\n");
        assert!(unified("a", "1", "1\n").contains("No newline at end of file"));
    }
}
