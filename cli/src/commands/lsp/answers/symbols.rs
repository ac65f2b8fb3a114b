//! The outline of a file.

use lsp_types::{DocumentSymbol, SymbolKind};
use phenomenon_compiler::document::{Document, Member, Value, ValueKind};

use crate::commands::lsp::file::OpenFile;
use crate::commands::lsp::part::text;
use crate::ours::Ours;

/// The outline of the file.
pub fn symbols(file: &OpenFile) -> Option<Vec<DocumentSymbol>> {
    let document = file.current()?;
    let outline = Outline { file };
    Some(match file.ours? {
        Ours::Graph => outline.phenomenon(&document.root),
        Ours::Scene => outline.scene(document),
    })
}

struct Outline<'f> {
    file: &'f OpenFile,
}

impl Outline<'_> {
    /// Parameters, nodes and what else has a name. The nesting of documents is bounded, and so is this recursion.
    fn phenomenon(&self, of: &Value) -> Vec<DocumentSymbol> {
        let sections = [
            ("interface", SymbolKind::PROPERTY),
            ("presets", SymbolKind::CONSTANT),
            ("phenomena", SymbolKind::CLASS),
            ("nodes", SymbolKind::VARIABLE),
            ("outputs", SymbolKind::FIELD),
            ("roots", SymbolKind::EVENT),
        ];
        let mut found = Vec::new();
        for member in of.members() {
            let section = sections.iter().find(|(section, _)| *section == member.key);
            let Some((section, kind)) = section else { continue };
            let inner = member.value.members().iter().map(|inner| {
                let detail = match inner.value.get("type") {
                    Some(of) => told_type(of),
                    None => String::new(),
                };
                let children = match *section {
                    "phenomena" => self.phenomenon(&inner.value),
                    _ => Vec::new(),
                };
                self.symbol(inner, &inner.key, detail, *kind, children)
            });
            let inner = inner.collect();
            found.push(self.symbol(member, section, String::new(), SymbolKind::NAMESPACE, inner));
        }
        found
    }

    fn scene(&self, document: &Document) -> Vec<DocumentSymbol> {
        let mut found = Vec::new();
        for member in document.root.members() {
            let kind = match member.key.as_str() {
                "objects" => SymbolKind::OBJECT,
                "lights" => SymbolKind::EVENT,
                "camera" | "environment" | "options" => SymbolKind::NAMESPACE,
                _ => continue,
            };
            let mut inner = Vec::new();
            if let ValueKind::Array(elements) = &member.value.kind {
                for element in elements {
                    let shape = element.members().iter().find(|it| it.key != "name");
                    let shape = shape.map_or("", |shape| shape.key.as_str());
                    let name = text(element, "name").unwrap_or(shape);
                    let place = element.start..element.end;
                    inner.push(self.symbol_at(
                        &place,
                        &place,
                        name,
                        shape.into(),
                        kind,
                        Vec::new(),
                    ));
                }
            }
            let namespace = SymbolKind::NAMESPACE;
            found.push(self.symbol(member, &member.key, String::new(), namespace, inner));
        }
        found
    }

    fn symbol(
        &self,
        member: &Member,
        name: &str,
        detail: String,
        kind: SymbolKind,
        children: Vec<DocumentSymbol>,
    ) -> DocumentSymbol {
        let (whole, key) = (member.key_start..member.value.end, member.key_start..member.key_end);
        self.symbol_at(&whole, &key, name, detail, kind, children)
    }

    fn symbol_at(
        &self,
        whole: &std::ops::Range<usize>,
        key: &std::ops::Range<usize>,
        name: &str,
        detail: String,
        kind: SymbolKind,
        children: Vec<DocumentSymbol>,
    ) -> DocumentSymbol {
        // Editors refuse symbols without a name.
        let name = if name.is_empty() { "(unnamed)" } else { name };
        #[expect(deprecated, reason = "the field must be given")]
        DocumentSymbol {
            name: name.into(),
            detail: (!detail.is_empty()).then_some(detail),
            kind,
            tags: None,
            deprecated: None,
            range: self.file.range_of(whole),
            selection_range: self.file.range_of(key),
            children: (!children.is_empty()).then_some(children),
        }
    }
}

/// The type of a node or a parameter.
fn told_type(of: &Value) -> String {
    match &of.kind {
        ValueKind::String(name) => name.clone(),
        _ => text(of, "file").or(text(of, "phenomenon")).unwrap_or_default().into(),
    }
}
