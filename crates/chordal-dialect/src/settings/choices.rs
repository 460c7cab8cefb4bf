//! Values of settings that a machine file writes as words.

/// Words and their values; of several words of one value the first is the one that is written back.
pub(crate) type Choices<T> = &'static [(&'static str, T)];

/// The words of a switch.
pub(crate) const SWITCH: Choices<bool> =
    &[("on", true), ("off", false), ("1", true), ("0", false), ("true", true), ("false", false)];

/// The value of a word, regardless of case; the error lists the words.
pub(crate) fn choose<T: Copy>(word: &str, choices: &[(&str, T)]) -> Result<T, String> {
    let choice = choices.iter().find(|(name, _)| name.eq_ignore_ascii_case(word));
    choice.map(|(_, value)| *value).ok_or_else(|| {
        let names: Vec<String> = choices.iter().map(|(name, _)| format!("`{name}`")).collect();
        names.join(" or ")
    })
}

/// The first word of a value; `?` if it has none.
pub(crate) fn name_of<T: Copy + PartialEq>(value: T, choices: &[(&str, T)]) -> String {
    choices.iter().find(|(_, v)| *v == value).map_or("?", |(name, _)| name).to_string()
}

/// A length as a machine file writes it.
pub(crate) fn mm_text(value: f64) -> String {
    // 399.9999 in is 10159.99746 mm, not what the last bit makes of it.
    let rounded = (value * 1e9).round() / 1e9;
    if value.is_finite() { format!("{rounded} mm") } else { "no limit".to_string() }
}
