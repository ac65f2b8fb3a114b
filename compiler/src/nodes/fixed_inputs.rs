//! Inputs known before shading, tried with a node that loops over one and branches on another.

use super::NodeLibrary;
use super::harness::numbers;
use crate::values::Literal;

pub mod powers {
    use crate::emit::Mask;
    use crate::nodes::finite::UNIT;

    node! {
        /// The sum of powers of a number, or the last of them.
        powers in arithmetic per component,
        source "",
        inputs {
            /// The number.
            input: generic = 0.5, in UNIT;
            /// How many powers.
            powers: count = 2, in 1.0..=5.0;
            /// Whether they count in part.
            weighted: boolean = false;
            /// The share of many that counts.
            share: scalar = 1.0, when e.mask(i.powers > 0) & i.weighted, in UNIT;
            /// What is made of them.
            mode: choice = 0, of ["sum", "last"];
        }
        outputs {
            /// The value.
            result: generic, in 0.0..=6.0;
        }
        body |e, i| {
            let (mut power, mut sum) = (i.input, i.input);
            for _ in 1..i.powers {
                power = power * i.input;
                sum = sum + power;
            }
            let result = if i.mode == 0 { sum } else { power };
            i.weighted.select(result * i.share, result)
        }
    }
}

#[test]
fn bodies_loop_and_branch_over_plain_numbers() {
    let value = |given: &[(&str, Literal)]| numbers(&powers::definition(), given, "result")[0];
    let (half, count) = (("input", Literal::Scalar(0.5)), |n| ("powers", Literal::Integer(n)));
    assert_eq!(value(std::slice::from_ref(&half)), 0.75);
    assert_eq!(value(&[half.clone(), count(1)]), 0.5);
    let part = [("weighted", Literal::Boolean(true)), ("share", Literal::Scalar(0.5))];
    assert_eq!(value(&[&[half.clone(), count(3)], &part[..]].concat()), 0.4375);
    assert_eq!(value(&[half, count(2), ("mode", Literal::Integer(1))]), 0.25);
}

#[test]
fn each_way_to_give_them_is_code_of_its_own() {
    let settled = powers::definition().settled();
    assert_eq!(settled.len(), 3 * 2);
    let recorded = |at: usize| settled[at].overloads[0].code.expect("a body").recorded().ops.len();
    assert!(recorded(4) > recorded(0), "five powers take more than one");
    let none = NodeLibrary::standard();
    let plain = none.find("add").map(|add| none.definition(add).settled().len());
    assert_eq!(plain, Some(1));
}
