//! What the writers of commands say about a move in addition to its ends.

use chordal::Job;
use chordal::control::{ArcShape, CompensationSide, Feed, FeedAlong, FeedMode, Move, SpindleState};
use chordal::geometry::{Curve, ParamCurve, Plane, Spiral, Spline};
use chordal::machine::{AXIS_LETTERS, PerAxis};
use chordal::path::curve_of;

/// A feed in the unit of [`PathFeed::per_minute`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PathFeed {
    /// mm/min; deg/min when only rotary axes move. NaN when there is none.
    pub per_minute: f64,
    /// True when only rotary axes move.
    pub rotary: bool,
}

/// The exact curve of a move and its length, mm.
pub(crate) fn curve_and_length(motion: &Move, shape: Option<&ArcShape>) -> (Curve, f64) {
    let curve = curve_of(motion, shape);
    let length = curve.length();
    (curve, length)
}

/// How exact the length of a spline is that has no closed form, mm: below what is written.
const LENGTH_MM: f64 = 1e-9;

/// The length that a spline is written with, mm.
pub(crate) fn spline_length(curve: &Spline) -> f64 {
    curve.length(LENGTH_MM)
}

/// The feed along the path of a spline, mm/min.
pub(crate) fn spline_feed(feed: &Feed, length_mm: f64) -> f64 {
    60.0 * match feed.mode {
        FeedMode::PerTime => feed.value,
        FeedMode::InverseTime => feed.value * length_mm,
        FeedMode::PerRevolution => feed.value * feed.spindle_rev_per_s,
    }
}

/// The feed along the path whatever F counts.
pub(crate) fn path_feed(feed: &Feed, motion: &Move, curve: &Curve, length_mm: f64) -> PathFeed {
    let turn = motion.turn_rad();
    // A move that stands still but for its rotary axes is measured by their angle.
    let rotary = length_mm == 0.0 && turn > 0.0;
    let course =
        if rotary { turn.to_degrees() } else { measured_length(feed.along, curve, length_mm) };
    // The path is slower than F where F counts rotary axes too.
    let share = match feed.along {
        FeedAlong::AllAxes(counted) if !rotary => length_mm / counted.vector_mm(length_mm, motion),
        _ => 1.0,
    };
    let per_second = match feed.mode {
        FeedMode::PerTime if rotary => feed.value.to_degrees(),
        FeedMode::PerTime => feed.value * share,
        FeedMode::InverseTime => feed.value * course,
        FeedMode::PerRevolution => feed.value * feed.spindle_rev_per_s * share,
    };
    PathFeed { per_minute: per_second * 60.0, rotary }
}

/// The length that F counts.
fn measured_length(along: FeedAlong, curve: &Curve, length_mm: f64) -> f64 {
    match (along, curve) {
        (FeedAlong::Plane, Curve::Arc(arc)) => (arc.radius * arc.sweep).abs(),
        (FeedAlong::Plane, Curve::Spiral(spiral)) => Spiral { rise: 0.0, ..*spiral }.length(),
        _ => length_mm,
    }
}

/// The plane's word.
pub(crate) const fn plane_word(plane: Plane) -> &'static str {
    match plane {
        Plane::Xy => "xy",
        Plane::Zx => "zx",
        Plane::Yz => "yz",
    }
}

/// The sense of turning as a word.
pub(crate) const fn direction_word(sweep: f64) -> &'static str {
    if sweep < 0.0 { "cw" } else { "ccw" }
}

/// What F counts, as a word.
pub(crate) const fn feed_mode_word(mode: FeedMode) -> &'static str {
    match mode {
        FeedMode::PerTime => "per_time",
        FeedMode::InverseTime => "inverse_time",
        FeedMode::PerRevolution => "per_revolution",
    }
}

/// What the spindle does, as a word.
pub(crate) const fn spindle_word(state: SpindleState) -> &'static str {
    match state {
        SpindleState::Off => "off",
        SpindleState::Cw => "cw",
        SpindleState::Ccw => "ccw",
        SpindleState::Oriented => "oriented",
    }
}

/// The side of cutter compensation.
pub(crate) const fn side_word(side: CompensationSide) -> &'static str {
    match side {
        CompensationSide::Off => "off",
        CompensationSide::Left => "left",
        CompensationSide::Right => "right",
    }
}

/// How places of a program are written: mm, the diameter on an axis that is programmed so, and degrees.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PositionScale {
    factors: PerAxis<f64>,
}

impl PositionScale {
    pub(crate) fn of(job: &Job) -> PositionScale {
        PositionScale { factors: job.machine().written_factors() }
    }

    /// A place of an axis.
    #[inline]
    pub(crate) fn place(&self, axis: usize, value: f64) -> f64 {
        if axis < 3 { value * self.factors[axis] } else { value.to_degrees() }
    }

    /// The centre of an arc.
    pub(crate) fn center(&self, shape: &ArcShape) -> [f64; 2] {
        let (first, second, _) = shape.plane.axes();
        [self.place(first, shape.center[0]), self.place(second, shape.center[1])]
    }

    /// The letters of the axes that are written as diameters; empty on a mill.
    pub(crate) fn diameters(&self) -> String {
        let written = AXIS_LETTERS.chars().zip(self.factors);
        written.filter(|(_, factor)| *factor != 1.0).map(|(letter, _)| letter).collect()
    }
}
