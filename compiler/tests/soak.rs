//! A hundred thousand compiles leave nothing behind. A program of its own: it counts the memory of the process.
#![cfg(target_os = "linux")]

use phenomenon_compiler::engine::jit::{Generator, JitCode};
use phenomenon_compiler::ops::{Op, OpSegment};
use phenomenon_compiler::storage::{FileShape, LANES, Lanes, Source};

/// `word + number`, so that no two neighbours are the same.
fn segment(number: u32) -> OpSegment {
    OpSegment {
        ops: vec![Op::Load(0), Op::Constant(number), Op::IntAdd(0, 1)],
        sources: vec![Source::Slot(0)],
        stores: vec![(1, 2)],
        wanted: vec![],
    }
}

/// Compiles and runs so many programs, one after another.
fn compile(generator: Generator, programs: u32) {
    for number in 0..programs {
        let shape = FileShape { uniforms: 0, slots: 2 };
        let code = JitCode::compile(generator, &[segment(number)], shape).expect("compiles");
        let mut lanes = [Lanes([number; LANES]); 2];
        code.run(0..1, &mut lanes, 0..1);
        assert_eq!(lanes[1], Lanes([number.wrapping_mul(2); LANES]));
    }
}

/// Pieces of memory, and KiB, of this process.
fn memory() -> (usize, usize) {
    let read = |file: &str| std::fs::read_to_string(file).expect("Linux has it");
    let status = read("/proc/self/status");
    let size = status.lines().find_map(|line| line.strip_prefix("VmSize:"));
    let size = size.and_then(|size| size.trim().strip_suffix(" kB"));
    let size = size.and_then(|size| size.trim().parse().ok()).expect("it is a number");
    (read("/proc/self/maps").lines().count(), size)
}

#[test]
fn compiling_over_and_over_leaves_nothing_behind() {
    for (generator, programs) in [(Generator::Native, 100_000), (Generator::Cranelift, 2_000)] {
        if generator.available().is_err() {
            continue;
        }
        compile(generator, 500);
        let (pieces, size) = memory();
        compile(generator, programs);
        let (pieces_after, size_after) = memory();
        // A page or a piece for each would be thousands; an allocator may keep a few more than before.
        assert!(pieces_after < pieces + 50, "{generator:?}: {pieces} to {pieces_after} pieces");
        assert!(size_after < size + 8 * 1024, "{generator:?}: {size} to {size_after} KiB");
    }
}
