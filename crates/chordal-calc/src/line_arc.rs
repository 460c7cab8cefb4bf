//! A corner of a line with an arc.

use chordal_geometry::Vec2;

use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::corner::cutter;
use crate::error::{CalcError, bounded};
use crate::figure::{Figure, LineStyle};
use crate::math::{PI, atan2};
use crate::numbers::AnswerUnit;

/// A line along X that meets an arc, and a cutter that touches both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineArc {
    /// Radius of the cutter, mm.
    pub cutter_radius: f64,
    /// Radius of the arc, mm.
    pub radius: f64,
    /// Δj: distance of the line from the arc's centre, mm.
    pub height: f64,
    /// The cutter is inside the arc's circle.
    pub inside: bool,
    /// The cutter is on that side of the line where the arc's centre is.
    pub toward: bool,
    /// Δi: the corner along the line from the arc's centre, mm, where a drawing gives it.
    pub corner: Option<f64>,
}

/// Offset of the cutter's centre at a corner of a line with an arc:
/// ΔX = Δi − √((R∓CR)² − (Δj∓CR)²), ΔY = CR.
///
/// # Errors
/// When line and arc do not meet, or the cutter cannot touch both.
pub fn line_with_arc(ask: &LineArc, units: AnswerUnit) -> Result<WorkedCalculation, CalcError> {
    let LineArc { cutter_radius, radius, height, inside, toward, corner } = *ask;
    bounded(&[cutter_radius, radius, height, corner.unwrap_or(0.0)], &[], units)?;
    cutter(cutter_radius, units)?;
    check(ask, units)?;
    let (arc_sign, line_sign) = (if inside { "−" } else { "+" }, if toward { "−" } else { "+" });
    let arc = if inside { radius - cutter_radius } else { radius + cutter_radius };
    let line = if toward { height - cutter_radius } else { height + cutter_radius };
    if line.abs() > arc {
        return Err(CalcError::new(
            format!(
                "a cutter with radius {} cannot touch both: its centre runs {} from the line's parallel \
                 through the arc's centre, and {} from that centre",
                units.length(cutter_radius),
                units.length(line.abs()),
                units.length(arc)
            ),
            "use a smaller cutter, or check on which sides it is",
        ));
    }
    let mut worked = WorkedCalculation::new("Corner of a line with an arc", units);
    worked.input("CR", "cutter radius", QuantityKind::Length, cutter_radius);
    worked.input("R", "radius of the arc", QuantityKind::Length, radius);
    worked.input("Δj", "line from the arc's centre", QuantityKind::Length, height);
    let n = |value: f64| units.number(value);
    let along = match corner {
        Some(along) => {
            worked.input(
                "Δi",
                "corner from the arc's centre, by the drawing",
                QuantityKind::Length,
                along,
            );
            along
        }
        None => {
            let along = ((radius - height) * (radius + height)).sqrt();
            let filled = format!("√({}² − {}²)", n(radius), n(height));
            let meaning = "corner from the arc's centre, along the line";
            worked.intermediate("Δi", meaning, QuantityKind::Length, along, "√(R² − Δj²)", filled);
            along
        }
    };
    let center = ((arc - line) * (arc + line)).sqrt();
    worked.result(
        "ΔX",
        "from the corner to the cutter's centre, along the line",
        QuantityKind::Length,
        along - center,
        &format!("Δi − √((R {arc_sign} CR)² − (Δj {line_sign} CR)²)"),
        format!(
            "{} − √(({} {arc_sign} {})² − ({} {line_sign} {})²)",
            n(along),
            n(radius),
            n(cutter_radius),
            n(height),
            n(cutter_radius)
        ),
    );
    worked.result(
        "ΔY",
        "off the line",
        QuantityKind::Length,
        cutter_radius,
        "CR",
        n(cutter_radius),
    );
    worked.note(if along - center >= 0.0 {
        "The cutter's centre is this much nearer to the arc's centre than the corner is."
    } else {
        "Below zero: the cutter's centre is further from the arc's centre than the corner is."
    });
    worked.figure = draw(ask, along, center, line, units);
    Ok(worked)
}

fn check(ask: &LineArc, units: AnswerUnit) -> Result<(), CalcError> {
    let LineArc { cutter_radius, radius, height, inside, corner, .. } = *ask;
    if !(radius > 0.0 && radius.is_finite() && height >= 0.0 && height.is_finite()) {
        return Err(CalcError::new(
            format!(
                "an arc with radius {} and a line {} from its centre are not possible",
                units.length(radius),
                units.length(height)
            ),
            "the radius must be above zero, the distance not below zero",
        ));
    }
    if height >= radius {
        return Err(CalcError::new(
            format!(
                "the line passes the arc's centre at a distance of {}, and the arc's radius is {}: they make no corner",
                units.length(height),
                units.length(radius)
            ),
            "for a line that touches the arc use `calc tangent`",
        ));
    }
    if inside && cutter_radius >= radius {
        return Err(CalcError::new(
            format!(
                "a cutter with radius {} does not fit into an arc with radius {}",
                units.length(cutter_radius),
                units.length(radius)
            ),
            "use a smaller cutter",
        ));
    }
    if corner.is_some_and(|along| !along.is_finite() || along < 0.0) {
        return Err(CalcError::new("Δi is below zero", "give the distance along the line"));
    }
    Ok(())
}

/// The arc's centre at 0, the line below it, the corner to the right.
fn draw(ask: &LineArc, along: f64, center: f64, line: f64, units: AnswerUnit) -> Figure {
    let cr = ask.cutter_radius;
    let corner = Vec2::new(along, -ask.height);
    let center = Vec2::new(center, -line);
    let arm = 3.5 * cr;
    let mut figure = Figure::default();
    // The part of the line and of the arc that the cutter can touch.
    let path = if ask.inside { -1.0 } else { 1.0 };
    let up = if ask.toward { 1.0 } else { -1.0 };
    figure.line(corner, corner + Vec2::new(path * arm, 0.0), LineStyle::Part);
    let arc_part = |figure: &mut Figure, at: Vec2, radius: f64, style: LineStyle| {
        let start = atan2(at.b, at.a);
        let sweep = (arm / radius).min(0.6 * PI);
        figure.arc(Vec2::ZERO, radius, start, up * sweep, style);
    };
    arc_part(&mut figure, corner, ask.radius, LineStyle::Part);
    figure.line(center, center + Vec2::new(path * arm, 0.0), LineStyle::Path);
    let offset = if ask.inside { ask.radius - cr } else { ask.radius + cr };
    arc_part(&mut figure, center, offset, LineStyle::Path);
    figure.circle(center, cr, LineStyle::Cutter);
    figure.line(Vec2::ZERO, corner, LineStyle::Helper);
    figure.point(corner, "P");
    figure.point(center, "C");
    figure.point(Vec2::ZERO, "arc centre");
    let below = corner.b.min(center.b) - 1.5 * cr;
    figure.width(corner, center, below, format!("ΔX {}", units.number((along - center.a).abs())));
    figure.width(Vec2::ZERO, corner, below - 0.9 * cr, format!("Δi {}", units.number(along)));
    let left = (-0.4 * cr).min(center.a - 4.2 * cr);
    if ask.height > 0.0 {
        figure.height(Vec2::ZERO, corner, left, format!("Δj {}", units.number(ask.height)));
    }
    figure.text(corner * 0.5, format!("R {}", units.number(ask.radius)));
    figure
}
