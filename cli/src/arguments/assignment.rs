//! `NAME=VALUE`, for parameters and state fields.

use phenomenon_runtime::link::TextValue;

/// Reads `NAME=VALUE`.
pub fn assignment(text: &str) -> Result<TextValue, String> {
    match text.split_once('=') {
        // Names have no spaces, so those round one mean nothing.
        Some((name, value)) if !name.trim().is_empty() => {
            Ok(TextValue { name: name.trim().into(), value: value.into() })
        }
        _ => Err("write NAME=VALUE; a vector or colour is x,y,z".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_equals_sign_divides() {
        let read = |text| assignment(text).map(|a| (a.name, a.value));
        assert_eq!(read("tint=1,0,0"), Ok(("tint".into(), "1,0,0".into())));
        assert_eq!(read("a=b=c"), Ok(("a".into(), "b=c".into())));
        assert_eq!(read(" fin = a "), Ok(("fin".into(), " a ".into())));
        assert_eq!(read("fin="), Ok(("fin".into(), String::new())), "a string may be empty");
        for text in ["", "=", "tint", "=1", " = "] {
            assert!(read(text).is_err(), "{text}");
        }
    }
}
