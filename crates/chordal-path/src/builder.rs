//! Turns commands into segments of the path, all in one frame.

use chordal_command::{
    AxisMask, Command, CommandKind, Feed, FeedAlong, FeedMode, Move, Position, SpindleState,
    WorkName, WorkZero,
};
use chordal_geometry::{Curve, Line, ParamCurve, Transform, Vec3};
use chordal_kernel::rules::LengthRules;
use chordal_machine::{AXES, Machine, PerAxis};

use crate::frame::ProgramFrame;
use crate::rapid::rapid_corners;
use crate::segment::{
    NotNamed, Segment, SegmentKind, UnrelatedZero, curve_of, curves_of, is_known, point,
};
use crate::tip::{TipPlace, TipTracker};

/// The frame in which the path of a run is given: the work coordinate system of its first cut.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RunFrame {
    name: WorkName,
    zero: WorkZero,
    /// What is added to coordinates in this frame to get machine coordinates, mm.
    offset: Position,
    /// The axes for which that is known.
    known: AxisMask,
}

impl RunFrame {
    /// The frame of a run whose first cut is made in `frame`. `set_up` is the offset of its work coordinate system that
    /// the setup gives, mm, `None` per axis without one: what the program writes into the system later is a move
    /// relative to it.
    pub fn of_cut(frame: &ProgramFrame, set_up: PerAxis<Option<f64>>) -> RunFrame {
        let zero = &frame.zero;
        let offset = std::array::from_fn(|axis| match set_up[axis] {
            // Only the preset says where the zero of this axis is.
            _ if zero.unknown_presets.axes.has(axis) => frame.work[axis],
            Some(value) => value,
            None => zero.system[axis],
        });
        let known =
            AxisMask::with_values(&set_up).or(zero.system_known).without(zero.unknown_presets.axes);
        RunFrame { name: frame.name, zero: *zero, offset, known }
    }

    /// What is added to a coordinate in this frame to get that of the machine, mm; `None` where it is not known.
    pub fn offset(&self, axis: usize) -> Option<f64> {
        self.known.has(axis).then_some(self.offset[axis])
    }

    /// The shift from the program coordinates of another frame to this one, mm: zero along the axes for which it is not
    /// known. Also those axes, with the reason; `None` if there are none.
    fn shift_of(&self, frame: &ProgramFrame) -> (Vec3, Option<UnrelatedZero>) {
        let same_system = frame.name == self.name;
        let mut axes = AxisMask::NONE;
        let mut along = |axis: usize| {
            if frame.zero.relation_is_known(&self.zero, same_system, axis) {
                return frame.work[axis] - self.offset[axis];
            }
            axes.insert(axis);
            0.0
        };
        let shift = Vec3::new(along(0), along(1), along(2));
        let [own, of_run] = [&frame.zero, &self.zero].map(|zero| zero.unknown_presets.axes);
        let unrelated = (axes != AxisMask::NONE).then_some(UnrelatedZero {
            axes,
            system: frame.name,
            run_system: self.name,
            is_preset: own.or(of_run).and(axes) != AxisMask::NONE,
        });
        (shift, unrelated)
    }
}

/// Turns commands into segments in one frame: the work coordinate system of the first cut.
/// Moves under another work offset, a shift or a preset are shifted to where they lie in that frame.
#[derive(Debug)]
pub struct PathBuilder<'a> {
    machine: &'a Machine,
    frame: ProgramFrame,
    run_frame: Option<RunFrame>,
    /// The shift from the active program coordinates to the frame of the run, mm, and why it is not known along some
    /// axes.
    shift: (Vec3, Option<UnrelatedZero>),
    /// From program coordinates to the work coordinate system in a tilted plane; `None` without one.
    plane: Option<Transform>,
    tool: u32,
    tip: TipTracker,
    /// The speed of the spindle, 1/min; 0 while it does not turn.
    rpm: f64,
    not_named: NotNamedTracker,
}

/// Finds, move by move, the axes that the program does not name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum NotNamedTracker {
    /// They were found before the run.
    Found(NotNamed),
    /// The run was not searched in advance. Z counts as not named in a cut as long as no move has named Z.
    SoFar(PlanarStart),
}

impl NotNamedTracker {
    /// Follows a move and returns the axes that are drawn at zero in it.
    fn follow(&mut self, motion: &Move, cuts: bool) -> NotNamed {
        match self {
            NotNamedTracker::Found(NotNamed { never, in_no_cut }) => {
                let mut remaining = in_no_cut.without(motion.from_known.or(motion.to_known));
                (0..3).filter(|axis| motion.from[*axis] != motion.to[*axis]).for_each(|axis| {
                    remaining.remove(axis);
                });
                NotNamed { never: *never, in_no_cut: remaining }
            }
            NotNamedTracker::SoFar(flat) => match flat.follow(motion, cuts) {
                true => {
                    NotNamed { never: AxisMask::LINEAR.without(AxisMask::XY), ..NotNamed::NONE }
                }
                false => NotNamed::NONE,
            },
        }
    }
}

/// Whether a program has moved only X and Y so far.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum PlanarStart {
    /// Z has not moved, and nothing was cut.
    Open,
    /// Z has not moved, and something was cut.
    Cut,
    /// Z has moved, or its position is known.
    No,
}

impl PlanarStart {
    /// Follows a move; true if it is drawn in a plane although its height is not known.
    fn follow(&mut self, motion: &Move, cuts: bool) -> bool {
        let both = motion.from_known.and(motion.to_known);
        if motion.from_known.or(motion.to_known).has(2) || motion.from[2] != motion.to[2] {
            *self = PlanarStart::No;
        }
        let is_flat = both.covers(AxisMask::XY)
            && *self != PlanarStart::No
            && (cuts || *self == PlanarStart::Cut);
        if is_flat {
            *self = PlanarStart::Cut;
        }
        is_flat
    }
}

impl<'a> PathBuilder<'a> {
    /// A builder for one run. `offset` and `known` come from [`initial_offset`](chordal_gcode::initial_offset).
    pub fn new(machine: &'a Machine, offset: Position, known: AxisMask) -> PathBuilder<'a> {
        PathBuilder {
            tip: TipTracker::new(machine, LengthRules::ABSENT, known),
            machine,
            frame: ProgramFrame::new(offset, known),
            run_frame: None,
            shift: (Vec3::ZERO, None),
            plane: None,
            tool: 0,
            rpm: 0.0,
            not_named: NotNamedTracker::SoFar(PlanarStart::Open),
        }
    }

    /// Draws the tip of a tool where the machine puts it, not where the program assumes it to be.
    pub fn with_tool_lengths(self, lengths: LengthRules) -> PathBuilder<'a> {
        let tip = TipTracker::new(self.machine, lengths, self.frame.known);
        PathBuilder { tip, ..self }
    }

    /// Sets the work coordinate system that is active when the run begins.
    pub fn in_system(self, name: WorkName) -> PathBuilder<'a> {
        PathBuilder { frame: self.frame.in_system(name), ..self }
    }

    /// Sets the frame of the run, if it is known before its first cut: then the moves before that cut are drawn in the
    /// same frame.
    pub fn in_run_frame(mut self, run_frame: Option<RunFrame>) -> PathBuilder<'a> {
        self.run_frame = run_frame;
        self.place();
        self
    }

    /// Sets the axes that the program does not name, if they are known before the run.
    pub fn without_names(mut self, axes: Option<NotNamed>) -> PathBuilder<'a> {
        if let Some(axes) = axes {
            self.not_named = NotNamedTracker::Found(axes);
        }
        self
    }

    /// The relation between program and machine coordinates after the last command.
    pub fn frame(&self) -> &ProgramFrame {
        &self.frame
    }

    /// From work coordinates to the frame of the run, mm.
    pub fn shift_to_run(&self) -> Vec3 {
        self.shift.0
    }

    /// Follows a command and passes its segments to `push`.
    pub fn command(&mut self, command: &Command, mut push: impl FnMut(&Segment)) {
        if let CommandKind::Tool { number } | CommandKind::ToolNumber { number } = command.kind {
            self.tool = number;
        }
        if let CommandKind::Spindle { state, rpm } = command.kind {
            let turns = matches!(state, SpindleState::Cw | SpindleState::Ccw);
            self.rpm = if turns { rpm } else { 0.0 };
        }
        self.tip.follow(command, self.machine);
        if self.frame.follow(command) {
            let frame = self.frame.part_frame.as_ref();
            self.plane = frame.filter(|frame| !frame.is_level()).map(|frame| frame.plane);
            return self.place();
        }
        let Some(motion) = command.kind.motion() else { return };
        let cuts = command.kind.feed().is_some();
        let not_named = self.not_named.follow(motion, cuts);
        let mut push = |segment: &Segment| match not_named {
            NotNamed::NONE => push(segment),
            not_named => push(&Segment { not_named, ..*segment }),
        };
        let shift = to_zero(self.shift(cuts), motion, not_named.all());
        match &command.kind {
            CommandKind::Rapid { motion, path } => {
                let mut at = motion.from;
                rapid_corners(self.machine, *path, &motion.from, &motion.to, |corner, time| {
                    let line = Curve::Line(Line { start: point(&at), end: point(corner) });
                    let mut segment =
                        self.segment(SegmentKind::Rapid, line, shift, command, motion, time);
                    segment.rotary_from = [at[3], at[4], at[5]];
                    segment.rotary_to = [corner[3], corner[4], corner[5]];
                    push(&segment);
                    at = *corner;
                });
            }
            CommandKind::Spline { motion, feed, .. } => {
                let mut curves = Vec::new();
                curves_of(&command.kind, |curve| curves.push(curve));
                let whole: f64 = curves.iter().map(ParamCurve::length).sum();
                for curve in curves {
                    let share = if whole > 0.0 { curve.length() / whole } else { 0.0 };
                    let time = match feed.mode {
                        FeedMode::InverseTime => duration_s(feed, motion, &curve) * share,
                        FeedMode::PerTime | FeedMode::PerRevolution => {
                            duration_s(feed, motion, &curve)
                        }
                    };
                    push(&self.segment(SegmentKind::Spline, curve, shift, command, motion, time));
                }
            }
            kind => {
                let curve = curve_of(motion, kind.shape());
                let time = match kind.feed() {
                    Some(feed) => duration_s(feed, motion, &curve),
                    None => 0.0,
                };
                let segment_kind = match kind {
                    CommandKind::Arc { .. } => SegmentKind::Arc,
                    CommandKind::Spiral { .. } => SegmentKind::Spiral,
                    _ => SegmentKind::Line,
                };
                push(&self.segment(segment_kind, curve, shift, command, motion, time));
            }
        }
    }

    /// The shift from the active program coordinates to the frame of the run, mm.
    fn shift(&mut self, cuts: bool) -> Vec3 {
        match self.tip.place() {
            TipPlace::Shifted(by) => self.shift_of_frame(cuts) + by,
            _ => self.shift_of_frame(cuts),
        }
    }

    fn shift_of_frame(&mut self, cuts: bool) -> Vec3 {
        if cuts && self.run_frame.is_none() {
            self.run_frame = Some(RunFrame::of_cut(&self.frame, [None; AXES]));
            self.place();
        }
        self.shift.0
    }

    fn place(&mut self) {
        if let Some(run_frame) = &self.run_frame {
            self.shift = run_frame.shift_of(&self.frame);
        }
    }

    #[inline]
    fn segment(
        &self,
        kind: SegmentKind,
        curve: Curve,
        shift: Vec3,
        command: &Command,
        motion: &Move,
        duration_s: f64,
    ) -> Segment {
        let moved = shift != Vec3::ZERO;
        let curve = match &self.plane {
            Some(plane) => curve.transformed(plane),
            None => curve,
        };
        let curve = if moved { curve.transformed(&Transform::translation(shift)) } else { curve };
        Segment {
            kind,
            length_mm: curve.length(),
            curve,
            duration_s,
            rotary_from: [motion.from[3], motion.from[4], motion.from[5]],
            rotary_to: [motion.to[3], motion.to[4], motion.to[5]],
            tool: self.tool,
            rpm: self.rpm,
            known: is_known(motion),
            from_known: motion.from_known,
            to_known: motion.to_known,
            tip_known: !matches!(self.tip.place(), TipPlace::Unknown(_)),
            unrelated_zero: self.shift.1,
            not_named: NotNamed::NONE,
            on_part: self.frame.part_frame.is_some(),
            origin: command.origin,
        }
    }
}

/// The shift of a move, mm, with the axes in `axes`, which the program does not name, brought to zero.
fn to_zero(shift: Vec3, motion: &Move, axes: AxisMask) -> Vec3 {
    if axes == AxisMask::NONE {
        return shift;
    }
    let by = shift.to_array();
    let along = |axis: usize| if axes.has(axis) { -motion.from[axis] } else { by[axis] };
    Vec3::new(along(0), along(1), along(2))
}

/// How long a cutting move takes at its programmed feed, without acceleration, s. 0 without a feed, and for a feed per
/// revolution while the spindle does not turn.
pub fn duration_s(feed: &Feed, motion: &Move, curve: &Curve) -> f64 {
    let positive = feed.value > 0.0;
    if !positive {
        return 0.0;
    }
    // Cuts whose spindle stands take no time, as those without a feed.
    if feed.surface.is_some_and(|surface| surface.mm_per_s <= 0.0) {
        return 0.0;
    }
    if feed.surface.is_some()
        && let Some(seconds) = crate::surface::surface_time(feed, curve)
    {
        // A limit of 0 leaves the spindle standing, too.
        return if seconds.is_finite() { seconds } else { 0.0 };
    }
    let length = match (feed.along, curve) {
        (FeedAlong::Path, _) => curve.length(),
        (FeedAlong::AllAxes(rotary), _) => rotary.vector_mm(curve.length(), motion),
        (FeedAlong::Plane, Curve::Arc(arc)) => (arc.radius * arc.sweep).abs(),
        (FeedAlong::Plane, Curve::Spiral(spiral)) => {
            let flat = chordal_geometry::Spiral { rise: 0.0, ..*spiral };
            flat.length()
        }
        (FeedAlong::Plane, Curve::Line(line)) => line.length(),
        (FeedAlong::Plane, Curve::Spline(piece)) => piece.length(),
    };
    match feed.mode {
        FeedMode::InverseTime => 1.0 / feed.value,
        FeedMode::PerRevolution if feed.spindle_rev_per_s > 0.0 => {
            length / (feed.value * feed.spindle_rev_per_s)
        }
        FeedMode::PerRevolution => 0.0,
        FeedMode::PerTime if length > 0.0 => length / feed.value,
        FeedMode::PerTime => {
            // Only rotary axes move: the feed is an angle per time.
            motion.turn_rad() / feed.value
        }
    }
}
