//! What must hold of a definition before a library takes it: engines rely on it and do not ask again.

use crate::effects::{Effect, Part};
use crate::emit::MAX_OUTPUTS;
use crate::state::{Iterated, Reduction};
use crate::values::{Literal, Type};

use super::{DefaultValue, Definition, Kind, Signature};

/// What is wrong with a definition.
#[derive(Debug, thiserror::Error, PartialEq, Eq)]
pub enum DefinitionError {
    /// The inputs of a request are not the arguments of its effect.
    #[error("`{node}` asks `{effect}`, so its inputs have to be ({expected}), in this order")]
    Arguments {
        /// The node type.
        node: String,
        /// What it asks.
        effect: &'static str,
        /// What has to be given.
        expected: String,
    },
    /// An output of a request is not part of the answer.
    #[error("`{node}` has an output `{output}`, but `{effect}` answers ({answers})")]
    Answer {
        /// The node type.
        node: String,
        /// The output.
        output: String,
        /// What it asks.
        effect: &'static str,
        /// What comes back.
        answers: String,
    },
    /// A body writes other words than the outputs, or the changed fields, have.
    #[error("the body of `{node}` writes {written} words where {due} are due")]
    Words {
        /// The node type.
        node: String,
        /// Words the body writes.
        written: usize,
        /// Words that are read.
        due: usize,
    },
    /// A body writes more words than engines have room for.
    #[error("the body of `{node}` writes {written} words; at most {MAX_OUTPUTS} are possible")]
    TooManyWords {
        /// The node type.
        node: String,
        /// Words the body writes.
        written: usize,
    },
    /// The node does not have the inputs and the output of its loop.
    #[error(
        "`{node}` loops over {over} samples, so its inputs have to be ({expected}) and a scoped one, \
         without guards, of the type of its one output: scalar, vector, color or generic, and color if turns \
         are laid over each other"
    )]
    Loop {
        /// The node type.
        node: String,
        /// What it runs over.
        over: &'static str,
        /// What it has to take.
        expected: String,
    },
    /// Not one place for a guard per input.
    #[error("`{node}` has {inputs} inputs and places for {guards} guards")]
    Guards {
        /// The node type.
        node: String,
        /// Inputs of the signature.
        inputs: usize,
        /// Guards of a form.
        guards: usize,
    },
    /// A guard yields something else than one truth value.
    #[error("the guard of input `{input}` of `{node}` writes {written} words where 1 is due")]
    GuardWords {
        /// The node type.
        node: String,
        /// The input.
        input: String,
        /// Words the guard writes.
        written: usize,
    },
    /// A guard looks at an input that has a guard itself: where that does not hold, there is nothing to look at.
    #[error(
        "the guard of input `{input}` of `{node}` looks at `{at}`, which is not demanded everywhere itself; let it \
         look at inputs without a guard"
    )]
    GuardOfGuarded {
        /// The node type.
        node: String,
        /// The input.
        input: String,
        /// The input looked at.
        at: String,
    },
    /// It has no form at all.
    #[error("`{0}` has no overload")]
    NoOverload(String),
    /// A number that is known before shading has no end that loops can run to.
    #[error(
        "input `{input}` of `{node}` is known before shading, so it has to be an integer with a range \
         within 0 to {MOST_FIXED}, its default included"
    )]
    Fixed {
        /// The node type.
        node: String,
        /// The input.
        input: String,
    },
}

/// Largest number that may be known before shading: what is recorded for it is unrolled.
pub const MOST_FIXED: i32 = 1024;

impl Definition {
    /// Whether engines can run it.
    ///
    /// # Errors
    /// The first thing that is wrong with it.
    pub fn check(&self) -> Result<(), DefinitionError> {
        let signature = &self.signature;
        if let Kind::Request(effect) = &signature.kind {
            check_request(signature, *effect)?;
        }
        if let Kind::Loop(iterated, reduction) = signature.kind {
            check_loop(signature, iterated, reduction)?;
        }
        let node = || signature.name.to_string();
        if self.overloads.is_empty() {
            return Err(DefinitionError::NoOverload(node()));
        }
        for input in signature.inputs.iter().filter(|input| input.fixed) {
            let range = 0.0..=f64::from(MOST_FIXED);
            let within = range.contains(input.range.start()) && range.contains(input.range.end());
            let default = match &input.default {
                DefaultValue::Literal(Literal::Integer(number)) => {
                    input.range.contains(&f64::from(*number))
                }
                _ => false,
            };
            if !(input.value_type == Type::Integer && within && default) {
                return Err(DefinitionError::Fixed { node: node(), input: input.name.to_string() });
            }
        }
        for overload in &self.overloads {
            let (inputs, guards) = (signature.inputs.len(), overload.guards.len());
            if inputs != guards {
                return Err(DefinitionError::Guards { node: node(), inputs, guards });
            }
            for (input, guard) in signature.inputs.iter().zip(&overload.guards) {
                if let Some(guard) = guard.filter(|guard| guard.outputs != 1) {
                    let (input, written) = (input.name.to_string(), guard.outputs);
                    return Err(DefinitionError::GuardWords { node: node(), input, written });
                }
            }
            // A phenomenon has no body of its own.
            let Some(code) = overload.code else { continue };
            let written = code.outputs;
            let due = words_due(signature, overload.generic);
            if written != due {
                return Err(DefinitionError::Words { node: node(), written, due });
            }
            if written > MAX_OUTPUTS {
                return Err(DefinitionError::TooManyWords { node: node(), written });
            }
        }
        self.check_what_guards_read()
    }

    /// What is not demanded has no value that a guard could look at.
    fn check_what_guards_read(&self) -> Result<(), DefinitionError> {
        let inputs = &self.signature.inputs;
        if inputs.iter().filter(|input| input.guarded).count() < 2 {
            return Ok(());
        }
        for settled in self.settled() {
            for overload in &settled.overloads {
                // The input each word is of.
                let words: Vec<usize> = (inputs.iter().enumerate())
                    .flat_map(|(at, input)| vec![at; overload.width(input.value_type)])
                    .collect();
                for (guard, input) in overload.guards.iter().zip(inputs) {
                    let Some(guard) = guard else { continue };
                    let reads = guard.recorded().reads(words.len());
                    let mut words = words.iter().zip(reads);
                    let guarded =
                        |&(at, read): &(&usize, bool)| read && overload.guards[*at].is_some();
                    if let Some((&at, _)) = words.find(guarded) {
                        return Err(DefinitionError::GuardOfGuarded {
                            node: self.signature.name.to_string(),
                            input: input.name.to_string(),
                            at: inputs[at].name.to_string(),
                        });
                    }
                }
            }
        }
        Ok(())
    }
}

/// Words a body has to write.
fn words_due(signature: &Signature, generic: Option<Type>) -> usize {
    let settled = |of: Type| if of == Type::Generic { generic.unwrap_or(of) } else { of };
    match &signature.kind {
        Kind::Scope(fields) => fields.iter().map(|field| field.value_type().width()).sum(),
        _ => signature.outputs.iter().map(|output| settled(output.value_type).width()).sum(),
    }
}

fn check_request(signature: &Signature, effect: Effect) -> Result<(), DefinitionError> {
    let inputs = signature.inputs.iter();
    let given = inputs.map(|input| (&*input.name, input.value_type));
    if !given.eq(effect.arguments().iter().map(|part| (part.name, part.value_type))) {
        return Err(DefinitionError::Arguments {
            node: signature.name.to_string(),
            effect: effect.name(),
            expected: listed(effect.arguments()),
        });
    }
    for output in &signature.outputs {
        let is_part =
            |part: &Part| output.name == part.name && output.value_type == part.value_type;
        if !effect.answers().iter().any(is_part) {
            return Err(DefinitionError::Answer {
                node: signature.name.to_string(),
                output: format!("{}: {}", output.name, output.value_type.name()),
                effect: effect.name(),
                answers: listed(effect.answers()),
            });
        }
    }
    Ok(())
}

fn check_loop(
    signature: &Signature,
    iterated: Iterated,
    reduction: Reduction,
) -> Result<(), DefinitionError> {
    let arguments = iterated.arguments();
    let fits = match (signature.inputs.split_last(), &signature.outputs[..]) {
        (Some((body, taken)), [output]) => {
            let reduced = match reduction {
                Reduction::Over => output.value_type == Type::Color,
                _ => matches!(
                    output.value_type,
                    Type::Scalar | Type::Vector | Type::Color | Type::Generic
                ),
            };
            let alike = body.scoped && body.value_type == output.value_type && reduced;
            let no_guard = signature.inputs.iter().all(|input| !input.guarded);
            // Which lights there are is known before shading.
            let settled = taken.iter().all(|input| {
                iterated == Iterated::Samples || input.fixed || input.value_type == Type::Lights
            });
            alike
                && no_guard
                && settled
                && taken.iter().map(|input| input.value_type).eq(arguments.to_vec())
        }
        _ => false,
    };
    if fits {
        return Ok(());
    }
    Err(DefinitionError::Loop {
        node: signature.name.to_string(),
        over: iterated.name(),
        expected: arguments.iter().map(|of| of.name()).collect::<Vec<_>>().join(", "),
    })
}

/// `color: color, ok: boolean`.
fn listed(parts: &[Part]) -> String {
    let part = |part: &Part| format!("{}: {}", part.name, part.value_type.name());
    parts.iter().map(part).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nodes::{FINITE, NodeLibrary};

    fn standard(name: &str) -> Definition {
        let library = NodeLibrary::standard();
        library.definition(library.find(name).expect("a standard node")).clone()
    }

    #[test]
    fn a_guard_yields_one_word_and_there_is_a_form() {
        let mut mix = standard("mix");
        let wide = mix.overloads[2].code;
        mix.overloads[2].guards[1] = wide;
        let error = mix.check().expect_err("a colour is no truth value").to_string();
        assert_eq!(error, "the guard of input `a` of `mix` writes 4 words where 1 is due");
        mix.overloads.clear();
        assert_eq!(mix.check().unwrap_err().to_string(), "`mix` has no overload");
    }

    #[test]
    fn a_guard_looks_at_nothing_that_has_a_guard_itself() {
        let mut select = standard("select");
        assert_eq!(select.check(), Ok(()));
        // The condition is demanded only where it holds, says its own guard.
        select.signature.inputs[0].guarded = true;
        for overload in &mut select.overloads {
            overload.guards[0] = overload.guards[1];
        }
        let error = select.check().expect_err("there may be no condition to look at").to_string();
        let expected =
            "the guard of input `condition` of `select` looks at `condition`, which is not";
        assert!(error.starts_with(expected), "{error}");
    }

    #[test]
    fn what_is_known_before_shading_has_an_end() {
        let noise = standard("perlin_noise");
        assert_eq!(noise.check(), Ok(()));
        for range in [FINITE, -1.0..=8.0, 1.0..=1025.0, 5.0..=8.0] {
            let mut noise = noise.clone();
            let at = noise.signature.input("octaves").unwrap();
            noise.signature.inputs[at].range = range.clone();
            let error = noise.check().expect_err("a loop over it may not end");
            assert!(matches!(error, DefinitionError::Fixed { .. }), "{range:?}: {error}");
        }
    }

    #[test]
    fn a_request_takes_the_arguments_of_its_effect() {
        let mut probe = standard("trace_probe");
        assert_eq!(probe.check(), Ok(()));
        probe.signature.inputs.swap(0, 1);
        let error = probe.check().expect_err("the origin comes second");
        let expected = "`trace_probe` asks `trace_probe`, so its inputs have to be (direction: \
                        vector, origin: vector), in this order";
        assert_eq!(error.to_string(), expected);
    }

    #[test]
    fn a_request_yields_some_of_the_answer() {
        let mut trace = standard("trace_reflection");
        trace.signature.outputs.truncate(1);
        assert_eq!(trace.check(), Ok(()));
        trace.signature.outputs[0].value_type = Type::Vector;
        let error = trace.check().expect_err("a colour is no vector");
        let expected = "`trace_reflection` has an output `color: vector`, but `trace_reflection` \
                        answers (color: color, ok: boolean, hit: boolean, distance: scalar)";
        assert_eq!(error.to_string(), expected);
    }

    #[test]
    fn a_loop_takes_what_it_runs_over_and_yields_what_its_body_does() {
        let mut light_loop = standard("light_loop");
        assert_eq!(light_loop.check(), Ok(()));
        light_loop.signature.inputs[2].value_type = Type::Scalar;
        let error = light_loop.check().expect_err("a number becomes no colour");
        assert!(
            error.to_string().starts_with("`light_loop` loops over light samples, so its inputs")
        );
        let mut light_loop = standard("light_loop");
        light_loop.signature.inputs[1].fixed = false;
        assert!(light_loop.check().is_err(), "the mode is known before shading");
        let mut light_loop = standard("light_loop");
        light_loop.signature.kind = Kind::Loop(Iterated::Samples, Reduction::Mean);
        assert!(light_loop.check().is_err(), "lights are no count");
    }

    #[test]
    fn a_body_writes_what_the_outputs_read() {
        let mut cross = standard("cross");
        cross.signature.outputs[0].value_type = Type::Color;
        let error = cross.check().expect_err("a colour has four words");
        assert_eq!(error.to_string(), "the body of `cross` writes 3 words where 4 are due");
        let mut cross = standard("cross");
        cross.overloads[0].guards.pop();
        let error = cross.check().expect_err("a place for a guard is missing");
        assert_eq!(error.to_string(), "`cross` has 2 inputs and places for 1 guards");
    }

    #[test]
    fn a_body_writes_no_more_than_there_is_room_for() {
        let mut cross = standard("cross");
        let output = cross.signature.outputs[0].clone();
        cross.signature.outputs = vec![output; 22];
        cross.overloads[0].code.as_mut().expect("a body").outputs = 66;
        let error = cross.check().expect_err("there is room for 64");
        assert_eq!(
            error.to_string(),
            "the body of `cross` writes 66 words; at most 64 are possible"
        );
    }

    #[test]
    #[should_panic(expected = "has an output `depth: scalar`")]
    fn a_library_refuses_what_cannot_be_run() {
        let mut trace = standard("trace_reflection");
        trace.signature.outputs[3].name = "depth".into();
        NodeLibrary::standard().add(trace);
    }
}
