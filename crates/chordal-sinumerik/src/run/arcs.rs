//! Arcs: G2 and G3 by centre, radius or angle, CIP, CT; helices with TURN.

use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_geometry::{HalfCircleTolerance, TurnDirection, Vec2, center_from_radius};
use chordal_kernel::ArcWords;
use chordal_kernel::frames::InPlane;

use super::interpreter::Interpreter;
use super::motion::BlockTarget;
use super::run_state::PathMotion;
use super::words::{BlockStatementView, BlockWords, CENTER_NAMES};
use crate::syntax::ValueFunction;

/// Largest difference of the radii at start and end, mm (MD21000), and as a fraction of the radius (MD21010).
const RADIUS_DIFFERENCE_MM: f64 = 0.01;
const RADIUS_DIFFERENCE_FACTOR: f64 = 0.001;

/// Points closer than this are one, mm.
pub(super) const COINCIDENT_MM: f64 = 1e-6;

/// An arc of the plane in programmed coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlaneArc {
    pub(super) center: [f64; 2],
    pub(super) direction: TurnDirection,
}

impl Interpreter<'_> {
    /// Cuts an arc.
    pub(super) fn arc(
        &mut self,
        view: &BlockStatementView<'_>,
        range: TextRange,
        words: &BlockWords,
        target: &BlockTarget,
    ) {
        let (a, b, _) = self.kernel.state.plane.axes();
        let astray = self.kernel.state.astray;
        if astray.has(a) || astray.has(b) {
            // From an unknown place no arc can be told: its end is reached.
            return self.kernel.straight_instead(view, target.end, target.named);
        }
        let start = [target.start[a], target.start[b]];
        let end = [target.programmed[a], target.programmed[b]];
        if self.modes.motion == PathMotion::ThroughPoint
            && let Some(middle) = self.point_outside_plane(words, target)
        {
            return self.arc_in_space(view, range, middle, target);
        }
        let mut end_by_angle = None;
        let found = match self.modes.motion {
            PathMotion::Arc(direction) => {
                self.programmed_arc(range, words, direction, start, end, &mut end_by_angle)
            }
            PathMotion::ThroughPoint => self.arc_through_point(range, words, start, end),
            _ => self.tangent_arc(range, start, end),
        };
        let mut target = *target;
        if let Some(place) = end_by_angle {
            (target.programmed[a], target.programmed[b]) = (place[0], place[1]);
            let mapped = self.mapped(target.programmed);
            (target.end[a], target.end[b]) = (mapped[a], mapped[b]);
            target.named.insert(a);
            target.named.insert(b);
        }
        match found {
            Some(arc) => self.cut_arc(view, range, words, &target, &arc),
            None => self.kernel.straight_instead(view, target.end, target.named),
        }
    }

    /// G2 and G3.
    fn programmed_arc(
        &mut self,
        range: TextRange,
        words: &BlockWords,
        direction: TurnDirection,
        start: [f64; 2],
        end: [f64; 2],
        end_by_angle: &mut Option<[f64; 2]>,
    ) -> Option<PlaneArc> {
        let (a, b, normal) = self.kernel.state.plane.axes();
        let unit = self.unit_mm();
        if let Some(word) = words.centers[normal] {
            self.center_outside_plane(word.range, normal);
            return None;
        }
        let has_center = words.centers[a].is_some() || words.centers[b].is_some();
        if let Some(radius) = words.other("CR") {
            return self.arc_by_radius(radius.range, radius.value * unit, direction, start, end);
        }
        let center = [a, b].map(|axis| {
            let from = if axis == a { start[0] } else { start[1] };
            words.centers[axis].map_or(from, |word| match word.function {
                Some(ValueFunction::Absolute) => word.value * self.unit_of_axis(axis, &word),
                _ => from + word.value * unit,
            })
        });
        if let Some(angle) = words.other("AR") {
            if !(angle.value > 0.0 && angle.value < 360.0) {
                let message = format!(
                    "the angle of the arc is {}: it must be above 0 and below 360",
                    angle.value
                );
                self.alarm(14040, Code::BadWordValue, angle.range, message);
                return None;
            }
            let sweep = direction.sign() * angle.value.to_radians();
            if has_center {
                *end_by_angle = Some(turned_about(start, center, sweep));
                return Some(PlaneArc { center, direction });
            }
            return Some(PlaneArc { center: center_of_angle(start, end, sweep), direction });
        }
        if !has_center {
            let is_polar = words.other("AP").is_some() || words.other("RP").is_some();
            if is_polar {
                let pole = self.modes.pole;
                return Some(PlaneArc { center: [pole[a], pole[b]], direction });
            }
            let message = "the arc has neither a centre nor a radius nor an angle";
            self.alarm(14040, Code::NoCenter, range, message);
            return None;
        }
        self.fitted(range, PlaneArc { center, direction }, start, end)
    }

    /// A centre word of the axis that is not in the plane.
    fn center_outside_plane(&mut self, range: TextRange, normal: usize) {
        let letter = CENTER_NAMES[normal];
        let code = ["G19", "G18", "G17"][normal];
        let diagnostic = Diagnostic::new(
            Code::CenterOutsidePlane,
            self.span(range),
            format!("{letter} does not belong to the plane of {code}"),
        )
        .help("remove the word, or choose the plane with G17, G18 or G19");
        self.report_alarm(14040, diagnostic);
    }

    /// The arc with a centre on the bisector of the chord, if the radii agree within the tolerance of the control.
    fn fitted(
        &mut self,
        range: TextRange,
        arc: PlaneArc,
        start: [f64; 2],
        end: [f64; 2],
    ) -> Option<PlaneArc> {
        let [from, to] =
            [start, end].map(|place| (place[0] - arc.center[0]).hypot(place[1] - arc.center[1]));
        let allowed = RADIUS_DIFFERENCE_MM.max(RADIUS_DIFFERENCE_FACTOR * from);
        if from <= COINCIDENT_MM || (from - to).abs() > allowed {
            let [one, other, most] = [from, to, allowed].map(|mm| self.kernel.length_text(mm));
            let message = format!("the centre is {one} from the start and {other} from the end");
            let diagnostic = Diagnostic::new(Code::RadiusMismatch, self.span(range), message)
                .label(format!("at most {most} apart"))
                .help("check the end point and the centre");
            self.report_alarm(14040, diagnostic);
            return None;
        }
        let chord = [end[0] - start[0], end[1] - start[1]];
        let length = chord[0].hypot(chord[1]);
        if length <= COINCIDENT_MM || from == to {
            return Some(arc);
        }
        // The centre moves to the bisector, at the distance of the start, on its own side of the chord.
        let side = chord[0] * (arc.center[1] - start[1]) - chord[1] * (arc.center[0] - start[0]);
        let height = (from * from - length * length / 4.0).max(0.0).sqrt() * side.signum();
        let normal = [-chord[1] / length, chord[0] / length];
        let center = [0, 1].map(|axis| start[axis] + chord[axis] / 2.0 + normal[axis] * height);
        Some(PlaneArc { center, ..arc })
    }

    /// `CR=`.
    fn arc_by_radius(
        &mut self,
        range: TextRange,
        radius: f64,
        direction: TurnDirection,
        start: [f64; 2],
        end: [f64; 2],
    ) -> Option<PlaneArc> {
        let chord = [end[0] - start[0], end[1] - start[1]];
        let length = chord[0].hypot(chord[1]);
        if length <= COINCIDENT_MM {
            let message = "start and end are one point: a radius gives no circle";
            self.alarm(14040, Code::FullCircleByRadius, range, message);
            return None;
        }
        let plane = self.kernel.state.plane;
        let [from, to] = [start, end].map(|[a, b]| plane.point(Vec2::new(a, b), 0.0));
        let tolerance =
            HalfCircleTolerance { too_short_mm: 2.0 * RADIUS_DIFFERENCE_MM, too_long_mm: 0.0 };
        let found = center_from_radius(plane, from, to, radius, direction, tolerance);
        let Ok((along, across)) = found else {
            let [is, needed] = [radius.abs(), length / 2.0].map(|mm| self.kernel.length_text(mm));
            let message = format!(
                "start and end are further apart than a radius of {is} reaches: it must be {needed} or more"
            );
            self.alarm(14095, Code::RadiusTooShort, range, message);
            return None;
        };
        Some(PlaneArc { center: [along, across], direction })
    }

    /// CIP: the arc through the point of I1, J1, K1.
    fn arc_through_point(
        &mut self,
        range: TextRange,
        words: &BlockWords,
        start: [f64; 2],
        end: [f64; 2],
    ) -> Option<PlaneArc> {
        let (a, b, _) = self.kernel.state.plane.axes();
        let incremental = self.kernel.state.incremental;
        let middle = [(a, start[0]), (b, start[1])].map(|(axis, from)| {
            words.between[axis].map_or(from, |word| {
                word.coordinate(from, self.unit_of_axis(axis, &word), incremental)
            })
        });
        let Some(center) = center_through([start, middle, end]) else {
            self.alarm(14040, Code::NoCenter, range, "start, point between and end are on a line");
            return None;
        };
        let turn = cross(start, middle, end);
        let direction = if turn > 0.0 { TurnDirection::Ccw } else { TurnDirection::Cw };
        Some(PlaneArc { center, direction })
    }

    /// CT: the arc that begins in the direction of the move before.
    fn tangent_arc(
        &mut self,
        range: TextRange,
        start: [f64; 2],
        end: [f64; 2],
    ) -> Option<PlaneArc> {
        let (a, b, _) = self.kernel.state.plane.axes();
        let direction = self.modes.last_direction.map(|along| [along[a], along[b]]);
        let direction = direction.filter(|along| along[0].hypot(along[1]) > COINCIDENT_MM);
        let Some(along) = direction else {
            self.alarm(
                14045,
                Code::NoCenter,
                range,
                "no move in the plane before CT gives its tangent",
            );
            return None;
        };
        let length = along[0].hypot(along[1]);
        let normal = [-along[1] / length, along[0] / length];
        let chord = [end[0] - start[0], end[1] - start[1]];
        let across = chord[0] * normal[0] + chord[1] * normal[1];
        let ahead = chord[0] * along[0] + chord[1] * along[1];
        if across.abs() <= COINCIDENT_MM && ahead < 0.0 {
            let message =
                "the end lies straight behind the move before: no tangential arc leads there";
            self.alarm(14045, Code::NoCenter, range, message);
            return None;
        }
        if across.abs() <= COINCIDENT_MM {
            // The end lies on the tangent: the arc is a straight line.
            return None;
        }
        let radius = (chord[0] * chord[0] + chord[1] * chord[1]) / (2.0 * across);
        let center = [0, 1].map(|axis| start[axis] + normal[axis] * radius);
        let direction = if radius > 0.0 { TurnDirection::Ccw } else { TurnDirection::Cw };
        Some(PlaneArc { center, direction })
    }

    /// Emits an arc through the programmable frame.
    pub(super) fn cut_arc(
        &mut self,
        view: &BlockStatementView<'_>,
        range: TextRange,
        words: &BlockWords,
        target: &BlockTarget,
        arc: &PlaneArc,
    ) {
        let plane = self.kernel.state.plane;
        let (a, b, _) = plane.axes();
        let InPlane::Similar { mirrored, .. } = self.modes.frame.in_plane(plane) else {
            return self.chords_in_frame(view, range, words, target, arc);
        };
        let mut center = target.programmed;
        (center[a], center[b]) = (arc.center[0], arc.center[1]);
        let center = self.mapped(center);
        let direction = arc.direction.mirrored_if(mirrored);
        let programmed = words.other("TURN").map_or(0.0, |word| word.value.round());
        let turns = programmed.clamp(0.0, 999.0) as u32;
        if f64::from(turns) != programmed {
            self.alarm(14048, Code::BadWordValue, range, "TURN must be 0 to 999");
            return self.kernel.straight_instead(view, target.end, target.named);
        }
        let from = self.kernel.state.position;
        let radius = [from[a] - center[a], from[b] - center[b]];
        let sense = direction.sign();
        self.contour_begins([from[a], from[b]], [-radius[1] * sense, radius[0] * sense]);
        let words = ArcWords { direction, center: [Some(center[a]), Some(center[b])], turns };
        let mut end = target.end;
        self.kernel.snap_to_start(&mut end);
        self.kernel.arc_by_center(view, &words, end, target.named);
        self.remember_direction(&words, target);
    }

    /// The direction in which an arc ends, for CT.
    fn remember_direction(&mut self, arc: &ArcWords, target: &BlockTarget) {
        let (a, b, _) = self.kernel.state.plane.axes();
        let [Some(x), Some(y)] = arc.center else { return };
        let radius = [target.end[a] - x, target.end[b] - y];
        let sense = arc.direction.sign();
        let mut along = [0.0; 3];
        (along[a], along[b]) = (-radius[1] * sense, radius[0] * sense);
        self.modes.last_direction = Some(along);
    }
}

/// A point turned about a centre.
pub(super) fn turned_about(point: [f64; 2], center: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    let [x, y] = [point[0] - center[0], point[1] - center[1]];
    [center[0] + cos * x - sin * y, center[1] + sin * x + cos * y]
}

/// The centre of an arc by its ends and its angle, positive counterclockwise.
fn center_of_angle(start: [f64; 2], end: [f64; 2], sweep: f64) -> [f64; 2] {
    let chord = [end[0] - start[0], end[1] - start[1]];
    // Half the chord over the tangent of half the angle is the distance of the centre from the chord.
    let height = 1.0 / (2.0 * libm::tan(sweep / 2.0));
    [0, 1].map(|axis| {
        let normal = [-chord[1], chord[0]][axis];
        start[axis] + chord[axis] / 2.0 + normal * height
    })
}

/// Twice the area of a triangle; positive where it turns counterclockwise.
fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The centre of the circle through three points; `None` if they are on a line.
fn center_through([p, q, r]: [[f64; 2]; 3]) -> Option<[f64; 2]> {
    let area = cross(p, q, r);
    let [u, v] = [[q[0] - p[0], q[1] - p[1]], [r[0] - p[0], r[1] - p[1]]];
    let [u2, v2] = [u, v].map(|w| w[0] * w[0] + w[1] * w[1]);
    if area.abs() <= 1e-12 * (u2 * v2).sqrt().max(COINCIDENT_MM) {
        return None;
    }
    let x = (v[1] * u2 - u[1] * v2) / (2.0 * area);
    let y = (u[0] * v2 - v[0] * u2) / (2.0 * area);
    Some([p[0] + x, p[1] + y])
}
