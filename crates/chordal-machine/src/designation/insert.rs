//! Inserts: `CNMG120408` (ISO 1832) and `CNMG432` (ANSI B212.4).

use super::edge::{circle_of_eighths, circle_of_symbol, edge_of_circle};
use super::letters::InsertLetter;
use super::letters::{is_clearance, is_fixing, is_tolerance, shape_of};
use super::{DesignationError, DesignationReader};

/// The data in the designation of an insert.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InsertDesignation {
    /// Its shape, which determines the angle of its corner.
    pub letter: InsertLetter,
    /// The letter of its normal clearance.
    pub clearance: char,
    /// The diameter of its inscribed circle, mm; `None` for a size that is not in the table.
    pub circle_mm: Option<f64>,
    /// The length of its edges, mm; `None` if it is not known.
    pub edge_mm: Option<f64>,
    /// The radius of its nose, mm; that of the insert if it is round.
    pub nose_mm: f64,
}

/// Symbols of thickness.
const THICKNESSES: [&str; 18] = [
    "01", "T0", "T1", "02", "T2", "03", "T3", "04", "05", "06", "07", "08", "09", "10", "12", "S1",
    "L1", "L2",
];

/// Symbols of nose radii, tenths of a millimetre.
const NOSES: [u32; 18] = [0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 16, 20, 24, 28, 32, 40, 50];

/// A sixty-fourth of an inch, mm.
const SIXTY_FOURTH_MM: f64 = 25.4 / 64.0;

const LETTERS_HELP: &str =
    "the four letters are shape, clearance, tolerance and kind of hole, as in `CNMG120408`";
const SIZE_HELP: &str = "after the letters come size, thickness and nose radius: `120408` in millimetres, `432` in inches";

impl InsertDesignation {
    /// Reads a designation. Text after it, such as a chip breaker and a grade of the manufacturer, is ignored.
    ///
    /// # Errors
    /// If the text is not a designation, with the reason.
    pub fn parse(text: &str) -> Result<InsertDesignation, DesignationError> {
        let mut reader = DesignationReader::new(text);
        reader.skip_gaps();
        refuse_threading(&reader)?;
        let (shape, clearance) = Self::letters(&mut reader)?;
        reader.skip_gaps();
        let start = reader.at;
        let sizes = metric(&mut reader, shape)?.or_else(|| inch(&mut reader, shape));
        let Some((circle_mm, nose_mm)) = sizes else {
            let digits = reader.run(|c| c.is_ascii_digit() || c == '.');
            // Without digits the next character is what stands there in place of a size.
            let next = reader.rest().chars().next().map_or(0, char::len_utf8);
            let count = if digits.is_empty() { next } else { digits.len() };
            let message = match digits {
                "" => "it has no size".to_string(),
                digits => format!("`{digits}` is no size of an insert"),
            };
            return Err(DesignationError::new(message, start..start + count, SIZE_HELP));
        };
        if let more @ 1.. = reader.run(|c| c.is_ascii_digit() || c == '.').len() {
            let message =
                "it has more digits than size, thickness and nose radius have".to_string();
            return Err(reader.wrong(more, message, SIZE_HELP));
        }
        let round = (shape == InsertLetter::R).then_some(circle_mm).flatten();
        Ok(InsertDesignation {
            letter: shape,
            clearance,
            circle_mm,
            edge_mm: circle_mm.and_then(|circle| edge_of_circle(shape, circle)),
            nose_mm: round.map_or(nose_mm, |circle| 0.5 * circle),
        })
    }

    /// Reads the four letters, and returns shape and clearance.
    fn letters(
        reader: &mut DesignationReader<'_>,
    ) -> Result<(InsertLetter, char), DesignationError> {
        let next = |reader: &mut DesignationReader<'_>, what: &str| match reader.letter() {
            Some(letter) => Ok(letter),
            None => {
                let at = reader.at;
                let message = format!("the letter of its {what} is missing");
                Err(DesignationError::new(message, at..at, LETTERS_HELP))
            }
        };
        let letter = next(reader, "shape")?;
        let shape = shape_of(letter).ok_or_else(|| {
            let known: Vec<&str> = InsertLetter::ALL.iter().map(|known| known.as_str()).collect();
            let help = format!("the shapes are {}", known.join(", "));
            reader.wrong(1, format!("`{letter}` is no shape of an insert"), help)
        })?;
        let clearance = next(reader, "clearance")?;
        if !is_clearance(clearance) {
            let message = format!("`{clearance}` is no clearance of an insert");
            let help = "the clearances are N 0°, A 3°, B 5°, C 7°, P 11°, D 15°, E 20°, F 25°, G 30° and O";
            return Err(reader.wrong(1, message, help));
        }
        let tolerance = next(reader, "tolerance class")?;
        if !is_tolerance(tolerance) {
            let message = format!("`{tolerance}` is no tolerance class of an insert");
            return Err(reader.wrong(1, message, "the classes are A, C, E to H, J to N and U"));
        }
        let fixing = next(reader, "hole and chip breaker")?;
        if !is_fixing(fixing) {
            let message = format!("`{fixing}` is no kind of hole and chip breaker");
            let help = "the kinds are A, B, C, F, G, H, J, M, N, Q, R, T, U, W and X";
            return Err(reader.wrong(1, message, help));
        }
        Ok((shape, clearance))
    }
}

/// Refuses the designation of a threading insert (`16ER AG60`): its size, side and hand come first.
fn refuse_threading(reader: &DesignationReader<'_>) -> Result<(), DesignationError> {
    let mut look = reader.clone();
    let digits = look.run(|c| c.is_ascii_digit()).len();
    look.skip_gaps();
    let side = look.letter();
    let hand = look.letter();
    if digits > 0 && matches!(side, Some('E' | 'I' | 'N')) && matches!(hand, Some('R' | 'L')) {
        let help = "give `insert_angle` and `nose_radius` instead of it";
        let message = "this is a threading insert, whose designations are not read".to_string();
        return Err(DesignationError::new(message, reader.at..look.at, help));
    }
    Ok(())
}

/// Inscribed circle and nose radius of `120408`, mm; `None` if the digits have another form.
#[allow(clippy::type_complexity, reason = "two lengths, of which one may be unknown")]
fn metric(
    reader: &mut DesignationReader<'_>,
    shape: InsertLetter,
) -> Result<Option<(Option<f64>, f64)>, DesignationError> {
    let start = reader.at;
    let mut places = [start; 3];
    let mut upper = String::new();
    for place in &mut places {
        // `12 04 08` is also usual.
        reader.run(|c| c == ' ');
        *place = reader.at;
        let Some(symbol) = reader.take(2) else {
            reader.at = start;
            return Ok(None);
        };
        upper.push_str(&symbol.to_ascii_uppercase());
    }
    let (size, thickness, nose) = (&upper[..2], &upper[2..4], &upper[4..]);
    let Ok(symbol) = size.parse::<u32>() else {
        reader.at = start;
        return Ok(None);
    };
    let looks_metric = |c: char| c.is_ascii_alphanumeric();
    let is_form = thickness.chars().all(looks_metric)
        && nose.chars().all(looks_metric)
        && thickness.ends_with(|c: char| c.is_ascii_digit())
        && nose.ends_with(|c: char| c.is_ascii_digit());
    if !is_form {
        reader.at = start;
        return Ok(None);
    }
    if !THICKNESSES.contains(&thickness) {
        let message = format!("`{thickness}` is no thickness of an insert");
        let help = "thicknesses are 01, 02, 03, T3, 04, 05, 06, 07 and 09: 04 is 4.76 mm";
        return Err(DesignationError::new(message, places[1]..places[1] + 2, help));
    }
    let is_metric_round = nose == "M0";
    let tenths = nose.parse::<u32>().ok().filter(|tenths| NOSES.contains(tenths));
    let nose_mm = match tenths {
        Some(tenths) => f64::from(tenths) / 10.0,
        None if is_metric_round && shape == InsertLetter::R => 0.0,
        None => {
            let message = format!("`{nose}` is no nose radius of an insert");
            let help = "nose radii are tenths of a millimetre: 04 is 0.4 mm, 08 is 0.8 mm";
            return Err(DesignationError::new(message, places[2]..places[2] + 2, help));
        }
    };
    Ok(Some((circle_of_symbol(shape, symbol, is_metric_round), nose_mm)))
}

/// Inscribed circle and nose radius of `432`, mm; `None` if the digits have another form.
fn inch(reader: &mut DesignationReader<'_>, shape: InsertLetter) -> Option<(Option<f64>, f64)> {
    use InsertLetter as Letter;
    // These have two digits for the size, in other units.
    if matches!(shape, Letter::A | Letter::B | Letter::K | Letter::L) {
        return None;
    }
    let mut look = reader.clone();
    let size = match look.rest() {
        rest if rest.starts_with("1.") => look.take(3)?,
        _ => look.take(1)?,
    };
    let circle = circle_of_eighths(size)?;
    let number = |look: &mut DesignationReader<'_>| {
        let length = if look.rest().get(1..2) == Some(".") { 3 } else { 1 };
        look.take(length)?.parse::<f64>().ok()
    };
    let sixteenths = number(&mut look)?;
    let sixty_fourths = number(&mut look)?;
    if sixteenths <= 0.0 {
        return None;
    }
    reader.at = look.at;
    Some((Some(circle), sixty_fourths * SIXTY_FOURTH_MM))
}
