//! Holes on a circle.

use chordal_geometry::Vec2;

use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::error::{CalcError, bounded};
use crate::figure::{Figure, LineStyle};
use crate::math::{TAU, sin, unit};
use crate::numbers::{AnswerUnit, degrees};

/// Holes at even steps on a circle or a part of one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoltCircle {
    /// Centre of the circle, mm.
    pub center: Vec2,
    /// Its diameter, mm.
    pub diameter: f64,
    /// Number of holes.
    pub holes: u32,
    /// Direction from the centre to the first hole, from the X axis, rad.
    pub start: f64,
    /// Angle from the first hole to the last; a whole turn: the holes share it evenly. rad.
    pub sweep: f64,
}

/// More holes than this are no list for a person.
const MAX_HOLES: u32 = 360;

/// X and Y of each hole, and the distance of neighbours.
///
/// # Errors
/// When the circle has no size, or the number of holes is none.
pub fn bolt_circle(ask: &BoltCircle, units: AnswerUnit) -> Result<WorkedCalculation, CalcError> {
    let BoltCircle { center, diameter, holes, start, sweep } = *ask;
    bounded(&[diameter, center.a, center.b], &[start, sweep], units)?;
    if diameter <= 0.0 || holes == 0 || holes > MAX_HOLES {
        return Err(CalcError::new(
            format!("{holes} holes on a circle of {} are not possible", units.length(diameter)),
            format!("give a diameter above zero and 1 to {MAX_HOLES} holes"),
        ));
    }
    if sweep == 0.0 || sweep.abs() > TAU + 1e-9 {
        return Err(CalcError::new(
            format!("holes over {} are not possible", degrees(sweep)),
            "give an angle of at most 360°, and not 0°",
        ));
    }
    let whole = (sweep.abs() - TAU).abs() < 1e-9;
    let gaps = if whole { holes } else { (holes - 1).max(1) };
    let step = sweep / f64::from(gaps);
    let mut worked = WorkedCalculation::new("Holes on a circle", units);
    worked.input("D", "diameter of the circle", QuantityKind::Length, diameter);
    worked.input("Xc", "X of the centre", QuantityKind::Length, center.a);
    worked.input("Yc", "Y of the centre", QuantityKind::Length, center.b);
    worked.input("N", "holes", QuantityKind::Number, f64::from(holes));
    worked.input("a", "direction of the first hole", QuantityKind::Angle, start);
    worked.input("s", "angle over all", QuantityKind::Angle, sweep);
    let (d, x, y) = (units.number(diameter), units.number(center.a), units.number(center.b));
    let (s, a) = (degrees(sweep), degrees(start));
    let formula = if whole { "s/N" } else { "s/(N − 1)" };
    worked.intermediate(
        "w",
        "from hole to hole",
        QuantityKind::Angle,
        step,
        formula,
        format!("{s}/{gaps}"),
    );
    let radius = diameter / 2.0;
    for hole in 0..holes {
        let at = center + unit(start + f64::from(hole) * step) * radius;
        let number = hole + 1;
        for (axis, value, from, ratio) in [("X", at.a, &x, "cos"), ("Y", at.b, &y, "sin")] {
            worked.result(
                &format!("{axis}{number}"),
                &format!("hole {number}"),
                QuantityKind::Length,
                value,
                &format!("{axis}c + D/2·{ratio}(a + {hole}·w)"),
                format!("{from} + {d}/2·{ratio}({a} + {hole}·{})", degrees(step)),
            );
        }
    }
    if holes > 1 {
        let separate = diameter * sin(step.abs() / 2.0);
        let filled = format!("{d}·sin({}/2)", degrees(step.abs()));
        worked.result(
            "c",
            "between neighbours",
            QuantityKind::Length,
            separate,
            "D·sin(w/2)",
            filled,
        );
    }
    worked.figure = draw(ask, step, units);
    Ok(worked)
}

fn draw(ask: &BoltCircle, step: f64, units: AnswerUnit) -> Figure {
    let mut figure = Figure::default();
    let radius = ask.diameter / 2.0;
    figure.circle(ask.center, radius, LineStyle::Helper);
    figure.point(ask.center, "");
    for hole in 0..ask.holes {
        let at = ask.center + unit(ask.start + f64::from(hole) * step) * radius;
        figure.circle(at, radius * 0.06, LineStyle::Part);
        figure.point(at, &(hole + 1).to_string());
    }
    figure.line(ask.center, ask.center + unit(ask.start) * radius, LineStyle::Helper);
    figure.text(ask.center, format!("D {}", units.number(ask.diameter)));
    figure
}
