//! Eight points at once, over AVX2 and FMA.
//!
//! Every operation is one or a few intrinsics. The token [`Avx2`] is made in [`run`] only, which
//! has the CPU features enabled; all else is `#[inline(always)]` and so becomes part of it. A call
//! that stayed a call would be slow, not wrong; `.ci/kernels-are-inlined` looks for those.

use std::arch::x86_64::*;
use std::mem::MaybeUninit;
use std::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Neg, Not, Sub};

use super::methods::standard_functions;
use super::{Bits, Emit, Int, Mask, Real, Select, Sink, Table, Words};
use crate::emit::Body;
use crate::storage::{Lanes, Placement, Source};

/// The back end of eight `f32` points. Its existence proves that the CPU has AVX2 and FMA.
#[derive(Clone, Copy, Debug)]
pub struct Avx2(());

/// Eight numbers.
#[derive(Clone, Copy, Debug)]
pub struct F32x8(__m256);
/// Eight integers.
#[derive(Clone, Copy, Debug)]
pub struct I32x8(__m256i);
/// Eight truth values, each all bits set or none.
#[derive(Clone, Copy, Debug)]
pub struct Bool8(__m256);

/// Calls intrinsics. The argument that makes each call sound is the same one.
macro_rules! simd {
    ($value:expr) => {
        // SAFETY: a value of this module's types exists only where the token `Avx2` did, which
        // `run` alone makes, behind the CPU features these intrinsics need.
        unsafe { $value }
    };
}

impl Emit for Avx2 {
    type Real = F32x8;
    type Int = I32x8;
    type Mask = Bool8;
    #[inline(always)]
    fn real(self, value: f64) -> F32x8 {
        F32x8(simd!(_mm256_set1_ps(value as f32)))
    }
    #[inline(always)]
    fn int(self, value: i32) -> I32x8 {
        I32x8(simd!(_mm256_set1_epi32(value)))
    }
    #[inline(always)]
    fn mask(self, value: bool) -> Bool8 {
        let bits = if value { -1 } else { 0 };
        Bool8(simd!(_mm256_castsi256_ps(_mm256_set1_epi32(bits))))
    }
    #[inline(always)]
    fn table(self, table: Table, index: I32x8) -> F32x8 {
        let (first, last) = simd!((_mm256_setzero_si256(), _mm256_set1_epi32(table.last())));
        let within = simd!(_mm256_min_epi32(_mm256_max_epi32(index.0, first), last));
        // SAFETY: the positions are those of the table's numbers now, and see `simd`.
        F32x8(unsafe { _mm256_i32gather_ps::<4>(table.numbers().as_ptr(), within) })
    }
}

macro_rules! operators {
    ($($type:ident, $trait:ident $method:ident $intrinsic:ident;)+) => {$(
        impl $trait for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(simd!($intrinsic(self.0, other.0)))
            }
        }
    )+};
}
operators! {
    F32x8, Add add _mm256_add_ps;
    F32x8, Sub sub _mm256_sub_ps;
    F32x8, Mul mul _mm256_mul_ps;
    F32x8, Div div _mm256_div_ps;
    I32x8, Add add _mm256_add_epi32;
    I32x8, Sub sub _mm256_sub_epi32;
    I32x8, Mul mul _mm256_mullo_epi32;
    I32x8, BitAnd bitand _mm256_and_si256;
    I32x8, BitOr bitor _mm256_or_si256;
    I32x8, BitXor bitxor _mm256_xor_si256;
    Bool8, BitAnd bitand _mm256_and_ps;
    Bool8, BitOr bitor _mm256_or_ps;
    Bool8, BitXor bitxor _mm256_xor_ps;
}

macro_rules! with_constant {
    ($($trait:ident $method:ident),+) => {$(
        impl $trait<f64> for F32x8 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, constant: f64) -> Self {
                self.$method(self.same(constant))
            }
        }
    )+};
}
with_constant!(Add add, Sub sub, Mul mul, Div div);

impl Neg for F32x8 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(simd!(_mm256_xor_ps(self.0, _mm256_set1_ps(-0.0))))
    }
}

impl Not for Bool8 {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(simd!(_mm256_xor_ps(self.0, _mm256_castsi256_ps(_mm256_set1_epi32(-1)))))
    }
}

impl Select<Bool8> for F32x8 {
    #[inline(always)]
    fn select(mask: Bool8, if_true: Self, if_false: Self) -> Self {
        // The blend looks at sign bits; a mask has all bits alike.
        Self(simd!(_mm256_blendv_ps(if_false.0, if_true.0, mask.0)))
    }
}

impl Select<Bool8> for I32x8 {
    #[inline(always)]
    fn select(mask: Bool8, if_true: Self, if_false: Self) -> Self {
        let (t, f) = simd!((_mm256_castsi256_ps(if_true.0), _mm256_castsi256_ps(if_false.0)));
        Self(simd!(_mm256_castps_si256(_mm256_blendv_ps(f, t, mask.0))))
    }
}

impl Select<Self> for Bool8 {
    #[inline(always)]
    fn select(mask: Self, if_true: Self, if_false: Self) -> Self {
        Self(simd!(_mm256_blendv_ps(if_false.0, if_true.0, mask.0)))
    }
}

impl Real for F32x8 {
    type Mask = Bool8;
    type Int = I32x8;
    #[inline(always)]
    fn same(self, value: f64) -> Self {
        Self(simd!(_mm256_set1_ps(value as f32)))
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self(simd!(_mm256_fmadd_ps(self.0, factor.0, addend.0)))
    }
    #[inline(always)]
    fn minimum(self, other: Self) -> Self {
        // The instruction yields its second operand for NaN and for equal zeros, as defined.
        Self(simd!(_mm256_min_ps(self.0, other.0)))
    }
    #[inline(always)]
    fn maximum(self, other: Self) -> Self {
        Self(simd!(_mm256_max_ps(self.0, other.0)))
    }
    #[inline(always)]
    fn absolute(self) -> Self {
        Self(simd!(_mm256_andnot_ps(_mm256_set1_ps(-0.0), self.0)))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(simd!(_mm256_sqrt_ps(self.0)))
    }
    #[inline(always)]
    fn floor(self) -> Self {
        Self(simd!(_mm256_floor_ps(self.0)))
    }
    #[inline(always)]
    fn ceil(self) -> Self {
        Self(simd!(_mm256_ceil_ps(self.0)))
    }
    #[inline(always)]
    fn truncate(self) -> Self {
        Self(simd!(_mm256_round_ps::<{ _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC }>(self.0)))
    }
    #[inline(always)]
    fn round_even(self) -> Self {
        Self(simd!(_mm256_round_ps::<{ _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC }>(self.0)))
    }
    #[inline(always)]
    fn less(self, other: Self) -> Bool8 {
        Bool8(simd!(_mm256_cmp_ps::<_CMP_LT_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn less_equal(self, other: Self) -> Bool8 {
        Bool8(simd!(_mm256_cmp_ps::<_CMP_LE_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn equal(self, other: Self) -> Bool8 {
        Bool8(simd!(_mm256_cmp_ps::<_CMP_EQ_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn not_equal(self, other: Self) -> Bool8 {
        Bool8(simd!(_mm256_cmp_ps::<_CMP_NEQ_UQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn to_int(self) -> I32x8 {
        // The instruction yields i32::MIN for whatever does not fit: flipped to i32::MAX above the
        // range, cleared for NaN.
        I32x8(simd!({
            let raw = _mm256_cvttps_epi32(self.0);
            let above = _mm256_cmp_ps::<_CMP_GE_OQ>(self.0, _mm256_set1_ps(2_147_483_648.0));
            let number = _mm256_cmp_ps::<_CMP_ORD_Q>(self.0, self.0);
            let in_range = _mm256_xor_si256(raw, _mm256_castps_si256(above));
            _mm256_and_si256(in_range, _mm256_castps_si256(number))
        }))
    }
    standard_functions!();
}

impl Bits for F32x8 {
    #[inline(always)]
    fn to_bits(self) -> I32x8 {
        I32x8(simd!(_mm256_castps_si256(self.0)))
    }
    #[inline(always)]
    fn from_bits(bits: I32x8) -> Self {
        Self(simd!(_mm256_castsi256_ps(bits.0)))
    }
}

impl Int for I32x8 {
    type Mask = Bool8;
    type Real = F32x8;
    #[inline(always)]
    fn same(self, value: i32) -> Self {
        Self(simd!(_mm256_set1_epi32(value)))
    }
    #[inline(always)]
    fn shift_left(self, bits: u32) -> Self {
        Self(simd!(_mm256_sll_epi32(self.0, _mm_cvtsi32_si128(bits as i32))))
    }
    #[inline(always)]
    fn shift_right(self, bits: u32) -> Self {
        Self(simd!(_mm256_srl_epi32(self.0, _mm_cvtsi32_si128(bits as i32))))
    }
    #[inline(always)]
    fn shift_right_signed(self, bits: u32) -> Self {
        Self(simd!(_mm256_sra_epi32(self.0, _mm_cvtsi32_si128(bits as i32))))
    }
    #[inline(always)]
    fn equal(self, other: Self) -> Bool8 {
        Bool8(simd!(_mm256_castsi256_ps(_mm256_cmpeq_epi32(self.0, other.0))))
    }
    #[inline(always)]
    fn less(self, other: Self) -> Bool8 {
        Bool8(simd!(_mm256_castsi256_ps(_mm256_cmpgt_epi32(other.0, self.0))))
    }
    #[inline(always)]
    fn to_real(self) -> F32x8 {
        F32x8(simd!(_mm256_cvtepi32_ps(self.0)))
    }
}

impl Mask for Bool8 {}

/// Most input words a body may have to run here.
pub const MOST_INPUTS: usize = 64;

/// Input word `i` of block `b` lies at `first[i] + b * step[i]`.
#[derive(Clone, Copy)]
struct Origin {
    first: usize,
    step: usize,
}

/// The inputs of a block. Every position it can name was checked against the file in [`run`].
struct Inputs<'a> {
    file: *const __m256,
    origins: &'a [Origin],
    block: usize,
}

impl Inputs<'_> {
    #[inline(always)]
    fn load(&self, index: usize) -> __m256 {
        let origin = self.origins[index];
        // SAFETY: `run` checked the last block's position, and `block` is at most that. `Lanes` is
        // 32 bytes aligned to 32, as `__m256`.
        unsafe { _mm256_load_ps(self.file.add(origin.first + self.block * origin.step).cast()) }
    }
}

impl Words<Avx2> for Inputs<'_> {
    #[inline(always)]
    fn real(&self, index: usize) -> F32x8 {
        F32x8(self.load(index))
    }
    #[inline(always)]
    fn int(&self, index: usize) -> I32x8 {
        I32x8(simd!(_mm256_castps_si256(self.load(index))))
    }
    #[inline(always)]
    fn mask(&self, index: usize) -> Bool8 {
        Bool8(self.load(index))
    }
    #[inline(always)]
    fn fixed(&self, index: usize) -> i32 {
        simd!(_mm256_cvtsi256_si32(_mm256_castps_si256(self.load(index))))
    }
}

/// The outputs of a block, `count` words from `first` on.
struct Outputs {
    first: *mut __m256,
    count: usize,
}

impl Outputs {
    #[inline(always)]
    fn store(&mut self, index: usize, value: __m256) {
        assert!(index < self.count, "a body writes past its outputs");
        // SAFETY: `run` checked that `count` words from `first` lie in the file.
        unsafe { _mm256_store_ps(self.first.add(index).cast(), value) }
    }
}

impl Sink<Avx2> for Outputs {
    #[inline(always)]
    fn real(&mut self, index: usize, value: F32x8) {
        self.store(index, value.0);
    }
    #[inline(always)]
    fn int(&mut self, index: usize, value: I32x8) {
        self.store(index, simd!(_mm256_castsi256_ps(value.0)));
    }
    #[inline(always)]
    fn mask(&mut self, index: usize, value: Bool8) {
        self.store(index, value.0);
    }
}

/// Runs `B` over the blocks. Output slots may be input slots too: a body reads a block's inputs
/// before it writes.
///
/// # Safety
/// The CPU must have AVX2 and FMA where the caller is not itself compiled for them.
#[target_feature(enable = "avx2,fma")]
pub fn run<B: Body>(lanes: &mut [Lanes], placement: &Placement<'_>) {
    let count = placement.sources.len();
    if placement.blocks == 0 {
        return;
    }
    assert!(count <= MOST_INPUTS, "a body has more input words than a kernel takes");
    let last = placement.first + placement.blocks - 1;
    let mut origins = [const { MaybeUninit::<Origin>::uninit() }; MOST_INPUTS];
    for (origin, &source) in origins.iter_mut().zip(placement.sources) {
        let (first, step) = match source {
            Source::Uniform(at) | Source::Constant { at, .. } => (at as usize, 0),
            Source::Slot(slot) => (placement.shape.slot(slot, 0), placement.shape.slots),
        };
        assert!(first + last * step < lanes.len(), "a source lies outside the file");
        origin.write(Origin { first, step });
    }
    // SAFETY: the first `count` were written just now.
    let origins = unsafe { std::slice::from_raw_parts(origins.as_ptr().cast::<Origin>(), count) };
    let end = placement.output(0, last) + B::OUTPUTS;
    assert!(end <= lanes.len(), "the outputs lie outside the file");

    let file = lanes.as_mut_ptr().cast::<__m256>();
    for block in placement.range() {
        let inputs = Inputs { file, origins, block };
        // SAFETY: the last block's outputs end within the file, and this block is not after it.
        let first = unsafe { file.add(placement.output(0, block)) };
        B::run(Avx2(()), &inputs, &mut Outputs { first, count: B::OUTPUTS });
    }
}
