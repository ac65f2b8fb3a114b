//! What a body yields lies in the set its intervals give, for every operation, function and node.

use phenomenon_compiler::emit::Body;
use phenomenon_compiler::emit::functions::conventions;
use phenomenon_compiler::emit::interval::{Interval, Truth, Whole, Word};
use phenomenon_compiler::emit::{Emit, Int, Mask, Real, Sink, Table, Words};
use phenomenon_compiler::kernels::BodyForms;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::Type;

/// Boxes tried per body, and points within each.
const BOXES: usize = 1000;
const POINTS: usize = 24;

/// A generator of numbers, the same in every run (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    fn unit(&mut self) -> f32 {
        (self.next() >> 40) as f32 / (1 << 24) as f32
    }

    fn number(&mut self) -> f32 {
        const HARD: [f32; 20] = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            0.5,
            2.0,
            -3.0,
            1e-45,
            -1e-45,
            f32::MIN_POSITIVE,
            0.999_999_94,
            1.000_000_1,
            f32::MAX,
            f32::MIN,
            f32::INFINITY,
            f32::NEG_INFINITY,
            16_777_216.0,
            2_147_483_648.0,
            -2_147_483_648.0,
            262_144.0,
        ];
        match self.below(5) {
            0 => HARD[self.below(HARD.len())],
            1 => self.unit() * 2.0 - 1.0,
            2 => (self.unit() - 0.5) * 20.0,
            3 => (self.unit() - 0.5) * 10_f32.powf(self.unit() * 80.0 - 42.0),
            _ => {
                let any = f32::from_bits(self.next() as u32);
                if any.is_nan() { 0.25 } else { any }
            }
        }
    }

    fn integer(&mut self) -> i32 {
        match self.below(4) {
            0 => self.next() as i32,
            1 => [0, 1, -1, i32::MIN, i32::MAX, 0x7f80_0000, 23, 127][self.below(8)],
            _ => self.below(9) as i32 - 3,
        }
    }

    /// A set of numbers, integers or truth.
    fn word(&mut self, value_type: Type, identity: u64) -> Word {
        match value_type {
            Type::Boolean => {
                let mut truth = Truth { identity, ..Truth::OPEN };
                match self.below(4) {
                    0 => truth.may_fail = false,
                    1 => truth.may_hold = false,
                    _ => {}
                }
                Word::Truth(truth)
            }
            Type::Integer => {
                let (a, b) = (self.integer(), self.integer());
                let b = if self.below(3) == 0 { a } else { b };
                Word::Integer(Whole { low: a.min(b), high: a.max(b), reads: 0, identity })
            }
            _ => {
                let (a, mut b) = (self.number(), self.number());
                match self.below(4) {
                    0 => b = a,
                    1 => b = a + self.unit() * a.abs(),
                    _ => {}
                }
                let b = if b.is_nan() { a } else { b };
                let (low, high) = if a.total_cmp(&b).is_le() { (a, b) } else { (b, a) };
                let nan = self.below(12) == 0;
                let smooth = true;
                Word::Number(Interval { low, high, nan, smooth, reads: 0, identity })
            }
        }
    }

    /// The bits of a value in a set.
    fn within(&mut self, word: Word) -> u32 {
        match word {
            Word::Truth(truth) => {
                let holds = truth.decided().unwrap_or_else(|| self.below(2) == 0);
                if holds { u32::MAX } else { 0 }
            }
            Word::Integer(Whole { low, high, .. }) => match self.below(4) {
                0 => low as u32,
                1 => high as u32,
                _ => {
                    let count = (i64::from(high) - i64::from(low) + 1) as u64;
                    (i64::from(low) + (self.next() % count) as i64) as u32
                }
            },
            Word::Number(interval) => self.number_within(interval).to_bits(),
        }
    }

    fn number_within(&mut self, interval: Interval) -> f32 {
        let Interval { low, high, nan, .. } = interval;
        let inside = match self.below(6) {
            0 => low,
            1 => high,
            2 if nan => f32::NAN,
            2 | 3 => self.number(),
            // Evenly by bits, which reaches every magnitude.
            4 => {
                let order = |x: f32| {
                    let bits = i64::from(x.to_bits() as i32);
                    if bits < 0 { i64::from(i32::MIN) - bits - 1 } else { bits }
                };
                let (from, to) = (order(low), order(high));
                let at = from + (self.next() % (to - from + 1) as u64) as i64;
                let bits = if at < 0 { i64::from(i32::MIN) - at - 1 } else { at };
                f32::from_bits(bits as i32 as u32)
            }
            _ => low + (high - low) * self.unit(),
        };
        let kept = inside.is_nan() && nan || Interval { nan, ..interval }.contains(inside);
        if kept { inside } else { low }
    }
}

/// Runs one body over boxes of inputs of these types.
fn hold(name: &str, code: &BodyForms, types: &[Type]) {
    hold_knowing(name, code, types, &[]);
}

/// The same where these words are known before shading.
fn hold_knowing(name: &str, code: &BodyForms, types: &[Type], fixed: &[(usize, i32)]) {
    let mut random = Random(0x9e37_79b9_7f4a_7c15 ^ (name.len() as u64) << 7);
    for _ in 0..BOXES {
        // Inputs of one identity are one value.
        let names: Vec<u64> = (0..types.len())
            .map(|at| {
                let other = random.below(types.len());
                if random.below(4) == 0 && types[other] == types[at] { other } else { at }
            })
            .map(|at| at as u64 + 1)
            .collect();
        let first = |name: u64| names.iter().position(|&other| other == name).unwrap();
        let mut inputs: Vec<Word> = Vec::new();
        for (at, value_type) in types.iter().enumerate() {
            let word = match first(names[at]) {
                same if same < at => inputs[same],
                _ => random.word(*value_type, names[at]),
            };
            inputs.push(word);
        }
        for &(word, number) in fixed {
            inputs[word] = Word::Integer(Whole::constant(number));
        }
        let mut sets = vec![Word::UNKNOWN; code.outputs];
        code.intervals(&inputs, &mut sets);
        for _ in 0..POINTS {
            let mut point: Vec<u32> = Vec::new();
            for (at, word) in inputs.iter().enumerate() {
                let same = first(names[at]);
                let own = same == at || fixed.iter().any(|(word, _)| *word == at);
                point.push(if own { random.within(*word) } else { point[same] });
            }
            let mut outputs = vec![0; code.outputs];
            (code.scalar)(&point, &mut outputs);
            for (output, set) in outputs.iter().zip(&sets) {
                assert!(
                    set.contains(*output),
                    "{name}: {:?} ({output:x}) is not in {set:?}\nat {:?}\nin {inputs:#?}",
                    f32::from_bits(*output),
                    point.iter().map(|&word| f32::from_bits(word)).collect::<Vec<_>>(),
                );
            }
        }
    }
}

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

#[test]
fn nodes_stay_in_their_sets() {
    let library = NodeLibrary::standard();
    // The least counts: more of the same takes long.
    let settled = library.iter().flat_map(|(_, it)| it.settled().into_iter().take(2));
    for definition in settled {
        for overload in &definition.overloads {
            let mut types: Vec<Type> = Vec::new();
            for input in &definition.signature.inputs {
                let (word, width) = match (input.value_type, overload.generic) {
                    (Type::Generic, Some(generic)) => (Type::Scalar, generic.width()),
                    (Type::Vector | Type::Color, _) => (Type::Scalar, input.value_type.width()),
                    (other, _) => (other, other.width()),
                };
                types.extend(std::iter::repeat_n(word, width));
            }
            for code in overload.guards.iter().flatten().chain(&overload.code) {
                let number = |at: usize| *definition.signature.inputs[at].range.start() as i32;
                let fixed = definition.fixed_words(overload).map(|(at, word)| (word, number(at)));
                let fixed: Vec<_> = fixed.collect();
                hold_knowing(&definition.signature.name, code, &types, &fixed);
            }
        }
    }
}

/// The interval of one output word of a body.
fn interval(code: &BodyForms, inputs: &[Word]) -> Interval {
    let mut outputs = vec![Word::UNKNOWN; code.outputs];
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
