//! The nearest name to a misspelt one.

/// Longer names are not compared: the distance costs the product of the lengths.
const MAX_LENGTH: usize = 64;

/// A name that was probably meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Suggestion<'a> {
    /// The name.
    pub name: &'a str,
    /// Whether it may be put in without asking: it is at most two edits away, and no other name is
    /// as near.
    pub sure: bool,
}

impl Suggestion<'_> {
    /// The help that asks for it.
    pub fn help(&self) -> String {
        format!("did you mean `{}`?", self.name)
    }

    /// Its JSON text, where it may be put in without asking.
    pub fn fix(&self) -> Option<String> {
        self.sure.then(|| serde_json::Value::from(self.name).to_string())
    }
}

/// The one of `names` nearest to `wrong`, if near enough to be meant: at most a third of the
/// characters differ, swapped neighbours count once, upper and lower case are the same.
pub fn nearest<'a>(
    wrong: &str,
    names: impl IntoIterator<Item = &'a str>,
) -> Option<Suggestion<'a>> {
    let wrong: Vec<char> =
        wrong.chars().take(MAX_LENGTH + 1).flat_map(char::to_lowercase).collect();
    if wrong.is_empty() || wrong.len() > MAX_LENGTH {
        return None;
    }
    let mut best: Option<(usize, Suggestion<'a>)> = None;
    for name in names {
        let letters: Vec<char> =
            name.chars().take(MAX_LENGTH).flat_map(char::to_lowercase).collect();
        let longest = letters.len().max(wrong.len());
        let allowed = (longest / 3).max(1);
        let bound = best.as_ref().map_or(allowed, |(distance, _)| allowed.min(*distance));
        if letters.len().abs_diff(wrong.len()) > bound {
            continue;
        }
        let distance = edit_distance(&wrong, &letters);
        if distance > bound || distance == longest {
            continue;
        }
        match &mut best {
            Some((least, suggestion)) if *least == distance => suggestion.sure = false,
            _ => best = Some((distance, Suggestion { name, sure: distance <= 2 })),
        }
    }
    best.map(|(_, suggestion)| suggestion)
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
        let nearest =
            |wrong: &str, names: [&'static str; 5]| nearest(wrong, names).map(|it| it.name);
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

    #[test]
    fn a_suggestion_with_a_rival_is_not_sure() {
        assert_eq!(
            nearest("tint3", ["tint1", "tint2"]),
            Some(Suggestion { name: "tint1", sure: false })
        );
        assert_eq!(nearest("tnit", ["tint", "ior"]), Some(Suggestion { name: "tint", sure: true }));
        assert_eq!(
            nearest("fresnl_reflctn", ["fresnel_reflection"]).map(|it| it.sure),
            Some(false)
        );
    }
}
