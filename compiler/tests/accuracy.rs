//! The functions against core-math, which rounds correctly: at most 2 units in the last place.
//!
//! `cargo test -p phenomenon-compiler --test accuracy -- --nocapture` prints the errors that
//! `docs/numerics.md` states; `EXHAUSTIVE=1` before it tries every 32-bit number, `EXHAUSTIVE=509` one
//! in 509 and more pairs.

use phenomenon_compiler::emit::Body;
use phenomenon_compiler::emit::standard;
use phenomenon_compiler::emit::{Emit, Real, Sink, Words};
use phenomenon_compiler::kernels::BodyForms;
use phenomenon_compiler::storage::{FileShape, LANES, Lanes, Placement, Source};

/// Error in units of the last place that an f32 near `exact` has; 0 where NaN or an overflow is
/// what is due.
fn ulps(actual: f32, exact: f64) -> f64 {
    if actual.is_nan() || exact.is_nan() {
        return if actual.is_nan() && exact.is_nan() { 0.0 } else { f64::INFINITY };
    }
    let due = exact as f32;
    if actual == due && (actual.is_infinite() || exact == 0.0) {
        let sign_agrees = actual.is_sign_negative() == exact.is_sign_negative();
        return if sign_agrees { 0.0 } else { f64::INFINITY };
    }
    let exponent = ((exact.abs().to_bits() >> 52) as i32 - 1023).clamp(-126, 127);
    let unit = 2f64.powi(exponent - 23);
    // An overflow that is not due counts as the power of two after the largest number.
    let actual =
        if actual.is_infinite() { 2f64.powi(128).copysign(actual.into()) } else { actual.into() };
    (actual - exact).abs() / unit
}

/// Largest error of a function over inputs, and where.
#[derive(Clone, Copy, Debug)]
struct Worst {
    ulps: f64,
    inputs: [f32; 2],
    actual: f32,
    exact: f64,
}

/// Blocks evaluated at a time.
const BLOCKS: usize = 64;

/// Compares over pairs of inputs; a function of one ignores the second.
fn worst(
    code: BodyForms,
    exact: impl Fn(f64, f64) -> f64,
    inputs: impl Iterator<Item = [f32; 2]>,
) -> Worst {
    let mut worst = Worst { ulps: 0.0, inputs: [0.0; 2], actual: 0.0, exact: 0.0 };
    let mut inputs = inputs.peekable();
    let mut file = vec![Lanes::default(); BLOCKS * 3];
    let sources = [Source::Slot(0), Source::Slot(1)];
    let placement = Placement {
        shape: FileShape { uniforms: 0, slots: 3 },
        first: 0,
        blocks: BLOCKS,
        sources: &sources,
        output: 2,
    };
    while inputs.peek().is_some() {
        let mut count = 0;
        for (at, pair) in inputs.by_ref().take(BLOCKS * LANES).enumerate() {
            for word in 0..2 {
                file[at / LANES * 3 + word].0[at % LANES] = pair[word].to_bits();
            }
            count = at + 1;
        }
        code.wide(&mut file, &placement);
        for at in 0..count {
            let word = |word: usize| f32::from_bits(file[at / LANES * 3 + word].0[at % LANES]);
            let (inputs, actual) = ([word(0), word(1)], word(2));
            let exact = exact(inputs[0].into(), inputs[1].into());
            let ulps = ulps(actual, exact);
            if ulps > worst.ulps {
                worst = Worst { ulps, inputs, actual, exact };
            }
        }
    }
    worst
}

macro_rules! code {
    (|$a:ident, $b:ident| $value:expr) => {{
        struct Function;
        impl Body for Function {
            const OUTPUTS: usize = 1;
            #[inline(always)]
            fn run<E: Emit>(_: E, words: &impl Words<E>, sink: &mut impl Sink<E>) {
                let ($a, $b) = (words.real(0), words.real(1));
                let _ = $b;
                sink.real(0, $value);
            }
        }
        BodyForms::of::<Function>()
    }};
}

/// The step of an exhaustive run, if one is asked for.
fn exhaustive() -> Option<usize> {
    std::env::var("EXHAUSTIVE").ok()?.parse().ok()
}

/// Every n-th 32-bit pattern.
fn patterns() -> impl Iterator<Item = [f32; 2]> {
    let stride = exhaustive().unwrap_or(4001).max(1);
    (0..=u32::MAX).step_by(stride).map(|bits| [f32::from_bits(bits), 0.0])
}

/// Numbers in low..=high, evenly spread and also dense at both ends.
fn spread(low: f32, high: f32) -> impl Iterator<Item = [f32; 2]> {
    let count = 400_000;
    let even = (0..=count).map(move |k| low + (high - low) * (k as f32 / count as f32));
    let near = move |end: f32, other: f32| {
        (0..60_000u32).map(move |k| {
            let bits = if end.abs() < other.abs() {
                end.abs().to_bits() + k
            } else {
                end.abs().to_bits() - k
            };
            f32::from_bits(bits).copysign(end)
        })
    };
    even.chain(near(low, high)).chain(near(high, low)).map(|x| [x, 0.0])
}

fn report(name: &str, domain: &str, limit: f64, worst: Worst) {
    println!(
        "{name:6} {domain:28} {:.3} ulp at {:e}, {:e} ({:e}, exactly {:e})",
        worst.ulps, worst.inputs[0], worst.inputs[1], worst.actual, worst.exact
    );
    assert!(worst.ulps <= limit, "{name} over {domain}: {worst:?}");
}

macro_rules! everywhere {
    ($($test:ident: $function:ident, $exact:ident, $($low:literal .. $high:literal),+;)+) => {$(
        #[test]
        fn $test() {
            let code = code!(|a, b| a.$function());
            let exact = |a, _| core_math::$exact(a);
            report(stringify!($function), "every number", 2.0, worst(code, exact, patterns()));
            $(report(stringify!($function), concat!($low, "..", $high), 2.0,
                worst(code, exact, spread($low, $high)));)+
        }
    )+};
}

everywhere! {
    exp_is_accurate: exp, exp, -104.0..89.0, -1.0..1.0;
    exp2_is_accurate: exp2, exp2, -150.0..129.0, -1.0..1.0;
    expm1_is_accurate: expm1, expm1, -20.0..89.0, -1.0..1.0;
    sinh_is_accurate: sinh, sinh, -90.0..90.0, -2.0..2.0;
    cosh_is_accurate: cosh, cosh, -90.0..90.0, -2.0..2.0;
    tanh_is_accurate: tanh, tanh, -10.0..10.0, -1.0..1.0;
    ln_is_accurate: ln, log, 0.0..4.0, 0.7..1.5;
    log2_is_accurate: log2, log2, 0.0..4.0, 0.7..1.5;
    log1p_is_accurate: log1p, log1p, -1.0..4.0, -0.5..0.5;
    asin_is_accurate: asin, asin, -1.0..1.0, 0.4..0.6;
    acos_is_accurate: acos, acos, -1.0..1.0, 0.4..0.6;
    atan_is_accurate: atan, atan, -4.0..4.0, 0.9..1.1;
}

/// Every number the angle of which counts.
fn angles() -> impl Iterator<Item = [f32; 2]> {
    patterns().filter(|[x, _]| x.abs() <= standard::LARGEST_ANGLE as f32)
}

/// The numbers next to multiples of pi/2, where sine, cosine or tangent is small or huge.
fn near_axes() -> impl Iterator<Item = [f32; 2]> {
    (0..166_880u32).map(|k| [(f64::from(k) * std::f64::consts::FRAC_PI_2) as f32, 0.0])
}

macro_rules! of_angles {
    ($($test:ident: $function:ident, $exact:ident;)+) => {$(
        #[test]
        fn $test() {
            let code = code!(|a, b| a.$function());
            let exact = |a, _| core_math::$exact(a);
            let name = stringify!($function);
            report(name, "every number to 2^18", 2.0, worst(code, exact, angles()));
            report(name, "next to k pi/2", 2.0, worst(code, exact, near_axes()));
            report(name, "-10..10", 2.0, worst(code, exact, spread(-10.0, 10.0)));
        }
    )+};
}

of_angles! {
    sin_is_accurate: sin, sin;
    cos_is_accurate: cos, cos;
    tan_is_accurate: tan, tan;
}

#[test]
fn sine_and_cosine_stay_within_one_for_every_number() {
    for [x, _] in patterns().filter(|[x, _]| x.is_finite()) {
        let (sine, cosine) = standard::sin_cos(phenomenon_compiler::emit::scalar::F32(x));
        assert!(sine.0.abs() <= 1.0 && cosine.0.abs() <= 1.0, "{x:e}: {sine:?} {cosine:?}");
    }
}

/// Random pairs: bits at first, then `scale`d numbers about 1.
fn pairs(make: impl Fn(f32, f32, u32) -> [f32; 2]) -> impl Iterator<Item = [f32; 2]> {
    let count = if exhaustive().is_some() { 4_000_000u64 } else { 400_000 };
    (0..count).map(move |k| {
        let mut bits = k.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        bits = (bits ^ (bits >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits ^= bits >> 32;
        let unit = |bits: u32| bits as f32 / 4_294_967_296.0;
        make(unit(bits as u32), unit((bits >> 32) as u32), k as u32)
    })
}

/// Every pair of special values.
fn specials() -> impl Iterator<Item = [f32; 2]> {
    let mut values = vec![
        0.0,
        1e-45,
        1e-38,
        1e-20,
        0.3,
        0.5,
        0.75,
        1.0,
        1.5,
        2.0,
        2.5,
        3.0,
        4.0,
        7.0,
        31.0,
        1e10,
        16_777_215.0,
        16_777_216.0,
        1e30,
        f32::MAX,
        f32::INFINITY,
        f32::NAN,
    ];
    values.extend([1.0f32.next_up(), 1.0f32.next_down()]);
    let negative: Vec<f32> = values.iter().map(|x| -x).collect();
    values.extend(negative);
    let firsts = values.clone();
    firsts.into_iter().flat_map(move |a| values.clone().into_iter().map(move |b| [a, b]))
}

#[test]
fn pow_is_accurate() {
    let code = code!(|a, b| a.pow(b));
    let exact = core_math::pow;
    report("pow", "special values", 2.0, worst(code, exact, specials()));
    let signed = |x: f32| x * 2.0 - 1.0;
    let unit = pairs(|a, b, _| [a, b * 10.0]);
    report("pow", "0..1 to 0..10", 2.0, worst(code, exact, unit));
    let small = pairs(|a, b, _| [a * 8.0, signed(b) * 20.0]);
    report("pow", "0..8 to -20..20", 2.0, worst(code, exact, small));
    let near_one = pairs(|a, b, _| [1.0 + signed(a) * 0.01, signed(b) * 8000.0]);
    report("pow", "0.99..1.01 to -8000..8000", 2.0, worst(code, exact, near_one));
    // Every size of x, and powers that reach from the least to the greatest number.
    let wide = pairs(|a, b, k| {
        let x = f32::from_bits((a * 2_139_095_000.0) as u32);
        let y = signed(b) * 150.0 / x.log2().abs().max(1e-3);
        [x, if k % 2 == 0 { y } else { y.round() }]
    });
    report("pow", "all, where it is a number", 2.0, worst(code, exact, wide));
}

#[test]
fn atan2_is_accurate() {
    let code = code!(|a, b| a.atan2(b));
    let exact = core_math::atan2;
    report("atan2", "special values", 2.0, worst(code, exact, specials()));
    let signed = |x: f32| x * 2.0 - 1.0;
    let unit = pairs(|a, b, _| [signed(a), signed(b)]);
    report("atan2", "-1..1, -1..1", 2.0, worst(code, exact, unit));
    let bits = |x: f32, k: u32| f32::from_bits((x * 2_139_095_000.0) as u32 | (k << 31));
    let wide = pairs(|a, b, k| [bits(a, k), bits(b, k >> 1)]);
    report("atan2", "every size", 2.0, worst(code, exact, wide));
}
