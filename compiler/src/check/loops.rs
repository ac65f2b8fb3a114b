//! What the turns of a loop provide is read only below its body.

use crate::diagnostics::{Code, Finding};
use crate::document::{Reader, Value};
use crate::nodes::{Kind, is_of_turn, reads_turn};
use crate::state::Iterated;

use super::draft::{Draft, Source, SourceKind};
use super::nested::OutsideLoops;

/// Reports every node that reads the turn of a loop and is reached from a root or an output without passing the
/// body of one. Tells for each parameter whether it is reached that way too: what a phenomenon
/// reads below its own loops only, others may give it from their turns.
pub(super) fn check(reader: &mut Reader<'_>, draft: &Draft<'_>) -> Vec<OutsideLoops> {
    let each = Iterated::ALL.map(|iterated| check_over(reader, draft, iterated));
    let parameters = 0..draft.parameters.len();
    parameters.map(|at| std::array::from_fn(|over| each[over][at])).collect()
}

/// The check for one kind of loop: for each parameter, whether it is reached outside of them.
fn check_over(reader: &mut Reader<'_>, draft: &Draft<'_>, over: Iterated) -> Vec<bool> {
    // Left to defaults, per node type and input: asked for often, so it is worked out once.
    let library = draft.node_types.library;
    let by_default: Vec<Vec<bool>> = library
        .iter()
        .map(|(node_type, definition)| {
            let inputs = 0..definition.signature.inputs.len();
            inputs.map(|input| reads_turn(library, node_type, input, over)).collect()
        })
        .collect();
    let mut walk = Walk {
        draft,
        over,
        by_default,
        visited: vec![false; draft.nodes.len()],
        reported: vec![false; draft.nodes.len()],
        parameters: vec![false; draft.parameters.len()],
        pending: Vec::new(),
    };
    for source in draft.called() {
        walk.arrive(reader, source);
    }
    while let Some(node) = walk.pending.pop() {
        walk.leave(reader, node);
    }
    walk.parameters
}

/// The nodes reached from roots outside of every loop of a kind.
struct Walk<'w, 'd> {
    draft: &'w Draft<'d>,
    over: Iterated,
    /// Of the types of the library.
    by_default: Vec<Vec<bool>>,
    visited: Vec<bool>,
    reported: Vec<bool>,
    parameters: Vec<bool>,
    pending: Vec<usize>,
}

impl Walk<'_, '_> {
    fn arrive(&mut self, reader: &mut Reader<'_>, source: &Source<'_>) {
        let (node, output) = match source.kind {
            SourceKind::Node(node, output) => (node, output),
            SourceKind::Parameter(parameter) => {
                self.parameters[parameter] = true;
                return;
            }
            SourceKind::Literal | SourceKind::Compound(_) | SourceKind::Broken => return,
        };
        let Some(node_type) = self.draft.nodes[node].node_type else { return };
        let library = self.draft.node_types.library;
        if self.draft.node_types.is_of_library(node_type)
            && is_of_turn(library, node_type, output, self.over)
        {
            self.report(reader, node, Some(source.value), "");
        }
        if !std::mem::replace(&mut self.visited[node], true) {
            self.pending.push(node);
        }
    }

    fn leave(&mut self, reader: &mut Reader<'_>, node: usize) {
        let (draft, over) = (self.draft, self.over);
        let Some(node_type) = draft.nodes[node].node_type else { return };
        let signature = draft.node_types.signature(node_type);
        let nested = draft.nested.get(&node_type);
        let is_body = |input: usize| match nested {
            Some(nested) => !nested.outside_loops[input][over as usize],
            None => match signature.kind {
                Kind::Loop(iterated, _) => iterated == over && signature.inputs[input].scoped,
                _ => false,
            },
        };
        for input in &draft.nodes[node].inputs {
            // A connection to an input that does not exist leads nowhere.
            if input.input.is_some_and(|at| !is_body(at)) {
                self.arrive(reader, &input.source);
            }
        }
        let mut given = vec![false; signature.inputs.len()];
        for at in draft.nodes[node].inputs.iter().filter_map(|input| input.input) {
            given[at] = true;
        }
        // The defaults of a phenomenon's parameters are literals.
        let by_default = self.by_default.get(node_type.0);
        for (at, is_given) in given.into_iter().enumerate() {
            if !is_given && !is_body(at) && by_default.is_some_and(|it| it[at]) {
                self.report(reader, node, None, &signature.inputs[at].name);
                break;
            }
        }
    }

    fn report(&mut self, reader: &mut Reader<'_>, node: usize, from: Option<&Value>, input: &str) {
        if std::mem::replace(&mut self.reported[node], true) {
            return;
        }
        let drafted = &self.draft.nodes[node];
        let by = if input.is_empty() {
            String::new()
        } else {
            format!(", by the default of its input `{input}`,")
        };
        let (what, of, help) = match self.over {
            Iterated::Lights => {
                let help = "connect what reads it to the input `body` of a `light_loop`";
                ("light sample", "light loop", help)
            }
            Iterated::Samples => {
                let help = "connect what reads it to the scoped input of a loop over samples";
                ("sample", "sample loop", help)
            }
        };
        let message =
            format!("{} reads the {what}{by} outside of a {of}", self.draft.described(node));
        let place = reader.document.place_of_key(drafted.member);
        let mut finding = Finding::new(Code::OUTSIDE_LIGHT_LOOP, place, message, help);
        if let Some(from) = from {
            finding = finding.with_related(reader.document.place(from), "reached from here");
        }
        reader.findings.push(finding);
    }
}
