//! Where a name is given and used.

use lsp_types::{DocumentHighlight, DocumentHighlightKind, Location};

use crate::commands::lsp::file::OpenFile;
use crate::commands::lsp::names;

/// Where the name under a byte is used, and given if the declaration is wanted too.
pub fn references(file: &OpenFile, at: usize, with_declaration: bool) -> Option<Vec<Location>> {
    let index = names::index(file.current()?);
    let name = index.name_at(at)?;
    let given = with_declaration.then_some(&name.place);
    let places = given.into_iter().chain(index.uses_of(name).map(|used| &used.place));
    let uri = file.own_uri()?;
    Some(places.map(|place| Location { uri: uri.clone(), range: file.range_of(place) }).collect())
}

/// The same for the editor to mark.
pub fn highlights(file: &OpenFile, at: usize) -> Option<Vec<DocumentHighlight>> {
    let index = names::index(file.current()?);
    let name = index.name_at(at)?;
    let mark = |place, kind| DocumentHighlight { range: file.range_of(place), kind: Some(kind) };
    let mut marks = vec![mark(&name.place, DocumentHighlightKind::WRITE)];
    marks.extend(index.uses_of(name).map(|used| mark(&used.place, DocumentHighlightKind::READ)));
    Some(marks)
}
