//! The conventions of `docs/numerics.md`, one test a row.

use phenomenon_compiler::emit::functions::conventions::*;
use phenomenon_compiler::emit::scalar::{F32, I32};
use phenomenon_compiler::emit::{Real, Vector};

const NAN: f32 = f32::NAN;
const INF: f32 = f32::INFINITY;

/// Zeros, extremes, and numbers of every size, both signs.
fn finite() -> Vec<f32> {
    let mut values = vec![
        0.0,
        f32::from_bits(1),
        f32::MIN_POSITIVE,
        1e-30,
        1e-5,
        0.1,
        0.5,
        1.0,
        1.0f32.next_up(),
        1.0f32.next_down(),
        1.5,
        2.0,
        2.5,
        3.0,
        7.25,
        100.0,
        16_777_216.0,
        3e9,
        1e20,
        3e38,
        f32::MAX,
    ];
    let negative: Vec<f32> = values.iter().map(|x| -x).collect();
    values.extend(negative);
    values
}

/// Bits compared, so that -0 is not 0.
#[track_caller]
fn is(actual: F32, expected: f32) {
    assert_eq!(actual.0.to_bits(), expected.to_bits(), "{actual:?}, not {expected}");
}

#[test]
fn division_by_zero_gives_zero() {
    for x in finite().into_iter().chain([INF, -INF, NAN]) {
        is(F32(x).divide_or_zero(F32(0.0)), 0.0);
        is(F32(x).divide_or_zero(F32(-0.0)), 0.0);
    }
    is(F32(-6.0).divide_or_zero(F32(1.5)), -4.0);
}

#[test]
fn a_square_root_below_zero_is_zero() {
    for x in finite().into_iter().filter(|x| *x <= 0.0).chain([-INF, NAN]) {
        is(sqrt_or_zero(F32(x)), 0.0);
    }
    is(sqrt_or_zero(F32(6.25)), 2.5);
}

#[test]
fn a_logarithm_of_nothing_is_zero() {
    for x in finite().into_iter().filter(|x| *x <= 0.0).chain([-INF, NAN]) {
        is(ln_or_zero(F32(x)), 0.0);
        is(log2_or_zero(F32(x)), 0.0);
    }
    is(ln_or_zero(F32(1.0)), 0.0);
    is(log2_or_zero(F32(f32::from_bits(1))), -149.0);
}

#[test]
fn powers() {
    for y in [0.0, -0.0] {
        for x in finite().into_iter().chain([INF, -INF, NAN]) {
            is(pow_or_zero(F32(x), F32(y)), 1.0);
        }
    }
    for zero in [0.0, -0.0] {
        for y in finite().into_iter().filter(|y| *y != 0.0).chain([INF, -INF, NAN]) {
            is(pow_or_zero(F32(zero), F32(y)), 0.0);
        }
    }
    for x in finite().into_iter().filter(|x| *x < 0.0) {
        for y in [0.5, -0.5, 2.5, -1.5, 1e-30, 8_388_606.5] {
            is(pow_or_zero(F32(x), F32(y)), 0.0);
        }
    }
    is(pow_or_zero(F32(-2.0), F32(3.0)), -8.0);
    is(pow_or_zero(F32(-2.0), F32(-2.0)), 0.25);
    is(pow_or_zero(F32(-1.0), F32(16_777_216.0)), 1.0);
    is(pow_or_zero(F32(1e30), F32(2.0)), f32::MAX);
    is(pow_or_zero(F32(-1e30), F32(3.0)), f32::MIN);
    is(pow_or_zero(F32(NAN), F32(2.0)), 0.0);
}

#[test]
fn inverse_functions_clamp_their_argument() {
    for x in finite().into_iter().filter(|x| *x >= 1.0).chain([INF]) {
        is(acos_clamped(F32(x)), 0.0);
        is(asin_clamped(F32(x)), std::f32::consts::FRAC_PI_2);
        is(acos_clamped(F32(-x)), std::f32::consts::PI);
        is(asin_clamped(F32(-x)), -std::f32::consts::FRAC_PI_2);
    }
    is(acos_clamped(F32(NAN)), std::f32::consts::PI);
    is(asin_clamped(F32(NAN)), -std::f32::consts::FRAC_PI_2);
}

#[test]
fn the_angle_of_the_origin_is_zero() {
    for x in [0.0, -0.0] {
        for y in [0.0, -0.0] {
            is(atan2_or_zero(F32(y), F32(x)), 0.0);
        }
    }
    is(atan2_or_zero(F32(0.0), F32(-1.0)), std::f32::consts::PI);
    is(atan2_or_zero(F32(-0.0), F32(-1.0)), -std::f32::consts::PI);
    is(atan2_or_zero(F32(1.0), F32(0.0)), std::f32::consts::FRAC_PI_2);
}

#[test]
fn a_zero_vector_normalises_to_zero() {
    for v in [
        [0.0, 0.0, 0.0],
        [-0.0, 0.0, -0.0],
        [NAN, 1.0, 1.0],
        [1.0, NAN, 2.0],
        [1.0, 2.0, NAN],
        [INF, 0.0, 0.0],
    ] {
        let Vector { x, y, z } = Vector { x: F32(v[0]), y: F32(v[1]), z: F32(v[2]) }.normalized();
        assert_eq!([x.0, y.0, z.0], [0.0; 3], "{v:?}");
    }
    for scale in [f32::from_bits(1), f32::MIN_POSITIVE, 1.0, f32::MAX] {
        let unit = Vector { x: F32(scale), y: F32(-scale), z: F32(scale) }.normalized();
        assert!((unit.dot(unit).0 - 1.0).abs() <= 2.0 * f32::EPSILON, "{scale:e}");
        assert!((unit.x.0 - 1.0 / 3f32.sqrt()).abs() <= f32::EPSILON, "{scale:e}");
    }
}

#[test]
fn modulo_takes_the_sign_of_the_divisor() {
    for (x, divisor, expected) in [
        (5.5, 2.0, 1.5),
        (-5.5, 2.0, 0.5),
        (5.5, -2.0, -0.5),
        (-5.5, -2.0, -1.5),
        (1.0, 0.1, 1.0f32.rem_euclid(0.1)),
        (6.0, 3.0, 0.0),
        (-1e-10, 1.0, 0.0),
        (1e30, 1e-30, 0.0),
        (7.0, INF, 0.0),
    ] {
        assert_eq!(modulo_or_zero(F32(x), F32(divisor)).0, expected, "{x} mod {divisor}");
    }
    for x in finite().into_iter().chain([INF, -INF, NAN]) {
        for divisor in finite().into_iter().chain([INF, -INF, NAN]) {
            let rest = modulo_or_zero(F32(x), F32(divisor)).0;
            let size = divisor.abs();
            let inside = rest == 0.0 || (rest.abs() < size && (rest < 0.0) == (divisor < 0.0));
            assert!(inside, "{x:e} mod {divisor:e} is {rest:e}");
        }
        assert_eq!(modulo_or_zero(F32(x), F32(0.0)).0, 0.0);
        assert_eq!(modulo_or_zero(F32(x), F32(-0.0)).0, 0.0);
    }
}

#[test]
fn integers_divide_downwards() {
    for (n, divisor, expected) in
        [(7, 2, 3), (-7, 2, -4), (7, -2, -4), (-7, -2, 3), (7, 0, 0), (0, 0, 0)]
    {
        assert_eq!(int_divide_or_zero(I32(n), I32(divisor)).0, expected, "{n} / {divisor}");
    }
}

#[test]
fn integers_divide_exactly() {
    let near = |x: i64| [x - 2, x - 1, x, x + 1, x + 2];
    let powers = (0..32).flat_map(|power| near(1 << power)).chain(near(1_000_000_007));
    let hard: Vec<i32> =
        powers.flat_map(|x| [x, -x]).filter_map(|x| i32::try_from(x).ok()).collect();
    for (n, divisor) in hard.iter().flat_map(|&n| hard.iter().map(move |&divisor| (n, divisor))) {
        let (wide, by) = (i64::from(n), i64::from(divisor));
        let (quotient, rest) = match by {
            0 => (0, 0),
            _ => {
                let down = wide.div_euclid(by) - i64::from(by < 0 && wide.rem_euclid(by) != 0);
                (down, wide - down * by)
            }
        };
        assert_eq!(int_divide_or_zero(I32(n), I32(divisor)).0, quotient as i32, "{n} / {divisor}");
        assert_eq!(int_modulo_or_zero(I32(n), I32(divisor)).0, rest as i32, "{n} mod {divisor}");
    }
}

#[test]
fn saturate_and_clamp_turn_nan_into_the_lower_end() {
    is(F32(NAN).saturate(), 0.0);
    is(F32(INF).saturate(), 1.0);
    is(F32(-INF).saturate(), 0.0);
    is(F32(NAN).clamp_to(F32(-3.0), F32(2.0)), -3.0);
}

#[test]
fn minimum_and_maximum_yield_the_second_for_nan_and_for_equal_zeros() {
    is(F32(NAN).minimum(F32(1.0)), 1.0);
    assert!(F32(1.0).minimum(F32(NAN)).0.is_nan());
    is(F32(-0.0).minimum(F32(0.0)), 0.0);
    is(F32(0.0).minimum(F32(-0.0)), -0.0);
    is(F32(NAN).maximum(F32(1.0)), 1.0);
    assert!(F32(1.0).maximum(F32(NAN)).0.is_nan());
    is(F32(-0.0).maximum(F32(0.0)), 0.0);
    is(F32(0.0).maximum(F32(-0.0)), -0.0);
}

#[test]
fn numbers_become_integers_by_clamping() {
    for (x, expected) in [
        (NAN, 0),
        (INF, i32::MAX),
        (-INF, i32::MIN),
        (2_147_483_648.0, i32::MAX),
        (2_147_483_520.0, 2_147_483_520),
        (-2_147_483_648.0, i32::MIN),
        (-2.9, -2),
        (2.9, 2),
    ] {
        assert_eq!(F32(x).to_int().0, expected, "{x}");
    }
}

#[test]
fn what_is_not_finite_is_made_finite() {
    is(clamp_finite(F32(NAN)), 0.0);
    is(clamp_finite(F32(INF)), f32::MAX);
    is(clamp_finite(F32(-INF)), f32::MIN);
    [NAN, -INF, -1.0, -0.0].into_iter().for_each(|x| is(not_negative(F32(x)), 0.0));
    is(not_negative(F32(INF)), f32::MAX);
    is(not_negative(F32(1e-45)), 1e-45);
    finite().into_iter().for_each(|x| is(clamp_finite(F32(x)), x));
}

#[test]
fn finite_numbers_give_finite_numbers() {
    for x in finite() {
        let a = F32(x);
        let one = [
            clamp_finite(a),
            sqrt_or_zero(a),
            ln_or_zero(a),
            log2_or_zero(a),
            asin_clamped(a),
            acos_clamped(a),
        ];
        one.into_iter().for_each(|y| assert!(y.0.is_finite(), "{x:e}: {y:?}"));
        for y in finite() {
            let b = F32(y);
            let two = [pow_or_zero(a, b), atan2_or_zero(a, b), modulo_or_zero(a, b)];
            two.into_iter().for_each(|z| assert!(z.0.is_finite(), "{x:e}, {y:e}: {z:?}"));
        }
    }
}
