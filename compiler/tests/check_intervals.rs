//! What the checker concludes from what values may be, and what it had better not conclude.

use std::fmt::Write;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document::read;
use phenomenon_compiler::nodes::NodeLibrary;

/// Parameters the graphs of these tests have, all used: ranges, none, an integer, a condition.
const INTERFACE: &str = r#"
    "p": { "type": "scalar", "default": 0.5, "min": 0, "max": 1 },
    "q": { "type": "scalar", "default": 0.5, "min": 0, "max": 1 },
    "free": { "type": "scalar", "default": 0.5 },
    "angle": { "type": "scalar", "default": 1, "min": 0, "max": 3 },
    "count": { "type": "integer", "default": 2, "min": 0, "max": 8 },
    "tint": { "type": "color", "default": [0.5, 0.5, 0.5], "min": 0, "max": 1 },
    "way": { "type": "vector", "default": [0, 1, 0] },
    "flag": { "type": "boolean", "default": true }"#;

/// `n.b` is a connection to output b of node n, `$p` to a parameter; all else stands as it is.
fn source(text: &str) -> String {
    if let Some(parameter) = text.strip_prefix('$') {
        return format!("{{\"interface\":\"{parameter}\"}}");
    }
    let literal = text.starts_with(|first: char| first.is_ascii_digit() || "[-".contains(first));
    if literal || text == "true" || text == "false" {
        return text.to_owned();
    }
    match text.split_once('.') {
        Some((node, output)) => format!("{{\"node\":\"{node}\",\"output\":\"{output}\"}}"),
        None => format!("{{\"node\":\"{text}\"}}"),
    }
}

/// The findings for nodes written `name = type input:source …`, one a line; the last is the root. Codes
/// with the nodes they are about, save that parameters or outputs are not used.
fn findings(nodes: &str) -> Vec<String> {
    let mut text = format!("{{\"phenomenon\":\"a\",\"interface\":{{{INTERFACE}}},\"nodes\":{{");
    let mut last = "";
    for (at, line) in nodes.lines().map(str::trim).filter(|line| !line.is_empty()).enumerate() {
        let (name, rest) = line.split_once('=').unwrap();
        let mut words = rest.split_whitespace();
        let inputs: Vec<String> = (words.clone().skip(1))
            .map(|word| word.split_once(':').unwrap())
            .map(|(input, given)| format!("\"{input}\":{}", source(given)))
            .collect();
        last = name.trim();
        let comma = if at > 0 { "," } else { "" };
        let node_type = words.next().unwrap();
        let inputs = inputs.join(",");
        write!(text, "{comma}\"{last}\":{{\"type\":\"{node_type}\",\"inputs\":{{{inputs}}}}}")
            .unwrap();
    }
    write!(text, "}},\"roots\":{{\"material\":{{\"node\":\"{last}\"}}}}}}").unwrap();
    let document = read("a.json", text.as_bytes()).unwrap();
    let checked = check_graph(&document, &NodeLibrary::standard());
    checked
        .findings
        .iter()
        .filter(|finding| !["unused-parameter", "unreachable-node"].contains(&finding.code.0))
        .map(|finding| {
            let path = finding.place.path.strip_prefix("nodes.").unwrap_or(&finding.place.path);
            format!("{} {}", finding.code.0, path.replace(".inputs", ""))
        })
        .collect()
}

#[track_caller]
fn silent(nodes: &str) {
    assert_eq!(findings(nodes), [""; 0], "{nodes}");
}

#[track_caller]
fn told(nodes: &str, expected: &str) {
    assert_eq!(findings(nodes), [expected], "{nodes}");
}

#[test]
fn values_that_leave_a_range_are_told_of() {
    told("s = add a:$p b:$q\n m = mix weight:s", "range-past-input m.weight");
    told("s = subtract a:$p b:$q\n m = mix weight:s", "range-past-input m.weight");
    told("s = scale input:$p factor:2\n m = mix weight:s", "range-past-input m.weight");
    told("s = constant_scalar value:2\n m = mix weight:s", "range-past-input m.weight");
    // Of a colour the one component counts.
    told(
        "s = add a:$tint b:[0,0,1]\n c = split_color color:s\n m = mix weight:c.b",
        "range-past-input m.weight",
    );
    silent("s = add a:$tint b:[0,0,1]\n c = split_color color:s\n m = mix weight:c.g");
    // A sine is taken to go all the way unless something narrower is given to it.
    told("s = sine input:$free\n m = mix weight:s", "range-past-input m.weight");
    silent("s = sine input:$angle\n m = mix weight:s");
    // An integer arrives as a number.
    told("s = scale input:$count factor:0.5\n m = mix weight:s", "range-past-input m.weight");
    told(
        "here = state\n up = split_vector vector:here.direction\n m = mix weight:up.y",
        "range-past-input m.weight",
    );
}

#[test]
fn bounds_that_are_never_met_are_not_told_of() {
    // Intervals know these to -1..2, 0..2, -3..3 and worse.
    silent("r = one_minus input:$p\n s = multiply a:$p b:r\n m = mix weight:s");
    silent("r = one_minus input:$p\n s = add a:$p b:r\n m = mix weight:s");
    silent(
        "here = state\n s = dot a:here.normal b:here.direction\n a = absolute input:s\n m = mix weight:a",
    );
    silent("n = normalize input:$way\n s = dot a:n b:n\n m = mix weight:s");
    silent("s = mix weight:$p a:$q b:1\n m = mix weight:s");
    silent("s = smooth_step input:$free low:0.2 high:0.8\n m = mix weight:s");
    silent("f = fresnel_reflection\n s = multiply a:f b:$p\n m = mix weight:s");
    // The cosine of the view, wherever no scope bends the normal.
    silent("here = state\n s = negate input:here.dot_nd\n m = mix weight:s");
    silent(
        "here = state\n u = split_vector vector:here.normal\n h = scale input:u.y factor:0.5\n \
            s = add a:h b:0.5\n m = mix weight:s",
    );
    // Rounding is no mistake.
    silent("a = scale input:$p factor:0.1\n s = divide a:a b:0.1\n m = mix weight:s");
}

#[test]
fn what_nothing_is_known_of_is_not_told_of() {
    silent("s = add a:$free b:1\n m = mix weight:s");
    silent("s = scale input:$free factor:100\n m = mix weight:s");
    silent("here = state\n s = add a:here.u b:here.v\n m = mix weight:s");
    silent("here = state\n c = split_vector vector:here.point\n m = mix weight:c.x");
    silent("t = trace_reflection\n c = split_color color:t\n m = mix weight:c.r");
    silent("here = state\n d = divide a:1 b:here.dist");
    silent("d = subtract a:$free b:1\n s = divide a:1 b:d");
}

#[test]
fn hazards_are_seen_through_arithmetic() {
    told("d = subtract a:$p b:$q\n s = divide a:1 b:d", "numeric-hazard s.b");
    told("d = subtract a:2 b:2\n s = modulo a:1 b:d", "numeric-hazard s.b");
    told("d = subtract a:$p b:0.5\n s = power base:d exponent:0.5", "numeric-hazard s.base");
    told("d = negate input:$count\n s = divide a:1 b:d", "numeric-hazard s.b");
    told("here = state\n s = divide a:1 b:here.ior", "numeric-hazard s.b");
    told("t = trace_probe\n s = divide a:1 b:t.distance", "numeric-hazard s.b");
    silent("d = add a:$p b:0.5\n s = divide a:1 b:d");
    silent("d = maximum a:$p b:0.001\n s = divide a:1 b:d");
    silent("d = mix weight:$p a:1 b:$angle\n e = add a:d b:1\n s = divide a:1 b:e");
    silent("d = multiply a:$p b:$p\n e = add a:d b:1\n s = power base:e exponent:0.5");
    // -1 or 1, never 0.
    silent("d = select condition:$flag if_true:1 if_false:-1\n s = divide a:1 b:d");
    silent("f = floor input:$angle\n d = add a:f b:-0.5\n s = divide a:1 b:d");
    // Only the range of a root says so; the value does not.
    silent("d = square_root input:2\n s = divide a:1 b:d");
}

#[test]
fn what_is_evaluated_under_a_condition_is_not_told_of() {
    silent(
        "d = subtract a:$p b:$q\n there = less a:0 b:d\n inverse = divide a:1 b:d\n \
         s = select condition:there if_true:inverse if_false:0",
    );
    silent(
        "there = less a:0 b:$p\n inverse = divide a:1 b:$p\n \
         s = select condition:there if_true:inverse if_false:0",
    );
    // Two conditions further up.
    silent(
        "d = subtract a:$p b:$q\n there = less a:0 b:d\n inverse = divide a:1 b:d\n \
         grey = one_minus input:inverse\n inner = select condition:$flag if_true:grey if_false:1\n \
         s = select condition:there if_true:inner if_false:0",
    );
    // A condition that has nothing to do with it does not help.
    told(
        "d = subtract a:$p b:$q\n inverse = divide a:1 b:d\n \
         s = select condition:$flag if_true:inverse if_false:0",
        "numeric-hazard inverse.b",
    );
    // Nor does one that is passed by.
    told(
        "d = subtract a:$p b:$q\n there = less a:0 b:d\n inverse = divide a:1 b:d\n \
         t = select condition:there if_true:inverse if_false:0\n s = add a:t b:inverse",
        "numeric-hazard inverse.b",
    );
}

#[test]
fn dead_branches_are_seen_through_arithmetic() {
    let mirror = "t = trace_reflection\n";
    let dead = |nodes: &str, expected: &str| told(&format!("{mirror}{nodes}"), expected);
    dead("z = subtract a:1 b:1\n s = mix weight:z b:t", "dead-input s.b");
    dead("z = subtract a:$free b:$free\n s = mix weight:1 a:t", "dead-input s.a");
    dead("z = less a:$p b:0\n s = select condition:z if_true:t if_false:0", "dead-input s.if_true");
    dead(
        "o = less_equal a:$p b:1\n s = select condition:o if_true:1 if_false:t",
        "dead-input s.if_false",
    );
    dead(
        "z = constant_boolean value:false\n a = and a:z b:$flag\n s = fallback ok:a primary:t",
        "dead-input s.primary",
    );
    dead(
        "z = add a:$p b:2\n e = equal a:z b:1\n s = select condition:e if_true:t if_false:0",
        "dead-input s.if_true",
    );
    dead(
        "z = multiply a:$angle b:$angle\n e = less a:z b:0\n s = select condition:e if_true:t if_false:0",
        "dead-input s.if_true",
    );
    let alive = |nodes: &str| silent(&format!("{mirror}{nodes}"));
    alive("z = less a:$p b:0.5\n s = select condition:z if_true:t if_false:0");
    alive("s = mix weight:$p b:t");
    alive("z = less a:$free b:0\n s = select condition:z if_true:t if_false:0");
    // Any finite number less itself is 0, but here it may be NaN.
    alive(
        "here = state\n z = subtract a:here.u b:here.u\n e = equal a:z b:0\n s = select condition:e if_true:1 if_false:t",
    );
}

#[test]
fn broken_graphs_are_gone_through_as_far_as_they_are_known() {
    assert_eq!(findings("x = add a:x b:1\n y = add a:x b:$p\n m = mix weight:y"), ["cycle x.a"],);
    assert_eq!(
        findings("x = nothing_known\n y = add a:x b:1\n s = add a:$p b:1\n m = mix weight:s a:y"),
        ["unknown-node-type x.type", "range-past-input m.weight"],
    );
    assert_eq!(findings("y = add a:true b:1\n m = mix weight:y"), ["type-mismatch y.a"],);
}
