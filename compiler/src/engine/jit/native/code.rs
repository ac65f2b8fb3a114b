//! The functions of a program in memory that can be run.

use memmap2::{Mmap, MmapMut};

use super::assembler::Assembler;
use super::constants::Constants;
use super::function::{FEWEST_REGISTERS, write};
use crate::engine::jit::JitError;
use crate::ops::OpSegment;
use crate::storage::{FileShape, LANES, Lanes};

/// Vector registers there are.
pub const MOST_REGISTERS: u32 = 16;

/// Functions start at multiples of this, as compilers have it.
const ALIGNMENT: usize = 32;

/// Rows for spilled words that are taken from the stack of whoever runs a function: 2 KiB. Parts of
/// [`COMFORTABLE`](crate::ops::split::COMFORTABLE) operations need fewer.
const ROWS_AT_HAND: usize = 64;

/// Most constants, or rows for spilled words: byte offsets stay below 2^31.
const MOST_ROWS: usize = (i32::MAX as usize) / size_of::<Lanes>();

/// A function: see [`super::function`].
type Entry = unsafe extern "sysv64" fn(
    file: *mut Lanes,
    block: *mut Lanes,
    constants: *const Lanes,
    rows: *mut Lanes,
    blocks: usize,
);

/// Machine code of segments.
#[derive(Debug)]
pub struct NativeCode {
    /// The instructions: written before they may be executed, and never writable again. None without any.
    memory: Option<Mmap>,
    constants: Vec<Lanes>,
    functions: Vec<Function>,
    bytes: usize,
}

#[derive(Clone, Copy, Debug)]
struct Function {
    /// Its first byte in the memory.
    start: usize,
    /// Rows for spilled words that it needs.
    rows: usize,
}

impl NativeCode {
    /// Compiles segments that are well formed for files of the shape, in so many registers.
    pub fn compile(
        segments: &[OpSegment],
        shape: FileShape,
        registers: u32,
    ) -> Result<Self, JitError> {
        let registers = registers.clamp(FEWEST_REGISTERS, MOST_REGISTERS);
        let mut assembler = Assembler::default();
        let mut constants = Constants::default();
        let mut functions = Vec::with_capacity(segments.len());
        for (index, segment) in segments.iter().enumerate() {
            assembler.align(ALIGNMENT);
            let start = assembler.len();
            let rows = write(segment, shape, &mut assembler, &mut constants, registers)
                .map_err(|what| JitError::Malformed { segment: index, what })?;
            functions.push(Function { start, rows });
        }
        let constants = constants.into_rows();
        let rows = functions.iter().map(|function| function.rows).max().unwrap_or(0);
        if constants.len().max(rows) > MOST_ROWS || assembler.len() > i32::MAX as usize {
            // Offsets were cut off.
            return Err(JitError::TooLarge { words: constants.len().max(rows) });
        }
        let code = assembler.into_bytes();
        let bytes = code.len() + size_of_val(&constants[..]);
        Ok(Self { memory: executable(&code)?, constants, functions, bytes })
    }

    /// Bytes of machine code and constants.
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// Runs function `index` over `blocks` blocks from `block` on, at least one.
    ///
    /// # Safety
    /// `file` holds the uniform words, and `block` the blocks, of a file of the shape it was compiled for, both
    /// to be read and written.
    pub unsafe fn run(&self, index: usize, file: *mut Lanes, block: *mut Lanes, blocks: usize) {
        let Function { start, rows } = self.functions[index];
        let Some(memory) = &self.memory else { return };
        let constants = self.constants.as_ptr();
        // SAFETY: a function was written at `start`, in this convention, and the memory lives as long as `self`.
        let entry = unsafe { std::mem::transmute::<*const u8, Entry>(memory[start..].as_ptr()) };
        let mut at_hand = [const { std::mem::MaybeUninit::<Lanes>::uninit() }; ROWS_AT_HAND];
        let mut many = Vec::new();
        let rows = if rows <= ROWS_AT_HAND {
            at_hand.as_mut_ptr().cast()
        } else {
            many.resize(rows, Lanes([0; LANES]));
            many.as_mut_ptr()
        };
        // SAFETY: the code reads constants below those it was written with, reads from `rows`, of which there are as
        // many as it needs, only what it wrote there, and else accesses what the caller vouches for. All is aligned
        // to 32 bytes, any bits are valid, and it calls nothing that could unwind or keep a pointer.
        unsafe { entry(file, block, constants, rows, blocks) }
    }
}

/// The bytes where they can be executed, and no longer written.
fn executable(code: &[u8]) -> Result<Option<Mmap>, JitError> {
    if code.is_empty() {
        return Ok(None);
    }
    let failed = |error: std::io::Error| JitError::Memory(error.to_string());
    let mut memory = MmapMut::map_anon(code.len()).map_err(failed)?;
    memory.copy_from_slice(code);
    memory.make_exec().map(Some).map_err(failed)
}
