//! Values in a unit that is nearly surely another than the input's: degrees where radians or turns are
//! due, percentages where 0 to 1 is usual, and colours of up to 255. A false alarm is worse than silence,
//! so only numbers are told of that people write for nothing else.

use std::collections::HashSet;
use std::f64::consts::PI;

use crate::diagnostics::{Code, Finding, shortened};
use crate::document::numbers::{self, Whole};
use crate::document::{Reader, Value, ValueKind};
use crate::graph::Parameter;
use crate::nodes::Input;
use crate::values::Type;

use super::draft::{Draft, SourceKind};

/// What angles are measured in.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Angle {
    Degrees,
    Radians,
    Turns,
}

impl Angle {
    fn of_unit(unit: &str) -> Option<Self> {
        Some(match unit.trim().to_lowercase().as_str() {
            "degrees" | "degree" | "deg" | "°" => Angle::Degrees,
            "radians" | "radian" | "rad" => Angle::Radians,
            "turns" | "turn" | "revolutions" => Angle::Turns,
            _ => return None,
        })
    }

    const fn name(self) -> &'static str {
        match self {
            Angle::Degrees => "degrees",
            Angle::Radians => "radians",
            Angle::Turns => "turns",
        }
    }

    /// A full turn.
    const fn full(self) -> f64 {
        match self {
            Angle::Degrees => 360.0,
            Angle::Radians => 2.0 * PI,
            Angle::Turns => 1.0,
        }
    }

    /// The unit a parameter is in: the one it declares, or else the one its name ends with.
    fn of_parameter(parameter: &Parameter) -> Option<Self> {
        if !parameter.unit.is_empty() {
            return Self::of_unit(&parameter.unit);
        }
        let last = parameter.name.rsplit(['_', '-', '.']).next()?;
        ["degrees", "deg"].contains(&last).then_some(Angle::Degrees)
    }
}

/// A literal in another unit than it should be in.
struct Mistake {
    code: Code,
    /// What it hardly is, and what it should be.
    message: String,
    help: String,
    fix: Option<String>,
}

/// Reports values in another unit; the first bytes of those, of which nothing else is to be said.
pub(super) fn check(reader: &mut Reader<'_>, draft: &Draft<'_>) -> HashSet<usize> {
    let mut told = HashSet::new();
    for (node, drafted) in draft.nodes.iter().enumerate() {
        let Some(node_type) = drafted.node_type else { continue };
        let signature = draft.node_types.signature(node_type);
        for given in &drafted.inputs {
            let Some(input) = given.input.map(|at| &signature.inputs[at]) else { continue };
            // What is enforced is refused in any case.
            let is_open = !input.fixed && !draft.nested.contains_key(&node_type);
            let what = || format!("input `{}` of {}", input.name, draft.described(node));
            let value = given.source.value;
            match given.source.kind {
                SourceKind::Literal => {
                    let is_angle = Angle::of_unit(&input.unit).is_some();
                    let Some(mistake) = literal(value, input).filter(|_| is_open || is_angle)
                    else {
                        continue;
                    };
                    told.insert(value.start);
                    let place = reader.document.place(value);
                    let message = format!("{} {}", what(), mistake.message);
                    let finding = Finding::new(mistake.code, place, message, mistake.help);
                    reader.findings.push(Finding { fix: mistake.fix, ..finding });
                }
                SourceKind::Parameter(at) => {
                    if let Some(parameter) = &draft.parameters[at].parameter {
                        let declared = reader.document.place_of_key(draft.parameters[at].member);
                        if let Some((message, help)) = connected(parameter, input) {
                            let place = reader.document.place(value);
                            let message = format!("{} {message}", what());
                            let finding = Finding::new(Code::DEGREES, place, message, help);
                            reader.findings.push(finding.with_related(declared, "declared here"));
                        }
                    }
                }
                SourceKind::Node(..) | SourceKind::Compound(_) | SourceKind::Broken => {}
            }
        }
    }
    told
}

/// What is wrong with a parameter of one angle for an input of another.
fn connected(parameter: &Parameter, input: &Input) -> Option<(String, String)> {
    let due = Angle::of_unit(&input.unit)?;
    let given = Angle::of_parameter(parameter).filter(|given| *given != due)?;
    let (name, due_name) = (shortened(&parameter.name), due.name());
    let message = format!("takes {due_name}, but parameter `{name}` is in {}", given.name());
    let factor = (due.full() / given.full()) as f32;
    let help = format!(
        "put it through a `scale` node with `factor` {factor}, or declare it in {due_name}"
    );
    Some((message, help))
}

fn literal(value: &Value, input: &Input) -> Option<Mistake> {
    match Angle::of_unit(&input.unit) {
        Some(Angle::Radians) => in_degrees(value, Angle::Radians, 15, 720, |x| x % 15 == 0),
        Some(Angle::Turns) => in_degrees(value, Angle::Turns, 10, 360, |_| true),
        Some(Angle::Degrees) => None,
        None if !is_usually_share(input) => None,
        None if input.value_type == Type::Scalar => in_percent(value),
        None if input.value_type == Type::Color => up_to_255(value),
        None => None,
    }
}

/// Whether 0 to 1 is what an input takes, or usually does.
fn is_usually_share(input: &Input) -> bool {
    [&input.range, &input.soft_range].contains(&&(0.0..=1.0))
}

/// A whole number.
fn whole(value: &Value) -> Option<i32> {
    let ValueKind::Number(text) = &value.kind else { return None };
    match numbers::whole(text) {
        Whole::Number(number) => i32::try_from(number).ok(),
        Whole::Fraction | Whole::NoNumber => None,
    }
}

/// Degrees between two bounds, of which `is_likely` tells: a number, or a list in which each is 0 or one of
/// these.
fn in_degrees(
    value: &Value,
    due: Angle,
    least: i32,
    most: i32,
    is_likely: impl Fn(i32) -> bool,
) -> Option<Mistake> {
    let elements = match &value.kind {
        ValueKind::Array(elements) => elements.as_slice(),
        _ => std::slice::from_ref(value),
    };
    let numbers: Option<Vec<i32>> = elements.iter().map(whole).collect();
    let numbers = numbers.filter(|numbers| numbers.iter().any(|&x| x != 0))?;
    let likely = |x: i32| x == 0 || (least..=most).contains(&x.abs()) && is_likely(x.abs());
    if !numbers.iter().all(|&x| likely(x)) {
        return None;
    }
    let converted = |x: i32| ((f64::from(x) * due.full() / 360.0) as f32).to_string();
    let (given, should) = (written(&numbers, i32::to_string), written(&numbers, |x| converted(*x)));
    // Tenths and their parts have an end as decimals, thirds and parts of pi have none.
    let exact = due == Angle::Turns && numbers.iter().all(|x| x * 1000 % 360 == 0);
    Some(Mistake {
        code: Code::DEGREES,
        message: format!("is in {}, and {given} looks like degrees: they are {should}", due.name()),
        help: format!(
            "write {should}; {} are degrees times {}",
            due.name(),
            (due.full() / 360.0) as f32
        ),
        fix: exact.then_some(should),
    })
}

fn written(numbers: &[i32], one: impl Fn(&i32) -> String) -> String {
    match numbers {
        [number] => one(number),
        many => format!("[{}]", many.iter().map(one).collect::<Vec<_>>().join(", ")),
    }
}

fn in_percent(value: &Value) -> Option<Mistake> {
    let number = whole(value).filter(|x| (10..=100).contains(x))?;
    let should = (f64::from(number) / 100.0).to_string();
    Some(Mistake {
        code: Code::PERCENT,
        message: format!(
            "is a share, usually 0 to 1, and {number} looks like percent: it is {should}"
        ),
        help: format!("write {should}"),
        fix: Some(should),
    })
}

/// A colour of whole numbers up to 255, as other programs show it: encoded, so that dividing is not enough.
fn up_to_255(value: &Value) -> Option<Mistake> {
    let ValueKind::Array(elements) = &value.kind else { return None };
    let numbers: Vec<Option<i32>> = elements.iter().map(whole).collect();
    let (rgb, alpha) = match numbers[..] {
        [Some(r), Some(g), Some(b)] => ([r, g, b], Some(1)),
        [Some(r), Some(g), Some(b), alpha] => ([r, g, b], alpha),
        _ => return None,
    };
    let likely = rgb.iter().all(|x| (0..=255).contains(x)) && rgb.iter().any(|&x| x > 16);
    if !likely {
        return None;
    }
    let linear = rgb.map(|x| {
        let encoded = f64::from(x) / 255.0;
        let linear = match encoded <= 0.04045 {
            true => encoded / 12.92,
            false => ((encoded + 0.055) / 1.055).powf(2.4),
        };
        format!("{}", (linear * 1e4).round() / 1e4)
    });
    let [r, g, b] = rgb;
    let as_srgb = format!("{{ \"srgb\": \"#{r:02x}{g:02x}{b:02x}\" }}");
    // Whether 0 or half is meant of an alpha of up to 255 is not known.
    let is_opaque = matches!(alpha, Some(1 | 255));
    Some(Mistake {
        code: Code::EIGHT_BIT_COLOR,
        message: format!(
            "is a reflectance, and [{r}, {g}, {b}] looks like a color of up to 255: it is [{}]",
            linear.join(", ")
        ),
        help: format!(
            "write `{as_srgb}`; colours are scene-linear, and numbers of up to 255 are mostly sRGB"
        ),
        fix: is_opaque.then_some(as_srgb),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::read;
    use crate::nodes::NodeLibrary;

    /// The mistake of a literal at an input of a node.
    fn told(node: &str, input: &str, literal_text: &str) -> Option<(Code, Option<String>)> {
        let library = NodeLibrary::standard();
        let signature = library.signature(library.find(node).expect("a node"));
        let input = &signature.inputs[signature.input(input).expect("an input")];
        let document = read("a.json", literal_text.as_bytes()).expect("JSON");
        literal(&document.root, input).map(|mistake| (mistake.code, mistake.fix))
    }

    #[test]
    fn what_people_write_for_nothing_else_is_told() {
        for degrees in ["45", "90", "-90", "180", "360", "30.0", "[0, 90, 0]"] {
            assert_eq!(told("sine", "input", degrees), Some((Code::DEGREES, None)), "{degrees}");
        }
        let fixed = |fix: &str| Some((Code::DEGREES, Some(fix.to_owned())));
        assert_eq!(told("hsv_to_rgb", "hue", "120"), Some((Code::DEGREES, None)));
        assert_eq!(told("hsv_to_rgb", "hue", "90"), fixed("0.25"));
        assert_eq!(told("mix", "weight", "57"), Some((Code::PERCENT, Some("0.57".to_owned()))));
        for (color, fix) in [
            ("[255, 128, 0]", Some("#ff8000")),
            ("[17, 0, 0]", Some("#110000")),
            ("[255, 255, 255, 1]", Some("#ffffff")),
            ("[0, 9, 255, 255]", Some("#0009ff")),
            ("[255, 128, 0, 128]", None),
            ("[255, 128, 0, 0.5]", None),
        ] {
            let fix = fix.map(|digits| format!("{{ \"srgb\": \"{digits}\" }}"));
            assert_eq!(
                told("lambert", "color", color),
                Some((Code::EIGHT_BIT_COLOR, fix)),
                "{color}"
            );
        }
    }

    #[test]
    fn what_may_be_meant_is_silent() {
        for angle in ["0", "1", "3", "6.2831855", "45.5", "100", "1000", "[1, 90, 0]", "[0, 0, 0]"]
        {
            assert_eq!(told("sine", "input", angle), None, "{angle}");
        }
        for hue in ["0", "1", "2", "-1", "1.5", "0.5", "400"] {
            assert_eq!(told("hsv_to_rgb", "hue", hue), None, "{hue}");
        }
        for weight in ["0", "1", "2", "1.5", "9", "101", "-50"] {
            assert_eq!(told("mix", "weight", weight), None, "{weight}");
        }
        for color in ["[1, 1, 1]", "[16, 16, 16]", "[0.5, 200, 0]", "[300, 0, 0]", "200"] {
            assert_eq!(told("lambert", "color", color), None, "{color}");
        }
        // Light is as bright as it likes.
        assert_eq!(told("lambert", "light", "[255, 128, 0]"), None);
        assert_eq!(told("hsv_to_rgb", "value", "8"), None);
    }
}
