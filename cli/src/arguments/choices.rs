//! Flags with a few fixed values.

use clap::ValueEnum;
use phenomenon_compiler::engine::jit::Generator;
use phenomenon_compiler::engine::{Engine, Simd};

/// `--engine`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum EngineChoice {
    /// Batch at once, jit as soon as its code is ready
    #[default]
    Auto,
    /// A tree walk with a cache, one point at a time
    Walk,
    /// Kernels of the node bodies, eight points wide
    Batch,
    /// Machine code made for this graph
    Jit,
    /// The hand-written Rust of this graph, where there is one; in a scene, of those of its graphs that
    /// have one, and the others are compiled
    Monolith,
}

impl EngineChoice {
    /// The engine of the compiler; none for a monolith, which the compiler does not know.
    pub fn compiled(self) -> Option<Engine> {
        match self {
            EngineChoice::Auto => Some(Engine::Auto),
            EngineChoice::Walk => Some(Engine::Walk),
            EngineChoice::Batch => Some(Engine::Batch),
            EngineChoice::Jit => Some(Engine::Jit),
            EngineChoice::Monolith => None,
        }
    }

    /// Name in reports.
    pub fn name(self) -> &'static str {
        match self {
            EngineChoice::Auto => "auto",
            EngineChoice::Walk => "walk",
            EngineChoice::Batch => "batch",
            EngineChoice::Jit => "jit",
            EngineChoice::Monolith => "monolith",
        }
    }
}

/// `--jit`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum GeneratorChoice {
    /// Ours, eight points wide, for CPUs with AVX2 and FMA
    Native,
    /// Cranelift, four points wide
    Cranelift,
}

impl From<GeneratorChoice> for Generator {
    fn from(choice: GeneratorChoice) -> Self {
        match choice {
            GeneratorChoice::Native => Generator::Native,
            GeneratorChoice::Cranelift => Generator::Cranelift,
        }
    }
}

/// `--simd`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum SimdChoice {
    /// The best this CPU has
    #[default]
    Native,
    /// Portable code: the same bits, slower
    Portable,
}

impl From<SimdChoice> for Simd {
    fn from(choice: SimdChoice) -> Self {
        match choice {
            SimdChoice::Native => Simd::Native,
            SimdChoice::Portable => Simd::Portable,
        }
    }
}

/// `--precision`. The tiers `fast` and `reference` do not exist yet, so they are no values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Precision {
    /// 32-bit numbers, functions within 2 units in the last place
    #[default]
    Standard,
}

impl Precision {
    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Precision::Standard => "standard",
        }
    }
}

/// `--format` of commands that print values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For reading
    #[default]
    Human,
    /// For programs
    Json,
}
