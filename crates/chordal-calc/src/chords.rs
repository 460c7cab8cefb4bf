//! How many chords stand for an arc.

use chordal_geometry::Vec2;

use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::error::{CalcError, bounded};
use crate::figure::{Figure, LineStyle};
use crate::math::{FRAC_PI_2, TAU, acos, cos, sin, unit};
use crate::numbers::{AnswerUnit, degrees, trimmed};

/// An arc to be cut into chords with their ends on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChordCount {
    /// Radius of the arc, mm.
    pub radius: f64,
    /// How far a chord may be from the arc, mm.
    pub tolerance: f64,
    /// Angle of the arc, rad.
    pub sweep: f64,
}

/// More chords than this are drawn as so many.
const DRAWN: f64 = 12.0;

/// Number and length of the chords of an arc, and how far they are from it.
///
/// # Errors
/// When the tolerance is not between nothing and the radius.
pub fn chord_count(ask: &ChordCount, units: AnswerUnit) -> Result<WorkedCalculation, CalcError> {
    let ChordCount { radius, tolerance, sweep } = *ask;
    bounded(&[radius, tolerance], &[sweep], units)?;
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(CalcError::new(
            format!("an arc with radius {} is not possible", units.length(radius)),
            "give a radius above zero",
        ));
    }
    if !(tolerance > 0.0 && tolerance < radius) {
        return Err(CalcError::new(
            format!(
                "a chord cannot be {} from an arc with radius {}",
                units.length(tolerance),
                units.length(radius)
            ),
            "give a tolerance above zero and below the radius",
        ));
    }
    if !(sweep > 0.0 && sweep <= TAU + 1e-9) {
        return Err(CalcError::new(
            format!("an arc of {} is not possible", degrees(sweep)),
            "give its angle, above 0° and not above 360°",
        ));
    }
    let step = 2.0 * acos(1.0 - tolerance / radius);
    // What rounding adds is no chord.
    let count = (sweep / step - 1e-9).ceil().max(1.0);
    if !count.is_finite() || count > 1e12 {
        return Err(CalcError::new(
            format!(
                "a tolerance of {} is too small for a radius of {}",
                units.length(tolerance),
                units.length(radius)
            ),
            "give a larger tolerance",
        ));
    }
    let half = sweep / count / 2.0;
    let mut worked = WorkedCalculation::new("Chords of an arc", units);
    let length = QuantityKind::Length;
    worked.input("R", "radius", length, radius);
    worked.input("e", "tolerance", length, tolerance);
    worked.input("s", "angle of the arc", QuantityKind::Angle, sweep);
    let (r, e, s) = (units.number(radius), units.number(tolerance), degrees(sweep));
    worked.intermediate(
        "α",
        "largest angle of a chord",
        QuantityKind::Angle,
        step,
        "2·acos(1 − e/R)",
        format!("2·acos(1 − {e}/{r})"),
    );
    worked.result(
        "N",
        "chords",
        QuantityKind::Number,
        count,
        "s/α, rounded up",
        format!("{s}/{}", degrees(step)),
    );
    let number = trimmed(count, 0);
    worked.result(
        "c",
        "length of a chord",
        length,
        2.0 * radius * sin(half),
        "2·R·sin(s/(2·N))",
        format!("2·{r}·sin({s}/(2·{number}))"),
    );
    worked.result(
        "f",
        "its distance from the arc",
        length,
        radius * (1.0 - cos(half)),
        "R·(1 − cos(s/(2·N)))",
        format!("{r}·(1 − cos({s}/(2·{number})))"),
    );
    worked.note(
        "The ends of the chords lie on the arc. With the ends outside it by e, √2 times fewer chords are needed.",
    );
    worked.figure = draw(radius, sweep, count, units, tolerance);
    if count > DRAWN {
        worked.note(format!("The figure shows {DRAWN} chords instead of {number}."));
    }
    Ok(worked)
}

fn draw(radius: f64, sweep: f64, count: f64, units: AnswerUnit, tolerance: f64) -> Figure {
    let mut figure = Figure::default();
    let shown = count.min(DRAWN);
    let start = FRAC_PI_2 - sweep / 2.0;
    figure.arc(Vec2::ZERO, radius, start, sweep, LineStyle::Part);
    let corner = |index: f64| unit(start + sweep * index / shown) * radius;
    for index in 0..shown as u32 {
        let (from, to) = (corner(f64::from(index)), corner(f64::from(index) + 1.0));
        figure.line(from, to, LineStyle::Path);
        figure.point(from, "");
    }
    figure.point(corner(shown), "");
    let index = (shown / 2.0).floor();
    let (from, to) = (corner(index), corner(index + 1.0));
    figure.line(Vec2::ZERO, from, LineStyle::Helper);
    figure.line(Vec2::ZERO, to, LineStyle::Helper);
    figure.point(Vec2::ZERO, "");
    let first = start + sweep * index / shown;
    figure.angle(
        Vec2::ZERO,
        0.45 * radius,
        first,
        sweep / shown,
        format!("{} / {}", degrees(sweep), trimmed(count, 0)),
    );
    figure.text(from * 0.75, format!("R {}", units.number(radius)));
    figure.text((from + to) * 0.5, format!("e ≤ {}", units.number(tolerance)));
    figure
}
