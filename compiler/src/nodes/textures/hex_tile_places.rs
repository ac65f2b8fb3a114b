use crate::emit::functions::cells::numbered_share;
use crate::emit::functions::gradient_noise::cell_of;
use crate::emit::functions::placing::place;
use crate::emit::{Emit, Int, Mask, Real, Vector};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Three places on a picture for one on a surface, so that nobody sees it repeat: the plane is covered by
    /// overlapping hexagons, each of which has the picture turned, scaled and moved at random. At every place three of
    /// them overlap. One `texture_lookup` for each, and `hex_tile_blend` of the three by `weights`, make the whole,
    /// which MaterialX has as `hextiledimage` and `hextilednormalmap`.
    ///
    /// Coordinates are skewed into a lattice of triangles, 2 sqrt(3) to a unit; its corners `c` are the middles of
    /// the hexagons, and weights the barycentric coordinates in the triangle. A hexagon reads
    /// `R(angle) (p - c) / size + c + offset`, with `p = (u tiling.x, v tiling.y)` and, from two random numbers `a`
    /// and `b` of `c` and the seed, `angle = rotation (2 a - 1)`, `size` between its bounds by `b`, and `offset (a, b)`.
    /// The random numbers are not those of MaterialX: patches lie elsewhere. What is read of a map of normals has to
    /// be turned back: x and y of the normal by `-angle`, which are x, y and z of `angles` for the three.
    hex_tile_places in textures,
    source "Mikkelsen 2022, Practical Real-Time Hex-Tiling, JCGT 11 (3); MaterialX 1.39, hextiledimage; Burley 2019, On Histogram-Preserving Blending for Randomized Texture Tiling",
    inputs {
        /// First coordinate.
        u: scalar = state(Field::U), in FACTOR;
        /// Second coordinate.
        v: scalar = state(Field::V), in FACTOR;
        /// Pictures per unit; x and y count.
        tiling: vector = [1.0; 3], in FACTOR;
        /// How far a hexagon is turned at most, either way, in radians; 0 for pictures with a grain.
        rotation: scalar = std::f64::consts::PI, in FACTOR, unit "radians";
        /// Least size of a picture.
        size_low: scalar = 1.0, in 1e-6..=1e6;
        /// Largest size of a picture.
        size_high: scalar = 1.0, in 1e-6..=1e6;
        /// How far a picture is moved at most, in pictures.
        offset: scalar = 1.0, in FACTOR;
        /// Another seed gives other patches.
        seed: integer = 0;
    }
    outputs {
        /// Where the first picture is read: u in x, v in y.
        first: vector;
        /// Where the second is read.
        second: vector;
        /// Where the third is read.
        third: vector;
        /// How much there is of each: together 1.
        weights: vector, in UNIT;
        /// By how much each is turned, in radians.
        angles: vector;
    }
    body |e, i| {
        let (x, y) = (i.u * i.tiling.x, i.v * i.tiling.y);
        let lattice = Lattice::<E::Int>::of(e, x, y);
        let mut places = [place(x, y); 3];
        let mut angles = [e.real(0.0); 3];
        for k in 0..3 {
            let [column, row] = lattice.corners[k];
            let (a, b) = (numbered_share([column, row, i.seed], 0), numbered_share([column, row, i.seed], 1));
            let angle = i.rotation * (a * 2.0 - 1.0);
            let size = b.mul_add(i.size_high - i.size_low, i.size_low);
            let middle = lattice.middle(k);
            let (across, up) = ((x - middle[0]) / size, (y - middle[1]) / size);
            let (sine, cosine) = (angle.sin(), angle.cos());
            let turned = [across * cosine - up * sine, across * sine + up * cosine];
            places[k] = place(
                turned[0] + middle[0] + i.offset * a,
                turned[1] + middle[1] + i.offset * b,
            );
            angles[k] = angle;
        }
        let [first, second, third] = places;
        let [x, y, z] = lattice.weights;
        let weights = Vector { x, y, z };
        let angles = Vector { x: angles[0], y: angles[1], z: angles[2] };
        Outputs { first, second, third, weights, angles }
    }
}

/// Lattice corners to a unit.
const CORNERS: f64 = 2.0 * SQRT_3;
const SQRT_3: f64 = 1.732_050_807_568_877_2;

/// A triangle of the lattice with a place in it.
struct Lattice<I: Int> {
    /// Its corners, by skewed column and row.
    corners: [[I; 2]; 3],
    /// How near each is.
    weights: [I::Real; 3],
}

impl<I: Int> Lattice<I> {
    #[inline(always)]
    fn of<E: Emit<Int = I, Real = I::Real, Mask = I::Mask>>(e: E, x: I::Real, y: I::Real) -> Self {
        let (column, right) = cell_of((x - y / SQRT_3) * CORNERS);
        let (row, up) = cell_of(y * (2.0 / SQRT_3 * CORNERS));
        let (zero, one) = (e.real(0.0), e.real(1.0));
        // Two triangles make a cell: this one has the corner at the origin, or the one across from it.
        let rest = one - right - up;
        let far = rest.less_equal(zero);
        let near = |far_step: i32, near_step: i32| far.select(e.int(far_step), e.int(near_step));
        let corners = [
            [column + near(1, 0), row + near(1, 0)],
            [column + near(1, 0), row + near(0, 1)],
            [column + near(0, 1), row + near(1, 0)],
        ];
        let weights =
            [far.select(-rest, rest), far.select(one - up, up), far.select(one - right, right)];
        Self { corners, weights: weights.map(Real::saturate) }
    }

    /// Where a corner lies.
    #[inline(always)]
    fn middle(&self, corner: usize) -> [I::Real; 2] {
        let [column, row] = self.corners[corner];
        let (column, row) = (column.to_real(), row.to_real());
        [(column + row * 0.5) / CORNERS, row * (SQRT_3 / 2.0 / CORNERS)]
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn unchanged_pictures_are_all_read_at_the_place_itself() {
        for (u, v) in [(0.1, 0.2), (-3.7, 12.45), (0.0, 0.0)] {
            let read = [
                numbers!(u = u, v = v, tiling = [2.0, 3.0, 0.0], rotation = 0.0, offset = 0.0 => first),
                numbers!(u = u, v = v, tiling = [2.0, 3.0, 0.0], rotation = 0.0, offset = 0.0 => second),
                numbers!(u = u, v = v, tiling = [2.0, 3.0, 0.0], rotation = 0.0, offset = 0.0 => third),
            ];
            for place in read {
                assert_close(&place, &[f64::from(u) * 2.0, f64::from(v) * 3.0, 0.0], 1e-6, 1e-6);
            }
        }
    }

    #[test]
    fn weights_are_together_one_and_all_at_the_middle_of_a_hexagon() {
        for (u, v) in [(0.1, 0.2), (0.33, 0.71), (-3.7, 12.45), (1e3, -1e3)] {
            let weights = numbers!(u = u, v = v => weights);
            assert!(
                (weights.iter().sum::<f32>() - 1.0).abs() < 2e-3
                    && weights.iter().all(|w| *w >= 0.0)
            );
        }
        assert_eq!(numbers!(u = 0.0, v = 0.0 => weights), [1.0, 0.0, 0.0]);
        // The middle of the triangle that has the corner at the origin: a third of the way to (0.5, 0.5) in the cell.
        let skewed = 1.0 / 3.0;
        let (u, v) = (skewed * 1.5 / super::CORNERS, skewed * super::SQRT_3 / 2.0 / super::CORNERS);
        let weights = numbers!(u = u as f32, v = v as f32 => weights);
        assert_close(&weights, &[1.0 / 3.0; 3], 1e-5, 1e-5);
    }

    /// Over an edge of the lattice, what has weight is read from the same places.
    #[test]
    fn hexagons_pass_into_one_another() {
        let blend = |u: f32, v: f32| {
            let weights = numbers!(u = u, v = v, size_low = 0.5, size_high = 2.0 => weights);
            let places = [
                numbers!(u = u, v = v, size_low = 0.5, size_high = 2.0 => first),
                numbers!(u = u, v = v, size_low = 0.5, size_high = 2.0 => second),
                numbers!(u = u, v = v, size_low = 0.5, size_high = 2.0 => third),
            ];
            [0, 1].map(|axis| (0..3).map(|k| weights[k] * places[k][axis]).sum::<f32>())
        };
        for k in 0..400 {
            let (u, v) = (k as f32 * 0.0137, k as f32 * -0.0071);
            assert_close(&blend(u + 1e-5, v), &blend(u, v).map(f64::from), 1e-3, 1e-3);
        }
    }

    #[test]
    fn another_seed_gives_other_patches() {
        let first = |seed: i32| numbers!(u = 0.3, v = 0.6, seed = seed => first);
        assert_ne!(first(0), first(1));
        let angles = numbers!(u = 0.3, v = 0.6, rotation = 0.5 => angles);
        assert!(angles.iter().all(|angle| angle.abs() <= 0.5) && angles[0] != angles[1]);
    }
}
