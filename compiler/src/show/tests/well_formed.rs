//! Whether a drawing is a document.

use std::collections::HashSet;

/// The document as elements with attributes and text, or why it is none: enough of XML for what
/// the writer uses, and strict in it.
pub fn parse(svg: &str) -> Result<usize, String> {
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
