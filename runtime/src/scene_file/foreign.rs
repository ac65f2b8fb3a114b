//! What other renderers have and scenes do not: one finding says what there is instead.

use phenomenon_compiler::diagnostics::{Code, Finding, shortened};
use phenomenon_compiler::document::{Member, Reader, Value, ValueKind};

/// Lights there are not, and what comes near.
const LIGHTS: [(&[&str], &str); 5] = [
    (
        &["area", "rect", "quad", "square", "plane", "softbox", "portal"],
        "light from a flat surface is a `rectangle` or a `disc`",
    ),
    (&["disk", "circle"], "a round one is a `disc`"),
    (
        &["tube", "cylinder", "line", "mesh", "geometry", "capsule"],
        "long ones are a `rectangle` of little height, round ones a `sphere`",
    ),
    (&["cone", "photometric", "ies", "projector", "goniometric"], "light in a cone is a `spot`"),
    (
        &[
            "dome",
            "sky",
            "skydome",
            "env",
            "hdri",
            "ibl",
            "image",
            "infinite_area",
            "ambient",
            "hemisphere",
        ],
        "light from all around is an `environment` light, which shines as the `environment` of the scene does",
    ),
];

/// How a light of each kind is written.
const FORMS: [(&str, &str); 7] = [
    ("point", "{ \"position\": [x, y, z] }"),
    ("spot", "{ \"position\": [x, y, z], \"direction\": [x, y, z] }"),
    ("directional", "{ \"direction\": [x, y, z] }"),
    (
        "rectangle",
        "{ \"position\": [x, y, z], \"direction\": [x, y, z], \"width\": w, \"height\": h }",
    ),
    ("disc", "{ \"position\": [x, y, z], \"direction\": [x, y, z], \"radius\": r }"),
    ("sphere", "{ \"position\": [x, y, z], \"radius\": r }"),
    ("environment", "{ \"samples\": n }"),
];

/// Shapes there are not.
const SHAPES: [&str; 16] = [
    "cube", "box", "cylinder", "cone", "torus", "capsule", "pyramid", "disk", "disc", "triangle",
    "curve", "hair", "points", "volume", "sdf", "instance",
];

/// Whether an object has keys that are none of `keys`.
pub(super) fn has_other_keys(value: &Value, keys: &[&str]) -> bool {
    value.members().iter().any(|member| !keys.contains(&member.key.as_str()))
}

/// Reports a light of a kind there is none of, or whose kind is given as a word; whether it did.
pub(super) fn light(reader: &mut Reader<'_>, value: &Value) -> bool {
    if FORMS.iter().any(|(kind, _)| value.get(kind).is_some()) {
        return false;
    }
    let plain = |name: &str| {
        let name = name.to_lowercase();
        name.trim_end_matches("light").trim_end_matches(['_', '-', ' ']).to_owned()
    };
    let instead = |name: &str| {
        let name = plain(name);
        LIGHTS.iter().find(|(names, _)| names.contains(&&*name)).map(|(_, instead)| *instead)
    };
    let is_type = |member: &&Member| ["type", "kind"].contains(&member.key.as_str());
    let typed = value.members().iter().find(is_type).and_then(|member| match &member.value.kind {
        ValueKind::String(name) => Some((member, name.as_str())),
        _ => None,
    });
    let named = value.members().iter().map(|member| (member, member.key.as_str()));
    let found = named.chain(typed).find_map(|(member, name)| Some((member, name, instead(name)?)));
    let (member, message, help) = match (found, typed) {
        (Some((member, name, instead)), _) => {
            let message = format!("there is no `{}` light", shortened(name));
            (
                member,
                message,
                format!(
                    "a light is one of `point`, `spot`, `directional`, `rectangle`, `disc`, `sphere` and `environment`; {instead}"
                ),
            )
        }
        (None, Some((member, name))) => {
            let is_meant = |(kind, _): &&(&str, &str)| *kind == plain(name);
            let (kind, form) = FORMS.iter().find(is_meant).unwrap_or(&FORMS[0]);
            let message = "the kind of a light is a key, not a word".to_owned();
            (member, message, format!("write `\"{kind}\": {form}`"))
        }
        (None, None) => return false,
    };
    let place = reader.document.place_of_key(member);
    reader.findings.push(Finding::new(Code::UNUSABLE_OBJECT, place, message, help));
    true
}

/// Reports an object of a shape there is none of, or whose shape is given as a word; whether it did.
pub(super) fn shape(reader: &mut Reader<'_>, value: &Value) -> bool {
    if ["sphere", "mesh", "rectangle"].iter().any(|key| value.get(key).is_some()) {
        return false;
    }
    let is_type = |member: &&Member| ["type", "shape", "kind"].contains(&member.key.as_str());
    let typed = value
        .members()
        .iter()
        .find(|member| is_type(member) && matches!(member.value.kind, ValueKind::String(_)));
    let named =
        value.members().iter().find(|member| SHAPES.contains(&member.key.to_lowercase().as_str()));
    let (member, message, help) = match (named, typed) {
        (Some(member), _) => (
            member,
            format!("there is no `{}` among the shapes", shortened(&member.key)),
            "an object is a `sphere`, a `rectangle` or a `mesh`, which an OBJ file gives any shape",
        ),
        (None, Some(member)) => (
            member,
            "the shape of an object is a key, not a word".to_owned(),
            "write `\"sphere\": { \"radius\": 1 }`, `\"rectangle\": { … }` or `\"mesh\": \"file.obj\"`",
        ),
        (None, None) => return false,
    };
    reader.report_key(Code::UNUSABLE_OBJECT, member, message, help);
    true
}

/// Reports a material that is given as a path, or in a list; whether it did.
pub(super) fn material(reader: &mut Reader<'_>, value: &Value) -> bool {
    let (file, is_path) = match &value.kind {
        ValueKind::String(file) => (file.as_str(), file.ends_with(".json")),
        ValueKind::Array(elements) => match elements.first().map(|element| &element.kind) {
            Some(ValueKind::String(file)) => (file.as_str(), false),
            _ => ("graph.json", false),
        },
        _ => return false,
    };
    let message = format!("a material must be an object, not {}", value.describe());
    // What would have to be escaped is left to whoever wrote it.
    let plain = !file.contains(['"', '\\']) && shortened(file) == file;
    let written = format!("\"{}\"", if plain { file } else { "graph.json" });
    let help = format!("write `{{ \"file\": {written} }}`");
    let place = reader.document.place(value);
    let mut finding = Finding::new(Code::WRONG_KIND, place, message, help);
    finding.fix = (is_path && plain).then(|| format!("{{ \"file\": {written} }}"));
    reader.findings.push(finding);
    true
}
