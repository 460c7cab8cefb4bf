//! Finds the name that a misspelt one may stand for.

/// Names shorter than this resemble too many others.
const MIN_LENGTH: usize = 4;

/// From this length on two mistakes are one name.
const LENGTH_OF_TWO_MISTAKES: usize = 8;

/// The name that differs from a word by a typing error: a letter lost, added, changed or swapped with its neighbour, and
/// two of these in long names. `None` if there is none. All names are in upper case.
pub fn nearest_name<'c>(
    word: &str,
    candidates: impl IntoIterator<Item = &'c str>,
) -> Option<&'c str> {
    let length = word.len();
    if length < MIN_LENGTH {
        return None;
    }
    let most = if length >= LENGTH_OF_TWO_MISTAKES { 2 } else { 1 };
    let distance = |other: &&str| strsim::damerau_levenshtein(word, other);
    let near = candidates.into_iter().filter(|other| {
        // Names that differ in their number only are a family (`DRILL_1`, `DRILL_2`) and no typing error.
        other.len().abs_diff(length) <= most && without_digits(other) != without_digits(word)
    });
    near.map(|other| (distance(&other), other))
        .filter(|(distance, _)| (1..=most).contains(distance))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, other)| other)
}

fn without_digits(name: &str) -> String {
    name.chars().filter(|letter| !letter.is_ascii_digit()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn typing_errors_are_found() {
        let names = ["DEPTH", "FEED_ROUGH", "TRANS", "LAB1"];
        assert_eq!(nearest_name("DPETH", names), Some("DEPTH"));
        assert_eq!(nearest_name("TRANSS", names), Some("TRANS"));
        assert_eq!(nearest_name("FED_RUOGH", names), Some("FEED_ROUGH"));
        assert_eq!(nearest_name("LAB2", names), None);
        assert_eq!(nearest_name("WIDTH", names), None);
        assert_eq!(nearest_name("FED", ["FEED"]), None);
    }
}
