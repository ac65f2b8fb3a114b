//! Functions: nodes that are called by their type, or by a name people know.

use crate::check::type_names::with_article;
use crate::check::types::overload_type;
use crate::diagnostics::synonyms::{self, Synonym};
use crate::diagnostics::{Advice, Code, listed, shortened};
use crate::document::Value;
use crate::document::expression::Argument;
use crate::nodes::{DefaultValue, Input, NodeType};
use crate::values::Type;

use super::convert::remedy;
use super::functions::{self, FUNCTIONS, Function};
use super::operand::{Arrives, Operand};
use super::writer::Writer;

/// Most inputs of a node whose arguments need no names, unless their order is declared.
const WITHOUT_NAMES: usize = 2;

/// A call, as far as its names are resolved.
struct Call<'c> {
    at: usize,
    name: &'c str,
    node_type: NodeType,
    function: Option<&'static Function>,
}

impl Writer<'_, '_> {
    /// A function with its arguments.
    pub fn call(&mut self, at: usize, name: &str, arguments: &[Argument]) -> Operand {
        let function = functions::find(name);
        let node = function.map_or(name, |function| function.node);
        let Some(node_type) = self.draft.node_types.library.find(node) else {
            self.unknown_function(at, name);
            return Operand::broken();
        };
        let call = Call { at, name, node_type, function };
        if !self.is_callable(&call) {
            return Operand::broken();
        }
        if function.is_some_and(|function| function.folds) && arguments.len() > 2 {
            return self.folded(&call, arguments);
        }
        // `vector(s)` and `color(s)` repeat a scalar.
        if let ("vector" | "color", [Argument { name: None, value }]) = (name, arguments) {
            return self.repeated(&call, *value);
        }
        match self.arguments(&call, arguments) {
            Some(given) => self.called(&call, &given),
            None => Operand::broken(),
        }
    }

    /// Whether a node can be called: what it is given is evaluated once, where it stands.
    fn is_callable(&mut self, call: &Call<'_>) -> bool {
        let signature = self.draft.node_types.signature(call.node_type);
        if functions::is_function(signature) {
            return true;
        }
        let message =
            format!("`{}` is no function: it evaluates its inputs in another way", call.name);
        let help = format!(
            "make it a node of its own: `\"type\": \"{}\"`, and name that here",
            signature.name
        );
        let mark = self.parsed.parts[call.at].mark.clone();
        self.report(Code::UNKNOWN_FUNCTION, &mark, message, help);
        false
    }

    /// `max(a, b, c)` as `max(max(a, b), c)`.
    fn folded(&mut self, call: &Call<'_>, arguments: &[Argument]) -> Operand {
        if let Some((_, span)) = arguments.iter().find_map(|argument| argument.name.clone()) {
            let message = format!("`{}` takes names with two arguments only", call.name);
            self.report(Code::WRONG_ARGUMENTS, &span, message, "give all of them without names");
            return Operand::broken();
        }
        let arriving: Option<Vec<Arrives>> =
            arguments.iter().map(|argument| self.arrives(argument.value)).collect();
        let Some(arriving) = arriving else { return Operand::broken() };
        let parts: Vec<usize> = arguments.iter().map(|argument| argument.value).collect();
        let Some(joined) = self.joined(call, &parts, &arriving) else { return Operand::broken() };
        let function = call.function.map_or("", |function| function.node);
        let mut so_far: Option<Value> = None;
        let mut made = Operand::broken();
        for (part, arrives) in parts.into_iter().zip(arriving) {
            let Some(next) = self.widened(part, arrives, joined) else { return Operand::broken() };
            let Some(before) = so_far.take() else {
                so_far = Some(next);
                continue;
            };
            let inputs = vec![("a", before), ("b", next)];
            let Some(folded) = self.generic(call.at, function, joined, inputs) else {
                return Operand::broken();
            };
            so_far = Some(self.at(call.at, &folded));
            made = folded;
        }
        made
    }

    fn repeated(&mut self, call: &Call<'_>, part: usize) -> Operand {
        let Some(arrives) = self.arrives(part) else { return Operand::broken() };
        let made = if call.name == "vector" { Type::Vector } else { Type::Color };
        if !arrives.is_scalar() {
            let message = format!(
                "`{}` of one argument repeats a scalar, but {}",
                call.name,
                self.described(part, arrives)
            );
            let help = remedy(arrives.own(), made, &self.text(part));
            let span = self.parsed.parts[part].span.clone();
            self.report(Code::TYPE_MISMATCH, &span, message, help);
            return Operand::broken();
        }
        let value = self.value_of(part);
        let keys = if made == Type::Vector { ["x", "y", "z"] } else { ["r", "g", "b"] };
        let node = if made == Type::Vector { "combine_vector" } else { "combine_color" };
        self.first_of(call.at, node, keys.map(|key| (key, value.clone())).to_vec(), made)
    }

    /// Which input each argument is given to, by position; none after a finding.
    fn arguments(
        &mut self,
        call: &Call<'_>,
        arguments: &[Argument],
    ) -> Option<Vec<(usize, usize)>> {
        let signature = self.draft.node_types.signature(call.node_type);
        let few = signature.inputs.len() <= WITHOUT_NAMES;
        let order: Vec<usize> = match call.function {
            Some(function) => {
                function.order.iter().filter_map(|name| signature.input(name)).collect()
            }
            None if few => (0..signature.inputs.len()).collect(),
            None => Vec::new(),
        };
        let mut given: Vec<(usize, usize)> = Vec::with_capacity(arguments.len());
        for (position, argument) in arguments.iter().enumerate() {
            let input = match &argument.name {
                Some((name, span)) => match signature.input(name) {
                    Some(input) => input,
                    None => {
                        let names = || signature.inputs.iter().map(|input| &*input.name);
                        let has = |name: &str| signature.input(name).is_some();
                        let advice =
                            self.reader.advice(name, names(), synonyms::input(name, has), || {
                                format!("its arguments are {}", listed(names()))
                            });
                        let message =
                            format!("`{}` has no argument `{}`", call.name, shortened(name));
                        self.advise(Code::WRONG_ARGUMENTS, span, message, advice);
                        return None;
                    }
                },
                None if arguments[..position].iter().any(|before| before.name.is_some()) => {
                    self.wrong_arguments(
                        argument.value,
                        "an argument without a name stands behind one with a name".into(),
                        "put those without names first".into(),
                    );
                    return None;
                }
                None => match order.get(position) {
                    Some(&input) => input,
                    None => {
                        self.too_many(call, &order, (arguments.len(), argument.value));
                        return None;
                    }
                },
            };
            if given.iter().any(|(known, _)| *known == input) {
                let name = &signature.inputs[input].name;
                let message = format!("`{}` is given its argument `{name}` twice", call.name);
                self.wrong_arguments(argument.value, message, "remove one of them".into());
                return None;
            }
            given.push((input, argument.value));
        }
        self.missing(call, &order, &given).then_some(given)
    }

    fn wrong_arguments(&mut self, part: usize, message: String, help: String) {
        let span = self.parsed.parts[part].span.clone();
        self.report(Code::WRONG_ARGUMENTS, &span, message, help);
    }

    fn too_many(&mut self, call: &Call<'_>, order: &[usize], (count, part): (usize, usize)) {
        let signature = self.draft.node_types.signature(call.node_type);
        let name = |at: &usize| &*signature.inputs[*at].name;
        if order.is_empty() && !signature.inputs.is_empty() {
            let named: Vec<String> =
                signature.inputs.iter().take(3).map(|input| format!("{}: …", input.name)).collect();
            let message = format!(
                "`{}` has {} arguments, which need their names",
                call.name,
                signature.inputs.len()
            );
            let help = format!("write `{}({})`", call.name, named.join(", "));
            return self.wrong_arguments(part, message, help);
        }
        let takes = match order.len() {
            0 => "takes no arguments".into(),
            1 => "takes one argument".into(),
            many => format!("takes {many} arguments"),
        };
        let message = format!("`{}` {takes}, but {count} are given", call.name);
        let help = match order.len() {
            0 => "remove them".into(),
            _ => format!("its order is {}", listed(order.iter().map(name))),
        };
        self.wrong_arguments(part, message, help);
    }

    /// Whether nothing is missing: of a function all that has no default of use, of a node what is required.
    fn missing(&mut self, call: &Call<'_>, order: &[usize], given: &[(usize, usize)]) -> bool {
        let signature = self.draft.node_types.signature(call.node_type);
        // A function is called with all it is known to take; only the alpha of a color may be left out.
        let optional = |at: usize| call.name == "color" && at == 3;
        let of_function = if call.function.is_some() { order } else { &[] };
        let required = (0..signature.inputs.len()).filter(|at| {
            of_function.contains(at) && !optional(*at)
                || matches!(signature.inputs[*at].default, DefaultValue::Required)
        });
        let missing: Vec<&str> = required
            .filter(|at| !given.iter().any(|(known, _)| known == at))
            .map(|at| &*signature.inputs[at].name)
            .collect();
        if missing.is_empty() {
            return true;
        }
        let count = if missing.len() == 1 { "argument" } else { "arguments" };
        let message =
            format!("`{}` lacks its {count} {}", call.name, listed(missing.iter().copied()));
        let help = match order.len() {
            0 => "give it by name".into(),
            _ => {
                let names: Vec<&str> =
                    order.iter().map(|at| &*signature.inputs[*at].name).collect();
                format!("write `{}({})`", call.name, names.join(", "))
            }
        };
        let span = self.parsed.parts[call.at].span.clone();
        self.report(Code::WRONG_ARGUMENTS, &span, message, help);
        false
    }

    /// The node of a call, given parts by input.
    fn called(&mut self, call: &Call<'_>, given: &[(usize, usize)]) -> Operand {
        let draft = self.draft;
        let definition = draft.node_types.definition(call.node_type);
        let signature = &definition.signature;
        let is_generic = |input: usize| signature.inputs[input].value_type == Type::Generic;
        let arriving: Option<Vec<Arrives>> =
            given.iter().map(|(_, part)| self.arrives(*part)).collect();
        let Some(arriving) = arriving else { return Operand::broken() };
        let (parts, generic): (Vec<usize>, Vec<Arrives>) = given
            .iter()
            .zip(&arriving)
            .filter(|((input, _), _)| is_generic(*input))
            .map(|((_, part), arrives)| (*part, *arrives))
            .unzip();
        let mut joined = None;
        if signature.is_generic() {
            let Some(wanted) = self.joined(call, &parts, &generic) else {
                return Operand::broken();
            };
            joined = overload_type(definition, wanted);
        }
        let mut inputs = Vec::with_capacity(given.len());
        for ((input, part), arrives) in given.iter().zip(arriving) {
            let declared = &signature.inputs[*input];
            let value = match joined {
                Some(joined) if is_generic(*input) => self.widened(*part, arrives, joined),
                _ if self.takes(call, declared, *part, arrives) => Some(self.value_of(*part)),
                _ => None,
            };
            let Some(value) = value else { return Operand::broken() };
            inputs.push((&*declared.name, value));
        }
        self.typed_node(call.at, call.node_type, joined, inputs)
    }

    /// What generic inputs are when given all these.
    fn joined(&mut self, call: &Call<'_>, parts: &[usize], arriving: &[Arrives]) -> Option<Type> {
        if let Some(joined) = Arrives::joined(arriving) {
            return Some(joined);
        }
        let all = || parts.iter().copied().zip(arriving.iter().copied());
        let first = all().find(|(_, arrives)| Arrives::joined(&[*arrives]).is_none());
        if let Some((part, arrives)) = first {
            let message =
                format!("`{}` takes numbers, but {}", call.name, self.described(part, arrives));
            let help = remedy(arrives.own(), Type::Scalar, &self.text(part));
            let span = self.parsed.parts[part].span.clone();
            self.report(Code::TYPE_MISMATCH, &span, message, help);
            return None;
        }
        let of = |wanted: Type| all().find(|(_, arrives)| *arrives == Arrives::Of(wanted));
        if let (Some(one), Some(other)) = (of(Type::Vector), of(Type::Color)) {
            self.unlike(call.at, if one.0 < other.0 { [one, other] } else { [other, one] });
        }
        None
    }

    /// Whether an argument suits its input, or a finding.
    fn takes(&mut self, call: &Call<'_>, input: &Input, part: usize, arrives: Arrives) -> bool {
        let is_word = arrives == Arrives::Text && !input.choices.is_empty();
        if is_word || self.suits(part, arrives, input.value_type) {
            return true;
        }
        let takes = with_article(input.value_type);
        let message = format!(
            "argument `{}` of `{}` takes {takes}, but {}",
            input.name,
            call.name,
            self.described(part, arrives)
        );
        let help = remedy(arrives.own(), input.value_type, &self.text(part));
        let span = self.parsed.parts[part].span.clone();
        self.report(Code::TYPE_MISMATCH, &span, message, help);
        false
    }

    fn unknown_function(&mut self, at: usize, name: &str) {
        let mark = self.parsed.parts[at].mark.clone();
        let library = self.draft.node_types.library;
        let mut names: Vec<&str> = FUNCTIONS.iter().map(|function| function.name).collect();
        names.extend(library.iter().map(|(_, definition)| &*definition.signature.name));
        let is_node = self.draft.node_names.contains_key(name);
        let synonym = synonyms::node(name)
            .filter(|found| found.ours.iter().all(|ours| library.find(ours).is_some()));
        let advice = match is_node || self.draft.parameter_names.contains_key(name) {
            true => Advice::from(format!(
                "`{}` is a value: write it without `( )`, or put an operator between",
                shortened(name)
            )),
            false => self.reader.advice(name, names.into_iter(), as_function(synonym), || {
                "`phenomenon nodes` lists every node, and each is a function".into()
            }),
        };
        let message = format!("there is no function `{}`", shortened(name));
        self.advise(Code::UNKNOWN_FUNCTION, &mark, message, advice);
    }
}

/// What a name means, as the function that takes its arguments in order where there is one: who writes
/// `vec3(1, 0, 0)` names none of them.
fn as_function(synonym: Option<Synonym>) -> Option<Synonym> {
    let mut synonym = synonym?;
    if let [node] = synonym.ours.as_mut_slice()
        && functions::find(node).is_none()
        && let Some(function) = FUNCTIONS.iter().find(|function| function.node == *node)
    {
        *node = function.name;
    }
    Some(synonym)
}
