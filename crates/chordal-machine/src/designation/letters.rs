//! What the letters of designations mean (ISO 1832, ISO 5608).

use crate::turning::InsertLetter;

/// The letter of an insert's shape.
pub(super) fn shape_of(letter: char) -> Option<InsertLetter> {
    InsertLetter::ALL.into_iter().find(|shape| shape.as_str().starts_with(letter))
}

/// The normal clearance of an insert, degrees; `None` for a letter that has none. `O` is a clearance of its own.
pub fn clearance_degrees(letter: char) -> Option<f64> {
    Some(match letter {
        'A' => 3.0,
        'B' => 5.0,
        'C' => 7.0,
        'D' => 15.0,
        'E' => 20.0,
        'F' => 25.0,
        'G' => 30.0,
        'N' => 0.0,
        'P' => 11.0,
        _ => return None,
    })
}

/// Whether the letter stands for a clearance.
pub(super) fn is_clearance(letter: char) -> bool {
    letter == 'O' || clearance_degrees(letter).is_some()
}

/// Whether the letter stands for a tolerance class.
pub(super) fn is_tolerance(letter: char) -> bool {
    "AFCHEGJKLMNU".contains(letter)
}

/// Whether the letter stands for hole and chip breaker.
pub(super) fn is_fixing(letter: char) -> bool {
    "NRFAMGWTQUBHCJX".contains(letter)
}

/// Whether the letter says how a holder clamps its insert.
pub(super) fn is_clamping(letter: char) -> bool {
    "CDMPSWN".contains(letter)
}

/// The style of a holder: its entering angle, and whether it is that of a feed along the shank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct HolderStyle {
    /// The angle between the main edge and the feed, degrees.
    pub entering_degrees: f64,
    /// The main edge lies at the end of the shank: the feed is square to it for a square shank held across
    /// the spindle, that is along X.
    pub end_cutting: bool,
    /// The same edge on both sides: it stands symmetrically where the holder has no hand.
    pub symmetrical: bool,
}

/// The style of a letter; `None` for one that has none of its own (`X`, `Z` are the maker's).
pub(super) fn style_of(letter: char) -> Option<HolderStyle> {
    let side =
        |entering_degrees| HolderStyle { entering_degrees, end_cutting: false, symmetrical: false };
    let end = |entering_degrees| HolderStyle { end_cutting: true, ..side(entering_degrees) };
    let middle = |entering_degrees| HolderStyle { symmetrical: true, ..side(entering_degrees) };
    Some(match letter {
        'A' | 'G' => side(90.0),
        'B' | 'R' => side(75.0),
        'C' | 'F' => end(90.0),
        'D' => middle(45.0),
        'E' => middle(60.0),
        'H' | 'Q' => side(107.5),
        'J' => side(93.0),
        'K' => end(75.0),
        'L' => side(95.0),
        'M' => middle(50.0),
        'N' => middle(63.0),
        'P' => side(117.5),
        'S' => side(45.0),
        'T' => side(60.0),
        'U' => end(93.0),
        'V' => middle(72.5),
        'W' => end(60.0),
        'Y' => end(85.0),
        _ => return None,
    })
}
