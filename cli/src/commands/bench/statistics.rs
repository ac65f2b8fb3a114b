//! Figures of repeated measurements.

/// The value in the middle; of an even number of them the mean of the two in the middle.
pub fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    quantile(&sorted(values), 0.5)
}

/// How far the values lie apart: the distance between their quartiles over their median, 0 for a single
/// value. Half of all measurements lie within it, and one slow minute of the machine does not move it.
pub fn spread(values: impl IntoIterator<Item = f64>) -> f64 {
    let sorted = sorted(values);
    (quantile(&sorted, 0.75) - quantile(&sorted, 0.25)) / quantile(&sorted, 0.5)
}

fn sorted(values: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    values
}

/// The value at a share of the way, between two of them where it falls there.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let at = share * (sorted.len() - 1) as f64;
    let (below, above) = (sorted[at.floor() as usize], sorted[at.ceil() as usize]);
    below + (above - below) * at.fract()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_lie_in_the_middle() {
        assert_eq!(median([3.0, 1.0, 9.0]), 3.0);
        assert_eq!(median([4.0, 1.0, 2.0, 9.0]), 3.0);
    }

    #[test]
    fn the_spread_is_that_of_the_middle_half() {
        assert_eq!(spread([7.0]), 0.0);
        assert_eq!(spread([5.0, 5.0, 5.0]), 0.0);
        assert_eq!(spread([8.0, 12.0, 10.0, 9.0, 1000.0]), 0.3);
    }
}
