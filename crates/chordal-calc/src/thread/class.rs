//! Classes of fit: how far a thread may be from its basic size.

use std::fmt;

use super::ThreadLocation;
use crate::error::CalcError;

/// The classes that there are, for people.
pub(super) const UNIFIED: &str = "1A 2A 3A outside and 1B 2B 3B inside; those of metric threads are tolerance classes of ISO \
                                  965-1, such as 6g 6H 4h 5H 7H 6e 8g or 4g6g";
/// The same of metric threads.
pub(super) const METRIC: &str = "a grade with e f g h outside, such as 6g 8g 6e 4h or 4g6g (3 to 9; 4, 6 or 8 \
                                 for the major diameter), and a grade with G H inside, such as 6H 5H 4H 7H 6G or \
                                 4H5H (4 to 8); those of unified threads are 1A 2A 3A 1B 2B 3B";

/// A class of fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FitClass {
    /// A unified thread (ASME B1.1): `2A`, `3B`.
    Unified {
        /// 1 is loose, 3 is close.
        grade: u8,
        /// A is outside, B is inside.
        place: ThreadLocation,
    },
    /// A metric thread (ISO 965-1): `6g`, `4g6g`, `6H`.
    Metric {
        /// The field of the pitch diameter.
        pitch: ToleranceZone,
        /// The field of the crests: the major diameter outside, the minor diameter inside.
        crest: ToleranceZone,
    },
    /// An outside G thread (ISO 228-1): A, or B with twice the tolerance.
    Pipe {
        /// True for B.
        wide: bool,
    },
}

/// A tolerance field of ISO 965-1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ToleranceZone {
    /// 3 is close, 9 is wide.
    pub grade: u8,
    /// `e f g h` outside, `G H` inside.
    pub position: char,
}

impl ToleranceZone {
    /// Capital letters are inside.
    pub fn place(self) -> ThreadLocation {
        if self.position.is_ascii_uppercase() {
            ThreadLocation::Inside
        } else {
            ThreadLocation::Outside
        }
    }
}

impl FitClass {
    /// In a hole or on a boss.
    pub fn place(self) -> ThreadLocation {
        match self {
            FitClass::Unified { place, .. } => place,
            FitClass::Metric { pitch, .. } => pitch.place(),
            FitClass::Pipe { .. } => ThreadLocation::Outside,
        }
    }
}

impl fmt::Display for FitClass {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FitClass::Unified { grade, place } => {
                write!(out, "{grade}{}", if *place == ThreadLocation::Inside { 'B' } else { 'A' })
            }
            FitClass::Metric { pitch, crest } if pitch == crest => {
                write!(out, "{}{}", pitch.grade, pitch.position)
            }
            FitClass::Metric { pitch, crest } => {
                write!(out, "{}{}{}{}", pitch.grade, pitch.position, crest.grade, crest.position)
            }
            FitClass::Pipe { wide } => out.write_str(if *wide { "B" } else { "A" }),
        }
    }
}

/// A class of a unified thread; `None` when there is no such class.
pub(super) fn unified(text: &str) -> Option<FitClass> {
    let (grade, place) = match text.as_bytes() {
        [grade @ b'1'..=b'3', b'A' | b'a'] => (grade, ThreadLocation::Outside),
        [grade @ b'1'..=b'3', b'B' | b'b'] => (grade, ThreadLocation::Inside),
        _ => return None,
    };
    Some(FitClass::Unified { grade: grade - b'0', place })
}

/// A class of a metric thread: the field of the pitch diameter, then that of the crests where it is
/// another.
pub(super) fn metric(text: &str) -> Option<FitClass> {
    let (pitch, crest) = match text.as_bytes() {
        [grade, position] => (zone(*grade, *position)?, zone(*grade, *position)?),
        [grade, position, crest, crest_position] => {
            (zone(*grade, *position)?, zone(*crest, *crest_position)?)
        }
        _ => return None,
    };
    let grades = match pitch.place() {
        ThreadLocation::Outside => {
            (3..=9).contains(&pitch.grade) && [4, 6, 8].contains(&crest.grade)
        }
        ThreadLocation::Inside => (4..=8).contains(&pitch.grade) && (4..=8).contains(&crest.grade),
    };
    (grades && pitch.place() == crest.place()).then_some(FitClass::Metric { pitch, crest })
}

fn zone(grade: u8, position: u8) -> Option<ToleranceZone> {
    let known = grade.is_ascii_digit() && b"efghGH".contains(&position);
    known.then(|| ToleranceZone { grade: grade - b'0', position: char::from(position) })
}

/// Adds a class to those of a name: one outside and one inside at most.
pub(super) fn add(classes: &mut Vec<FitClass>, class: FitClass) -> Result<(), CalcError> {
    if let Some(other) = classes.iter().find(|other| other.place() == class.place()) {
        let place = if class.place() == ThreadLocation::Inside { "inside" } else { "outside" };
        return Err(CalcError::new(
            format!("{other} and {class} are both classes of an {place} thread"),
            "give one class, or one for each of the pair: 2A/2B, 6H/6g",
        ));
    }
    classes.push(class);
    Ok(())
}
