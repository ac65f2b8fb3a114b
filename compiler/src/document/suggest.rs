//! The nearest name to a misspelt one.

/// Longer names are not compared: the distance costs the product of the lengths.
const MAX_LENGTH: usize = 64;

/// The one of `names` nearest to `wrong`, if near enough to be meant: at most a third of the
/// characters differ, swapped neighbours count once, upper and lower case are the same.
pub fn nearest<'a>(wrong: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wrong: Vec<char> =
        wrong.chars().take(MAX_LENGTH + 1).flat_map(char::to_lowercase).collect();
    if wrong.is_empty() || wrong.len() > MAX_LENGTH {
        return None;
    }
    let mut best: Option<(usize, &str)> = None;
    for name in names {
        let letters: Vec<char> =
            name.chars().take(MAX_LENGTH).flat_map(char::to_lowercase).collect();
        let longest = letters.len().max(wrong.len());
        let allowed = (longest / 3).max(1);
        let bound = best.map_or(allowed, |(distance, _)| allowed.min(distance.saturating_sub(1)));
        if letters.len().abs_diff(wrong.len()) <= bound {
            let distance = edit_distance(&wrong, &letters);
            if distance <= bound && distance < longest {
                best = Some((distance, name));
                if distance == 0 {
                    break;
                }
            }
        }
    }
    best.map(|(_, name)| name)
}

/// Optimal string alignment: insertions, deletions, replacements and swaps of neighbours.
fn edit_distance(a: &[char], b: &[char]) -> usize {
    let mut before = vec![0; b.len() + 1];
    let mut above: Vec<usize> = (0..=b.len()).collect();
    let mut here = vec![0; b.len() + 1];
    for (i, &x) in a.iter().enumerate() {
        here[0] = i + 1;
        for (j, &y) in b.iter().enumerate() {
            let replaced = above[j] + usize::from(x != y);
            let mut least = replaced.min(above[j + 1] + 1).min(here[j] + 1);
            if i > 0 && j > 0 && x == b[j - 1] && a[i - 1] == y {
                least = least.min(before[j - 1] + 1);
            }
            here[j + 1] = least;
        }
        std::mem::swap(&mut before, &mut above);
        std::mem::swap(&mut above, &mut here);
    }
    above[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_count_single_edits() {
        let distance = |a: &str, b: &str| {
            edit_distance(&a.chars().collect::<Vec<_>>(), &b.chars().collect::<Vec<_>>())
        };
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("abc", ""), 3);
        assert_eq!(distance("weight", "wieght"), 1);
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("mix", "mix"), 0);
    }

    #[test]
    fn the_nearest_name_is_near_enough_to_be_meant() {
        let names = ["weight", "a", "b", "perturb_normal", "color"];
        assert_eq!(nearest("wieght", names), Some("weight"));
        assert_eq!(nearest("Weight", names), Some("weight"));
        assert_eq!(nearest("colour", names), Some("color"));
        assert_eq!(nearest("pertrub_normal", names), Some("perturb_normal"));
        assert_eq!(nearest("refraction", names), None);
        assert_eq!(nearest("c", names), None, "nothing of a one letter name is kept");
        assert_eq!(nearest("", names), None);
        assert_eq!(nearest(&"weight".repeat(100), names), None);
    }
}
