//! Expressions of `categories.txt`: nodes over MaterialX's inputs.

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A number.
    Number(f64),
    /// A list of numbers.
    Numbers(Vec<f64>),
    /// A choice by its name.
    Text(String),
    /// An input of MaterialX's node.
    Input(View),
    /// Values for an input that takes a list.
    List(Vec<Expression>),
    /// A node of ours.
    Node {
        /// Its type.
        name: String,
        /// Its inputs.
        inputs: Vec<(String, Expression)>,
        /// The output; by default the first.
        output: Option<String>,
    },
}

/// What is taken of an input.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct View {
    /// The input.
    pub name: String,
    /// How it is taken.
    pub taken: Taken,
}

/// How an input is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Taken {
    /// As it is.
    Plain,
    /// A number repeated in all components.
    Wide,
    /// As an integer.
    Integer,
    /// One component.
    Component(usize),
    /// The first three components, as a vector.
    Three,
}

/// Reads one.
///
/// # Panics
/// If there is none.
pub fn read(text: &str) -> Expression {
    let mut reader = Reader { rest: text };
    let expression = reader.expression();
    assert!(reader.rest.trim().is_empty(), "`{}` is left of {text}", reader.rest);
    expression
}

struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    fn expression(&mut self) -> Expression {
        self.rest = self.rest.trim_start();
        match self.rest.chars().next().expect("an expression") {
            '[' => Expression::Numbers(self.inside('[', ']').split(',').map(number).collect()),
            '"' => {
                let (text, rest) = self.rest[1..].split_once('"').expect("a closing quote");
                self.rest = rest;
                Expression::Text(text.into())
            }
            '(' => {
                self.take("(");
                let mut values = vec![self.expression()];
                while self.takes(",") {
                    values.push(self.expression());
                }
                self.take(")");
                Expression::List(values)
            }
            '-' | '0'..='9' => Expression::Number(number(self.word())),
            '~' => self.marked("~", Taken::Wide),
            '#' => self.marked("#", Taken::Integer),
            _ => self.named(),
        }
    }

    fn named(&mut self) -> Expression {
        let name = self.name().to_owned();
        if !self.takes("(") {
            let taken = if self.takes(".") { component(self.name()) } else { Taken::Plain };
            return Expression::Input(View { name, taken });
        }
        let mut inputs = Vec::new();
        while !self.takes(")") {
            let input = self.name().to_owned();
            self.take("=");
            inputs.push((input, self.expression()));
            self.takes(",");
        }
        let output = self.takes(".").then(|| self.name().to_owned());
        Expression::Node { name, inputs, output }
    }

    fn marked(&mut self, mark: &str, taken: Taken) -> Expression {
        self.take(mark);
        Expression::Input(View { name: self.name().to_owned(), taken })
    }

    fn name(&mut self) -> &'a str {
        self.run(|c| c.is_alphanumeric() || c == '_')
    }

    fn word(&mut self) -> &'a str {
        self.run(|c| c.is_ascii_digit() || matches!(c, '.' | '-'))
    }

    fn run(&mut self, belongs: impl Fn(char) -> bool) -> &'a str {
        self.rest = self.rest.trim_start();
        let end = self.rest.find(|c| !belongs(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        assert!(!word.is_empty(), "a name or a number before `{rest}`");
        word
    }

    fn inside(&mut self, open: char, close: char) -> &'a str {
        let inner = self.rest.trim_start().strip_prefix(open).expect("it opens");
        let (inner, rest) = inner.split_once(close).expect("it closes");
        self.rest = rest;
        inner
    }

    fn takes(&mut self, mark: &str) -> bool {
        let rest = self.rest.trim_start().strip_prefix(mark);
        rest.map(|rest| self.rest = rest).is_some()
    }

    fn take(&mut self, mark: &str) {
        assert!(self.takes(mark), "`{mark}` before `{}`", self.rest);
    }
}

fn number(text: &str) -> f64 {
    text.trim().parse().unwrap_or_else(|_| panic!("`{text}` is no number"))
}

fn component(name: &str) -> Taken {
    match name {
        "xyz" => Taken::Three,
        _ => Taken::Component("xyzw".find(name).unwrap_or_else(|| panic!("no component `{name}`"))),
    }
}

#[test]
fn expressions_are_read() {
    let plain = |name: &str, taken| Expression::Input(View { name: name.into(), taken });
    let read = read("mix(a = in.w, b = split(c = [1, -2.5]).r, d = ~e, f = (#g, 0.5))");
    let split = Expression::Node {
        name: "split".into(),
        inputs: vec![("c".into(), Expression::Numbers(vec![1.0, -2.5]))],
        output: Some("r".into()),
    };
    let list = vec![plain("g", Taken::Integer), Expression::Number(0.5)];
    let inputs = vec![
        ("a".into(), plain("in", Taken::Component(3))),
        ("b".into(), split),
        ("d".into(), plain("e", Taken::Wide)),
        ("f".into(), Expression::List(list)),
    ];
    assert_eq!(read, Expression::Node { name: "mix".into(), inputs, output: None });
}
