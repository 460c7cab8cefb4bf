//! The head of the problems of a program: for which control it is read, why, and what else fits.

use chordal_load::Loaded;

use crate::programs::recognized;

/// So many other controls are named.
const NAMED_CONTROLS: usize = 3;

/// Which control was assumed and why, and the others that move the program alike; empty where the user said the
/// machine. What moves it otherwise is a problem of its own, with the sizes of the part and what to type.
pub fn head(loaded: &Loaded) -> String {
    let mut text = recognized(loaded);
    let Some(premise) = loaded.premise.as_ref().filter(|_| !text.is_empty()) else { return text };
    let Some(own) = premise.groups.first() else { return text };
    let others = own.other_titles();
    if others.is_empty() || premise.groups.len() > 1 {
        return text;
    }
    let named = others.iter().take(NAMED_CONTROLS).copied().collect::<Vec<_>>().join(", ");
    let more = others.len().saturating_sub(NAMED_CONTROLS);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    text += &format!("  the same path on {named}{more}\n");
    text
}
