//! The beginning of a text.

/// The whole lines within the first `most` bytes; the cut line itself when it is the only one.
pub(crate) fn whole_lines(text: &[u8], most: usize) -> &[u8] {
    if text.len() <= most {
        return text;
    }
    let end = text[..most].iter().rposition(|byte| matches!(byte, b'\n' | b'\r'));
    &text[..end.map_or(most, |end| end + 1)]
}
