//! Colours as they are written elsewhere: `{ "srgb": "#ff8000" }`, `{ "acescg": [0.5, 0.2, 0.1] }`.

use crate::diagnostics::{Code, Finding};
use crate::document::{Reader, Value, ValueKind};
use crate::values::ColorSpace;

use super::keys::COLOR;

/// The space of a colour that names one; none for any other value.
pub fn space_of(value: &Value) -> Option<ColorSpace> {
    value.members().iter().find_map(|member| ColorSpace::find(&member.key))
}

/// Reads such a colour as scene-linear Rec. 709, converted in 64 bits and rounded once, or reports it.
pub fn read_color<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    space: ColorSpace,
) -> Option<[f32; 4]> {
    reader.object(value, COLOR.what, &[space.name])?;
    let given = value.get(space.name)?;
    let [r, g, b, alpha] = match &given.kind {
        ValueKind::String(text) => hexadecimal(reader, given, space, text)?,
        ValueKind::Number(_) => {
            let grey = component(reader, given, space)?;
            [grey, grey, grey, 1.0]
        }
        ValueKind::Array(elements) if matches!(elements.len(), 3 | 4) => {
            let mut color = [0.0, 0.0, 0.0, 1.0];
            let mut complete = true;
            for (element, into) in elements.iter().zip(&mut color) {
                match component(reader, element, space) {
                    Some(x) => *into = x,
                    None => complete = false,
                }
            }
            complete.then_some(color)?
        }
        _ => {
            reader.wrong_kind(given, &format!("a colour in `{}`", space.name), &form(space));
            return None;
        }
    };
    let linear = space.to_linear_rec709([r, g, b]);
    let rounded = [linear[0], linear[1], linear[2], alpha].map(|x| x as f32);
    if rounded.iter().all(|x| x.is_finite()) {
        return Some(rounded);
    }
    let message = "the colour is not finite in 32 bits once it is converted";
    reader.report(Code::NOT_FINITE, given, message, "give smaller components");
    None
}

/// How a colour of a space is written.
fn form(space: ColorSpace) -> String {
    match space.is_encoded() {
        true => "a text such as `\"#ff8000\"`, or a list of three or four numbers of 0 to 1".into(),
        false => "a list of three or four numbers".into(),
    }
}

/// `#rgb`, `#rgba`, `#rrggbb` or `#rrggbbaa`.
fn hexadecimal(
    reader: &mut Reader<'_>,
    value: &Value,
    space: ColorSpace,
    text: &str,
) -> Option<[f64; 4]> {
    if !space.is_encoded() {
        let message = format!(
            "`{}` is light as it is, and hexadecimal digits are of an encoded colour",
            space.name
        );
        let help = "write numbers here, or `{ \"srgb\": \"#…\" }`";
        reader.report(Code::BAD_COLOR, value, message, help);
        return None;
    }
    if let Some(color) = digits(text) {
        return Some(color);
    }
    // A sign that is missing, or what CSS and C write, is no doubt about the digits.
    let bare = text.trim().trim_start_matches("0x").trim_start_matches('#');
    let mended = format!("#{bare}");
    let message = format!("{} is no colour", value.describe());
    let help =
        "write `#` and three, four, six or eight digits 0 to 9 and a to f, such as `#ff8000`";
    let mut finding = Finding::new(Code::BAD_COLOR, reader.document.place(value), message, help);
    if digits(&mended).is_some() {
        finding = finding.with_fix(format!("\"{mended}\""));
    }
    reader.findings.push(finding);
    None
}

fn digits(text: &str) -> Option<[f64; 4]> {
    let digits: Option<Vec<u32>> =
        text.strip_prefix('#')?.chars().take(9).map(|digit| digit.to_digit(16)).collect();
    let digits = digits?;
    let components: Vec<u32> = match digits.len() {
        3 | 4 => digits.iter().map(|digit| digit * 17).collect(),
        6 | 8 => digits.chunks(2).map(|pair| pair[0] * 16 + pair[1]).collect(),
        _ => return None,
    };
    let mut color = [0.0, 0.0, 0.0, 1.0];
    for (into, component) in color.iter_mut().zip(components) {
        *into = f64::from(component) / 255.0;
    }
    Some(color)
}

/// One number; of an encoded colour it is 0 to 1.
fn component<'d>(reader: &mut Reader<'d>, value: &'d Value, space: ColorSpace) -> Option<f64> {
    let number = reader.finite(value, "a component of a colour")?;
    if !space.is_encoded() || (0.0..=1.0).contains(&number) {
        return Some(number);
    }
    let message = format!("components of a colour in `{}` are 0 to 1, not {number}", space.name);
    let help = match (1.0..=255.0).contains(&number) {
        true => "divide them by 255, or write `#` and two hexadecimal digits for each",
        false => "light brighter than white is written in a linear space, such as `lin_rec709`",
    };
    reader.report(Code::BAD_COLOR, value, message, help);
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_eight_bits_each() {
        assert_eq!(digits("#f80"), digits("#ff8800"));
        assert_eq!(digits("#F80c"), digits("#ff8800cc"));
        assert_eq!(digits("#ff8000"), Some([1.0, 128.0 / 255.0, 0.0, 1.0]));
        for text in
            ["", "#", "#ff", "#fffff", "#fffffff", "#fffffffff", "ff8000", "#ggg", "#ff800é"]
        {
            assert_eq!(digits(text), None, "{text}");
        }
    }
}
