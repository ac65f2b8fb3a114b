//! Where words lie: a batch of points in blocks of eight lanes.
//!
//! A batch of points lies in blocks of eight lanes. The file of a program holds its uniform words
//! first, one [`Lanes`] each with the same value in all lanes, then for every block one [`Lanes`]
//! per slot: `uniforms + block * slots + slot`.

use std::ops::Range;

/// Lanes of a block.
pub const LANES: usize = 8;

/// One word of eight points: numbers and integers by their bits, truth as all bits set or none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C, align(32))]
pub struct Lanes(pub [u32; LANES]);

/// Where a word comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Source {
    /// A word that never changes, with the position among the uniform words where it stands too.
    Constant {
        /// Its position.
        at: u32,
        /// The word.
        bits: u32,
    },
    /// A uniform word of the program, by position.
    Uniform(u32),
    /// A slot of every block.
    Slot(u32),
}

/// The shape of a file: how many words lie before its blocks, and how many in each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FileShape {
    /// Uniform words before the first block.
    pub uniforms: usize,
    /// Slots of a block.
    pub slots: usize,
}

/// Slots of a block that is to hold `slots`: an odd number, so that a slot of one block and of the next
/// do not fall into the same set of the cache, as they do at multiples of 128.
pub fn stride(slots: u32) -> usize {
    slots as usize | 1
}

impl FileShape {
    /// Position in the file of a slot of the block.
    #[inline(always)]
    pub fn slot(self, slot: u32, block: usize) -> usize {
        self.uniforms + block * self.slots + slot as usize
    }

    /// Position in the file of a source for the block.
    #[inline(always)]
    pub fn at(self, source: Source, block: usize) -> usize {
        match source {
            Source::Uniform(at) | Source::Constant { at, .. } => at as usize,
            Source::Slot(slot) => self.slot(slot, block),
        }
    }

    /// Words of a file with so many blocks.
    #[inline]
    pub fn words(self, blocks: usize) -> usize {
        self.uniforms + blocks * self.slots
    }
}

/// Where one body reads and writes, over blocks of a batch.
#[derive(Clone, Copy, Debug)]
pub struct Placement<'a> {
    /// The shape of the file.
    pub shape: FileShape,
    /// First block to run.
    pub first: usize,
    /// How many blocks to run.
    pub blocks: usize,
    /// One source per input word.
    pub sources: &'a [Source],
    /// First of the consecutive slots that take the output words.
    pub output: u32,
}

impl Placement<'_> {
    /// The blocks to run.
    #[inline(always)]
    pub fn range(&self) -> Range<usize> {
        self.first..self.first + self.blocks
    }

    /// Position in the file of input word `word` for the block.
    #[inline(always)]
    pub fn input(&self, word: usize, block: usize) -> usize {
        self.shape.at(self.sources[word], block)
    }

    /// Position in the file of output word `word` for the block.
    #[inline(always)]
    pub fn output(&self, word: usize, block: usize) -> usize {
        self.shape.slot(self.output, block) + word
    }
}
