//! Segments as text.

use phenomenon_compiler::ops::{Op, OpSegment, dead};
use phenomenon_compiler::storage::Source;

fn segment() -> OpSegment {
    OpSegment {
        ops: vec![
            Op::Load(1),
            Op::Load(2),
            Op::Constant(0x3fc0_0000),
            Op::Constant(0xc049_0fdb),
            Op::MulAdd(0, 2, 3),
            Op::Less(4, 1),
            Op::Constant(u32::MAX),
            Op::Constant(7),
            Op::ShiftRightSigned(7, 3),
            Op::Select(5, 4, 1),
            Op::Constant(0x8000_0000),
            Op::Add(9, 10),
        ],
        sources: vec![Source::Slot(9), Source::Uniform(4), Source::Slot(2)],
        stores: vec![(3, 9), (4, 6), (5, 8), (6, 11)],
        wanted: vec![Source::Slot(12), Source::Uniform(1)],
    }
}

#[test]
fn a_segment_prints_as_text() {
    let expected = "\
where slot 12
where uniform 1
%0 = load uniform 4
%1 = load slot 2
%2 = constant 0x1.8p0 (1.5)
%3 = constant -0x1.921fb6p1 (-3.1415927)
%4 = mul_add %0, %2, %3
%5 = less %4, %1
%6 = constant all
%7 = constant 0x00000007 (integer 7)
%8 = shift_right_signed %7, 3
%9 = select %5, %4, %1
%10 = constant -0x0.0p0 (-0)
%11 = add %9, %10
store slot 3, %9
store slot 4, %6
store slot 5, %8
store slot 6, %11
";
    assert_eq!(segment().to_string(), expected);
}

#[test]
fn dead_operations_and_sources_go() {
    let mut segment = segment();
    segment.stores = vec![(3, 5)];
    let expected = "\
where slot 12
where uniform 1
%0 = load uniform 4
%1 = load slot 2
%2 = constant 0x1.8p0 (1.5)
%3 = constant -0x1.921fb6p1 (-3.1415927)
%4 = mul_add %0, %2, %3
%5 = less %4, %1
store slot 3, %5
";
    let live = dead::remove(&segment);
    assert_eq!(live.to_string(), expected);
    assert_eq!(live.sources, [Source::Uniform(4), Source::Slot(2)]);
}
