//! Colours, for editors to show and to choose.

use lsp_types::{Color, ColorInformation, ColorPresentation};
use phenomenon_compiler::document::{Member, Value, ValueKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::film::{srgb_decoded, srgb_encoded};
use phenomenon_runtime::scene_file::LINEAR;

use crate::commands::lsp::file::OpenFile;
use crate::commands::lsp::keys::{Spot, spot};
use crate::commands::lsp::open_files::OpenFiles;
use crate::commands::lsp::parameters::parameters;
use crate::commands::lsp::part::text;
use crate::commands::lsp::parts::{parts_of_node, phenomenon};
use crate::commands::lsp::scope::Scope;
use crate::ours::Ours;

/// The colours that are written in the file, as a screen shows them. Those brighter than a screen are left out: what is
/// chosen there could not be as bright.
pub fn colors(
    file: &OpenFile,
    library: &NodeLibrary,
    files: &OpenFiles,
) -> Option<Vec<ColorInformation>> {
    let document = file.current()?;
    let mut found = Found { file, library, files, colors: Vec::new() };
    match file.ours? {
        Ours::Graph => found.phenomenon(&document.root, &mut Vec::new()),
        Ours::Scene => found.scene(&document.root, &mut Vec::new()),
    }
    Some(found.colors)
}

/// How a colour that was chosen is written.
pub fn presentations(color: Color) -> Vec<ColorPresentation> {
    let parts = [color.red, color.green, color.blue].map(|encoded| rounded(srgb_decoded(encoded)));
    let mut parts: Vec<String> = parts.to_vec();
    if color.alpha < 1.0 {
        parts.push(rounded(color.alpha));
    }
    vec![ColorPresentation { label: format!("[{}]", parts.join(", ")), ..Default::default() }]
}

/// Four digits: more than an eye can tell apart.
fn rounded(value: f32) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

struct Found<'f> {
    file: &'f OpenFile,
    library: &'f NodeLibrary,
    files: &'f OpenFiles,
    colors: Vec<ColorInformation>,
}

impl Found<'_> {
    /// The nesting of documents is bounded, and so is this recursion.
    fn phenomenon<'v>(&mut self, of: &'v Value, path: &mut Vec<&'v str>) {
        for parameter in of.get("interface").map_or(&[][..], Value::members) {
            self.declared(&parameter.value, parameter.value.get("default"));
        }
        let (scope, _) = Scope::of(self.file, path);
        for node in of.get("nodes").map_or(&[][..], Value::members) {
            let inputs = node.value.get("inputs").map_or(&[][..], Value::members);
            if inputs.is_empty() {
                continue;
            }
            let parts = parts_of_node(&scope, &node.value, self.library, self.files);
            let parts = parts.map(|parts| parts.inputs).unwrap_or_default();
            for input in inputs {
                if parts.iter().any(|part| part.name == input.key && part.of == "color") {
                    self.literal(&input.value);
                }
            }
        }
        for inner in of.get("phenomena").map_or(&[][..], Value::members) {
            path.extend(["phenomena", &inner.key]);
            self.phenomenon(&inner.value, path);
            path.truncate(path.len() - 2);
        }
    }

    /// What a parameter, an element or a member is by default.
    fn declared(&mut self, of: &Value, default: Option<&Value>) {
        match (text(of, "type"), default.map(|default| &default.kind)) {
            (Some("color"), Some(_)) => default.into_iter().for_each(|it| self.literal(it)),
            (Some("array"), Some(ValueKind::Array(elements))) => {
                let Some(of) = of.get("of") else { return };
                elements.iter().for_each(|element| self.declared(of, Some(element)));
            }
            (Some("struct"), _) => {
                for member in of.get("members").map_or(&[][..], Value::members) {
                    self.declared(&member.value, member.value.get("default"));
                }
            }
            _ => {}
        }
    }

    /// The same of a scene, at a path of its keys.
    fn scene<'v>(&mut self, value: &'v Value, path: &mut Vec<&'v str>) {
        match &value.kind {
            ValueKind::Array(elements) => {
                if matches!(spot(path), Some(Spot::Value(key)) if key.unit == LINEAR) {
                    return self.literal(value);
                }
                elements.iter().for_each(|element| self.scene(element, path));
            }
            ValueKind::Object(members) => {
                for member in members {
                    path.push(&member.key);
                    match spot(path) {
                        Some(Spot::Settings) => self.settings(value, member),
                        Some(_) => self.scene(&member.value, path),
                        None => {}
                    }
                    path.pop();
                }
            }
            _ => {}
        }
    }

    /// What is set of the parameters of a graph.
    fn settings(&mut self, of: &Value, set: &Member) {
        let Some(graph) = text(of, "file") else { return };
        let Some(document) = phenomenon(self.file, graph, self.files) else { return };
        let parameters = parameters(&document);
        for member in set.value.members() {
            if parameters.iter().any(|part| part.name == member.key && part.of == "color") {
                self.literal(&member.value);
            }
        }
    }

    /// A list of three or four numbers that a screen can show.
    fn literal(&mut self, value: &Value) {
        let ValueKind::Array(elements) = &value.kind else { return };
        let number = |value: &Value| match &value.kind {
            ValueKind::Number(text) => text.parse::<f32>().ok(),
            _ => None,
        };
        let parts: Option<Vec<f32>> = elements.iter().map(number).collect();
        let Some(parts) = parts else { return };
        let (red, green, blue, alpha) = match *parts.as_slice() {
            [red, green, blue] => (red, green, blue, 1.0),
            [red, green, blue, alpha] => (red, green, blue, alpha),
            _ => return,
        };
        if [red, green, blue, alpha].iter().all(|part| (0.0..=1.0).contains(part)) {
            let [red, green, blue] = [red, green, blue].map(srgb_encoded);
            let color = Color { red, green, blue, alpha };
            let range = self.file.range_of(&(value.start..value.end));
            self.colors.push(ColorInformation { range, color });
        }
    }
}
