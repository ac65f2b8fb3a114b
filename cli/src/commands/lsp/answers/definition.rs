//! Where something is said of what stands under the cursor.

use lsp_types::{Location, Range};
use phenomenon_compiler::document::{Document, Member, Value, ValueKind};

use crate::commands::lsp::address::uri_of;
use crate::commands::lsp::file::{OpenFile, range_in};
use crate::commands::lsp::names;
use crate::commands::lsp::open_files::OpenFiles;
use crate::commands::lsp::part::text;
use crate::commands::lsp::parts::body_of;
use crate::commands::lsp::paths::endings;

/// Where the name under a byte is given, in this file or in one it uses; of the name of a file, its beginning.
pub fn definition(file: &OpenFile, at: usize, files: &OpenFiles) -> Option<Location> {
    let document = file.current()?;
    let index = names::index(document);
    if let Some(name) = index.name_at(at) {
        return Some(Location { uri: file.own_uri()?, range: file.range_of(&name.place) });
    }
    let way = way_to(&document.root, at);
    let (last, above) = way.split_last()?;
    if endings(&last.key).is_some() && last.value.start <= at {
        let ValueKind::String(named) = &last.value.kind else { return None };
        let path = file.folder().join(named);
        let uri = uri_of(&path.canonicalize().ok().filter(|path| path.is_file())?).parse().ok()?;
        return Some(Location { uri, range: Range::default() });
    }
    let keys: Vec<&str> = way.iter().map(|member| member.key.as_str()).collect();
    let (of, section) = match keys.as_slice() {
        [.., "nodes", _, "inputs", _] => (way[way.len() - 3].value.get("type")?, "interface"),
        [.., "set", _] => (&above.iter().rev().nth(1)?.value, "interface"),
        [.., "output"] => {
            let connection = &above.last()?.value;
            (node_type(&document.root, &way, innermost(connection, at)?)?, "outputs")
        }
        _ => return None,
    };
    let name = match section {
        "outputs" => string(&last.value)?,
        _ => &last.key,
    };
    let of = body_of(of);
    let head = &name[..name.find(['.', '[']).unwrap_or(name.len())];
    match text(of, "file") {
        Some(named) => {
            let used = files.document(&file.folder().join(named))?;
            let uri = uri_of(&file.folder().join(named).canonicalize().ok()?).parse().ok()?;
            Some(Location { uri, range: range_of_key(&used, &used.root, section, head)? })
        }
        None => {
            let inner = inner_phenomenon(&document.root, &way, text(of, "phenomenon")?)?;
            let range = range_of_key(document, inner, section, head)?;
            Some(Location { uri: file.own_uri()?, range })
        }
    }
}

/// The members round a byte, outermost first; lists between them are passed through.
fn way_to(root: &Value, at: usize) -> Vec<&Member> {
    let mut way = Vec::new();
    let mut pending = vec![root];
    while let Some(value) = pending.pop() {
        match &value.kind {
            ValueKind::Array(elements) => {
                pending.extend(elements.iter().find(|it| it.start <= at && at <= it.end));
            }
            ValueKind::Object(members) => {
                let round = |it: &&Member| it.key_start <= at && at <= it.value.end;
                if let Some(member) = members.iter().find(round) {
                    way.push(member);
                    if member.value.start <= at {
                        pending.push(&member.value);
                    }
                }
            }
            _ => {}
        }
    }
    way
}

/// The innermost object round a byte, of a value that is one or a list of them.
fn innermost(value: &Value, at: usize) -> Option<&Value> {
    match &value.kind {
        ValueKind::Array(elements) => {
            innermost(elements.iter().find(|it| it.start <= at && at <= it.end)?, at)
        }
        ValueKind::Object(_) => Some(value),
        _ => None,
    }
}

/// The type of the node that a connection names, which stands in the phenomenon round it.
fn node_type<'d>(root: &'d Value, way: &[&'d Member], connection: &'d Value) -> Option<&'d Value> {
    let name = text(connection, "node")?;
    phenomenon_round(root, way).get("nodes")?.get(name)?.get("type")
}

/// The innermost phenomenon a way leads through.
fn phenomenon_round<'d>(root: &'d Value, way: &[&'d Member]) -> &'d Value {
    rounds(root, way).last().copied().unwrap_or(root)
}

/// The phenomena a way leads through, outermost first.
fn rounds<'d>(root: &'d Value, way: &[&'d Member]) -> Vec<&'d Value> {
    let mut round = vec![root];
    let mut rest = way;
    while let [section, inner, further @ ..] = rest {
        if section.key != "phenomena" {
            break;
        }
        round.push(&inner.value);
        rest = further;
    }
    round
}

/// The phenomenon of that name that is known on the way.
fn inner_phenomenon<'d>(root: &'d Value, way: &[&'d Member], name: &str) -> Option<&'d Value> {
    rounds(root, way).iter().rev().find_map(|round| round.get("phenomena")?.get(name))
}

fn range_of_key(document: &Document, of: &Value, section: &str, name: &str) -> Option<Range> {
    let member = of.get(section)?.members().iter().find(|member| member.key == name)?;
    Some(range_in(&document.file, &(member.key_start..member.key_end)))
}

fn string(value: &Value) -> Option<&str> {
    match &value.kind {
        ValueKind::String(text) => Some(text),
        _ => None,
    }
}
