//! The keys of scene files: from them come the lists of keys the reader knows, the schema, the reference page and
//! completion. A test holds the defaults and ranges given here against what the reader does.

use phenomenon_compiler::document::{
    FORMAT, GRAPH_FILES, Given, Kind, MESH_FILES, PICTURE_FILES, Section,
};

use super::key_kinds::{
    COLOR, COORDINATES, DEGREES, LENGTH, LIGHT, LINEAR, SCENE_UNITS, VECTOR, key, measured,
};
use super::light_keys::LIGHT_SOURCE;

/// A scene file.
pub static SCENE: Section = Section {
    name: "scene",
    what: "a scene",
    keys: &[
        key("$schema", Kind::Text, Given::Optional, "Where the schema is, for editors"),
        key("format", Kind::Whole(1..=FORMAT as i128), Given::Default("1"), "Format of the file"),
        key(
            "scene",
            Kind::Text,
            Given::Required,
            "Name of the scene. The key makes the file a scene",
        ),
        key(
            "version",
            Kind::Whole(1..=1),
            Given::Default("1"),
            "Always 1: what scenes had before `format`, and it says the same",
        ),
        key("doc", Kind::Text, Given::Optional, "What it shows"),
        key("camera", Kind::Object(&CAMERA), Given::Required, "Where it is seen from"),
        key(
            "objects",
            Kind::Objects(&OBJECT),
            Given::Required,
            "What stands in it; the list may be empty",
        ),
        key(
            "lights",
            Kind::Objects(&LIGHT_SOURCE),
            Given::Default("[]"),
            "What lights it, besides the environment that shaders ask for",
        ),
        key(
            "environment",
            Kind::Object(&ENVIRONMENT),
            Given::Optional,
            "What rays see that leave the scene. Without it they see nothing: black, with alpha 0 in the picture",
        ),
        key(
            "options",
            Kind::Object(&OPTIONS),
            Given::Optional,
            "How it is rendered, unless the command line says otherwise",
        ),
        key(
            "editor",
            Kind::Anything,
            Given::Optional,
            "Whatever editors keep here; it changes nothing",
        ),
    ],
    one_of: &[],
};

/// The camera.
pub static CAMERA: Section = Section {
    name: "camera",
    what: "the camera",
    keys: &[
        measured(
            "position",
            VECTOR,
            Given::Required,
            SCENE_UNITS,
            "Where it stands: one point, from which all rays start",
        ),
        measured(
            "look_at",
            VECTOR,
            Given::Required,
            SCENE_UNITS,
            "The point seen in the middle of the picture; not the camera's own position",
        ),
        key(
            "up",
            VECTOR,
            Given::Default("[0, 1, 0]"),
            "A direction that points up in the picture, of any length but 0, and not along the view. It need not be square to it",
        ),
        measured(
            "field_of_view",
            Kind::Number(1e-3..=179.0),
            Given::Default("40"),
            DEGREES,
            "Angle between the upper and the lower edge of the picture. The width follows from the size of the picture, for pixels are square",
        ),
    ],
    one_of: &[],
};

/// An object.
pub static OBJECT: Section = Section {
    name: "object",
    what: "an object",
    keys: &[
        key(
            "name",
            Kind::Text,
            Given::Optional,
            "What findings call it; no two objects have the same. By default its shape",
        ),
        key("doc", Kind::Text, Given::Optional, "What it is"),
        key("sphere", Kind::Object(&SPHERE), Given::Choice, "The object is a sphere"),
        key("mesh", Kind::File(MESH_FILES), Given::Choice, "The object is this OBJ file"),
        key("rectangle", Kind::Object(&RECTANGLE), Given::Choice, "The object is a rectangle"),
        key(
            "second_uv",
            Kind::File(MESH_FILES),
            Given::Optional,
            "An OBJ file of the same mesh, whose surface coordinates are its second set. Without it the second set is the first",
        ),
        key(
            "normals",
            Kind::Word(&["smooth", "flat"]),
            Given::Default("\"smooth\""),
            "How a mesh is shaded: with the normals of its file, smoothed over its vertices where the file has none; or with those of its faces. It changes nothing else of a scene",
        ),
        key(
            "shadow_terminator",
            Kind::Word(&["smooth", "facets"]),
            Given::Default("\"smooth\""),
            "Where a mesh with normals ends in its own shadow: where the round surface would that the normals describe, or where its facets do",
        ),
        key(
            "transform",
            Kind::Object(&TRANSFORM),
            Given::Optional,
            "From its own space to that of the scene; by default it stays where it is",
        ),
        key("material", Kind::Object(&MATERIAL), Given::Required, "What shades it"),
    ],
    one_of: &["sphere", "mesh", "rectangle"],
};

/// A sphere.
pub static SPHERE: Section = Section {
    name: "sphere",
    what: "a sphere",
    keys: &[
        measured("center", VECTOR, Given::Default("[0, 0, 0]"), SCENE_UNITS, "Its middle"),
        measured("radius", LENGTH, Given::Required, SCENE_UNITS, "Its radius"),
    ],
    one_of: &[],
};

/// A rectangle.
pub static RECTANGLE: Section = Section {
    name: "rectangle",
    what: "a rectangle",
    keys: &[
        measured("width", LENGTH, Given::Required, SCENE_UNITS, "Its size along x"),
        measured("depth", LENGTH, Given::Required, SCENE_UNITS, "Its size along z"),
    ],
    one_of: &[],
};

/// A transform.
pub static TRANSFORM: Section = Section {
    name: "transform",
    what: "a transform",
    keys: &[
        key(
            "scale",
            Kind::Either(&Kind::Number(COORDINATES), &VECTOR),
            Given::Default("1"),
            "Factor, or one along each axis; none may be 0, and spheres take the same along each. Applied first",
        ),
        measured(
            "rotate",
            VECTOR,
            Given::Default("[0, 0, 0]"),
            DEGREES,
            "Angles about x, then y, then z, the axes of the scene. Applied after `scale`",
        ),
        measured(
            "translate",
            VECTOR,
            Given::Default("[0, 0, 0]"),
            SCENE_UNITS,
            "Where the origin goes. Applied last",
        ),
        key(
            "matrix",
            Kind::Several(&Kind::Number(COORDINATES), 12..=12),
            Given::Optional,
            "Three rows of four numbers, in place of the other keys",
        ),
    ],
    one_of: &[],
};

/// What shades an object.
pub static MATERIAL: Section = Section {
    name: "material",
    what: "a material",
    keys: &[
        key(
            "subject",
            Kind::True,
            Given::Choice,
            "The graph that is looked at, in a scene that serves as a stage",
        ),
        key("file", Kind::File(GRAPH_FILES), Given::Choice, "A graph with the root `material`"),
        key(
            "preset",
            Kind::Text,
            Given::Optional,
            "A preset of the graph; what `set` gives counts before its values",
        ),
        key(
            "set",
            Kind::Settings,
            Given::Default("{}"),
            "Values for parameters of the graph; the others have their defaults",
        ),
    ],
    one_of: &["subject", "file"],
};

/// What rays see that leave the scene.
pub static ENVIRONMENT: Section = Section {
    name: "environment",
    what: "the environment",
    keys: &[
        measured("color", COLOR, Given::Choice, LINEAR, "The same colour all round"),
        key("gradient", Kind::Object(&GRADIENT), Given::Choice, "Colours by height"),
        key(
            "image",
            Kind::File(PICTURE_FILES),
            Given::Choice,
            "A picture of all directions: HDR, EXR, PNG or JPEG",
        ),
        key("file", Kind::File(GRAPH_FILES), Given::Choice, "A graph with the root `environment`"),
        key(
            "intensity",
            Kind::Number(LIGHT),
            Given::Default("1"),
            "Factor on the colours of the `image`; with it only",
        ),
        measured(
            "rotation",
            Kind::Number(-3600.0..=3600.0),
            Given::Default("0"),
            DEGREES,
            "Turn of the `image` about the vertical; with it only",
        ),
        key("preset", Kind::Text, Given::Optional, "A preset of the graph `file`; with it only"),
        key(
            "set",
            Kind::Settings,
            Given::Default("{}"),
            "Values for parameters of the graph `file`; with it only",
        ),
    ],
    one_of: &["color", "gradient", "image", "file"],
};

/// A sky of three colours.
pub static GRADIENT: Section = Section {
    name: "gradient",
    what: "the gradient",
    keys: &[
        measured("zenith", COLOR, Given::Required, LINEAR, "Straight up, towards +y"),
        measured("horizon", COLOR, Given::Required, LINEAR, "At eye level"),
        measured("ground", COLOR, Given::Required, LINEAR, "Straight down"),
    ],
    one_of: &[],
};

/// How a scene is rendered.
pub static OPTIONS: Section = Section {
    name: "options",
    what: "`options`",
    keys: &[
        measured(
            "size",
            Kind::Several(&Kind::Whole(1..=65_536), 2..=2),
            Given::Default("[512, 512]"),
            "pixels",
            "Width and height of the picture; 67,108,864 pixels at most",
        ),
        key(
            "samples",
            Kind::Whole(1..=1_048_576),
            Given::Default("16"),
            "Rays from the camera for each pixel",
        ),
        key(
            "trace_depth",
            Kind::Either(&Kind::Whole(0..=32), &Kind::Several(&Kind::Whole(0..=64), 1..=3)),
            Given::Default("[6, 6, 6]"),
            "Most reflections on a path; or reflections and refractions, each 32 at most; or both and their sum",
        ),
        key(
            "seed",
            Kind::Whole(0..=u64::MAX as i128),
            Given::Default("0"),
            "Seed of all random numbers: the same seed, the same picture",
        ),
    ],
    one_of: &[],
};
