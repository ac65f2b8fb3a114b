//! The code generators of the jit that run here.

use phenomenon_compiler::engine::jit::Generator;
use phenomenon_compiler::engine::{Engine, Options};

use crate::terminal;

/// Those that run on this machine. The others are told of.
pub fn here() -> Vec<Generator> {
    let mut here = Generator::ALL.to_vec();
    here.retain(|&generator| match generator.available() {
        Ok(()) => true,
        Err(error) => {
            terminal::tell(&format!("without {}: {error}", engine_name(generator)));
            false
        }
    });
    here
}

/// Name among engines: that of the one `--engine jit` takes is `jit`.
pub fn engine_name(generator: Generator) -> &'static str {
    match generator {
        taken if Generator::chosen(None) == Ok(taken) => "jit",
        Generator::Native => "jit_native",
        Generator::Cranelift => "jit_cranelift",
    }
}

/// The options of a shader whose code it makes.
pub fn options(generator: Generator) -> Options {
    Options { engine: Engine::Jit, generator: Some(generator), ..Options::default() }
}
