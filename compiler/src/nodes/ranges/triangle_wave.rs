use crate::emit::Real;
use crate::nodes::finite::UNIT;

node! {
    /// Up and down between 0 at integers and 1 half way, per component: twice the distance from
    /// the nearest integer, exact for every number. MaterialX's goes up to one half. A colour
    /// keeps its alpha.
    triangle_wave in ranges per component,
    source "",
    inputs {
        /// Where to look.
        input: generic = 0.0;
    }
    outputs {
        /// The height.
        result: generic, in UNIT;
    }
    body |e, i| (i.input - i.input.round_even()).absolute() * 2.0
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_twice_the_distance_from_an_integer() {
        for (x, height) in
            [(0.0, 0.0), (0.25, 0.5), (0.5, 1.0), (-0.25, 0.5), (7.75, 0.5), (1e30, 0.0)]
        {
            assert_eq!(number!(input = x => result), height);
        }
    }
}
