use crate::emit::Mask;

node! {
    /// One of two values; only the one chosen is evaluated, and it passes unchanged to the bit. The
    /// values are of any type that nodes compute. Strings, textures and lights are known before shading,
    /// and not chosen among: choose among what is made of them.
    select in logic every type,
    source "",
    inputs {
        /// What decides.
        condition: boolean = false;
        /// The value where it holds.
        if_true: generic = 1.0, when i.condition;
        /// The value where it does not.
        if_false: generic = 0.0, when !i.condition;
    }
    outputs {
        /// The value chosen, with its alpha.
        result: generic;
    }
    body |e, i| Outputs { result: i.condition.select(i.if_true, i.if_false) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn passes_one_side_to_the_bit() {
        let (a, b) = ([-0.0, 1e-45, 2.0, 0.5], [f32::NAN; 4]);
        let chosen = numbers!(condition = true, if_true = a, if_false = b => result);
        assert_eq!(chosen.iter().map(|x| x.to_bits()).collect::<Vec<_>>(), a.map(f32::to_bits));
        assert_eq!(numbers!(condition = false, if_true = b, if_false = a => result), a);
        assert_eq!(number!(condition = true, if_true = 3.0 => result), 3.0);
    }

    #[test]
    fn passes_what_is_no_number_of_components() {
        use crate::values::Literal;
        assert_eq!(number!(condition = true, if_true = i32::MIN => result).to_bits(), 1 << 31);
        assert!(truth!(condition = false, if_true = false, if_false = true => result));
        assert!(!truth!(condition = false, if_true = true => result), "by default false");
        let moved: [f32; 16] =
            std::array::from_fn(|at| if at % 4 == 3 { (at / 15) as f32 } else { at as f32 });
        for condition in [true, false] {
            let given = Literal::Transform(moved);
            let chosen = numbers!(condition = condition, if_true = given, if_false = Literal::IDENTITY => result);
            let Literal::Transform(identity) = Literal::IDENTITY else { unreachable!() };
            assert_eq!(chosen, if condition { moved } else { identity });
        }
    }

    #[test]
    fn demands_one_side() {
        for condition in [false, true] {
            assert_eq!(demanded!(condition = condition => if_true), condition);
            assert_eq!(demanded!(condition = condition => if_false), !condition);
        }
    }
}
