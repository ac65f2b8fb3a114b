use crate::emit::functions::cells::{Scattered, cell_share, numbered_share, scattered};
use crate::emit::{Color, Emit, Vector};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Distances from points scattered at random, one in each cell of the lattice of whole numbers: `f1`
    /// from the nearest, `f2` and `f3` from the next. `f2 - f1` is 0 on the edges between regions. What
    /// belongs to a region is the same throughout: its point, its number, its colour, those that
    /// `cell_noise` has at the point. MaterialX's `worleynoise2d` and `worleynoise3d` of style 0 are the distances,
    /// of style 1 number and colour; Blender calls it Voronoi.
    ///
    /// Looked at are the cell of the position and those beside it, as in MaterialX. So a distance can be too
    /// long where the nearest point is more than a cell away, which a jitter of 1 makes rare for `f1`,
    /// and for `f3` not so rare.
    worley_noise in noise,
    source "Worley 1996, A Cellular Texture Basis Function; Jenkins 2006, lookup3",
    inputs {
        /// Where to look; the first `dimensions` coordinates count.
        position: vector = state(Field::Point), in FACTOR;
        /// How many coordinates count: 2 for uv; the fourth is `w`.
        dimensions: count = 3, in 1.0..=4.0;
        /// The fourth coordinate, often the time.
        w: scalar = 0.0, in FACTOR, when e.mask(i.dimensions == 4);
        /// How far points stray from the middle of their cells: 0 not at all, 1 over the whole cell.
        jitter: scalar = 1.0, in -4.0..=4.0, soft UNIT;
        /// What a distance is: along the straight line, the sum of the steps along the axes, or the longest
        /// of these.
        metric: choice = 0, of ["euclidean", "manhattan", "chebyshev"];
    }
    outputs {
        /// Distance from the nearest point.
        f1: scalar, in 0.0..=12.0;
        /// Distance from the second.
        f2: scalar, in 0.0..=12.0;
        /// Distance from the third.
        f3: scalar, in 0.0..=20.0;
        /// Where the nearest point is.
        point: vector;
        /// A random number of the nearest point, 0 to 1.
        id: scalar, in 0.0..=1.0;
        /// A random colour of the nearest point.
        color: color, in 0.0..=1.0;
    }
    body |e, i| {
        let Vector { x, y, z } = i.position;
        let zero = e.real(0.0);
        match i.dimensions {
            1 => {
                let found = scattered(e, [x], i.jitter, i.metric);
                let point = Vector { x: found.point[0], y: zero, z: zero };
                outputs(e, found, point)
            }
            2 => {
                let found = scattered(e, [x, y], i.jitter, i.metric);
                let point = Vector { x: found.point[0], y: found.point[1], z: zero };
                outputs(e, found, point)
            }
            3 => {
                let found = scattered(e, [x, y, z], i.jitter, i.metric);
                let [x, y, z] = found.point;
                outputs(e, found, Vector { x, y, z })
            }
            _ => {
                let found = scattered(e, [x, y, z, i.w], i.jitter, i.metric);
                let [x, y, z, _] = found.point;
                outputs(e, found, Vector { x, y, z })
            }
        }
    }
}

/// What is known of the nearest point.
#[inline(always)]
fn outputs<E: Emit, const D: usize>(
    e: E,
    found: Scattered<E::Int, D>,
    point: Vector<E::Real>,
) -> Outputs<E> {
    let Scattered { distances: [f1, f2, f3], cell, .. } = found;
    let color = Color {
        r: numbered_share(cell, 0),
        g: numbered_share(cell, 1),
        b: numbered_share(cell, 2),
        a: e.real(1.0),
    };
    Outputs { f1, f2, f3, point, id: cell_share(cell), color }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn without_jitter_points_stand_in_the_middle_of_cells() {
        for (metric, distances) in [
            (0, [0.09_f64, 0.04, 0.49, 0.04, 0.09, 0.64]),
            (1, [0.3, 0.2, 0.7, 0.2, 0.3, 0.8]),
            (2, [0.3, 0.2, 0.7, 0.2, 0.3, 0.8]),
        ] {
            let [ax, ay, bx, by, cx, cy] = distances;
            let length = |x: f64, y: f64| match metric {
                0 => (x + y).sqrt(),
                1 => x + y,
                _ => x.max(y),
            };
            let given = |output: &str| {
                let position = [7.2, -1.3, 0.0];
                match output {
                    "f1" => {
                        number!(position = position, dimensions = 2, jitter = 0.0, metric = metric => f1)
                    }
                    "f2" => {
                        number!(position = position, dimensions = 2, jitter = 0.0, metric = metric => f2)
                    }
                    _ => {
                        number!(position = position, dimensions = 2, jitter = 0.0, metric = metric => f3)
                    }
                }
            };
            let found = [given("f1"), given("f2"), given("f3")];
            let expected = [length(ax, ay), length(bx, by), length(cx, cy)];
            assert_close(&found, &expected, 1e-6, 1e-6);
        }
    }

    #[test]
    fn a_region_has_one_point_and_number_however_far() {
        for far in [0.0_f32, -3.0, 1e6, -1e6, 1e9] {
            let of = |x: f32, y: f32| {
                let position = [far + x, far - y, 0.5];
                let point = numbers!(position = position => point);
                (point.clone(), number!(position = position => id), point)
            };
            let mut by_point = std::collections::HashMap::new();
            for step in 0..400 {
                let (point, id, _) = of((step % 20) as f32 * 0.13, (step / 20) as f32 * 0.17);
                let key: Vec<u32> = point.iter().map(|x| x.to_bits()).collect();
                let known = by_point.entry(key).or_insert(id);
                assert!(far.abs() > 1e5 || *known == id, "{point:?}");
            }
            assert!(by_point.len() > 3 || far.abs() > 1e5, "{far}");
        }
    }

    #[test]
    fn the_point_is_as_far_as_said_and_has_the_number_of_its_cell() {
        for dimensions in 1..=3 {
            let position = [0.37, -2.61, 4.05];
            let f1 = number!(position = position, dimensions = dimensions => f1);
            let point = numbers!(position = position, dimensions = dimensions => point);
            let apart = (0..dimensions as usize)
                .map(|axis| f64::from(point[axis] - position[axis]).powi(2))
                .sum::<f64>()
                .sqrt();
            assert_close(&[f1], &[apart], 1e-6, 1e-6);
            let f2 = number!(position = position, dimensions = dimensions => f2);
            let f3 = number!(position = position, dimensions = dimensions => f3);
            assert!(f1 <= f2 && f2 <= f3);
        }
    }
}
