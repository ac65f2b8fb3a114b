//! `--allow CODE`.

use phenomenon_compiler::diagnostics::{Code, Explanation, Severity, listed, nearest};

/// Reads the code of findings that are no errors.
pub fn allowable(name: &str) -> Result<Code, String> {
    let explanations = Explanation::ALL.iter();
    let no_errors = || explanations.clone().filter(|it| it.severity != Severity::Error);
    match Code::from_name(name) {
        Some(code) if code.severity() != Severity::Error => Ok(code),
        Some(_) => {
            let codes: Vec<&str> = no_errors().map(|it| it.code.0).collect();
            let (last, rest) = codes.split_last().unwrap_or((&"none", &[]));
            Err(format!(
                "this is an error, and errors cannot be allowed; these can: {} and {last}",
                rest.join(", ")
            ))
        }
        None => {
            let names = no_errors().map(|it| it.code.0);
            Err(match nearest(name, names.clone()) {
                Some(near) => near.help(),
                None => format!("these can be allowed: {}", listed(names)),
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_error_can_be_allowed() {
        for Explanation { code, severity, .. } in Explanation::ALL {
            let allowed = allowable(code.0);
            assert_eq!(allowed.is_ok(), *severity != Severity::Error, "{code}");
        }
        let refused = allowable("unknown-root").unwrap_err();
        assert!(refused.contains("unused-parameter"), "{refused}");
        assert!(!refused.contains("unknown-root"), "{refused}");
        assert!(allowable("unused-paramter").unwrap_err().contains("`unused-parameter`"));
    }
}
