use crate::emit::functions::figures::{is_odd, mean_sign, spread};
use crate::emit::functions::passage::mixed;
use crate::emit::{Emit, Mask, Real};
use crate::nodes::finite::{FACTOR, SUMMAND, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// A checkerboard over u and v: `odd` where `floor(u tiling.x - offset.x) + floor(v tiling.y - offset.y)`
    /// is odd, else `even`. Only the value that is due is evaluated. MaterialX's `checkerboard` has the
    /// same squares, `color1` being `odd`.
    ///
    /// With the filter `footprint` it is their mean over what a pixel covers, so that a floor does not flicker far
    /// away but fades to `(even + odd) / 2`: the share of `odd` is `1/2 - 1/2 s(x) s(y)`, where `s` is the mean of
    /// `(-1)^floor` over a width, in closed form. The widths are `sqrt(du_dx² + du_dy²) tiling.x` and
    /// `sqrt(dv_dx² + dv_dy²) tiling.y`: those of the rectangle with the variance of the footprint along either
    /// axis. A footprint at a slant blurs somewhat more than it covers. Both values are evaluated then.
    checker in patterns generic,
    source "MaterialX 1.39, checkerboard; the filter: Apodaca and Gritz 1999, Advanced RenderMan, chapter 11",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U), in FACTOR;
        /// Where to look: up.
        v: scalar = state(Field::V), in FACTOR;
        /// Squares per unit; x and y count.
        tiling: vector = [8.0, 8.0, 8.0], in FACTOR, soft 0.0..=100.0;
        /// What the board is moved by, in squares; x and y count.
        offset: vector = [0.0; 3], in FACTOR, unit "squares", soft UNIT;
        /// Whether squares smaller than a pixel become their mean.
        filter: choice = 0, of ["none", "footprint"];
        /// Value of even squares, the one at the origin among them.
        even: generic = 0.0, in SUMMAND, when e.mask(i.filter == FOOTPRINT) | !odd(e, i);
        /// Value of odd squares.
        odd: generic = 1.0, in SUMMAND, when e.mask(i.filter == FOOTPRINT) | odd(e, i);
        /// Change of `u` along the longer axis of the footprint.
        du_dx: scalar = state(Field::DuDx), when e.mask(i.filter == FOOTPRINT), slope ("shifted_x", "u");
        /// Change of `v` along the longer axis of the footprint.
        dv_dx: scalar = state(Field::DvDx), when e.mask(i.filter == FOOTPRINT), slope ("shifted_x", "v");
        /// Change of `u` along the shorter axis of the footprint.
        du_dy: scalar = state(Field::DuDy), when e.mask(i.filter == FOOTPRINT), slope ("shifted_y", "u");
        /// Change of `v` along the shorter axis of the footprint.
        dv_dy: scalar = state(Field::DvDy), when e.mask(i.filter == FOOTPRINT), slope ("shifted_y", "v");
    }
    outputs {
        /// The value of the square.
        result: generic;
    }
    body |e, i| Outputs {
        result: match i.filter {
            FOOTPRINT => mixed(i.even, i.odd, share(i)),
            _ => odd(e, i).select(i.odd, i.even),
        }
    }
}

/// Number of the filter `footprint`.
const FOOTPRINT: i32 = 1;

#[inline(always)]
fn odd<E: Emit, T: Copy>(_: E, i: &Inputs<E, T>) -> E::Mask {
    is_odd(i.u * i.tiling.x - i.offset.x) ^ is_odd(i.v * i.tiling.y - i.offset.y)
}

/// The share of odd squares in the footprint.
#[inline(always)]
fn share<E: Emit, T: Copy>(i: &Inputs<E, T>) -> E::Real {
    let across = spread(i.du_dx, i.du_dy) * i.tiling.x.absolute();
    let up = spread(i.dv_dx, i.dv_dy) * i.tiling.y.absolute();
    let across = mean_sign(i.u * i.tiling.x - i.offset.x, across);
    let up = mean_sign(i.v * i.tiling.y - i.offset.y, up);
    ((across * up) * -0.5 + 0.5).saturate()
}

#[cfg(test)]
mod tests {
    fn at(u: f32, v: f32) -> f32 {
        number!(u = u, v = v, tiling = [2.0, 4.0, 0.0] => result)
    }

    #[test]
    fn squares_alternate_on_both_sides_of_the_origin() {
        assert_eq!([at(0.1, 0.1), at(0.6, 0.1), at(0.1, 0.3), at(0.6, 0.3)], [0.0, 1.0, 1.0, 0.0]);
        assert_eq!([at(-0.1, 0.1), at(-0.1, -0.1), at(-0.6, 0.1)], [1.0, 0.0, 0.0]);
        assert_eq!([at(0.5, 0.0), at(0.5_f32.next_down(), 0.0)], [1.0, 0.0]);
        assert_eq!([at(3e7, 0.1), at(-1e18, 1e19)], [0.0, 0.0]);
    }

    #[test]
    fn values_pass_to_the_bit_and_the_other_is_not_asked_for() {
        let (even, odd) = ([0.1, -0.0, 3.0, 0.5], [f32::NAN, 1.0, 2.0, 0.25]);
        assert_eq!(numbers!(u = 0.0, v = 0.0, even = even, odd = odd => result), even);
        assert!(demanded!(u = 0.0, v = 0.0 => even) && !demanded!(u = 0.0, v = 0.0 => odd));
        assert!(demanded!(u = 0.2, v = 0.0 => odd) && !demanded!(u = 0.2, v = 0.0 => even));
    }

    #[test]
    fn the_offset_is_in_squares() {
        let moved = number!(u = 0.1, v = 0.1, offset = [1.0, 0.0, 0.0] => result);
        assert_eq!(moved, 1.0);
    }

    /// With steps of `width` squares along u and `height` along v.
    fn filtered(u: f32, v: f32, width: f32, height: f32) -> f32 {
        number!(
            u = u, v = v, tiling = [1.0, 1.0, 0.0], filter = 1,
            du_dx = width * 0.6, du_dy = width * -0.8, dv_dx = 0.0, dv_dy = height => result
        )
    }

    /// The mean over the rectangle, by counting.
    fn counted(u: f32, v: f32, width: f32, height: f32) -> f64 {
        const SIDE: usize = 4000;
        let places = |middle: f32, width: f32| {
            (0..SIDE).map(move |k| {
                f64::from(middle) + f64::from(width) * ((k as f64 + 0.5) / SIDE as f64 - 0.5)
            })
        };
        let sign = |x: f64| if x.floor().rem_euclid(2.0) == 0.0 { 1.0 } else { -1.0 };
        let mean = |middle, width| places(middle, width).map(sign).sum::<f64>() / SIDE as f64;
        0.5 - 0.5 * mean(u, width) * mean(v, height)
    }

    #[test]
    fn filtered_it_is_the_mean_over_the_footprint() {
        for (u, v) in [(0.3, 0.4), (0.98, -0.51), (-3.02, 7.5), (100.25, -1.0), (2.0, 3.0)] {
            for (width, height) in [(0.1, 0.2), (0.9, 1.1), (1.0, 1.7), (3.3, 0.01), (7.9, 12.6)] {
                let (found, expected) =
                    (filtered(u, v, width, height), counted(u, v, width, height));
                assert!(
                    (f64::from(found) - expected).abs() < 5e-3,
                    "{u} {v} {width} {height}: {found}, not {expected}"
                );
            }
        }
    }

    #[test]
    fn filtered_it_is_the_squares_from_near_and_their_mean_from_afar() {
        for (u, v) in [(0.1, 0.1), (1.2, 0.1), (-0.1, 5.4), (0.0, 0.0), (1.0_f32.next_down(), 0.0)]
        {
            let squares = number!(u = u, v = v, tiling = [1.0; 3] => result);
            assert_eq!(filtered(u, v, 0.0, 0.0), squares, "{u} {v}");
            // On an edge half of each is covered, however small the footprint.
            let expected = if v == 0.0 { 0.5 } else { squares };
            assert_eq!(filtered(u, v, 1e-9, 1e-12), expected, "{u} {v}");
            assert!((filtered(u, v, 1e4, 1e5) - 0.5).abs() < 1e-7);
            assert_eq!(filtered(u, v, 1e30, 1e-30), 0.5);
        }
        let [nan, values] = [filtered(f32::NAN, 0.0, 0.5, 0.5), filtered(0.3, 0.0, f32::MAX, 1.0)];
        assert!((0.0..=1.0).contains(&nan) && (0.0..=1.0).contains(&values));
    }
}
