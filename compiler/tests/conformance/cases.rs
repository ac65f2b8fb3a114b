//! The operations and functions under test, one line each.

use std::ops::{Add, Div, Mul, Neg, Sub};

use phenomenon_compiler::emit::Body;
use phenomenon_compiler::emit::functions::conventions;
use phenomenon_compiler::emit::{
    Components, Emit, Int, Mask, Real, Sink, Table, Words, read_vector, write_vector,
};
use phenomenon_compiler::kernels::BodyForms;

/// What the 32 bits of a word mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    Real,
    Int,
    Mask,
}

/// One operation or function, compiled for every back end.
pub struct Case {
    /// Name; for a primitive that of its `Op`.
    pub name: &'static str,
    /// Whether it is one operation, and so checked against its definition directly.
    pub primitive: bool,
    /// The code.
    pub code: BodyForms,
    /// Its input words.
    pub inputs: &'static [Word],
    /// Its output words.
    pub outputs: &'static [Word],
}

macro_rules! case {
    (@word real) => { &[Word::Real] };
    (@word int) => { &[Word::Int] };
    (@word mask) => { &[Word::Mask] };
    (@word vector) => { &[Word::Real, Word::Real, Word::Real] };
    (@read $words:ident $at:ident vector) => {{ $at += 3; read_vector::<E>($words, $at - 3) }};
    (@read $words:ident $at:ident $kind:ident) => {{ $at += 1; $words.$kind($at - 1) }};
    (@write $sink:ident $value:ident vector) => { write_vector::<E>($sink, 0, $value) };
    (@write $sink:ident $value:ident $kind:ident) => { $sink.$kind(0, $value) };
    ($list:ident, $primitive:literal, $name:ident, |$($arg:ident : $kind:ident),+| -> $out:ident $value:expr) => {{
        struct Tested;
        impl Body for Tested {
            const OUTPUTS: usize = { let words: &[Word] = case!(@word $out); words.len() };
            #[inline(always)]
            fn run<E: Emit>(_: E, words: &impl Words<E>, sink: &mut impl Sink<E>) {
                let mut at = 0;
                $(let $arg = case!(@read words at $kind);)+
                let _ = at;
                let value = $value;
                case!(@write sink value $out);
            }
        }
        const INPUTS: &[&[Word]] = &[$(case!(@word $kind)),+];
        $list.push(Case {
            name: stringify!($name),
            primitive: $primitive,
            code: BodyForms::of::<Tested>(),
            inputs: INPUTS.concat().leak(),
            outputs: case!(@word $out),
        });
    }};
}

macro_rules! cases {
    ($function:ident, $primitive:literal: $($name:ident |$($arg:ident : $kind:ident),+| -> $out:ident $value:expr;)+) => {
        fn $function(list: &mut Vec<Case>) {
            $(case!(list, $primitive, $name, |$($arg : $kind),+| -> $out $value);)+
        }
    };
}

/// All of them.
pub fn cases() -> Vec<Case> {
    let mut list = vec![];
    table(&mut list);
    list.push(lookup());
    words(&mut list);
    compositions(&mut list);
    guarded(&mut list);
    list
}

/// A lookup, at positions within a table and outside.
fn lookup() -> Case {
    static NUMBERS: [f32; 7] = [0.0, -0.0, 1.5, f32::INFINITY, f32::NAN, 1e-45, -3.0];
    struct Tested;
    impl Body for Tested {
        const OUTPUTS: usize = 1;
        #[inline(always)]
        fn run<E: Emit>(e: E, words: &impl Words<E>, sink: &mut impl Sink<E>) {
            sink.real(0, e.table(const { Table::new(&NUMBERS) }, words.int(0)));
        }
    }
    Case {
        name: "Table",
        primitive: true,
        code: BodyForms::of::<Tested>(),
        inputs: &[Word::Int],
        outputs: &[Word::Real],
    }
}

/// The operations of the table. `Add` of two numbers is its variant over its operands.
macro_rules! table {
    (
        operators { $($operator:ident $operator_name:literal $both:ident $trait:ident::$call:ident $f:tt;)+ }
        methods { $($method:ident $method_name:literal $of:ident.$calls:ident($($operand:ident: $its:ident),*)
            -> $out:ident $g:tt;)+ }
        shifts { $($shift:ident $shift_calls:ident;)+ }
        words $words:tt
        functions { $($function:ident $function_calls:ident($($second:ident)?);)+ }
    ) => {
        fn table(list: &mut Vec<Case>) {
            $(case!(list, true, $operator, |a: $both, b: $both| -> $both $trait::$call(a, b));)+
            $(case!(list, true, $method, |a: $of $(, $operand: $its)*| -> $out a.$calls($($operand),*));)+
            $(
                case!(list, true, $shift, |a: int| -> int a.$shift_calls(5));
                case!(list, true, $shift, |a: int| -> int a.$shift_calls(31));
            )+
            $(case!(list, true, $function, |a: real $(, $second: real)?| -> real a.$function_calls($($second)?));)+
        }
    };
}
phenomenon_compiler::operations! {table}

// What works on words, for each meaning they may have.
cases! { words, true:
    And |a: int, b: int| -> int a & b;
    Or |a: int, b: int| -> int a | b;
    Xor |a: int, b: int| -> int a ^ b;
    And |a: mask, b: mask| -> mask a & b;
    Or |a: mask, b: mask| -> mask a | b;
    Xor |a: mask, b: mask| -> mask a ^ b;
    Not |a: mask| -> mask !a;
    Select |m: mask, a: real, b: real| -> real m.select(a, b);
    Select |m: mask, a: int, b: int| -> int m.select(a, b);
    Select |m: mask, a: mask, b: mask| -> mask m.select(a, b);
}

cases! { compositions, false:
    add_constant |a: real| -> real (a + 0.1) * 3.0 - 1e-3;
    same |a: real| -> real a / 0.7 + a.same(16_777_217.0);
    shift_by_nothing |a: int| -> int a.shift_left(0).shift_right(0).shift_right_signed(0);
    greater |a: real, b: real| -> mask a.greater(b) ^ a.greater_equal(b);
    clamp_to |a: real, b: real, c: real| -> real a.clamp_to(b, c);
    saturate |a: real| -> real a.saturate();
    divide_or_zero |a: real, b: real| -> real a.divide_or_zero(b);
    dot |a: vector, b: vector| -> real a.dot(b);
    cross |a: vector, b: vector| -> vector a.cross(b);
    length |a: vector| -> real a.length();
    normalized |a: vector| -> vector a.normalized();
    vector_minimum |a: vector, b: vector| -> vector Components::minimum(a, b);
    vector_scaled |a: vector, f: real| -> vector a * f;
}

cases! { guarded, false:
    clamp_finite |a: real| -> real conventions::clamp_finite(a);
    sqrt_or_zero |a: real| -> real conventions::sqrt_or_zero(a);
    ln_or_zero |a: real| -> real conventions::ln_or_zero(a);
    log2_or_zero |a: real| -> real conventions::log2_or_zero(a);
    asin_clamped |a: real| -> real conventions::asin_clamped(a);
    acos_clamped |a: real| -> real conventions::acos_clamped(a);
    pow_or_zero |x: real, y: real| -> real conventions::pow_or_zero(x, y);
    atan2_or_zero |y: real, x: real| -> real conventions::atan2_or_zero(y, x);
    modulo_or_zero |x: real, d: real| -> real conventions::modulo_or_zero(x, d);
    int_divide_or_zero |n: int, d: int| -> int conventions::int_divide_or_zero(n, d);
    int_modulo_or_zero |n: int, d: int| -> int conventions::int_modulo_or_zero(n, d);
}
