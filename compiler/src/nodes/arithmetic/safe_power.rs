use crate::emit::functions::shaping::signed_power;

node! {
    /// `sign(base) |base|^exponent`, per component: negative bases are mirrored, where `power`
    /// gives 0 for exponents that are not whole. 0 for a base of 0; the largest number where it
    /// overflows. A colour keeps its alpha.
    safe_power in arithmetic per component,
    source "MaterialX 1.39, safepower",
    inputs {
        /// What is raised.
        base: generic = 1.0;
        /// The power.
        exponent: scalar = 1.0;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| signed_power(i.base, i.exponent)
}

#[cfg(test)]
mod tests {
    #[test]
    fn mirrors_negative_bases() {
        assert_eq!(number!(base = -4.0, exponent = 0.5 => result), -2.0);
        assert_eq!(number!(base = -2.0, exponent = 2.0 => result), -4.0);
        assert_eq!(number!(base = 0.0, exponent = 0.0 => result), 0.0);
        assert_eq!(number!(base = -2.0, exponent = 1e9 => result), f32::MIN);
    }
}
