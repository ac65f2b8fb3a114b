//! What an expression consists of.

use std::ops::Range;

/// A range of bytes of the expression, escapes of JSON resolved.
pub(crate) type Span = Range<usize>;

/// A part of an expression. Parts stand in a list, each after those it is made of, and the whole last: whoever goes
/// through them in order needs no recursion, however long the expression is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Part {
    /// All of it.
    pub span: Span,
    /// What says what it does: the operator, the name of the function or of the member.
    pub mark: Span,
    /// What it is.
    pub kind: PartKind,
}

/// What a part is. Positions are those of other parts.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum PartKind {
    /// A number, as JSON writes it.
    Number(String),
    /// `true` or `false`.
    Boolean(bool),
    /// A text between quotes.
    Text(String),
    /// A name.
    Name(String),
    /// `.name` behind a part.
    Member(usize, String),
    /// `[2]` behind a part.
    Element(usize, usize),
    /// An operator before its operand, or between two.
    Operation(Operator, Vec<usize>),
    /// `condition ? one : other`.
    Choice(usize, usize, usize),
    /// A function with its arguments.
    Call(String, Vec<Argument>),
}

/// An argument of a function.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Argument {
    /// Its name with its place, where it is given.
    pub name: Option<(String, Span)>,
    /// Position of its value.
    pub value: usize,
}

/// An operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operator {
    Or,
    And,
    Not,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    Negate,
    Power,
}

impl Operator {
    /// How it is written.
    pub fn sign(self) -> &'static str {
        match self {
            Operator::Or => "||",
            Operator::And => "&&",
            Operator::Not => "!",
            Operator::Less => "<",
            Operator::LessEqual => "<=",
            Operator::Greater => ">",
            Operator::GreaterEqual => ">=",
            Operator::Equal => "==",
            Operator::NotEqual => "!=",
            Operator::Add => "+",
            Operator::Subtract | Operator::Negate => "-",
            Operator::Multiply => "*",
            Operator::Divide => "/",
            Operator::Modulo => "%",
            Operator::Power => "**",
        }
    }

    /// Whether it compares two values.
    pub fn compares(self) -> bool {
        matches!(
            self,
            Operator::Less
                | Operator::LessEqual
                | Operator::Greater
                | Operator::GreaterEqual
                | Operator::Equal
                | Operator::NotEqual
        )
    }
}

/// Why a text is no expression.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mistake {
    /// Where.
    pub span: Span,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: String,
    /// What surely mends it.
    pub fix: Option<&'static str>,
}

impl Mistake {
    /// A mistake that nothing is sure to mend.
    pub fn new(span: Span, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { span, message: message.into(), help: help.into(), fix: None }
    }

    /// One that is mended by putting `fix` in its place.
    pub fn mended(span: Span, message: impl Into<String>, fix: &'static str) -> Self {
        let help = format!("write `{fix}`");
        Self { span, message: message.into(), help, fix: Some(fix) }
    }
}
