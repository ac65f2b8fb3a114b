//! What lies beyond the edges of a picture.

use phenomenon_compiler::effects::Wrap;

/// Beyond so many pictures from the first, places are as good as that far away: no filter reaches back.
const FAR: f64 = 8.0;

/// Where a coordinate lies among `count` pixels, in pixels from the left edge of the picture. In f64,
/// where the position among 65,536 pixels keeps the 24 bits of the coordinate. Pictures that repeat
/// are gone back to the first.
pub(super) fn position(coordinate: f64, count: u32, wrap: Wrap) -> f64 {
    let inside = match wrap {
        Wrap::Periodic => coordinate - coordinate.floor(),
        Wrap::Mirror => coordinate - 2.0 * (coordinate / 2.0).floor(),
        Wrap::Clamp | Wrap::Constant => coordinate.clamp(-FAR, FAR),
    };
    inside * f64::from(count)
}

/// The pixel that stands at a place of the endless row that wrapping makes of `count` pixels; none
/// where it is outside, and a colour is given.
pub(super) fn pixel(place: i64, count: u32, wrap: Wrap) -> Option<u32> {
    let size = i64::from(count);
    let at = match wrap {
        Wrap::Periodic => place.rem_euclid(size),
        Wrap::Clamp => place.clamp(0, size - 1),
        Wrap::Mirror => {
            let at = place.rem_euclid(2 * size);
            if at < size { at } else { 2 * size - 1 - at }
        }
        Wrap::Constant => return (0..size).contains(&place).then_some(place as u32),
    };
    Some(at as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(wrap: Wrap) -> Vec<Option<u32>> {
        (-4..7).map(|place| pixel(place, 3, wrap)).collect()
    }

    #[test]
    fn rows_go_on_as_they_are_wrapped() {
        let numbers = |of: [u32; 11]| of.map(Some).to_vec();
        assert_eq!(row(Wrap::Periodic), numbers([2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0]));
        assert_eq!(row(Wrap::Clamp), numbers([0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2]));
        assert_eq!(row(Wrap::Mirror), numbers([2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0]));
        let inside = [None, None, None, None, Some(0), Some(1), Some(2), None, None, None, None];
        assert_eq!(row(Wrap::Constant), inside);
    }

    #[test]
    fn hard_places_stay_within_the_pictures_they_are_of() {
        for wrap in [Wrap::Periodic, Wrap::Clamp, Wrap::Mirror, Wrap::Constant] {
            for coordinate in [-0.0, 1e-45_f32, -1e-45, 0.999_999_94, f32::MAX, f32::MIN] {
                let at = position(f64::from(coordinate), 5, wrap);
                assert!(at.abs() <= 40.0, "{wrap:?} {coordinate}: {at}");
            }
        }
        assert_eq!(position(-0.25, 4, Wrap::Mirror), 7.0);
        assert_eq!(position(-0.25, 4, Wrap::Periodic), 3.0);
    }
}
