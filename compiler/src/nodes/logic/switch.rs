use crate::emit::{Int, Mask};

node! {
    /// One of several values by number; only the one chosen is evaluated, and it passes unchanged to the
    /// bit. A number past the cases takes the nearest. Four cases have names; as `cases` there may be any
    /// number of them, and the node is the `element` of that list. The values are of any type that nodes
    /// compute.
    switch in logic every type,
    source "",
    inputs {
        /// Which one.
        index: integer = 0, in 0.0..=3.0;
        /// The value of index 0 and below.
        case_0: generic = 0.0, when i.index.less(e.int(1));
        /// The value of index 1.
        case_1: generic = 0.0, when i.index.equal(e.int(1));
        /// The value of index 2.
        case_2: generic = 0.0, when i.index.equal(e.int(2));
        /// The value of index 3 and above.
        case_3: generic = 0.0, when e.int(2).less(i.index);
    }
    or {
        /// The values of index 0, 1, 2 …, in place of the four.
        cases;
    }
    outputs {
        /// The value chosen, with its alpha.
        result: generic;
    }
    body |e, i| {
        let from_two = e.int(2).less(i.index).select(i.case_3, i.case_2);
        let from_one = i.index.equal(e.int(1)).select(i.case_1, from_two);
        Outputs { result: i.index.less(e.int(1)).select(i.case_0, from_one) }
    }
}

#[cfg(test)]
mod tests {
    fn switch(index: i32) -> f32 {
        number!(index = index, case_0 = 10.0, case_1 = 11.0, case_2 = 12.0, case_3 = 13.0 => result)
    }

    #[test]
    fn takes_the_nearest_case() {
        let chosen = [i32::MIN, -1, 0, 1, 2, 3, 4, i32::MAX].map(switch);
        assert_eq!(chosen, [10.0, 10.0, 10.0, 11.0, 12.0, 13.0, 13.0, 13.0]);
    }

    #[test]
    fn demands_one_case() {
        for index in [i32::MIN, -1, 0, 1, 2, 3, 4, i32::MAX] {
            let demands = [
                demanded!(index = index => case_0),
                demanded!(index = index => case_1),
                demanded!(index = index => case_2),
                demanded!(index = index => case_3),
            ];
            let chosen = index.clamp(0, 3) as usize;
            assert_eq!(demands, std::array::from_fn(|case| case == chosen), "{index}");
        }
    }
}
