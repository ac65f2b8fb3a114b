//! Storage of the batch and jit engines, and the entries through which node bodies run on it.
//!
//! A batch of points lies in blocks of eight lanes. The file of a program holds its uniform words
//! first, one [`Lanes`] each with the same value in all lanes, then for every block one [`Lanes`]
//! per slot: `uniforms + block * slots + slot`.

use crate::emit::scalar::Scalar;
use crate::nodes::Body;

/// Lanes of a block.
pub const LANES: usize = 8;

/// One word of eight points: numbers and integers by their bits, truth as all bits set or none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C, align(32))]
pub struct Lanes(pub [u32; LANES]);

/// Where a word comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Source {
    /// A uniform word of the program, by position.
    Uniform(u32),
    /// A slot of every block.
    Slot(u32),
}

/// Where one body reads and writes, over all blocks of a batch.
#[derive(Clone, Copy, Debug)]
pub struct Placement<'a> {
    /// Uniform words before the first block.
    pub uniforms: usize,
    /// Slots of a block.
    pub slots: usize,
    /// Blocks to run.
    pub blocks: usize,
    /// One source per input word.
    pub sources: &'a [Source],
    /// First of the consecutive slots that take the output words.
    pub output: u32,
}

impl Placement<'_> {
    /// Position in the file of input word `word` for the block.
    #[inline(always)]
    pub fn input(&self, word: usize, block: usize) -> usize {
        match self.sources[word] {
            Source::Uniform(at) => at as usize,
            Source::Slot(slot) => self.uniforms + block * self.slots + slot as usize,
        }
    }

    /// Position in the file of output word `word` for the block.
    #[inline(always)]
    pub fn output(&self, word: usize, block: usize) -> usize {
        self.uniforms + block * self.slots + self.output as usize + word
    }
}

/// Whether the CPU runs the native forms (AVX2 and FMA).
pub fn native_simd() -> bool {
    #[cfg(target_arch = "x86_64")]
    {
        std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        false
    }
}

/// Runs `B` for one point, fused multiply-add in hardware where there is one.
pub fn scalar<B: Body>(inputs: &[u32], outputs: &mut [u32]) {
    #[cfg(target_arch = "x86_64")]
    {
        #[target_feature(enable = "avx2,fma")]
        fn with_fma<B: Body>(inputs: &[u32], mut outputs: &mut [u32]) {
            B::run(Scalar, &inputs, &mut outputs);
        }
        if native_simd() {
            // SAFETY: the features were detected.
            return unsafe { with_fma::<B>(inputs, outputs) };
        }
    }
    let mut outputs = outputs;
    B::run(Scalar, &inputs, &mut outputs);
}

/// Runs `B` over the blocks, eight lanes at once where the CPU can.
pub fn wide<B: Body>(lanes: &mut [Lanes], placement: &Placement<'_>) {
    #[cfg(target_arch = "x86_64")]
    if native_simd() {
        // SAFETY: the features were detected.
        return unsafe { crate::emit::avx2::run::<B>(lanes, placement) };
    }
    wide_portable::<B>(lanes, placement);
}

/// Runs `B` over the blocks lane by lane: same bits, any CPU.
pub fn wide_portable<B: Body>(lanes: &mut [Lanes], placement: &Placement<'_>) {
    let mut inputs = vec![0; placement.sources.len()];
    let mut outputs = [0; 64];
    let mut outputs = &mut outputs[..B::OUTPUTS];
    for block in 0..placement.blocks {
        for lane in 0..LANES {
            for (word, input) in inputs.iter_mut().enumerate() {
                *input = lanes[placement.input(word, block)].0[lane];
            }
            B::run(Scalar, &&inputs[..], &mut outputs);
            for (word, output) in outputs.iter().enumerate() {
                lanes[placement.output(word, block)].0[lane] = *output;
            }
        }
    }
}
