//! Expressions: what they compute, against a direct evaluation in 32 bits, and what they become.

use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::check::{FUNCTIONS, check_graph, read_graph_file};
use phenomenon_compiler::document::read;
use phenomenon_compiler::effects::Effect;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::{Binding, Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::show::draw_svg;
use phenomenon_compiler::state::State;
use phenomenon_compiler::testing::build::every_engine;
use phenomenon_compiler::testing::mock::MockRenderer;
use phenomenon_compiler::testing::random::{Random, canonical};

fn graph(text: &str) -> Graph {
    let document = read("expressions.json", text.as_bytes()).expect("it is JSON");
    let checked = check_graph(&document, &NodeLibrary::standard());
    let told: Vec<String> = checked.findings.iter().map(ToString::to_string).collect();
    checked.graph.unwrap_or_else(|| panic!("{text}\n{}", told.join("\n")))
}

fn shaded(graph: &Arc<Graph>, options: Options, renderer: &mut MockRenderer) -> [f32; 4] {
    let shader = Shader::new(Arc::clone(graph), &[], options).expect("it compiles");
    let mut results = [Shaded { color: [f32::NAN; 4], ok: false }];
    shader.shade(RootKind::Material, &[State::default()], renderer, &mut results);
    results[0].color
}

/// A value computed without the compiler.
#[derive(Clone, Copy, Debug)]
enum Value {
    Scalar(f32),
    Vector([f32; 3]),
    Color([f32; 4]),
    Boolean(bool),
}

use Value::{Boolean, Color, Scalar, Vector};

/// Components in pairs, as operators have them: a scalar is repeated, and the alpha of the left stays.
fn zip(a: Value, b: Value, of: impl Fn(f32, f32) -> f32) -> Value {
    let rgb = |c: [f32; 4]| [c[0], c[1], c[2]];
    let each = |a: [f32; 3], b: [f32; 3]| [0, 1, 2].map(|at| of(a[at], b[at]));
    let with_alpha = |c: [f32; 3], alpha: f32| Color([c[0], c[1], c[2], alpha]);
    match (a, b) {
        (Scalar(a), Scalar(b)) => Scalar(of(a, b)),
        (Vector(a), Vector(b)) => Vector(each(a, b)),
        (Vector(a), Scalar(b)) => Vector(each(a, [b; 3])),
        (Scalar(a), Vector(b)) => Vector(each([a; 3], b)),
        (Color(a), Color(b)) => with_alpha(each(rgb(a), rgb(b)), a[3]),
        (Color(a), Scalar(b)) => with_alpha(each(rgb(a), [b; 3]), a[3]),
        (Scalar(a), Color(b)) => with_alpha(each([a; 3], rgb(b)), 1.0),
        _ => unreachable!("the generator joins what can be joined"),
    }
}

fn number(value: Value) -> f32 {
    match value {
        Scalar(x) => x,
        _ => unreachable!("a scalar was asked for"),
    }
}

fn truth(value: Value) -> bool {
    match value {
        Boolean(x) => x,
        _ => unreachable!("a boolean was asked for"),
    }
}

/// What kind of value is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Scalar,
    Vector,
    Color,
    Boolean,
}

/// The interface and the nodes that expressions speak of, and their values.
const NAMES: [(&str, Kind, Value); 14] = [
    ("a", Kind::Scalar, Scalar(0.75)),
    ("b", Kind::Scalar, Scalar(-1.25)),
    ("zero", Kind::Scalar, Scalar(0.0)),
    ("count", Kind::Scalar, Scalar(3.0)),
    ("look.weights[1]", Kind::Scalar, Scalar(0.125)),
    ("apart.y", Kind::Scalar, Scalar(-0.5)),
    ("v", Kind::Vector, Vector([1.5, -0.5, 0.25])),
    ("place", Kind::Vector, Vector([0.5, 2.0, -3.0])),
    ("doubled", Kind::Vector, Vector([3.0, -1.0, 0.5])),
    ("c", Kind::Color, Color([0.25, 0.5, 1.0, 0.5])),
    ("look.tint", Kind::Color, Color([0.75, 0.0, 2.0, 1.0])),
    ("paint.value", Kind::Color, Color([0.5, 0.25, 0.125, 0.75])),
    ("on", Kind::Boolean, Boolean(true)),
    ("off", Kind::Boolean, Boolean(false)),
];

const GRAPH: &str = r#"{
    "phenomenon": "random",
    "interface": {
        "a": { "type": "scalar", "default": 0.75 }, "b": { "type": "scalar", "default": -1.25 },
        "zero": { "type": "scalar", "default": 0 }, "count": { "type": "integer", "default": 3 },
        "v": { "type": "vector", "default": [1.5, -0.5, 0.25] },
        "c": { "type": "color", "default": [0.25, 0.5, 1.0, 0.5] },
        "look": { "type": "struct", "members": {
            "tint": { "type": "color", "default": [0.75, 0, 2] },
            "weights": { "type": "array", "of": { "type": "scalar" }, "default": [1, 0.125] } } },
        "on": { "type": "boolean", "default": true }, "off": { "type": "boolean", "default": false }
    },
    "nodes": {
        "place": { "type": "constant_vector", "inputs": { "value": [0.5, 2, -3] } },
        "paint": { "type": "constant_color", "inputs": { "value": [0.5, 0.25, 0.125, 0.75] } },
        "doubled": { "type": "add", "inputs": { "a": { "interface": "v" }, "b": { "expression": "v" } } },
        "apart": { "type": "split_vector", "inputs": { "vector": { "interface": "v" } } }
    },
    "roots": { "material": ROOT } }"#;

/// Makes expressions and evaluates them at once.
struct Maker {
    random: Random,
    /// What is bound under `where`, as JSON, and its names with their values.
    bound: Vec<String>,
    names: Vec<(String, Kind, Value)>,
}

impl Maker {
    fn new(seed: u64) -> Self {
        Self { random: Random::new(seed), bound: Vec::new(), names: Vec::new() }
    }

    fn leaf(&mut self, kind: Kind) -> (String, Value) {
        if kind == Kind::Scalar && self.random.chance(30) {
            let (text, value) = self.random.pick(&[
                ("2", 2.0),
                (".5", 0.5),
                ("1e-1", 0.1),
                ("0", 0.0),
                ("-1.5", -1.5),
            ]);
            return (text.into(), Scalar(value));
        }
        let own = NAMES.iter().map(|(name, kind, value)| ((*name).to_owned(), *kind, *value));
        let all: Vec<_> = own.chain(self.names.clone()).filter(|it| it.1 == kind).collect();
        let (name, _, value) = all[self.random.below(all.len())].clone();
        (name, value)
    }

    /// An expression of a kind, in brackets wherever it is not one word, with its value.
    fn value(&mut self, kind: Kind, depth: usize) -> (String, Value) {
        if depth == 0 || self.random.chance(15) {
            return self.leaf(kind);
        }
        let (text, value) = match kind {
            Kind::Boolean => self.boolean(depth - 1),
            Kind::Scalar if self.random.chance(25) => self.component(depth - 1),
            _ if self.random.chance(15) => self.choice(kind, depth - 1),
            _ if self.random.chance(15) => self.made(kind, depth - 1),
            _ => self.computed(kind, depth - 1),
        };
        let text = format!("({text})");
        if self.random.chance(12) {
            let name = format!("w{}", self.names.len());
            self.bound.push(format!("\"{name}\": {{ \"expression\": \"{text}\" }}"));
            self.names.push((name.clone(), kind, value));
            return (name, value);
        }
        (text, value)
    }

    fn boolean(&mut self, depth: usize) -> (String, Value) {
        if self.random.chance(40) {
            let (one, a) = self.value(Kind::Boolean, depth);
            let (other, b) = self.value(Kind::Boolean, depth);
            let (a, b) = (truth(a), truth(b));
            return match self.random.below(3) {
                0 => (format!("{one} && {other}"), Boolean(a && b)),
                1 => (format!("{one} or {other}"), Boolean(a || b)),
                _ => (format!("!{one}"), Boolean(!a)),
            };
        }
        let (one, a) = self.value(Kind::Scalar, depth);
        let (other, b) = self.value(Kind::Scalar, depth);
        let (a, b) = (number(a), number(b));
        #[expect(clippy::float_cmp, reason = "this is what the operators mean")]
        let (sign, holds) = match self.random.below(6) {
            0 => ("<", a < b),
            1 => ("<=", a <= b),
            2 => (">", a > b),
            3 => (">=", a >= b),
            4 => ("==", a == b),
            _ => ("!=", a != b),
        };
        (format!("{one} {sign} {other}"), Boolean(holds))
    }

    fn component(&mut self, depth: usize) -> (String, Value) {
        if self.random.chance(50) {
            let (text, value) = self.value(Kind::Vector, depth);
            let Vector(v) = value else { unreachable!("a vector") };
            let at = self.random.below(3);
            return (format!("{text}.{}", ["x", "y", "z"][at]), Scalar(v[at]));
        }
        let (text, value) = self.value(Kind::Color, depth);
        let Color(c) = value else { unreachable!("a color") };
        let at = self.random.below(4);
        (format!("{text}.{}", ["r", "g", "b", "a"][at]), Scalar(c[at]))
    }

    fn choice(&mut self, kind: Kind, depth: usize) -> (String, Value) {
        let (condition, holds) = self.value(Kind::Boolean, depth);
        let (one, a) = self.value(kind, depth);
        let (other, b) = self.value(kind, depth);
        (format!("{condition} ? {one} : {other}"), if truth(holds) { a } else { b })
    }

    /// What constructors and swizzles make.
    fn made(&mut self, kind: Kind, depth: usize) -> (String, Value) {
        let mut parts = || -> [(String, f32); 3] {
            [0; 3].map(|_| self.value(Kind::Scalar, depth)).map(|(text, it)| (text, number(it)))
        };
        match kind {
            Kind::Vector => {
                let [(x, a), (y, b), (z, c)] = parts();
                if self.random.chance(50) {
                    return (format!("vector({x}, {y}, {z})"), Vector([a, b, c]));
                }
                (format!("vector({x}, {y}, {z}).zzx"), Vector([c, c, a]))
            }
            Kind::Color => {
                let [(x, a), (y, b), (z, c)] = parts();
                if self.random.chance(50) {
                    return (format!("color({x}, {y}, {z}, .5)"), Color([a, b, c, 0.5]));
                }
                (format!("vector({x}, {y}, {z}).bgr"), Color([c, b, a, 1.0]))
            }
            _ => {
                let [(x, a), (y, b), (z, c)] = parts();
                let clamped = if a < b { b } else { a };
                let clamped = if c < clamped { c } else { clamped };
                (format!("min(max({x}, {y}), {z})"), Scalar(clamped))
            }
        }
    }

    fn computed(&mut self, kind: Kind, depth: usize) -> (String, Value) {
        let (one, a) = self.value(kind, depth);
        // Scalars may stand on either side.
        let mixes = kind != Kind::Scalar && self.random.chance(40);
        let (other, b) = self.value(if mixes { Kind::Scalar } else { kind }, depth);
        let ((one, a), (other, b)) = match mixes && self.random.chance(50) {
            true => ((other, b), (one, a)),
            false => ((one, a), (other, b)),
        };
        let minimum = |a: f32, b: f32| if a < b { a } else { b };
        let divided =
            |a: f32, b: f32| if b == 0.0 { 0.0 } else { (a / b).clamp(f32::MIN, f32::MAX) };
        match self.random.below(6) {
            0 => (format!("{one} + {other}"), zip(a, b, |a, b| a + b)),
            1 => (format!("{one} - {other}"), zip(a, b, |a, b| a - b)),
            2 => {
                let product = zip(a, b, |a, b| a * b);
                // A scalar scales a color, and leaves its alpha.
                let product = match (a, b, product) {
                    (Scalar(_), Color(b), Color([x, y, z, _])) => Color([x, y, z, b[3]]),
                    _ => product,
                };
                (format!("{one} * {other}"), product)
            }
            3 => (format!("{one} / {other}"), zip(a, b, divided)),
            4 => (format!("min({one}, {other})"), zip(a, b, minimum)),
            _ => {
                let negative = |x: f32| -x;
                let (one, a) = self.value(kind, depth);
                let value = match a {
                    Scalar(x) => Scalar(-x),
                    Vector(v) => Vector(v.map(negative)),
                    Color([r, g, b, a]) => Color([-r, -g, -b, a]),
                    Boolean(_) => unreachable!("a number"),
                };
                (format!("-{one}"), value)
            }
        }
    }
}

#[test]
fn random_expressions_are_what_they_say_in_every_engine() {
    let mut operators = String::new();
    let engines = every_engine();
    for seed in 0..160 {
        let mut maker = Maker::new(seed);
        let kind = maker.random.pick(&[Kind::Scalar, Kind::Vector, Kind::Color, Kind::Boolean]);
        let (text, value) = maker.value(kind, 5);
        let (text, expected) = match value {
            Scalar(x) => (text, [x, x, x, 1.0]),
            Vector([x, y, z]) => (format!("({text}).rgb"), [x, y, z, 1.0]),
            Color(color) => (text, color),
            Boolean(holds) => {
                let x = f32::from(u8::from(holds));
                (format!("{text} ? 1 : 0"), [x, x, x, 1.0])
            }
        };
        let bound = maker.bound.join(", ");
        let root = format!("{{ \"expression\": \"{text}\", \"where\": {{ {bound} }} }}");
        let graph = Arc::new(graph(&GRAPH.replace("ROOT", &root)));
        // All engines for some of them: they agree by tests of their own.
        let options = [
            engines[seed as usize % engines.len()],
            Options { engine: Engine::Walk, ..Options::default() },
        ];
        for options in options {
            let found = shaded(&graph, options, &mut MockRenderer::default());
            let bits = |of: [f32; 4]| of.map(|x| canonical(x.to_bits()));
            assert_eq!(
                bits(found),
                bits(expected),
                "seed {seed}, {options:?}: {root}\n{found:?} {expected:?}"
            );
        }
        write!(operators, "{root}").unwrap();
    }
    for used in ["+", "-", "*", "/", "?", "&&", "or", "!", "<=", "!=", ".zzx", ".bgr", "w1", "min("]
    {
        assert!(operators.contains(used), "the generator makes no {used}");
    }
}

/// The nodes of a graph of one expression: name, type, and what each is given.
fn nodes(expression: &str) -> Vec<String> {
    let root = format!("{{ \"expression\": \"{expression}\" }}");
    let graph = graph(&GRAPH.replace("ROOT", &root));
    let told = |binding: &Binding| match binding {
        Binding::Default => "-".into(),
        Binding::Literal(literal) => literal.to_string(),
        Binding::Parameter(at) => graph.parameters[*at].name.clone(),
        Binding::Node { node, output } => format!("{}.{output}", graph.nodes[*node].name),
    };
    let written = graph.nodes.iter().filter(|node| node.name.contains('@'));
    let mut found: Vec<String> = written
        .map(|node| {
            let inputs: Vec<String> = node.inputs.iter().map(told).collect();
            let kind = &graph.library.signature(node.node_type).name;
            format!("{} {kind}({})", node.name, inputs.join(", "))
        })
        .collect();
    found.push(told(&graph.root(RootKind::Material).expect("it has one").color));
    found
}

#[test]
fn expressions_become_nodes_with_names_that_stay() {
    let root = "@roots.material";
    for (expression, expected) in [
        ("a", vec!["a".to_owned()]),
        ("0.5", vec!["[0.5, 0.5, 0.5, 1]".to_owned()]),
        ("c.rgba", vec!["c".into()]),
        ("look.tint", vec!["look.tint".into()]),
        ("a + 1", vec![format!("{root} add(a, 1)"), format!("{root}.0")]),
        (
            "2 * c * a",
            vec![
                format!("{root}#1 scale(c, 2)"),
                format!("{root} scale({root}#1.0, a)"),
                format!("{root}.0"),
            ],
        ),
        (
            "on && a >= 2 ? smoothstep(0, 1, a) : v.x * v.x",
            vec![
                format!("{root}#1 less_equal(2, a)"),
                format!("{root}#2 and(on, {root}#1.0)"),
                format!("{root}#3 smooth_step(a, 0, 1)"),
                format!("{root}#4 split_vector(v)"),
                format!("{root}#5 multiply({root}#4.0, {root}#4.0)"),
                format!("{root} select({root}#2.0, {root}#3.0, {root}#5.0)"),
                format!("{root}.0"),
            ],
        ),
        (
            "mix(weight: a, a: 0, b: c)",
            vec![format!("{root} mix(a, [0, 0, 0, 1], c)"), format!("{root}.0")],
        ),
        (
            "max(a, b, 0)",
            vec![
                format!("{root}#1 maximum(a, b)"),
                format!("{root} maximum({root}#1.0, 0)"),
                format!("{root}.0"),
            ],
        ),
        (
            "(v + a).rgb",
            vec![
                format!("{root}#1 combine_vector(a, a, a)"),
                format!("{root}#2 add(v, {root}#1.0)"),
                format!("{root}#3 split_vector({root}#2.0)"),
                format!("{root} combine_color({root}#3.0, {root}#3.1, {root}#3.2, -)"),
                format!("{root}.0"),
            ],
        ),
        (
            "luminance(trace_reflection())",
            vec![
                format!("{root}#1 trace_reflection(-)"),
                format!("{root} luminance({root}#1.0)"),
                format!("{root}.0"),
            ],
        ),
    ] {
        assert_eq!(nodes(expression), expected, "{expression}");
    }
}

#[test]
fn a_choice_asks_for_what_it_chooses() {
    let text = |weight: &str| {
        format!(
            r#"{{ "phenomenon": "lazy", "nodes": {{ "s": {{ "type": "state" }} }}, "roots": {{ "material": {{
                "expression": "s.u {weight} ? trace_reflection() : color(1, 0, 0)" }} }} }}"#
        )
    };
    for (weight, rays) in [("> 0.5", 0), ("< 0.5", 1)] {
        let graph = Arc::new(graph(&text(weight)));
        for options in every_engine() {
            let mut renderer = MockRenderer::default();
            shaded(&graph, options, &mut renderer);
            assert_eq!(renderer.count(Effect::TraceReflection), rays, "{weight} in {options:?}");
        }
    }
}

/// The rows of the table of functions.
fn functions() -> String {
    let library = NodeLibrary::standard();
    let mut table = String::from("\n| function | node | what it is |\n| --- | --- | --- |\n");
    for function in FUNCTIONS {
        let node = library.signature(library.find(function.node).expect("it is in the library"));
        let doc = node.doc.replace('|', "\\|").replace('\n', " ");
        // The first sentence, or what stands before the formula.
        let ends = doc.match_indices(['.', ':', ';']).find(|(at, sign)| {
            let next = doc[at + 1..].strip_prefix(' ');
            next.is_some_and(|next| *sign != "." || next.starts_with(char::is_uppercase))
        });
        let doc = doc[..ends.map_or(doc.len(), |(at, _)| at)].trim_end_matches('.');
        let order = function.order.join(", ");
        let more = if function.folds { ", …" } else { "" };
        let (name, node) = (function.name, function.node);
        writeln!(table, "| `{name}({order}{more})` | `{node}` | {doc} |").unwrap();
    }
    table + "\n"
}

/// `PHENOMENON_BLESS=1 cargo test --workspace --test expressions` writes the table anew.
#[test]
fn the_page_of_expressions_is_in_sync_and_its_examples_run() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/expressions.md");
    let page = std::fs::read_to_string(&path).expect("the page is there");
    let (before, rest) = page.split_once("<!-- functions -->\n").expect("it has the table");
    let (_, after) = rest.split_once("<!-- end -->").expect("the table ends");
    let due = format!("{before}<!-- functions -->\n{}<!-- end -->{after}", functions());
    if std::env::var_os("PHENOMENON_BLESS").is_some() {
        std::fs::write(&path, &due).expect("it can be written");
    } else {
        assert!(page == due, "docs/expressions.md differs; write it anew as this test says");
    }
    let blocks = page.split("```json\n").skip(1).map(|rest| rest.split("```").next().unwrap_or(""));
    let mut examples = 0;
    for example in blocks {
        let graph = Arc::new(graph(example));
        let options = Options { engine: Engine::Walk, ..Options::default() };
        let color = shaded(&graph, options, &mut MockRenderer::default());
        assert!(color.iter().all(|x| x.is_finite()), "{example}");
        examples += 1;
    }
    assert!(examples > 0);
}

#[test]
fn a_drawing_has_one_box_for_an_expression_or_its_nodes() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs/expressions/agate.json");
    let mut graph = read_graph_file(&path, &NodeLibrary::standard()).graph.expect("it is right");
    let closed = draw_svg(&graph).expect("it is drawn");
    assert!(closed.contains("(state.point - vector(0.3, 0.8, 0.4))") && !closed.contains('@'));
    let boxes = |svg: &str| svg.matches("expression").count();
    graph.expressions.clear();
    let open = draw_svg(&graph).expect("it is drawn");
    assert!(open.contains("stone@color#1") && boxes(&open) == 0);
    assert!(open.len() > closed.len());
}

#[test]
fn phenomena_within_a_file_and_outputs_have_expressions_too() {
    let text = r##"{
        "phenomenon": "outer",
        "phenomena": { "line": {
            "interface": { "x": { "type": "scalar", "default": 1 }, "tint": { "type": "color", "default": { "srgb": "#fff" } } },
            "nodes": { "twice": { "type": "multiply", "inputs": { "a": { "expression": "x + 1" }, "b": 2 } } },
            "outputs": {
                "y": { "type": "scalar", "from": { "expression": "twice - tint.g * half", "where": { "half": 0.5 } } },
                "c": { "type": "color", "from": { "expression": "tint * up", "where": { "up": { "interface": "tint.r" } } } }
            } } },
        "nodes": { "one": { "type": { "phenomenon": "line" }, "inputs": { "x": { "expression": "0.25 + 0.5" } } } },
        "roots": { "material": { "expression": "one.y + one.c.r" } } }"##;
    let graph = Arc::new(graph(text));
    assert_eq!(graph.expressions.len(), 5);
    assert!(graph.nodes.iter().any(|node| node.name == "one/twice@a"), "{:?}", graph.nodes);
    for options in every_engine() {
        let color = shaded(&graph, options, &mut MockRenderer::default());
        assert_eq!(color.map(f32::to_bits), [4.0, 4.0, 4.0, 1.0].map(f32::to_bits), "{options:?}");
    }
}
