//! Machine code of a program's segments, whoever made it.

use std::ops::Range;

use super::cranelift::CraneliftCode;
#[cfg(target_arch = "x86_64")]
use super::native::{MOST_REGISTERS, NativeCode};
use super::{Generator, JitError};
use crate::ops::{OpSegment, verify};
use crate::storage::{FileShape, Lanes};

/// Largest number of uniforms or slots: byte offsets stay below 2^31.
const MOST_WORDS: usize = (i32::MAX as usize) / size_of::<Lanes>() - 1;

/// Bytes of blocks that functions run over one after another, before the next blocks have their turn: a function finds
/// what the one before it wrote in the cache nearest to the CPU.
const TILE: usize = 32 << 10;

/// Fewest blocks of a turn: a call has its price, and blocks overlap.
const FEWEST_BLOCKS: usize = 8;

/// The machine code of a program's segments.
#[derive(Debug)]
pub struct JitCode {
    machine: Machine,
    shape: FileShape,
    /// Blocks of a turn.
    tile: usize,
}

#[derive(Debug)]
enum Machine {
    #[cfg(target_arch = "x86_64")]
    Native(NativeCode),
    Cranelift(Box<CraneliftCode>),
}

impl JitCode {
    /// Compiles each segment to a function over files of that shape. Segments are compiled as they are:
    /// legalise, fold and split them before.
    ///
    /// # Errors
    /// See [`JitError`].
    pub fn compile(
        generator: Generator,
        segments: &[OpSegment],
        shape: FileShape,
    ) -> Result<Self, JitError> {
        generator.available()?;
        check(segments, shape)?;
        let machine = match generator {
            #[cfg(target_arch = "x86_64")]
            Generator::Native => {
                Machine::Native(NativeCode::compile(segments, shape, MOST_REGISTERS)?)
            }
            #[cfg(not(target_arch = "x86_64"))]
            Generator::Native => return Err(JitError::UnsupportedTarget),
            Generator::Cranelift => {
                Machine::Cranelift(Box::new(CraneliftCode::compile(segments, shape)?))
            }
        };
        Ok(Self { machine, shape, tile: tile(shape) })
    }

    /// Compiles by [`Generator::Native`] with fewer registers than there are (from 5 on), so that tests see words spilled.
    ///
    /// # Errors
    /// See [`JitError`].
    #[cfg(target_arch = "x86_64")]
    pub fn compile_with_registers(
        registers: u32,
        segments: &[OpSegment],
        shape: FileShape,
    ) -> Result<Self, JitError> {
        Generator::Native.available()?;
        check(segments, shape)?;
        let machine = Machine::Native(NativeCode::compile(segments, shape, registers)?);
        Ok(Self { machine, shape, tile: tile(shape) })
    }

    /// Runs function after function over blocks of the file, a few blocks at a time.
    ///
    /// # Panics
    /// If there is no such function, or the file is smaller than `uniforms + blocks.end * slots`.
    pub fn run(&self, functions: Range<usize>, lanes: &mut [Lanes], blocks: Range<usize>) {
        let FileShape { uniforms, slots } = self.shape;
        let words = blocks.end.checked_mul(slots).and_then(|words| words.checked_add(uniforms));
        assert!(
            words.is_some_and(|words| words <= lanes.len()),
            "a file of {} words cannot hold {} blocks",
            lanes.len(),
            blocks.end
        );
        // A segment without slots may pass any number of blocks, and stores nothing.
        if slots == 0 {
            return;
        }
        let file = lanes.as_mut_ptr();
        // No `step_by`, which divides.
        let mut first = blocks.start;
        while first < blocks.end {
            let blocks = self.tile.min(blocks.end - first);
            let before = uniforms + first * slots;
            for function in functions.clone() {
                // The code reads uniforms below `uniforms` and accesses slots below `slots` of these blocks
                // (`check`): all within `lanes` by the assertion, which this call alone may access now.
                match &self.machine {
                    #[cfg(target_arch = "x86_64")]
                    // SAFETY: see above; `block` is where the first of these blocks starts.
                    Machine::Native(code) => unsafe {
                        code.run(function, file, file.add(before), blocks);
                    },
                    // SAFETY: see above; so many bytes lie before the first of these blocks.
                    Machine::Cranelift(code) => unsafe {
                        code.run(function, file, before * size_of::<Lanes>(), blocks);
                    },
                }
            }
            first += blocks;
        }
    }

    /// Bytes of machine code, constants included.
    pub fn code_bytes(&self) -> usize {
        match &self.machine {
            #[cfg(target_arch = "x86_64")]
            Machine::Native(code) => code.bytes(),
            Machine::Cranelift(code) => code.bytes(),
        }
    }
}

/// Blocks of a turn, in a file of the shape.
fn tile(shape: FileShape) -> usize {
    (TILE / (shape.slots.max(1) * size_of::<Lanes>())).max(FEWEST_BLOCKS)
}

/// Whether segments can be compiled for files of the shape; the safety of running them rests on this.
fn check(segments: &[OpSegment], shape: FileShape) -> Result<(), JitError> {
    let words = shape.uniforms.max(shape.slots);
    if words > MOST_WORDS {
        return Err(JitError::TooLarge { words });
    }
    for (index, segment) in segments.iter().enumerate() {
        verify::inside(segment, shape)
            .map_err(|what| JitError::Malformed { segment: index, what })?;
    }
    Ok(())
}
