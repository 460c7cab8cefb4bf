//! BLK FORM: the blank that a program defines.

use chordal_diagnostics::TextRange;
use chordal_machine::{Body, BodyShape};

use crate::syntax::{KlartextReader, KlartextStatement, PathWords, WordOperand};

const INCH_MM: f64 = 25.4;

/// The block between BLK FORM 0.1 and 0.2 of the first program of a text, and their texts; `None` where one of them is
/// missing, is given by parameters, or is not above the other.
pub fn blank_form(text: &[u8]) -> Option<(Body, TextRange)> {
    let mut unit = 1.0;
    let mut least: Option<([f64; 3], TextRange)> = None;
    for block in KlartextReader::new(text) {
        match &block.statement {
            KlartextStatement::Begin { is_inch: true, .. } => unit = INCH_MM,
            KlartextStatement::Blank { corner: Some(1), words } => {
                least = Some((point(words, [0.0; 3], unit)?, block.range));
            }
            KlartextStatement::Blank { corner: Some(2), words } => {
                let (from, range) = least?;
                let to = point(words, from, unit)?;
                let is_block = from.iter().zip(&to).all(|(from, to)| from < to);
                let body = Body {
                    shape: Some(BodyShape::Box),
                    from: from.map(Some),
                    to: to.map(Some),
                    ..Body::default()
                };
                return is_block.then_some((body, range.cover(block.range)));
            }
            KlartextStatement::End { .. } => return None,
            _ => {}
        }
    }
    None
}

/// A corner, mm; `None` where a coordinate is missing or is a parameter.
fn point(words: &PathWords, from: [f64; 3], unit: f64) -> Option<[f64; 3]> {
    let mut point = [0.0; 3];
    for (axis, value) in point.iter_mut().enumerate() {
        let word = words.axes[axis]?;
        let WordOperand::Number(number) = word.value else { return None };
        *value = number * unit + if word.is_incremental { from[axis] } else { 0.0 };
    }
    Some(point)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners(text: &str) -> Option<[[Option<f64>; 3]; 2]> {
        blank_form(text.as_bytes()).map(|(body, _)| [body.from, body.to])
    }

    #[test]
    fn two_corners_are_a_block() {
        let text =
            "0 BEGIN PGM P MM\n1 BLK FORM 0.1 Z X+0 Y-5 Z-20\n2 BLK FORM 0.2 X+100 IY+60 Z+0\n";
        let expected = [[0.0, -5.0, -20.0], [100.0, 55.0, 0.0]].map(|point| point.map(Some));
        assert_eq!(corners(text), Some(expected));
        let inch = text.replace("MM", "INCH").replace("100", "1").replace("IY+60", "IY+10");
        let expected = [[0.0, -127.0, -508.0], [25.4, 127.0, 0.0]].map(|point| point.map(Some));
        assert_eq!(corners(&inch), Some(expected));
    }

    #[test]
    fn what_is_no_block_is_none() {
        for text in [
            "0 BEGIN PGM P MM\n1 BLK FORM 0.1 Z X+0 Y-5 Z-20\n",
            "0 BEGIN PGM P MM\n1 BLK FORM 0.1 Z X+0 Y-5 Z+Q1\n2 BLK FORM 0.2 X+100 IY+60 Z+0\n",
            "0 BEGIN PGM P MM\n1 BLK FORM 0.1 Z X+0 Y-5 Z+0\n2 BLK FORM 0.2 X+100 IY+60 Z+0\n",
            "0 BEGIN PGM P MM\n1 BLK FORM CYLINDER Z R50 L105\n",
        ] {
            assert_eq!(corners(text), None, "{text}");
        }
    }
}
