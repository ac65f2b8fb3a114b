//! Random expressions, against a direct evaluation in 32 bits.

use std::fmt::Write;
use std::sync::Arc;

use phenomenon_compiler::engine::{Engine, Options};
use phenomenon_compiler::testing::build::every_engine;
use phenomenon_compiler::testing::mock::MockRenderer;
use phenomenon_compiler::testing::random::{Random, canonical};

use crate::build::{GRAPH, graph, shaded};

/// A value computed without the compiler.
#[derive(Clone, Copy, Debug)]
enum Value {
    Scalar(f32),
    Vector([f32; 3]),
    Color([f32; 4]),
    Boolean(bool),
}

use Value::{Boolean, Color, Scalar, Vector};

/// Components in pairs, as operators have them: a scalar is repeated, and the alpha of the left stays.
fn zip(a: Value, b: Value, of: impl Fn(f32, f32) -> f32) -> Value {
    let rgb = |c: [f32; 4]| [c[0], c[1], c[2]];
    let each = |a: [f32; 3], b: [f32; 3]| [0, 1, 2].map(|at| of(a[at], b[at]));
    let with_alpha = |c: [f32; 3], alpha: f32| Color([c[0], c[1], c[2], alpha]);
    match (a, b) {
        (Scalar(a), Scalar(b)) => Scalar(of(a, b)),
        (Vector(a), Vector(b)) => Vector(each(a, b)),
        (Vector(a), Scalar(b)) => Vector(each(a, [b; 3])),
        (Scalar(a), Vector(b)) => Vector(each([a; 3], b)),
        (Color(a), Color(b)) => with_alpha(each(rgb(a), rgb(b)), a[3]),
        (Color(a), Scalar(b)) => with_alpha(each(rgb(a), [b; 3]), a[3]),
        (Scalar(a), Color(b)) => with_alpha(each([a; 3], rgb(b)), 1.0),
        _ => unreachable!("the generator joins what can be joined"),
    }
}

fn number(value: Value) -> f32 {
    match value {
        Scalar(x) => x,
        _ => unreachable!("a scalar was asked for"),
    }
}

fn truth(value: Value) -> bool {
    match value {
        Boolean(x) => x,
        _ => unreachable!("a boolean was asked for"),
    }
}

/// What kind of value is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Scalar,
    Vector,
    Color,
    Boolean,
}

/// The interface and the nodes that expressions speak of, and their values.
const NAMES: [(&str, Kind, Value); 14] = [
    ("a", Kind::Scalar, Scalar(0.75)),
    ("b", Kind::Scalar, Scalar(-1.25)),
    ("zero", Kind::Scalar, Scalar(0.0)),
    ("count", Kind::Scalar, Scalar(3.0)),
    ("look.weights[1]", Kind::Scalar, Scalar(0.125)),
    ("apart.y", Kind::Scalar, Scalar(-0.5)),
    ("v", Kind::Vector, Vector([1.5, -0.5, 0.25])),
    ("place", Kind::Vector, Vector([0.5, 2.0, -3.0])),
    ("doubled", Kind::Vector, Vector([3.0, -1.0, 0.5])),
    ("c", Kind::Color, Color([0.25, 0.5, 1.0, 0.5])),
    ("look.tint", Kind::Color, Color([0.75, 0.0, 2.0, 1.0])),
    ("paint.value", Kind::Color, Color([0.5, 0.25, 0.125, 0.75])),
    ("on", Kind::Boolean, Boolean(true)),
    ("off", Kind::Boolean, Boolean(false)),
];

/// Makes expressions and evaluates them at once.
struct Maker {
    random: Random,
    /// What is bound under `where`, as JSON, and its names with their values.
    bound: Vec<String>,
    names: Vec<(String, Kind, Value)>,
}

impl Maker {
    fn new(seed: u64) -> Self {
        Self { random: Random::new(seed), bound: Vec::new(), names: Vec::new() }
    }

    fn leaf(&mut self, kind: Kind) -> (String, Value) {
        if kind == Kind::Scalar && self.random.chance(30) {
            let (text, value) = self.random.pick(&[
                ("2", 2.0),
                (".5", 0.5),
                ("1e-1", 0.1),
                ("0", 0.0),
                ("-1.5", -1.5),
            ]);
            return (text.into(), Scalar(value));
        }
        let own = NAMES.iter().map(|(name, kind, value)| ((*name).to_owned(), *kind, *value));
        let all: Vec<_> = own.chain(self.names.clone()).filter(|it| it.1 == kind).collect();
        let (name, _, value) = all[self.random.below(all.len())].clone();
        (name, value)
    }

    /// An expression of a kind, in brackets wherever it is not one word, with its value.
    fn value(&mut self, kind: Kind, depth: usize) -> (String, Value) {
        if depth == 0 || self.random.chance(15) {
            return self.leaf(kind);
        }
        let (text, value) = match kind {
            Kind::Boolean => self.boolean(depth - 1),
            Kind::Scalar if self.random.chance(25) => self.component(depth - 1),
            _ if self.random.chance(15) => self.choice(kind, depth - 1),
            _ if self.random.chance(15) => self.made(kind, depth - 1),
            _ => self.computed(kind, depth - 1),
        };
        let text = format!("({text})");
        if self.random.chance(12) {
            let name = format!("w{}", self.names.len());
            self.bound.push(format!("\"{name}\": {{ \"expression\": \"{text}\" }}"));
            self.names.push((name.clone(), kind, value));
            return (name, value);
        }
        (text, value)
    }

    fn boolean(&mut self, depth: usize) -> (String, Value) {
        if self.random.chance(40) {
            let (one, a) = self.value(Kind::Boolean, depth);
            let (other, b) = self.value(Kind::Boolean, depth);
            let (a, b) = (truth(a), truth(b));
            return match self.random.below(3) {
                0 => (format!("{one} && {other}"), Boolean(a && b)),
                1 => (format!("{one} or {other}"), Boolean(a || b)),
                _ => (format!("!{one}"), Boolean(!a)),
            };
        }
        let (one, a) = self.value(Kind::Scalar, depth);
        let (other, b) = self.value(Kind::Scalar, depth);
        let (a, b) = (number(a), number(b));
        #[expect(clippy::float_cmp, reason = "this is what the operators mean")]
        let (sign, holds) = match self.random.below(6) {
            0 => ("<", a < b),
            1 => ("<=", a <= b),
            2 => (">", a > b),
            3 => (">=", a >= b),
            4 => ("==", a == b),
            _ => ("!=", a != b),
        };
        (format!("{one} {sign} {other}"), Boolean(holds))
    }

    fn component(&mut self, depth: usize) -> (String, Value) {
        if self.random.chance(50) {
            let (text, value) = self.value(Kind::Vector, depth);
            let Vector(v) = value else { unreachable!("a vector") };
            let at = self.random.below(3);
            return (format!("{text}.{}", ["x", "y", "z"][at]), Scalar(v[at]));
        }
        let (text, value) = self.value(Kind::Color, depth);
        let Color(c) = value else { unreachable!("a color") };
        let at = self.random.below(4);
        (format!("{text}.{}", ["r", "g", "b", "a"][at]), Scalar(c[at]))
    }

    fn choice(&mut self, kind: Kind, depth: usize) -> (String, Value) {
        let (condition, holds) = self.value(Kind::Boolean, depth);
        let (one, a) = self.value(kind, depth);
        let (other, b) = self.value(kind, depth);
        (format!("{condition} ? {one} : {other}"), if truth(holds) { a } else { b })
    }

    /// What constructors and swizzles make.
    fn made(&mut self, kind: Kind, depth: usize) -> (String, Value) {
        let mut parts = || -> [(String, f32); 3] {
            [0; 3].map(|_| self.value(Kind::Scalar, depth)).map(|(text, it)| (text, number(it)))
        };
        match kind {
            Kind::Vector => {
                let [(x, a), (y, b), (z, c)] = parts();
                if self.random.chance(50) {
                    return (format!("vector({x}, {y}, {z})"), Vector([a, b, c]));
                }
                (format!("vector({x}, {y}, {z}).zzx"), Vector([c, c, a]))
            }
            Kind::Color => {
                let [(x, a), (y, b), (z, c)] = parts();
                if self.random.chance(50) {
                    return (format!("color({x}, {y}, {z}, .5)"), Color([a, b, c, 0.5]));
                }
                (format!("vector({x}, {y}, {z}).bgr"), Color([c, b, a, 1.0]))
            }
            _ => {
                let [(x, a), (y, b), (z, c)] = parts();
                let clamped = if a < b { b } else { a };
                let clamped = if c < clamped { c } else { clamped };
                (format!("min(max({x}, {y}), {z})"), Scalar(clamped))
            }
        }
    }

    fn computed(&mut self, kind: Kind, depth: usize) -> (String, Value) {
        let (one, a) = self.value(kind, depth);
        // Scalars may stand on either side.
        let mixes = kind != Kind::Scalar && self.random.chance(40);
        let (other, b) = self.value(if mixes { Kind::Scalar } else { kind }, depth);
        let ((one, a), (other, b)) = match mixes && self.random.chance(50) {
            true => ((other, b), (one, a)),
            false => ((one, a), (other, b)),
        };
        let minimum = |a: f32, b: f32| if a < b { a } else { b };
        let divided =
            |a: f32, b: f32| if b == 0.0 { 0.0 } else { (a / b).clamp(f32::MIN, f32::MAX) };
        match self.random.below(6) {
            0 => (format!("{one} + {other}"), zip(a, b, |a, b| a + b)),
            1 => (format!("{one} - {other}"), zip(a, b, |a, b| a - b)),
            2 => {
                let product = zip(a, b, |a, b| a * b);
                // A scalar scales a color, and leaves its alpha.
                let product = match (a, b, product) {
                    (Scalar(_), Color(b), Color([x, y, z, _])) => Color([x, y, z, b[3]]),
                    _ => product,
                };
                (format!("{one} * {other}"), product)
            }
            3 => (format!("{one} / {other}"), zip(a, b, divided)),
            4 => (format!("min({one}, {other})"), zip(a, b, minimum)),
            _ => {
                let negative = |x: f32| -x;
                let (one, a) = self.value(kind, depth);
                let value = match a {
                    Scalar(x) => Scalar(-x),
                    Vector(v) => Vector(v.map(negative)),
                    Color([r, g, b, a]) => Color([-r, -g, -b, a]),
                    Boolean(_) => unreachable!("a number"),
                };
                (format!("-{one}"), value)
            }
        }
    }
}

#[test]
fn random_expressions_are_what_they_say_in_every_engine() {
    let mut operators = String::new();
    let engines = every_engine();
    for seed in 0..160 {
        let mut maker = Maker::new(seed);
        let kind = maker.random.pick(&[Kind::Scalar, Kind::Vector, Kind::Color, Kind::Boolean]);
        let (text, value) = maker.value(kind, 5);
        let (text, expected) = match value {
            Scalar(x) => (text, [x, x, x, 1.0]),
            Vector([x, y, z]) => (format!("({text}).rgb"), [x, y, z, 1.0]),
            Color(color) => (text, color),
            Boolean(holds) => {
                let x = f32::from(u8::from(holds));
                (format!("{text} ? 1 : 0"), [x, x, x, 1.0])
            }
        };
        let bound = maker.bound.join(", ");
        let root = format!("{{ \"expression\": \"{text}\", \"where\": {{ {bound} }} }}");
        let graph = Arc::new(graph(&GRAPH.replace("ROOT", &root)));
        // All engines for some of them: they agree by tests of their own.
        let options = [
            engines[seed as usize % engines.len()],
            Options { engine: Engine::Walk, ..Options::default() },
        ];
        for options in options {
            let found = shaded(&graph, options, &mut MockRenderer::default());
            let bits = |of: [f32; 4]| of.map(|x| canonical(x.to_bits()));
            assert_eq!(
                bits(found),
                bits(expected),
                "seed {seed}, {options:?}: {root}\n{found:?} {expected:?}"
            );
        }
        write!(operators, "{root}").unwrap();
    }
    for used in ["+", "-", "*", "/", "?", "&&", "or", "!", "<=", "!=", ".zzx", ".bgr", "w1", "min("]
    {
        assert!(operators.contains(used), "the generator makes no {used}");
    }
}
