//! Inputs made to crash, hang or mislead the reader and the checker.

mod chain;

use std::fmt::Write;
use std::time::{Duration, Instant};

use chain::chain;
use cpu_time::ThreadTime;
use phenomenon_compiler::check::{Checked, check_graph, read_graph_file};
use phenomenon_compiler::diagnostics::{Code, KEPT_FINDINGS, Severity};
use phenomenon_compiler::document::{
    MAX_DEPTH, MAX_FILE_BYTES, MAX_VALUES, ValueKind, canonical, read,
};
use phenomenon_compiler::graph::Binding;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::{Literal, Type};

fn check(bytes: impl AsRef<[u8]>) -> Checked {
    match read("hostile.json", bytes.as_ref()) {
        Ok(document) => check_graph(&document, &NodeLibrary::standard()),
        Err(finding) => Checked { findings: vec![*finding], ..Checked::default() },
    }
}

#[track_caller]
fn only(bytes: impl AsRef<[u8]>, code: Code) -> Checked {
    let checked = check(bytes);
    let codes: Vec<_> = checked.findings.iter().map(|finding| finding.code).collect();
    assert_eq!(codes, [code], "{}", checked.findings.first().map_or("", |it| &it.message));
    for finding in &checked.findings {
        // Places are inside the text, and so can be shown.
        assert!(finding.place.end <= finding.place.file.text.len());
        let _ = (finding.place.line_column(), finding.place.length());
    }
    checked
}

#[test]
fn what_is_not_json_is_one_finding() {
    for text in [
        "",
        " ",
        "\n\n",
        "nul",
        "tru",
        "{",
        "[",
        "\"",
        "{]",
        "[}",
        "{\"a\"}",
        "{\"a\":}",
        "{,}",
        "[,]",
        "[1,]",
        "[1 2]",
        "{\"a\":1 \"b\":2}",
        "01",
        "-",
        "+1",
        "1.",
        ".5",
        "1e",
        "0x10",
        "NaN",
        "Infinity",
        "-Infinity",
        "'a'",
        "\"\\x41\"",
        "\"\\u12\"",
        "\"\\ud83d\"",
        "\"\\ude00\\ud83d\"",
        "\"\t\"",
        "\"a\nb\"",
        "\"\\\n\"",
        "// c\n1",
        "/* c */ 1",
        "/*",
        "{a:1}",
        "1 1",
        "{} {}",
        "[1] // c",
        "\u{feff}{}",
        "{\u{a0}}",
        "\u{b}1",
        "[1\u{c}]",
        "{\"a\":1}\0",
        "\0",
        "#",
        "@",
        "true false",
        "]",
        "}",
        ":",
        ",",
        "{\"a\":1,}",
        "{1:2}",
        "{null:1}",
        "[\u{2028}1]",
        "\"\u{7f}",
        "é",
    ] {
        let found = only(text, Code::SYNTAX);
        assert!(!found.findings[0].help.is_empty(), "{text:?}");
    }
}

#[test]
fn strict_json_is_read_in_full() {
    let text = "\r\n{\"a\\u0041\\\"\\\\\\/\\b\\f\\n\\r\\t\\ud83d\\ude00\u{7f}é\":\t[-0.0e+1,1E-9,true,false,null,\"\",{},[]]}\n";
    let document = read("a", text.as_bytes()).unwrap();
    let ValueKind::Object(members) = &document.root.kind else { panic!() };
    assert_eq!(members[0].key, "aA\"\\/\u{8}\u{c}\n\r\t😀\u{7f}é");
    let ValueKind::Array(elements) = &members[0].value.kind else { panic!() };
    assert_eq!(elements[0].kind, ValueKind::Number("-0.0e+1".into()));
    assert_eq!(elements.len(), 8);
    let place = document.place(&elements[4]);
    assert_eq!(place.text(), "null");
    assert!(place.path.ends_with("[4]"), "{}", place.path);
    assert_eq!(place.line_column().0, 2);
}

#[test]
fn columns_count_characters() {
    let checked = check("{ \"phenomenon\": \"a\", \"roots\": { \"é😀\": 1 } }");
    assert_eq!(checked.findings[0].place.line_column(), (1, 33));
    assert_eq!(checked.findings[0].place.length(), 4);
}

#[test]
fn nesting_is_bounded() {
    for (open, close) in [("[", "]"), ("{\"a\":", "}")] {
        let nested = |depth: usize| format!("{}1{}", open.repeat(depth), close.repeat(depth));
        assert!(read("a", nested(MAX_DEPTH).as_bytes()).is_ok());
        only(nested(MAX_DEPTH + 1), Code::TOO_DEEP);
        only(nested(1_000_000), Code::TOO_DEEP);
        only(open.repeat(1_000_000), Code::TOO_DEEP);
    }
    // Brackets in strings nest nothing.
    assert!(read("a", format!("\"{}\"", "[".repeat(1000)).as_bytes()).is_ok());
}

#[test]
fn encodings_other_than_utf8_are_named() {
    let found = only(b"\xff\xfe{\0}\0", Code::NOT_UTF8);
    assert!(found.findings[0].message.contains("UTF-16"));
    let utf16 = |text: &str, little: bool| -> Vec<u8> {
        let bytes = |unit: u16| if little { unit.to_le_bytes() } else { unit.to_be_bytes() };
        text.encode_utf16().flat_map(bytes).collect()
    };
    for (text, little) in [("\u{feff}{ }", false), ("{ \"é\": 1 }", true), ("{ \"é\": 1 }", false)]
    {
        let found = only(utf16(text, little), Code::NOT_UTF8);
        assert!(found.findings[0].message.contains("UTF-16"), "{text}");
        assert!(found.findings[0].place.file.text.starts_with('{'), "it can be read");
    }
    let found = only(b"{ \"a\": \"\xc3\x28\" }", Code::NOT_UTF8);
    assert_eq!(found.findings[0].place.line_column(), (1, 9));
    only(b"\xed\xa0\x80", Code::NOT_UTF8);
    only(b"\xf8", Code::NOT_UTF8);
}

#[test]
fn a_sparse_file_past_the_limit_is_not_read() {
    let path = std::env::temp_dir().join(format!("phenomenon-sparse-{}.json", std::process::id()));
    let file = std::fs::File::create(&path).unwrap();
    file.set_len(1 << 40).or_else(|_| file.set_len(MAX_FILE_BYTES as u64 + 1)).unwrap();
    let started = Instant::now();
    let checked = read_graph_file(&path, &NodeLibrary::standard());
    std::fs::remove_file(&path).unwrap();
    assert_eq!(checked.findings[0].code, Code::FILE_TOO_LARGE);
    assert!(started.elapsed() < Duration::from_secs(5));
}

#[test]
fn files_that_cannot_be_read_are_findings() {
    for path in ["no/such/file.json", ".", "/", "a\0b"] {
        let checked = read_graph_file(path.as_ref(), &NodeLibrary::standard());
        assert_eq!(checked.findings[0].code, Code::UNREADABLE_FILE, "{path:?}");
        assert!(checked.graph.is_none());
    }
}

#[test]
fn a_million_duplicate_keys_are_one_finding() {
    let mut text = String::from("{\"phenomenon\":\"a\",\"roots\":{\"material\":1");
    for _ in 0..1_000_000 {
        text.push_str(",\"material\":1");
    }
    text.push_str("}}");
    let found = only(&text, Code::DUPLICATE_KEY);
    assert!(found.findings[0].message.contains("1000001 times"));
}

#[test]
fn a_million_keys_each_given_twice_are_counted() {
    let mut text =
        String::from("{\"phenomenon\":\"a\",\"roots\":{\"material\":1},\"editor\":{\"\":0");
    for at in 0..500_000 {
        write!(text, ",\"{at}\":0,\"{at}\":0").unwrap();
    }
    text.push_str("}}");
    let started = ThreadTime::now();
    let checked = check(&text);
    assert_eq!(checked.findings.len(), KEPT_FINDINGS);
    assert_eq!(checked.findings.len() + checked.omitted, 500_000);
    assert!(checked.findings.iter().all(|finding| finding.code == Code::DUPLICATE_KEY));
    assert!(started.elapsed() < Duration::from_secs(20), "{:?}", started.elapsed());
}

#[test]
fn values_are_counted_before_they_take_memory() {
    for (one, much) in [("0,", MAX_VALUES), ("[],", MAX_VALUES / 2), ("{\"\":0},", MAX_VALUES / 2)]
    {
        let text = format!("[{}0]", one.repeat(much));
        assert!(text.len() < MAX_FILE_BYTES);
        only(text, Code::FILE_TOO_LARGE);
    }
    // A value at the limit is read: the list is one, and so is the last zero.
    let document = read("a", format!("[{}0]", "0,".repeat(MAX_VALUES - 2)).as_bytes());
    assert!(document.is_ok());
    // Commas in strings are none.
    assert!(read("a", format!("\"{}\"", ",".repeat(MAX_VALUES + 1)).as_bytes()).is_ok());
}

#[test]
fn findings_are_kept_up_to_a_limit_and_counted_past_it() {
    let mut text = String::from(
        "{\"phenomenon\":\"a\",\"roots\":{\"material\":1},\"nodes\":{\"n\":{\"type\":\"add\"}",
    );
    for at in 0..200_000 {
        write!(text, ",\"n{at}\":{{\"type\":\"ad\",\"inputs\":{{\"a\":{{\"node\":\"m{at}\"}}}}}}")
            .unwrap();
    }
    text.push_str("}}");
    let started = Instant::now();
    let checked = check(&text);
    assert_eq!(checked.findings.len(), KEPT_FINDINGS);
    assert_eq!(checked.findings.len() + checked.omitted, 400_000);
    assert!(checked.graph.is_none());
    assert!(started.elapsed() < Duration::from_secs(60), "{:?}", started.elapsed());
}

#[test]
fn a_chain_of_100_000_nodes_is_checked() {
    let length = 100_000;
    let checked = check(chain(length, "[1,0,0]"));
    assert!(checked.findings.is_empty(), "{:?}", checked.findings.first().map(|it| &it.message));
    let graph = checked.graph.unwrap();
    assert_eq!(graph.nodes.len(), length);
    // The colour at the far end makes every sum on the way a colour.
    let library = NodeLibrary::standard();
    let first = &graph.nodes[0];
    let generic = library.definition(first.node_type).overloads[first.overload].generic;
    assert_eq!(generic, Some(Type::Color));
    assert_eq!(first.inputs[1], Binding::Literal(Literal::Color([0.5, 0.5, 0.5, 1.0])));
}

/// CPU time of the quickest of some runs, so that other tests and programs do not count.
#[test]
fn time_grows_with_the_length_of_a_chain_not_with_its_square() {
    let (short, long) = (2_000, 32_000);
    let run = |length: usize, text: &str| {
        let started = ThreadTime::now();
        assert!(check(text).graph.is_some());
        started.elapsed().as_secs_f64() / length as f64
    };
    let texts = [short, long].map(|length| chain(length, "[1,0,0]"));
    let mut best = [f64::INFINITY; 2];
    for _ in 0..12 {
        best[0] = best[0].min(run(short, &texts[0]));
        best[1] = best[1].min(run(long, &texts[1]));
        // A pass that took the square would make it 16.
        if best[1] < 4.0 * best[0] {
            return;
        }
    }
    panic!("a node costs {} s in {short} and {} s in {long} nodes", best[0], best[1]);
}

#[test]
fn a_chain_does_not_overflow_a_small_stack() {
    let thread = std::thread::Builder::new().stack_size(256 << 10);
    let checked = thread.spawn(|| check(chain(100_000, "1"))).unwrap().join().unwrap();
    assert!(checked.graph.is_some());
}

#[test]
fn a_cycle_of_100_000_nodes_is_one_finding_of_bounded_size() {
    let found = only(chain(100_000, "{\"node\":\"n0\"}"), Code::CYCLE);
    assert!(found.findings[0].message.len() < 1000, "{}", found.findings[0].message);
    assert!(found.findings[0].message.contains("100000 nodes"));
    assert!(found.findings[0].related.len() < 64);
}

#[test]
fn each_knot_of_cycles_is_one_finding() {
    let node = |name: &str, source: &str| {
        format!("\"{name}\":{{\"type\":\"add\",\"inputs\":{{\"a\":{{\"node\":\"{source}\"}}}}}}")
    };
    let nodes = [node("a", "b"), node("b", "a"), node("c", "c"), node("d", "a")].join(",");
    let text = format!(
        "{{\"phenomenon\":\"k\",\"nodes\":{{{nodes}}},\"roots\":{{\"material\":{{\"node\":\"d\"}}}}}}"
    );
    let checked = check(text);
    let cycles = checked.findings.iter().filter(|finding| finding.code == Code::CYCLE).count();
    assert_eq!(cycles, 2);
    let errors = checked.findings.iter().filter(|it| it.severity == Severity::Error).count();
    assert_eq!(errors, 2, "{:?}", checked.findings);
}

#[test]
fn numbers_of_any_size_are_finite_or_findings() {
    let with =
        |number: &str| format!("{{\"phenomenon\":\"a\",\"roots\":{{\"material\":{number}}}}}");
    for number in ["1e400", "-1e400", "1e39", "3.4028236e38", &"9".repeat(1000), "1e999999999999"] {
        only(with(number), Code::NOT_FINITE);
    }
    for number in ["3.4028235e38", "-0.0", "1e-400", "1e-45", "0.00000000000000000000000000001"] {
        assert!(check(with(number)).graph.is_some(), "{number}");
    }
    let graph = check(with("-0.0")).graph.unwrap();
    let Binding::Literal(Literal::Color([r, ..])) = graph.roots[0].color else { panic!() };
    assert!(r.is_sign_negative(), "the sign of zero is kept");
}

#[test]
fn very_long_names_are_findings_with_short_messages() {
    let long = "n".repeat(1_000_000);
    let text = format!(
        "{{\"phenomenon\":\"a\",\"{long}\":1,\"requires\":{{\"trace\":\"{long}\"}},\"nodes\":{{\"{long}\":{{\"type\":\"{long}\"}}}},\"roots\":{{\"material\":{{\"node\":\"x{long}\"}}}}}}"
    );
    let checked = check(text);
    assert_eq!(checked.findings.len(), 5);
    for finding in &checked.findings {
        assert!(finding.message.len() < 1000 && finding.help.len() < 1000, "{}", finding.code);
    }
}

#[test]
fn the_canonical_form_of_hostile_files_takes_linear_time() {
    let long = "é\\u0000".repeat(1_000_000);
    let deep = "[".repeat(MAX_DEPTH - 1);
    let shut = "]".repeat(MAX_DEPTH - 1);
    for text in [
        format!("[{deep}\"{long}\"{shut}]"),
        format!("[{deep}0{}{shut}]", ",0".repeat(1_000_000)),
        format!("{{\"a\":[0{}]}}", ",0".repeat(1_000_000)),
        format!("[[{}0]]", "{\"\":[]},".repeat(500_000)),
    ] {
        let document = read("a", text.as_bytes()).unwrap();
        let started = ThreadTime::now();
        let form = canonical(&document);
        assert!(started.elapsed() < Duration::from_secs(10), "{:?}", started.elapsed());
        assert!(form.len() < 3 * text.len(), "{} {}", form.len(), text.len());
        let again = read("a", form.as_bytes()).unwrap();
        assert!(canonical(&again) == form);
    }
}

#[cfg(unix)]
#[test]
fn a_pipe_nobody_writes_to_is_not_waited_for() {
    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("pipe.json");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status().unwrap();
    assert!(made.success());
    for (nodes, what) in [
        (r#""n": { "type": { "file": "pipe.json" } }"#, "cannot be used: it is no ordinary file"),
        (
            r#""n": { "type": "texture_lookup", "inputs": { "texture": { "texture": "pipe.json" } } }"#,
            "cannot be used: it is no ordinary file",
        ),
    ] {
        let text = format!(
            r#"{{ "phenomenon": "a", "nodes": {{ {nodes} }}, "roots": {{ "material": {{ "node": "n" }} }} }}"#
        );
        let user = folder.path().join("user.json");
        std::fs::write(&user, text).unwrap();
        let checked = phenomenon_compiler::check::read_graph_file(&user, &NodeLibrary::standard());
        let [finding] = checked.findings.as_slice() else { panic!("{:?}", checked.findings) };
        assert_eq!(finding.code, Code::UNREADABLE_FILE);
        assert!(finding.message.contains(what), "{}", finding.message);
    }
}

#[test]
fn wide_declarations_take_linear_time_and_bounded_memory() {
    let join = |count: usize, one: &dyn Fn(usize) -> String| {
        (0..count).map(one).collect::<Vec<_>>().join(",")
    };
    let members = join(40_000, &|at| format!(r#""m{at}":{{"type":"scalar","default":1}}"#));
    let values = join(40_000, &|at| format!(r#""m{at}":2"#));
    let labels = join(100_000, &|at| format!(r#""l{at}""#));
    let few = join(1_000, &|at| format!(r#""label_{at}""#));
    let zeros = vec!["0"; 60_000].join(",");
    let (doc, type_of) = ("x".repeat(10_000), r#""type":"scalar","doc""#);
    for (declaration, code) in [
        (
            format!(
                r#""type":"struct","members":{{{members}}},"default":{{"struct":{{{values}}}}}"#
            ),
            None,
        ),
        (format!(r#""type":"integer","default":"l99999","values":[{labels}]"#), None),
        (
            format!(r#""type":"array","of":{{{type_of}:"{doc}"}},"default":[{zeros}]"#),
            Some(Code::TOO_MANY_PARTS),
        ),
        (
            format!(
                r#""type":"array","of":{{"type":"integer","values":[{few}]}},"default":[{zeros}]"#
            ),
            Some(Code::TOO_MANY_PARTS),
        ),
    ] {
        let text = format!(
            r#"{{"phenomenon":"a","interface":{{"p":{{{declaration}}}}},"roots":{{"material":1}}}}"#
        );
        let start = ThreadTime::now();
        let document = read("a.json", text.as_bytes()).unwrap();
        let checked = check_graph(&document, &NodeLibrary::standard());
        // Seconds where it took minutes; a fraction of one otherwise.
        assert!(
            start.elapsed() < Duration::from_secs(5),
            "{:.60} {:?}",
            declaration,
            start.elapsed()
        );
        let errors = checked.findings.iter().filter(|of| of.severity == Severity::Error);
        let codes: Vec<Code> = errors.map(|finding| finding.code).collect();
        assert_eq!(codes, code.into_iter().collect::<Vec<_>>(), "{declaration:.60}");
    }
}
