//! Reads the words of PLANE.

use chordal_diagnostics::TextRange;

use super::cursor::TokenCursor;
use super::operands::OperandWord;
use super::planes::{PlaneForm, PlanePositioning, PlaneWords};
use super::tokens::KlartextTokenKind;

/// Reads the words of PLANE after its name.
pub fn plane_words(cursor: &mut TokenCursor<'_>) -> PlaneWords {
    let form = match cursor.peek_word() {
        Some("SPATIAL") => PlaneForm::Spatial,
        Some("EULER") => PlaneForm::Euler,
        Some("PROJECTED") => PlaneForm::Projected,
        Some("AXIAL") => PlaneForm::Axial,
        Some("VECTOR") => PlaneForm::Vector,
        Some("POINTS") => PlaneForm::Points,
        Some("RELATIV") => PlaneForm::Relative,
        Some("RESET") => PlaneForm::Reset,
        _ => PlaneForm::Other,
    };
    let mut words = PlaneWords {
        form,
        angles: [None; 3],
        euler: [None; 3],
        projected: [None; 3],
        axial: [None; 3],
        points: [[None; 3]; 3],
        base: [None; 3],
        normal: [None; 3],
        positioning: None,
        sequence: None,
    };
    cursor.take();
    while let Some(token) = cursor.take() {
        let KlartextTokenKind::Word(word) = &token.kind else { continue };
        match word.as_str() {
            // The feed, the distance of the turning point and what the table does move nothing of the plane.
            "MOVE" => words.positioning = Some(PlanePositioning::Move),
            "TURN" => words.positioning = Some(PlanePositioning::Turn),
            "STAY" => words.positioning = Some(PlanePositioning::Stay),
            "SEQ" | "SYM" => words.sequence = sign(cursor),
            // How the coordinates or the table turn where an axis is free.
            "COORD" | "TABLE" => {
                cursor.take_word("ROT");
            }
            "P" => point_word(cursor, &mut words, token.range),
            name => {
                let (name, is_incremental) = match name.strip_prefix('I') {
                    Some(name) => (name, true),
                    None => (name, false),
                };
                if let Some(place) = named_place(&mut words, name) {
                    *place = cursor.operand_of(token.range, is_incremental);
                }
            }
        }
    }
    words
}

fn sign(cursor: &mut TokenCursor<'_>) -> Option<bool> {
    match cursor.take_sign(b'+') {
        true => Some(true),
        false => cursor.take_sign(b'-').then_some(false),
    }
}

/// The place of a word by its name; `None` for one that is not kept.
fn named_place<'w>(words: &'w mut PlaneWords, name: &str) -> Option<&'w mut Option<OperandWord>> {
    let index = |names: [&str; 3]| names.iter().position(|own| *own == name);
    if let Some(index) = index(["SPA", "SPB", "SPC"]) {
        return Some(&mut words.angles[index]);
    }
    if let Some(index) = index(["EULPR", "EULNU", "EULROT"]) {
        return Some(&mut words.euler[index]);
    }
    if let Some(index) = index(["PROPR", "PROMIN", "ROT"]) {
        return Some(&mut words.projected[index]);
    }
    if words.form == PlaneForm::Axial
        && let Some(index) = index(["A", "B", "C"])
    {
        return Some(&mut words.axial[index]);
    }
    if let Some(index) = index(["BX", "BY", "BZ"]) {
        return Some(&mut words.base[index]);
    }
    index(["NX", "NY", "NZ"]).map(|index| &mut words.normal[index])
}

/// P1X to P3Z: the number of the point and the axis after P.
fn point_word(cursor: &mut TokenCursor<'_>, words: &mut PlaneWords, start: TextRange) {
    let Some(point @ 1..=3) = cursor.take_whole() else { return };
    let axis =
        cursor.peek_word().and_then(|word| ["X", "Y", "Z"].iter().position(|own| *own == word));
    let Some(axis) = axis else { return };
    cursor.take();
    words.points[point as usize - 1][axis] = cursor.operand_of(start, false);
}

#[cfg(test)]
mod tests {
    use super::super::ast::KlartextStatement;
    use super::super::operands::WordOperand;
    use super::super::parser::KlartextReader;
    use super::*;

    fn read(text: &str) -> PlaneWords {
        let block = KlartextReader::new(text.as_bytes()).next().expect("a block");
        assert!(block.faults.is_empty(), "{text}");
        let KlartextStatement::Plane(words) = block.statement else { panic!("{text}") };
        *words
    }

    fn number(word: Option<OperandWord>) -> Option<f64> {
        match word?.value {
            WordOperand::Number(value) => Some(value),
            WordOperand::Parameter { .. } => None,
        }
    }

    #[test]
    fn every_form_has_its_words() {
        let words = read("5 PLANE EULER EULPR+90 EULNU30 EULROT-5 TURN FMAX SEQ-");
        assert_eq!(words.form, PlaneForm::Euler);
        assert_eq!(words.euler.map(number), [Some(90.0), Some(30.0), Some(-5.0)]);
        assert_eq!(words.positioning, Some(PlanePositioning::Turn));
        assert_eq!(words.sequence, Some(false));
        let words = read(
            "PLANE POINTS P1X+0 P1Y+0 P1Z+20 P2X+30 P2Y+31 P2Z+20 P3X+0 P3Y+41 P3Z+32.5 MOVE DIST5 F500",
        );
        let points = words.points.map(|point| point.map(|word| number(word).expect("a number")));
        assert_eq!(points, [[0.0, 0.0, 20.0], [30.0, 31.0, 20.0], [0.0, 41.0, 32.5]]);
        assert_eq!(words.positioning, Some(PlanePositioning::Move));
        let words =
            read("PLANE PROJECTED PROPR+24 PROMIN-10 ROT+30 MOVE DIST50 F1000 SEQ+ TABLE ROT");
        assert_eq!(words.projected.map(number), [Some(24.0), Some(-10.0), Some(30.0)]);
        let words = read("PLANE AXIAL B+45 IC-90 TURN F2000");
        assert_eq!(words.axial.map(number), [None, Some(45.0), Some(-90.0)]);
        assert!(words.axial[2].is_some_and(|word| word.is_incremental));
        let words = read("PLANE RELATIV SPB-12 STAY");
        assert_eq!((words.form, number(words.angles[1])), (PlaneForm::Relative, Some(-12.0)));
    }
}
