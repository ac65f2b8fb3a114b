//! What expressions become: nodes with names that stay, boxes of drawings, rows of the page.

use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::check::{FUNCTIONS, read_graph_file};
use phenomenon_compiler::effects::Effect;
use phenomenon_compiler::engine::{Engine, Options};
use phenomenon_compiler::graph::{Binding, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::show::draw_svg;
use phenomenon_compiler::testing::build::every_engine;
use phenomenon_compiler::testing::mock::MockRenderer;

use crate::build::{GRAPH, graph, shaded};

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
    // Each box opens a panel of its own, by links alone.
    let panels = closed.matches("class=\"panel\" display=\"none\"").count();
    assert_eq!(panels, closed.matches("<a href=\"#expression-").count());
    assert!(panels > 3 && closed.contains(">smooth_step<") && !closed.contains("<script"));
    for at in closed.split("<a href=\"#expression-").skip(1) {
        let number = at.split('"').next().unwrap();
        assert_eq!(closed.matches(&format!("<g id=\"expression-{number}\"")).count(), 1);
    }
    assert!(!open.contains("<style") && !open.contains("<a "));
}
