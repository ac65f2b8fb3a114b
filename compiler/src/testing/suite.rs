//! The suite as tests.

/// Writes a module with a test for each thing that nodes must keep to, run on [`Subjects`]:
///
/// ```
/// use phenomenon_compiler::nodes::NodeLibrary;
/// use phenomenon_compiler::test_nodes;
/// use phenomenon_compiler::testing::Subjects;
///
/// test_nodes!(standard_nodes: Subjects::all(NodeLibrary::standard()));
/// ```
///
/// In-range inputs give finite outputs in their ranges, and all forms of a body (native and portable, one
/// point and eight, and what it recorded) the same bits, out of range too. Conditions look at earlier
/// inputs only, inputs that were not demanded leave no trace, nodes per component take each alone and
/// keep the alpha. What a body yields lies in the set that the checker follows. And on random graphs
/// with the node, all engines and the definition give the same results and ask the same.
///
/// [`Subjects`]: crate::testing::Subjects
#[macro_export]
macro_rules! test_nodes {
    ($name:ident: $subjects:expr) => {
        fn $name() -> $crate::testing::Subjects {
            $subjects
        }

        mod $name {
            $crate::test_nodes!(@tests $name;
                signatures: signatures_are_sound,
                forms: in_range_inputs_give_outputs_in_range_and_all_forms_agree,
                forms: out_of_range_inputs_do_not_trap_and_all_forms_agree,
                forms: guards_agree_in_all_forms_and_look_at_earlier_inputs_only,
                forms: undemanded_inputs_do_not_show,
                forms: nodes_per_component_take_each_alone_and_keep_the_alpha_of_the_first,
                sets: nodes_stay_in_their_sets,
                engines: engines_agree_on_graphs_with_the_node,
            );
        }
    };
    (@tests $subjects:ident; $($module:ident: $test:ident,)+) => { $(
        #[test]
        fn $test() {
            $crate::testing::$module::$test(&super::$subjects());
        }
    )+ };
}
