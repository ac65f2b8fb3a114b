//! Reading `interface`: the parameters of a phenomenon.

use std::collections::{HashMap, HashSet};
use std::ops::RangeInclusive;

use crate::diagnostics::{Code, Finding, shortened, shown};
use crate::document::{MAX_FILE_BYTES, Member, Reader, Value, ValueKind};
use crate::graph::Parameter;
use crate::values::{Literal, Type};

use super::compounds::unknown_member;
use super::declarations::{Declared, One, declaration};
use super::draft::{Draft, DraftParameter};
use super::limits::MAX_PARTS;
use super::literals::{self, Room};
use super::names::check_key;
use super::shape::{Shape, element_name, member_name, struct_literal};

/// Reads all parameters.
pub(super) fn read<'d>(reader: &mut Reader<'d>, value: Option<&'d Value>, draft: &mut Draft<'d>) {
    let Some(value) = value else { return };
    let Some(members) = reader.members(value, "`interface`") else { return };
    for member in members {
        check_key(reader, member, "the name of a parameter");
        let what = format!("parameter `{}`", shortened(&member.key));
        let declared = declaration(reader, &member.value, &what, true);
        let before = draft.parameters.len();
        let shape = declared.and_then(|declared| {
            let default = member.value.get("default");
            let mut parts = Parts { reader, draft, member, told: HashSet::new() };
            parts.add(&declared, default, member.key.clone())
        });
        match shape {
            Some(Shape::One(_)) => {}
            Some(shape) => {
                let name = member.key.clone();
                add_compounds(draft, name, shape);
            }
            // Whatever reads it has a reason not to be understood.
            None => {
                for part in draft.parameters.drain(before..) {
                    draft.parameter_names.remove(&part.name);
                }
                push(draft, member, member.key.clone(), None, None);
            }
        }
    }
}

/// Makes a compound and those within it known by name.
fn add_compounds(draft: &mut Draft<'_>, name: String, shape: Shape) {
    match &shape {
        Shape::One(_) => return,
        Shape::Array(elements) => {
            for (at, element) in elements.iter().enumerate() {
                add_compounds(draft, element_name(&name, at), element.clone());
            }
        }
        Shape::Struct(members) => {
            for (member, shape) in members {
                add_compounds(draft, member_name(&name, member), shape.clone());
            }
        }
    }
    draft.compound_names.insert(name.clone(), draft.compounds.len());
    draft.compounds.push((name, shape));
}

fn push<'d>(
    draft: &mut Draft<'d>,
    member: &'d Member,
    name: String,
    value_type: Option<Type>,
    parameter: Option<Parameter>,
) {
    draft.parameter_names.insert(name.clone(), draft.parameters.len());
    draft.parameters.push(DraftParameter { member, name, value_type, parameter });
}

/// Adds the parts of a parameter to the draft.
struct Parts<'p, 'd> {
    reader: &'p mut Reader<'d>,
    draft: &'p mut Draft<'d>,
    /// The declaration findings point at.
    member: &'d Member,
    /// Where declarations start whose missing default was told.
    told: HashSet<usize>,
}

impl<'d> Parts<'_, 'd> {
    /// Adds what is declared, with its default; none where the shape is not known.
    fn add(
        &mut self,
        declared: &Declared<'d>,
        default: Option<&'d Value>,
        name: String,
    ) -> Option<Shape> {
        match declared {
            Declared::One(one) => {
                self.draft.part_bytes += one.bytes();
                if self.draft.parameters.len() >= MAX_PARTS
                    || self.draft.part_bytes > MAX_FILE_BYTES
                {
                    return self.too_many(one.value);
                }
                let parameter = self.parameter(one, default, &name);
                push(self.draft, self.member, name, Some(one.value_type), parameter);
                Some(Shape::One(one.value_type))
            }
            Declared::Array { of, value } => self.array(of, value, default, &name),
            Declared::Struct { members } => self.structure(members, default, &name),
        }
    }

    fn too_many(&mut self, value: &Value) -> Option<Shape> {
        let message = format!(
            "the interface has more than {MAX_PARTS} parts in all, or they have more than \
             {MAX_FILE_BYTES} bytes of `doc` and `values`"
        );
        let help = "give arrays fewer elements, structs fewer members, and elements shorter texts";
        self.reader.report(Code::TOO_MANY_PARTS, value, message, help);
        None
    }

    fn array(
        &mut self,
        of: &Declared<'d>,
        value: &'d Value,
        default: Option<&'d Value>,
        name: &str,
    ) -> Option<Shape> {
        let Some(default) = default else {
            self.reader.missing(value, &format!("array `{}`", shortened(name)), "default");
            return None;
        };
        let elements = self.reader.list(default, "the default of an array")?;
        if elements.is_empty() {
            let message = "an array without elements holds nothing";
            let help = "an array has the length its default has; give at least one value";
            self.reader.report(Code::WRONG_LENGTH, default, message, help);
            return None;
        }
        let mut shapes = Vec::with_capacity(elements.len());
        for (at, element) in elements.iter().enumerate() {
            shapes.push(self.add(of, Some(element), element_name(name, at))?);
        }
        Some(Shape::Array(shapes))
    }

    fn structure(
        &mut self,
        members: &[(&'d Member, Declared<'d>)],
        default: Option<&'d Value>,
        name: &str,
    ) -> Option<Shape> {
        let mut given = HashMap::new();
        if let Some(value) = default {
            let Some(literal) = struct_literal(value) else {
                let what = "the default of a struct";
                let expected = "`{ \"struct\": { … } }`";
                self.reader.wrong_kind(value, what, expected);
                return None;
            };
            self.reader.object(value, "a struct", &["struct"]);
            let names: Vec<&str> = members.iter().map(|(member, _)| member.key.as_str()).collect();
            let known: HashSet<&str> = names.iter().copied().collect();
            for member in self.reader.members(literal, "a struct")? {
                if known.contains(member.key.as_str()) {
                    given.insert(member.key.as_str(), &member.value);
                } else {
                    unknown_member(self.reader, member, &names);
                }
            }
        }
        let mut shapes = Vec::with_capacity(members.len());
        let outer = self.member;
        for (member, declared) in members {
            let given = given.get(member.key.as_str()).copied();
            let default = given.or(member.value.get("default"));
            self.member = member;
            let shape = self.add(declared, default, member_name(name, &member.key));
            self.member = outer;
            shapes.push((member.key.clone(), shape?));
        }
        Some(Shape::Struct(shapes))
    }

    /// The parameter of one value; none where something of it is wrong.
    fn parameter(
        &mut self,
        one: &One<'d>,
        default: Option<&'d Value>,
        name: &str,
    ) -> Option<Parameter> {
        let default = match (default, one.value_type) {
            (None, Type::Lights) => Some(Literal::Lights(Vec::new())),
            (None, Type::Texture) => Some(Literal::Texture(None)),
            (None, Type::Shader) => Some(Literal::NoShader),
            // Elements of an array share the declaration that lacks it.
            (None, _) if !self.told.insert(one.value.start) => None,
            (None, _) => {
                let what = format!("parameter `{}`", shortened(name));
                self.reader.missing(one.value, &what, "default");
                None
            }
            (Some(value), value_type) => {
                let (range, labels) = (one.range.as_ref(), one.labels.as_deref());
                read_default(self.reader, value, value_type, range, labels)
            }
        };
        Some(Parameter {
            name: name.to_owned(),
            doc: one.doc.clone()?,
            value_type: one.value_type,
            default: default?,
            range: one.range.clone()?,
            soft_range: one.soft_range.clone()?,
            unit: one.unit.clone()?,
            labels: one.labels.clone().unwrap_or_default(),
        })
    }
}

fn read_default<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    value_type: Type,
    range: Option<&RangeInclusive<f64>>,
    labels: Option<&[String]>,
) -> Option<Literal> {
    if let (Some(labels), ValueKind::String(_)) = (labels, &value.kind) {
        let choices: Vec<(&str, i32)> =
            labels.iter().enumerate().map(|(at, label)| (label.as_str(), at as i32)).collect();
        return reader.choice(value, "`default`", &choices).map(Literal::Integer);
    }
    let literal = literals::read(reader, value, value_type, Room::Literal, &|| "`default`".into())?;
    let range = range?;
    // Compared as kept, in 32 bits: a default of 0.1 is not below a minimum of 0.1.
    let inside = |x: f32| (*range.start() as f32) <= x && x <= (*range.end() as f32);
    let outside = match &literal {
        Literal::Integer(number) => !range.contains(&f64::from(*number)),
        Literal::Scalar(x) => !inside(*x),
        Literal::Vector(vector) => vector.iter().any(|x| !inside(*x)),
        Literal::Color(color) => color[..3].iter().any(|x| !inside(*x)),
        _ => false,
    };
    if !outside {
        return Some(literal);
    }
    let help = format!("give a default in {}, or widen `min` and `max`", shown(range));
    let place = reader.document.place(value);
    let message = format!("the default lies outside the parameter's range, {}", shown(range));
    reader.findings.push(Finding::new(Code::NUMBER_OUT_OF_RANGE, place, message, help));
    None
}
