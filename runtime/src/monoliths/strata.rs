//! Samples spread evenly.

/// The unit square cut into as many equal cells as there are samples, each of which falls into its own.
#[derive(Clone, Copy, Debug)]
pub struct Strata {
    count: usize,
    rows: usize,
}

/// The largest number below 1.
const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

impl Strata {
    /// For a number of samples.
    pub fn of(count: usize) -> Self {
        let rows = (1..=32).rev().find(|rows| rows * rows <= count && count.is_multiple_of(*rows));
        Self { count, rows: rows.unwrap_or(1) }
    }

    /// Two numbers drawn, from 0 to below 1, put into the cell of a sample.
    #[inline]
    pub fn spread(self, sample: usize, [u, v]: [f32; 2]) -> [f32; 2] {
        let within = |cell: usize, number: f32, cells: usize| {
            // Rounding may reach the end, which belongs to the next cell.
            ((cell as f32 + number) / cells as f32).min(BELOW_ONE)
        };
        [within(sample % self.count, u, self.count), within(sample % self.rows, v, self.rows)]
    }
}
