use crate::emit::Real;

node! {
    /// Nearest integer, per component; halves go to the even one: 2.5 becomes 2, and 3.5
    /// becomes 4. So does MaterialX on GPUs; Blender takes `floor(input + 0.5)`, OSL goes away
    /// from zero. A colour keeps its alpha.
    round in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The integer.
        result: generic;
    }
    body |e, i| i.input.round_even()
}

#[cfg(test)]
mod tests {
    #[test]
    fn halves_go_to_the_even_integer() {
        for (x, near) in [(0.5, 0.0), (1.5, 2.0), (2.5, 2.0), (-0.5, 0.0), (-1.5, -2.0), (2.4, 2.0)]
        {
            assert_eq!(number!(input = x => result), near, "{x}");
        }
        let below = 0.5_f32.next_down();
        assert_eq!(number!(input = below => result), 0.0, "the sum with 0.5 would round to 1");
    }
}
