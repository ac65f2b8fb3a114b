//! Drawings as a whole: nothing overlaps, wires end at sockets, documents are well formed.

use std::collections::HashSet;
use std::time::Instant;

use proptest::prelude::*;

use super::diagram::{Dead, Diagram, Wire};
use super::layout::{Layout, Place, layout};
use super::{MAX_BOXES, ShowError, draw_dot, draw_svg};
use crate::graph::{Binding, Graph, Node, Parameter, Root, RootKind};
use crate::nodes::NodeLibrary;
use crate::values::Literal;

fn empty(name: &str) -> Graph {
    Graph { name: name.into(), version: 1, ..Graph::default() }
}

fn node(library: &NodeLibrary, node_type: &str, name: &str, given: &[(&str, Binding)]) -> Node {
    let node_type = library.find(node_type).expect("a node of the library");
    let signature = library.signature(node_type);
    let mut inputs = vec![Binding::Default; signature.inputs.len()];
    for (input, binding) in given {
        inputs[signature.input(input).expect("an input of the node")] = binding.clone();
    }
    Node { name: name.into(), node_type, overload: 0, inputs }
}

fn from(node: usize, output: usize) -> Binding {
    Binding::Node { node, output }
}

fn root(kind: RootKind, color: Binding) -> Root {
    Root { kind, color, ok: Binding::Default }
}

/// A mirror in a scope, mixed with a parameter, and a node nothing reaches.
fn small(library: &NodeLibrary) -> Graph {
    let mut graph = empty("small");
    graph.parameters = vec![
        Parameter::new("tint", Literal::Color([0.9, 0.7, 0.4, 1.0])),
        Parameter::new("unused", Literal::Scalar(1.0)),
    ];
    graph.nodes = vec![
        node(library, "trace_reflection", "mirror", &[]),
        node(library, "perturb_normal", "bumped", &[("input", from(0, 0))]),
        node(
            library,
            "mix",
            "shade",
            &[("weight", from(0, 3)), ("a", from(1, 0)), ("b", Binding::Parameter(0))],
        ),
        node(library, "add", "lost", &[("a", from(0, 3))]),
    ];
    graph.nodes[2].overload = color_overload(library, "mix");
    graph.roots = vec![root(RootKind::Material, from(2, 0)), root(RootKind::Shadow, from(0, 3))];
    graph
}

fn color_overload(library: &NodeLibrary, name: &str) -> usize {
    let definition = library.definition(library.find(name).expect("a node of the library"));
    let color = Some(crate::values::Type::Color);
    definition
        .overloads
        .iter()
        .position(|overload| overload.generic == color)
        .expect("a colour form")
}

fn chain(library: &NodeLibrary, length: usize) -> Graph {
    let mut graph = empty("chain");
    graph.parameters = vec![Parameter::new("step", Literal::Scalar(0.5))];
    for at in 0..length {
        let before = at.checked_sub(1).map_or(Binding::Default, |before| from(before, 0));
        let given = [("a", before), ("b", Binding::Parameter(0))];
        graph.nodes.push(node(library, "add", &format!("n{at}"), &given));
    }
    graph.roots = vec![root(RootKind::Material, from(length - 1, 0))];
    graph
}

fn laid_out<'a>(graph: &'a Graph, library: &'a NodeLibrary) -> (Diagram<'a>, Layout) {
    let diagram = super::build::diagram(graph, library, usize::MAX).expect("it is consistent");
    let layout = layout(&diagram).expect("it has no cycle");
    (diagram, layout)
}

/// Boxes that overlap, wires that do not end at their sockets or run to the left.
fn faults(diagram: &Diagram<'_>, layout: &Layout) -> Vec<String> {
    let mut faults = Vec::new();
    let boxes: Vec<(Place, f64, f64)> = layout
        .places
        .iter()
        .zip(&layout.frames)
        .map(|(place, frame)| (*place, frame.width, frame.height))
        .collect();
    for (at, (a, a_width, a_height)) in boxes.iter().enumerate() {
        let inside = a.x >= 0.0
            && a.y >= -1e-6
            && a.x + a_width <= layout.width + 1e-6
            && a.y + a_height <= layout.height + 1e-6;
        if !inside {
            faults.push(format!("box {at} leaves the page: {a:?}"));
        }
        for (other, (b, b_width, b_height)) in boxes.iter().enumerate().skip(at + 1) {
            let apart = a.x + a_width + 8.0 <= b.x
                || b.x + b_width + 8.0 <= a.x
                || a.y + a_height + 8.0 <= b.y
                || b.y + b_height + 8.0 <= a.y;
            if !apart {
                faults.push(format!("boxes {at} and {other} overlap"));
            }
        }
    }
    for (wire, track) in diagram.wires.iter().zip(&layout.tracks) {
        let (Some(start), Some(end)) = (track.first(), track.last()) else { continue };
        let (from, to) = (wire.from.0, wire.to.0);
        let output = layout.places[from].y + layout.frames[from].outputs[wire.from.1];
        let input = layout.places[to].y + layout.frames[to].inputs[wire.to.1];
        let at_output = start.x == layout.places[from].x + layout.frames[from].width;
        let at_input = end.x == layout.places[to].x;
        if !at_output || !at_input || start.y != output || end.y != input {
            faults.push(format!("{wire:?} misses a socket"));
        }
        if track.windows(2).any(|pair| pair[1].x < pair[0].x) || track.len() % 2 != 0 {
            faults.push(format!("{wire:?} runs to the left"));
        }
        // Curves as drawn: each a cubic whose middle points stand level with its ends, half way.
        let mut points: Vec<Place> = track.clone();
        for pair in track[1..track.len() - 1].chunks(2) {
            let &[from, to] = pair else { continue };
            for step in 1..64 {
                let t = f64::from(step) / 64.0;
                let (near, far) = ((1.0 - t).powi(3), t.powi(3));
                let (x, y) = (3.0 * t * (1.0 - t) * (from.x + to.x) / 2.0, t * t * (3.0 - 2.0 * t));
                points.push(Place {
                    x: near * from.x + x + far * to.x,
                    y: from.y + y * (to.y - from.y),
                });
            }
        }
        for pair in track[1..track.len() - 1].windows(2).skip(1).step_by(2) {
            points.extend((0..=64).map(|step| Place {
                x: pair[0].x + (pair[1].x - pair[0].x) * f64::from(step) / 64.0,
                y: pair[0].y,
            }));
        }
        let near = |point: &Place| {
            let at = |&(place, width, height): &(Place, f64, f64)| {
                place.x - 6.0 < point.x
                    && point.x < place.x + width + 6.0
                    && place.y - 6.0 < point.y
                    && point.y < place.y + height + 6.0
            };
            boxes.iter().enumerate().any(|(card, it)| card != from && card != to && at(it))
        };
        if points.iter().any(near) {
            faults.push(format!("{wire:?} runs behind a box, or too near one"));
        }
    }
    faults
}

/// The document as elements with attributes and text, or why it is none: enough of XML for what
/// the writer uses, and strict in it.
fn parse(svg: &str) -> Result<usize, String> {
    let mut open: Vec<&str> = Vec::new();
    let mut elements = 0;
    let mut rest = svg;
    while let Some(start) = rest.find('<') {
        require_text(&rest[..start])?;
        let end = rest[start..].find('>').ok_or("a tag does not end")? + start;
        let tag = &rest[start + 1..end];
        rest = &rest[end + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            if open.pop() != Some(name) {
                return Err(format!("</{name}> closes nothing"));
            }
            continue;
        }
        elements += 1;
        let body = tag.strip_suffix('/').unwrap_or(tag);
        let (name, mut attributes) = body.split_once(' ').unwrap_or((body, ""));
        let mut names = HashSet::new();
        while !attributes.trim_start().is_empty() {
            let (attribute, after) =
                attributes.split_once("=\"").ok_or_else(|| format!("no value in <{tag}>"))?;
            let (value, after) =
                after.split_once('"').ok_or_else(|| format!("open quote in <{tag}>"))?;
            require_text(value)?;
            let attribute = attribute.strip_prefix(' ').unwrap_or(attribute);
            if attribute.contains([' ', '"']) || !names.insert(attribute) {
                return Err(format!("attribute `{attribute}` in <{tag}>"));
            }
            attributes = after;
        }
        if !tag.ends_with('/') {
            open.push(name);
        }
    }
    require_text(rest)?;
    if open.is_empty() { Ok(elements) } else { Err(format!("{open:?} stay open")) }
}

fn require_text(text: &str) -> Result<(), String> {
    let allowed = |c: char| matches!(c, '\t' | '\n' | '\r' | ' '..='\u{d7ff}' | '\u{e000}'..='\u{fffd}' | '\u{10000}'..);
    if text.contains(['<', '>']) || !text.chars().all(allowed) {
        return Err(format!("a forbidden character in {text:?}"));
    }
    for after in text.split('&').skip(1) {
        let entity = after.split_once(';').map_or("", |(entity, _)| entity);
        if !["amp", "lt", "gt", "quot", "#39", "#9", "#10", "#13"].contains(&entity) {
            return Err(format!("a bare & in {text:?}"));
        }
    }
    Ok(())
}

#[test]
fn a_small_graph_shows_all_its_marks() {
    let library = NodeLibrary::standard();
    let graph = small(&library);
    let (diagram, layout) = laid_out(&graph, &library);
    assert_eq!(faults(&diagram, &layout), Vec::<String>::new());
    let svg = super::svg::write(&diagram, &layout);
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
    let library = NodeLibrary::standard();
    let dot = draw_dot(&small(&library), &library).expect("it is consistent");
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

/// A mix of weight 0 that never asks for its mirror; the other half is a lambert turned away from
/// its light, which asks neither the light nor its colour.
fn ruled_out(library: &NodeLibrary) -> Graph {
    let mut graph = empty("ruled_out");
    graph.parameters = vec![
        Parameter::new("tint", Literal::Color([0.9, 0.7, 0.4, 1.0])),
        Parameter::new("share", Literal::Scalar(0.0)),
    ];
    let away = [0.0, -0.0, -1.0];
    graph.nodes = vec![
        node(library, "trace_reflection", "mirror", &[]),
        node(
            library,
            "lambert",
            "turned_away",
            &[
                ("normal", Binding::Literal(Literal::Vector([0.0, 0.0, 1.0]))),
                ("direction", Binding::Literal(Literal::Vector(away))),
                ("color", Binding::Parameter(0)),
            ],
        ),
        node(library, "lambert", "facing", &[]),
        node(
            library,
            "mix",
            "constant",
            &[
                ("weight", Binding::Literal(Literal::Scalar(-0.0))),
                ("a", from(1, 0)),
                ("b", from(0, 0)),
            ],
        ),
        node(
            library,
            "mix",
            "live",
            &[("weight", Binding::Parameter(1)), ("a", from(3, 0)), ("b", from(2, 0))],
        ),
    ];
    for at in [3, 4] {
        graph.nodes[at].overload = color_overload(library, "mix");
    }
    graph.roots = vec![root(RootKind::Material, from(4, 0))];
    // What the checker would say of it.
    graph.ruled_out = vec![(1, 2), (1, 3), (3, 2)];
    graph
}

#[test]
fn what_constants_rule_out_is_marked_as_the_checker_says() {
    let library = NodeLibrary::standard();
    let graph = ruled_out(&library);
    let (diagram, layout) = laid_out(&graph, &library);
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
    let svg = super::svg::write(&diagram, &layout);
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
    let dot = draw_dot(&graph, &library).expect("it is consistent");
    for text in
        ["n0:o0:e -> n3:i2:w [color=\"#e0a800\", style=dotted, arrowhead=tee];", "lambert [light]"]
    {
        assert!(dot.contains(text), "{text} is missing in\n{dot}");
    }
}

#[test]
fn hostile_names_stay_text() {
    let library = NodeLibrary::standard();
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
        graph.nodes.push(node(&library, "trace_reflection", name, &[]));
    }
    graph.name = names.concat();
    graph.roots = vec![root(RootKind::Material, from(0, 0))];
    let svg = draw_svg(&graph, &library).expect("it is consistent");
    parse(&svg).expect("well formed");
    assert!(!svg.contains("<script"));
    let (diagram, layout) = laid_out(&graph, &library);
    assert_eq!(faults(&diagram, &layout), Vec::<String>::new());
    assert!(layout.frames.iter().all(|frame| frame.width <= 400.0), "boxes stay boxes");
    let dot = draw_dot(&graph, &library).expect("it is consistent");
    assert_eq!(
        dot.matches("digraph x").count(),
        dot.matches("\\\"; } digraph x").count() + dot.matches("&quot;; } digraph x").count()
    );
}

#[test]
fn text_ends_before_the_side_of_its_box() {
    let library = NodeLibrary::standard();
    let mut graph = empty("wide");
    graph.nodes.push(node(&library, "trace_reflection", &"W".repeat(80), &[]));
    graph.roots = vec![root(RootKind::Material, from(0, 0))];
    let (diagram, layout) = laid_out(&graph, &library);
    let svg = super::svg::write(&diagram, &layout);
    let title = super::theme::TITLE;
    let shown = svg.split("font-weight=\"700\"").filter_map(|text| {
        text.split_once("preserve\">").and_then(|(_, text)| text.split_once("</text>"))
    });
    let cut = shown.map(|(text, _)| text).find(|text| text.starts_with('W')).expect("the title");
    assert!(cut.ends_with('…') && title.width(cut) <= layout.frames[0].width - 20.0, "{cut}");
    assert!(svg.contains(&format!("<title>{}", "W".repeat(80))), "the whole name is in the tip");
}

#[test]
fn an_empty_graph_is_a_drawing_too() {
    let library = NodeLibrary::standard();
    parse(&draw_svg(&empty(""), &library).expect("nothing to go wrong")).expect("well formed");
    let mut graph = empty("constant");
    graph.roots = vec![root(RootKind::Material, Binding::Literal(Literal::Color([f32::NAN; 4])))];
    parse(&draw_svg(&graph, &library).expect("nothing to go wrong")).expect("well formed");
}

#[test]
fn long_chains_are_drawn_quickly_and_without_recursion() {
    let library = NodeLibrary::standard();
    let graph = chain(&library, 3_000);
    let start = Instant::now();
    let (diagram, layout) = laid_out(&graph, &library);
    parse(&super::svg::write(&diagram, &layout)).expect("well formed");
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
    let level = |track: &[Place]| track.iter().all(|at| (at.y - track[0].y).abs() < 0.05);
    let of_nodes = diagram.wires.iter().zip(&layout.tracks).filter(|(wire, _)| wire.from.0 > 0);
    let steps = of_nodes.filter(|(_, track)| !level(track)).count();
    assert!(steps <= 3, "a chain is a line, but for {steps} steps");
    let graph = chain(&library, 50_000);
    assert_eq!(
        draw_svg(&graph, &library),
        Err(ShowError::TooManyBoxes { boxes: 50_002, limit: MAX_BOXES })
    );
    assert!(draw_dot(&graph, &library).is_ok());
}

#[test]
fn a_graph_that_was_not_checked_is_refused() {
    let library = NodeLibrary::standard();
    let refused = |change: fn(&mut Graph), problem: &str| {
        let mut graph = small(&library);
        change(&mut graph);
        for error in [draw_svg(&graph, &library).err(), draw_dot(&graph, &library).err()] {
            // DOT needs no order, so that it can show a cycle.
            let text = error.map(|error| error.to_string());
            assert!(text.is_none_or(|text| text.contains(problem)), "{problem}");
        }
        assert!(draw_svg(&graph, &library).is_err(), "{problem}");
    };
    refused(
        |graph| graph.nodes[0].node_type = crate::nodes::NodeType(usize::MAX),
        "type is unknown",
    );
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

/// A random graph of mixes, sums and traces; each node takes from nodes before it.
fn random_graph() -> impl Strategy<Value = Graph> {
    let picks =
        prop::collection::vec((0..5_usize, prop::collection::vec(0..1_000_usize, 6)), 1..60);
    (picks, 0..6_usize).prop_map(|(picks, parameters)| {
        let library = NodeLibrary::standard();
        let types = ["mix", "add", "trace_reflection", "perturb_normal", "light_loop"];
        let mut graph = empty("random");
        for at in 0..parameters {
            graph.parameters.push(Parameter::new(format!("p{at}"), Literal::Scalar(at as f32)));
        }
        for (at, (kind, sources)) in picks.iter().enumerate() {
            let mut node = node(&library, types[*kind], &format!("node_{at}"), &[]);
            for (input, &source) in node.inputs.iter_mut().zip(sources) {
                *input = match source % 4 {
                    0 if parameters > 0 => Binding::Parameter(source % parameters),
                    1 | 2 if at > 0 => {
                        let from = source % at;
                        let outputs = library.signature(graph.nodes[from].node_type).outputs.len();
                        Binding::Node { node: from, output: source / 7 % outputs }
                    }
                    _ => Binding::Default,
                };
            }
            graph.nodes.push(node);
        }
        graph.roots = vec![
            root(RootKind::Material, from(picks.len() - 1, 0)),
            root(RootKind::Shadow, from(picks.len() / 2, 0)),
        ];
        graph
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn nothing_overlaps_and_every_wire_ends_at_its_sockets(graph in random_graph()) {
        let library = NodeLibrary::standard();
        let (diagram, layout) = laid_out(&graph, &library);
        prop_assert_eq!(faults(&diagram, &layout), Vec::<String>::new());
        let svg = super::svg::write(&diagram, &layout);
        prop_assert!(parse(&svg).is_ok());
        prop_assert_eq!(svg, draw_svg(&graph, &library).unwrap(), "the same bytes each time");
    }
}
