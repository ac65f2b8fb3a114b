//! Inputs on which back ends tend to differ, then random ones from a fixed seed.

use phenomenon_compiler::testing::random::Random;

use crate::back_ends::Rows;
use crate::cases::Word;

/// Even in -scale..scale.
fn real(random: &mut Random, scale: f32) -> u32 {
    (random.bits() as i32 as f32 * (scale / 2_147_483_648.0)).to_bits()
}

/// Numbers at the edges of what operations and functions distinguish; each with its negative.
pub fn hard_reals() -> Vec<u32> {
    let mut magnitudes = vec![
        0.0,
        f32::from_bits(1),
        f32::from_bits(2),
        f32::from_bits(0x007f_ffff),
        f32::MIN_POSITIVE,
        1e-30,
        1e-10,
        1e-4,
        0.1,
        0.25,
        0.3,
        1.0 / 3.0,
        0.7,
        1.1,
        1.5,
        2.5,
        3.5,
        4.5,
        7.3,
        10.0,
        44.4,
        87.3,
        88.73,
        103.9,
        104.0,
        126.5,
        127.5,
        149.5,
        255.5,
        1000.25,
        12345.678,
        1e5,
        1e10,
        1e20,
        1e38,
        f32::MAX,
        f32::INFINITY,
    ];
    let exact = [
        0.5f32,
        1.0,
        2.0,
        3.0,
        8_388_608.0,
        16_777_216.0,
        1_073_741_824.0,
        2_147_483_648.0,
        4_294_967_296.0,
        std::f32::consts::FRAC_1_SQRT_2,
        std::f32::consts::SQRT_2,
        std::f32::consts::FRAC_PI_4,
        std::f32::consts::FRAC_PI_2,
        std::f32::consts::PI,
        std::f32::consts::TAU,
        0.414_213_57,
        std::f32::consts::LN_2,
        0.346_573_6,
        127.0,
        128.0,
        126.0,
        149.0,
        150.0,
    ];
    for value in exact {
        magnitudes.extend([value.next_down(), value, value.next_up()]);
    }
    let mut bits: Vec<u32> = magnitudes.iter().map(|value| value.to_bits()).collect();
    bits.extend([0x7fc0_0000, 0x7fc1_2345, 0x7f80_0001, 0x7fff_ffff]);
    let negative: Vec<u32> = bits.iter().map(|bits| bits | 0x8000_0000).collect();
    bits.extend(negative);
    bits
}

fn hard_ints() -> Vec<u32> {
    let mut ints = vec![];
    for value in [
        0i32,
        1,
        2,
        3,
        7,
        255,
        256,
        65535,
        65536,
        8_388_607,
        16_777_215,
        16_777_216,
        16_777_217,
        33_554_431,
        33_554_433,
        0x4000_0000,
        0x7fff_ff80,
        0x7fff_ffc0,
        i32::MAX,
    ] {
        ints.extend([value as u32, value.wrapping_neg() as u32, !value as u32]);
    }
    ints.extend([0x8000_0000, 0x5555_5555, 0xaaaa_aaaa, 0x7f80_0000, 0xff80_0000]);
    ints
}

fn hard(word: Word) -> Vec<u32> {
    match word {
        Word::Real => hard_reals(),
        Word::Int => hard_ints(),
        Word::Mask => vec![0, u32::MAX],
    }
}

fn random(word: Word, random: &mut Random) -> u32 {
    match (word, random.below(4)) {
        (Word::Mask, choice) => {
            if choice < 2 {
                0
            } else {
                u32::MAX
            }
        }
        (Word::Int, 0) => random.below(64) as u32,
        (Word::Real, 0) => real(random, 1.0),
        (Word::Real, 1) => real(random, 100.0),
        _ => random.bits() as u32,
    }
}

/// Rows for the words: every hard combination for up to two inputs, a sample for more, and random
/// rows. Not a multiple of eight, so that a last block is partly filled.
pub fn rows(words: &[Word]) -> Rows {
    let mut rows = Rows::new(words.len());
    let mut source = Random::new(0x5eed ^ words.len() as u64);
    let lists: Vec<Vec<u32>> = words.iter().map(|&word| hard(word)).collect();
    match &lists[..] {
        [only] => only.iter().for_each(|&a| rows.push(&[a])),
        [first, second] => {
            for &a in first {
                second.iter().for_each(|&b| rows.push(&[a, b]));
            }
        }
        _ => {
            for _ in 0..30_000 {
                let row: Vec<u32> = lists.iter().map(|list| source.pick(list)).collect();
                rows.push(&row);
            }
        }
    }
    for _ in 0..20_003 {
        let row: Vec<u32> = words.iter().map(|&word| random(word, &mut source)).collect();
        rows.push(&row);
    }
    rows
}
