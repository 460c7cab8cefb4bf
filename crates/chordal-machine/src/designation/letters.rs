//! The meaning of the letters in designations (ISO 1832, ISO 5608).

/// The shapes of inserts, by their letter (ISO 1832).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the letters are their names")]
pub enum InsertLetter {
    A,
    B,
    C,
    D,
    E,
    H,
    K,
    L,
    M,
    O,
    P,
    R,
    S,
    T,
    V,
    W,
}

impl InsertLetter {
    /// Every letter.
    pub const ALL: [InsertLetter; 16] = [
        InsertLetter::A,
        InsertLetter::B,
        InsertLetter::C,
        InsertLetter::D,
        InsertLetter::E,
        InsertLetter::H,
        InsertLetter::K,
        InsertLetter::L,
        InsertLetter::M,
        InsertLetter::O,
        InsertLetter::P,
        InsertLetter::R,
        InsertLetter::S,
        InsertLetter::T,
        InsertLetter::V,
        InsertLetter::W,
    ];

    /// The letter.
    pub const fn as_str(self) -> &'static str {
        match self {
            InsertLetter::A => "A",
            InsertLetter::B => "B",
            InsertLetter::C => "C",
            InsertLetter::D => "D",
            InsertLetter::E => "E",
            InsertLetter::H => "H",
            InsertLetter::K => "K",
            InsertLetter::L => "L",
            InsertLetter::M => "M",
            InsertLetter::O => "O",
            InsertLetter::P => "P",
            InsertLetter::R => "R",
            InsertLetter::S => "S",
            InsertLetter::T => "T",
            InsertLetter::V => "V",
            InsertLetter::W => "W",
        }
    }

    /// The angle of the corner, degrees; `None` for a round insert.
    pub const fn corner_degrees(self) -> Option<f64> {
        Some(match self {
            InsertLetter::A => 85.0,
            InsertLetter::B => 82.0,
            InsertLetter::C | InsertLetter::W => 80.0,
            InsertLetter::D | InsertLetter::K => 55.0,
            InsertLetter::E => 75.0,
            InsertLetter::H => 120.0,
            InsertLetter::L | InsertLetter::S => 90.0,
            InsertLetter::M => 86.0,
            InsertLetter::O => 135.0,
            InsertLetter::P => 108.0,
            InsertLetter::T => 60.0,
            InsertLetter::V => 35.0,
            InsertLetter::R => return None,
        })
    }

    /// Whether the insert has three corners.
    pub const fn is_triangle(self) -> bool {
        matches!(self, InsertLetter::T)
    }
}

/// The shape with a letter; `None` if there is none.
pub(super) fn shape_of(letter: char) -> Option<InsertLetter> {
    InsertLetter::ALL.into_iter().find(|shape| shape.as_str().starts_with(letter))
}

/// The normal clearance angle of an insert, degrees; `None` for a letter without one. `O` is a special clearance.
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

/// Whether the letter is one of a clearance.
pub(super) fn is_clearance(letter: char) -> bool {
    letter == 'O' || clearance_degrees(letter).is_some()
}

/// Whether the letter is one of a tolerance class.
pub(super) fn is_tolerance(letter: char) -> bool {
    "AFCHEGJKLMNU".contains(letter)
}

/// Whether the letter is one for hole and chip breaker.
pub(super) fn is_fixing(letter: char) -> bool {
    "NRFAMGWTQUBHCJX".contains(letter)
}

/// Whether the letter is one for the clamping of a holder.
pub(super) fn is_clamping(letter: char) -> bool {
    "CDMPSWN".contains(letter)
}

/// The style of a holder: its entering angle, and the direction of the feed that it is for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct HolderStyle {
    /// The angle between the main edge and the feed, degrees.
    pub entering_degrees: f64,
    /// The main edge is at the end of the shank: for a square shank across the spindle, the entering angle is that of a
    /// feed along X.
    pub end_cutting: bool,
}

/// The style with a letter; `None` if there is none (`X` and `Z` are defined by the manufacturer).
pub(super) fn style_of(letter: char) -> Option<HolderStyle> {
    let side = |entering_degrees| HolderStyle { entering_degrees, end_cutting: false };
    let end = |entering_degrees| HolderStyle { end_cutting: true, ..side(entering_degrees) };
    Some(match letter {
        'A' | 'G' => side(90.0),
        'B' | 'R' => side(75.0),
        'C' | 'F' => end(90.0),
        'D' => side(45.0),
        'E' => side(60.0),
        'H' | 'Q' => side(107.5),
        'J' => side(93.0),
        'K' => end(75.0),
        'L' => side(95.0),
        'M' => side(50.0),
        'N' => side(63.0),
        'P' => side(117.5),
        'S' => side(45.0),
        'T' => side(60.0),
        'U' => end(93.0),
        'V' => side(72.5),
        'W' => end(60.0),
        'Y' => end(85.0),
        _ => return None,
    })
}
