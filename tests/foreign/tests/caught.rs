//! The suite finds what is wrong with a node: each of these breaks one rule.

use std::panic::catch_unwind;

use phenomenon_compiler::emit::Real;
use phenomenon_compiler::nodes::{Definition, Group, NodeLibrary};
use phenomenon_compiler::testing::{Subjects, forms, signatures};

/// Nodes of two numbers and a truth value, that differ in condition and body.
macro_rules! broken {
    ($($name:ident, $doc:literal, when $condition:expr, |$i:ident| $result:expr;)+) => { $(
        mod $name {
            use phenomenon_compiler::emit::Mask;
            use phenomenon_compiler::node;
            use phenomenon_compiler::nodes::finite::UNIT;

            node! {
                #[doc = $doc]
                $name in broken,
                source "",
                inputs {
                    /// Whether the second counts.
                    both: boolean = true;
                    /// The first.
                    a: scalar = 0.0, in UNIT;
                    /// The second.
                    b: scalar = 0.0, in UNIT, when { let $i = i; $condition };
                    /// One more.
                    c: scalar = 0.0, in UNIT;
                }
                outputs {
                    /// What is made of them.
                    result: scalar, in UNIT;
                }
                body |e, i| Outputs { result: { let $i = i; $result } }
            }
        }
    )+ };
}

broken! {
    right, "The second where it counts.", when i.both, |i| i.both.select(i.b, i.a);
    too_far, "Twice the first.", when i.both, |i| i.both.select(i.b, i.a + i.a);
    shows, "The second, whether it counts or not.", when i.both, |i| i.both.select(i.b, i.b);
    peeks, "Asks for the second by the third.", when super::less(i.a, i.c), |i| super::less(i.a, i.c).select(i.b, i.a);
}

/// For conditions over numbers.
#[inline(always)]
fn less<R: Real>(a: R, b: R) -> R::Mask {
    a.less(b)
}

fn subjects(definition: Definition) -> Subjects {
    let mut library = NodeLibrary::standard();
    library.add_group(Group { name: "broken", doc: "Nodes that break rules." });
    library.add(definition);
    Subjects::foreign(library)
}

/// What the suite says against a node; nothing where that keeps to all.
fn said(definition: &Definition) -> Vec<&'static str> {
    type Rule = (&'static str, fn(&Subjects));
    let rules: [Rule; 5] = [
        ("signature", signatures::signatures_are_sound),
        ("range", forms::in_range_inputs_give_outputs_in_range_and_all_forms_agree),
        ("forms", forms::out_of_range_inputs_do_not_trap_and_all_forms_agree),
        ("condition", forms::guards_agree_in_all_forms_and_look_at_earlier_inputs_only),
        ("trace", forms::undemanded_inputs_do_not_show),
    ];
    let breaks = |rule: fn(&Subjects)| {
        let subjects = subjects(definition.clone());
        catch_unwind(move || rule(&subjects)).is_err()
    };
    rules.into_iter().filter(|(_, rule)| breaks(*rule)).map(|(name, _)| name).collect()
}

#[test]
fn each_rule_that_is_broken_is_told() {
    assert_eq!(said(&right::definition()), [""; 0]);
    assert_eq!(said(&too_far::definition()), ["range"]);
    assert_eq!(said(&shows::definition()), ["trace"]);
    assert_eq!(said(&peeks::definition()), ["condition"]);
    let mut unfinished = right::definition();
    unfinished.signature.inputs[1].doc = "The first".into();
    assert_eq!(said(&unfinished), ["signature"]);
}

#[test]
fn a_node_without_its_group_is_refused() {
    let refused = catch_unwind(|| NodeLibrary::standard().add(right::definition()));
    assert!(refused.is_err());
}
