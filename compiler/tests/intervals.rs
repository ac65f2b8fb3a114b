//! What a body yields lies in the set its intervals give, for every operation and function; nodes have it
//! in their suite.

use phenomenon_compiler::emit::Body;
use phenomenon_compiler::emit::functions::conventions;
use phenomenon_compiler::emit::interval::{Interval, Word};
use phenomenon_compiler::emit::{Emit, Int, Mask, Real, Sink, Table, Words};
use phenomenon_compiler::kernels::BodyForms;
use phenomenon_compiler::testing::sets::hold;
use phenomenon_compiler::values::Type;

macro_rules! bodies {
    ($($name:ident ($($input:ident : $type:ident $read:ident),*) $write:ident |$e:ident| $value:expr;)+) => {$({
        struct Tried;
        impl Body for Tried {
            const OUTPUTS: usize = 1;
            fn run<E: Emit>($e: E, words: &impl Words<E>, sink: &mut impl Sink<E>) {
                let _ = $e;
                let mut at = 0;
                $(let $input = words.$read(at); at += 1;)*
                let _ = at;
                sink.$write(0, $value);
            }
        }
        hold(stringify!($name), &BodyForms::of::<Tried>(), &[$(Type::$type),*]);
    })+};
}

#[test]
fn operations_stay_in_their_sets() {
    bodies! {
        add(a: Scalar real, b: Scalar real) real |e| a + b;
        subtract(a: Scalar real, b: Scalar real) real |e| a - b;
        multiply(a: Scalar real, b: Scalar real) real |e| a * b;
        divide(a: Scalar real, b: Scalar real) real |e| a / b;
        negate(a: Scalar real) real |e| -a;
        multiply_add(a: Scalar real, b: Scalar real, c: Scalar real) real |e| a.mul_add(b, c);
        minimum(a: Scalar real, b: Scalar real) real |e| a.minimum(b);
        maximum(a: Scalar real, b: Scalar real) real |e| a.maximum(b);
        absolute(a: Scalar real) real |e| a.absolute();
        square_root(a: Scalar real) real |e| a.sqrt();
        floor(a: Scalar real) real |e| a.floor();
        ceil(a: Scalar real) real |e| a.ceil();
        truncate(a: Scalar real) real |e| a.truncate();
        round_even(a: Scalar real) real |e| a.round_even();
        less(a: Scalar real, b: Scalar real) mask |e| a.less(b);
        less_equal(a: Scalar real, b: Scalar real) mask |e| a.less_equal(b);
        equal(a: Scalar real, b: Scalar real) mask |e| a.equal(b);
        not_equal(a: Scalar real, b: Scalar real) mask |e| a.not_equal(b);
        to_int(a: Scalar real) int |e| a.to_int();
        divide_or_zero(a: Scalar real, b: Scalar real) real |e| a.divide_or_zero(b);
        constants(a: Scalar real) real |e| (a + 0.1) * 3.0 / e.real(-7.0) - 0.0;
        int_add(a: Integer int, b: Integer int) int |e| a + b;
        int_subtract(a: Integer int, b: Integer int) int |e| a - b;
        int_multiply(a: Integer int, b: Integer int) int |e| a * b;
        int_and(a: Integer int, b: Integer int) int |e| a & b;
        int_or(a: Integer int, b: Integer int) int |e| a | b;
        int_xor(a: Integer int, b: Integer int) int |e| a ^ b;
        int_sign(a: Integer int) int |e| (a ^ e.int(i32::MIN)) & e.int(i32::MIN);
        int_shifts(a: Integer int) int |e| a.shift_left(3) ^ a.shift_right(5);
        int_no_shift(a: Integer int) int |e| a.shift_right(0);
        int_shift_signed(a: Integer int) int |e| a.shift_right_signed(23);
        int_equal(a: Integer int, b: Integer int) mask |e| a.equal(b);
        int_less(a: Integer int, b: Integer int) mask |e| a.less(b);
        lookup(a: Integer int) real |e| e.table(Table::new(&[0.5, -0.0, 3.0, -1e30, 1e-45]), a);
        int_to_real(a: Integer int) real |e| a.to_real();
        and(a: Boolean mask, b: Boolean mask) mask |e| a & b;
        or(a: Boolean mask, b: Boolean mask) mask |e| a | b;
        xor(a: Boolean mask, b: Boolean mask) mask |e| (a ^ b) & !e.mask(false);
        select(m: Boolean mask, a: Scalar real, b: Scalar real) real |e| m.select(a, b);
        select_int(m: Boolean mask, a: Integer int, b: Integer int) int |e| m.select(a, b);
        select_mask(m: Boolean mask, a: Boolean mask, b: Boolean mask) mask |e| m.select(a, b);
        select_compared(a: Scalar real, b: Scalar real) real |e| a.less(b).select(b - a, a - b);
    }
}

#[test]
fn functions_stay_in_their_sets() {
    bodies! {
        exp(a: Scalar real) real |e| a.exp();
        exp2(a: Scalar real) real |e| a.exp2();
        expm1(a: Scalar real) real |e| a.expm1();
        ln(a: Scalar real) real |e| a.ln();
        log2(a: Scalar real) real |e| a.log2();
        log1p(a: Scalar real) real |e| a.log1p();
        pow(a: Scalar real, b: Scalar real) real |e| a.pow(b);
        sin(a: Scalar real) real |e| a.sin();
        cos(a: Scalar real) real |e| a.cos();
        tan(a: Scalar real) real |e| a.tan();
        asin(a: Scalar real) real |e| a.asin();
        acos(a: Scalar real) real |e| a.acos();
        atan(a: Scalar real) real |e| a.atan();
        atan2(a: Scalar real, b: Scalar real) real |e| a.atan2(b);
        sinh(a: Scalar real) real |e| a.sinh();
        cosh(a: Scalar real) real |e| a.cosh();
        tanh(a: Scalar real) real |e| a.tanh();
        clamp_finite(a: Scalar real) real |e| conventions::clamp_finite(a);
        modulo(a: Scalar real, b: Scalar real) real |e| conventions::modulo_or_zero(a, b);
        pow_or_zero(a: Scalar real, b: Scalar real) real |e| conventions::pow_or_zero(a, b);
        int_divide(a: Integer int, b: Integer int) int |e| conventions::int_divide_or_zero(a, b);
    }
}

/// The interval of one output word of a body.
fn interval(code: &BodyForms, inputs: &[Word]) -> Interval {
    let mut outputs = vec![Word::UNKNOWN; code.outputs()];
    code.intervals(inputs, &mut outputs);
    match outputs[0] {
        Word::Number(interval) => interval,
        other => panic!("{other:?}"),
    }
}

#[test]
fn sets_are_no_wider_than_they_must_be() {
    let number = |low, high, name| Word::Number(Interval::between(low, high, 0, name));
    macro_rules! of {
        ($inputs:expr, |$a:ident, $b:ident| $value:expr) => {{
            struct Tried;
            impl Body for Tried {
                const OUTPUTS: usize = 1;
                fn run<E: Emit>(_: E, words: &impl Words<E>, sink: &mut impl Sink<E>) {
                    let ($a, $b) = (words.real(0), words.real(1));
                    let _ = ($a, $b);
                    sink.real(0, $value);
                }
            }
            let found = interval(&BodyForms::of::<Tried>(), &$inputs);
            (found.low, found.high, found.nan)
        }};
    }
    let two = [number(-1.0, 3.0, 1), number(2.0, 4.0, 2)];
    let one = [number(-1.0, 3.0, 1), number(-1.0, 3.0, 1)];
    assert_eq!(of!(two, |a, b| a + b), (1.0, 7.0, false));
    assert_eq!(of!(two, |a, b| a * b), (-4.0, 12.0, false));
    assert_eq!(of!(two, |a, b| a / b), (-0.5, 1.5, false));
    assert_eq!(of!(two, |a, b| a.mul_add(b, a)), (-5.0, 15.0, false));
    assert_eq!(of!(one, |a, b| a - b), (0.0, 0.0, false));
    assert_eq!(of!(one, |a, b| a * b), (0.0, 9.0, false));
    assert_eq!(of!(one, |a, b| (a + 1.0) - (b + 1.0)), (0.0, 0.0, false));
    assert_eq!(of!(one, |a, b| a.mul_add(b, a.same(2.0))), (2.0, 11.0, false));
    assert_eq!(of!(two, |a, b| a.divide_or_zero(b)), (-0.5, 1.5, false));
    assert_eq!(of!(two, |a, b| a.saturate() + b.floor()), (2.0, 5.0, false));
    assert_eq!(of!(two, |a, b| b.sqrt()), (2.0_f32.sqrt(), 2.0, false));
    assert_eq!(of!(two, |a, b| a.sqrt()), (0.0, 3.0_f32.sqrt(), true));
    let angles = [number(0.0, 1.0, 1), number(-1.0, 1.0, 2)];
    let near = |found: (f32, f32, bool), low: f32, high: f32| {
        let (from, to, nan) = found;
        let close = |a: f32, b: f32| (a - b).abs() <= 1e-6 * b.abs();
        assert!(close(from, low) && close(to, high) && !nan, "{found:?}, not {low} to {high}");
    };
    near(of!(angles, |a, b| a.sin()), 0.0, 1.0_f32.sin());
    near(of!(angles, |a, b| b.cos()), 1.0_f32.cos(), 1.0);
    near(of!(angles, |a, b| (a * 2.0).sin()), 0.0, 1.0);
    near(of!(angles, |a, b| b.exp()), 1.0_f32.exp().recip(), 1.0_f32.exp());
    near(of!(angles, |a, b| b.acos()), 0.0, std::f32::consts::PI);
    near(of!(angles, |a, b| b.cosh()), 1.0, 1.0_f32.cosh());
    near(of!(angles, |a, b| (a + 1.0).ln()), 0.0, 2.0_f32.ln());
    near(of!(angles, |a, b| (a + 1.0).pow(a * 3.0)), 1.0, 8.0);
    near(of!(angles, |a, b| b.pow(b.same(2.0))), 0.0, 1.0);
    near(of!(angles, |a, b| b.atan2(a + 1.0)), -1.0_f32.atan(), 1.0_f32.atan());
    assert_eq!(of!(angles, |a, b| b.ln()), (f32::NEG_INFINITY, 0.0, true));
    // A constant goes through everything.
    let seven = [number(7.0, 7.0, 0), number(0.5, 0.5, 0)];
    let expected = 7.0_f32.sin();
    let (low, high, _) = of!(seven, |a, b| a.sin());
    assert!(low == high && (low - expected).abs() < 1e-6, "{low} {high}");
}

#[test]
fn what_nothing_is_known_of_is_never_one_value() {
    let unknown = [Word::UNKNOWN, Word::UNKNOWN];
    struct Tried;
    impl Body for Tried {
        const OUTPUTS: usize = 1;
        fn run<E: Emit>(_: E, words: &impl Words<E>, sink: &mut impl Sink<E>) {
            sink.real(0, (words.real(0) + 1.0) - (words.real(1) + 1.0));
        }
    }
    let difference = interval(&BodyForms::of::<Tried>(), &unknown);
    assert!(difference.contains(5.0) && difference.contains(f32::NAN), "{difference:?}");
}
