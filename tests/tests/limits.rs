//! Every limit, met: what is just past it is refused by name. `docs/limits.md` is this list.
//!
//! `PHENOMENON_BLESS=1 cargo test --workspace --test limits` writes it anew.

#[path = "limits/pictures.rs"]
mod pictures;
#[path = "limits/reports.rs"]
mod reports;
#[path = "limits/turns.rs"]
mod turns;

use std::fmt::Write;
use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::check::{
    Checked, MAX_FILE_DEPTH, MAX_INNER, MAX_NAME, MAX_NODES, MAX_OUTPUTS, MAX_PARTS, MAX_SHADERS,
    MAX_TURNS, check_graph, read_graph_file,
};
use phenomenon_compiler::diagnostics::grouped;
use phenomenon_compiler::document::{
    MAX_DEPTH, MAX_EXPRESSION, MAX_EXPRESSION_DEPTH, MAX_FILE_BYTES, MAX_VALUES, read,
};
use phenomenon_compiler::engine::{Engine, Options, Shader};
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::show::{MAX_BOXES, draw_svg};
use phenomenon_compiler::specialise::{MAX_INSTANCES, MAX_NESTED_LOOPS};
use phenomenon_runtime::film::{PIXEL_LIMIT, SIDE_LIMIT};
use phenomenon_runtime::geometry::{CONCAVE_CORNERS_LIMIT, COORDINATE_LIMIT, OBJ_BYTES_LIMIT};
use phenomenon_runtime::render::SAMPLE_LIMIT;
use phenomenon_runtime::scene::DEPTH_LIMIT;
use phenomenon_runtime::scene_file::read_scene;

/// A limit: what is limited, the most there may be, what is said past it, and a proof of it: what
/// is said of something just past the limit, in a folder to put files in.
pub struct Limit {
    what: &'static str,
    most: u64,
    said: &'static str,
    past: fn(&Path) -> String,
}

const fn limit(
    what: &'static str,
    most: u64,
    said: &'static str,
    past: fn(&Path) -> String,
) -> Limit {
    Limit { what, most, said, past }
}

const GRAPHS: [Limit; 16] = [
    limit("bytes of a graph or a scene", MAX_FILE_BYTES as u64, "`file-too-large`", huge_file),
    limit("values in a file", MAX_VALUES as u64, "`file-too-large`", many_values),
    limit("nesting of lists and objects", MAX_DEPTH as u64, "`too-deep`", deep_nesting),
    limit("characters of a name", MAX_NAME as u64, "`bad-name`", long_name),
    limit(
        "characters of an expression",
        MAX_EXPRESSION as u64,
        "`expression-syntax`",
        long_expression,
    ),
    limit(
        "nesting of brackets, signs and choices in an expression",
        MAX_EXPRESSION_DEPTH as u64,
        "`expression-syntax`",
        deep_expression,
    ),
    limit(
        "nodes, those of nested phenomena included",
        MAX_NODES as u64,
        "`too-many-nodes`",
        doubling_nests,
    ),
    limit(
        "parts of an interface, each element of an array one",
        MAX_PARTS as u64,
        "`too-many-parts`",
        long_array,
    ),
    limit(
        "shaders in the list of a root",
        MAX_SHADERS as u64,
        "`number-out-of-range`",
        many_shaders,
    ),
    limit("outputs of a phenomenon", MAX_OUTPUTS as u64, "`too-many-parts`", many_outputs),
    limit("phenomena within a file", MAX_INNER as u64, "`too-many-parts`", many_phenomena),
    limit(
        "turns of the maps and folds of a file",
        MAX_TURNS as u64,
        "`too-many-nodes`",
        turns::many_turns,
    ),
    limit("phenomena within one another", MAX_FILE_DEPTH as u64, "`recursion`", deep_files),
    limit(
        "evaluations of one root, copies in nested scopes included",
        MAX_INSTANCES as u64,
        "an error when compiled",
        doubling_scopes,
    ),
    limit(
        "light loops within one another, each over the light of the one outside",
        MAX_NESTED_LOOPS as u64,
        "an error when compiled",
        nested_loops,
    ),
    limit(
        "boxes of an SVG by `show`: parameters, nodes and roots",
        MAX_BOXES as u64,
        "an error; DOT has no limit",
        many_boxes,
    ),
];

const SCENES: [Limit; 7] = [
    limit("bytes of a mesh", OBJ_BYTES_LIMIT, "`file-too-large`", huge_mesh),
    limit(
        "corners of a concave face of a mesh",
        CONCAVE_CORNERS_LIMIT as u64,
        "`unusable-file`",
        large_face,
    ),
    limit("coordinates and lengths", FAR_AWAY, "`number-out-of-range`", far_away),
    limit(
        "pixels on a side of a picture",
        SIDE_LIMIT as u64,
        "`number-out-of-range`",
        wide_picture,
    ),
    limit("pixels of a picture", PIXEL_LIMIT, "`number-out-of-range`", large_picture),
    limit("samples of a pixel", SAMPLE_LIMIT as u64, "`number-out-of-range`", many_samples),
    limit(
        "reflections, or refractions, in a row",
        DEPTH_LIMIT as u64,
        "`number-out-of-range`",
        deep_rays,
    ),
];

/// `COORDINATE_LIMIT` before it is rounded to 32 bits.
const FAR_AWAY: u64 = 1_000_000_000_000;

#[test]
fn what_is_past_a_limit_is_refused() {
    for (at, limit) in
        GRAPHS.iter().chain(&SCENES).chain(&pictures::LIMITS).chain(&reports::LIMITS).enumerate()
    {
        let folder = tempfile::tempdir().unwrap();
        let said = (limit.past)(folder.path());
        assert_eq!(said, limit.said, "{at}: {}", limit.what);
    }
}

#[test]
fn the_page_of_limits_is_in_sync() {
    let mut page = String::from(
        "# Limits\n\n\
         No file can crash the program, hang it or use up the memory. What is past a limit is \
         refused, and said so. This page is made by `tests/tests/limits.rs`, which goes past each.\n",
    );
    let sections = [
        ("Graphs", &GRAPHS[..]),
        ("Scenes", &SCENES[..]),
        ("Pictures that are read", &pictures::LIMITS[..]),
        ("What is told of a file", &reports::LIMITS[..]),
    ];
    for (title, limits) in sections {
        write!(page, "\n## {title}\n\n| what | most | past it |\n| --- | ---: | --- |\n").unwrap();
        for Limit { what, most, said, .. } in limits {
            writeln!(page, "| {what} | {} | {said} |", grouped(*most)).unwrap();
        }
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/limits.md");
    if std::env::var_os("PHENOMENON_BLESS").is_some() {
        std::fs::write(&path, &page).unwrap();
    }
    let checked_in = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(checked_in == page, "docs/limits.md differs; write it anew as this file says:\n{page}");
}

fn check(text: &str) -> Checked {
    match read("limit.json", text.as_bytes()) {
        Ok(document) => check_graph(&document, &NodeLibrary::standard()),
        Err(finding) => Checked { findings: vec![*finding], ..Checked::default() },
    }
}

/// The code of the one finding.
fn code(checked: &Checked) -> String {
    let [finding] = checked.findings.as_slice() else {
        let found: Vec<String> = checked.findings.iter().map(ToString::to_string).collect();
        panic!("{}", found.join("\n"))
    };
    assert!(checked.graph.is_none());
    format!("`{}`", finding.code)
}

fn graph(text: &str) -> Graph {
    let checked = check(text);
    checked.graph.unwrap_or_else(|| panic!("{:?}", checked.findings.first()))
}

fn phenomenon(nodes: &str, material: &str) -> String {
    format!(r#"{{"phenomenon":"p","nodes":{{{nodes}}},"roots":{{"material":{material}}}}}"#)
}

/// A sparse file: nothing of it is on the disk, and nothing of it is read.
fn sparse(path: &Path, bytes: u64) {
    File::create(path).unwrap().set_len(bytes).unwrap();
}

fn huge_file(folder: &Path) -> String {
    let path = folder.join("huge.json");
    sparse(&path, MAX_FILE_BYTES as u64 + 1);
    code(&read_graph_file(&path, &NodeLibrary::standard()))
}

fn many_values(_: &Path) -> String {
    // The file itself, what stands under `editor`, the list, its elements and the three others.
    let with = |elements: usize| {
        let list = vec!["0"; elements].join(",");
        format!(r#"{{"phenomenon":"p","editor":[{list}],"roots":{{"material":1}}}}"#)
    };
    code(&check(&with(MAX_VALUES)))
}

fn deep_nesting(_: &Path) -> String {
    let with = |depth: usize| {
        let list = format!("{}{}", "[".repeat(depth), "]".repeat(depth));
        format!(r#"{{"phenomenon":"p","editor":{list},"roots":{{"material":1}}}}"#)
    };
    graph(&with(MAX_DEPTH - 1));
    code(&check(&with(MAX_DEPTH)))
}

fn long_name(_: &Path) -> String {
    let with = |length: usize| {
        format!(r#"{{"phenomenon":"{}","roots":{{"material":1}}}}"#, "é".repeat(length))
    };
    graph(&with(MAX_NAME));
    code(&check(&with(MAX_NAME + 1)))
}

fn expression(text: &str) -> Checked {
    check(&phenomenon("", &format!(r#"{{"expression":"{text}"}}"#)))
}

fn long_expression(_: &Path) -> String {
    // Every character of a sum is a sign or a number.
    let with = |length: usize| format!("1{}", "+1".repeat(length / 2));
    assert!(expression(&with(MAX_EXPRESSION - 2)).graph.is_some());
    code(&expression(&with(MAX_EXPRESSION)))
}

fn deep_expression(_: &Path) -> String {
    let with = |depth: usize| format!("{}1{}", "(".repeat(depth), ")".repeat(depth));
    // The expression itself is one of them.
    assert!(expression(&with(MAX_EXPRESSION_DEPTH - 1)).graph.is_some());
    assert_eq!(code(&expression(&"(".repeat(1_000_000))), "`expression-syntax`");
    code(&expression(&with(MAX_EXPRESSION_DEPTH)))
}

/// Phenomena of two of the next one: twenty files, a million nodes and more.
fn doubling_nests(folder: &Path) -> String {
    let levels = MAX_NODES.ilog2();
    for level in 0..=levels {
        let nodes = if level == levels {
            r#""x":{"type":"state"},"n":{"type":"add","inputs":{"a":{"node":"x","output":"u"}}}"#
                .to_owned()
        } else {
            let inner = format!(r#"{{"type":{{"file":"{}.json"}}}}"#, level + 1);
            let sum = r#"{"type":"add","inputs":{"a":{"node":"x"},"b":{"node":"y"}}}"#;
            format!(r#""x":{inner},"y":{inner},"n":{sum}"#)
        };
        let text = phenomenon(&nodes, r#"{"node":"n"}"#);
        std::fs::write(folder.join(format!("{level}.json")), text).unwrap();
    }
    code(&read_graph_file(&folder.join("0.json"), &NodeLibrary::standard()))
}

fn long_array(_: &Path) -> String {
    let with = |length: usize| {
        let zeros = vec!["0"; length].join(",");
        let parameter =
            format!(r#"{{"type":"array","of":{{"type":"scalar"}},"default":[{zeros}]}}"#);
        let nodes = r#""s":{"type":"sum","inputs":{"values":{"interface":"p"}}}"#;
        phenomenon(nodes, r#"{"node":"s"}"#).replacen(
            "{",
            &format!(r#"{{"interface":{{"p":{parameter}}},"#),
            1,
        )
    };
    graph(&with(100));
    code(&check(&with(MAX_PARTS + 1)))
}

fn many_phenomena(_: &Path) -> String {
    let with = |count: usize| {
        let offers = r#"{ "outputs": { "x": { "type": "scalar", "from": 1 } } }"#;
        let phenomena: Vec<String> = (0..count).map(|at| format!(r#""p{at}": {offers}"#)).collect();
        let nodes: Vec<String> = (0..count)
            .map(|at| format!(r#""n{at}": {{ "type": {{ "phenomenon": "p{at}" }} }}"#))
            .collect();
        let values: Vec<String> =
            (0..count).map(|at| format!(r#"{{ "node": "n{at}" }}"#)).collect();
        format!(
            r#"{{ "phenomenon": "p", "phenomena": {{ {} }},
                 "nodes": {{ {}, "all": {{ "type": "sum", "inputs": {{ "values": [{}] }} }} }},
                 "roots": {{ "material": {{ "node": "all" }} }} }}"#,
            phenomena.join(", "),
            nodes.join(", "),
            values.join(", ")
        )
    };
    graph(&with(MAX_INNER));
    code(&check(&with(MAX_INNER + 1)))
}

fn many_outputs(_: &Path) -> String {
    let with = |count: usize| {
        let outputs: Vec<String> = (0..count)
            .map(|at| format!(r#""o{at}": {{ "type": "scalar", "from": {at} }}"#))
            .collect();
        format!(r#"{{ "phenomenon": "p", "outputs": {{ {} }} }}"#, outputs.join(", "))
    };
    graph(&with(MAX_OUTPUTS));
    code(&check(&with(MAX_OUTPUTS + 1)))
}

fn many_shaders(_: &Path) -> String {
    let with = |count: usize| {
        let shaders = vec![r#"{"node":"n"}"#; count].join(",");
        phenomenon(r#""n":{"type":"mix"}"#, &format!("[{shaders}]"))
    };
    graph(&with(MAX_SHADERS));
    code(&check(&with(MAX_SHADERS + 1)))
}

fn deep_files(folder: &Path) -> String {
    for depth in 0..=MAX_FILE_DEPTH {
        let nodes = if depth == MAX_FILE_DEPTH {
            r#""n":{"type":"mix"}"#.to_owned()
        } else {
            format!(r#""n":{{"type":{{"file":"{}.json"}}}}"#, depth + 1)
        };
        let text = phenomenon(&nodes, r#"{"node":"n"}"#);
        std::fs::write(folder.join(format!("{depth}.json")), text).unwrap();
    }
    let library = NodeLibrary::standard();
    assert!(read_graph_file(&folder.join("1.json"), &library).graph.is_some());
    code(&read_graph_file(&folder.join("0.json"), &library))
}

/// What compiling a graph says.
fn compiled(graph: Graph) -> Result<Shader, String> {
    let options = Options { engine: Engine::Batch, ..Options::default() };
    Shader::new(Arc::new(graph), &[], options).map_err(|error| error.to_string())
}

/// Every level holds what is below twice: inside a scope and outside.
fn doubling_scopes(_: &Path) -> String {
    let with = |levels: u32| {
        let mut nodes = String::from(r#""s0":{"type":"state"}"#);
        for level in 1..=levels {
            let inner = match level {
                1 => r#"{"node":"s0","output":"dot_nd"}"#.to_owned(),
                _ => format!(r#"{{"node":"s{}"}}"#, level - 1),
            };
            let scope = r#""type":"perturb_normal","inputs":{"normal":[0.6,0,0.8],"input""#;
            let sum = format!(r#""type":"add","inputs":{{"a":{inner},"b":{{"node":"b{level}"}}}}"#);
            write!(nodes, r#","b{level}":{{{scope}:{inner}}}}},"s{level}":{{{sum}}}"#).unwrap();
        }
        graph(&phenomenon(&nodes, &format!(r#"{{"node":"s{levels}"}}"#)))
    };
    let levels = MAX_INSTANCES.ilog2();
    assert!(compiled(with(levels / 2)).is_ok());
    let error = compiled(with(levels)).err().unwrap();
    assert!(error.contains(&MAX_INSTANCES.to_string()), "{error}");
    "an error when compiled".to_owned()
}

/// Loops in loops, each under a normal that the light of the one outside gives.
fn nested_loops(_: &Path) -> String {
    let with = |loops: usize| {
        let mut nodes = String::from(r#""b1":{"type":"lambert"},"light":{"type":"light"}"#);
        for at in 1..=loops {
            let body = format!(r#"{{"body":{{"node":"b{at}"}}}}"#);
            write!(nodes, r#","l{at}":{{"type":"light_loop","inputs":{body}}}"#).unwrap();
            if at < loops {
                let normal = r#""normal":{"node":"light","output":"direction"}"#;
                let inputs = format!(r#"{{{normal},"input":{{"node":"l{at}"}}}}"#);
                let next = at + 1;
                write!(nodes, r#","b{next}":{{"type":"perturb_normal","inputs":{inputs}}}"#)
                    .unwrap();
            }
        }
        compiled(graph(&phenomenon(&nodes, &format!(r#"{{"node":"l{loops}"}}"#))))
    };
    assert!(with(MAX_NESTED_LOOPS).is_ok());
    let error = with(MAX_NESTED_LOOPS + 1).err().unwrap();
    assert!(error.contains("light loops"), "{error}");
    "an error when compiled".to_owned()
}

fn many_boxes(_: &Path) -> String {
    let with = |nodes: usize| {
        let mut text = String::from(r#""n0":{"type":"state"}"#);
        let mut last = r#"{"node":"n0","output":"u"}"#.to_owned();
        for at in 1..nodes {
            write!(text, r#","n{at}":{{"type":"negate","inputs":{{"input":{last}}}}}"#).unwrap();
            last = format!(r#"{{"node":"n{at}"}}"#);
        }
        draw_svg(&graph(&phenomenon(&text, &last)))
    };
    // One box is the root.
    with(MAX_BOXES - 1).unwrap();
    assert!(with(MAX_BOXES).unwrap_err().to_string().contains("boxes"));
    "an error; DOT has no limit".to_owned()
}

const CAMERA: &str = r#""camera":{"position":[0,0,5],"look_at":[0,0,0]}"#;

/// The code of the one finding in a scene of those objects and options.
fn scene(folder: &Path, objects: &str, options: &str) -> Option<String> {
    let text = format!(r#"{{"scene":"s",{CAMERA},"objects":[{objects}],"options":{{{options}}}}}"#);
    let file = read_scene("scene.json", text.as_bytes(), folder);
    match file.findings.as_slice() {
        [] => None,
        [finding] => Some(format!("`{}`", finding.code)),
        findings => panic!("{findings:?}"),
    }
}

/// What is said of an option past its limit, where it is fine at its limit.
fn option(folder: &Path, at: &str, past: &str) -> String {
    assert_eq!(scene(folder, "", at), None);
    scene(folder, "", past).unwrap()
}

fn huge_mesh(folder: &Path) -> String {
    sparse(&folder.join("huge.obj"), OBJ_BYTES_LIMIT + 1);
    let object = r#"{"mesh":"huge.obj","material":{"subject":true}}"#;
    scene(folder, object, "").unwrap()
}

fn large_face(folder: &Path) -> String {
    let with = |corners: usize| {
        // A comb: its teeth stand on the line below.
        let vertex = |at: usize| match at {
            0 | 1 => format!("v {} -1 0\n", if at == 0 { 0 } else { corners }),
            at => format!("v {} {} 0\n", corners - at, at % 2),
        };
        let vertices: String = (0..corners).map(vertex).collect();
        let indices: String = (1..=corners).map(|at| format!(" {at}")).collect();
        std::fs::write(folder.join("comb.obj"), format!("{vertices}f{indices}\n")).unwrap();
        scene(folder, r#"{"mesh":"comb.obj","material":{"subject":true}}"#, "")
    };
    assert_eq!(with(CONCAVE_CORNERS_LIMIT), None);
    with(CONCAVE_CORNERS_LIMIT + 1).unwrap()
}

fn far_away(folder: &Path) -> String {
    let with = |x: f64| {
        let sphere = format!(r#"{{"center":[{x:e},0,0],"radius":1}}"#);
        let object = format!(r#"{{"sphere":{sphere},"material":{{"subject":true}}}}"#);
        scene(folder, &object, "")
    };
    assert_eq!(FAR_AWAY as f32, COORDINATE_LIMIT);
    assert_eq!(with(FAR_AWAY as f64), None);
    with(FAR_AWAY as f64 * 1.001).unwrap()
}

fn wide_picture(folder: &Path) -> String {
    let size = |width: u32| format!(r#""size":[{width},1]"#);
    option(folder, &size(SIDE_LIMIT), &size(SIDE_LIMIT + 1))
}

fn large_picture(folder: &Path) -> String {
    let side = PIXEL_LIMIT.isqrt();
    option(
        folder,
        &format!(r#""size":[{side},{side}]"#),
        &format!(r#""size":[{side},{}]"#, side + 1),
    )
}

fn many_samples(folder: &Path) -> String {
    let samples = |count: u32| format!(r#""samples":{count}"#);
    option(folder, &samples(SAMPLE_LIMIT), &samples(SAMPLE_LIMIT + 1))
}

fn deep_rays(folder: &Path) -> String {
    let depth = |depth: i32| format!(r#""trace_depth":[{depth},0]"#);
    option(folder, &depth(DEPTH_LIMIT), &depth(DEPTH_LIMIT + 1))
}
