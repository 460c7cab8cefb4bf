//! Centre and end of an arc from its radius and angles.

use chordal_geometry::{TurnDirection, Vec2};

use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::error::{CalcError, bounded};
use crate::figure::{Figure, LineStyle};
use crate::math::{FRAC_PI_2, TAU, turn, unit};
use crate::numbers::{AnswerUnit, degrees, factor};

/// An arc as drawings give it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcPoints {
    /// Where it begins, mm.
    pub start: Vec2,
    /// Its radius, mm.
    pub radius: f64,
    /// Direction from the centre to its start, from the X axis, rad.
    pub from: f64,
    /// Direction from the centre to its end, rad.
    pub to: f64,
    /// Its sense: G3 or G2.
    pub direction: TurnDirection,
}

/// Centre, end, I and J of an arc.
///
/// # Errors
/// When the radius is none.
pub fn arc_points(ask: &ArcPoints, units: AnswerUnit) -> Result<WorkedCalculation, CalcError> {
    let ArcPoints { start, radius, from, to, direction } = *ask;
    bounded(&[start.a, start.b, radius], &[from, to], units)?;
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(CalcError::new(
            format!("an arc with radius {} is not possible", units.length(radius)),
            "give a radius above zero",
        ));
    }
    let ccw = direction == TurnDirection::Ccw;
    let open = if ccw { turn(to - from) } else { turn(from - to) };
    // Ends on one ray are a full turn, as controls take it with I and J.
    let sweep = if open < 1e-12 { TAU } else { open };
    let center = start - unit(from) * radius;
    let end = center + unit(to) * radius;
    let (i, j) = (center.a - start.a, center.b - start.b);
    let mut worked = WorkedCalculation::new("Arc from radius and angles", units);
    let length = QuantityKind::Length;
    worked.input("XS", "start", length, start.a);
    worked.input("YS", "start", length, start.b);
    worked.input("R", "radius", length, radius);
    worked.input("a", "direction from the centre to the start", QuantityKind::Angle, from);
    worked.input("b", "direction from the centre to the end", QuantityKind::Angle, to);
    let n = |value: f64| units.number(value);
    let (r, ta, tb) = (n(radius), degrees(from), degrees(to));
    let rows = [
        ("XC", "centre", center.a, "XS − R·cos(a)", format!("{} − {r}·cos({ta})", n(start.a))),
        ("YC", "centre", center.b, "YS − R·sin(a)", format!("{} − {r}·sin({ta})", n(start.b))),
        ("XE", "end", end.a, "XC + R·cos(b)", format!("{} + {r}·cos({tb})", n(center.a))),
        ("YE", "end", end.b, "YC + R·sin(b)", format!("{} + {r}·sin({tb})", n(center.b))),
        (
            "I",
            "to the centre, from the start",
            i,
            "XC − XS",
            format!("{} − {}", n(center.a), factor(n(start.a))),
        ),
        (
            "J",
            "to the centre, from the start",
            j,
            "YC − YS",
            format!("{} − {}", n(center.b), factor(n(start.b))),
        ),
    ];
    for (symbol, meaning, value, formula, filled) in rows {
        worked.result(symbol, meaning, length, value, formula, filled);
    }
    let (formula, filled) = if ccw {
        ("b − a", format!("{tb} − {}", factor(ta.clone())))
    } else {
        ("a − b", format!("{ta} − {}", factor(tb.clone())))
    };
    worked.result(
        "s",
        "angle travelled",
        QuantityKind::Angle,
        sweep,
        &format!("{formula}, within a turn"),
        filled,
    );
    worked.result(
        "l",
        "length of the arc",
        length,
        radius * sweep,
        "R·s·π/180",
        format!("{r}·{}·π/180", degrees(sweep)),
    );
    worked.note(format!(
        "Block: {} X{} Y{} I{} J{}",
        if ccw { "G3" } else { "G2" },
        n(end.a),
        n(end.b),
        n(i),
        n(j)
    ));
    worked.note(format!(
        "For controls that read I and J from the centre to the start: I{} J{}; absolute: I{} J{}.",
        n(-i + 0.0),
        n(-j + 0.0),
        n(center.a),
        n(center.b)
    ));
    worked.figure = draw(ask, center, end, if ccw { sweep } else { -sweep }, units);
    Ok(worked)
}

fn draw(ask: &ArcPoints, center: Vec2, end: Vec2, sweep: f64, units: AnswerUnit) -> Figure {
    let ArcPoints { start, radius, from, to, .. } = *ask;
    let mut figure = Figure::default();
    figure.line(center, center + Vec2::new(1.25 * radius, 0.0), LineStyle::Helper);
    figure.line(center, start, LineStyle::Helper);
    figure.line(center, end, LineStyle::Helper);
    figure.arc(center, radius, from, sweep, LineStyle::Path);
    let middle = from + sweep * 0.5;
    figure.arrow(center + unit(middle) * radius, middle + FRAC_PI_2.copysign(sweep));
    let place =
        |name: &str, at: Vec2| format!("{name} X{} Y{}", units.number(at.a), units.number(at.b));
    figure.point(center, &place("centre", center));
    figure.point(start, &place("start", start));
    if start.distance(end) > 1e-9 * radius {
        figure.point(end, &place("end", end));
    }
    if turn(from) > 1e-9 {
        figure.angle(center, 0.3 * radius, 0.0, from % TAU, format!("a {}", degrees(from)));
    }
    if turn(to) > 1e-9 && turn(to - from) > 1e-9 {
        figure.angle(center, 0.52 * radius, 0.0, to % TAU, format!("b {}", degrees(to)));
    }
    figure.text(center + unit(from) * (0.7 * radius), format!("R {}", units.number(radius)));
    figure
}
