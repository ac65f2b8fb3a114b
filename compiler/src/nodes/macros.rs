//! The [`node!`](crate::node) macro: a node's signature, and the structures its body takes and
//! returns.

/// Declares a node in its file: `definition()` for the list, and the structures `Inputs<E>` and
/// `Outputs<E>` for `fn body<E: Emit>(emit: E, inputs: &Inputs<E>) -> Outputs<E>`, an ordinary
/// function below the macro.
///
/// Inputs stand in the order in which they are demanded. An input with `when guard` is demanded
/// only where `fn guard<E: Emit>(emit: E, inputs: &Inputs<E>) -> E::Mask` holds; the guard may look
/// at earlier inputs only. A body must not let an input that was not demanded show in its outputs.
/// `avoid zero` and `avoid negative` mark inputs that take any number, but mean nothing with such.
///
/// After the group's name may stand `generic` (bodies over `T: Components<E::Real>`, used with
/// scalar, vector and color inputs; all outputs generic), `request Effect` (no body), or
/// `scope [Field, …]` (the body returns `Changes<E>`, one for each field in order, and the `scoped`
/// input is evaluated under them).
#[macro_export]
macro_rules! node {
    // ---- generic nodes: one body, three types
    (
        $(#[doc = $doc:literal])+
        $name:ident in $group:ident generic, source $source:literal,
        inputs { $($(#[doc = $idoc:literal])+ $input:ident : $itype:ident = $default:expr $(, in $irange:expr)? $(, avoid $avoid:ident)? $(, when $guard:ident)?;)* }
        outputs { $($(#[doc = $odoc:literal])+ $output:ident : generic $(, in $orange:expr)?;)+ }
    ) => {
        /// What arrives at the node.
        #[expect(clippy::allow_attributes, reason = "a node may have no use for some of it")]
        #[allow(dead_code, reason = "a guard may be all that looks at an input")]
        struct Inputs<E: $crate::emit::Emit, T> {
            $($input: $crate::node!(@generic_type E, T, $itype),)*
            back_end: std::marker::PhantomData<(E, T)>,
        }

        /// What the node yields.
        struct Outputs<T> {
            $($output: T,)+
        }

        $crate::node!(@generic_body ScalarBody, One, [$($input : $itype,)*], [$($output : generic,)+]);
        $crate::node!(@generic_body VectorBody, Vector, [$($input : $itype,)*], [$($output : generic,)+]);
        $crate::node!(@generic_body ColorBody, Color, [$($input : $itype,)*], [$($output : generic,)+]);

        /// What the list of nodes holds of this node.
        pub fn definition() -> $crate::nodes::Definition {
            $crate::nodes::Definition {
                signature: $crate::node!(@signature [$($doc)+] $name $group $source,
                    [$($input [$($idoc)+] $itype [$default] [$($irange)?] [$($avoid)?] [$($guard)?] [];)*]
                    [$($output [$($odoc)+] generic [$($orange)?];)+]
                    $crate::nodes::Kind::Plain),
                overloads: vec![
                    $crate::nodes::Overload { generic: Some($crate::values::Type::Scalar), code: Some($crate::kernels::BodyForms::of::<ScalarBody>()), guards: $crate::node!(@generic_guards One [$($input : $itype,)*] [$([$($guard)?])*]) },
                    $crate::nodes::Overload { generic: Some($crate::values::Type::Vector), code: Some($crate::kernels::BodyForms::of::<VectorBody>()), guards: $crate::node!(@generic_guards Vector [$($input : $itype,)*] [$([$($guard)?])*]) },
                    $crate::nodes::Overload { generic: Some($crate::values::Type::Color), code: Some($crate::kernels::BodyForms::of::<ColorBody>()), guards: $crate::node!(@generic_guards Color [$($input : $itype,)*] [$([$($guard)?])*]) },
                ],
            }
        }
    };

    // ---- requests: no body
    (
        $(#[doc = $doc:literal])+
        $name:ident in $group:ident request $effect:ident, source $source:literal,
        inputs { $($(#[doc = $idoc:literal])+ $input:ident : $itype:ident = $default:expr $(, in $irange:expr)?;)* }
        outputs { $($(#[doc = $odoc:literal])+ $output:ident : $otype:ident $(, in $orange:expr)?;)+ }
    ) => {
        /// What the list of nodes holds of this node.
        pub fn definition() -> $crate::nodes::Definition {
            $crate::nodes::Definition {
                signature: $crate::node!(@signature [$($doc)+] $name $group $source,
                    [$($input [$($idoc)+] $itype [$default] [$($irange)?] [] [] [];)*]
                    [$($output [$($odoc)+] $otype [$($orange)?];)+]
                    $crate::nodes::Kind::Request($crate::effects::Effect::$effect)),
                overloads: vec![$crate::nodes::Overload {
                    generic: None,
                    code: None,
                    guards: vec![$($crate::node!(@nothing $input),)*],
                }],
            }
        }
    };

    // ---- scopes: the body yields changed fields
    (
        $(#[doc = $doc:literal])+
        $name:ident in $group:ident scope [$($field:ident),+ $(,)?], source $source:literal,
        inputs { $($(#[doc = $idoc:literal])+ $input:ident : $itype:ident = $default:expr $(, in $irange:expr)?;)* }
        scoped { $(#[doc = $sdoc:literal])+ $scoped:ident : $stype:ident = $sdefault:expr $(, in $srange:expr)?; }
        changes { $($change:ident : $ctype:ident;)+ }
        outputs { $($(#[doc = $odoc:literal])+ $output:ident : $otype:ident $(, in $orange:expr)?;)+ }
    ) => {
        $crate::node!(@inputs [$($input : $itype,)*]);
        $crate::node!(@structure Changes "What the scope changes." [$($change : $ctype,)+]);
        $crate::node!(@body Changes, [$($input : $itype,)*], [$($change : $ctype,)+]);

        /// What the list of nodes holds of this node.
        pub fn definition() -> $crate::nodes::Definition {
            $crate::nodes::Definition {
                signature: $crate::node!(@signature [$($doc)+] $name $group $source,
                    [$($input [$($idoc)+] $itype [$default] [$($irange)?] [] [] [];)* $scoped [$($sdoc)+] $stype [$sdefault] [$($srange)?] [] [] [scoped];]
                    [$($output [$($odoc)+] $otype [$($orange)?];)+]
                    $crate::nodes::Kind::Scope(vec![$($crate::state::Field::$field),+])),
                overloads: vec![$crate::nodes::Overload {
                    generic: None,
                    code: Some($crate::kernels::BodyForms::of::<NodeBody>()),
                    guards: vec![$($crate::node!(@nothing $input),)* None],
                }],
            }
        }
    };

    // ---- plain nodes
    (
        $(#[doc = $doc:literal])+
        $name:ident in $group:ident, source $source:literal,
        inputs { $($(#[doc = $idoc:literal])+ $input:ident : $itype:ident = $default:expr $(, in $irange:expr)? $(, avoid $avoid:ident)? $(, when $guard:ident)?;)* }
        outputs { $($(#[doc = $odoc:literal])+ $output:ident : $otype:ident $(, in $orange:expr)?;)+ }
    ) => {
        $crate::node!(@inputs [$($input : $itype,)*]);
        $crate::node!(@structure Outputs "What the node yields." [$($output : $otype,)+]);
        $crate::node!(@body Outputs, [$($input : $itype,)*], [$($output : $otype,)+]);

        /// What the list of nodes holds of this node.
        pub fn definition() -> $crate::nodes::Definition {
            $crate::nodes::Definition {
                signature: $crate::node!(@signature [$($doc)+] $name $group $source,
                    [$($input [$($idoc)+] $itype [$default] [$($irange)?] [$($avoid)?] [$($guard)?] [];)*]
                    [$($output [$($odoc)+] $otype [$($orange)?];)+]
                    $crate::nodes::Kind::Plain),
                overloads: vec![$crate::nodes::Overload {
                    generic: None,
                    code: Some($crate::kernels::BodyForms::of::<NodeBody>()),
                    guards: $crate::node!(@guards [$($input : $itype,)*] [$([$($guard)?])*]),
                }],
            }
        }
    };

    // ---- parts
    (@structure $structure:ident $doc:literal [$($field:ident : $type:ident,)*]) => {
        #[doc = $doc]
        struct $structure<E: $crate::emit::Emit> {
            $($field: $crate::node!(@type E, $type),)*
        }
    };
    (@inputs [$($field:ident : $type:ident,)*]) => {
        /// What arrives at the node.
        #[expect(clippy::allow_attributes, reason = "a node may have no use for some of it")]
        #[allow(dead_code, reason = "a guard may be all that looks at an input")]
        struct Inputs<E: $crate::emit::Emit> {
            $($field: $crate::node!(@type E, $type),)*
            back_end: std::marker::PhantomData<E>,
        }
    };
    (@body $result:ident, [$($input:ident : $itype:ident,)*], [$($output:ident : $otype:ident,)+]) => {
        struct NodeBody;

        impl $crate::emit::Body for NodeBody {
            const OUTPUTS: usize = 0 $(+ $crate::node!(@width $otype))+;
            #[inline(always)]
            fn run<E: $crate::emit::Emit>(
                emit: E,
                words: &impl $crate::emit::Words<E>,
                sink: &mut impl $crate::emit::Sink<E>,
            ) {
                let inputs = $crate::node!(@read E, emit, words, [$($input : $itype,)*]);
                let result: $result<E> = body(emit, &inputs);
                let mut at = 0;
                $($crate::node!(@write sink, at, result.$output, $otype);)+
                let _ = at;
            }
        }
    };
    (@read $e:ident, $emit:ident, $words:ident, [$($input:ident : $itype:ident,)*]) => {{
        let mut at = 0;
        let inputs = Inputs::<$e> {
            $($input: $crate::node!(@load $emit, $words, at, $itype),)*
            back_end: std::marker::PhantomData,
        };
        let _ = (at, inputs.back_end);
        inputs
    }};
    (@generic_read $shape:ident, $e:ident, $emit:ident, $words:ident, [$($input:ident : $itype:ident,)*]) => {{
        let mut at = 0;
        let inputs = Inputs::<$e, $crate::emit::$shape<$e::Real>> {
            $($input: $crate::node!(@generic_load $shape, $emit, $words, at, $itype),)*
            back_end: std::marker::PhantomData,
        };
        let _ = (at, inputs.back_end);
        inputs
    }};
    (@generic_body $body:ident, $shape:ident, [$($input:ident : $itype:ident,)*], [$($output:ident : $otype:ident,)+]) => {
        struct $body;

        impl $crate::emit::Body for $body {
            const OUTPUTS: usize = 0 $(+ $crate::node!(@generic_width $shape, $otype))+;
            #[inline(always)]
            fn run<E: $crate::emit::Emit>(
                emit: E,
                words: &impl $crate::emit::Words<E>,
                sink: &mut impl $crate::emit::Sink<E>,
            ) {
                let inputs = $crate::node!(@generic_read $shape, E, emit, words, [$($input : $itype,)*]);
                let result: Outputs<$crate::emit::$shape<E::Real>> = body(emit, &inputs);
                let mut at = 0;
                $($crate::node!(@generic_write $shape, sink, at, result.$output, $otype);)+
                let _ = at;
            }
        }
    };

    (@type $e:ident, scalar) => { $e::Real };
    (@type $e:ident, integer) => { $e::Int };
    (@type $e:ident, boolean) => { $e::Mask };
    (@type $e:ident, vector) => { $crate::emit::Vector<$e::Real> };
    (@type $e:ident, color) => { $crate::emit::Color<$e::Real> };
    (@type $e:ident, lights) => { () };
    (@type $e:ident, light) => { () };
    (@type $e:ident, texture) => { () };
    (@type $e:ident, string) => { $e::Int };
    (@type $e:ident, transform) => { $crate::emit::Transform<$e::Real> };
    (@type $e:ident, shader) => { $crate::emit::Color<$e::Real> };
    (@generic_type $e:ident, $t:ident, generic) => { $t };
    (@generic_type $e:ident, $t:ident, $type:ident) => { $crate::node!(@type $e, $type) };

    (@width vector) => { 3 };
    (@width color) => { 4 };
    (@width lights) => { 0 };
    (@width light) => { 0 };
    (@width texture) => { 0 };
    (@width transform) => { 16 };
    (@width shader) => { 4 };
    (@width $type:ident) => { 1 };
    (@generic_width One, generic) => { 1 };
    (@generic_width Vector, generic) => { 3 };
    (@generic_width Color, generic) => { 4 };
    (@generic_width $shape:ident, $type:ident) => { $crate::node!(@width $type) };

    (@load $emit:ident, $words:ident, $at:ident, $type:ident) => {{
        let value = $crate::node!(@load_at $words, $at, $type);
        $at += $crate::node!(@width $type);
        value
    }};
    (@load_at $words:ident, $at:ident, scalar) => { $words.real($at) };
    (@load_at $words:ident, $at:ident, integer) => { $words.int($at) };
    (@load_at $words:ident, $at:ident, boolean) => { $words.mask($at) };
    (@load_at $words:ident, $at:ident, vector) => { $crate::emit::read_vector::<E>($words, $at) };
    (@load_at $words:ident, $at:ident, color) => { $crate::emit::read_color::<E>($words, $at) };
    (@load_at $words:ident, $at:ident, lights) => { () };
    (@load_at $words:ident, $at:ident, light) => { () };
    (@load_at $words:ident, $at:ident, texture) => { () };
    (@load_at $words:ident, $at:ident, string) => { $words.int($at) };
    (@load_at $words:ident, $at:ident, transform) => { $crate::emit::read_transform::<E>($words, $at) };
    (@load_at $words:ident, $at:ident, shader) => { $crate::emit::read_color::<E>($words, $at) };
    (@generic_load One, $emit:ident, $words:ident, $at:ident, generic) => {{
        let value = $crate::emit::One { x: $words.real($at) };
        $at += 1;
        value
    }};
    (@generic_load Vector, $emit:ident, $words:ident, $at:ident, generic) => {
        $crate::node!(@load $emit, $words, $at, vector)
    };
    (@generic_load Color, $emit:ident, $words:ident, $at:ident, generic) => {
        $crate::node!(@load $emit, $words, $at, color)
    };
    (@generic_load $shape:ident, $emit:ident, $words:ident, $at:ident, $type:ident) => {
        $crate::node!(@load $emit, $words, $at, $type)
    };

    (@write $sink:ident, $at:ident, $value:expr, scalar) => {{ $sink.real($at, $value); $at += 1; }};
    (@write $sink:ident, $at:ident, $value:expr, integer) => {{ $sink.int($at, $value); $at += 1; }};
    (@write $sink:ident, $at:ident, $value:expr, boolean) => {{ $sink.mask($at, $value); $at += 1; }};
    (@write $sink:ident, $at:ident, $value:expr, vector) => {{ $crate::emit::write_vector($sink, $at, $value); $at += 3; }};
    (@write $sink:ident, $at:ident, $value:expr, color) => {{ $crate::emit::write_color($sink, $at, $value); $at += 4; }};
    (@generic_write One, $sink:ident, $at:ident, $value:expr, generic) => {{ $sink.real($at, $value.x); $at += 1; }};
    (@generic_write Vector, $sink:ident, $at:ident, $value:expr, generic) => { $crate::node!(@write $sink, $at, $value, vector) };
    (@generic_write Color, $sink:ident, $at:ident, $value:expr, generic) => { $crate::node!(@write $sink, $at, $value, color) };
    (@generic_write $shape:ident, $sink:ident, $at:ident, $value:expr, $type:ident) => { $crate::node!(@write $sink, $at, $value, $type) };

    (@nothing $input:ident) => { None };
    (@guards $inputs:tt [$([$($guard:ident)?])*]) => { vec![$($crate::node!(@guard $inputs $($guard)?)),*] };
    (@guard $inputs:tt) => { None };
    (@guard [$($input:ident : $itype:ident,)*] $guard:ident) => {{
        struct Guard;
        impl $crate::emit::Body for Guard {
            const OUTPUTS: usize = 1;
            #[inline(always)]
            fn run<E: $crate::emit::Emit>(
                emit: E,
                words: &impl $crate::emit::Words<E>,
                sink: &mut impl $crate::emit::Sink<E>,
            ) {
                let inputs = $crate::node!(@read E, emit, words, [$($input : $itype,)*]);
                sink.mask(0, $guard(emit, &inputs));
            }
        }
        Some($crate::kernels::BodyForms::of::<Guard>())
    }};

    (@generic_guards $shape:ident $inputs:tt [$([$($guard:ident)?])*]) => { vec![$($crate::node!(@generic_guard $shape $inputs $($guard)?)),*] };
    (@generic_guard $shape:ident $inputs:tt) => { None };
    (@generic_guard $shape:ident [$($input:ident : $itype:ident,)*] $guard:ident) => {{
        struct Guard;
        impl $crate::emit::Body for Guard {
            const OUTPUTS: usize = 1;
            #[inline(always)]
            fn run<E: $crate::emit::Emit>(
                emit: E,
                words: &impl $crate::emit::Words<E>,
                sink: &mut impl $crate::emit::Sink<E>,
            ) {
                let inputs = $crate::node!(@generic_read $shape, E, emit, words, [$($input : $itype,)*]);
                sink.mask(0, $guard(emit, &inputs));
            }
        }
        Some($crate::kernels::BodyForms::of::<Guard>())
    }};

    (@kind scalar) => { $crate::values::Type::Scalar };
    (@kind integer) => { $crate::values::Type::Integer };
    (@kind boolean) => { $crate::values::Type::Boolean };
    (@kind vector) => { $crate::values::Type::Vector };
    (@kind color) => { $crate::values::Type::Color };
    (@kind lights) => { $crate::values::Type::Lights };
    (@kind light) => { $crate::values::Type::Light };
    (@kind texture) => { $crate::values::Type::Texture };
    (@kind string) => { $crate::values::Type::String };
    (@kind transform) => { $crate::values::Type::Transform };
    (@kind shader) => { $crate::values::Type::Shader };
    (@kind generic) => { $crate::values::Type::Generic };

    (@range) => { $crate::nodes::FINITE };
    (@range $range:expr) => { $range };
    (@avoid) => { None };
    (@avoid zero) => { Some($crate::nodes::Avoid::Zero) };
    (@avoid negative) => { Some($crate::nodes::Avoid::Negative) };
    (@flag) => { false };
    (@flag $word:ident) => { true };

    (@signature [$($doc:literal)+] $name:ident $group:ident $source:literal,
        [$($input:ident [$($idoc:literal)+] $itype:ident [$default:expr] [$($irange:expr)?] [$($avoid:ident)?] [$($guard:ident)?] [$($scoped:ident)?];)*]
        [$($output:ident [$($odoc:literal)+] $otype:ident [$($orange:expr)?];)+]
        $kind:expr) => {
        $crate::nodes::Signature {
            name: stringify!($name),
            group: stringify!($group),
            doc: $crate::nodes::paragraph(&[$($doc),+]),
            source: $source,
            inputs: vec![$($crate::nodes::Input {
                name: stringify!($input),
                doc: $crate::nodes::paragraph(&[$($idoc),+]),
                value_type: $crate::node!(@kind $itype),
                default: $default.into(),
                range: $crate::node!(@range $($irange)?),
                avoid: $crate::node!(@avoid $($avoid)?),
                guarded: $crate::node!(@flag $($guard)?),
                scoped: $crate::node!(@flag $($scoped)?),
                list: false,
            },)*],
            outputs: vec![$($crate::nodes::Output {
                name: stringify!($output),
                doc: $crate::nodes::paragraph(&[$($odoc),+]),
                value_type: $crate::node!(@kind $otype),
                range: $crate::node!(@range $($orange)?),
            },)+],
            kind: $kind,
        }
    };
}
