//! Fills the frame of a program, which is the control's.

/// Puts the fillings into a line.
pub(crate) fn fill(line: &str, fillings: &[(&str, String)]) -> String {
    let mut text = line.to_string();
    for (name, value) in fillings {
        text = text.replace(&format!("{{{name}}}"), value);
    }
    text
}
