//! Inputs whose size multiplies: each would not end, or not fit, if something were quadratic.

use std::fmt::Write;

use crate::program::{Folder, run};

#[test]
fn brackets_that_match_nothing_are_told_of_in_one_pass() {
    let folder = Folder::new();
    let behind_blanks = format!("{}{}", " ".repeat(1_000_000), "[}".repeat(50_000));
    let many = "[},".repeat(400_000);
    for (name, text) in [("blanks.json", behind_blanks), ("many.json", many)] {
        let found = run(&["check", &folder.file(name, text)]);
        assert_eq!(found.code, Some(1), "{name}");
        assert!(found.output.contains("syntax"), "{name}");
        assert!(found.output.matches("error[").count() <= 1_000, "{name}");
    }
}

/// A scene that gives each of `count` parameters no graph has, and one with as many lights.
fn strangers(count: usize) -> (String, String) {
    let (mut interface, mut set) = (String::new(), String::new());
    for number in 0..count {
        write!(interface, "\"p{number:06}\": {{ \"type\": \"scalar\", \"default\": 1 }},").unwrap();
        write!(set, "\"q{number:06}\": 1,").unwrap();
    }
    let graph = format!(
        "{{ \"phenomenon\": \"g\", \"interface\": {{ {interface} \"a\": {{ \"type\": \"color\", \"default\": 1 }} }},
            \"roots\": {{ \"material\": {{ \"interface\": \"a\" }} }} }}"
    );
    let scene = format!(
        "{{ \"scene\": \"s\", \"camera\": {{ \"position\": [0, 0, 5], \"look_at\": [0, 0, 0] }},
            \"objects\": [{{ \"sphere\": {{ \"radius\": 1 }},
              \"material\": {{ \"file\": \"g.json\", \"set\": {{ {set} \"a\": 1 }} }} }}] }}"
    );
    (graph, scene)
}

#[test]
fn thousands_of_unknown_parameters_are_told_of_and_the_first_are_advised() {
    let folder = Folder::new();
    let (graph, scene) = strangers(3_000);
    folder.file("g.json", graph);
    let found = run(&["check", &folder.file("s.json", scene)]);
    assert_eq!(found.code, Some(1));
    assert!(found.output.contains("has no parameter `q000000`"));
    assert!(found.output.contains("so many are unknown"));
}

#[test]
fn thousands_of_unknown_lights_are_told_of_by_the_first() {
    let folder = Folder::new();
    let (mut lights, mut asked) = (String::new(), String::new());
    for number in 0..3_000 {
        write!(lights, "{{ \"name\": \"l{number}\", \"point\": {{ \"position\": [0, 1, 0] }} }},")
            .unwrap();
        write!(asked, "{{ \"light\": \"zz{number}\" }},").unwrap();
    }
    let graph = format!(
        "{{ \"phenomenon\": \"g\", \"nodes\": {{ \"body\": {{ \"type\": \"lambert\" }},
            \"all\": {{ \"type\": \"light_loop\", \"inputs\": {{ \"body\": {{ \"node\": \"body\" }}, \"lights\": [{}] }} }} }},
            \"roots\": {{ \"material\": {{ \"node\": \"all\" }} }} }}",
        asked.trim_end_matches(',')
    );
    folder.file("g.json", graph);
    let scene = format!(
        "{{ \"scene\": \"s\", \"camera\": {{ \"position\": [0, 0, 5], \"look_at\": [0, 0, 0] }},
            \"lights\": [{}],
            \"objects\": [{{ \"sphere\": {{ \"radius\": 1 }}, \"material\": {{ \"file\": \"g.json\" }} }}] }}",
        lights.trim_end_matches(',')
    );
    let found = run(&["check", &folder.file("s.json", scene)]);
    assert_eq!(found.code, Some(1));
    let told = found.output.matches("unknown-light").count();
    assert!((1..=64).contains(&told), "{told}: {}", &found.output[..found.output.len().min(2_000)]);
    assert!(found.output.len() < 1_000_000);
}
