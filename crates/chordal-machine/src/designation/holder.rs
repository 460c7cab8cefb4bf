//! Holders: `PCLNR2525M12` (ISO 5608) and boring bars: `S20R-SCLCR09` (ISO 6261).

use super::edge::{circle_of_eighths, circle_of_symbol, edge_of_circle};
use super::letters::InsertLetter;
use super::letters::{HolderStyle, is_clamping, is_clearance, shape_of, style_of};
use super::{DesignationError, DesignationReader};

/// The hand of a holder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToolHand {
    /// R.
    Right,
    /// L.
    Left,
    /// N: cuts on both sides.
    Neutral,
}

/// The kind of a holder, by its shank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HolderKind {
    /// Rectangular, across the spindle.
    Square,
    /// A round bar along the spindle.
    Bar {
        /// The diameter of its shank, mm.
        diameter_mm: f64,
    },
}

/// The data in the designation of a holder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HolderDesignation {
    /// Its shank.
    pub kind: HolderKind,
    /// The shape of the inserts that it takes.
    pub letter: InsertLetter,
    /// The letter of their clearance.
    pub clearance: char,
    /// The letter of its style.
    pub style: char,
    /// Its hand.
    pub hand: ToolHand,
    /// The length of the edges of its inserts, mm; `None` if the designation does not give it.
    pub edge_mm: Option<f64>,
}

/// Entering angles that differ by less are equal, degrees: manufacturers round them, for example 62.5° to 63°.
const ANGLE_TOLERANCE_DEG: f64 = 2.0;

const HEAD_HELP: &str = "the letters are clamping, shape of the insert, style, clearance and hand, as in `PCLNR2525M12`";
const BAR_HELP: &str = "a boring bar has type, diameter and length first, as in `S20R-SCLCR09`";
const SHANK_HELP: &str = "after the letters come height, width, length and insert size: `2525M12`";

impl HolderDesignation {
    /// Reads a designation. The part after the hand may be missing.
    ///
    /// # Errors
    /// If the text is not a designation, with the reason.
    pub fn parse(text: &str) -> Result<HolderDesignation, DesignationError> {
        let mut reader = DesignationReader::new(text);
        reader.skip_gaps();
        let kind = bar(&mut reader)?;
        let (letter, style, clearance, hand) = head(&mut reader)?;
        reader.skip_gaps();
        let edge_mm = match kind {
            HolderKind::Square => shank(&mut reader, letter)?,
            HolderKind::Bar { .. } => size(&mut reader, letter)?,
        };
        if let more @ 1.. = reader.run(|c| c.is_ascii_digit()).len() {
            let message = "it has more digits than it can have".to_string();
            return Err(reader.wrong(more, message, SHANK_HELP));
        }
        Ok(HolderDesignation { kind, letter, clearance, style, hand, edge_mm })
    }

    /// The angle κ between the main edge of the insert and the feed along Z, degrees. `None` if the letter of the style
    /// does not determine it.
    pub fn approach_degrees(&self) -> Option<f64> {
        // Manufacturers use different angles: 107.5° and 117.5°.
        if self.style == 'Q' && self.letter != InsertLetter::D {
            return None;
        }
        let style = self.style_row()?;
        if !style.end_cutting || self.kind != HolderKind::Square {
            return Some(style.entering_degrees);
        }
        // The main edge is at the end: the angle is that of the other edge, if that can cut along Z.
        let corner = self.letter.corner_degrees()?;
        let other = 270.0 - style.entering_degrees - corner;
        (other + corner <= 180.0).then_some(other)
    }

    /// The tip number of Fanuc for the usual mounting: a right-hand holder feeds towards the chuck, a bar is in a bore,
    /// and a neutral holder is perpendicular to the spindle. `None` if more than one mounting is usual.
    pub fn usual_tip(&self) -> Option<u32> {
        let style = self.style_row()?;
        match (self.kind, self.hand) {
            (HolderKind::Bar { .. }, ToolHand::Right | ToolHand::Left) => Some(2),
            (HolderKind::Square, ToolHand::Right) => Some(3),
            (HolderKind::Square, ToolHand::Neutral) if self.is_symmetrical(style) => Some(8),
            (HolderKind::Bar { .. } | HolderKind::Square, _) => None,
        }
    }

    /// Whether both edges of its inserts have the same angle to the shank.
    fn is_symmetrical(&self, style: HolderStyle) -> bool {
        let other =
            self.letter.corner_degrees().map(|corner| 180.0 - corner - style.entering_degrees);
        other.is_some_and(|other| (other - style.entering_degrees).abs() < ANGLE_TOLERANCE_DEG)
    }

    fn style_row(&self) -> Option<HolderStyle> {
        style_of(self.style)
    }
}

/// Reads type, diameter and length of a boring bar, if the text begins with them.
fn bar(reader: &mut DesignationReader<'_>) -> Result<HolderKind, DesignationError> {
    let mut look = reader.clone();
    if look.letter().is_none() || !look.rest().starts_with(|c: char| c.is_ascii_digit()) {
        return Ok(HolderKind::Square);
    }
    let kind = reader.letter().unwrap_or_default();
    if !"SABCDEFGHJ".contains(kind) {
        let message = format!("`{kind}` is no type of a boring bar");
        return Err(reader.wrong(1, message, BAR_HELP));
    }
    let digits = reader.run(|c| c.is_ascii_digit());
    let diameter = digits.parse::<u32>().ok().filter(|_| digits.len() == 2).filter(|mm| *mm > 0);
    let Some(diameter) = diameter else {
        let message = format!("`{digits}` is no diameter of a boring bar");
        return Err(reader.wrong(digits.len(), message, BAR_HELP));
    };
    let length = reader.letter();
    if length.is_none() {
        let at = reader.at;
        let message = "the letter of the bar's length is missing".to_string();
        return Err(DesignationError::new(message, at..at, BAR_HELP));
    }
    reader.skip_gaps();
    Ok(HolderKind::Bar { diameter_mm: f64::from(diameter) })
}

/// Reads clamping, shape, style, clearance and hand.
fn head(
    reader: &mut DesignationReader<'_>,
) -> Result<(InsertLetter, char, char, ToolHand), DesignationError> {
    let mut next = |what: &str, is_good: &dyn Fn(char) -> bool| match reader.letter() {
        Some(letter) if is_good(letter) => Ok(letter),
        Some(letter) => Err(reader.wrong(1, format!("`{letter}` is no {what}"), HEAD_HELP)),
        None => {
            let at = reader.at;
            let message = format!("the letter of its {what} is missing");
            Err(DesignationError::new(message, at..at, HEAD_HELP))
        }
    };
    next("clamping of a holder", &is_clamping)?;
    let shape = next("shape of an insert", &|letter| shape_of(letter).is_some())?;
    let is_style = |letter| style_of(letter).is_some() || matches!(letter, 'X' | 'Z');
    let style = next("style of a holder", &is_style)?;
    let clearance = next("clearance of an insert", &is_clearance)?;
    let hand = match next("hand", &|letter| matches!(letter, 'R' | 'L' | 'N'))? {
        'R' => ToolHand::Right,
        'L' => ToolHand::Left,
        _ => ToolHand::Neutral,
    };
    // This was checked before.
    let Some(shape) = shape_of(shape) else {
        return Err(reader.wrong(1, String::new(), HEAD_HELP));
    };
    Ok((shape, style, clearance, hand))
}

/// Reads `2525M12`, `16-4D`, or nothing: the length of the edges, mm.
fn shank(
    reader: &mut DesignationReader<'_>,
    letter: InsertLetter,
) -> Result<Option<f64>, DesignationError> {
    let start = reader.at;
    let digits = reader.run(|c| c.is_ascii_digit());
    match digits.len() {
        0 => Ok(None),
        4 => {
            // A dash replaces the letter of a special length.
            reader.run(|c| c == ' ');
            let dash = reader.run(|c| c == '-');
            if dash.is_empty() {
                reader.letter();
            }
            reader.skip_gaps();
            size(reader, letter)
        }
        // Sixteenths of an inch, then the size in eighths and the letter of the length.
        2 | 3 => {
            let size = match digits.len() {
                3 => &digits[2..],
                _ => {
                    reader.skip_gaps();
                    reader.run(|c| c.is_ascii_digit())
                }
            };
            Ok(circle_of_eighths(size).and_then(|circle| edge_of_circle(letter, circle)))
        }
        count => {
            let message = format!("`{digits}` is no height and width of a shank");
            Err(DesignationError::new(message, start..start + count, SHANK_HELP))
        }
    }
}

/// Reads the symbol of the size of the insert, or nothing.
fn size(
    reader: &mut DesignationReader<'_>,
    letter: InsertLetter,
) -> Result<Option<f64>, DesignationError> {
    let digits = reader.run(|c| c.is_ascii_digit());
    match digits.len() {
        0 => Ok(None),
        // `3`: eighths of an inch.
        1 => Ok(circle_of_eighths(digits).and_then(|circle| edge_of_circle(letter, circle))),
        2 => {
            let symbol = digits.parse::<u32>().unwrap_or_default();
            let circle = circle_of_symbol(letter, symbol, letter == InsertLetter::R);
            Ok(circle.and_then(|circle| edge_of_circle(letter, circle)))
        }
        count => {
            let message = format!("`{digits}` is no size of an insert");
            Err(reader.wrong(count, message, SHANK_HELP))
        }
    }
}
