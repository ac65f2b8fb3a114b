//! Segments that not all lanes want.

use phenomenon_compiler::ops::{OpSegment, dead, fold, split};
use phenomenon_compiler::storage::{LANES, Lanes, Source};
use phenomenon_compiler::testing::random::Random;

use crate::machine_code::makers;
use crate::random::Case;
use crate::samples::{File, Kind};

/// A random segment with one or two masks of who wants it: in slots behind its own, and a uniform one.
fn guarded(random: &mut Random) -> (Case, Vec<u32>) {
    let mut case = Case::new(random, 120);
    let first = case.slots.len() as u32;
    let masks: Vec<u32> = (first..first + 1 + random.below(2) as u32).collect();
    case.slots.extend(masks.iter().map(|_| Kind::Mask));
    case.segment.wanted = masks.iter().map(|&slot| Source::Slot(slot)).collect();
    if random.below(2) == 0 {
        case.segment.wanted.push(Source::Uniform(case.uniforms.len() as u32));
        case.uniforms.push(Kind::Mask);
    }
    (case, masks)
}

/// Fills the masks; every other block is wanted by nobody as a whole.
fn fill(file: &mut File, case: &Case, masks: &[u32], random: &mut Random) {
    for block in 0..file.blocks {
        for &slot in masks {
            let words = [(); LANES].map(|()| if random.below(3) > 0 { u32::MAX } else { 0 });
            *file.slot(block, slot) = Lanes(words);
        }
        if block % 2 == 0 {
            *file.slot(block, masks[0]) = Lanes([0; LANES]);
        }
    }
    if let Some(Source::Uniform(at)) = case.segment.wanted.last() {
        file.lanes[*at as usize] = Lanes([u32::MAX; LANES]);
    }
}

/// Asserts that lanes that want it got the same, and that blocks nobody wants are as they were.
fn assert_wanted_same(
    got: &mut File,
    meant: &mut File,
    before: &mut File,
    case: &Case,
    what: &str,
) {
    let mut skipped = 0;
    for block in 0..got.blocks {
        let mut wants = [true; LANES];
        for mask in &case.segment.wanted {
            let words = match *mask {
                Source::Slot(slot) => before.slot(block, slot).0,
                Source::Uniform(at) | Source::Constant { at, .. } => before.lanes[at as usize].0,
            };
            for (wants, word) in wants.iter_mut().zip(words) {
                *wants &= word != 0;
            }
        }
        let nobody = !wants.contains(&true);
        skipped += usize::from(nobody);
        for slot in 0..case.slots.len() as u32 {
            let [got, meant, before] =
                [&mut *got, &mut *meant, &mut *before].map(|file| file.slot(block, slot).0);
            for lane in 0..LANES {
                if nobody {
                    assert_eq!(got[lane], before[lane], "block {block}, slot {slot}\n{what}");
                } else if wants[lane] {
                    let nan = |word| f32::from_bits(word).is_nan();
                    let is_real = case.slots[slot as usize] == Kind::Real;
                    let same =
                        got[lane] == meant[lane] || is_real && nan(got[lane]) && nan(meant[lane]);
                    assert!(same, "block {block}, slot {slot}, lane {lane}\n{what}");
                }
            }
        }
    }
    assert!(skipped > 0, "no block was skipped");
}

#[test]
fn blocks_nobody_wants_are_left_alone_and_the_others_get_what_they_should() {
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let (case, masks) = guarded(&mut random);
        let folded = dead::remove(&fold::fold(&case.segment));
        let cut = split::split(&folded, 25, case.slots.len() as u32);
        let mut before = case.file(&mut random, cut.scratch, 7);
        fill(&mut before, &case, &masks, &mut random);
        let mut meant = before.clone();
        meant.interpret(&OpSegment { wanted: vec![], ..case.segment.clone() });
        let what = format!("seed {seed}\n{}", case.segment);
        for segments in [vec![case.segment.clone()], vec![folded], cut.parts] {
            let mut got = before.clone();
            segments.iter().for_each(|segment| got.interpret(segment));
            assert_wanted_same(&mut got, &mut meant, &mut before, &case, &what);
            for maker in makers() {
                let mut got = before.clone();
                maker.run(&segments, &mut got);
                let what = format!("{maker:?}, {what}");
                assert_wanted_same(&mut got, &mut meant, &mut before, &case, &what);
            }
        }
    }
}
