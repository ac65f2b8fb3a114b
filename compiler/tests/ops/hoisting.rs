//! What is taken out of segments, and what it is worth.

use phenomenon_compiler::ops::hoist::Hoister;
use phenomenon_compiler::ops::{Op, OpSegment, dead, fold, verify};
use phenomenon_compiler::storage::{LANES, Lanes, Source};
use phenomenon_compiler::testing::random::Random;

use crate::random::Case;
use crate::samples::File;

/// The file with the words that are computed before all points behind its uniform words.
fn with_words(file: &File, words: &[u32]) -> File {
    let mut longer = File::new(words.len(), file.slots, file.blocks);
    for (lanes, &word) in longer.lanes.iter_mut().zip(words) {
        *lanes = Lanes([word; LANES]);
    }
    longer.lanes[words.len()..].copy_from_slice(&file.lanes[file.uniforms..]);
    longer
}

fn uniforms(file: &File) -> Vec<u32> {
    file.lanes[..file.uniforms].iter().map(|lanes| lanes.0[0]).collect()
}

/// Several segments share what is taken out of them; each does what it did.
#[test]
fn hoisting_changes_no_bit_and_leaves_no_uniform_operation() {
    let mut words = 0;
    for seed in 0..300 {
        let mut random = Random::new(3000 + seed);
        let cases = [(); 3].map(|()| {
            let size = 10 + random.below(120);
            Case::new(&mut random, size)
        });
        let most = cases.iter().map(|case| case.uniforms.len()).max().unwrap_or(0);
        let mut hoister = Hoister::new(most as u32);
        let rests = cases.each_ref().map(|case| {
            let rest = hoister.hoist(dead::remove(&fold::fold(&case.segment)));
            verify::legal(&rest).expect("it is a segment");
            check_rest(&rest);
            rest
        });
        let hoisted = hoister.finish();
        words += hoisted.words();
        for (case, rest) in cases.iter().zip(&rests) {
            let mut plain = case.file(&mut random, 0, 2);
            let mut before = uniforms(&plain);
            before.resize(most, 0);
            let all = hoisted.with_words(&before);
            assert_eq!(all.len(), most + hoisted.words());
            assert_eq!(all[..most], before);
            let mut file = with_words(&plain, &all);
            plain.interpret(&case.segment);
            file.interpret(rest);
            let what = format!("seed {seed}\n{}\nrest:\n{rest}", case.segment);
            let kind = |slot: u32| case.slots[slot as usize];
            // Those of the longer file begin elsewhere.
            with_words(&plain, &all).assert_same(&file, case.slots.len() as u32, kind, &what);
        }
    }
    assert!(words > 300, "{words}");
}

/// Loads and constants aside, all that is left differs from point to point.
fn check_rest(rest: &OpSegment) {
    let mut varies: Vec<bool> = Vec::new();
    for &op in &rest.ops {
        let mut any = match op {
            Op::Load(source) => matches!(rest.sources[source as usize], Source::Slot(_)),
            _ => false,
        };
        op.for_each_operand(|id| any |= varies[id as usize]);
        assert!(any || op.is_fetch(), "{op} is the same for all points\n{rest}");
        varies.push(any);
    }
}

#[test]
fn what_two_segments_share_is_one_word_and_bare_words_stay() {
    let ops = vec![Op::Load(0), Op::Load(1), Op::Load(2), Op::Sub(0, 1), Op::Mul(2, 3)];
    let sources = vec![Source::Uniform(0), Source::Uniform(1), Source::Slot(0)];
    let segment = |ops, stores| OpSegment { ops, sources: sources.clone(), stores, wanted: vec![] };
    let mut hoister = Hoister::new(2);
    let first = hoister.hoist(segment(ops.clone(), vec![(1, 4)]));
    let second = hoister.hoist(segment(ops, vec![(1, 3), (2, 4)]));
    let bare = segment(vec![Op::Load(0), Op::Load(2), Op::Add(0, 1)], vec![(1, 2)]);
    assert_eq!(hoister.hoist(bare.clone()), bare);
    let text = "%0 = load slot 0\n%1 = load uniform 2\n%2 = mul %0, %1\nstore slot 1, %2\n";
    assert_eq!(first.to_string(), text);
    assert_eq!(
        second.to_string(),
        "%0 = load slot 0\n%1 = load uniform 2\n%2 = mul %0, %1\nstore slot 1, %1\nstore slot 2, %2\n"
    );
    let hoisted = hoister.finish();
    assert_eq!(
        hoisted.to_string(),
        "when parameters are bound:\n%0 = load uniform 0\n%1 = load uniform 1\n%2 = sub %0, %1\nstore uniform 2, %2\n"
    );
    let words = [3.0_f32, 0.5].map(f32::to_bits);
    assert_eq!(hoisted.with_words(&words)[2], 2.5_f32.to_bits());
}
