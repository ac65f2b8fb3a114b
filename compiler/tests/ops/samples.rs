//! Hard words, and comparing what segments leave in their files.

use phenomenon_compiler::ops::{Class, Op, OpId, OpSegment, interpret};
use phenomenon_compiler::storage::{LANES, Lanes};
use phenomenon_compiler::testing::random::Random;

/// Numbers that break careless code.
pub const REALS: &[f32] = &[
    0.0,
    -0.0,
    1.0,
    -1.0,
    1.0 + f32::EPSILON,
    1.0 - f32::EPSILON / 2.0,
    -1.0 - f32::EPSILON,
    0.5,
    -0.5,
    0.499_999_97,
    0.500_000_06,
    1.5,
    2.5,
    -2.5,
    3.0,
    0.1,
    -0.3,
    1e-3,
    16_777_215.0,
    16_777_216.0,
    -16_777_217.0,
    8_388_607.5,
    4_194_303.8,
    2_147_483_500.0,
    2_147_483_600.0,
    -2_147_483_600.0,
    -2_147_484_000.0,
    4_294_967_300.0,
    1e20,
    -1e30,
    f32::MAX,
    f32::MIN,
    f32::MIN_POSITIVE,
    -f32::MIN_POSITIVE,
    1e-45,
    -1e-45,
    1.175_494_2e-38,
    1.844_674_4e19,
    8.507_059e37,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];

/// Integers that break careless code.
pub const INTS: &[i32] = &[
    0,
    1,
    -1,
    2,
    -2,
    31,
    255,
    65_535,
    65_536,
    46_341,
    -46_341,
    16_777_217,
    33_554_433,
    0x1234_5678,
    -559_038_737,
    i32::MAX,
    i32::MAX - 63,
    i32::MAX - 64,
    i32::MIN,
    i32::MIN + 1,
    i32::MIN + 65,
];

/// What kind of value a word holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Real,
    Int,
    Mask,
}

impl Kind {
    pub fn words(self) -> Vec<u32> {
        match self {
            Kind::Real => {
                // A signalling NaN and one with the other sign, too.
                let nans = [0x7fa0_0000, 0xffc0_0000];
                REALS.iter().map(|value| value.to_bits()).chain(nans).collect()
            }
            Kind::Int => INTS.iter().map(|&value| value as u32).collect(),
            Kind::Mask => vec![0, u32::MAX],
        }
    }

    /// A word of the kind: half of them hard, half arbitrary (numbers of moderate size).
    pub fn word(self, random: &mut Random) -> u32 {
        if self == Kind::Mask || random.chance(50) {
            return random.pick(&self.words());
        }
        match self {
            Kind::Real => ((random.below(2_000_001) as f32 - 1_000_000.0) / 8192.0).to_bits(),
            _ => random.bits() as u32,
        }
    }
}

/// The kind of what `op` yields, given the kinds of its operands.
pub fn yields(op: Op, kind: impl Fn(OpId) -> Kind) -> Kind {
    match op.class() {
        Some(Class::Real) => Kind::Real,
        Some(Class::Int) => Kind::Int,
        Some(Class::Mask) => Kind::Mask,
        None => {
            let mut last = None;
            op.for_each_operand(|id| last = Some(id));
            kind(last.expect("whoever makes a fetch knows"))
        }
    }
}

/// Whether two words of a kind are the same: bit for bit, NaNs being one class.
pub fn same(kind: Kind, a: u32, b: u32) -> bool {
    let nan = |bits: u32| f32::from_bits(bits).is_nan();
    a == b || kind == Kind::Real && nan(a) && nan(b)
}

/// A file, and where things lie in it.
#[derive(Clone)]
pub struct File {
    pub uniforms: usize,
    pub slots: usize,
    pub blocks: usize,
    pub lanes: Vec<Lanes>,
}

impl File {
    pub fn new(uniforms: usize, slots: usize, blocks: usize) -> Self {
        // Slots not written must stay as they are, whatever they hold.
        let lanes = vec![Lanes([0x5eed_5eed; LANES]); uniforms + slots * blocks];
        Self { uniforms, slots, blocks, lanes }
    }
    pub fn slot(&mut self, block: usize, slot: u32) -> &mut Lanes {
        &mut self.lanes[self.uniforms + block * self.slots + slot as usize]
    }
    pub fn interpret(&mut self, segment: &OpSegment) {
        interpret::run(segment, self.uniforms, self.slots, &mut self.lanes, self.blocks);
    }
    /// Asserts that both hold the same, up to `slots` (scratch lies behind).
    pub fn assert_same(&self, other: &Self, slots: u32, kind: impl Fn(u32) -> Kind, what: &str) {
        assert_eq!(self.lanes[..self.uniforms], other.lanes[..other.uniforms], "uniforms: {what}");
        for block in 0..self.blocks {
            for slot in 0..slots {
                let at =
                    |file: &Self| file.lanes[file.uniforms + block * file.slots + slot as usize];
                let (a, b) = (at(self), at(other));
                for lane in 0..LANES {
                    assert!(
                        same(kind(slot), a.0[lane], b.0[lane]),
                        "block {block} lane {lane} slot {slot}: {:08x} and {:08x}\n{what}",
                        a.0[lane],
                        b.0[lane]
                    );
                }
            }
        }
    }
}
