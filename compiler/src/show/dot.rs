//! A diagram as DOT, for Graphviz to lay out.

use std::fmt::Write;

use crate::graph::Graph;

use super::build::diagram;
use super::diagram::{Card, Diagram, Given, Role};
use super::error::ShowError;
use super::escape::{dot, xml};
use super::frames::given_text;
use super::implied::Implied;
use super::theme::{HEADER, MUTED, OUTLINE, PAPER, PARAMETER, PARAMETER_BOX, ROOT, color};

/// Most characters of a text in a box.
const LONGEST: usize = 40;

/// Draws `graph` as a DOT digraph from left to right: a table for each node, a port for each
/// socket, wires in the colour of the type they carry. Of any size.
///
/// # Errors
/// A graph that was not checked.
pub fn draw_dot(graph: &Graph) -> Result<String, ShowError> {
    let diagram = diagram(graph, usize::MAX)?;
    let mut text = format!(
        "digraph \"{}\" {{\n  rankdir=LR; nodesep=0.3; ranksep=0.8; bgcolor=white;\n  \
         fontname=\"Helvetica\"; fontsize=16; labelloc=t; labeljust=l; label=\"{}\";\n  \
         node [shape=plain, fontname=\"Helvetica\", fontsize=10];\n  \
         edge [penwidth=1.5, arrowsize=0.6, fontname=\"Helvetica\", fontsize=8];\n",
        dot(diagram.name),
        dot(diagram.name)
    );
    let ids: Vec<String> = (0..diagram.cards.len()).map(|at| id(&diagram, at)).collect();
    for (card, id) in diagram.cards.iter().zip(&ids) {
        let label = table(card);
        let tip = dot(&format!("{}: {}", card.title, card.subtitle));
        let _ = writeln!(text, "  {id} [label=<{label}>, tooltip=\"{tip}\"];");
    }
    for (role, rank) in [(Role::Parameter, "min"), (Role::Root, "max")] {
        let alike: Vec<&str> = diagram
            .cards
            .iter()
            .zip(&ids)
            .filter(|(card, _)| card.role == role)
            .map(|(_, id)| id.as_str())
            .collect();
        if !alike.is_empty() {
            let _ = writeln!(text, "  {{ rank={rank}; {}; }}", alike.join("; "));
        }
    }
    for wire in &diagram.wires {
        let ((from, output), (to, input)) = (wire.from, wire.to);
        let output_type = diagram.cards[from].outputs[output].value_type;
        let target = &diagram.cards[to].inputs[input];
        let mut attributes = format!("color=\"{}\"", color(output_type));
        if wire.dead {
            attributes.push_str(", style=dotted");
        } else if target.scoped {
            attributes.push_str(", style=dashed");
        }
        if target.ruled_out {
            attributes.push_str(", arrowhead=tee");
        } else if target.guarded {
            attributes.push_str(", arrowhead=empty");
        }
        if wire.converts {
            let _ = write!(
                attributes,
                ", label=\"{} to {}\"",
                output_type.name(),
                target.value_type.name()
            );
        }
        let _ =
            writeln!(text, "  {}:o{output}:e -> {}:i{input}:w [{attributes}];", ids[from], ids[to]);
    }
    text.push_str("}\n");
    Ok(text)
}

/// A name for Graphviz: `p0`, `n0`, `r0`.
fn id(diagram: &Diagram<'_>, at: usize) -> String {
    match diagram.cards[at].role {
        Role::Parameter => format!("p{at}"),
        Role::Node => format!("n{}", at - diagram.parameters),
        Role::Root => format!("r{}", at - diagram.parameters - diagram.nodes),
    }
}

/// The HTML-like label of a card.
fn table(card: &Card<'_>) -> String {
    let fill = match (card.role, &card.badge) {
        (Role::Root, _) => ROOT,
        (Role::Parameter, _) => PARAMETER_BOX,
        (Role::Node, Some(badge)) => badge.accent.colors().0,
        (Role::Node, None) => HEADER,
    };
    let ink = if card.role == Role::Root { PAPER } else { "#000000" };
    let style = if card.dead.is_some() { " STYLE=\"DASHED\"" } else { "" };
    let port = if card.role == Role::Parameter { " PORT=\"o0\"" } else { "" };
    let mut second = card.subtitle.to_owned();
    if let Some(badge) = &card.badge {
        let _ = write!(second, " [{}]", badge.text);
    }
    if let Some(value) = &card.value {
        let _ = write!(second, " = {}", value.text);
    }
    if card.dead.is_some() {
        second.push_str(" (dead)");
    }
    let small = if card.role == Role::Root { PAPER } else { MUTED };
    let mut text = format!(
        "<TABLE BORDER=\"1\" CELLBORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"4\" \
         COLOR=\"{OUTLINE}\" BGCOLOR=\"{PAPER}\"{style}><TR><TD COLSPAN=\"2\" BGCOLOR=\"{fill}\"{port}>\
         <FONT COLOR=\"{ink}\"><B>{}</B></FONT><BR/>\
         <FONT POINT-SIZE=\"8\" COLOR=\"{small}\">{}</FONT></TD></TR>",
        cell(card.title),
        cell(&second)
    );
    if card.role != Role::Parameter {
        for row in 0..card.inputs.len().max(card.outputs.len()) {
            text.push_str("<TR>");
            text.push_str(&input_cell(card, row));
            text.push_str(&output_cell(card, row));
            text.push_str("</TR>");
        }
    }
    text + "</TABLE>"
}

fn input_cell(card: &Card<'_>, row: usize) -> String {
    let Some(input) = card.inputs.get(row) else {
        return "<TD></TD>".to_owned();
    };
    let given = given_text(&input.given);
    let value = match given {
        "" => String::new(),
        given => format!(" <FONT COLOR=\"{}\">{}</FONT>", given_color(&input.given), cell(given)),
    };
    let ruled_out = if input.ruled_out { " (ruled out)" } else { "" };
    format!("<TD ALIGN=\"LEFT\" PORT=\"i{row}\">{}{value}{ruled_out}</TD>", cell(&input.name))
}

fn given_color(given: &Given) -> &'static str {
    match given {
        Given::Parameter(_) => PARAMETER,
        Given::Implied(Implied { accent: Some(accent), .. }) => accent.colors().1,
        _ => MUTED,
    }
}

fn output_cell(card: &Card<'_>, row: usize) -> String {
    match card.outputs.get(row) {
        Some(output) => {
            format!("<TD ALIGN=\"RIGHT\" PORT=\"o{row}\">{}</TD>", cell(output.name))
        }
        None => "<TD></TD>".to_owned(),
    }
}

/// `text` for a cell, cut where it is long. Graphviz refuses empty fonts and bold.
fn cell(text: &str) -> String {
    if text.is_empty() {
        return "&#160;".to_owned();
    }
    let mut kept: String = text.chars().take(LONGEST).collect();
    if text.chars().nth(LONGEST).is_some() {
        kept.push('…');
    }
    xml(&kept)
}
