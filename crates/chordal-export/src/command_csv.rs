//! Commands as a table: moves, and what happens between them.

use std::io::{self, Write};

use chordal::control::{ArcShape, AxisMask, Feed, Move, Position};
use chordal::geometry::ParamCurve;
use chordal::path::curve_of;
use chordal::{Command, CommandKind, Job, PathCommand};

use crate::motion::{
    PositionScale, direction_word, path_feed, plane_word, side_word, spindle_word, spline_feed,
    spline_length,
};
use crate::number::number;

const COLUMNS: [&str; 30] = [
    "line",
    "kind",
    "x_from_mm",
    "y_from_mm",
    "z_from_mm",
    "a_from_deg",
    "b_from_deg",
    "c_from_deg",
    "x_to_mm",
    "y_to_mm",
    "z_to_mm",
    "a_to_deg",
    "b_to_deg",
    "c_to_deg",
    "plane",
    "center_a_mm",
    "center_b_mm",
    "direction",
    "sweep_deg",
    "radius_from_mm",
    "radius_to_mm",
    "length_mm",
    "feed_mm_per_min",
    "seconds",
    "number",
    "state",
    "rpm",
    "compensation",
    "cutter_radius_mm",
    "inserted",
];

/// The columns that commands as programmed have.
const PROGRAMMED: usize = 27;

const FROM: usize = 2;
const TO: usize = 8;
const PLANE: usize = 14;
const LENGTH: usize = 21;
const FEED: usize = 22;
const SECONDS: usize = 23;
const NUMBER: usize = 24;
const STATE: usize = 25;
const RPM: usize = 26;
const COMPENSATION: usize = 27;

/// Writes moves, dwells, tools and the spindle as CSV: one row each, fixed columns, blank
/// where a column does not apply. A coordinate that is not known stays blank, and rotary axes that the machine does
/// not have; the
/// feed of moves of rotary axes alone too, because it is no length.
#[derive(Debug)]
pub struct CommandCsv<W: Write> {
    out: csv::Writer<W>,
    axes: AxisMask,
    written: PositionScale,
    columns: usize,
    row: [String; COLUMNS.len()],
}

impl<W: Write> CommandCsv<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// Those of the output.
    pub fn new(out: W, job: &Job) -> io::Result<Self> {
        Self::with_columns(out, job, PROGRAMMED)
    }

    /// Writes the header of a table for commands of the tool centre, which has columns for
    /// cutter compensation.
    ///
    /// # Errors
    /// Those of the output.
    pub fn of_path(out: W, job: &Job) -> io::Result<Self> {
        Self::with_columns(out, job, COLUMNS.len())
    }

    fn with_columns(out: W, job: &Job, columns: usize) -> io::Result<Self> {
        let mut out = csv::Writer::from_writer(out);
        out.write_record(&COLUMNS[..columns])?;
        let axes = job.control().axes().and(AxisMask::ROTARY).or(AxisMask::LINEAR);
        Ok(Self { out, axes, written: PositionScale::of(job), columns, row: Default::default() })
    }

    /// Writes a command of the tool centre.
    ///
    /// # Errors
    /// Those of the output.
    pub fn path_command(&mut self, path: PathCommand<'_>) -> io::Result<()> {
        if path.command.kind.feed().is_some() {
            self.row[COMPENSATION] = side_word(path.side).into();
            self.row[COMPENSATION + 1] = number(path.cutter_radius_mm);
        }
        if path.command.kind.motion().is_some() {
            self.row[COMPENSATION + 2] = u8::from(path.inserted).to_string();
        }
        self.command(path.command)
    }

    /// Writes a command, if it is one of those that have a row.
    ///
    /// # Errors
    /// Those of the output.
    pub fn command(&mut self, command: &Command) -> io::Result<()> {
        if command.kind.is_effect() {
            return Ok(());
        }
        let kind = match &command.kind {
            CommandKind::Rapid { motion, .. } => {
                self.ends(motion);
                "rapid"
            }
            CommandKind::Line { motion, feed } => self.cut("line", motion, None, feed),
            CommandKind::Arc { motion, shape, feed } => self.cut("arc", motion, Some(shape), feed),
            CommandKind::Spiral { motion, shape, feed } => {
                self.cut("spiral", motion, Some(shape), feed)
            }
            CommandKind::Spline { motion, curve, feed } => {
                self.ends(motion);
                let length = spline_length(curve);
                self.row[LENGTH] = number(length);
                self.row[FEED] = number(spline_feed(feed, length));
                "spline"
            }
            CommandKind::Dwell { seconds, .. } => {
                self.row[SECONDS] = number(*seconds);
                "dwell"
            }
            CommandKind::Tool { number } => {
                self.row[NUMBER] = number.to_string();
                "tool"
            }
            CommandKind::ToolNumber { number } => {
                self.row[NUMBER] = number.to_string();
                "tool_number"
            }
            CommandKind::Spindle { state, rpm } => {
                self.row[STATE] = spindle_word(*state).into();
                self.row[RPM] = number(*rpm);
                "spindle"
            }
            _ => return Ok(()),
        };
        self.row[0] = command.origin.line.to_string();
        self.row[1] = kind.into();
        self.out.write_record(&self.row[..self.columns])?;
        self.row.iter_mut().for_each(String::clear);
        Ok(())
    }

    /// Writes what is left and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(self) -> io::Result<W> {
        self.out.into_inner().map_err(|error| error.into_error())
    }

    fn cut(
        &mut self,
        kind: &'static str,
        motion: &Move,
        shape: Option<&ArcShape>,
        feed: &Feed,
    ) -> &'static str {
        self.ends(motion);
        if let Some(shape) = shape {
            self.shape(shape);
        }
        let curve = curve_of(motion, shape);
        let length = curve.length();
        self.row[LENGTH] = number(length);
        let feed = path_feed(feed, motion, &curve, length);
        if !feed.rotary {
            self.row[FEED] = number(feed.per_minute);
        }
        kind
    }

    fn ends(&mut self, motion: &Move) {
        self.position(FROM, &motion.from, motion.from_known);
        self.position(TO, &motion.to, motion.to_known);
    }

    fn position(&mut self, column: usize, position: &Position, known: AxisMask) {
        for (axis, value) in position.iter().enumerate() {
            if self.axes.and(known).has(axis) {
                self.row[column + axis] = number(self.written.place(axis, *value));
            }
        }
    }

    fn shape(&mut self, shape: &ArcShape) {
        let center = self.written.center(shape);
        self.row[PLANE] = plane_word(shape.plane).into();
        self.row[PLANE + 1] = number(center[0]);
        self.row[PLANE + 2] = number(center[1]);
        self.row[PLANE + 3] = direction_word(shape.sweep).into();
        self.row[PLANE + 4] = number(shape.sweep.abs().to_degrees());
        self.row[PLANE + 5] = number(shape.radius_from);
        self.row[PLANE + 6] = number(shape.radius_to);
    }
}
