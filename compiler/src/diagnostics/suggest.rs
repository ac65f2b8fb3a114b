//! The nearest name to a misspelt one.

use std::cell::Cell;

use strsim::osa_distance;

use super::listed_or;
use super::synonyms;

/// Longer names are not compared: the distance costs the product of the lengths.
const MAX_LENGTH: usize = 64;

/// A name that was probably meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Suggestion<'a> {
    /// The name.
    pub name: &'a str,
    /// Another that is as near.
    pub rival: Option<&'a str>,
    /// Whether it may be put in without asking: nothing else can be meant. It is at most two edits
    /// away, no other name is nearly as near, and what stands there is no word of its own.
    pub sure: bool,
    /// Edits between the two, upper and lower case being the same.
    pub distance: usize,
}

impl Suggestion<'_> {
    /// The help that asks for it.
    pub fn help(&self) -> String {
        format!("did you mean {}?", listed_or(std::iter::once(self.name).chain(self.rival)))
    }

    /// Its JSON text, where it may be put in without asking.
    pub fn fix(&self) -> Option<String> {
        self.sure.then(|| serde_json::Value::from(self.name).to_string())
    }
}

/// Suggestions for the misspelt names of a file, bounded: comparing every wrong name with every right
/// one takes time in the square of the file.
#[derive(Clone, Debug)]
pub struct Suggestions {
    comparisons_left: Cell<usize>,
}

impl Default for Suggestions {
    fn default() -> Self {
        Self { comparisons_left: Cell::new(1_000_000) }
    }
}

impl Suggestions {
    /// The nearest of `names`, none where the file used its share of comparisons up.
    pub fn nearest<'a>(
        &self,
        wrong: &str,
        names: impl ExactSizeIterator<Item = &'a str>,
    ) -> Option<Suggestion<'a>> {
        let left = self.comparisons_left.get().checked_sub(names.len())?;
        self.comparisons_left.set(left);
        nearest(wrong, names)
    }
}

/// Whether a name may be another one, misspelt.
pub(crate) fn is_near(wrong: &str, name: &str) -> bool {
    nearest(wrong, [name]).is_some()
}

/// The one of `names` nearest to `wrong`, if near enough to be meant: at most a third of the
/// characters differ, swapped neighbours count once, upper and lower case are the same.
pub fn nearest<'a>(
    wrong: &str,
    names: impl IntoIterator<Item = &'a str>,
) -> Option<Suggestion<'a>> {
    let letters = |name: &str| -> (String, usize) {
        let letters: String =
            name.chars().take(MAX_LENGTH + 1).flat_map(char::to_lowercase).collect();
        let count = letters.chars().count();
        (letters, count)
    };
    let (given, length) = letters(wrong);
    if length == 0 || length > MAX_LENGTH {
        return None;
    }
    let mut best: Option<Suggestion<'a>> = None;
    // The distance of the second best.
    let mut second = usize::MAX;
    for name in names {
        let (candidate, count) = letters(name);
        let longest = count.max(length);
        let allowed = (longest / 3).max(1);
        let bound = best.map_or(allowed, |best| allowed.min(best.distance + 1));
        if count.abs_diff(length) > bound {
            continue;
        }
        let distance = osa_distance(&given, &candidate);
        if distance > bound || distance == longest {
            continue;
        }
        match &mut best {
            Some(best) if best.name == name => {}
            Some(best) if best.distance == distance => {
                best.rival.get_or_insert(name);
                second = distance;
            }
            Some(best) if best.distance < distance => second = second.min(distance),
            _ => {
                second = best.map_or(second, |best| best.distance);
                best = Some(Suggestion { name, rival: None, sure: false, distance });
            }
        }
    }
    let best = best?;
    let alone = best.distance == 0 || second > (best.distance + 1).min(2);
    let sure = best.rival.is_none() && alone && is_misspelling(wrong, best.name, best.distance);
    Some(Suggestion { sure, ..best })
}

/// Whether a word that is so many edits from another can be nothing but that one, misspelt.
fn is_misspelling(wrong: &str, name: &str, distance: usize) -> bool {
    if distance == 0 {
        return true;
    }
    let digits = |text: &str| text.chars().filter(char::is_ascii_digit).collect::<String>();
    let sorted = |text: &str| {
        let mut letters: Vec<char> = text.to_lowercase().chars().collect();
        letters.sort_unstable();
        letters
    };
    let lengths = (wrong.chars().count(), name.chars().count());
    // Of three letters, or four where one is another, many words are made.
    let is_short = lengths.0.max(lengths.1) <= 3 || lengths == (4, 4);
    distance <= 2
        && (!is_short || sorted(wrong) == sorted(name))
        && !is_derived(&wrong.to_lowercase(), &name.to_lowercase())
        // Another number is another thing.
        && digits(wrong) == digits(name)
        && !synonyms::is_word(wrong)
}

/// Whether a word may be made of the other on purpose: with something put before or behind it, as
/// `unscale` is of `scale` and `lengthsq` of `length`, or with another abbreviation among its parts,
/// as `hsl_to_rgb` has. A letter that only doubles its neighbour is put there by no one.
fn is_derived(wrong: &str, name: &str) -> bool {
    let doubles = |extra: &str, neighbour: Option<char>| {
        let mut letters = extra.chars();
        letters.next() == neighbour && letters.next().is_none()
    };
    let added = match (wrong.strip_prefix(name), wrong.strip_suffix(name)) {
        (Some(behind), _) => !doubles(behind, name.chars().next_back()),
        (_, Some(before)) => !doubles(before, name.chars().next()),
        _ => false,
    };
    let is_abbreviation = |part: &str| part.chars().count() <= 3;
    let anagrams = |a: &str, b: &str| {
        let letters = |part: &str| {
            let mut letters: Vec<char> = part.chars().collect();
            letters.sort_unstable();
            letters
        };
        letters(a) == letters(b)
    };
    let parts = |word: &'_ str| word.split('_').count();
    let another_part = parts(wrong) > 1
        && parts(wrong) == parts(name)
        && wrong
            .split('_')
            .zip(name.split('_'))
            .any(|(a, b)| a != b && is_abbreviation(a) && is_abbreviation(b) && !anagrams(a, b));
    added || another_part
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_count_single_edits_and_swapped_neighbours() {
        let distance = |wrong, name| nearest(wrong, [name]).map(|near| near.distance);
        assert_eq!(distance("weight", "wieght"), Some(1));
        assert_eq!(distance("kittens", "sitten"), Some(2));
        assert_eq!(distance("mix", "mix"), Some(0));
        assert_eq!(distance("mix", "MIX"), Some(0));
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
    fn only_what_can_be_nothing_else_is_sure() {
        let sure = |wrong: &str, names: &[&str]| {
            nearest(wrong, names.iter().copied()).map(|near| near.sure)
        };
        for (wrong, names) in [
            ("tnit", &["tint", "ior"][..]),
            ("mxi", &["mix", "sum", "add"]),
            ("wieght", &["weight", "a", "b"]),
            ("Weight", &["weight"]),
            ("lambrt", &["lambert", "less"]),
            ("kye", &["key", "fill"]),
        ] {
            assert_eq!(sure(wrong, names), Some(true), "{wrong}");
        }
        for (wrong, names) in [
            ("tint3", &["tint1", "tint2"][..]),
            ("layer2", &["layer1"]),
            ("max", &["mix"]),
            ("sub", &["sum"]),
            ("lens", &["less"]),
            ("fresnl_reflctn", &["fresnel_reflection"]),
            ("scalar", &["scale"]),
            ("normal", &["normals"]),
            ("tints", &["tint", "tilts"]),
        ] {
            assert_eq!(sure(wrong, names), Some(false), "{wrong}");
        }
    }

    #[test]
    fn two_that_are_as_near_are_both_named() {
        let near = nearest("tint3", ["tint1", "tint2", "other"]).unwrap();
        assert_eq!((near.name, near.rival), ("tint1", Some("tint2")));
        assert_eq!(near.help(), "did you mean `tint1` or `tint2`?");
    }

    #[test]
    fn words_made_of_others_on_purpose_are_no_misspellings() {
        for (wrong, name) in [
            ("madd", "add"),
            ("addc", "add"),
            ("unscale", "scale"),
            ("rescale", "scale"),
            ("deselect", "select"),
            ("lengthsq", "length"),
            ("rlength", "length"),
            ("ifloor", "floor"),
            ("floori", "floor"),
            ("unmultiply", "multiply"),
            ("hsl_to_rgb", "hsv_to_rgb"),
        ] {
            let found = nearest(wrong, [name]);
            assert!(found.is_none_or(|near| near.fix().is_none()), "{wrong} is made {name}");
        }
        for (wrong, name) in [
            ("mutliply", "multiply"),
            ("lenght", "length"),
            ("floorr", "floor"),
            ("sselect", "select"),
            ("hvs_to_rgb", "hsv_to_rgb"),
            ("trace_relfection", "trace_reflection"),
        ] {
            assert!(nearest(wrong, [name]).is_some_and(|near| near.fix().is_some()), "{wrong}");
        }
    }
}
