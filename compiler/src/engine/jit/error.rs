//! Why there is no machine code.

/// Why segments could not be compiled. The batch engine runs them all the same.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum JitError {
    /// Code is generated for x86-64 only.
    #[error("the jit engine needs an x86-64 processor; the batch engine runs everywhere")]
    UnsupportedTarget,
    /// The CPU lacks a feature the code relies on.
    #[error("machine code by {generator} needs a processor with {feature}; {remedy}")]
    MissingFeature {
        /// Who makes the code.
        generator: &'static str,
        /// What the CPU lacks.
        feature: &'static str,
        /// What runs there.
        remedy: &'static str,
    },
    /// Offsets in the file must fit 31 bits.
    #[error("the program is too large for the jit engine: {words} words in one block")]
    TooLarge {
        /// Uniform words, or slots.
        words: usize,
    },
    /// A segment names a source, an operation or a slot that does not exist.
    #[error("segment {segment} is not well formed: {what}")]
    Malformed {
        /// Which segment.
        segment: usize,
        /// What is wrong.
        what: &'static str,
    },
    /// The system gave no memory for code.
    #[error("no memory for machine code: {0}")]
    Memory(String),
    /// The code generator refused.
    #[error("code generation failed: {0}")]
    CodeGeneration(String),
}
