//! Arcs that are no circles of a plane of the machine: they are cut in chords, and the run is not verified from there on.

use std::f64::consts::TAU;

use chordal_command::AxisMask;
use chordal_diagnostics::{Code, TextRange};
use chordal_geometry::{Arc, ParamCurve, Vec3};

use super::arcs::{COINCIDENT_MM, PlaneArc, turned_about};
use super::interpreter::Interpreter;
use super::motion::BlockTarget;
use super::words::{BlockStatementView, BlockWords};

/// How far the chords of an arc may be off it where no circle of the machine's planes is possible, mm.
const CHORD_DEVIATION_MM: f64 = 0.001;

/// Chords of an arc at most.
const MAX_CHORDS: f64 = 100_000.0;

/// A smaller angle between the ends of an arc is none: the arc is a full circle, rad.
const FULL_CIRCLE_RAD: f64 = 1e-9;

impl Interpreter<'_> {
    /// An arc in a frame that tilts or distorts its plane: no circle of a plane of the machine, so it is cut in chords.
    pub(super) fn chords_in_frame(
        &mut self,
        view: &BlockStatementView<'_>,
        range: TextRange,
        words: &BlockWords,
        target: &BlockTarget,
        arc: &PlaneArc,
    ) {
        self.lose_path(range, "the exact path", "the arc outside of the machine's planes");
        let (a, b, normal) = self.kernel.state.plane.axes();
        let start = [target.start[a], target.start[b]];
        let [x, y] = [start[0] - arc.center[0], start[1] - arc.center[1]];
        let end = [target.programmed[a] - arc.center[0], target.programmed[b] - arc.center[1]];
        let radius_mm = x.hypot(y);
        let sense = arc.direction.sign();
        let least = sense * (libm::atan2(end[1], end[0]) - libm::atan2(y, x));
        let turns = words.other("TURN").map_or(0.0, |word| word.value.round().clamp(0.0, 999.0));
        let mut sweep = least.rem_euclid(TAU);
        if sweep < FULL_CIRCLE_RAD {
            sweep = TAU;
        }
        sweep += turns * TAU;
        let rise = target.programmed[normal] - target.start[normal];
        let point = |part: f64| {
            let mut place = target.programmed;
            [place[a], place[b]] = turned_about(start, arc.center, sense * sweep * part);
            place[normal] = target.start[normal] + rise * part;
            place
        };
        self.cut_chords(view, target, chord_count(radius_mm, sweep), point);
    }

    /// Cuts a number of chords to the end of a block; `point` gives the programmed coordinates, mm, of a part of the way.
    fn cut_chords(
        &mut self,
        view: &BlockStatementView<'_>,
        target: &BlockTarget,
        count: u32,
        point: impl Fn(f64) -> [f64; 3],
    ) {
        for number in 1..=count {
            let part = f64::from(number) / f64::from(count);
            let place = if number < count { point(part) } else { target.programmed };
            let end = self.mapped(place);
            self.kernel.straight(view, end, target.named.or(AxisMask::LINEAR));
        }
        self.modes.last_direction = None;
    }

    /// The point between of CIP, programmed coordinates, mm, if the arc leaves the plane; `None` if it stays in it.
    pub(super) fn point_outside_plane(
        &self,
        words: &BlockWords,
        target: &BlockTarget,
    ) -> Option<[f64; 3]> {
        let (_, _, normal) = self.kernel.state.plane.axes();
        let incremental = self.kernel.state.incremental;
        let middle = std::array::from_fn(|axis| {
            let start = target.start[axis];
            words.between[axis].map_or(start, |word| {
                word.coordinate(start, self.unit_of_axis(axis, &word), incremental)
            })
        });
        let level = target.start[normal];
        let leaves = |point: &[f64; 3]| (point[normal] - level).abs() > COINCIDENT_MM;
        (leaves(&middle) || leaves(&target.programmed)).then_some(middle)
    }

    /// CIP through three points of space.
    pub(super) fn arc_in_space(
        &mut self,
        view: &BlockStatementView<'_>,
        range: TextRange,
        middle: [f64; 3],
        target: &BlockTarget,
    ) {
        let vector = |[x, y, z]: [f64; 3]| Vec3::new(x, y, z);
        let (start, end) = (vector(target.start), vector(target.programmed));
        let middle = vector(middle);
        let is_bent = (middle - start).cross(end - start).length() > COINCIDENT_MM;
        let Some(arc) = Arc::through(start, middle, end).filter(|_| is_bent) else {
            self.alarm(14040, Code::NoCenter, range, "start, point between and end are on a line");
            return self.kernel.straight_instead(view, target.end, target.named);
        };
        self.lose_path(range, "the exact path", "the arc outside of the machine's planes");
        let point = |part: f64| {
            let point = arc.point_at(arc.length() * part);
            [point.x, point.y, point.z]
        };
        self.cut_chords(view, target, chord_count(arc.radius, arc.sweep), point);
    }
}

/// How many chords an arc gets: that of an angle t is r (1 - cos t/2) off it.
fn chord_count(radius_mm: f64, sweep: f64) -> u32 {
    let step = 2.0 * libm::acos((1.0 - CHORD_DEVIATION_MM / radius_mm).clamp(-1.0, 1.0));
    (sweep / step).ceil().clamp(1.0, MAX_CHORDS) as u32
}
