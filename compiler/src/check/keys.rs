//! The keys of the objects a phenomenon is written with: from them come the lists of keys the reader knows, the schema,
//! the reference page and completion.

use crate::document::{FORMAT, Given, Key, Kind, PICTURE_FILES, Section, names_of};
use crate::values::Type;

pub use super::value_keys::{COLOR, OUTPUT};
use super::value_keys::{EDITOR, key};

/// A key that goes with some types only.
const fn key_of(
    only: &'static [&'static str],
    name: &'static str,
    kind: Kind,
    given: Given,
    doc: &'static str,
) -> Key {
    Key { name, kind, only, given, unit: "", doc }
}

/// The author's and the library's versions.
const VERSION: Kind = Kind::Whole(0..=i32::MAX as i128);

/// A graph file.
pub static PHENOMENON: Section = Section {
    name: "phenomenon",
    what: "a phenomenon",
    keys: &[
        key("$schema", Kind::Text, Given::Optional, "Where the schema is, for editors"),
        key("format", Kind::Whole(1..=FORMAT as i128), Given::Default("1"), "Format of the file"),
        key("phenomenon", Kind::Name, Given::Required, "Its name"),
        key("version", VERSION, Given::Default("0"), "The author's version of the phenomenon"),
        key("doc", Kind::Text, Given::Optional, "What it is"),
        key(
            "requires",
            Kind::Object(&REQUIRES),
            Given::Optional,
            "What the renderer must do for it",
        ),
        INTERFACE,
        key(
            "presets",
            Kind::Presets,
            Given::Default("{}"),
            "Values of some of the parameters, by the name of a preset; `--preset` and scenes choose one",
        ),
        key("phenomena", Kind::Named(&INNER), Given::Default("{}"), PHENOMENA),
        NODES,
        OUTPUTS,
        CALLED_FOR,
        EDITOR,
    ],
    one_of: &[],
};

const INTERFACE: Key =
    key("interface", Kind::Named(&PARAMETER), Given::Default("{}"), "Its parameters, by name");
const PHENOMENA: &str =
    "Phenomena its nodes may be, by name: `{ \"phenomenon\": \"name\" }` as a type";
const NODES: Key = key("nodes", Kind::Named(&NODE), Given::Default("{}"), "Its nodes, by name");
const OUTPUTS: Key = key(
    "outputs",
    Kind::Named(&OUTPUT),
    Given::Optional,
    "What it offers where it is a node, by name; at least one",
);
const CALLED_FOR: Key = key(
    "roots",
    Kind::Object(&ROOTS),
    Given::Optional,
    "What it is called for; at least one root, and required unless there are `outputs`",
);

/// A phenomenon within a file.
pub static INNER: Section = Section {
    name: "phenomena",
    what: "a phenomenon within a file",
    keys: &[
        key("version", VERSION, Given::Default("0"), "The author's version of it"),
        key("doc", Kind::Text, Given::Optional, "What it is"),
        key(
            "requires",
            Kind::Object(&REQUIRES),
            Given::Optional,
            "What the renderer must do for it",
        ),
        INTERFACE,
        key("phenomena", Kind::Named(&INNER), Given::Default("{}"), PHENOMENA),
        NODES,
        OUTPUTS,
        CALLED_FOR,
        EDITOR,
    ],
    one_of: &[],
};

const SWITCH: Kind = Kind::Word(&["on", "off"]);
const COUNT: Kind = Kind::Whole(0..=1000);
/// The names of the shader types.
const ROOT_NAMES: [&str; 14] = names_of(&ROOTS);

/// What the renderer must do for a phenomenon.
pub static REQUIRES: Section = Section {
    name: "requires",
    what: "`requires`",
    keys: &[
        key("scanline", SWITCH, Given::Optional, "Whether eye rays may be found by scanlines"),
        key("trace", SWITCH, Given::Optional, "Whether rays are traced"),
        key(
            "shadow",
            Kind::Word(&["on", "off", "sort", "segments"]),
            Given::Optional,
            "Whether there are shadows, and in which order their shaders are called; `sort` and `segments` refine `on`",
        ),
        key(
            "face",
            Kind::Word(&["front", "back", "both"]),
            Given::Optional,
            "Which side of surfaces is seen",
        ),
        key(
            "space",
            Kind::Word(&["object", "camera", "mixed"]),
            Given::Optional,
            "The space shaders compute in",
        ),
        key("texture", COUNT, Given::Default("0"), "Least number of texture spaces"),
        key("bump", COUNT, Given::Default("0"), "Least number of bump bases"),
        key("volume_level", COUNT, Given::Default("0"), "Level by which volumes are ordered"),
        key(
            "derivative",
            Kind::Set(&Kind::Whole(1..=2), 1..=2),
            Given::Optional,
            "Orders of the surface derivatives it needs",
        ),
        key(
            "parallel",
            Kind::Boolean,
            Given::Optional,
            "Whether an output shader may run in parallel",
        ),
        key(
            "apply",
            Kind::Set(&Kind::Word(&ROOT_NAMES), 1..=ROOT_NAMES.len()),
            Given::Optional,
            "What it may be used as; a root, or a place below a root, of another type is an error",
        ),
    ],
    one_of: &[],
};

const SHADER: Kind = Kind::Value { text: "a root", definition: "root" };

/// What a phenomenon is called for: the shader types of mental ray.
pub static ROOTS: Section = Section {
    name: "roots",
    what: "`roots`",
    keys: &[
        key(
            "material",
            SHADER,
            Given::Optional,
            "The colour a visible ray sees that hit a surface",
        ),
        key("shadow", SHADER, Given::Optional, "The colour light is multiplied by at a surface"),
        key("environment", SHADER, Given::Optional, "The colour a ray sees that left the scene"),
        key("volume", SHADER, Given::Optional, "Changes the colour seen through a volume"),
        key("light", SHADER, Given::Optional, "What a light sends to a point"),
        key("lens", SHADER, Given::Optional, "A ray that leaves the camera"),
        key("texture", SHADER, Given::Optional, "A texture that another shader asks for"),
        key(
            "displacement",
            SHADER,
            Given::Optional,
            "The distance a vertex moves along its normal, a scalar",
        ),
        key("output", SHADER, Given::Optional, "A pixel of the finished picture"),
        key("photon", SHADER, Given::Optional, "Changes the energy of a photon at a surface"),
        key("contour", SHADER, Given::Optional, "A contour line"),
        key("lightmap", SHADER, Given::Optional, "A light map"),
        key("geometry", SHADER, Given::Optional, "Geometry made before rendering"),
        key("state", SHADER, Given::Optional, "A state that is set up or taken down"),
    ],
    one_of: &[],
};

/// A root that may yield no value at all.
pub static ROOT: Section = Section {
    name: "root",
    what: "a root",
    keys: &[
        key(
            "color",
            Kind::Value { text: "color, or a list of shaders", definition: "shaders" },
            Given::Required,
            "Its value",
        ),
        key(
            "ok",
            Kind::Value { text: "boolean", definition: "boolean" },
            Given::Default("true"),
            "Whether it yields one; false is mental ray's miFALSE, no value at all",
        ),
    ],
    one_of: &[],
};

/// Types of parameters that are made of others.
pub const COMPOUNDS: [&str; 2] = ["array", "struct"];

const TYPE_NAMES: [&str; Type::ALL.len() + COMPOUNDS.len()] = {
    let mut names = [""; Type::ALL.len() + COMPOUNDS.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = match at.checked_sub(Type::ALL.len()) {
            Some(at) => COMPOUNDS[at],
            None => Type::ALL[at].name(),
        };
        at += 1;
    }
    names
};

/// Types whose values are numbers with an order.
const NUMBERS: &[&str] = &["scalar", "integer", "color", "vector"];
/// Types with a default of their own.
const WITH_DEFAULT: &[&str] = &["texture", "lights", "shader", "struct"];
const BOUND: Kind = Kind::Value { text: "number", definition: "number" };

/// A parameter of any type.
pub static PARAMETER: Section = Section {
    name: "parameter",
    what: "a parameter",
    keys: &[
        key("type", Kind::Word(&TYPE_NAMES), Given::Required, "What its values are"),
        key_of(
            &["array"],
            "of",
            Kind::Object(&PARAMETER),
            Given::Required,
            "What each value is, as a parameter without a default",
        ),
        key_of(
            &["struct"],
            "members",
            Kind::Named(&PARAMETER),
            Given::Required,
            "Its members, by name, each with its default",
        ),
        key(
            "default",
            Kind::Value { text: "literal", definition: "literal" },
            Given::RequiredBut(WITH_DEFAULT),
            "A literal of that type. `lights` are the empty list by default, `texture` and `shader` are `null`, structs have the defaults of their members",
        ),
        key_of(
            &["integer"],
            "values",
            Kind::Labels,
            Given::Optional,
            "An enumeration: the names of 0, 1, 2 …, in place of `min`, `max`, `soft_min` and `soft_max`. Whoever gives a value may give a name",
        ),
        key_of(
            NUMBERS,
            "min",
            BOUND,
            Given::Optional,
            "The least value it may take, per component (of colours r, g, b). It is enforced where the parameter is bound: by `--set`, by a scene, by a phenomenon that uses this one",
        ),
        key_of(
            NUMBERS,
            "max",
            BOUND,
            Given::Optional,
            "The largest value it may take, enforced as `min` is",
        ),
        key_of(
            NUMBERS,
            "soft_min",
            BOUND,
            Given::Optional,
            "The least value an editor offers, within `min` and `max`",
        ),
        key_of(
            NUMBERS,
            "soft_max",
            BOUND,
            Given::Optional,
            "The largest value an editor offers, within `min` and `max`",
        ),
        key_of(NUMBERS, "unit", Kind::Text, Given::Optional, "Such as `\"mm\"`"),
        key("doc", Kind::Text, Given::Optional, "What it means"),
        EDITOR,
    ],
    one_of: &[],
};

/// What the range of an enumeration stands in place of: that of its names.
const BOUNDS: [&str; 4] = ["min", "max", "soft_min", "soft_max"];

/// What the type of a parameter may be.
pub const fn declared_types() -> &'static [&'static str] {
    &TYPE_NAMES
}

/// The keys of a declaration by what it says its type is, as far as that is known. An enumeration `has_values`.
pub fn of_declaration(type_name: Option<&str>, has_values: bool) -> Vec<&'static Key> {
    match type_name {
        Some(name) if declared_types().contains(&name) => {
            let is_enumeration = name == "integer" && has_values;
            let keys = PARAMETER.keys_of(name);
            keys.filter(|key| !(is_enumeration && BOUNDS.contains(&key.name))).collect()
        }
        // What it may be is not known, so any of them may be right.
        _ => PARAMETER.keys.iter().collect(),
    }
}

/// A node.
pub static NODE: Section = Section {
    name: "node",
    what: "a node",
    keys: &[
        key(
            "type",
            Kind::Value {
                text: "a type from `phenomenon nodes`, `{ \"file\": \"snow.json\" }`, `{ \"phenomenon\": \"name\" }`, or a [map or a fold](#maps-and-folds)",
                definition: "node_type",
            },
            Given::Required,
            "What it computes; a phenomenon as a node is in another file, or in this one under `phenomena`",
        ),
        key(
            "version",
            VERSION,
            Given::Default("0"),
            "The version of its type it was made for, checked where it is not 0. Library nodes have version 1",
        ),
        key("doc", Kind::Text, Given::Optional, "Why it is there"),
        key(
            "inputs",
            Kind::Value { text: "values by name", definition: "inputs" },
            Given::Default("{}"),
            "What it is given; an input that is left out has the default its type declares",
        ),
        EDITOR,
    ],
    one_of: &[],
};

/// The names of the keys of a node.
pub const NODE_KEYS: [&str; 5] = names_of(&NODE);

/// A connection, of which `output` goes with `node`.
pub static CONNECTION: Section = Section {
    name: "connection",
    what: "a connection",
    keys: &[
        key("node", Kind::Text, Given::Choice, "The node whose output arrives"),
        key(
            "output",
            Kind::Text,
            Given::Optional,
            "Which of its outputs, by default the first, or a component of one: `\"normal.y\"`, `\"color.r\"`, and `\"y\"` where there is one output alone; with `node` only",
        ),
        key(
            "interface",
            Kind::Text,
            Given::Choice,
            "The parameter whose value arrives, or a part or a component of one: `\"look.tint\"`, `\"layers[2].tint\"`, `\"tint.r\"`",
        ),
    ],
    one_of: &["node", "interface"],
};

/// The names of the keys of a connection: first those of one to a node, then those of others.
pub const CONNECTION_KEYS: [&str; 3] = names_of(&CONNECTION);

/// What is computed from what other connections give.
pub static EXPRESSION: Section = Section {
    name: "expression",
    what: "an expression",
    keys: &[
        key(
            "expression",
            Kind::Text,
            Given::Required,
            "What is computed: `\"0.5 * (noise + 1) * tint.r\"`. [Expressions](expressions.md) tells what may stand there",
        ),
        key(
            "where",
            Kind::Value { text: "values by name", definition: "where" },
            Given::Default("{}"),
            "Names for values: literals, connections, other expressions. Each is known to the expression, and to those after it",
        ),
    ],
    one_of: &[],
};

/// The names of the keys of an expression.
pub const EXPRESSION_KEYS: [&str; 2] = names_of(&EXPRESSION);

/// A picture.
pub static TEXTURE: Section = Section {
    name: "texture",
    what: "a texture",
    keys: &[
        key("texture", Kind::File(PICTURE_FILES), Given::Required, "The picture"),
        key(
            "space",
            Kind::Word(&["srgb", "linear"]),
            Given::Optional,
            "How its colours are encoded; by default EXR and HDR are linear, PNG and JPEG sRGB",
        ),
    ],
    one_of: &[],
};

/// All objects of graph files whose keys are known.
pub fn sections() -> Vec<&'static Section> {
    [PHENOMENON.all(), vec![&ROOT, &CONNECTION, &EXPRESSION, &TEXTURE, &COLOR]].concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::RootKind;
    use crate::values::{ColorSpace, Space};

    #[test]
    fn tables_name_what_the_code_names() {
        assert_eq!(ROOT_NAMES, RootKind::ALL.map(RootKind::name));
        let numbers = Type::ALL.into_iter().filter(|of| of.is_numeric()).map(Type::name);
        assert!(numbers.eq(NUMBERS.iter().copied()), "{NUMBERS:?}");
        let Kind::Word(spaces) = TEXTURE.keys[1].kind else { panic!() };
        assert_eq!(spaces, Space::ALL.map(|(name, _)| name));
        assert_eq!(COLOR.names(), ColorSpace::ALL.map(|space| space.name));
        for section in sections() {
            for key in section.keys {
                assert!(!key.doc.ends_with('.') && !key.doc.is_empty(), "{}", key.name);
                assert!(key.only.iter().all(|of| declared_types().contains(of)), "{}", key.name);
                assert_eq!(section.one_of.contains(&key.name), key.given == Given::Choice);
            }
        }
    }

    #[test]
    fn declarations_have_the_keys_of_their_type() {
        let names = |of, has_values| -> Vec<&str> {
            of_declaration(of, has_values).iter().map(|key| key.name).collect()
        };
        assert_eq!(names(Some("struct"), false), ["type", "members", "default", "doc", "editor"]);
        assert_eq!(names(Some("string"), true), ["type", "default", "doc", "editor"]);
        let enumeration = ["type", "default", "values", "unit", "doc", "editor"];
        assert_eq!(names(Some("integer"), true), enumeration);
        assert_eq!(names(Some("float"), false).len(), PARAMETER.keys.len());
    }
}
