//! Commands as the canonical text that LinuxCNC's own interpreter prints.

use std::f64::consts::TAU;
use std::io::{self, Write};

use chordal::control::SurfaceShape;
use chordal::control::{
    ArcShape, CompensationSide, Coolant, Feed, FeedMode, Move, Overrides, PathMode, Position,
    SpindleState, Units, WorkName,
};
use chordal::diagnostics::FileId;
use chordal::geometry::{Plane, Spline};
use chordal::machine::PerAxis;
use chordal::{Command, CommandKind, Job, SourceMap};

use self::turn::CoordinateRotation;
use crate::number::{push_fixed, push_integer};

mod turn;

/// Radii that differ by more are not one arc, mm: below what is written.
const EQUAL_RADIUS_MM: f64 = 1e-6;

/// Writes commands in the canonical text of LinuxCNC (`rs274 -g`): one call a line, in mm,
/// degrees and minutes, after the line of the program it comes from.
///
/// A spline is `NURBS_FEED` with its order, then X, Y and weight of each control point.
/// Arcs between different radii have no canonical form. They are written as `ARC_FEED` with
/// both radii in a comment.
///
/// A place is as the program has it: the machine is at its sum with `SET_G92_OFFSET`, turned by `SET_XY_ROTATION`
/// about zero, and moved by `SET_G5X_OFFSET` and `USE_TOOL_LENGTH_OFFSET`.
#[derive(Debug)]
pub struct CanonWriter<'a, W> {
    out: W,
    line: Vec<u8>,
    sources: &'a SourceMap<'a>,
    feed_per_minute: f64,
    plane: Plane,
    coolant: Coolant,
    rpm: f64,
    work: Option<(WorkName, Position)>,
    turn: CoordinateRotation,
}

impl<'a, W: Write> CanonWriter<'a, W> {
    /// Writes the header: comments and the units.
    ///
    /// # Errors
    /// Those of the output.
    pub fn new(mut out: W, job: &'a Job<'a>) -> io::Result<Self> {
        let name = job.sources().get(FileId(0)).map_or("", |source| source.name());
        writeln!(out, "; {}", one_line(name))?;
        writeln!(out, "; machine {}, in mm, deg, mm/min", one_line(&job.machine().name))?;
        writeln!(out, "N0 USE_LENGTH_UNITS(CANON_UNITS_MM)")?;
        Ok(Self {
            out,
            line: Vec::with_capacity(256),
            sources: job.sources(),
            feed_per_minute: f64::NAN,
            plane: job.rules().starts_in,
            coolant: Coolant::default(),
            rpm: 0.0,
            work: None,
            turn: CoordinateRotation::default(),
        })
    }

    /// Writes a command.
    ///
    /// # Errors
    /// Those of the output.
    pub fn command(&mut self, command: &Command) -> io::Result<()> {
        let line = command.origin.line;
        match &command.kind {
            CommandKind::Rapid { motion, .. } => self.straight(line, "STRAIGHT_TRAVERSE", motion),
            CommandKind::Line { motion, feed } => {
                self.feed(line, feed);
                self.straight(line, "STRAIGHT_FEED", motion);
            }
            CommandKind::Arc { motion, shape, feed }
            | CommandKind::Spiral { motion, shape, feed } => {
                self.feed(line, feed);
                self.select_plane(line, shape.plane);
                self.arc(line, &motion.to, shape);
            }
            CommandKind::Spline { motion, curve, feed } => {
                self.feed(line, feed);
                match self.turn.upright_arc(curve) {
                    Some((end, shape)) => {
                        self.select_plane(line, shape.plane);
                        let [x, y, z] = end.to_array();
                        let [_, _, _, a, b, c] = motion.to;
                        self.arc_of(line, &[x, y, z, a, b, c], &shape);
                    }
                    None => self.spline(line, curve),
                }
            }
            CommandKind::Plane(plane) => self.select_plane(line, *plane),
            CommandKind::Spindle { state, rpm } => self.spindle(line, *state, *rpm),
            CommandKind::Coolant(coolant) => self.coolant(line, *coolant),
            CommandKind::WorkOffset { name, offset, zero, turned, .. } => {
                self.work_offset(line, *name, offset, &zero.system, *turned);
            }
            CommandKind::Message(range) => {
                let words = self.sources.words(range.in_file(command.origin.span.file));
                self.plain(line, &format!("MESSAGE(\"{}\")", one_line(&words)));
            }
            CommandKind::Output { text } => {
                self.plain(line, &format!("PRINT(\"{}\")", one_line(text)));
            }
            CommandKind::FeedMode(mode) => self.feed_mode(line, *mode),
            // The feed is written where it is used, in mm/min; the units are always mm.
            CommandKind::FeedRate { .. } => {}
            // What moves nothing and no rule of the path knows is for who compares programs.
            CommandKind::Effect(_) => {}
            CommandKind::Units(units) => {
                let word = if *units == Units::Inch { "inches" } else { "millimetres" };
                self.plain(line, &format!("COMMENT(\"units of the program: {word}\")"));
            }
            other => {
                if let Some(text) = simple(other) {
                    self.plain(line, &text);
                }
            }
        }
        self.out.write_all(&self.line)?;
        self.line.clear();
        Ok(())
    }

    /// Writes what is left and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(mut self) -> io::Result<W> {
        self.out.flush()?;
        Ok(self.out)
    }

    fn begin(&mut self, line: u32) {
        self.line.push(b'N');
        push_integer(&mut self.line, line.into());
        self.line.push(b' ');
    }

    fn plain(&mut self, line: u32, text: &str) {
        self.begin(line);
        self.line.extend_from_slice(text.as_bytes());
        self.line.push(b'\n');
    }

    fn straight(&mut self, line: u32, name: &str, motion: &Move) {
        self.begin(line);
        self.line.extend_from_slice(name.as_bytes());
        self.line.push(b'(');
        let to = self.turn.before(&motion.to);
        self.numbers(&canonical(&to));
        self.line.extend_from_slice(b")\n");
    }

    fn numbers(&mut self, values: &[f64]) {
        for (index, value) in values.iter().enumerate() {
            if index > 0 {
                self.line.extend_from_slice(b", ");
            }
            push_fixed(&mut self.line, *value);
        }
    }

    fn arc(&mut self, line: u32, to: &Position, shape: &ArcShape) {
        let before = self.turn.arc_before(to, shape);
        let to = self.turn.before(to);
        self.arc_of(line, &to, &before);
    }

    /// An arc as the program has it.
    fn arc_of(&mut self, line: u32, to: &Position, shape: &ArcShape) {
        let (first, second, normal) = shape.plane.axes();
        let to = canonical(to);
        self.begin(line);
        self.line.extend_from_slice(b"ARC_FEED(");
        self.numbers(&[to[first], to[second], shape.center[0], shape.center[1]]);
        self.line.extend_from_slice(format!(", {}, ", rotation(shape.sweep)).as_bytes());
        self.numbers(&[to[normal], to[3], to[4], to[5]]);
        self.line.push(b')');
        if (shape.radius_from - shape.radius_to).abs() > EQUAL_RADIUS_MM {
            self.line.extend_from_slice(b" ; radius ");
            push_fixed(&mut self.line, shape.radius_from);
            self.line.extend_from_slice(b" to ");
            push_fixed(&mut self.line, shape.radius_to);
        }
        self.line.push(b'\n');
    }

    /// Order, then X, Y and weight of each control point.
    fn spline(&mut self, line: u32, curve: &Spline) {
        self.begin(line);
        self.line.extend_from_slice(format!("NURBS_FEED({}", curve.order()).as_bytes());
        for (point, weight) in curve.points().iter().zip(curve.weights()) {
            self.line.extend_from_slice(b", ");
            let point = self.turn.point_before(*point);
            self.numbers(&[point.x, point.y, *weight]);
        }
        self.line.extend_from_slice(b")\n");
    }

    fn feed(&mut self, line: u32, feed: &Feed) {
        let per_minute = match feed.mode {
            FeedMode::PerTime | FeedMode::InverseTime => feed.value * 60.0,
            FeedMode::PerRevolution => feed.value,
        };
        let changed = per_minute != self.feed_per_minute;
        if per_minute.is_finite() && changed {
            self.feed_per_minute = per_minute;
            self.begin(line);
            self.line.extend_from_slice(b"SET_FEED_RATE(");
            self.numbers(&[per_minute]);
            self.line.extend_from_slice(b")\n");
        }
    }

    fn feed_mode(&mut self, line: u32, mode: FeedMode) {
        self.feed_per_minute = f64::NAN;
        self.plain(
            line,
            match mode {
                FeedMode::PerTime => "SET_FEED_MODE(0)",
                FeedMode::InverseTime => "SET_FEED_MODE(1)",
                FeedMode::PerRevolution => "SET_FEED_MODE(2)",
            },
        );
    }

    fn select_plane(&mut self, line: u32, plane: Plane) {
        if plane == self.plane {
            return;
        }
        self.plane = plane;
        self.plain(
            line,
            match plane {
                Plane::Xy => "SELECT_PLANE(CANON_PLANE_XY)",
                Plane::Zx => "SELECT_PLANE(CANON_PLANE_XZ)",
                Plane::Yz => "SELECT_PLANE(CANON_PLANE_YZ)",
            },
        );
    }

    fn spindle(&mut self, line: u32, state: SpindleState, rpm: f64) {
        let changed = rpm != self.rpm;
        if changed && rpm.is_finite() {
            self.rpm = rpm;
            self.begin(line);
            self.line.extend_from_slice(b"SET_SPINDLE_SPEED(");
            self.numbers(&[rpm]);
            self.line.extend_from_slice(b")\n");
        }
        self.plain(
            line,
            match state {
                SpindleState::Off => "STOP_SPINDLE_TURNING()",
                SpindleState::Cw => "START_SPINDLE_CLOCKWISE()",
                SpindleState::Ccw => "START_SPINDLE_COUNTERCLOCKWISE()",
                SpindleState::Oriented => "ORIENT_SPINDLE(0.000000, CANON_CLOCKWISE)",
            },
        );
    }

    fn coolant(&mut self, line: u32, coolant: Coolant) {
        let before = std::mem::replace(&mut self.coolant, coolant);
        let valves = [
            (before.mist, coolant.mist, "MIST"),
            (before.flood, coolant.flood, "FLOOD"),
            (before.through_tool, coolant.through_tool, "THROUGH_TOOL"),
        ];
        for (was, is, name) in valves {
            if was != is {
                self.plain(line, &format!("{name}_{}()", if is { "ON" } else { "OFF" }));
            }
        }
    }

    /// The parts of a work offset that have changed: its system, presets and shifts, its turn.
    fn work_offset(
        &mut self,
        line: u32,
        name: WorkName,
        offset: &Position,
        system: &Position,
        turned: f64,
    ) {
        let preset = std::array::from_fn(|axis| offset[axis] - system[axis]);
        let before =
            std::mem::replace(&mut self.turn, CoordinateRotation { degrees: turned, preset });
        if self.work.replace((name, *system)) != Some((name, *system)) {
            self.begin(line);
            self.line.extend_from_slice(format!("SET_G5X_OFFSET({}, ", slot(name)).as_bytes());
            self.numbers(&canonical(system));
            self.line.extend_from_slice(b")\n");
        }
        if before.preset != preset {
            self.begin(line);
            self.line.extend_from_slice(b"SET_G92_OFFSET(");
            self.numbers(&canonical(&preset));
            self.line.extend_from_slice(b")\n");
        }
        if before.degrees != turned {
            self.begin(line);
            self.line.extend_from_slice(b"SET_XY_ROTATION(");
            self.numbers(&[turned]);
            self.line.extend_from_slice(b")\n");
        }
    }
}

/// mm and degrees.
fn canonical(position: &Position) -> PerAxis<f64> {
    let mut values = *position;
    values[3..].iter_mut().for_each(|value| *value = value.to_degrees());
    values
}

/// Turns begun, counter-clockwise positive: 1 up to a whole turn, 2 up to two.
fn rotation(sweep: f64) -> i64 {
    // Rounding must not begin another turn.
    let turns = (sweep.abs() / TAU - 1e-9).ceil().max(1.0) as i64;
    if sweep < 0.0 { -turns } else { turns }
}

/// LinuxCNC's number of a work coordinate system: 1 is G54, 7 is G59.1.
fn slot(name: WorkName) -> u16 {
    match name {
        WorkName::Machine => 0,
        WorkName::G(number) => number.saturating_sub(53),
        WorkName::G59(number) => 6 + number,
        WorkName::Extended(number) => 6 + number,
        WorkName::E(number) => number,
    }
}

/// The commands that need no state.
fn simple(kind: &CommandKind) -> Option<String> {
    Some(match kind {
        CommandKind::Dwell { seconds, .. } => format!("DWELL({seconds:.6})"),
        CommandKind::Tool { number } => format!("CHANGE_TOOL({number})"),
        CommandKind::ToolNumber { number } => format!("CHANGE_TOOL_NUMBER({number})"),
        CommandKind::ToolSelect { number } => format!("SELECT_TOOL({number})"),
        CommandKind::ToolLength { offset: [x, y, z, ..], .. } => {
            format!("USE_TOOL_LENGTH_OFFSET({x:.6}, {y:.6}, {z:.6})")
        }
        CommandKind::Compensation { side: CompensationSide::Off, .. } => {
            "STOP_CUTTER_RADIUS_COMPENSATION()".into()
        }
        CommandKind::Compensation { side, radius_mm, .. } => {
            let word = if *side == CompensationSide::Left { "LEFT" } else { "RIGHT" };
            let radius = radius_mm.unwrap_or(0.0);
            format!("START_CUTTER_RADIUS_COMPENSATION({word}) ; radius {radius:.6}")
        }
        CommandKind::Surface { surface, .. } => match surface.map(|surface| surface.shape) {
            None => "COMMENT(\"coordinates of the axes\")".into(),
            Some(SurfaceShape::Face { .. }) => "COMMENT(\"coordinates on the face\")".into(),
            Some(SurfaceShape::Cylinder { radius_mm }) => {
                format!("COMMENT(\"coordinates on a cylinder, radius {radius_mm:.6}\")")
            }
        },
        CommandKind::PartFrame { frame, .. } => match frame {
            None => "COMMENT(\"coordinates of the axes\")".into(),
            Some(_) => "COMMENT(\"coordinates of the tip on the part\")".into(),
        },
        CommandKind::Stop { optional: true } => "OPTIONAL_PROGRAM_STOP()".into(),
        CommandKind::Stop { optional: false } => "PROGRAM_STOP()".into(),
        CommandKind::End => "PROGRAM_END()".into(),
        CommandKind::PathMode(mode) => match mode {
            PathMode::ExactPath => "SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH, 0.000000)".into(),
            PathMode::ExactStop => "SET_MOTION_CONTROL_MODE(CANON_EXACT_STOP, 0.000000)".into(),
            PathMode::Continuous { tolerance_mm, .. } => {
                let tolerance = tolerance_mm.unwrap_or(0.0);
                format!("SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, {tolerance:.6})")
            }
        },
        CommandKind::Overrides(Overrides { feed: true, .. }) => "ENABLE_FEED_OVERRIDE()".into(),
        CommandKind::Overrides(Overrides { feed: false, .. }) => "DISABLE_FEED_OVERRIDE()".into(),
        _ => return None,
    })
}

/// Text that cannot end its line.
fn one_line(text: &str) -> String {
    text.replace(['\n', '\r', '"'], " ")
}
