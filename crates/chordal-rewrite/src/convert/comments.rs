//! Comments as the new control reads them.

use chordal::control::Control;
use chordal::syntax::{Lexicon, ParenthesisComment};

use super::draft::BlockDraft;

/// Puts the comments of a block into the marks of the new control.
pub(crate) fn translate(draft: &mut BlockDraft, from: &Control, to: &Control) {
    let last_word = draft.block.words.last().map_or(0, |word| word.range.end);
    for at in 0..draft.block.comments.len() {
        let range = draft.block.comments[at];
        let written = draft.slice(range);
        let new = comment(&written, &from.table.lexicon, &to.table.lexicon);
        let acts = from.macros.comments_act && acts(&written);
        if acts && !to.macros.comments_act {
            draft.note(
                written.clone(),
                new.clone(),
                "an active comment becomes an ordinary comment",
            );
        }
        if !acts && new != written.trim_end() {
            let [before, after] = forms(&written, &new);
            draft.note(before, after, format!("{} writes comments like this", to.table.title));
        }
        // Where a comment takes the rest of the line, nothing may follow.
        let ends_line = to.table.lexicon.parenthesis == ParenthesisComment::ToEndOfLine;
        if ends_line && (range.start < last_word || !draft.back.is_empty()) {
            draft.set_comment(at, "");
            draft.trailing.push(new);
        } else if new != written {
            draft.set_comment(at, new);
        }
    }
}

/// Messages that LinuxCNC takes out of comments.
fn acts(comment: &str) -> bool {
    let inner = comment.trim_start_matches(['(', ';', ' ']).to_ascii_uppercase();
    ["MSG,", "DEBUG,", "PRINT,", "LOG", "PROBE"].iter().any(|word| inner.starts_with(word))
}

/// How a comment is written and how it is now, without its text.
fn forms(written: &str, new: &str) -> [String; 2] {
    let form = |text: &str| {
        let mark = text.chars().next().unwrap_or('(');
        let inner = text.trim_start_matches(mark);
        let nested = inner.find(['(', '[']).map(|at| &inner[at..=at]).unwrap_or_default();
        let end = if text.trim_end().ends_with(')') { ")" } else { "" };
        format!("{mark}…{nested}{end}")
    };
    let after = if new.is_empty() { String::new() } else { form(new) };
    let [before, after] = [form(written), after];
    if before == after { [written.trim_end().into(), new.into()] } else { [before, after] }
}

/// One comment in the marks of another control.
pub(crate) fn comment(written: &str, from: &Lexicon, to: &Lexicon) -> String {
    let trimmed = written.trim_end();
    let is_closed = trimmed.starts_with('(') && trimmed.ends_with(')') && trimmed.len() > 1;
    let is_nested =
        trimmed.len() > 2 && is_closed && trimmed[1..trimmed.len() - 1].contains(['(', ')']);
    if is_closed && (!is_nested || to.parenthesis == ParenthesisComment::ToEndOfLine) {
        return trimmed.into();
    }
    if from == to {
        return trimmed.into();
    }
    let inner = match trimmed.strip_prefix('(') {
        Some(inner) => inner.strip_suffix(')').unwrap_or(inner),
        None => trimmed.trim_start_matches(['*', ';', '\'']),
    };
    let inner = inner.trim_end_matches('*').trim();
    let inner = inner.replace('(', "[").replace(')', "]");
    if inner.is_empty() { String::new() } else { format!("({inner})") }
}

#[cfg(test)]
mod tests {
    use chordal::control::table;
    use chordal::machine::ControlName;

    #[test]
    fn open_comments_are_closed() {
        let [fadal, haas] = [ControlName::Fadal, ControlName::Haas]
            .map(|name| table(name).expect("a table").lexicon);
        let comment = |text: &str| super::comment(text, &fadal, &haas);
        assert_eq!(comment("(TOOL 3, .5 END MILL"), "(TOOL 3, .5 END MILL)");
        assert_eq!(comment("(CLOSED)"), "(CLOSED)");
        assert_eq!(comment("(A (B) C"), "(A [B] C)");
        assert_eq!(comment("********MAIN PROGRAM *********"), "(MAIN PROGRAM)");
        assert_eq!(comment("********"), "");
    }
}
