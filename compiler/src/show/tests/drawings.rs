//! Drawings as a whole: nothing overlaps, wires end at sockets, documents are well formed.

use std::time::Instant;

use proptest::prelude::*;

use super::faults::faults;
use super::graphs::{chain, empty, from, node, random_graph, root, ruled_out, small};
use super::well_formed::parse;
use crate::graph::{Binding, Graph, Parameter, RootKind};
use crate::nodes::{NodeLibrary, NodeType};
use crate::show::diagram::{Dead, Diagram, Wire};
use crate::show::layout::{Layout, Place, layout};
use crate::show::{MAX_BOXES, ShowError, build, draw_dot, draw_svg, svg, theme};
use crate::values::Literal;

fn laid_out(graph: &Graph) -> (Diagram<'_>, Layout) {
    let diagram = build::diagram(graph, usize::MAX).expect("it is consistent");
    let layout = layout(&diagram).expect("it has no cycle");
    (diagram, layout)
}

#[test]
fn a_small_graph_shows_all_its_marks() {
    let graph = small();
    let (diagram, layout) = laid_out(&graph);
    assert_eq!(faults(&diagram, &layout), Vec::<String>::new());
    let svg = svg::write(&diagram, &layout, &[]);
    parse(&svg).expect("well formed");
    for text in [
        ">tint</text>",
        ">scope</text>",
        ">ray</text>",
        ">0.9, 0.7, 0.4</text>",
        ">reflection_direction</text>",
        "mirror.distance → shadow.color, scalar to color",
        "lost: add (dead: no root reaches it)",
        "unused: scalar (dead: no root reaches it)",
        "dead: never evaluated",
        "default that is evaluated, without a box",
        "direction = reflection_direction(direction = state.direction, normal = state.normal,",
        "evaluated only where needed",
        "evaluated in the scope of the node",
        "4 nodes · 2 parameters · 2 dead",
    ] {
        assert!(svg.contains(text), "{text} is missing in\n{svg}");
    }
    let dead: Vec<&str> =
        diagram.cards.iter().filter(|card| card.dead.is_some()).map(|card| card.title).collect();
    assert_eq!(dead, ["unused", "lost"]);
    // Only outputs in use have a socket.
    assert_eq!(
        diagram.cards[2].outputs.iter().map(|o| o.name).collect::<Vec<_>>(),
        ["color", "distance"]
    );
}

#[test]
fn dot_says_the_same_as_the_drawing() {
    let dot = draw_dot(&small()).expect("it is consistent");
    for line in [
        "digraph \"small\" {",
        "n0:o0:e -> n1:i3:w [color=\"#e0a800\", style=dashed];",
        "n0:o1:e -> r1:i0:w [color=\"#80868e\", label=\"scalar to color\"];",
        "p0:o0:e -> n2:i2:w [color=\"#e0a800\", arrowhead=empty];",
        "n0:o1:e -> n3:i0:w [color=\"#80868e\", style=dotted];",
        "{ rank=max; r0; r1; }",
    ] {
        assert!(dot.contains(line), "{line} is missing in\n{dot}");
    }
}

#[test]
fn what_constants_rule_out_is_marked_as_the_checker_says() {
    let graph = ruled_out();
    let (diagram, layout) = laid_out(&graph);
    // A parameter that is 0 by default may be bound to another value: it rules nothing out.
    let dead: Vec<_> =
        diagram.cards.iter().filter_map(|card| card.dead.map(|dead| (card.title, dead))).collect();
    assert_eq!(dead, [("tint", Dead::RuledOut), ("mirror", Dead::RuledOut)]);
    let ruled_out = |wires: &[Wire]| -> Vec<(usize, usize)> {
        wires.iter().filter(|wire| wire.ruled_out).map(|wire| wire.to).collect()
    };
    let parameters = diagram.parameters;
    assert_eq!(ruled_out(&diagram.wires), [(parameters + 1, 3), (parameters + 3, 2)]);
    // Only the lambert that asks its light is marked as one that does.
    let badges: Vec<_> = diagram
        .cards
        .iter()
        .filter_map(|card| card.badge.as_ref().map(|it| (card.title, it.text, it.by_default)))
        .collect();
    assert_eq!(badges, [("mirror", "ray", false), ("facing", "light", true)]);
    let svg = svg::write(&diagram, &layout, &[]);
    parse(&svg).expect("well formed");
    for text in [
        "mirror.color → constant.b: never evaluated, a constant rules it out",
        "mirror: trace_reflection (dead: constants rule out all that reads it)",
        "ruled out by a constant",
        "light = light_color (never evaluated)",
        "line-through\" xml:space=\"preserve\">light_color</text>",
        "5 nodes · 2 parameters · 2 dead",
    ] {
        assert!(svg.contains(text), "{text} is missing in\n{svg}");
    }
    let dot = draw_dot(&graph).expect("it is consistent");
    for text in
        ["n0:o0:e -> n3:i2:w [color=\"#e0a800\", style=dotted, arrowhead=tee];", "lambert [light]"]
    {
        assert!(dot.contains(text), "{text} is missing in\n{dot}");
    }
}

#[test]
fn hostile_names_stay_text() {
    let names = [
        "<&\"'>]]>",
        "</text><script>alert(1)</script>",
        "\u{0}\u{1b}\u{fffe}\u{202e}\t\n\r",
        "\\\"; } digraph x {",
        &"very_long_name_".repeat(10_000),
        "語語語🙂é",
        "",
    ];
    let mut graph = empty(names[0]);
    for name in names {
        graph.parameters.push(Parameter::new(name, Literal::Lights(vec![name.into(); 3])));
        graph.nodes.push(node(&NodeLibrary::standard(), "trace_reflection", name, &[]));
    }
    graph.name = names.concat();
    graph.roots = vec![root(RootKind::Material, from(0, 0))];
    let svg = draw_svg(&graph).expect("it is consistent");
    parse(&svg).expect("well formed");
    assert!(!svg.contains("<script"));
    let (diagram, layout) = laid_out(&graph);
    assert_eq!(faults(&diagram, &layout), Vec::<String>::new());
    assert!(layout.frames.iter().all(|frame| frame.width <= 400.0), "boxes stay boxes");
    let dot = draw_dot(&graph).expect("it is consistent");
    assert_eq!(
        dot.matches("digraph x").count(),
        dot.matches("\\\"; } digraph x").count() + dot.matches("&quot;; } digraph x").count()
    );
}

#[test]
fn text_ends_before_the_side_of_its_box() {
    let mut graph = empty("wide");
    graph.nodes.push(node(&NodeLibrary::standard(), "trace_reflection", &"W".repeat(80), &[]));
    graph.roots = vec![root(RootKind::Material, from(0, 0))];
    let (diagram, layout) = laid_out(&graph);
    let svg = svg::write(&diagram, &layout, &[]);
    let title = theme::TITLE;
    let shown = svg.split("font-weight=\"700\"").filter_map(|text| {
        text.split_once("preserve\">").and_then(|(_, text)| text.split_once("</text>"))
    });
    let cut = shown.map(|(text, _)| text).find(|text| text.starts_with('W')).expect("the title");
    assert!(cut.ends_with('…') && title.width(cut) <= layout.frames[0].width - 20.0, "{cut}");
    assert!(svg.contains(&format!("<title>{}", "W".repeat(80))), "the whole name is in the tip");
}

#[test]
fn an_empty_graph_is_a_drawing_too() {
    parse(&draw_svg(&empty("")).expect("nothing to go wrong")).expect("well formed");
    let mut graph = empty("constant");
    graph.roots = vec![root(RootKind::Material, Binding::Literal(Literal::Color([f32::NAN; 4])))];
    parse(&draw_svg(&graph).expect("nothing to go wrong")).expect("well formed");
}

#[test]
fn long_chains_are_drawn_quickly_and_without_recursion() {
    let graph = chain(3_000);
    let start = Instant::now();
    let (diagram, layout) = laid_out(&graph);
    parse(&svg::write(&diagram, &layout, &[])).expect("well formed");
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
    let level = |track: &[Place]| track.iter().all(|at| (at.y - track[0].y).abs() < 0.05);
    let of_nodes = diagram.wires.iter().zip(&layout.tracks).filter(|(wire, _)| wire.from.0 > 0);
    let steps = of_nodes.filter(|(_, track)| !level(track)).count();
    assert!(steps <= 3, "a chain is a line, but for {steps} steps");
    let graph = chain(50_000);
    assert_eq!(draw_svg(&graph), Err(ShowError::TooManyBoxes { boxes: 50_002, limit: MAX_BOXES }));
    assert!(draw_dot(&graph).is_ok());
}

#[test]
fn a_graph_that_was_not_checked_is_refused() {
    let refused = |change: fn(&mut Graph), problem: &str| {
        let mut graph = small();
        change(&mut graph);
        for error in [draw_svg(&graph).err(), draw_dot(&graph).err()] {
            // DOT needs no order, so that it can show a cycle.
            let text = error.map(|error| error.to_string());
            assert!(text.is_none_or(|text| text.contains(problem)), "{problem}");
        }
        assert!(draw_svg(&graph).is_err(), "{problem}");
    };
    refused(|graph| graph.nodes[0].node_type = NodeType(usize::MAX), "type is unknown");
    refused(|graph| graph.nodes[0].inputs.clear(), "inputs are not those");
    refused(|graph| graph.nodes[0].overload = 9, "inputs are not those");
    refused(
        |graph| graph.nodes[3].inputs[0] = Binding::Parameter(9),
        "parameter that does not exist",
    );
    refused(
        |graph| graph.roots[0].color = Binding::Node { node: 0, output: 9 },
        "output that does not",
    );
    refused(
        |graph| graph.roots[0].ok = Binding::Node { node: 9, output: 0 },
        "output that does not",
    );
    refused(
        |graph| graph.nodes[0].inputs[0] = Binding::Node { node: 2, output: 0 },
        "form a cycle",
    );
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn nothing_overlaps_and_every_wire_ends_at_its_sockets(graph in random_graph()) {
        let (diagram, layout) = laid_out(&graph);
        prop_assert_eq!(faults(&diagram, &layout), Vec::<String>::new());
        let svg = svg::write(&diagram, &layout, &[]);
        prop_assert!(parse(&svg).is_ok());
        prop_assert_eq!(svg, draw_svg(&graph).unwrap(), "the same bytes each time");
    }
}
