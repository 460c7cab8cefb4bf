//! What a word means in the block of a G or M code: Q of G83 is a peck, Q of G76 a shift.

use chordal::control::table::CodeRow;

use crate::meaning::ControlView;

/// The meaning of a letter in the block of a code; `None` where the word is accepted without effect on the path, or where
/// no meaning is on record, as for codes that are not simulated.
pub fn word_meaning(row: &CodeRow, letter: u8, view: &ControlView) -> Option<String> {
    row.action.word_meaning(letter, view.table, &view.parameters)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::meaning::codes;

    /// What a letter means with a G code (ten times its number) on a control.
    fn meaning_of(control: &str, code: u16, letter: u8) -> Option<String> {
        let view = ControlView::all().into_iter().find(|view| view.table.name == control).unwrap();
        let row = codes(view.table, b'G').iter().find(|row| row.code == code).unwrap();
        word_meaning(row, letter, &view)
    }

    #[test]
    fn the_meaning_of_a_letter_depends_on_its_code() {
        let text = |control, code, letter| meaning_of(control, code, letter).unwrap();
        assert_eq!(text("haas", 830, b'Q'), "depth of each peck");
        assert!(text("haas", 830, b'I').contains("first peck"));
        assert!(text("fanuc", 760, b'Q').contains("away from the wall"));
        assert!(text("fadal", 840, b'Q').contains("lead"));
        assert!(text("fanuc", 830, b'K').contains("number of holes"));
        assert!(text("linuxcnc", 870, b'K').contains("top of the bore"));
        assert!(text("linuxcnc", 820, b'P').contains("P1 is 1 s"));
        assert_eq!(meaning_of("fanuc", 830, b'L'), None);
        assert_eq!(meaning_of("haas", 760, b'E'), None);
    }
}
