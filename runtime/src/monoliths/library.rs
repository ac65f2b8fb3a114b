//! Finding a monolith by the name of its graph.

use phenomenon_compiler::engine::Shade;
use phenomenon_compiler::values::{Literal, Type};

use super::arithmetic::{Arithmetic, SameBits, Std};
use super::pointwise::{Parameter, PointShader, Pointwise};
use super::{
    AdvancedGlass, AnisoBrdf, Cd, CheckerFloor, ConstantSimple, GradientSky, Rainbow, Silk, Snow,
    Sunglasses, TintedMirror, Xray,
};

/// Why a monolith cannot take a value for a parameter.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MonolithError {
    /// There is no such parameter.
    #[error("the monolith `{monolith}` has no parameter `{parameter}`")]
    Unknown {
        /// The monolith.
        monolith: String,
        /// The name that was given.
        parameter: String,
    },
    /// The value is of another type.
    #[error("parameter `{parameter}` of the monolith `{monolith}` does not take a {given}")]
    Type {
        /// The monolith.
        monolith: String,
        /// The parameter.
        parameter: String,
        /// Type of the value.
        given: &'static str,
    },
}

/// The names [`find`] knows.
pub const NAMES: &[&str] = &[
    "advanced_glass",
    "aniso_brdf",
    "cd",
    "checker_floor",
    "constant_simple",
    "gradient_sky",
    "rainbow",
    "silk",
    "snow",
    "sunglasses",
    "tinted_mirror",
    "xray",
];

/// The monolith of the graph called `name`, with parameters set by name; none if there is no such
/// monolith. Ranges are the graph's to enforce. It computes with the mathematics of std and glam, so results
/// differ from the graph's by rounding.
pub fn find(
    name: &str,
    overrides: &[(String, Literal)],
) -> Option<Result<Box<dyn Shade>, MonolithError>> {
    found::<Std>(name, overrides)
}

/// The same over the compiler's arithmetic: results, and what is asked of the renderer, have the bits of
/// the graph's.
pub fn find_same_bits(
    name: &str,
    overrides: &[(String, Literal)],
) -> Option<Result<Box<dyn Shade>, MonolithError>> {
    found::<SameBits>(name, overrides)
}

fn found<A: Arithmetic>(
    name: &str,
    overrides: &[(String, Literal)],
) -> Option<Result<Box<dyn Shade>, MonolithError>> {
    Some(match name {
        "advanced_glass" => made::<AdvancedGlass, A>(name, overrides),
        "aniso_brdf" => made::<AnisoBrdf, A>(name, overrides),
        "cd" => made::<Cd, A>(name, overrides),
        "checker_floor" => made::<CheckerFloor, A>(name, overrides),
        "constant_simple" => made::<ConstantSimple, A>(name, overrides),
        "gradient_sky" => made::<GradientSky, A>(name, overrides),
        "rainbow" => made::<Rainbow, A>(name, overrides),
        "silk" => made::<Silk, A>(name, overrides),
        "snow" => made::<Snow, A>(name, overrides),
        "sunglasses" => made::<Sunglasses, A>(name, overrides),
        "tinted_mirror" => made::<TintedMirror, A>(name, overrides),
        "xray" => made::<Xray, A>(name, overrides),
        _ => return None,
    })
}

fn made<S: PointShader, A: Arithmetic>(
    name: &str,
    overrides: &[(String, Literal)],
) -> Result<Box<dyn Shade>, MonolithError> {
    let mut shader = S::default();
    for (parameter, literal) in overrides {
        let slot = shader.parameter(parameter).ok_or_else(|| MonolithError::Unknown {
            monolith: name.into(),
            parameter: parameter.clone(),
        })?;
        set(slot, literal).ok_or_else(|| MonolithError::Type {
            monolith: name.into(),
            parameter: parameter.clone(),
            given: literal.value_type().name(),
        })?;
    }
    Ok(Box::new(Pointwise::<S, A>::new(shader)))
}

fn set(slot: Parameter<'_>, literal: &Literal) -> Option<()> {
    let wanted = match slot {
        Parameter::Scalar(_) => Type::Scalar,
        Parameter::Integer(_) => Type::Integer,
        Parameter::Color(_) => Type::Color,
        Parameter::Vector(_) => Type::Vector,
    };
    match (slot, literal.converted_to(wanted)?) {
        (Parameter::Scalar(slot), Literal::Scalar(value)) => *slot = value,
        (Parameter::Integer(slot), Literal::Integer(value)) => *slot = value,
        (Parameter::Color(slot), Literal::Color(value)) => *slot = value.into(),
        (Parameter::Vector(slot), Literal::Vector(value)) => *slot = value.into(),
        _ => return None,
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(name: &str, parameter: &str, literal: Literal) -> Option<String> {
        let found = find(name, &[(parameter.into(), literal)])?;
        found.err().map(|error| error.to_string())
    }

    #[test]
    fn every_name_is_found_and_no_other() {
        for name in NAMES {
            assert!(find(name, &[]).is_some_and(|found| found.is_ok()), "{name}");
        }
        assert!(find("advanced_glas", &[]).is_none());
    }

    #[test]
    fn values_convert_as_connections_do() {
        assert_eq!(error("rainbow", "ior", Literal::Integer(2)), None);
        assert_eq!(error("rainbow", "ambient", Literal::Scalar(0.5)), None);
        assert_eq!(error("gradient_sky", "sun_direction", Literal::Vector([0.0; 3])), None);
    }

    #[test]
    fn wrong_names_and_types_are_told() {
        assert_eq!(
            error("rainbow", "iro", Literal::Scalar(1.0)).as_deref(),
            Some("the monolith `rainbow` has no parameter `iro`")
        );
        assert_eq!(
            error("rainbow", "ior", Literal::Vector([1.0; 3])).as_deref(),
            Some("parameter `ior` of the monolith `rainbow` does not take a vector")
        );
    }
}
