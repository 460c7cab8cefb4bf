//! A corner of two arcs.

use chordal_geometry::Vec2;

use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::corner::{TravelSide, cutter};
use crate::error::{CalcError, bounded};
use crate::figure::{Figure, LineStyle};
use crate::math::{PI, atan2, cos, sin};
use crate::numbers::{AnswerUnit, degrees, factor};

/// Two arcs that cross, and a cutter that touches both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcArc {
    /// Radius of the cutter, mm.
    pub cutter_radius: f64,
    /// Radii of the arcs, mm.
    pub radii: [f64; 2],
    /// Whether the cutter is inside each arc's circle.
    pub inside: [bool; 2],
    /// The second arc's centre from the first's, mm.
    pub center_offset: [f64; 2],
    /// Which crossing: seen from the first centre towards the second.
    pub side: TravelSide,
}

/// The crossing of two circles along and across the line of their centres.
struct CircleCrossing {
    along: f64,
    across: f64,
}

/// Offset of the cutter's centre at a corner of two arcs: the crossing of the arcs with radii
/// R∓CR less that of the arcs themselves.
///
/// # Errors
/// When the arcs do not cross, or the cutter cannot touch both.
pub fn arc_with_arc(ask: &ArcArc, units: AnswerUnit) -> Result<WorkedCalculation, CalcError> {
    let ArcArc { cutter_radius: cr, radii, inside, center_offset: separate, side } = *ask;
    bounded(&[cr, radii[0], radii[1], separate[0], separate[1]], &[], units)?;
    cutter(cr, units)?;
    let distance = (separate[0] * separate[0] + separate[1] * separate[1]).sqrt();
    for (radius, inside) in radii.into_iter().zip(inside) {
        if !(radius > 0.0 && radius.is_finite()) || (inside && cr >= radius) {
            return Err(CalcError::new(
                format!(
                    "a cutter with radius {} does not fit into an arc with radius {}",
                    units.length(cr),
                    units.length(radius)
                ),
                "use a smaller cutter; radii are above zero",
            ));
        }
    }
    if !(distance > 0.0 && distance.is_finite()) {
        return Err(CalcError::new(
            "the arcs have the same centre: they do not cross",
            "give the distance from the first centre to the second",
        ));
    }
    let sign = |inside: bool| if inside { -1.0 } else { 1.0 };
    let offset = [radii[0] + sign(inside[0]) * cr, radii[1] + sign(inside[1]) * cr];
    let corner = cross(radii, distance)
        .ok_or_else(|| separation_error("the arcs", radii, distance, units))?;
    let center = cross(offset, distance).ok_or_else(|| {
        separation_error("the paths of the cutter's centre", offset, distance, units)
    })?;
    let turned = if side == TravelSide::Left { 1.0 } else { -1.0 };
    let angle = atan2(separate[1], separate[0]);
    let (du, dv) = (center.along - corner.along, turned * (center.across - corner.across));
    let (dx, dy) = (du * cos(angle) - dv * sin(angle), du * sin(angle) + dv * cos(angle));

    let mut worked = WorkedCalculation::new("Corner of two arcs", units);
    let n = |value: f64| units.number(value);
    let length = QuantityKind::Length;
    worked.input("CR", "cutter radius", length, cr);
    worked.input("R1", "radius of the first arc", length, radii[0]);
    worked.input("R2", "radius of the second arc", length, radii[1]);
    worked.input("D", "distance between the centres", length, distance);
    worked.input("φ", "direction from the first to the second", QuantityKind::Angle, angle);
    let mut circle = |marks: [&str; 2], names: [&str; 2], radii: [f64; 2], at: &CircleCrossing| {
        let [a, h] = marks;
        let (r1, r2, d) = (n(radii[0]), n(radii[1]), n(distance));
        let [n1, n2] = names;
        worked.intermediate(
            a,
            "along the line of the centres",
            length,
            at.along,
            &format!("({n1}² − {n2}² + D²)/(2·D)"),
            format!("({r1}² − {r2}² + {d}²)/(2·{d})"),
        );
        worked.intermediate(
            h,
            "across it",
            length,
            at.across,
            &format!("√({n1}² − {a}²)"),
            format!("√({r1}² − {}²)", factor(n(at.along))),
        );
    };
    circle(["a", "h"], ["R1", "R2"], radii, &corner);
    let name =
        |index: usize| format!("(R{} {} CR)", index + 1, if inside[index] { "−" } else { "+" });
    circle(["a'", "h'"], [&name(0), &name(1)], offset, &center);
    let (u, v, phi) = (factor(n(du)), factor(n(dv)), degrees(angle));
    let (u_path, v_path) = ("a' − a", if side == TravelSide::Left { "h' − h" } else { "h − h'" });
    worked.intermediate(
        "u",
        "along the centres, corner to cutter",
        length,
        du,
        u_path,
        format!("{} − {}", n(center.along), factor(n(corner.along))),
    );
    let (first, second) =
        if side == TravelSide::Left { (&center, &corner) } else { (&corner, &center) };
    worked.intermediate(
        "v",
        "left of them, corner to cutter",
        length,
        dv,
        v_path,
        format!("{} − {}", n(first.across), n(second.across)),
    );
    let text = format!("{u}·cos({phi}) − {v}·sin({phi})");
    worked.result(
        "ΔX",
        "from the corner to the cutter's centre",
        length,
        dx,
        "u·cos φ − v·sin φ",
        text,
    );
    let text = format!("{u}·sin({phi}) + {v}·cos({phi})");
    worked.result(
        "ΔY",
        "from the corner to the cutter's centre",
        length,
        dy,
        "u·sin φ + v·cos φ",
        text,
    );
    let place = |at: &CircleCrossing| {
        let (a, h) = (at.along, turned * at.across);
        Vec2::new(a * cos(angle) - h * sin(angle), a * sin(angle) + h * cos(angle))
    };
    worked.figure = draw(ask, place(&corner), place(&center), offset, units);
    Ok(worked)
}

fn cross(radii: [f64; 2], distance: f64) -> Option<CircleCrossing> {
    let [first, second] = radii;
    let along = ((first - second) * (first + second) + distance * distance) / (2.0 * distance);
    let square = (first - along) * (first + along);
    (first > 0.0 && second > 0.0 && square >= 0.0)
        .then(|| CircleCrossing { along, across: square.sqrt() })
}

fn separation_error(what: &str, radii: [f64; 2], distance: f64, units: AnswerUnit) -> CalcError {
    let [first, second] = radii;
    CalcError::new(
        format!(
            "{what} do not cross: radii {} and {}, centres {} apart",
            units.length(first),
            units.length(second),
            units.length(distance)
        ),
        format!(
            "the centres must be between {} and {} apart",
            units.length((first - second).abs()),
            units.length(first + second)
        ),
    )
}

/// The arcs near the corner, the cutter, and both distances.
fn draw(ask: &ArcArc, corner: Vec2, center: Vec2, offset: [f64; 2], units: AnswerUnit) -> Figure {
    let cr = ask.cutter_radius;
    let middles = [Vec2::ZERO, Vec2::new(ask.center_offset[0], ask.center_offset[1])];
    let mut figure = Figure::default();
    let arm = 3.5 * cr;
    for index in 0..2 {
        let (middle, other) = (middles[index], middles[1 - index]);
        // From the corner, each arc goes on where the cutter's side of the other arc is.
        let toward = ask.inside[1 - index];
        let path = |at: Vec2| {
            let from = at - middle;
            let ccw = from.turned_left().dot(other - at) > 0.0;
            if ccw == toward { 1.0 } else { -1.0 }
        };
        for (at, radius, style) in
            [(corner, ask.radii[index], LineStyle::Part), (center, offset[index], LineStyle::Path)]
        {
            let from = at - middle;
            let sweep = path(at) * (arm / radius).min(0.8 * PI);
            figure.arc(middle, radius, atan2(from.b, from.a), sweep, style);
        }
        let from = center - middle;
        let touch = middle + from * (ask.radii[index] / from.length().max(1e-300));
        figure.line(center, touch, LineStyle::Helper);
    }
    figure.circle(center, cr, LineStyle::Cutter);
    figure.point(corner, "P");
    figure.point(center, "C");
    let step = center - corner;
    let sign = |value: f64| if value < 0.0 { -1.0 } else { 1.0 };
    if step.a.abs() > 1e-6 * cr {
        let y = center.b + sign(step.b) * 1.45 * cr;
        figure.width(corner, center, y, format!("ΔX {}", units.number(step.a.abs())));
    }
    if step.b.abs() > 1e-6 * cr {
        let x = center.a + sign(step.a) * 1.45 * cr;
        figure.height(corner, center, x, format!("ΔY {}", units.number(step.b.abs())));
    }
    for (index, middle) in middles.into_iter().enumerate() {
        // A hint where the centres are, without drawing all the way there.
        let from = middle - corner;
        let far = from.length();
        let direction = from * (1.0 / far.max(1e-300));
        let reach = far.min(1.8 * cr);
        figure.line(corner, corner + direction * reach, LineStyle::Helper);
        figure.text(
            corner + direction * reach,
            format!("R{} {}", index + 1, units.number(ask.radii[index])),
        );
    }
    figure
}
