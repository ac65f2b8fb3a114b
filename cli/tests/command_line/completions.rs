//! Completions, manual pages, and hints to flags of other programs.

use std::collections::BTreeSet;

use crate::program::{Folder, printed, refused, run};

/// The commands that `--help` lists.
fn commands() -> BTreeSet<String> {
    let help = printed(&["--help"]);
    let (_, list) = help.split_once("Commands:\n").unwrap();
    let lines = list.lines().take_while(|line| !line.is_empty());
    // Docs go on in deeper lines.
    let names = lines.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let names = names.filter_map(|line| line.split_whitespace().next()).map(str::to_owned);
    let commands: BTreeSet<String> = names.filter(|name| name != "help").collect();
    assert!(commands.contains("render") && commands.len() > 10, "{commands:?}");
    commands
}

#[test]
fn every_shell_completes_every_command() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = printed(&["completions", shell]);
        for command in commands() {
            assert!(script.contains(&command), "{shell} lacks {command}");
        }
        for part in ["spp", "tolerance", "monolith"] {
            assert!(script.contains(part), "{shell} lacks {part}");
        }
    }
    refused(&["completions", "tcsh"], &["tcsh", "fish"]);
}

#[test]
fn every_command_has_a_page() {
    let folder = Folder::new();
    printed(&["man", "-o", &folder.path("pages/man1")]);
    let program = printed(&["man"]);
    assert!(program.starts_with(".ie") || program.contains(".TH"), "{program}");
    for command in commands() {
        let file = folder.path(&format!("pages/man1/phenomenon-{command}.1"));
        let page = std::fs::read_to_string(&file).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert_eq!(page, printed(&["man", &command]), "{command}");
        assert!(page.contains(&format!("phenomenon {command}")) || page.contains(&command));
        // Hyphens are escaped in pages.
        assert!(program.contains(&command.replace('-', "\\-")), "{command}");
    }
    assert!(printed(&["man", "render"]).contains("\\-\\-spp"));
    assert!(
        folder.path("pages").len() > 1
            && std::fs::exists(folder.path("pages/man1/phenomenon-bench-render.1")).unwrap()
    );
    refused(&["man", "rendre"], &["`rendre`", "`render`"]);
    refused(&["man", "-o", &folder.file("taken", "")], &["-o", "taken"]);
}

#[test]
fn flags_of_other_programs_are_explained() {
    let graph = "graphs/mirror/tinted_mirror.json";
    for (command, flag, hint) in [
        ("render", "--samples", "--spp N"),
        ("render", "--samples=4", "--spp N"),
        ("render", "--output", "-o FILE"),
        ("render", "--out", "-o FILE"),
        ("render", "--resolution", "--size WxH"),
        ("render", "--width", "--size WxH"),
        ("render", "--jobs", "--threads N"),
        ("eval", "--json", "--format json"),
        ("compare", "--threshold", "--tolerance RMS"),
        ("show", "--output", "-o FILE"),
    ] {
        let run = crate::program::run(&[command, graph, flag, "4"]);
        assert_eq!(run.code, Some(2), "{run:?}");
        assert!(run.complaint.contains(hint), "{flag}: {}", run.complaint);
        assert!(!run.complaint.contains("'-- "), "{flag}: {}", run.complaint);
    }
    // No hint that cannot be followed, and none that misleads.
    let run = crate::program::run(&["render", graph, "--zzz"]);
    assert!(
        run.complaint.contains("--zzz") && !run.complaint.contains("tip:"),
        "{}",
        run.complaint
    );
    let run = crate::program::run(&["render", graph, "--sizes", "4x4"]);
    assert!(run.complaint.contains("'--size'"), "{}", run.complaint);
}

#[test]
fn pages_replace_pages_alone() {
    let folder = Folder::new();
    let pages = folder.path("pages");
    printed(&["man", "-o", &pages]);
    printed(&["man", "-o", &pages]);
    let mine = folder.file("pages/phenomenon-render.1", "mine");
    let refusal = run(&["man", "-o", &pages]);
    assert_eq!(refusal.code, Some(2), "{refusal:?}");
    assert!(refusal.complaint.contains("phenomenon-render.1"), "{}", refusal.complaint);
    assert_eq!(std::fs::read_to_string(mine).unwrap(), "mine");
}
