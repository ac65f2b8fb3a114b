//! What editors are offered: items of completion.

use lsp_types::{CompletionItem, CompletionItemKind, Documentation};
use phenomenon_compiler::document::Key;

use super::keys;
use super::part::Part;

/// Longest literal that is offered, in bytes.
const LONGEST: usize = 120;

/// Makes items for a place in the text.
#[derive(Clone, Copy, Debug)]
pub struct Offers {
    /// Whether the place is within a string, whose quotes are there.
    pub in_string: bool,
}

impl Offers {
    /// A word, between quotes.
    pub fn word(
        self,
        label: &str,
        kind: CompletionItemKind,
        detail: &str,
        doc: &str,
    ) -> CompletionItem {
        let text = if self.in_string { label.to_owned() } else { quoted(label) };
        let told = |text: &str| (!text.is_empty()).then(|| text.to_owned());
        CompletionItem {
            label: label.into(),
            kind: Some(kind),
            detail: told(detail),
            documentation: told(doc).map(Documentation::String),
            insert_text: Some(text),
            ..CompletionItem::default()
        }
    }

    /// Words without more to say of them.
    pub fn words<'w>(
        self,
        words: impl IntoIterator<Item = &'w str>,
        kind: CompletionItemKind,
    ) -> Vec<CompletionItem> {
        words.into_iter().map(|word| self.word(word, kind, "", "")).collect()
    }

    /// A value that is no string; none within one, and none that is longer than a line.
    pub fn literal(self, text: &str, detail: &str) -> Option<CompletionItem> {
        let is_one_line = text.len() <= LONGEST && !text.contains('\n');
        (is_one_line && !self.in_string).then(|| CompletionItem {
            label: text.into(),
            kind: Some(CompletionItemKind::VALUE),
            detail: (!detail.is_empty()).then(|| detail.to_owned()),
            insert_text: Some(text.into()),
            ..CompletionItem::default()
        })
    }

    /// Keys, with what there is to say of them.
    pub fn keys<'k>(self, keys: impl IntoIterator<Item = &'k Key>) -> Vec<CompletionItem> {
        let item = |key: &Key| {
            let (detail, doc) = (keys::detail(key), keys::doc(key));
            self.word(key.name, CompletionItemKind::PROPERTY, &detail, &doc)
        };
        keys.into_iter().map(item).collect()
    }

    /// Inputs, outputs or parameters.
    pub fn parts<'p>(self, parts: impl IntoIterator<Item = &'p Part>) -> Vec<CompletionItem> {
        let item =
            |part: &Part| self.word(&part.name, CompletionItemKind::FIELD, &part.of, &part.doc);
        parts.into_iter().map(item).collect()
    }
}

/// A string as JSON has it.
pub fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
