//! Finds suggestions for misspelt words.

/// The smallest similarity of two words for a suggestion, 0 to 1.
const MIN_SIMILARITY: f64 = 0.75;

/// The candidate most similar to a word, or the first of several; `None` if none is similar enough.
pub(crate) fn nearest<'c>(
    word: &str,
    candidates: impl IntoIterator<Item = &'c str>,
) -> Option<&'c str> {
    let word = word.to_lowercase();
    let mut best: Option<(f64, &str)> = None;
    for candidate in candidates {
        let other = candidate.to_lowercase();
        let mut alike = strsim::normalized_damerau_levenshtein(&word, &other)
            .max(strsim::jaro_winkler(&word, &other) - 0.1);
        // One mistake in a short word, such as `mx` for `max`; two letters are not enough (`km`, `mm`).
        let (short, long) = (word.len().min(other.len()), word.len().max(other.len()));
        if short >= 2 && long >= 3 && strsim::damerau_levenshtein(&word, &other) == 1 {
            alike = alike.max(MIN_SIMILARITY);
        }
        if alike >= MIN_SIMILARITY && best.is_none_or(|(most, _)| alike > most) {
            best = Some((alike, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// A list as text: `a`, `a or b`, `a, b or c`.
pub(crate) fn or_list<T: AsRef<str>>(items: &[T]) -> String {
    match items {
        [] => String::new(),
        [one] => one.as_ref().to_string(),
        [most @ .., last] => {
            let most: Vec<&str> = most.iter().map(AsRef::as_ref).collect();
            format!("{} or {}", most.join(", "), last.as_ref())
        }
    }
}
