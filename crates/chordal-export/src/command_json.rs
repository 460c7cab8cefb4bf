//! Commands as JSON lines.

use std::io::{self, Write};

use chordal::control::{
    ArcShape, AxisMask, Feed, FeedAlong, FeedMode, Move, Origin, PathMode, Position, RapidPath,
    RotarySurface, SurfaceShape, Units, WorkName,
};
use chordal::diagnostics::FileId;
use chordal::geometry::Spline;
use chordal::machine::{AXES, AXIS_NAMES, Axis};
use chordal::{Command, CommandKind, Job, PathCommand, SourceMap};

use crate::json::JsonObject;
use crate::motion::{
    PositionScale, curve_and_length, direction_word, feed_mode_word, path_feed, plane_word,
    side_word, spindle_word, spline_feed, spline_length,
};

/// Writes commands as JSON lines, schema `chordal.commands/1`: a header object, then one
/// object for each command. Lengths are mm, angles degrees, feeds mm/min along the path
/// whatever F counts; the feed of rotary axes alone is deg/min, and says so by `feed_unit`.
///
/// Positions are work coordinates, diameters of the axes that the header lists under `diameter`.
/// `from_unknown` and `to_unknown` list the axes that the
/// program has not placed relative to the part yet: their numbers mean nothing.
#[derive(Debug)]
pub struct CommandJsonLines<'a, W> {
    out: W,
    line: Vec<u8>,
    sources: &'a SourceMap<'a>,
    naming: chordal::control::WorkNaming,
    /// X, Y and Z always, and the rotary axes of the machine.
    axes: AxisMask,
    written: PositionScale,
}

impl<'a, W: Write> CommandJsonLines<'a, W> {
    /// Writes the header.
    ///
    /// # Errors
    /// Those of the output.
    pub fn new(out: W, job: &'a Job<'a>) -> io::Result<Self> {
        let mut writer = Self {
            out,
            line: Vec::with_capacity(512),
            sources: job.sources(),
            naming: job.profile().work_names,
            axes: job.axes().and(AxisMask::ROTARY).or(AxisMask::LINEAR),
            written: PositionScale::of(job),
        };
        let mut header = JsonObject::open(&mut writer.line);
        header.word("schema", "chordal.commands/1");
        header.word("length_unit", "mm");
        header.word("angle_unit", "deg");
        header.word("feed_unit", "mm/min");
        header.text("program", job.sources().get(FileId(0)).map_or("", |source| source.name()));
        header.text("machine", &job.machine().name);
        header.text("control", job.machine().control.as_str());
        let diameters = writer.written.diameters();
        if !diameters.is_empty() {
            header.letters("diameter", diameters.chars());
        }
        header.close();
        writer.flush_line()?;
        Ok(writer)
    }

    /// Writes a command.
    ///
    /// # Errors
    /// Those of the output.
    pub fn command(&mut self, command: &Command) -> io::Result<()> {
        self.write(command, |_| {})
    }

    /// Writes a command of the tool centre: feed moves have the side and the radius of cutter
    /// compensation, links that it made say so.
    ///
    /// # Errors
    /// Those of the output.
    pub fn path_command(&mut self, path: PathCommand<'_>) -> io::Result<()> {
        let feeds = path.command.kind.feed().is_some();
        self.write(path.command, |object| {
            if feeds {
                object.word("compensation", side_word(path.side));
                object.number("cutter_radius", path.cutter_radius_mm);
            }
            if path.inserted {
                object.boolean("inserted", true);
            }
        })
    }

    fn write(&mut self, command: &Command, more: impl FnOnce(&mut JsonObject)) -> io::Result<()> {
        if command.kind.is_effect() {
            return Ok(());
        }
        let mut object = JsonObject::open(&mut self.line);
        write_origin(&mut object, &command.origin, self.sources);
        let context = CommandJsonContext {
            sources: self.sources,
            naming: self.naming,
            axes: self.axes,
            written: self.written,
        };
        context.write(&mut object, command);
        more(&mut object);
        object.close();
        self.flush_line()
    }

    /// Writes what is left and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(mut self) -> io::Result<W> {
        self.out.flush()?;
        Ok(self.out)
    }

    fn flush_line(&mut self) -> io::Result<()> {
        self.line.push(b'\n');
        self.out.write_all(&self.line)?;
        self.line.clear();
        Ok(())
    }
}

/// The block's line, and its file where that is not the program's.
fn write_origin(object: &mut JsonObject, origin: &Origin, sources: &SourceMap) {
    if origin.span.file != FileId(0)
        && let Some(source) = sources.get(origin.span.file)
    {
        object.text("file", source.name());
    }
    object.integer("line", origin.line.into());
}

struct CommandJsonContext<'a> {
    sources: &'a SourceMap<'a>,
    naming: chordal::control::WorkNaming,
    axes: AxisMask,
    written: PositionScale,
}

impl CommandJsonContext<'_> {
    fn write(&self, object: &mut JsonObject, command: &Command) {
        match &command.kind {
            CommandKind::Rapid { motion, path } => self.rapid(object, motion, *path),
            CommandKind::Line { motion, feed } => self.cut(object, "line", motion, None, feed),
            CommandKind::Arc { motion, shape, feed } => {
                self.cut(object, "arc", motion, Some(shape), feed);
            }
            CommandKind::Spiral { motion, shape, feed } => {
                self.cut(object, "spiral", motion, Some(shape), feed);
            }
            CommandKind::Spline { motion, curve, feed } => {
                self.spline(object, motion, curve, feed);
            }
            CommandKind::WorkOffset { name, offset, known, .. } => {
                self.work_offset(object, *name, offset, *known);
            }
            CommandKind::Message(range) => {
                object.word("kind", "message");
                let span = range.in_file(command.origin.span.file);
                object.text("text", &self.sources.words(span));
            }
            CommandKind::Output { text } => {
                object.word("kind", "print");
                object.text("text", text);
            }
            other => state(object, other),
        }
    }

    fn rapid(&self, object: &mut JsonObject, motion: &Move, path: RapidPath) {
        object.word("kind", "rapid");
        self.ends(object, motion);
        let word = match path {
            RapidPath::Straight | RapidPath::AtFeed(_) => "straight",
            RapidPath::DogLeg => "dog_leg",
        };
        object.word("path", word);
    }

    fn cut(
        &self,
        object: &mut JsonObject,
        kind: &str,
        motion: &Move,
        shape: Option<&ArcShape>,
        feed: &Feed,
    ) {
        object.word("kind", kind);
        self.ends(object, motion);
        let (curve, length) = curve_and_length(motion, shape);
        if let Some(shape) = shape {
            write_shape(object, shape, self.written.center(shape));
        }
        object.number("length", length);
        let path_feed = path_feed(feed, motion, &curve, length);
        object.number("feed", path_feed.per_minute);
        if path_feed.rotary {
            object.word("feed_unit", "deg/min");
        }
        if feed.mode != FeedMode::PerTime {
            object.word("feed_mode", feed_mode_word(feed.mode));
        }
        if feed.along == FeedAlong::Plane {
            object.word("feed_along", "plane");
        }
    }

    /// The order and the control points with their weights, as places are written.
    fn spline(&self, object: &mut JsonObject, motion: &Move, curve: &Spline, feed: &Feed) {
        object.word("kind", "spline");
        self.ends(object, motion);
        object.integer("order", curve.order() as u64);
        for (letter, axis) in [("x", 0), ("y", 1), ("z", 2)] {
            let values = curve.points().iter();
            let places = values.map(|point| self.written.place(axis, point.component(axis)));
            object.numbers(letter, places);
        }
        object.numbers("weights", curve.weights().iter().copied());
        object.numbers("knots", curve.knots().iter().copied());
        let length = spline_length(curve);
        object.number("length", length);
        object.number("feed", spline_feed(feed, length));
        if feed.mode != FeedMode::PerTime {
            object.word("feed_mode", feed_mode_word(feed.mode));
        }
    }

    fn ends(&self, object: &mut JsonObject, motion: &Move) {
        object.object("from", |inner| self.position(inner, &motion.from));
        object.object("to", |inner| self.position(inner, &motion.to));
        // Rotary axes that stand still are reported only where a program turns them: most never do.
        let mut noted = AxisMask::LINEAR;
        for axis in 3..AXES {
            let (from, to) = (motion.from[axis], motion.to[axis]);
            if from != to {
                noted.insert(axis);
            }
        }
        unknown(object, "from_unknown", noted.without(motion.from_known));
        unknown(object, "to_unknown", noted.without(motion.to_known));
    }

    fn position(&self, object: &mut JsonObject, position: &Position) {
        for (axis, value) in position.iter().enumerate() {
            if self.axes.has(axis) {
                object.number(AXIS_NAMES[axis], self.written.place(axis, *value));
            }
        }
    }

    fn work_offset(
        &self,
        object: &mut JsonObject,
        name: WorkName,
        offset: &Position,
        known: AxisMask,
    ) {
        object.word("kind", "work_offset");
        object.text("name", &name.key(self.naming));
        object.object("offset", |inner| self.position(inner, offset));
        object.letters("known", known.and(self.axes).iter().map(|axis| axis.letter()));
    }
}

/// The axes whose value is not known relative to the part, where there are any.
fn unknown(object: &mut JsonObject, name: &str, axes: AxisMask) {
    if axes != AxisMask::NONE {
        object.letters(name, axes.iter().map(|axis| axis.letter()));
    }
}

fn write_shape(object: &mut JsonObject, shape: &ArcShape, center: [f64; 2]) {
    object.word("plane", plane_word(shape.plane));
    let (first, second, _) = shape.plane.axes();
    object.object("center", |inner| {
        inner.number(AXIS_NAMES[first], center[0]);
        inner.number(AXIS_NAMES[second], center[1]);
    });
    object.word("direction", direction_word(shape.sweep));
    object.number("sweep_deg", shape.sweep.abs().to_degrees());
    object.number("radius_from", shape.radius_from);
    object.number("radius_to", shape.radius_to);
}

/// Commands that move nothing.
fn state(object: &mut JsonObject, kind: &CommandKind) {
    match kind {
        CommandKind::Dwell { seconds, label } => {
            object.word("kind", "dwell");
            object.number("seconds", *seconds);
            if let Some(label) = label {
                object.text("label", label);
            }
        }
        CommandKind::Tool { number } => {
            object.word("kind", "tool");
            object.integer("number", (*number).into());
        }
        CommandKind::ToolNumber { number } => {
            object.word("kind", "tool_number");
            object.integer("number", (*number).into());
        }
        CommandKind::ToolSelect { number } => {
            object.word("kind", "tool_select");
            object.integer("number", (*number).into());
        }
        CommandKind::ToolLength { number, length_mm, .. } => {
            object.word("kind", "tool_length");
            object.optional_integer("number", *number);
            object.optional("length", *length_mm);
        }
        CommandKind::Compensation { side, number, radius_mm, .. } => {
            object.word("kind", "compensation");
            object.word("side", side_word(*side));
            object.optional_integer("number", *number);
            object.optional("radius", *radius_mm);
        }
        CommandKind::CornerArc { .. } => object.word("kind", "corner_arc"),
        CommandKind::CornerMode { meets, opens } => {
            object.word("kind", "corner_mode");
            object.boolean("meets", *meets);
            object.boolean("opens", *opens);
        }
        CommandKind::Spindle { state, rpm } => {
            object.word("kind", "spindle");
            object.word("state", spindle_word(*state));
            object.number("rpm", *rpm);
        }
        CommandKind::Coolant(coolant) => {
            object.word("kind", "coolant");
            object.boolean("mist", coolant.mist);
            object.boolean("flood", coolant.flood);
            object.boolean("through_tool", coolant.through_tool);
        }
        CommandKind::Stop { optional } => {
            object.word("kind", "stop");
            object.boolean("optional", *optional);
        }
        CommandKind::Probed { hit } => {
            object.word("kind", "probed");
            object.boolean("hit", *hit);
        }
        CommandKind::PartFrame { frame, .. } => {
            object.word("kind", "part_frame");
            object.boolean("on", frame.is_some());
        }
        CommandKind::Surface { surface, .. } => surface_of(object, surface.as_ref()),
        CommandKind::End => object.word("kind", "end"),
        other => mode(object, other),
    }
}

/// Where two coordinates lie from here on.
fn surface_of(object: &mut JsonObject, surface: Option<&RotarySurface>) {
    object.word("kind", "surface");
    let Some(surface) = surface else { return object.word("surface", "none") };
    let letter = |axis: usize| Axis::ALL[axis].letter().to_string();
    match surface.shape {
        SurfaceShape::Face { .. } => object.word("surface", "face"),
        SurfaceShape::Cylinder { radius_mm } => {
            object.word("surface", "cylinder");
            object.number("radius", radius_mm);
        }
    }
    object.text("rotary", &letter(surface.rotary));
    object.text("across", &letter(surface.across));
}

/// Commands that change what later ones mean.
fn mode(object: &mut JsonObject, kind: &CommandKind) {
    match kind {
        CommandKind::Units(units) => {
            object.word("kind", "units");
            object.word("unit", if *units == Units::Inch { "in" } else { "mm" });
        }
        CommandKind::Plane(plane) => {
            object.word("kind", "plane");
            object.word("plane", plane_word(*plane));
        }
        CommandKind::FeedMode(mode) => {
            object.word("kind", "feed_mode");
            object.word("mode", feed_mode_word(*mode));
        }
        CommandKind::FeedRate { value, mode } => {
            object.word("kind", "feed_rate");
            let (value, unit) = match mode {
                FeedMode::PerTime => (*value * 60.0, "mm/min"),
                FeedMode::InverseTime => (*value * 60.0, "1/min"),
                FeedMode::PerRevolution => (*value, "mm/rev"),
            };
            object.number("value", value);
            object.word("unit", unit);
        }
        CommandKind::PathMode(mode) => {
            object.word("kind", "path_mode");
            let (word, tolerance) = match mode {
                PathMode::ExactPath => ("exact_path", None),
                PathMode::ExactStop => ("exact_stop", None),
                PathMode::Continuous { tolerance_mm, .. } => ("continuous", *tolerance_mm),
            };
            object.word("mode", word);
            object.optional("tolerance", tolerance);
        }
        CommandKind::Overrides(overrides) => {
            object.word("kind", "overrides");
            object.boolean("feed", overrides.feed);
            object.boolean("rapid", overrides.rapid);
        }
        // Motions, offsets and messages are written before this is asked.
        _ => {}
    }
}
