//! `docs/diagnostics.md`, made from the codes.

use std::fmt::Write;

use super::Explanation;

/// The page that lists every code with its story.
pub fn documentation() -> String {
    let mut text = String::from(
        "# Diagnostics\n\n\
         What `phenomenon check` can find. This page is made from `compiler/src/diagnostics/codes.rs`, \
         as are the texts of `phenomenon explain CODE`; a test keeps it in sync.\n\n\
         An error leaves the file unusable. A warning is probably a mistake, a note is worth knowing; \
         `--deny warnings` makes warnings errors, `--allow CODE` silences what is no error. One mistake \
         is one finding: what only follows from it is not told. At most 10,000 findings are kept for a \
         file and 1,000 shown, the rest is counted.\n\n\
         | code | severity | meaning |\n| --- | --- | --- |\n",
    );
    for Explanation { code, severity, title, .. } in Explanation::ALL {
        let _ = writeln!(text, "| [{code}](#{code}) | {severity} | {title} |");
    }
    for Explanation { code, severity, title, story, wrong, right, .. } in Explanation::ALL {
        let _ = write!(text, "\n## {code}\n\n{title} ({severity}).\n\n{story}\n");
        if !wrong.is_empty() {
            let _ = write!(
                text,
                "\nWrong:\n\n```json\n{wrong}\n```\n\nRight:\n\n```json\n{right}\n```\n"
            );
        }
    }
    text
}
