//! OBJ files as they are found.

use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::diagnostics::{Code, Severity};
use phenomenon_runtime::geometry::{
    CONCAVE_CORNERS_LIMIT, Mesh, Normals, ObjFault, ObjMesh, parse_obj, read_obj,
};
use phenomenon_runtime::scene_file::{SceneFile, ShapeDescription, read_scene};

use crate::shaders::Numbers;

const SQUARE: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

fn read(text: impl AsRef<[u8]>) -> ObjMesh {
    let text = text.as_ref();
    parse_obj(text, Normals::Smooth)
        .unwrap_or_else(|error| panic!("{error:?}\n{}", String::from_utf8_lossy(text)))
}

/// Position, surface coordinates and normal.
type Corner = ([f32; 3], Option<[f32; 2]>, Option<[f32; 3]>);

/// The corners of all triangles, with what they have.
fn corners(mesh: &Mesh) -> Vec<[Corner; 3]> {
    let corner = |vertex: u32| {
        let at = vertex as usize;
        (mesh.positions[at], mesh.uvs.get(at).copied(), mesh.normals.get(at).copied())
    };
    mesh.triangles.iter().map(|triangle| triangle.map(corner)).collect()
}

#[test]
fn legal_lines_are_read() {
    let plain = read(format!("{SQUARE}f 1 2 3 4\n"));
    assert_eq!(plain.mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
    for text in [
        "v -1 -1 0 # corner\nv 1 -1 0#\nv 1 1 0 # \\\nv -1 1 0\nf 1 2 3 4 # all".to_owned(),
        format!("\u{feff}{SQUARE}f 1 2 3 4"),
        format!("{SQUARE}f 1 2 \\\n 3 4\n"),
        format!("{SQUARE}f 1\\\n2\\\n\\\n3 4 \\"),
        format!("{SQUARE}f 1 2 3 4").replace('\n', "\r\n"),
        format!("{SQUARE}f 1 2 3 4").replace('\n', "\r"),
        format!("{SQUARE}f 1 2 3 4").replace(' ', "\t "),
        format!("{SQUARE}f -4 -3 -2 -1\nv 9 9 9\n"),
        format!("f 1 2 3 4\n{SQUARE}"),
        format!("{SQUARE}fo 1// 2/ 3 4\n"),
        format!("g a b\\\no caf\u{e9}\ns off\n{SQUARE}mtllib x.mtl\nusemtl C:\\\nf 1 2 3 4\ns 1"),
        format!("{SQUARE}p 1 2\nl 1 2 3\nvp 1 2\ncstype bezier\ndeg 3\ncurv 0 1 1 2\nend\nf 1 2 3 4"),
        // A weight, a weight and a colour, a number of fourteen digits.
        "v -1 -1 0 1\nv 1 -1 0 nan 0.5 0.5 0.5\nv 1.0000000000001 1 0 1 nan 0 0\nv -1e0 +1. .0\nf 1 2 3 4"
            .to_owned(),
        // A corner twice in a row is once.
        format!("{SQUARE}v -1 -1 0\nf 1 2 2 3 4 4 5"),
        format!("{SQUARE}Xgrids of another program\nf 1 2 3 4"),
    ] {
        assert_eq!(read(&text).mesh, plain.mesh, "{text}");
    }
    let mut latin = b"# caf\xe9\ng caf\xe9\n".to_vec();
    latin.extend(format!("{SQUARE}f 1 2 3 4").into_bytes());
    assert_eq!(read(&latin).mesh, plain.mesh);
}

#[test]
fn positions_of_six_numbers_have_colours() {
    let text = "v -1 -1 0\nv 1 -1 0 0.5 0.25 2\nv 1 1 0\nv -1 1 0 0 -1 0\nv 9 9 9\nf 1 2 3 4";
    let mesh = read(text).mesh;
    assert_eq!(mesh.colors, [[1.0; 3], [0.5, 0.25, 2.0], [1.0; 3], [0.0, -1.0, 0.0]]);
    // Where a vertex becomes two, both have its colour.
    let mixed = "v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1 2 3\nf 3 1 4\nf 1/1 2/1 4/1";
    let mesh = read(mixed).mesh;
    assert_eq!(mesh.colors.len(), mesh.positions.len());
    for (position, color) in mesh.positions.iter().zip(&mesh.colors) {
        let red = *position == [0.0; 3];
        assert_eq!(*color, if red { [1.0, 0.0, 0.0] } else { [1.0; 3] });
    }
    let refused = parse_obj(b"v 0 0 0 1 nan 0\n", Normals::Smooth).unwrap_err();
    assert_eq!(refused, (Some(1), ObjFault::NotFinite("nan".into())));
}

#[test]
fn surface_coordinates_have_one_two_or_three_numbers() {
    let text = format!("{SQUARE}vt 0.25\nvt 1 0.5\nvt 1 1 7\nf 1/1 2/2 3/3 4/1\n");
    let mesh = read(text).mesh;
    assert_eq!(mesh.uvs, [[0.25, 0.0], [1.0, 0.5], [1.0, 1.0], [0.25, 0.0]]);
}

#[test]
fn numbers_are_rounded_once() {
    let text = |x: &str| format!("v {x} 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3");
    // A trifle above the middle of two numbers of 32 bits; by way of 64 bits it would become 1.
    let above = "1.00000005960464477539062500000000000001";
    for (written, exact) in
        [(above, 1f32.next_up()), ("0.1", 0.1), ("1e-45", f32::from_bits(1)), ("-1E12", -1e12)]
    {
        assert_eq!(
            read(text(written)).mesh.positions[0][0].to_bits(),
            exact.to_bits(),
            "{written}"
        );
    }
}

#[test]
fn what_is_refused_is_named_by_its_line() {
    let square = |rest: &str| format!("{SQUARE}{rest}");
    let cases = [
        (square("v nan 0 0\nf 1 2 3"), 5, "`nan` is no finite"),
        (square("v 0 -inf 0\nf 1 2 3"), 5, "`-inf` is no finite"),
        (square("\n# a\nvt 0 1e999\nf 1 2 3"), 7, "`1e999` is no finite"),
        (square("vn 0 -1.#IND 0\nf 1 2 3"), 5, "`-1.#IND` is no finite"),
        (square("vt nan(ind)\nf 1 2 3"), 5, "`nan(ind)` is no finite"),
        (square("vn 0 1 \\\n x\nf 1 2 3"), 6, "`x` is no number"),
        (square("vt 0,5 1\nf 1 2 3"), 5, "`0,5` is no number"),
        (square("v 1e13 0 0\nf 1 2 3"), 5, "past the limit"),
        (square("v 1 2 3 red\nf 1 2 3"), 5, "`red` is no number"),
        (square("v 1 2\nf 1 2 3"), 5, "`v` needs 3 numbers and has 2"),
        (square("vt\nf 1 2 3"), 5, "`vt` needs 1 numbers and has 0"),
        (square("f 1 2 3\nf 1 2"), 6, "needs 3 corners and has 2"),
        (square("f"), 5, "has 0"),
        (square("f 1 2 3\r\nf 1 2 5"), 6, "vertex that does not exist: there are 4"),
        (square("f 1 2 -5"), 5, "there are 4"),
        (square("f 1 -5 2\nv 0 0 0"), 5, "there are 4"),
        (square("f 0 1 2"), 5, "index 0"),
        (square("f 1/0 2 3"), 5, "index 0"),
        (square("vt 0 0\nf 1/1 2/2 3/1"), 6, "`2/2` names a texture coordinate"),
        (square("vn 0 0 1\nf 1//1 2//1 3//4"), 6, "`3//4` names a normal"),
        (square("f 1 2 99999999999999999999999"), 5, "does not exist"),
        (square("f 1 2 -99999999999999999999999"), 5, "does not exist"),
        (square("f 1 2 x"), 5, "`x` is no corner"),
        (square("f 1 2 3.0"), 5, "`3.0` is no corner"),
        (square("f 1 2 /3"), 5, "`/3` is no corner"),
        (square("f 1 2 3/1/1/1"), 5, "is no corner"),
        (square("f 1 2 - 3"), 5, "`-` is no corner"),
        (square("f 1 2 3 \u{1b}[31m"), 5, r"`\u{1b}[31m`"),
        (square("f 1 2 3\nsurf 0 1 0 1 1 2 3 4"), 6, "`surf` is not read"),
        (square("call other.obj"), 5, "`call` is not read"),
        ("BLENDER-v293\u{0}\u{1}".to_owned(), 1, "starts no statement"),
    ];
    for (text, line, part) in cases {
        let (at, fault) = parse_obj(text.as_bytes(), Normals::Smooth).expect_err(&text);
        assert_eq!(at, Some(line), "{text}: {fault}");
        assert!(fault.to_string().contains(part), "{text}: {fault}");
    }
    let wide = b"\xff\xfev\x00 \x001\x00";
    assert_eq!(parse_obj(wide, Normals::Smooth), Err((Some(1), ObjFault::Utf16)));
    // Of all of the file: there is nothing in it.
    for text in [String::new(), SQUARE.to_owned()] {
        let (line, fault) = parse_obj(text.as_bytes(), Normals::Smooth).unwrap_err();
        assert_eq!((line, fault.to_string().as_str()), (None, "the mesh has no triangles"));
    }
    let long = square(&format!("f 1 2 {}", "z".repeat(1000)));
    assert!(parse_obj(long.as_bytes(), Normals::Smooth).unwrap_err().1.to_string().len() < 150);
}

#[test]
fn a_concave_face_past_the_limit_is_refused_and_a_fan_is_not() {
    let with = |count: usize, is_concave: bool| {
        let mut text = String::new();
        for at in 0..count {
            let radius = if is_concave && at % 2 == 0 { 0.5 } else { 1.0 };
            let turn = std::f64::consts::TAU * at as f64 / count as f64;
            text +=
                &format!("v {} {} 0\n", 1000.0 * radius * turn.cos(), 1000.0 * radius * turn.sin());
        }
        let indices: String = (1..=count).map(|at| format!(" {at}")).collect();
        format!("{text}f{indices}\n")
    };
    let past = CONCAVE_CORNERS_LIMIT + 1;
    let refused = parse_obj(with(past + 1, true).as_bytes(), Normals::Flat);
    assert_eq!(refused, Err((Some(past + 2), ObjFault::TooManyCorners(past + 1))));
    assert_eq!(read(with(past, false)).mesh.triangles.len(), past - 2);
}

#[test]
fn a_face_without_surface_coordinates_falls_back_alone() {
    let mapped = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
    let bare = "v 5 5 0\nv 6 5 0\nv 6 6 0\nv 5 6 0\nf 5 6 7\nf 6 7 5\nf 7/1 8/1 5\nf 5 6 7 8\n";
    let mesh = read(format!("{SQUARE}{mapped}{bare}")).mesh;
    let uvs: Vec<_> = corners(&mesh).iter().map(|t| t.map(|(_, uv, _)| uv.unwrap())).collect();
    assert_eq!(uvs[0], [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]);
    assert_eq!(uvs[1], [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    // What makes barycentric weights, in each triangle anew.
    assert_eq!(uvs[2..], [[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]; 5]);
    let positions: Vec<_> = corners(&mesh).iter().map(|t| t.map(|(p, ..)| p)).collect();
    assert_eq!(positions[3], [[6.0, 5.0, 0.0], [6.0, 6.0, 0.0], [5.0, 5.0, 0.0]]);
    mesh.validate().unwrap();
    // Without any of them there is nothing to keep.
    assert!(read(format!("{SQUARE}vt 0 0\nf 1/1 2 3\nf 1 3 4")).mesh.uvs.is_empty());
}

#[test]
fn a_face_without_normals_is_smoothed_as_if_it_stood_alone() {
    // A roof of two faces without normals over a floor that has them, and shares their edge.
    let roof = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    let alone = read(format!("{roof}f 1 2 3\nf 1 3 4\n")).mesh;
    let floor = "vn 0.6 0.8 0\nf 1//1 2//1 4//1\n";
    let mixed = read(format!("{roof}f 1 2 3\nf 1 3 4\n{floor}")).mesh;
    let (alone, mixed) = (corners(&alone), corners(&mixed));
    assert_eq!(alone[..2], mixed[..2]);
    assert!(mixed[2].iter().all(|(_, _, normal)| *normal == Some([0.6, 0.8, 0.0])));
    // One corner without is a face without.
    let half = corners(&read(format!("{roof}{floor}f 2//1 3//1 4\n")).mesh);
    let smooth = half[1].map(|(_, _, normal)| normal.unwrap());
    assert!(smooth.iter().all(|normal| *normal != [0.6, 0.8, 0.0]), "{smooth:?}");
    // Flat: nobody's normals count.
    let flat = parse_obj(format!("{roof}f 1 2 3\n{floor}").as_bytes(), Normals::Flat).unwrap();
    assert!(flat.mesh.normals.is_empty());
}

#[test]
fn triangles_without_area_are_left_out_and_needles_stay() {
    let count = |vertices: &str| {
        let text = format!("{SQUARE}{vertices}\nf 1 2 3 4\nf 5 6 7\n");
        let read = read(text);
        (read.mesh.triangles.len(), read.flat_triangles)
    };
    for flat in [
        "v 0 0 0\nv 0 0 0\nv 0 0 0",
        "v 0 0 0\nv 1 2 3\nv 0 -0 0",
        "v 1 1 1\nv 2 2 2\nv 3 3 3",
        "v 0.1 0.1 0.1\nv 0.2 0.2 0.2\nv 0.4 0.4 0.4",
        "v -1e12 0 1e-45\nv 1e12 0 1e-45\nv 3 0 1e-45",
        "v 1e-45 0 0\nv 0 0 0\nv 3e-45 0 0",
    ] {
        assert_eq!(count(flat), (2, 1), "{flat}");
    }
    for needle in [
        "v 0 0 0\nv 1 0 0\nv 0.5 1e-45 0",
        "v -1e12 0 0\nv 1e12 0 0\nv 0 0 1e-45",
        "v 0.1 0.3 0\nv 0.2 0.6 0\nv 0.3 0.9 0",
        "v 1 1 1\nv 1.0000001 1 1\nv 1 1.0000001 1",
        "v 1e-45 0 0\nv 0 1e-45 0\nv 0 0 0",
    ] {
        assert_eq!(count(needle), (3, 0), "{needle}");
    }
    // Corners of one face in one place, or on one line, count as the triangles they would have made.
    let read = read(format!("{SQUARE}f 1 2 3 4\nf 1 1 1 1 1\nf 1 2 1 2\nf 1 1 2 3 3\n"));
    assert_eq!((read.mesh.triangles.len(), read.flat_triangles), (3, 3 + 2 + 2));
    let points = format!("{SQUARE}{}", "f 1 1 1\n".repeat(65));
    let (line, fault) = parse_obj(points.as_bytes(), Normals::Smooth).unwrap_err();
    assert_eq!((line, fault), (None, ObjFault::NothingLeft(65)));
}

fn scene_of(folder: &Path, objects: &str) -> SceneFile {
    let text = format!(
        r#"{{ "scene": "s", "camera": {{ "position": [0, 0, 5], "look_at": [0, 0, 0] }}, "objects": [{objects}] }}"#
    );
    read_scene("test.json", text.as_bytes(), folder)
}

#[test]
fn scenes_tell_what_was_left_out_and_in_which_line_a_mesh_is_wrong() {
    let folder = tempfile::tempdir().unwrap();
    let points = format!("{SQUARE}f 1 2 3 4\n{}", "f 1 1 1\n".repeat(65));
    std::fs::write(folder.path().join("points.obj"), points).unwrap();
    std::fs::write(folder.path().join("nan.obj"), format!("{SQUARE}vt nan\nf 1/1 2/1 3/1"))
        .unwrap();
    let object =
        |name: &str| format!(r#"{{ "mesh": "{name}", "material": {{ "subject": true }} }}"#);
    let file = scene_of(folder.path(), &object("points.obj"));
    let [finding] = &file.findings[..] else { panic!("{:?}", file.findings) };
    assert_eq!((finding.code, finding.severity), (Code::FLAT_TRIANGLES, Severity::Note));
    assert!(finding.message.starts_with("65 triangles"), "{}", finding.message);
    assert_eq!(finding.place.path, "objects[0].mesh");
    assert!(file.scene.is_some());
    // Every object that uses it is told.
    let file = scene_of(folder.path(), &[object("nan.obj"), object("./nan.obj")].join(","));
    assert_eq!(file.findings.len(), 2);
    for finding in &file.findings {
        assert_eq!(finding.code, Code::UNUSABLE_FILE);
        assert!(finding.message.contains("nan.obj:5: `nan`"), "{}", finding.message);
    }
}

#[test]
fn objects_that_share_a_file_share_its_mesh() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.obj"), format!("{SQUARE}f 1 2 3 4")).unwrap();
    let object = |name: &str, normals: &str| {
        format!(
            r#"{{ "mesh": "{name}", "normals": "{normals}", "material": {{ "subject": true }} }}"#
        )
    };
    let objects = [object("a.obj", "smooth"), object("./a.obj", "smooth"), object("a.obj", "flat")];
    let scene = scene_of(folder.path(), &objects.join(",")).scene.unwrap();
    let mesh = |at: usize| match &scene.objects[at].shape {
        ShapeDescription::Mesh(mesh) => mesh,
        other => panic!("{other:?}"),
    };
    assert!(Arc::ptr_eq(mesh(0), mesh(1)));
    assert!(!Arc::ptr_eq(mesh(0), mesh(2)));
}

#[cfg(unix)]
#[test]
fn what_is_no_file_is_refused_without_being_opened() {
    let error = read_obj(Path::new("/dev/zero"), Normals::Smooth).unwrap_err().to_string();
    assert!(error.contains("/dev/zero") && error.contains("a device"), "{error}");
}

/// Nothing anybody writes makes the reader panic, and what it accepts is a mesh.
#[test]
fn changed_files_are_read_or_refused() {
    let start = format!(
        "\u{feff}# square\n{SQUARE}v 0 0 1e-3 1 1 1\nvt 0.5\nvt 1 0.25 3\nvn 0 0 1\nvn 1 0 0\ng a\n\
         f 1/1/1 2/2/1 3//2 4\nf -1 -2 \\\n -3\nf 1/2 2/1 3/1 5/1 4/2\nl 1 2\ns 1\n"
    );
    let words: [&[u8]; 21] = [
        b"\n",
        b"\\\n",
        b"#",
        b" ",
        b"/",
        b"-",
        b"0",
        b"9",
        b"1e999",
        b"nan",
        b"f ",
        b"v ",
        b"\r",
        b"vt ",
        b"\xff\xfe",
        b"//",
        b"18446744073709551617",
        b"\\",
        b"\0",
        b"1.#IND",
        b"f 1 2 3 4 5 1 3 2\n",
    ];
    let mut numbers = Numbers(31);
    let (mut read, mut refused) = (0, 0);
    for _ in 0..20_000 {
        let mut bytes = start.clone().into_bytes();
        for _ in 0..1 + (numbers.next() * 4.0) as usize {
            let mut below = |limit: usize| (numbers.next() * limit as f64) as usize;
            let at = below(bytes.len());
            match below(4) {
                0 => bytes[at] = below(256) as u8,
                1 => drop(bytes.drain(at..(at + below(20)).min(bytes.len()))),
                2 => {
                    let copied = bytes[at..(at + below(30)).min(bytes.len())].to_vec();
                    let to = below(bytes.len());
                    bytes.splice(to..to, copied);
                }
                _ => drop(bytes.splice(at..at, words[below(words.len())].iter().copied())),
            }
            if bytes.is_empty() {
                break;
            }
        }
        match parse_obj(&bytes, Normals::Smooth) {
            Ok(ObjMesh { mesh, .. }) => {
                mesh.validate().unwrap();
                let values = mesh.uvs.iter().flatten().chain(mesh.normals.iter().flatten());
                assert!(values.into_iter().all(|value| value.is_finite()));
                read += 1;
            }
            Err((line, _)) => {
                let lines = bytes.iter().filter(|byte| matches!(byte, b'\n' | b'\r')).count() + 1;
                assert!(line.is_none_or(|line| (1..=lines).contains(&line)));
                refused += 1;
            }
        }
    }
    assert!(read > 2000 && refused > 2000, "{read} read, {refused} refused");
}
