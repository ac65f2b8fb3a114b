//! Which channels of a file are its colour.

use phenomenon_compiler::diagnostics::shortened;

use super::part::Part;
use crate::film::fault::Fault;

/// Most channels a message lists.
const SHOWN_LIMIT: usize = 24;

/// Which channels of a part, by number, are red, green, blue and alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Selection {
    /// The same one three times where it is grey.
    pub(super) color: [usize; 3],
    pub(super) alpha: Option<usize>,
    pub(super) grey: bool,
}

/// The part and the channels that are read: those of a part without layers if there are some, else those of
/// the only layer that has any.
pub(super) fn select(parts: &[Part]) -> Result<(usize, Selection), Fault> {
    let mut layers = Vec::new();
    for (number, part) in parts.iter().enumerate() {
        for layer in layers_of(part) {
            let Some(selection) = in_layer(part, layer) else { continue };
            // What has no layer, in the first part that has it, comes before all.
            if layer.is_empty() {
                return usable(part, selection).map(|selection| (number, selection));
            }
            layers.push((number, selection));
        }
    }
    if let [(number, selection)] = layers[..] {
        return usable(&parts[number], selection).map(|selection| (number, selection));
    }
    if let ([part], [channel]) = (parts, parts[0].channels.as_slice()) {
        let selection = Selection { color: [0; 3], alpha: None, grey: true };
        debug_assert!(!channel.name.is_empty());
        return usable(part, selection).map(|selection| (0, selection));
    }
    let why = match layers.len() {
        0 => "it has neither R, G and B nor Y",
        _ => "it has several layers, and none without a name",
    };
    Err(Fault::Malformed(format!(
        "{why}; its channels are {}: write the ones wanted as R, G and B, or as Y, into a file of their own",
        listed(parts)
    )))
}

/// Names of channels up to their last dot: the empty one for those without.
fn layers_of(part: &Part) -> Vec<&str> {
    let mut layers: Vec<&str> =
        part.channels.iter().map(|channel| split(&channel.name).0).collect();
    layers.sort_unstable();
    layers.dedup();
    layers
}

fn split(name: &str) -> (&str, &str) {
    name.rsplit_once('.').unwrap_or(("", name))
}

fn in_layer(part: &Part, layer: &str) -> Option<Selection> {
    let find =
        |name: &str| part.channels.iter().position(|channel| split(&channel.name) == (layer, name));
    let alpha = find("A");
    if let (Some(red), Some(green), Some(blue)) = (find("R"), find("G"), find("B")) {
        return Some(Selection { color: [red, green, blue], alpha, grey: false });
    }
    // Beside X or Z it is a coordinate.
    let vector = find("X").is_some() || find("Z").is_some();
    find("Y").filter(|_| !vector).map(|grey| Selection { color: [grey; 3], alpha, grey: true })
}

/// Refuses what cannot be read of these channels.
fn usable(part: &Part, selection: Selection) -> Result<Selection, Fault> {
    let chroma = part.channels.iter().any(|channel| matches!(split(&channel.name).1, "RY" | "BY"));
    if selection.grey && chroma {
        return Err(Fault::malformed(
            "its colors are luminance and chroma (Y, RY, BY), which are not read: write it as R, G and B",
        ));
    }
    match part.channels.iter().find(|channel| channel.subsampled) {
        None => Ok(selection),
        Some(channel) => Err(Fault::Malformed(format!(
            "its channel {} has fewer samples than pixels, which is not read: write all channels at full size",
            shortened(&channel.name)
        ))),
    }
}

fn listed(parts: &[Part]) -> String {
    let mut names = Vec::new();
    for part in parts {
        for channel in &part.channels {
            // Names of parts are told where there are several.
            let name = match parts {
                [_] => shortened(&channel.name),
                _ => format!("{} ({})", shortened(&channel.name), shortened(&part.name)),
            };
            names.push(name);
        }
    }
    let more = names.len().saturating_sub(SHOWN_LIMIT);
    names.truncate(SHOWN_LIMIT);
    let text = names.join(", ");
    if more == 0 { text } else { format!("{text} and {more} more") }
}
