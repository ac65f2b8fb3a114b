//! The codes of findings, each with its story: the single source of `phenomenon explain`, of
//! `docs/diagnostics.md` and of the rules in SARIF output.

use std::fmt;

use super::Severity;

/// The stable code of a kind of finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Code(pub &'static str);

/// What there is to say about a code.
#[derive(Clone, Copy, Debug)]
pub struct Explanation {
    /// The code.
    pub code: Code,
    /// Severity of its findings.
    pub severity: Severity,
    /// Whether it tells of what could be left out, which editors grey.
    pub idle: bool,
    /// What it is, in a few words.
    pub title: &'static str,
    /// Why it is reported and what to do, in a paragraph.
    pub story: &'static str,
    /// A file, or a part of one, that has it.
    pub wrong: &'static str,
    /// The same mended.
    pub right: &'static str,
}

macro_rules! codes {
    (@idle idle) => { true };
    (@idle) => { false };
    ($($constant:ident $code:literal $severity:ident $($idle:ident)? $title:literal,
        $story:literal, wrong $wrong:literal, right $right:literal;)+) => {
        impl Code {
            $(#[doc = $title] pub const $constant: Code = Code($code);)+
        }

        impl Explanation {
            /// Every code, in the order of the documentation.
            pub const ALL: &'static [Explanation] = &[$(Explanation {
                code: Code::$constant,
                severity: Severity::$severity,
                idle: codes!(@idle $($idle)?),
                title: $title,
                story: $story,
                wrong: $wrong,
                right: $right,
            },)+];
        }
    };
}

impl Code {
    /// What there is to say about it; none for codes another crate made.
    pub fn explanation(self) -> Option<&'static Explanation> {
        Explanation::ALL.iter().find(|explanation| explanation.code == self)
    }

    /// The severity of its findings.
    pub fn severity(self) -> Severity {
        self.explanation().map_or(Severity::Error, |explanation| explanation.severity)
    }

    /// Whether its findings are of what could be left out.
    pub fn is_idle(self) -> bool {
        self.explanation().is_some_and(|explanation| explanation.idle)
    }

    /// The code of that name.
    pub fn from_name(name: &str) -> Option<Code> {
        Explanation::ALL.iter().map(|explanation| explanation.code).find(|code| code.0 == name)
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

codes! {
    UNREADABLE_FILE "unreadable-file" Error "A file that cannot be read",
        "The file does not exist, is a folder, or may not be read.",
        wrong "phenomenon check graphs/glas.json", right "phenomenon check graphs/glass.json";
    FILE_TOO_LARGE "file-too-large" Error "A file past the size limit",
        "Files are read whole, so their size is limited, and so is the number of values in them. Split a larger graph into phenomena that use one another.",
        wrong r#"forest.json: { … "nodes": { … 80 MB of trees … } … }"#,
        right r#"forest.json: { … "nodes": { "tree": { "type": { "file": "tree.json" } } … } … }"#;
    NOT_UTF8 "not-utf8" Error "A file that is not UTF-8",
        "JSON is UTF-8. Editors call it \"UTF-8 without BOM\".",
        wrong r#"… "doc": "caf<E9>" …   in Latin-1, where é is the byte E9"#,
        right r#"… "doc": "caf<C3><A9>" …   in UTF-8, where é is the bytes C3 A9"#;
    SYNTAX "syntax" Error "A file that is not JSON",
        "The file breaks the rules of JSON (RFC 8259), so nothing else can be said about it. All its mistakes are told in one run; where brackets do not come out even, indentation says which. There are no comments, no trailing commas and no single quotes.",
        wrong r#"{ "phenomenon": "a", "roots": { "material": [1, 0, 0], } }"#,
        right r#"{ "phenomenon": "a", "roots": { "material": [1, 0, 0] } }"#;
    TOO_DEEP "too-deep" Error "Nesting past the limit",
        "Lists and objects may be nested 64 deep. No graph or scene needs more than a dozen levels.",
        wrong r#"{ "phenomenon": "a", "roots": { "material": 1 }, "editor": [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]] }"#,
        right r#"{ "phenomenon": "a", "roots": { "material": 1 }, "editor": [] }"#;
    DUPLICATE_KEY "duplicate-key" Error "A key given twice",
        "JSON readers disagree on which of two equal keys counts, so none may stand twice in one object. Here the first is checked and the others are ignored.",
        wrong r#"{ "phenomenon": "a", "roots": { "material": [1, 0, 0], "material": [0, 1, 0] } }"#,
        right r#"{ "phenomenon": "a", "roots": { "material": [1, 0, 0] } }"#;
    UNKNOWN_KEY "unknown-key" Error "A key that has no meaning",
        "The object has a fixed set of keys, and this is none of them. Often it is misspelt, or belongs one level up or down.",
        wrong r#"{ "phenomenon": "a", "root": { "material": [1, 0, 0] }, "roots": { "material": 1 } }"#,
        right r#"{ "phenomenon": "a", "roots": { "material": [1, 0, 0] } }"#;
    MISSING_KEY "missing-key" Error "A key that must be given",
        "The object cannot be understood without this key.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "inputs": {} } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "add" } }, "roots": { "material": { "node": "n" } } }"#;
    WRONG_KIND "wrong-kind" Error "A value of the wrong kind",
        "The place takes another kind of JSON value: an object, a list, a string, a number, true or false.",
        wrong r#"{ "phenomenon": "a", "nodes": [], "roots": { "material": 1 } }"#,
        right r#"{ "phenomenon": "a", "nodes": {}, "roots": { "material": 1 } }"#;
    BAD_NAME "bad-name" Error "A name that cannot be used",
        "Names of phenomena, parameters and nodes are letters, digits, `_` and `-`, at most 256 characters, so that they can stand in paths such as `node.output` and on the command line.",
        wrong r#"{ "phenomenon": "a b", "roots": { "material": 1 } }"#,
        right r#"{ "phenomenon": "a_b", "roots": { "material": 1 } }"#;
    NUMBER_OUT_OF_RANGE "number-out-of-range" Error "A number past the limits",
        "The number lies outside the values that make sense in this place. Numbers are kept in 32 bits: scalars reach 3.4e38, integers 2147483647.",
        wrong r#"{ "phenomenon": "a", "version": -1, "roots": { "material": 1 } }"#,
        right r#"{ "phenomenon": "a", "version": 1, "roots": { "material": 1 } }"#;
    UNKNOWN_CHOICE "unknown-choice" Error "A word that is none of the choices",
        "The place takes one of a few words, and this is none of them.",
        wrong r#"{ "phenomenon": "a", "interface": { "p": { "type": "colour", "default": 1 } }, "roots": { "material": { "interface": "p" } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "p": { "type": "color", "default": 1 } }, "roots": { "material": { "interface": "p" } } }"#;
    EMPTY_RANGE "empty-range" Error "A range that holds nothing",
        "The minimum is above the maximum, or an enumeration lists no values, so the parameter could take no value at all.",
        wrong r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1, "min": 2, "max": 0 } }, "roots": { "material": { "interface": "p" } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1, "min": 0, "max": 2 } }, "roots": { "material": { "interface": "p" } } }"#;
    UNKNOWN_ROOT "unknown-root" Error "A root of a shader type that does not exist",
        "The keys of `roots` are mental ray's shader types.",
        wrong r#"{ "phenomenon": "a", "roots": { "matrial": 1 } }"#,
        right r#"{ "phenomenon": "a", "roots": { "material": 1 } }"#;
    NOT_A_GRAPH "not-a-graph" Error "A file that is no phenomenon",
        "A graph is an object with the key `phenomenon`, a scene one with the key `scene`. This file is the other of the two, or neither.",
        wrong r#"{ "nodes": {}, "roots": { "material": 1 } }"#,
        right r#"{ "phenomenon": "a", "nodes": {}, "roots": { "material": 1 } }"#;
    NOT_A_SCENE "not-a-scene" Error "A file that is no scene",
        "A scene is an object with the key `scene`, a graph one with the key `phenomenon`. This file is the other of the two, or neither.",
        wrong r#"{ "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0] }, "objects": [] }"#,
        right r#"{ "scene": "s", "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0] }, "objects": [] }"#;
    NEWER_FORMAT "newer-format" Error "A file of a newer format",
        "The file says by its key `format` that it is written for a format this program does not know yet, so nothing else is said about it. A newer version of the program reads it. Without the key a file has format 1.",
        wrong r#"{ "format": 2, "phenomenon": "a", "roots": { "material": 1 } }"#,
        right r#"{ "format": 1, "phenomenon": "a", "roots": { "material": 1 } }"#;
    UNUSABLE_FILE "unusable-file" Error "A mesh or picture that cannot be used",
        "A scene names a mesh or a picture that was found but is malformed, empty, or holds numbers that are not finite.",
        wrong r#"s.json: { … "objects": [{ "mesh": "teapot.blend", … }] … }"#,
        right r#"s.json: { … "objects": [{ "mesh": "teapot.obj", … }] … }"#;
    UNUSABLE_OBJECT "unusable-object" Error "A part of a scene that makes no sense",
        "The numbers are each in range, but together they give no camera, light, object or transform: a camera that looks at itself, a transform that flattens, a sphere scaled unevenly.",
        wrong r#"{ "scene": "s", "camera": { "position": [0, 0, 5], "look_at": [0, 0, 5] }, "objects": [] }"#,
        right r#"{ "scene": "s", "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0] }, "objects": [] }"#;
    FLAT_TRIANGLES "flat-triangles" Note "Triangles without area",
        "Some triangles of a mesh have their corners on one line, or in one place, exactly. No ray can meet them, so they are left out, and the picture is that of the others. Modelling programs leave such triangles behind; to be rid of them, merge vertices and dissolve what is degenerate before the mesh is saved.",
        wrong "mesh.obj: … f 1 2 3 … f 1 1 2 …",
        right "mesh.obj: … f 1 2 3 …";
    UNKNOWN_NODE_TYPE "unknown-node-type" Error "A node type that does not exist",
        "No node of this type is in the library. `phenomenon nodes` lists them all.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mixx" } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix" } }, "roots": { "material": { "node": "n" } } }"#;
    UNKNOWN_INPUT "unknown-input" Error "An input the node does not have",
        "The node type has no input of this name. `phenomenon nodes TYPE` lists its inputs.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix", "inputs": { "wieght": 1 } } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix", "inputs": { "weight": 1 } } }, "roots": { "material": { "node": "n" } } }"#;
    UNKNOWN_OUTPUT "unknown-output" Error "An output the node does not have",
        "The node that is referred to has no output of this name. Leave `output` out to take its first one.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix" } }, "roots": { "material": { "node": "n", "output": "color" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix" } }, "roots": { "material": { "node": "n", "output": "result" } } }"#;
    UNKNOWN_NODE "unknown-node" Error "A connection to a node that does not exist",
        "No node of this name stands under `nodes`.",
        wrong r#"{ "phenomenon": "a", "nodes": { "shade": { "type": "mix" } }, "roots": { "material": { "node": "shaed" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "shade": { "type": "mix" } }, "roots": { "material": { "node": "shade" } } }"#;
    UNKNOWN_PARAMETER "unknown-parameter" Error "A connection to an interface parameter that does not exist",
        "No parameter of this name stands under `interface`.",
        wrong r#"{ "phenomenon": "a", "roots": { "material": { "interface": "tint" } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "tint": { "type": "color", "default": [1, 0, 0] } }, "roots": { "material": { "interface": "tint" } } }"#;
    UNKNOWN_MEMBER "unknown-member" Error "A member the struct does not have",
        "The interface declares the struct with other members. Those that are not given have the defaults of their declarations.",
        wrong r#"{ "phenomenon": "a", "interface": { "look": { "type": "struct", "members": { "tint": { "type": "color", "default": 1 } }, "default": { "struct": { "tnit": 0.5 } } } }, "roots": { "material": { "interface": "look.tint" } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "look": { "type": "struct", "members": { "tint": { "type": "color", "default": 1 } }, "default": { "struct": { "tint": 0.5 } } } }, "roots": { "material": { "interface": "look.tint" } } }"#;
    TYPE_MISMATCH "type-mismatch" Error "A value of another type than the place takes",
        "An integer becomes a scalar, and a scalar a grey color, without being asked; any other change of type is a node of its own, so that the file says what is meant.",
        wrong r#"{ "phenomenon": "a", "nodes": { "s": { "type": "state" } }, "roots": { "material": { "node": "s", "output": "normal" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "s": { "type": "state" } }, "roots": { "material": { "node": "s", "output": "dot_nd" } } }"#;
    FIXED_INPUT "fixed-input" Error "What is known before shading, given by what is not",
        "Counts and choices are known before a point is shaded, because the code is made for their value: a loop runs that often, a choice leaves the others out. So a literal gives them, or a parameter that never leaves the range of the input, and no node.",
        wrong r#"{ "phenomenon": "a", "nodes": { "s": { "type": "state" }, "n": { "type": "perlin_noise", "inputs": { "octaves": { "node": "s", "output": "ray_type" } } } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "octaves": { "type": "integer", "default": 4, "min": 1, "max": 8 } }, "nodes": { "n": { "type": "perlin_noise", "inputs": { "octaves": { "interface": "octaves" } } } }, "roots": { "material": { "node": "n" } } }"#;
    EXPRESSION_SYNTAX "expression-syntax" Error "A text that is no expression",
        "The text breaks the grammar of expressions, which docs/expressions.md has; the finding points at the part that does. Powers are written `**`, equality `==`, and an expression is one value of at most 16,384 characters, nested at most 64 deep.",
        wrong r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "roots": { "material": { "expression": "2 * (p + 1" } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "roots": { "material": { "expression": "2 * (p + 1)" } } }"#;
    UNKNOWN_NAME "unknown-name" Error "A name in an expression that means nothing",
        "A name in an expression is one that `where` binds, a node, or a parameter; behind a `.` it is an output of the node, a member of the struct, or a component such as `x` or `rgb`.",
        wrong r#"{ "phenomenon": "a", "interface": { "tint": { "type": "scalar", "default": 1 } }, "roots": { "material": { "expression": "2 * tnit" } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "tint": { "type": "scalar", "default": 1 } }, "roots": { "material": { "expression": "2 * tint" } } }"#;
    AMBIGUOUS_NAME "ambiguous-name" Error "A name in an expression that is a node and a parameter",
        "Nodes and parameters may share a name, for a connection says which is meant. An expression says nothing but the name, so one of the two has to be bound to another under `where`.",
        wrong r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "nodes": { "p": { "type": "sine", "inputs": { "input": { "interface": "p" } } } }, "roots": { "material": { "expression": "2 * p" } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "nodes": { "p": { "type": "sine", "inputs": { "input": { "interface": "p" } } } }, "roots": { "material": { "expression": "2 * height", "where": { "height": { "node": "p" } } } } }"#;
    UNKNOWN_FUNCTION "unknown-function" Error "A function that does not exist",
        "Functions are the node types that evaluate each input once, and the names of docs/expressions.md, such as `sin` and `smoothstep`.",
        wrong r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "roots": { "material": { "expression": "sinus(p)" } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "roots": { "material": { "expression": "sin(p)" } } }"#;
    WRONG_ARGUMENTS "wrong-arguments" Error "A function with other arguments than it takes",
        "Arguments with a name, `low: 0`, are given to the input of that name. Those without have an order, which functions of docs/expressions.md declare and nodes of one or two inputs have by themselves; other nodes have their inputs in the order of demand, so that names are needed.",
        wrong r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "roots": { "material": { "expression": "clamp(p)" } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "roots": { "material": { "expression": "clamp(p, 0, 0.5)" } } }"#;
    UNUSED_NAME "unused-name" Warning idle "A name under where that nothing uses",
        "The expression does not use what is bound there, so it computes nothing.",
        wrong r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "roots": { "material": { "expression": "2 * p", "where": { "q": 3 } } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "roots": { "material": { "expression": "q * p", "where": { "q": 3 } } } }"#;
    CYCLE "cycle" Error "Nodes that feed themselves",
        "The value of each node on the path depends on itself, so none can be computed. The finding shows the whole path; break it at one of its connections.",
        wrong r#"{ "phenomenon": "a", "nodes": { "x": { "type": "add", "inputs": { "a": { "node": "y" } } }, "y": { "type": "add", "inputs": { "a": { "node": "x" } } } }, "roots": { "material": { "node": "x" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "x": { "type": "add", "inputs": { "a": { "node": "y" } } }, "y": { "type": "add", "inputs": { "a": 1 } } }, "roots": { "material": { "node": "x" } } }"#;
    MISSING_INPUT "missing-input" Error "An input that must be given",
        "The input has no default: give a literal, an interface parameter or a connection.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "perturb_normal" } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "perturb_normal", "inputs": { "normal": [0, 0, 1] } } }, "roots": { "material": { "node": "n" } } }"#;
    MISSING_ROOT "missing-root" Error "A phenomenon without a root",
        "A phenomenon is called through its roots; without one nothing of it can ever run.",
        wrong r#"{ "phenomenon": "a", "roots": {} }"#,
        right r#"{ "phenomenon": "a", "roots": { "material": [1, 0, 0] } }"#;
    NOT_FINITE "not-finite" Error "A number that is not finite",
        "Numbers are kept in 32 bits. This one is too large for them and would become infinite.",
        wrong r#"{ "phenomenon": "a", "roots": { "material": 1e39 } }"#,
        right r#"{ "phenomenon": "a", "roots": { "material": 1e38 } }"#;
    OUTSIDE_LIGHT_LOOP "outside-light-loop" Error "A sample read outside its loop",
        "The nodes `light` and `light_color`, and inputs that default to them, speak of the light sample a loop is at. They have a value only below the `body` input of a `light_loop`; so do `sample`, and nodes that draw a direction by it, below that of a `sample_loop`.",
        wrong r#"{ "phenomenon": "a", "nodes": { "c": { "type": "light_color" } }, "roots": { "material": { "node": "c" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "c": { "type": "light_color" }, "all": { "type": "light_loop", "inputs": { "body": { "node": "c" } } } }, "roots": { "material": { "node": "all" } } }"#;
    TOO_MANY_NODES "too-many-nodes" Error "A graph past the size limit",
        "The number of nodes is limited, those of nested phenomena included.",
        wrong r#"a.json: { … "nodes": { "x": { "type": { "file": "b.json" } }, "y": { "type": { "file": "b.json" } } … } … }   where b.json has 600000 nodes"#,
        right r#"a.json: { … "nodes": { "x": { "type": { "file": "b.json" } } … } … }"#;
    TOO_MANY_EVALUATIONS "too-many-evaluations" Error "A graph whose evaluations multiply",
        "What is shared between the inside and the outside of a scope is evaluated for each; scopes within scopes can double that again and again. A root may have 1,048,576 evaluations, copies included, and four light loops within one another, each over the light of the one outside. `check` tries every root with the values at hand.",
        wrong r#"a.json: { … "s2": { "type": "add", "inputs": { "a": { "node": "s1" }, "b": { "node": "inside_2" } } } … }   where inside_2 perturbs the normal of s1, and so on, twenty times over"#,
        right r#"a.json: { … "s2": { "type": "add", "inputs": { "a": { "node": "s0" }, "b": { "node": "inside_2" } } } … }"#;
    TOO_MANY_PARTS "too-many-parts" Error "An interface past the size limit",
        "Arrays and structs are taken apart: each part is a parameter of its own. An interface may have 65,536 of them in all.",
        wrong "\"default\": [0, 0, … 100,000 numbers … 0]", right "\"default\": [0, 0, … 100 numbers … 0]";
    UNKNOWN_PHENOMENON "unknown-phenomenon" Error "A phenomenon the file does not hold",
        "A node is to be a phenomenon that stands in the file, and none of that name stands under `phenomena`, nor round the phenomenon the node belongs to.",
        wrong r#"{ "phenomenon": "a", "phenomena": { "grey": { "outputs": { "value": { "type": "scalar", "from": 0.5 } } } }, "nodes": { "n": { "type": { "phenomenon": "gray" } } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "phenomena": { "grey": { "outputs": { "value": { "type": "scalar", "from": 0.5 } } } }, "nodes": { "n": { "type": { "phenomenon": "grey" } } }, "roots": { "material": { "node": "n" } } }"#;
    UNKNOWN_PRESET "unknown-preset" Error "A preset the graph does not have",
        "The scene names a preset, and none of that name stands under `presets` in the graph.",
        wrong r#"s.json: { … "material": { "file": "glass.json", "preset": "smokey" } … }"#,
        right r#"s.json: { … "material": { "file": "glass.json", "preset": "smoke" } … }"#;
    BAD_COLOR "bad-color" Error "A colour that cannot be read",
        "Colours of encoded spaces are `#` and three, four, six or eight hexadecimal digits, or three or four numbers of 0 to 1; those of linear spaces are numbers.",
        wrong r##"{ "phenomenon": "a", "roots": { "material": { "srgb": [1, 128, 0] } } }"##,
        right r##"{ "phenomenon": "a", "roots": { "material": { "srgb": "#ff8000" } } }"##;
    WRONG_LENGTH "wrong-length" Error "A list of the wrong length",
        "An array has the length its default has, so that every part of it is known before anything is evaluated. Where it is given, there must be as many values. A list with nothing in it has no value at all, and each value of a ramp has a position.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "sum", "inputs": { "values": [] } } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "sum", "inputs": { "values": [0.25, 0.5] } } }, "roots": { "material": { "node": "n" } } }"#;
    UNREACHABLE_NODE "unreachable-node" Warning idle "A node no root reaches",
        "No root reads the node, directly or through others, so it is never evaluated. Only the last node of an unused part is reported.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix" } }, "roots": { "material": 1 } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix" } }, "roots": { "material": { "node": "n" } } }"#;
    UNUSED_PHENOMENON "unused-phenomenon" Warning idle "A phenomenon no node is",
        "The phenomenon stands in the file, and nothing there uses it. Only the outermost of what is unused is reported.",
        wrong r#"{ "phenomenon": "a", "phenomena": { "grey": { "outputs": { "value": { "type": "scalar", "from": 0.5 } } } }, "roots": { "material": 1 } }"#,
        right r#"{ "phenomenon": "a", "phenomena": { "grey": { "outputs": { "value": { "type": "scalar", "from": 0.5 } } } }, "nodes": { "n": { "type": { "phenomenon": "grey" } } }, "roots": { "material": { "node": "n" } } }"#;
    UNUSED_PARAMETER "unused-parameter" Warning idle "A parameter nothing reads",
        "Setting the parameter changes nothing, because no node and no root reads it.",
        wrong r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "roots": { "material": 1 } }"#,
        right r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "roots": { "material": { "interface": "p" } } }"#;
    LITERAL_OUT_OF_RANGE "literal-out-of-range" Warning "A literal outside the range of its input",
        "The node declares the values it is made for. Outside of them it still yields the same bits everywhere, but what they mean is not promised.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix", "inputs": { "weight": 1.5 } } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix", "inputs": { "weight": 0.5 } } }, "roots": { "material": { "node": "n" } } }"#;
    RANGE_PAST_INPUT "range-past-input" Warning "A value that may leave the range of the input it feeds",
        "The range of a parameter is enforced where it is bound, but it is wider than what the node is made for; or what other nodes make of constants, parameters with ranges and the state surely comes to lie outside. It is reported only where a value outside is known to arrive: nothing is said of what is made from parameters without `min` and `max`, of values whose parts depend on one another, or of what is evaluated under a condition on the same values.",
        wrong r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 0.5, "min": 0, "max": 2 } }, "nodes": { "n": { "type": "mix", "inputs": { "weight": { "interface": "p" } } } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 0.5, "min": 0, "max": 1 } }, "nodes": { "n": { "type": "mix", "inputs": { "weight": { "interface": "p" } } } }, "roots": { "material": { "node": "n" } } }"#;
    DEAD_INPUT "dead-input" Note idle "A connection that is never evaluated",
        "The inputs that decide whether this one is needed rule it out: the mix has weight 0, the condition is always true. They are constants, or computed from constants, from parameters whose range leaves no choice (ranges are enforced where parameters are bound) and from what the state can be. What is connected here costs nothing and shows nowhere.",
        wrong r#"{ "phenomenon": "a", "nodes": { "t": { "type": "trace_reflection" }, "n": { "type": "mix", "inputs": { "weight": 0, "b": { "node": "t" } } } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "t": { "type": "trace_reflection" }, "n": { "type": "mix", "inputs": { "weight": 0.5, "b": { "node": "t" } } } }, "roots": { "material": { "node": "n" } } }"#;
    CONFLICTING_REQUIREMENTS "conflicting-requirements" Error "Requirements that cannot both hold",
        "Requirements of the file, of its nodes and of the phenomena it uses are joined before rendering. Two of them contradict each other; the finding names both.",
        wrong r#"{ "phenomenon": "a", "requires": { "trace": "off" }, "nodes": { "t": { "type": "trace_reflection" } }, "roots": { "material": { "node": "t" } } }"#,
        right r#"{ "phenomenon": "a", "requires": { "trace": "on" }, "nodes": { "t": { "type": "trace_reflection" } }, "roots": { "material": { "node": "t" } } }"#;
    VERSION_MISMATCH "version-mismatch" Error "Another version than the one asked for",
        "A node may say which version of its type it was made for; 0, or nothing, asks for none. The nodes of the library have version 1, a phenomenon the `version` its file gives.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix", "version": 2 } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix", "version": 1 } }, "roots": { "material": { "node": "n" } } }"#;
    RECURSION "recursion" Error "A phenomenon that is a part of itself",
        "A phenomenon is expanded in the place of the node that uses it, so none may use itself, directly or through other files. The finding shows the way through the files. Files may be nested 32 deep.",
        wrong r#"a.json: { … "nodes": { "n": { "type": { "file": "a.json" } } } … }"#,
        right r#"a.json: { … "nodes": { "n": { "type": { "file": "b.json" } } } … }"#;
    DEGREES "degrees" Warning "An angle that is probably in degrees",
        "Angles of functions are in radians and hues in turns, and the number is one that people write for degrees, or a parameter is in another unit than the input it is connected to. The message names the value it should be.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "sine", "inputs": { "input": 90 } } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "sine", "inputs": { "input": 1.5707964 } } }, "roots": { "material": { "node": "n" } } }"#;
    PERCENT "percent" Warning "A share that is probably in percent",
        "Weights, shares and saturations are 0 to 1, and the number is a whole one from 10 to 100.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix", "inputs": { "weight": 50, "a": 0.2, "b": 0.8 } } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "mix", "inputs": { "weight": 0.5, "a": 0.2, "b": 0.8 } } }, "roots": { "material": { "node": "n" } } }"#;
    EIGHT_BIT_COLOR "eight-bit-color" Warning "A color that probably counts up to 255",
        "Colours are scene-linear, and those of surfaces 0 to 1. Whole numbers of up to 255 come from programs that show encoded colours: dividing them by 255 is not enough, they are to be decoded. Lights, which may be as bright as they like, are not told of.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "light_loop", "inputs": { "body": { "node": "lit" } } }, "lit": { "type": "lambert", "inputs": { "color": [255, 128, 0] } } }, "roots": { "material": { "node": "n" } } }"#,
        right r##"{ "phenomenon": "a", "nodes": { "n": { "type": "light_loop", "inputs": { "body": { "node": "lit" } } }, "lit": { "type": "lambert", "inputs": { "color": { "srgb": "#ff8000" } } } }, "roots": { "material": { "node": "n" } } }"##;
    NUMERIC_HAZARD "numeric-hazard" Warning "A number that means nothing where it arrives",
        "A constant, the range of a parameter, or what other nodes surely make of such lets a node divide by zero or raise a negative number to a power. The result is defined, and the same in every engine, but hardly what is wanted. A node evaluated under a condition on the same values, as in `select` with `less`, is not reported.",
        wrong r#"{ "phenomenon": "a", "nodes": { "n": { "type": "divide", "inputs": { "b": 0 } } }, "roots": { "material": { "node": "n" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "n": { "type": "divide", "inputs": { "b": 2 } } }, "roots": { "material": { "node": "n" } } }"#;
    UNKNOWN_LIGHT "unknown-light" Error "A light the scene does not have",
        "A graph, or a `set` of a scene, names lights of the scene that uses it. A name that is none of them would light nothing. The finding is shown where the name is written, with the scene that lacks it. Checking a graph alone cannot find it: which lights there are is a matter of the scene.",
        wrong r#"scene.json: { … "lights": [{ "name": "key", … }], "objects": [{ … "set": { "lights": ["kye"] } }] }"#,
        right r#"scene.json: { … "lights": [{ "name": "key", … }], "objects": [{ … "set": { "lights": ["key"] } }] }"#;
    MISPLACED_EFFECT "misplaced-effect" Error "An effect its shader type does not allow",
        "Each shader type is called at a moment of its own. A displacement runs before there is a scene, an output shader on finished pixels, a light shader while a light loop asks it: not every ray can be cast and not every light asked then.",
        wrong r#"{ "phenomenon": "a", "nodes": { "t": { "type": "trace_reflection" } }, "roots": { "displacement": { "node": "t", "output": "distance" } } }"#,
        right r#"{ "phenomenon": "a", "nodes": { "t": { "type": "trace_reflection" } }, "roots": { "material": { "node": "t" } } }"#;
}
