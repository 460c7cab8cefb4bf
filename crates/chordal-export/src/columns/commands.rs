//! Commands as columns.

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, SchemaRef};
use chordal::control::{
    ArcShape, AxisMask, Feed, FeedMode, Move, PathMode, Position, SurfaceShape, Units,
};
use chordal::geometry::ParamCurve;
use chordal::path::curve_of;
use chordal::{Command, CommandKind, Job, PathCommand, SourceMap};

use super::cells::{FileColumn, FlagColumn, IntegerColumn, NumberColumn, TextColumn, WordColumn};
use super::field::{CellType, Column, axes_of, places, schema};
use super::rows::RowBatcher;
use crate::motion::{
    PositionScale, feed_mode_word, path_feed, plane_word, side_word, spindle_word, spline_feed,
    spline_length,
};

/// Name and version of the columns of commands as programmed.
pub const COMMAND_COLUMNS: &str = "chordal.command-columns/1";

/// Name and version of the columns of commands of the tool centre.
pub const TOOL_PATH_COLUMNS: &str = "chordal.tool-path-columns/1";

const KINDS: &[&str] = &[
    "rapid",
    "line",
    "arc",
    "spiral",
    "spline",
    "dwell",
    "tool",
    "tool_number",
    "tool_select",
    "tool_length",
    "compensation",
    "corner_arc",
    "spindle",
    "coolant",
    "stop",
    "probed",
    "surface",
    "end",
    "units",
    "plane",
    "feed_mode",
    "feed_rate",
    "path_mode",
    "work_offset",
    "message",
    "print",
    "idle",
];
const PLANES: &[&str] = &["xy", "zx", "yz"];
const DIRECTIONS: &[&str] = &["cw", "ccw"];
const SIDES: &[&str] = &["off", "left", "right"];

/// Gathers commands, one row each, as programmed or as of the tool centre.
#[derive(Debug)]
pub struct CommandColumns<'a> {
    schema: SchemaRef,
    sources: &'a SourceMap<'a>,
    naming: chordal::control::WorkNaming,
    axes: Vec<usize>,
    written: PositionScale,
    of_path: bool,
    /// Only the commands that have a row in a table of text.
    is_text: bool,
    rows: usize,
    line: IntegerColumn,
    file: FileColumn<'a>,
    kind: WordColumn,
    from: Vec<NumberColumn>,
    to: Vec<NumberColumn>,
    arc: ArcCells,
    length: NumberColumn,
    feed: NumberColumn,
    seconds: NumberColumn,
    number: IntegerColumn,
    state: TextColumn,
    rpm: NumberColumn,
    value: NumberColumn,
    text: TextColumn,
    side: WordColumn,
    radius: NumberColumn,
    inserted: FlagColumn,
}

#[derive(Debug)]
struct ArcCells {
    plane: WordColumn,
    center: [NumberColumn; 2],
    direction: WordColumn,
    sweep: NumberColumn,
    radii: [NumberColumn; 2],
}

/// The columns of commands, those of the tool centre with what compensation did.
pub(super) fn columns(axes: AxisMask, of_path: bool) -> Vec<Column> {
    use CellType::{
        File, FlagOrGap, Integer, IntegerOrGap, NumberOrGap, TextOrGap, Word, WordOrGap,
    };
    let column = Column::new;
    let mut columns = vec![
        column("line", Integer, "", "line of the block, from 1"),
        column("file", File, "", "the text that the block is in"),
        column("kind", Word, "", "what the command does"),
    ];
    columns.extend(places(
        axes,
        "from",
        NumberOrGap,
        "start of a move, program coordinates, where known",
    ));
    columns.extend(places(
        axes,
        "to",
        NumberOrGap,
        "end of a move, program coordinates, where known",
    ));
    columns.extend([
        column("plane", WordOrGap, "", "plane of an arc, or the new plane"),
        column("center_a_mm", NumberOrGap, "mm", "centre of an arc, first axis of its plane"),
        column("center_b_mm", NumberOrGap, "mm", "centre of an arc, second axis of its plane"),
        column("direction", WordOrGap, "", "direction of an arc"),
        column("sweep_deg", NumberOrGap, "deg", "angle of an arc, without its sign"),
        column("radius_from_mm", NumberOrGap, "mm", "radius at the start of an arc"),
        column("radius_to_mm", NumberOrGap, "mm", "radius at the end of an arc"),
        column("length_mm", NumberOrGap, "mm", "length of a cut"),
        column(
            "feed_mm_per_min",
            NumberOrGap,
            "mm/min",
            "feed along a cut, whatever the unit of F",
        ),
        column("seconds", NumberOrGap, "s", "time of a dwell"),
        column("number", IntegerOrGap, "", "number of a tool or of an offset"),
        column("state", TextOrGap, "", "new state of the spindle, a mode or a switch"),
        column("rpm", NumberOrGap, "rev/min", "speed of the spindle"),
        column("value", NumberOrGap, "", "length or radius of an offset, mm; F in its own unit"),
        column(
            "text",
            TextOrGap,
            "",
            "a message, a printed line, the name of a work offset, the label of a custom M code",
        ),
    ]);
    if of_path {
        columns.extend([
            column("compensation", WordOrGap, "", "side of cutter compensation of a cut"),
            column("cutter_radius_mm", NumberOrGap, "mm", "tool radius by which a cut is offset"),
            column("inserted", FlagOrGap, "", "a move that compensation inserted"),
        ]);
    }
    columns
}

impl<'a> CommandColumns<'a> {
    /// Columns for commands as programmed.
    pub fn new(job: &'a Job<'a>) -> CommandColumns<'a> {
        CommandColumns::of(job, false)
    }

    /// Columns for commands of the tool centre.
    pub fn of_path(job: &'a Job<'a>) -> CommandColumns<'a> {
        CommandColumns::of(job, true)
    }

    /// Columns for either.
    pub fn of(job: &'a Job<'a>, of_path: bool) -> CommandColumns<'a> {
        let axes = axes_of(job);
        let name = if of_path { TOOL_PATH_COLUMNS } else { COMMAND_COLUMNS };
        let axes_listed: Vec<usize> = axes.iter().map(|axis| axis as usize).collect();
        let numbers = || axes_listed.iter().map(|_| NumberColumn::new()).collect::<Vec<_>>();
        CommandColumns {
            schema: schema(job, name, &columns(axes, of_path), &[]),
            sources: job.sources(),
            written: PositionScale::of(job),
            naming: job.profile().work_names,
            of_path,
            is_text: false,
            rows: 0,
            line: IntegerColumn::new(),
            file: FileColumn::of(job),
            kind: WordColumn::new(KINDS),
            from: numbers(),
            to: numbers(),
            arc: ArcCells::new(),
            length: NumberColumn::new(),
            feed: NumberColumn::new(),
            seconds: NumberColumn::new(),
            number: IntegerColumn::new(),
            state: TextColumn::new(),
            rpm: NumberColumn::new(),
            value: NumberColumn::new(),
            text: TextColumn::new(),
            side: WordColumn::new(SIDES),
            radius: NumberColumn::new(),
            inserted: FlagColumn::new(),
            axes: axes_listed,
        }
    }

    /// The same for a table of text: moves, dwells, tools and the spindle alone.
    #[must_use]
    pub fn for_text(self) -> CommandColumns<'a> {
        CommandColumns { is_text: true, ..self }
    }

    /// Takes a command of the tool centre.
    pub fn path_command(&mut self, path: PathCommand<'_>) {
        if path.command.kind.feed().is_some() {
            self.side.put_word(self.rows, side_word(path.side));
            self.radius.put(self.rows, path.cutter_radius_mm);
        }
        if path.command.kind.motion().is_some() {
            self.inserted.put(self.rows, path.inserted);
        }
        self.command(path.command);
    }

    /// Takes a command.
    #[inline]
    pub fn command(&mut self, command: &Command) {
        if command.kind.is_effect() || self.is_text && !is_text_row(&command.kind) {
            return;
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
                self.length.put(self.rows, length);
                self.feed.put(self.rows, spline_feed(feed, length));
                "spline"
            }
            CommandKind::Message(range) => {
                let words = self.sources.words(range.in_file(command.origin.span.file));
                self.text.put(self.rows, &words);
                "message"
            }
            other => self.state(other),
        };
        self.kind.put_word(self.rows, kind);
        self.line.put(self.rows, command.origin.line);
        self.file.push(command.origin.span.file);
        self.rows += 1;
    }

    #[inline]
    fn cut(
        &mut self,
        kind: &'static str,
        motion: &Move,
        shape: Option<&ArcShape>,
        feed: &Feed,
    ) -> &'static str {
        self.ends(motion);
        let row = self.rows;
        if let Some(shape) = shape {
            self.arc.put(row, shape, self.written.center(shape));
        }
        let curve = curve_of(motion, shape);
        let length = curve.length();
        self.length.put(row, length);
        let feed = path_feed(feed, motion, &curve, length);
        // The feed of rotary axes alone is no length.
        if !feed.rotary {
            self.feed.put(row, feed.per_minute);
        }
        kind
    }

    #[inline]
    fn ends(&mut self, motion: &Move) {
        let (row, written) = (self.rows, self.written);
        let put = |columns: &mut [NumberColumn], position: &Position, known: AxisMask| {
            for (column, axis) in columns.iter_mut().zip(&self.axes) {
                if known.has(*axis) {
                    column.put(row, written.place(*axis, position[*axis]));
                }
            }
        };
        put(&mut self.from, &motion.from, motion.from_known);
        put(&mut self.to, &motion.to, motion.to_known);
    }

    /// Commands that move nothing.
    fn state(&mut self, kind: &CommandKind) -> &'static str {
        let row = self.rows;
        match kind {
            CommandKind::Dwell { seconds, label } => {
                self.seconds.put(row, *seconds);
                if let Some(label) = label {
                    self.text.put(row, label);
                }
                "dwell"
            }
            CommandKind::Tool { number } => {
                self.number.put(row, *number);
                "tool"
            }
            CommandKind::ToolNumber { number } => {
                self.number.put(row, *number);
                "tool_number"
            }
            CommandKind::ToolSelect { number } => {
                self.number.put(row, *number);
                "tool_select"
            }
            CommandKind::ToolLength { number, length_mm, .. } => {
                self.offset(*number, *length_mm);
                "tool_length"
            }
            CommandKind::Compensation { side, number, radius_mm, .. } => {
                self.offset(*number, *radius_mm);
                self.state.put(row, side_word(*side));
                "compensation"
            }
            CommandKind::Spindle { state, rpm } => {
                self.state.put(row, spindle_word(*state));
                self.rpm.put(row, *rpm);
                "spindle"
            }
            CommandKind::WorkOffset { name, .. } => {
                self.text.put(row, &name.key(self.naming));
                "work_offset"
            }
            CommandKind::Output { text } => {
                self.text.put(row, text);
                "print"
            }
            other => self.mode(other),
        }
    }

    fn offset(&mut self, number: Option<u32>, value: Option<f64>) {
        if let Some(number) = number {
            self.number.put(self.rows, number);
        }
        self.value.put(self.rows, value.unwrap_or(f64::NAN));
    }

    /// Commands that change what later ones mean, and switches.
    fn mode(&mut self, kind: &CommandKind) -> &'static str {
        let row = self.rows;
        match kind {
            CommandKind::Coolant(coolant) => {
                let valves = [
                    (coolant.mist, "mist"),
                    (coolant.flood, "flood"),
                    (coolant.through_tool, "through_tool"),
                ];
                let open: Vec<&str> =
                    valves.iter().filter(|valve| valve.0).map(|valve| valve.1).collect();
                self.state.put(row, &if open.is_empty() { "off".into() } else { open.join("+") });
                "coolant"
            }
            CommandKind::Stop { optional } => {
                self.state.put(row, if *optional { "optional" } else { "always" });
                "stop"
            }
            CommandKind::Probed { hit } => {
                self.state.put(row, if *hit { "hit" } else { "nothing" });
                "probed"
            }
            CommandKind::PartFrame { frame, .. } => {
                self.state.put(row, if frame.is_some() { "on" } else { "off" });
                "part_frame"
            }
            CommandKind::Surface { surface, .. } => {
                let shape = surface.map(|surface| surface.shape);
                self.state.put(
                    row,
                    match shape {
                        None => "none",
                        Some(SurfaceShape::Face { .. }) => "face",
                        Some(SurfaceShape::Cylinder { .. }) => "cylinder",
                    },
                );
                "surface"
            }
            CommandKind::Units(units) => {
                self.state.put(row, if *units == Units::Inch { "in" } else { "mm" });
                "units"
            }
            CommandKind::Plane(plane) => {
                self.arc.plane.put_word(row, plane_word(*plane));
                "plane"
            }
            CommandKind::FeedMode(mode) => {
                self.state.put(row, feed_mode_word(*mode));
                "feed_mode"
            }
            CommandKind::FeedRate { value, mode } => {
                let per_minute = if *mode == FeedMode::PerRevolution { 1.0 } else { 60.0 };
                self.value.put(row, value * per_minute);
                self.state.put(row, feed_mode_word(*mode));
                "feed_rate"
            }
            CommandKind::PathMode(mode) => {
                let (word, tolerance) = match mode {
                    PathMode::ExactPath => ("exact_path", None),
                    PathMode::ExactStop => ("exact_stop", None),
                    PathMode::Continuous { tolerance_mm, .. } => ("continuous", *tolerance_mm),
                };
                self.state.put(row, word);
                self.value.put(row, tolerance.unwrap_or(f64::NAN));
                "path_mode"
            }
            CommandKind::CornerArc { .. } => "corner_arc",
            CommandKind::CornerMode { .. } => "corner_mode",
            CommandKind::End => "end",
            // Moves and texts are taken before this is asked.
            _ => "idle",
        }
    }
}

/// Whether a command has a row in a table of text.
fn is_text_row(kind: &CommandKind) -> bool {
    let is_switch = matches!(
        kind,
        CommandKind::Dwell { .. }
            | CommandKind::Tool { .. }
            | CommandKind::ToolNumber { .. }
            | CommandKind::Spindle { .. }
    );
    is_switch || kind.motion().is_some()
}

impl RowBatcher for CommandColumns<'_> {
    fn rows(&self) -> usize {
        self.rows
    }

    fn schema(&self) -> &SchemaRef {
        &self.schema
    }

    /// Every axis has its columns, whatever the machine; the text of a program has none.
    fn text_columns(&self) -> Vec<String> {
        let all = columns(AxisMask::ALL, self.of_path).into_iter().map(|column| column.name);
        all.filter(|name| !["file", "value", "text"].contains(&name.as_str())).collect()
    }

    fn take(&mut self) -> Result<RecordBatch, ArrowError> {
        let rows = std::mem::take(&mut self.rows);
        let mut arrays = vec![self.line.take(rows), self.file.take()?, self.kind.take(rows)?];
        arrays.extend(self.from.iter_mut().map(|column| column.take(rows)));
        arrays.extend(self.to.iter_mut().map(|column| column.take(rows)));
        arrays.push(self.arc.plane.take(rows)?);
        arrays.extend(self.arc.center.iter_mut().map(|column| column.take(rows)));
        arrays.push(self.arc.direction.take(rows)?);
        arrays.push(self.arc.sweep.take(rows));
        arrays.extend(self.arc.radii.iter_mut().map(|column| column.take(rows)));
        arrays.push(self.length.take(rows));
        arrays.push(self.feed.take(rows));
        arrays.push(self.seconds.take(rows));
        arrays.push(self.number.take(rows));
        arrays.push(self.state.take(rows));
        arrays.push(self.rpm.take(rows));
        arrays.push(self.value.take(rows));
        arrays.push(self.text.take(rows));
        if self.of_path {
            arrays.push(self.side.take(rows)?);
            arrays.push(self.radius.take(rows));
            arrays.push(self.inserted.take(rows));
        }
        RecordBatch::try_new(self.schema.clone(), arrays)
    }
}

impl ArcCells {
    fn new() -> ArcCells {
        ArcCells {
            plane: WordColumn::new(PLANES),
            center: [NumberColumn::new(), NumberColumn::new()],
            direction: WordColumn::new(DIRECTIONS),
            sweep: NumberColumn::new(),
            radii: [NumberColumn::new(), NumberColumn::new()],
        }
    }

    fn put(&mut self, row: usize, shape: &ArcShape, center: [f64; 2]) {
        self.plane.put_word(row, plane_word(shape.plane));
        self.center[0].put(row, center[0]);
        self.center[1].put(row, center[1]);
        self.direction.put(row, usize::from(shape.sweep >= 0.0));
        self.sweep.put(row, shape.sweep.abs().to_degrees());
        self.radii[0].put(row, shape.radius_from);
        self.radii[1].put(row, shape.radius_to);
    }
}
