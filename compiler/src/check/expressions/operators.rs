//! Operators, as the nodes they are.

use crate::check::types::overload_type;
use crate::diagnostics::Code;
use crate::document::Value;
use crate::document::expression::Operator;
use crate::values::Type;

use super::convert::remedy;
use super::operand::{Arrives, Is, Operand};
use super::writer::Writer;

/// The node of an operator between two numbers, and its inputs.
fn arithmetic(operator: Operator) -> Option<(&'static str, &'static str, &'static str)> {
    Some(match operator {
        Operator::Add => ("add", "a", "b"),
        Operator::Subtract => ("subtract", "a", "b"),
        Operator::Multiply => ("multiply", "a", "b"),
        Operator::Divide => ("divide", "a", "b"),
        Operator::Modulo => ("modulo", "a", "b"),
        _ => return None,
    })
}

impl Writer<'_, '_> {
    /// An operator with its operands.
    pub fn operation(&mut self, at: usize, operator: Operator, of: &[usize]) -> Operand {
        let arriving: Vec<Option<Arrives>> = of.iter().map(|part| self.arrives(*part)).collect();
        let Some(arriving) = arriving.into_iter().collect::<Option<Vec<Arrives>>>() else {
            return Operand::broken();
        };
        let made = match (operator, of, arriving.as_slice()) {
            (Operator::Negate, &[one], &[arrives]) => self.negated(at, one, arrives),
            (Operator::Not, &[one], _) => self.logic(at, operator, &[one], &arriving),
            (Operator::And | Operator::Or, ..) => self.logic(at, operator, of, &arriving),
            (Operator::Power, &[base, exponent], &[a, b]) => {
                self.power(at, [(base, a), (exponent, b)])
            }
            (_, &[one, other], &[a, b]) if operator.compares() => {
                self.comparison(at, operator, [(one, a), (other, b)])
            }
            (_, &[one, other], &[a, b]) => self.arithmetic(at, operator, [(one, a), (other, b)]),
            _ => None,
        };
        made.unwrap_or_else(Operand::broken)
    }

    fn negated(&mut self, at: usize, of: usize, arrives: Arrives) -> Option<Operand> {
        let Some(joined) = Arrives::joined(&[arrives]) else {
            self.no_number(at, of, arrives);
            return None;
        };
        let value = self.value_of(of);
        self.generic(at, "negate", joined, vec![("input", value)])
    }

    /// A node whose generic inputs and outputs are `wanted`, or what comes nearest.
    pub fn generic(
        &mut self,
        at: usize,
        type_name: &str,
        wanted: Type,
        inputs: Vec<(&str, Value)>,
    ) -> Option<Operand> {
        let node_type = self.library_type(at, type_name)?;
        let generic = overload_type(self.draft.node_types.definition(node_type), wanted);
        let node = self.typed_node(at, node_type, generic, inputs);
        Some(Operand::of(node.json, generic?))
    }

    fn arithmetic(
        &mut self,
        at: usize,
        operator: Operator,
        [(one, a), (other, b)]: [(usize, Arrives); 2],
    ) -> Option<Operand> {
        let (node, left, right) = arithmetic(operator)?;
        for (part, arrives) in [(one, a), (other, b)] {
            if Arrives::joined(&[arrives]).is_none() {
                self.no_number(at, part, arrives);
                return None;
            }
        }
        let Some(joined) = Arrives::joined(&[a, b]) else {
            self.unlike(at, [(one, a), (other, b)]);
            return None;
        };
        let compound = matches!(joined, Type::Vector | Type::Color);
        if operator == Operator::Multiply && compound && a.is_scalar() != b.is_scalar() {
            let (whole, factor) = if a.is_scalar() { (other, one) } else { (one, other) };
            let inputs = vec![("input", self.value_of(whole)), ("factor", self.value_of(factor))];
            return self.generic(at, "scale", joined, inputs);
        }
        let inputs =
            vec![(left, self.widened(one, a, joined)?), (right, self.widened(other, b, joined)?)];
        self.generic(at, node, joined, inputs)
    }

    /// What stands for a part among values of a type: a scalar is repeated among vectors, as a number is.
    pub fn widened(&mut self, part: usize, arrives: Arrives, to: Type) -> Option<Value> {
        let value = self.value_of(part);
        if to != Type::Vector || !arrives.is_scalar() || arrives == Arrives::Number {
            return Some(value);
        }
        let inputs = ["x", "y", "z"].map(|key| (key, value.clone())).to_vec();
        let node = self.first_of(part, "combine_vector", inputs, Type::Vector);
        (node.is != Is::Broken).then(|| self.at(part, &node))
    }

    fn power(
        &mut self,
        at: usize,
        [(base, a), (exponent, b)]: [(usize, Arrives); 2],
    ) -> Option<Operand> {
        let Some(joined) = Arrives::joined(&[a]) else {
            self.no_number(at, base, a);
            return None;
        };
        if !b.is_scalar() {
            let message =
                format!("the exponent of `**` is a scalar, but {}", self.described(exponent, b));
            let help = remedy(b.own(), Type::Scalar, &self.text(exponent));
            let span = self.parsed.parts[exponent].span.clone();
            self.report(Code::TYPE_MISMATCH, &span, message, help);
            return None;
        }
        let inputs = vec![("base", self.value_of(base)), ("exponent", self.value_of(exponent))];
        self.generic(at, "power", joined, inputs)
    }

    fn comparison(
        &mut self,
        at: usize,
        operator: Operator,
        [(one, a), (other, b)]: [(usize, Arrives); 2],
    ) -> Option<Operand> {
        let is_text = |it: Arrives| it.own() == Type::String;
        let equals = matches!(operator, Operator::Equal | Operator::NotEqual);
        let is_truth = |it: Arrives| it.own() == Type::Boolean;
        if equals && is_truth(a) && is_truth(b) {
            return self.same_truth(at, operator, [one, other]);
        }
        let (node, first, second) = match operator {
            _ if equals && is_text(a) && is_text(b) => ("string_equal", one, other),
            Operator::Less => ("less", one, other),
            Operator::LessEqual => ("less_equal", one, other),
            Operator::Greater => ("less", other, one),
            Operator::GreaterEqual => ("less_equal", other, one),
            _ => ("equal", one, other),
        };
        if node != "string_equal" && !(a.is_scalar() && b.is_scalar()) {
            self.incomparable(operator, [(one, a), (other, b)]);
            return None;
        }
        let inputs = vec![("a", self.value_of(first)), ("b", self.value_of(second))];
        let generic = Arrives::joined(&[a, b]);
        let node_type = self.library_type(at, node)?;
        let generic = generic
            .and_then(|wanted| overload_type(self.draft.node_types.definition(node_type), wanted));
        let made = self.typed_node(at, node_type, generic, inputs);
        let made = Operand::of(made.json, Type::Boolean);
        if operator != Operator::NotEqual {
            return Some(made);
        }
        let value = self.at(at, &made);
        Some(self.first_of(at, "not", vec![("input", value)], Type::Boolean))
    }

    /// `==` or `!=` of booleans.
    fn same_truth(
        &mut self,
        at: usize,
        operator: Operator,
        [one, other]: [usize; 2],
    ) -> Option<Operand> {
        let inputs = vec![("a", self.value_of(one)), ("b", self.value_of(other))];
        let differ = self.first_of(at, "xor", inputs, Type::Boolean);
        if operator == Operator::NotEqual {
            return Some(differ);
        }
        let value = self.at(at, &differ);
        Some(self.first_of(at, "not", vec![("input", value)], Type::Boolean))
    }

    fn logic(
        &mut self,
        at: usize,
        operator: Operator,
        of: &[usize],
        arriving: &[Arrives],
    ) -> Option<Operand> {
        for (part, arrives) in of.iter().zip(arriving) {
            if arrives.own() != Type::Boolean {
                let sign = self.quote(&self.parsed.parts[at].mark);
                let message =
                    format!("`{sign}` takes booleans, but {}", self.described(*part, *arrives));
                let help = remedy(arrives.own(), Type::Boolean, &self.text(*part));
                let span = self.parsed.parts[*part].span.clone();
                self.report(Code::TYPE_MISMATCH, &span, message, help);
                return None;
            }
        }
        let values = of.iter().map(|part| self.value_of(*part));
        let (node, keys) = match operator {
            Operator::Not => ("not", ["input", ""]),
            Operator::And => ("and", ["a", "b"]),
            _ => ("or", ["a", "b"]),
        };
        let inputs = keys.into_iter().zip(values).collect();
        Some(self.first_of(at, node, inputs, Type::Boolean))
    }

    /// `condition ? one : other`.
    pub fn choice(&mut self, at: usize, [condition, one, other]: [usize; 3]) -> Operand {
        let arriving = [condition, one, other].map(|part| self.arrives(part));
        let [Some(decides), Some(a), Some(b)] = arriving else { return Operand::broken() };
        if decides.own() != Type::Boolean {
            let message = format!(
                "the condition before `?` is a boolean, but {}",
                self.described(condition, decides)
            );
            let help = remedy(decides.own(), Type::Boolean, &self.text(condition));
            let span = self.parsed.parts[condition].span.clone();
            self.report(Code::TYPE_MISMATCH, &span, message, help);
            return Operand::broken();
        }
        let own = a.own();
        let made = match Arrives::joined(&[a, b]) {
            Some(joined) => Some(joined),
            None if own == b.own() => Some(own),
            None => {
                self.unlike(at, [(one, a), (other, b)]);
                return Operand::broken();
            }
        };
        let chosen = made.and_then(|made| self.select(at, made, condition, [(one, a), (other, b)]));
        chosen.unwrap_or_else(Operand::broken)
    }

    fn select(
        &mut self,
        at: usize,
        made: Type,
        condition: usize,
        [(one, a), (other, b)]: [(usize, Arrives); 2],
    ) -> Option<Operand> {
        let node_type = self.library_type(at, "select")?;
        let definition = self.draft.node_types.definition(node_type);
        let takes = |of: Type| definition.overloads.iter().any(|it| it.generic == Some(of));
        // A whole number is an integer beside one, where integers are chosen among.
        let is_integer = |part, arrives| self.suits(part, arrives, Type::Integer);
        let integers = is_integer(one, a) && is_integer(other, b);
        let any = [a, b].contains(&Arrives::Of(Type::Integer));
        let made = match made {
            Type::Scalar | Type::Integer if integers && any && takes(Type::Integer) => {
                Type::Integer
            }
            Type::Integer => Type::Scalar,
            made => made,
        };
        if !takes(made) {
            let message = format!("`?` cannot choose between values of type {}", made.name());
            let mark = self.parsed.parts[at].mark.clone();
            self.report(Code::TYPE_MISMATCH, &mark, message, "choose between what is made of them");
            return None;
        }
        let decides = self.value_of(condition);
        let inputs = vec![
            ("condition", decides),
            ("if_true", self.widened(one, a, made)?),
            ("if_false", self.widened(other, b, made)?),
        ];
        let node = self.typed_node(at, node_type, Some(made), inputs);
        Some(Operand::of(node.json, made))
    }

    /// Reports an operand that is no number.
    fn no_number(&mut self, at: usize, part: usize, arrives: Arrives) {
        let sign = self.quote(&self.parsed.parts[at].mark);
        let message = format!("`{sign}` takes numbers, but {}", self.described(part, arrives));
        let help = remedy(arrives.own(), Type::Scalar, &self.text(part));
        let span = self.parsed.parts[part].span.clone();
        self.report(Code::TYPE_MISMATCH, &span, message, help);
    }

    /// Reports two values that nothing joins.
    pub fn unlike(&mut self, at: usize, [(one, a), (other, b)]: [(usize, Arrives); 2]) {
        let sign = self.quote(&self.parsed.parts[at].mark);
        let message = format!(
            "`{sign}` takes two values of one type, but {} and {}",
            self.described(one, a),
            self.described(other, b)
        );
        let help = remedy(b.own(), a.own(), &self.text(other));
        let mark = self.parsed.parts[at].mark.clone();
        self.report(Code::TYPE_MISMATCH, &mark, message, help);
    }

    /// Reports a comparison of what has no order.
    fn incomparable(&mut self, operator: Operator, of: [(usize, Arrives); 2]) {
        let Some((part, arrives)) = of.into_iter().find(|(_, arrives)| !arrives.is_scalar()) else {
            return;
        };
        let sign = operator.sign();
        let message = format!("`{sign}` compares scalars, but {}", self.described(part, arrives));
        let help = match arrives.own() {
            Type::Boolean => "join booleans with `&&`, `||` and `!`".into(),
            own => remedy(own, Type::Scalar, &self.text(part)),
        };
        let span = self.parsed.parts[part].span.clone();
        self.report(Code::TYPE_MISMATCH, &span, message, help);
    }
}
