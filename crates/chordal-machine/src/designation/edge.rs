//! The length of the edges of an insert, from its inscribed circle, which has standard sizes.

use super::letters::InsertLetter;

/// The standard diameters of inscribed circles, mm: multiples of 1/32 in.
const CIRCLES_MM: [f64; 12] =
    [3.96875, 4.7625, 5.55625, 6.35, 7.9375, 9.525, 12.7, 15.875, 19.05, 25.4, 31.75, 38.1];

/// The diameters of round inserts of metric sizes, mm.
const METRIC_ROUNDS_MM: [f64; 10] = [5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0];

/// The symbol of a size has whole millimetres, rounded down; with this tolerance, 10.9985 counts as 11, mm.
const ROUNDING_MM: f64 = 0.01;

/// The length of an edge of an insert with this inscribed circle, mm; `None` if the circle does not determine it.
pub(super) fn edge_of_circle(letter: InsertLetter, circle_mm: f64) -> Option<f64> {
    // The length of the tangent from a corner to the circle; the edge is the sum of those of its two corners.
    let tangent = |corner_degrees: f64| 0.5 * circle_mm / tan_half(corner_degrees);
    Some(match letter {
        InsertLetter::R => circle_mm,
        InsertLetter::C
        | InsertLetter::D
        | InsertLetter::E
        | InsertLetter::M
        | InsertLetter::S
        | InsertLetter::V => {
            let corner = letter.corner_degrees()?;
            tangent(corner) + tangent(180.0 - corner)
        }
        InsertLetter::T | InsertLetter::P | InsertLetter::H | InsertLetter::O => {
            2.0 * tangent(letter.corner_degrees()?)
        }
        // Corners of 80° and of 160° alternate.
        InsertLetter::W => tangent(80.0) + tangent(160.0),
        // Two of the edges are longer than the others.
        InsertLetter::A | InsertLetter::B | InsertLetter::K | InsertLetter::L => return None,
    })
}

fn tan_half(degrees: f64) -> f64 {
    libm::tan(0.5 * degrees.to_radians())
}

/// The diameter of the inscribed circle whose edge has this symbol of size, mm; `None` if there is none.
pub(super) fn circle_of_symbol(letter: InsertLetter, symbol: u32, is_metric: bool) -> Option<f64> {
    if letter == InsertLetter::R && is_metric {
        return METRIC_ROUNDS_MM.into_iter().find(|mm| *mm == f64::from(symbol));
    }
    CIRCLES_MM.into_iter().find(|circle| {
        edge_of_circle(letter, *circle)
            .is_some_and(|edge| (edge + ROUNDING_MM).floor() == f64::from(symbol))
    })
}

/// The diameter of the inscribed circle of an inch designation in eighths of an inch, mm; those below a quarter inch are
/// rounded. `None` if there is none.
pub(super) fn circle_of_eighths(text: &str) -> Option<f64> {
    let thirty_seconds = match text {
        "1.2" => 5.0,
        "1.5" => 6.0,
        "1.8" => 7.0,
        _ => 4.0 * text.parse::<f64>().ok().filter(|eighths| (2.0..=12.0).contains(eighths))?,
    };
    Some(thirty_seconds * 25.4 / 32.0)
}
