//! The [`node!`](crate::node) macro: a node's signature, and its body compiled for every type it
//! takes.

/// Declares a node in its file: its header, from which come the signature and the structures
/// `Inputs` and `Outputs`, and its body. What the list of nodes holds of it is `definition()`.
///
/// ```
/// mod halve {
///     use phenomenon_compiler::emit::Mask;
///     use phenomenon_compiler::node;
///
///     node! {
///         /// Half of a number.
///         halve in arithmetic,
///         source "",
///         inputs {
///             /// Whether it is wanted.
///             sure: boolean = true;
///             /// What is halved.
///             input: scalar = 1.0, when i.sure, in 0.0..=8.0;
///         }
///         outputs {
///             /// The half.
///             result: scalar, in 0.0..=4.0;
///         }
///         body |e, i| Outputs { result: i.sure.select(i.input * 0.5, e.real(0.0)) }
///     }
/// }
///
/// assert_eq!(halve::definition().signature.inputs[1].range, 0.0..=8.0);
/// ```
///
/// **Kinds**, after the group's name:
///
/// * none: the body yields `Outputs`;
/// * `generic`: the same, over `T: Components<E::Real>` for scalar, vector and color inputs, or for
///   those in brackets: `generic [vector, color]`;
/// * `every type`: chooses among values of any type that is computed; over `T: Select<E::Mask>`;
/// * `comparing`: compares scalars, and integers exactly; over `T: Ordered<E::Mask>`;
/// * `per component`: the body yields the one output's component from the inputs' components. The
///   first input is generic, and of a colour its alpha passes unchanged: bodies never see alpha;
/// * `request Effect`: asks the renderer, and has no body: what conditions look at is named before its
///   inputs, `inputs |e, i| { … }`;
/// * `scope [Field, …]`: the body yields `Changes`, one for each field in order, and the input under
///   `scoped`, of any type or generic, is evaluated under them;
/// * `structural [Kind]`: the engines or the checker know what to do, and there is no body.
///
/// **Annotations** of an input, in any order: `in RANGE`, `soft RANGE` (what is usual), `unit "radians"`, `avoid zero` or `avoid negative` (taken,
/// but hardly meant), `when CONDITION`, `list`, `of ["name", …]` of a `choice`, and `under ("scope", "input")`:
/// where it is not given, what that input is given, evaluated in a scope of that type, or `slope` for how much that changes with the step of the scope. An output has
/// `in RANGE`. Others are refused:
///
/// ```compile_fail
/// mod halve {
///     use phenomenon_compiler::emit::Mask;
///     use phenomenon_compiler::node;
///
///     node! {
///         /// Half of a number.
///         halve in arithmetic,
///         source "",
///         inputs {
///             /// Whether it is wanted.
///             sure: boolean = true;
///             /// What is halved.
///             input: scalar = 1.0, when i.sure, within 0.0..=8.0;
///         }
///         outputs {
///             /// The half.
///             result: scalar, in 0.0..=4.0;
///         }
///         body |e, i| Outputs { result: i.sure.select(i.input * 0.5, e.real(0.0)) }
///     }
/// }
/// ```
///
/// A list of types has those that `generic` may stand for, and the body of a scope sees no generic
/// input:
///
/// ```compile_fail
/// mod twofold {
///     use phenomenon_compiler::node;
///
///     node! {
///         /// Twice a value.
///         twofold in arithmetic generic [scalar, integer],
///         source "",
///         inputs {
///             /// What is doubled.
///             input: generic = 1.0;
///         }
///         outputs {
///             /// Its double.
///             result: generic;
///         }
///         body |e, i| Outputs { result: i.input + i.input }
///     }
/// }
/// ```
///
/// ```compile_fail
/// mod later {
///     use phenomenon_compiler::node;
///     use phenomenon_compiler::nodes::BLACK;
///
///     node! {
///         /// Evaluates `input` at another time.
///         later in scopes scope [Time],
///         source "",
///         inputs {
///             /// The time.
///             time: generic = 1.0;
///         }
///         scoped {
///             /// What is evaluated.
///             input: color = BLACK;
///         }
///         changes { time: scalar; }
///         outputs {
///             /// The value.
///             color: color;
///         }
///         body |e, i| Changes { time: i.time.x }
///     }
/// }
/// ```
///
/// **Known before shading** are inputs of the types `count` and `choice`: plain `i32`s to the body, in
/// their range. A literal or a parameter gives them, and another value is other code, so a body may
/// loop over a count and match on a choice.
///
/// Inputs stand in the order in which they are demanded. One with `when` is demanded only where its
/// condition holds, which may look at earlier inputs without a condition. A body must not let an input that was not
/// demanded show in its outputs. Bodies and conditions are functions of the back end and the inputs,
/// called as in `body |e, i|`, and always inlined; functions they call must be `#[inline(always)]`.
#[macro_export]
macro_rules! node {
    (
        $(#[doc = $doc:literal])+
        $name:ident in $group:ident $($kind:ident)* $([$($of:tt)+])?, source $source:literal,
        inputs $(|$back_end:ident, $given:ident|)? { $($(#[doc = $idoc:literal])+ $input:ident : $itype:ident = $default:expr $(, $iword:ident $($ivalue:expr)?)*;)* }
        $(or { $(#[doc = $ldoc:literal])+ $list:ident; })?
        $(scoped { $(#[doc = $sdoc:literal])+ $scoped:ident : $stype:ident = $sdefault:expr $(, $sword:ident $($svalue:expr)?)*; })?
        $(changes { $($change:ident : $ctype:ident;)+ })?
        outputs { $($(#[doc = $odoc:literal])+ $output:ident : $otype:ident $(, $oword:ident $($ovalue:expr)?)*;)+ }
        $(body |$e:ident, $i:ident| $body:expr)?
    ) => {
        $crate::node!(@code [$($kind)*] [$($($of)+)?] [$($e $i $body)? $($back_end $given)?]
            [$($input : $itype [$($iword [$($ivalue)?])*];)*] [$($scoped)?]
            [$($($change : $ctype;)+)?] [$($output : $otype;)+]);

        /// What the list of nodes holds of this node.
        pub fn definition() -> $crate::nodes::Definition {
            let signature = $crate::nodes::Signature {
                name: stringify!($name).into(),
                group: stringify!($group),
                doc: $crate::nodes::paragraph(&[$($doc),+]),
                source: $source,
                inputs: vec![
                    $($crate::node!(@input $input [$($idoc)+] $itype [$default] [$($iword [$($ivalue)?])*]),)*
                    $($crate::node!(@input $scoped [$($sdoc)+] $stype [$sdefault] [$($sword [$($svalue)?])*]).scoped(),)?
                ],
                outputs: vec![$($crate::node!(@output $output [$($odoc)+] $otype [$($oword [$($ovalue)?])*]),)+],
                kind: $crate::node!(@kind [$($kind)*] [$($($of)+)?]),
                generic: $crate::node!(@types [$($kind)*] [$($($of)+)?]),
                or_list: None$(.or(Some($crate::nodes::Input::new(
                    stringify!($list),
                    &[$($ldoc),+],
                    $crate::values::Type::Generic,
                    $crate::nodes::required(),
                ).list())))?,
            };
            define(signature)
        }
    };

    // ---- kinds: what each has for code, which is `define`
    (@code [request $effect:ident] [] [$e:ident $i:ident] [$($input:ident : $itype:ident $annotations:tt;)*] [] [] $outputs:tt) => {
        $crate::node!(@structure Inputs "What arrives at the node." [$($input : $itype $annotations;)*]);
        fn define(signature: $crate::nodes::Signature) -> $crate::nodes::Definition {
            // Conditions look at some inputs only.
            fn looked_at<E: $crate::emit::Emit>(inputs: &Inputs<E>) {
                $(let _ = &inputs.$input;)*
            }
            let _ = looked_at::<$crate::emit::scalar::Scalar>;
            let guards = $crate::node!(@guards [] $crate::nodes::ports::scalar, plain $e $i
                [$($input : $itype $annotations;)*] [$($input : $itype $annotations;)*]);
            $crate::nodes::Definition::with_code(signature, None, guards)
        }
    };
    (@code [request $effect:ident] [] $($rest:tt)*) => { $crate::node!(@bodiless $($rest)*); };
    (@code [structural] $kind:tt $($rest:tt)*) => { $crate::node!(@bodiless $($rest)*); };
    (@bodiless [] $($rest:tt)*) => {
        fn define(signature: $crate::nodes::Signature) -> $crate::nodes::Definition {
            $crate::nodes::Definition::without_body(signature)
        }
    };
    (@code [] [] [$e:ident $i:ident $body:expr] $inputs:tt [] [] $outputs:tt) => {
        $crate::node!(@structure Inputs "What arrives at the node." $inputs);
        $crate::node!(@structure Outputs "What the node yields." $outputs);
        $crate::node!(@function body plain $e $i Outputs<E>, $body);
        $crate::node!(@run [] $crate::nodes::ports::scalar, $inputs $outputs);
        $crate::node!(@plain $e $i $inputs);
    };
    (@code [scope] $fields:tt [$e:ident $i:ident $body:expr] $inputs:tt [$scoped:ident] $changes:tt $outputs:tt) => {
        $crate::node!(@structure Inputs "What arrives at the node." $inputs);
        $crate::node!(@known_types $inputs);
        $crate::node!(@structure Changes "What the scope changes." $changes);
        $crate::node!(@function body plain $e $i Changes<E>, $body);
        $crate::node!(@run [] $crate::nodes::ports::scalar, $inputs $changes);
        $crate::node!(@plain $e $i $inputs);
    };
    (@code [generic] $types:tt [$e:ident $i:ident $body:expr] $inputs:tt [] [] $outputs:tt) => {
        $crate::node!(@structure Inputs "What arrives at the node." $inputs);
        $crate::node!(@structure Outputs "What the node yields." $outputs);
        $crate::node!(@function body generic $e $i Outputs<E, T>, $body);
        $crate::node!(@run [S: $crate::nodes::ports::Shape] S, $inputs $outputs);
        $crate::node!(@generic [S: $crate::nodes::ports::Shape] generic $e $i $inputs false $types);
    };
    (@code [every type] [] [$e:ident $i:ident $body:expr] $inputs:tt [] [] $outputs:tt) => {
        $crate::node!(@structure Inputs "What arrives at the node." $inputs);
        $crate::node!(@structure Outputs "What the node yields." $outputs);
        $crate::node!(@function body chosen $e $i Outputs<E, T>, $body);
        $crate::node!(@run [S: $crate::nodes::ports::Form] S, $inputs $outputs);
        $crate::node!(@generic [S: $crate::nodes::ports::Form] chosen $e $i $inputs false
            [scalar, vector, color, integer, boolean, transform]);
    };
    (@code [comparing] [] [$e:ident $i:ident $body:expr] $inputs:tt [] [] $outputs:tt) => {
        $crate::node!(@structure Inputs "What arrives at the node." $inputs);
        $crate::node!(@structure Outputs "What the node yields." $outputs);
        $crate::node!(@function body compared $e $i Outputs<E, T>, $body);
        $crate::node!(@run [] $crate::nodes::ports::scalar, $inputs $outputs);
        $crate::node!(@run_again [] $crate::nodes::ports::integer, $inputs $outputs);

        fn define(signature: $crate::nodes::Signature) -> $crate::nodes::Definition {
            $crate::nodes::Definition::of_bodies(signature, &[
                $crate::kernels::BodyForms::of::<NodeBody<$crate::nodes::ports::scalar>>(),
                $crate::kernels::BodyForms::of::<NodeBody<$crate::nodes::ports::integer>>(),
            ])
        }
    };
    (@code [per component] [] [$e:ident $i:ident $body:expr] $inputs:tt [] [] [$output:ident : generic;]) => {
        $crate::node!(@structure Inputs "What arrives at the node." $inputs);
        $crate::node!(@function component component $e $i E::Real, $body);
        $crate::node!(@run_components $inputs $inputs);
        $crate::node!(@generic [S: $crate::nodes::ports::Shape] generic $e $i $inputs true []);
    };
    (@code [$($kind:ident)*] $($rest:tt)*) => {
        compile_error!(concat!(
            "no node is of the kind `", stringify!($($kind)*), "` with these parts: there are none, `generic`, \
             `generic [TYPE, …]`, `every type`, `comparing` and `per component` (one generic output) with a body, `scope [FIELD, …]` with scoped input, \
             changes and a body, and `request EFFECT` and `structural [KIND]` without one"
        ));
    };

    // ---- overloads
    (@plain $e:ident $i:ident $inputs:tt) => {
        fn define(signature: $crate::nodes::Signature) -> $crate::nodes::Definition {
            let mut guards = $crate::node!(@guards [] $crate::nodes::ports::scalar, plain $e $i $inputs $inputs);
            // A scoped input stands last, and has none.
            guards.resize(signature.inputs.len(), None);
            let code = Some($crate::kernels::BodyForms::of::<NodeBody<$crate::nodes::ports::scalar>>());
            $crate::nodes::Definition::with_code(signature, code, guards)
        }
    };
    (@generic [$($bounds:tt)+] $mode:ident $e:ident $i:ident $inputs:tt $per_component:literal $types:tt) => {
        fn overload<$($bounds)+>() -> $crate::nodes::Overload {
            $crate::nodes::Overload {
                generic: Some(S::TYPE),
                code: Some($crate::kernels::BodyForms::of::<NodeBody<S>>()),
                guards: $crate::node!(@guards [$($bounds)+] S, $mode $e $i $inputs $inputs),
            }
        }

        fn define(signature: $crate::nodes::Signature) -> $crate::nodes::Definition {
            let overloads = $crate::node!(@overloads $types);
            $crate::nodes::Definition { signature, overloads, per_component: $per_component }
        }
    };

    (@overloads []) => { $crate::node!(@overloads [scalar, vector, color]) };
    (@overloads [$($type:ident),+]) => { vec![$(overload::<$crate::nodes::ports::$type>()),+] };
    (@known_types [$($input:ident : $itype:ident $annotations:tt;)*]) => { $($crate::node!(@known_type $itype);)* };
    (@known_type generic) => {
        compile_error!(
            "the body of a scope is the same for all types, so only what is scoped, and the output, are generic"
        );
    };
    (@known_type $known:ident) => {};

    // ---- code
    (@structure $structure:ident $doc:literal [$($field:ident : $type:ident $([$($annotation:tt)*])?;)*]) => {
        #[doc = $doc]
        struct $structure<E: $crate::emit::Emit, T: Copy = $crate::emit::One<<E as $crate::emit::Emit>::Real>> {
            $($field: <$crate::nodes::ports::$type as $crate::nodes::ports::Port>::Value<E, T>,)*
        }
    };
    // The names of back end and inputs are the node's, so that its expressions see them.
    (@function $function:ident plain $e:ident $i:ident $result:ty, $body:expr) => {
        #[inline(always)]
        fn $function<E: $crate::emit::Emit>($e: E, $i: &Inputs<E>) -> $result {
            let _ = ($e, $i);
            $body
        }
    };
    (@function $function:ident generic $e:ident $i:ident $result:ty, $body:expr) => {
        #[inline(always)]
        fn $function<E: $crate::emit::Emit, T: $crate::emit::Components<E::Real>>($e: E, $i: &Inputs<E, T>) -> $result {
            let _ = ($e, $i);
            $body
        }
    };
    (@function $function:ident chosen $e:ident $i:ident $result:ty, $body:expr) => {
        #[inline(always)]
        fn $function<E: $crate::emit::Emit, T: Copy + $crate::emit::Select<E::Mask>>($e: E, $i: &Inputs<E, T>) -> $result {
            let _ = ($e, $i);
            $body
        }
    };
    (@function $function:ident compared $e:ident $i:ident $result:ty, $body:expr) => {
        #[inline(always)]
        fn $function<E: $crate::emit::Emit, T: $crate::emit::Ordered<E::Mask>>($e: E, $i: &Inputs<E, T>) -> $result {
            let _ = ($e, $i);
            $body
        }
    };
    (@function $function:ident component $e:ident $i:ident $result:ty, $body:expr) => {
        #[inline(always)]
        fn $function<E: $crate::emit::Emit>($e: E, $i: &Inputs<E, E::Real>) -> $result {
            let _ = ($e, $i);
            $body
        }
    };
    (@load $shape:ty, $words:ident, [$($input:ident : $itype:ident $annotations:tt;)*]) => {{
        let mut at = 0;
        let inputs = Inputs::<E, <$shape as $crate::nodes::ports::Form>::Of<E>> {
            $($input: {
                let value = <$crate::nodes::ports::$itype as $crate::nodes::ports::Port>::load::<E, $shape>($words, at);
                at += const { $crate::nodes::ports::width::<$crate::nodes::ports::$itype, $shape>() };
                value
            },)*
        };
        let _ = at;
        inputs
    }};
    (@body_impl $bounds:tt $body:ident $shape:ty, $outputs:expr, |$emit:ident, $words:ident, $sink:ident| $run:block) => {
        #[doc = "Code of the node, over the type its generic inputs have."]
        #[derive(Debug)]
        pub struct $body<S>(std::marker::PhantomData<S>);

        $crate::node!(@run_impl $bounds $body $shape, $outputs, |$emit, $words, $sink| $run);
    };
    (@run_impl [$($bound:tt)*] $body:ident $shape:ty, $outputs:expr, |$emit:ident, $words:ident, $sink:ident| $run:block) => {
        impl<$($bound)*> $crate::emit::Body for $body<$shape> {
            const OUTPUTS: usize = $outputs;
            #[inline(always)]
            fn run<E: $crate::emit::Emit>(
                $emit: E,
                $words: &impl $crate::emit::Words<E>,
                $sink: &mut impl $crate::emit::Sink<E>,
            ) $run
        }
    };
    (@run $bounds:tt $shape:ty, $inputs:tt $outputs:tt) => {
        $crate::node!(@run_by body_impl $bounds $shape, $inputs $outputs);
    };
    (@run_again $bounds:tt $shape:ty, $inputs:tt $outputs:tt) => {
        $crate::node!(@run_by run_impl $bounds $shape, $inputs $outputs);
    };
    (@run_by $by:ident $bounds:tt $shape:ty, $inputs:tt [$($output:ident : $otype:ident;)+]) => {
        $crate::node!(@$by $bounds NodeBody $shape,
            0 $(+ $crate::nodes::ports::width::<$crate::nodes::ports::$otype, $shape>())+,
            |emit, words, sink| {
                let result = body(emit, &$crate::node!(@load $shape, words, $inputs));
                let mut at = 0;
                $(
                    <$crate::nodes::ports::$otype as $crate::nodes::ports::Computed>::store::<E, $shape>(sink, at, result.$output);
                    at += const { $crate::nodes::ports::width::<$crate::nodes::ports::$otype, $shape>() };
                )+
                let _ = at;
            });
    };
    (@run_components $inputs:tt [$first:ident : generic $annotations:tt; $($input:ident : $itype:ident $more:tt;)*]) => {
        $crate::node!(@body_impl [S: $crate::nodes::ports::Shape] NodeBody S, S::WIDTH, |emit, words, sink| {
            use $crate::emit::Components;
            let inputs = $crate::node!(@load S, words, $inputs);
            let mut result = inputs.$first.to_words();
            for (number, component_of_result) in result[..S::COMPONENTS].iter_mut().enumerate() {
                let inputs = Inputs::<E, E::Real> {
                    $first: inputs.$first.to_words()[number],
                    $($input: <$crate::nodes::ports::$itype as $crate::nodes::ports::Port>::component::<E, S>(inputs.$input, number),)*
                };
                *component_of_result = component(emit, &inputs);
            }
            S::write(sink, 0, S::Of::<E>::from_words(result));
        });
    };
    (@guards $bounds:tt $shape:ty, $mode:ident $e:ident $i:ident $inputs:tt [$($input:ident : $itype:ident [$($word:ident $value:tt)*];)*]) => {
        vec![$(None::<$crate::kernels::BodyForms>$(.or($crate::node!(@guard $bounds $shape, $mode $e $i $inputs $word $value)))*),*]
    };
    (@guard $bounds:tt $shape:ty, $mode:ident $e:ident $i:ident $inputs:tt when [$guard:expr]) => {{
        $crate::node!(@function holds $mode $e $i E::Mask, $guard);
        $crate::node!(@body_impl $bounds Guard $shape, 1, |emit, words, sink| {
            sink.mask(0, holds(emit, &$crate::node!(@load $shape, words, $inputs)));
        });
        Some($crate::kernels::BodyForms::of::<Guard<$shape>>())
    }};
    (@guard $bounds:tt $shape:ty, $mode:ident $e:ident $i:ident $inputs:tt $word:ident $value:tt) => { None };

    // ---- signature
    (@types [generic] [$($type:ident),+]) => { vec![$(<$crate::nodes::ports::$type as $crate::nodes::ports::Port>::TYPE),+] };
    (@types [every type] []) => { $crate::values::Type::COMPUTED.to_vec() };
    (@types [comparing] []) => { vec![$crate::values::Type::Scalar, $crate::values::Type::Integer] };
    (@types [structural] [$kind:expr]) => { $kind.generic().to_vec() };
    (@types $kind:tt $of:tt) => { $crate::values::Type::GENERIC.to_vec() };
    (@kind [] []) => { $crate::nodes::Kind::Plain };
    (@kind [generic] [$($type:ident),*]) => { $crate::nodes::Kind::Plain };
    (@kind [every type] []) => { $crate::nodes::Kind::Plain };
    (@kind [comparing] []) => { $crate::nodes::Kind::Plain };
    (@kind [per component] []) => { $crate::nodes::Kind::Plain };
    (@kind [request $effect:ident] []) => { $crate::nodes::Kind::Request($crate::effects::Effect::$effect) };
    (@kind [scope] [$($field:ident),+]) => { $crate::nodes::Kind::Scope(vec![$($crate::state::Field::$field),+]) };
    (@kind [structural] [$kind:expr]) => { $kind };
    (@input $input:ident [$($doc:literal)+] $type:ident [$default:expr] [$($word:ident $value:tt)*]) => {{
        let input = $crate::nodes::Input::of::<$crate::nodes::ports::$type>(
            stringify!($input),
            &[$($doc),+],
            $default,
        );
        $(let input = $crate::node!(@annotate input $word $value);)*
        input
    }};
    (@annotate $input:ident in [$range:expr]) => { $input.within($range) };
    (@annotate $input:ident avoid [$what:expr]) => {{
        use $crate::nodes::avoidable::*;
        $input.avoiding($what)
    }};
    (@annotate $input:ident when [$guard:expr]) => { $input.guarded() };
    (@annotate $input:ident under [$scope_and_input:expr]) => { $input.under($scope_and_input) };
    (@annotate $input:ident slope [$scope_and_input:expr]) => { $input.slope($scope_and_input) };
    (@annotate $input:ident list []) => { $input.list() };
    (@annotate $input:ident unit [$unit:expr]) => { $input.measured_in($unit) };
    (@annotate $input:ident soft [$range:expr]) => { $input.usually($range) };
    (@annotate $input:ident of [$choices:expr]) => { $input.one_of(&$choices) };
    (@annotate $input:ident $word:ident [$($value:expr)?]) => {
        compile_error!(concat!(
            "an input has no annotation `", stringify!($word $($value)?), "`: there are `in RANGE`, \
             `soft RANGE`, `unit TEXT`, `avoid zero`, `avoid negative`, `when CONDITION`, `list`, `of [NAME, …]`, `under (SCOPE, INPUT)` and `slope (SCOPE, INPUT)`"
        ))
    };
    (@output $output:ident [$($doc:literal)+] $type:ident [$($word:ident $value:tt)*]) => {{
        let output = $crate::nodes::Output::new(
            stringify!($output),
            &[$($doc),+],
            <$crate::nodes::ports::$type as $crate::nodes::ports::Port>::TYPE,
        );
        $(let output = $crate::node!(@annotate_output output $word $value);)*
        output
    }};
    (@annotate_output $output:ident in [$range:expr]) => { $output.within($range) };
    (@annotate_output $output:ident $word:ident [$($value:expr)?]) => {
        compile_error!(concat!(
            "an output has no annotation `", stringify!($word $($value)?), "`: there is `in RANGE`"
        ))
    };
}
