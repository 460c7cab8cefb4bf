//! Words of letters in any case, searched in texts of any length.

/// The bytes that are most frequent in lines that move, the most frequent first.
const FREQUENT_BYTES: &[u8] = b"0123456789XYZLFMAR";

/// How rare a byte is: larger for a rarer one.
fn rarity(byte: u8) -> usize {
    let place = FREQUENT_BYTES.iter().position(|own| *own == byte.to_ascii_uppercase());
    place.unwrap_or(FREQUENT_BYTES.len())
}

/// The places at which a word of letters begins in a text, in any case.
pub fn positions_ignoring_case<'t>(
    text: &'t [u8],
    word: &'t [u8],
) -> impl Iterator<Item = usize> + 't {
    // The search is for the letter that stands in the fewest lines.
    let rarest = (0..word.len()).max_by_key(|index| (rarity(word[*index]), word.len() - index));
    let letter = rarest.map_or(0, |index| word[index]);
    let places =
        memchr::memchr2_iter(letter.to_ascii_uppercase(), letter.to_ascii_lowercase(), text);
    places.filter_map(move |place| {
        let start = place.checked_sub(rarest?)?;
        let found = text.get(start..start + word.len())?;
        found.eq_ignore_ascii_case(word).then_some(start)
    })
}

/// Whether a text contains a word of letters in any case.
pub fn contains_ignoring_case(text: &[u8], word: &[u8]) -> bool {
    positions_ignoring_case(text, word).next().is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_found_in_any_case() {
        let text = b"12 L X+1\nlbl 1\nCALL LBL 12 rep 3\nLb";
        let places = |word: &[u8]| positions_ignoring_case(text, word).collect::<Vec<_>>();
        assert_eq!(places(b"LBL"), [9, 20]);
        assert_eq!(places(b"REP"), [27]);
        assert_eq!(places(b"L X"), [3]);
        assert!(!contains_ignoring_case(text, b"LBLX"));
        assert!(!contains_ignoring_case(b"", b"END"));
    }
}
