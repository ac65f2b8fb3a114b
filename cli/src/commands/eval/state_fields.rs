//! `--state FIELD=VALUE`.

use phenomenon_compiler::diagnostics::nearest;
use phenomenon_compiler::document::numbers::{self, Whole};
use phenomenon_compiler::state::{Field, Place, RayType};
use phenomenon_compiler::values::{Literal, Type};

use phenomenon_runtime::geometry::Transform;
use phenomenon_runtime::link::TextValue;

use crate::failure::Failure;

/// Directions this near to unit length are taken as they are, to the bit.
const UNIT: f64 = 1e-6;

/// Numbers of the widest field: a transform.
const MOST: usize = 16;

/// Most reflections or refractions so far.
const LEVELS: i32 = 1 << 20;

/// The default place with these fields set, and notes on what was changed to fit.
///
/// # Errors
/// An unknown field, a field set twice, or a value the renderer never builds.
pub fn place(assignments: &[TextValue]) -> Result<(Place, Vec<String>), Failure> {
    let mut place = Place::default();
    let mut notes = Vec::new();
    let mut given: Vec<Field> = Vec::new();
    for assignment in assignments {
        let TextValue { name, value } = assignment;
        let refuse =
            |why: &str, help: &str| Failure::new(format!("--state {name}={value}: {why}"), help);
        let field = field(name).map_err(|help| refuse("the state has no such field", &help))?;
        if let Some(of) = field.of_loop() {
            let why = format!("this field exists only inside a {} loop", of.name());
            return Err(refuse(&why, "evaluate the loop; an empty scene has no lights"));
        }
        if given.contains(&field) {
            return Err(refuse("the field is set twice", "leave one of them out"));
        }
        given.push(field);
        let literal = parse(field, value).map_err(|why| refuse(&why, form(field)))?;
        let literal = admit(field, literal).map_err(|help| refuse("out of range", help))?;
        if matches!(field, Field::Direction | Field::Normal | Field::NormalGeom) && literal.1 {
            notes.push(format!("note: {name} was brought to unit length"));
        }
        field.put(&mut place, &literal.0.words());
    }
    follow(&mut place, &given);
    Ok((place, notes))
}

/// Sets what follows from fields that are given, where it is not given itself.
fn follow(place: &mut Place, given: &[Field]) {
    let Place { state, object, surface, camera } = place;
    let has = |field: Field| given.contains(&field);
    if !has(Field::NormalGeom) {
        state.normal_geom = state.normal;
    }
    if !has(Field::DotNd) {
        state.dot_nd = dot(state.normal, state.direction).clamp(-1.0, 1.0);
    }
    // A surface has one set of coordinates unless it is said to have two.
    for (axis, field) in [Field::SecondU, Field::SecondV].into_iter().enumerate() {
        if !has(field) {
            surface.second_uv[axis] = state.uv[axis];
        }
    }
    for (there, back, to, from) in [
        (Field::ObjectToWorld, Field::WorldToObject, &mut object.to_world, &mut object.to_object),
        (Field::CameraToWorld, Field::WorldToCamera, &mut camera.to_world, &mut camera.to_camera),
    ] {
        match (has(there), has(back)) {
            (true, false) => *from = inverse(to),
            (false, true) => *to = inverse(from),
            _ => {}
        }
    }
}

fn inverse(rows: &[f32; 16]) -> [f32; 16] {
    Transform::of_graph_rows(rows).inverse().rows()
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    let products = a.iter().zip(b).map(|(x, y)| f64::from(*x) * f64::from(y));
    products.sum::<f64>() as f32
}

fn field(name: &str) -> Result<Field, String> {
    Field::from_name(name).ok_or_else(|| {
        let names = || Field::ALL.iter().filter(|it| it.of_loop().is_none()).map(|it| it.name());
        match nearest(name, names()) {
            Some(near) => near.help(),
            None => format!("the fields are {}", names().collect::<Vec<_>>().join(", ")),
        }
    })
}

/// The value, if it is of the field's type; else why it is not.
fn parse(field: Field, text: &str) -> Result<Literal, String> {
    let word = text.trim();
    if field == Field::RayType
        && let Some(ray_type) = RayType::ALL.into_iter().find(|it| it.name() == word)
    {
        return Ok(Literal::Integer(ray_type as i32));
    }
    match field.value_type() {
        Type::Boolean => match word {
            "true" => Ok(Literal::Boolean(true)),
            "false" => Ok(Literal::Boolean(false)),
            _ => Err("no such value".into()),
        },
        Type::Integer => match numbers::whole(word) {
            Whole::Number(number) => {
                i32::try_from(number).map(Literal::Integer).map_err(|_| "out of range".to_owned())
            }
            Whole::Fraction => Err("a whole number is needed".into()),
            Whole::NoNumber => Err(nearly(word)),
        },
        Type::Scalar => match given(text)?.as_slice() {
            [x] => Ok(Literal::Scalar(*x)),
            many => Err(miscounted("one number is needed", many)),
        },
        Type::Vector => match given(text)?.as_slice() {
            [x, y, z] => Ok(Literal::Vector([*x, *y, *z])),
            other => Err(miscounted("three numbers are needed", other)),
        },
        Type::Color => match given(text)?.as_slice() {
            [x] => Ok(Literal::Color([*x, *x, *x, 1.0])),
            [r, g, b] => Ok(Literal::Color([*r, *g, *b, 1.0])),
            [r, g, b, a] => Ok(Literal::Color([*r, *g, *b, *a])),
            other => Err(miscounted("one, three or four numbers are needed", other)),
        },
        Type::Transform => match given(text)?.try_into() {
            Ok(rows) => Ok(Literal::Transform(rows)),
            Err(other) => Err(miscounted("sixteen numbers are needed", &other)),
        },
        // No field is of these.
        _ => Err("no such value".into()),
    }
}

/// The numbers of a list.
fn given(text: &str) -> Result<Vec<f32>, String> {
    let number = |part: &str| {
        numbers::single(part).ok_or_else(|| {
            let too_large = numbers::is_number(part) || numbers::names_no_finite(part);
            let why = if too_large { "not finite in 32 bits".into() } else { nearly(part) };
            if part == text { why } else { format!("`{part}`: {why}") }
        })
    };
    // One more than any field takes is enough to tell that there are too many.
    text.split(',').take(MOST + 1).map(|part| number(part.trim())).collect()
}

/// Why a text is no number.
fn nearly(text: &str) -> String {
    match numbers::nearest_number(text) {
        Some(number) => format!("write {number}"),
        None => "no such value".into(),
    }
}

fn miscounted(needed: &str, given: &[f32]) -> String {
    match given.len() {
        1 => format!("{needed}, and 1 is given"),
        count if count > MOST => format!("{needed}, and more than {MOST} are given"),
        count => format!("{needed}, and {count} are given"),
    }
}

/// How a value of the field is written.
fn form(field: Field) -> &'static str {
    match field.value_type() {
        Type::Boolean => "write true or false",
        Type::Integer if field == Field::RayType => {
            "write eye, reflection, refraction, transparent, shadow, environment, displace or 0 to 6"
        }
        Type::Integer => "write a whole number",
        Type::Vector => "write three numbers, such as 0,0,1",
        Type::Transform => {
            "write four rows of four numbers: where x, y and z go, each with a 0 behind, and the origin with a 1"
        }
        Type::Color => "write one, three or four numbers, such as 0.5,0.25,0.25",
        _ => "write a number, such as 0.5",
    }
}

/// The value as the renderer would build it, and whether it had to be changed for that; or what
/// would do.
fn admit(field: Field, literal: Literal) -> Result<(Literal, bool), &'static str> {
    match (field, literal) {
        (Field::Direction | Field::Normal | Field::NormalGeom, Literal::Vector(vector)) => {
            unit(vector)
                .map(|(vector, changed)| (Literal::Vector(vector), changed))
                .ok_or("give finite numbers that are not all 0")
        }
        (_, Literal::Vector(vector)) if vector.iter().any(|x| !x.is_finite()) => {
            Err("give finite numbers")
        }
        (_, Literal::Transform(rows)) => match is_map(&rows) {
            true => Ok((Literal::Transform(rows), false)),
            false => Err("give a map that flattens nothing, its last column 0, 0, 0, 1"),
        },
        (_, Literal::Scalar(x)) if !x.is_finite() => Err("give a finite number"),
        (Field::DotNd, Literal::Scalar(x)) if !(-1.0..=1.0).contains(&x) => {
            Err("give a number from -1 to 1")
        }
        (Field::Time | Field::ObjectRandom, Literal::Scalar(x)) if !(0.0..=1.0).contains(&x) => {
            Err("give a number from 0 to 1")
        }
        (Field::Dist | Field::Ior | Field::IorIn | Field::CameraHeight, Literal::Scalar(x))
            if x < 0.0 =>
        {
            Err("give a number that is not negative")
        }
        (Field::RayType, Literal::Integer(x)) if !(0..=6).contains(&x) => Err(form(field)),
        (Field::ObjectId, Literal::Integer(x)) if x < 0 => {
            Err("give a whole number that is not negative")
        }
        (Field::ReflectionLevel | Field::RefractionLevel, Literal::Integer(x))
            if !(0..=LEVELS).contains(&x) =>
        {
            Err("give a whole number from 0 to 1048576")
        }
        (_, literal) => Ok((literal, false)),
    }
}

/// Whether it is a map the renderer could have of an object or its camera.
fn is_map(rows: &[f32; 16]) -> bool {
    let last = [3, 7, 11, 15].map(|at| rows[at]);
    last == [0.0, 0.0, 0.0, 1.0] && Transform::of_graph_rows(rows).is_regular()
}

/// The vector at unit length, and whether that changed it; none if it has no direction.
fn unit(vector: [f32; 3]) -> Option<([f32; 3], bool)> {
    let wide = vector.map(f64::from);
    let length = wide.iter().map(|x| x * x).sum::<f64>().sqrt();
    if !length.is_finite() || length == 0.0 {
        return None;
    }
    if (length - 1.0).abs() <= UNIT {
        return Some((vector, false));
    }
    Some((wide.map(|x| (x / length) as f32), true))
}

#[cfg(test)]
mod tests {
    use phenomenon_compiler::state::Objects;

    use super::*;
    use crate::arguments::assignment;

    fn read(texts: &[&str]) -> Result<(Place, Vec<String>), String> {
        let assignments: Vec<_> = texts.iter().map(|text| assignment(text).unwrap()).collect();
        place(&assignments).map_err(|failure| format!("{failure}; {}", failure.help()))
    }

    #[test]
    fn what_is_not_given_follows() {
        let (Place { state, .. }, notes) = read(&["normal=0,1,0", "direction=0.6,-0.8,0"]).unwrap();
        assert!(notes.is_empty());
        assert_eq!(state.direction, [0.6, -0.8, 0.0]);
        assert_eq!(state.normal_geom, [0.0, 1.0, 0.0]);
        assert_eq!(state.dot_nd, -0.8);
        let (Place { state, .. }, _) =
            read(&["normal=0,1,0", "dot_nd=-0.0", "normal_geom=0,0,1"]).unwrap();
        assert_eq!(state.dot_nd.to_bits(), (-0.0_f32).to_bits());
        assert_eq!(state.normal_geom, [0.0, 0.0, 1.0]);
    }

    #[test]
    fn directions_are_brought_to_unit_length_and_that_is_said() {
        for text in ["normal=0,3,4", "normal=0,3e30,4e30", "normal=0,3e-40,4e-40"] {
            let (Place { state, .. }, notes) = read(&[text]).unwrap();
            assert!((state.normal[1] - 0.6).abs() < 1e-5, "{text} {:?}", state.normal);
            assert_eq!(notes, ["note: normal was brought to unit length"]);
        }
    }

    #[test]
    fn every_field_of_a_place_can_be_set() {
        for field in Field::ALL.iter().filter(|field| field.of_loop().is_none()) {
            let value = match field.value_type() {
                Type::Boolean => "true",
                Type::Vector => "0,1,0",
                Type::Transform => "0,2,0,0,-2,0,0,0,0,0,2,0,1,2,3,1",
                _ => "1",
            };
            let text = format!("{}={value}", field.name());
            let (place, _) = read(&[&text]).unwrap();
            let mut words = vec![0; field.value_type().width()];
            Objects::of_place(&place).read(*field, &place.state, &mut words);
            let one = if field.value_type() == Type::Integer { 1 } else { 1.0_f32.to_bits() };
            match field.value_type() {
                Type::Boolean => assert_eq!(words[0], u32::MAX, "{text}"),
                Type::Vector => assert_eq!(words, [0, one, 0], "{text}"),
                Type::Transform => assert_eq!((words[1], words[12]), (2.0_f32.to_bits(), one)),
                _ => assert_eq!(words[0], one, "{text}"),
            }
        }
        let (place, _) =
            read(&["world_to_object=0,2,0,0,-2,0,0,0,0,0,2,0,1,2,3,1", "u=3"]).unwrap();
        assert_eq!(place.object.to_world[12..], [-1.0, 0.5, -1.5, 1.0]);
        assert_eq!(place.surface.second_uv, [3.0, 0.0]);
        assert_eq!(read(&["ray_type=shadow"]).unwrap().0.state.ray_type, RayType::Shadow);
    }

    #[test]
    fn what_the_renderer_never_builds_is_refused() {
        for text in [
            "normal=0,0,0",
            "normal=0,0",
            "normal=0,0,1,0",
            "direction=NaN,0,1",
            "point=inf,0,0",
            "u=NaN",
            "u=",
            "dist=-1",
            "dot_nd=1.0000001",
            "time=1.1",
            "ior=-1e-45",
            "ray_type=7",
            "ray_type=eyes",
            "reflection_level=-1",
            "refraction_level=1.5",
            "inv_normal=maybe",
            "inv_normal=1",
            "u=.5",
            "u=0x1",
            "u=1e39",
            "u=1,2",
            "reflection_level=+1",
            "reflection_level=4294967297",
            "incoming=1,1",
            "incoming=1,1,1,1,1",
            "light_direction=0,0,1",
            "object_id=-1",
            "object_random=1.5",
            "object_to_world=1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2",
            "derivative_u=0,inf,0",
        ] {
            let Ok(assignment) = assignment(text) else { continue };
            let failure = place(&[assignment]).expect_err(text);
            assert!(failure.to_string().contains(text), "{failure}");
            assert!(!failure.help().is_empty(), "{text}");
        }
        let told = |text: &str, part: &str| {
            let error = read(&[text]).unwrap_err();
            assert!(error.contains(part), "{text}: {error}");
        };
        told("normal=0,0", "three numbers are needed, and 2 are given");
        told("point=1", "three numbers are needed, and 1 is given");
        told("incoming=1,1", "one, three or four numbers are needed, and 2 are given");
        told("u=1,2", "one number is needed, and 2 are given");
        told("point=0,.5,0", "`.5`: write 0.5");
        told("reflection_level=1.5", "a whole number is needed");
        told("object_to_world=1,0,0", "sixteen numbers are needed, and 3 are given");
        told("camera_to_world=0,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1", "flattens nothing");
        assert_eq!(read(&["reflection_level=2e0"]).unwrap().0.state.reflection_level, 2);
        assert!(read(&["norml=0,0,1"]).unwrap_err().contains("did you mean `normal`?"));
        assert!(read(&["u=1", "u=2"]).unwrap_err().contains("twice"));
    }
}
