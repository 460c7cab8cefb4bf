//! Everything a report says, as plain data.

use serde::Serialize;

/// The rows of a table up to its most.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CappedRows<T> {
    /// The rows.
    pub rows: Vec<T>,
    /// How many more there are.
    pub left_out: u64,
}

/// Everything a report says. Lengths are mm, angles degrees, times s, feeds mm/min.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Document {
    /// `chordal.report/1`.
    pub schema: &'static str,
    /// The version of Chordal.
    pub chordal: &'static str,
    /// What the program is and what it runs on.
    pub head: ReportHead,
    /// Errors: the control would stop, or do something else than the text says.
    pub errors: u64,
    /// File and line from which on the path, or its time alone, is not known.
    pub not_verified_from: Option<(String, u32)>,
    /// The path is known everywhere; its time may not be.
    pub is_path_verified: bool,
    /// Warnings.
    pub warnings: u64,
    /// Notes.
    pub notes: u64,
    /// How the run ended, where it did not end as programs do.
    pub ends: Vec<String>,
    /// Moves counted.
    pub moves: MoveCounts,
    /// The planned time; `None` where the machine's limits let nothing be planned.
    pub time: Option<PlannedTime>,
    /// Tools in the order of their first use.
    pub tools: CappedRows<ReportedTool>,
    /// Work offsets in the order of their first use.
    pub work_offsets: Vec<ReportedWorkOffset>,
    /// Tool offsets by number.
    pub registers: CappedRows<Register>,
    /// Where the tool goes, in each work coordinate system.
    pub travel: CappedRows<Travel>,
    /// The same against the machine's travel.
    pub machine_travel: Vec<MachineTravel>,
    /// Where an operator is wanted, and what the program shows, in the order of the run.
    pub stops: CappedRows<OperatorStop>,
    /// Blocks that the block delete switch leaves out.
    pub skipped: SkippedBlocks,
    /// Lines that the program prints.
    pub printed: CappedRows<String>,
    /// Subprograms that were run.
    pub called: CappedRows<CalledProgram>,
    /// Problems, the gravest first; those of the stock among them.
    pub problems: CappedRows<ReportedProblem>,
    /// What is left of the stock, where one is given.
    pub stock: Option<ReportedStock>,
    /// The path.
    #[serde(skip)]
    pub pictures: PathPictures,
}

/// What the program is and what it runs on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReportHead {
    /// Name of the file.
    pub file: String,
    /// The programs that are run, as `O1000`, with their titles.
    pub programs: CappedRows<CalledProgram>,
    /// Comments at the head of the program.
    pub comments: Vec<String>,
    /// The control.
    pub control: &'static str,
    /// The machine.
    pub machine: String,
    /// It is a lathe: its tool offsets are of X and Z, with a nose radius and a tip.
    pub is_lathe: bool,
    /// Why this machine, where nobody said it.
    pub recognized: Option<String>,
    /// `inch` or `mm`: the units of the program's last block.
    pub units: &'static str,
    /// Size of the text.
    pub bytes: u64,
    /// Lines of the text.
    pub lines: u64,
    /// SHA-256 of the text, hexadecimal.
    pub sha256: String,
    /// The date that the caller gives, in his words.
    pub date: Option<String>,
}

/// Moves counted.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MoveCounts {
    /// Blocks carried out, repeats counted.
    pub blocks: u64,
    /// Straight cuts.
    pub lines: u64,
    /// Flat arcs.
    pub arcs: u64,
    /// Helices.
    pub helices: u64,
    /// Spirals and cones.
    pub spirals: u64,
    /// Splines.
    pub splines: u64,
    /// Rapids.
    pub rapids: u64,
    /// Dwells.
    pub dwells: u64,
    /// Length of all cuts, mm.
    pub cut_mm: f64,
    /// Length of all rapids, mm.
    pub rapid_mm: f64,
}

/// The planned time: velocity, acceleration and jerk of every axis held.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlannedTime {
    /// All of it, s.
    pub total_s: f64,
    /// Cuts, s.
    pub cutting_s: f64,
    /// Rapids, s.
    pub rapid_s: f64,
    /// Everything else, s.
    pub other_s: f64,
    /// What everything else is.
    pub waits: Vec<WaitTime>,
    /// Length of the cuts over their feed, and of the rapids over rapid speed, s.
    pub at_feed_s: f64,
    /// Cuts that have no feed and so no time.
    pub cuts_without_feed: u64,
    /// Limits that the machine file does not give and that were assumed.
    pub assumed: Vec<String>,
    /// Operations in the order of the run.
    pub operations: CappedRows<Operation>,
    /// The blocks that take the most time.
    pub longest: Vec<ReportedBlock>,
}

/// A reason to wait.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WaitTime {
    /// For what.
    pub what: &'static str,
    /// How long together, s.
    pub time_s: f64,
}

/// What a tool does from one tool change, or from one comment on a line of its own, to the next.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Operation {
    /// Number of the tool.
    pub tool: u32,
    /// The comment it begins with.
    pub comment: Option<String>,
    /// Its first line.
    pub first_line: u32,
    /// Its last line.
    pub last_line: u32,
    /// All of it, s.
    pub total_s: f64,
    /// Cuts, s.
    pub cutting_s: f64,
    /// Rapids, s.
    pub rapid_s: f64,
    /// Everything else, s.
    pub other_s: f64,
}

/// A block and its time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReportedBlock {
    /// Its line.
    pub line: u32,
    /// Its file, where it is not the program's.
    pub file: Option<String>,
    /// Its words.
    pub text: String,
    /// How often it ran.
    pub runs: u64,
    /// All runs, s.
    pub time_s: f64,
    /// Why it takes that long.
    pub reason: &'static str,
}

/// The least and the largest feed of cuts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct FeedRange {
    /// mm/min.
    pub mm_per_min: Option<(f64, f64)>,
    /// mm per revolution.
    pub mm_per_rev: Option<(f64, f64)>,
    /// Some cuts have the time of their block instead of a feed (G93).
    pub inverse_time: bool,
}

/// A tool and what it does.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReportedTool {
    /// Its number; 0 before any tool was changed.
    pub number: u32,
    /// What the program says of it, in a comment at its call or at the head.
    pub comment: Option<String>,
    /// What the machine's tool table says of it.
    pub table: Option<String>,
    /// Line of its first call.
    pub line: Option<u32>,
    /// How often it goes into the spindle.
    pub changes: u64,
    /// Numbers of the length offsets that are active with it.
    pub length_offsets: Vec<u32>,
    /// Numbers of the radius offsets that are active with it.
    pub radius_offsets: Vec<u32>,
    /// Diameter by the tool table, or where that gives none by a comment of the program, mm.
    pub diameter_mm: Option<f64>,
    /// The nose radius of an insert by the tool table, mm.
    pub nose_radius_mm: Option<f64>,
    /// The number of the direction of its tip.
    pub tip: Option<u32>,
    /// What it is: a word of the machine file's `shape`.
    pub shape: Option<&'static str>,
    /// The diameter or the shape is a comment's.
    pub by_comment: bool,
    /// Least and largest spindle speed of its cuts, rev/min.
    pub rpm: Option<(f64, f64)>,
    /// The spindle turns clockwise (M3) in its cuts.
    pub clockwise: bool,
    /// The spindle turns counter-clockwise (M4) in its cuts.
    pub counterclockwise: bool,
    /// Feeds of its cuts.
    pub feeds: FeedRange,
    /// The lowest Z of its cuts in program coordinates, mm.
    pub lowest_z_mm: Option<f64>,
    /// Length of its cuts, mm.
    pub cut_mm: f64,
    /// Coolant during its cuts: `flood`, `mist`, `through tool`.
    pub coolant: Vec<&'static str>,
    /// Its time, its changes included, s.
    pub time_s: Option<f64>,
}

/// A value of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AxisValue {
    /// Letter of the axis.
    pub axis: char,
    /// mm or degrees; `None`: not set.
    pub value: Option<f64>,
}

/// A work offset that the program runs under.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReportedWorkOffset {
    /// Its name: `G54`, `E1`.
    pub name: String,
    /// The machine's values of the axes that move under it.
    pub values: Vec<AxisValue>,
    /// The program itself sets or moves it (G10, G52, G92); the first lines where it does.
    pub moved_at: Vec<u32>,
}

/// A tool offset that the program uses.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Register {
    /// Its number.
    pub number: u32,
    /// Tools that use it.
    pub tools: Vec<u32>,
    /// Its length is used.
    pub uses_length: bool,
    /// The length with its wear, mm; on a lathe the offset of Z. `None`: not set.
    pub length_mm: Option<f64>,
    /// On a lathe the offset of X with its wear, mm, a diameter where X is programmed so; `None`: not set.
    pub x_mm: Option<f64>,
    /// Its radius is used.
    pub uses_radius: bool,
    /// The diameter with its wear, mm; `None`: not set, or a tool with a nose radius.
    pub diameter_mm: Option<f64>,
    /// The nose radius with its wear, mm; `None`: not set, or a tool with a diameter.
    pub nose_radius_mm: Option<f64>,
    /// The number of the tip's direction.
    pub tip: Option<u32>,
    /// The program itself writes it (G10).
    pub by_program: bool,
}

/// Where an axis goes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AxisRange {
    /// Letter of the axis.
    pub axis: char,
    /// Lowest and highest place of all moves, mm or degrees.
    pub all: (f64, f64),
    /// The same of the cuts.
    pub cuts: Option<(f64, f64)>,
    /// Where the zero of this work offset may lie in machine coordinates, so that everything is
    /// within the machine's travel, mm; given where the offset is not set.
    pub zero_may_lie: Option<(f64, f64)>,
}

/// Where the tool goes in a work coordinate system.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Travel {
    /// Its name.
    pub name: String,
    /// The line where the program itself moved it there (G52, G92, G10).
    pub moved_at: Option<u32>,
    /// The axes that move.
    pub axes: Vec<AxisRange>,
}

/// An axis of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MachineTravel {
    /// Letter of the axis.
    pub axis: char,
    /// Its travel in machine coordinates, mm or degrees.
    pub limits: (f64, f64),
    /// Where it goes as far as that is known, machine coordinates.
    pub goes: Option<(f64, f64)>,
    /// Some moves lie where nobody knows in machine coordinates, because an offset is not set.
    pub partly_unknown: bool,
}

/// What an operator meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum StopKind {
    /// M0.
    Stop,
    /// M1.
    OptionalStop,
    /// Text on the screen.
    Message,
    /// A probe or skip move.
    Probe,
}

/// Where an operator is needed, or gets a message.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OperatorStop {
    /// What it is.
    pub kind: StopKind,
    /// Its line.
    pub line: u32,
    /// Its file, where it is not the program's.
    pub file: Option<String>,
    /// The tool in the spindle.
    pub tool: u32,
    /// The message, or the comment next to the stop.
    pub text: Option<String>,
    /// How often.
    pub times: u64,
}

/// Blocks that the block delete switch leaves out.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SkippedBlocks {
    /// Their lines in the program's text.
    pub lines: CappedRows<u32>,
    /// This report is of a run with the switch on.
    pub left_out: bool,
}

/// A program of a text.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CalledProgram {
    /// Its number, where it has one.
    pub number: Option<u32>,
    /// The comment after its head.
    pub title: Option<String>,
    /// Its file, where it is not the program's.
    pub file: Option<String>,
    /// The line of its head.
    pub line: u32,
}

/// A problem.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReportedProblem {
    /// `error`, `warning` or `note`.
    pub severity: &'static str,
    /// Stable number, as `CH401`.
    pub code: &'static str,
    /// Stable name.
    pub name: &'static str,
    /// One sentence with the measured numbers.
    pub message: String,
    /// Its file and line, where it has a place.
    pub place: Option<(String, u32)>,
    /// The lines with the words underlined.
    pub excerpt: String,
    /// What the control would show.
    pub alarm: Option<String>,
    /// Further facts, and the calls through which it was reached.
    pub notes: Vec<String>,
    /// What to do.
    pub help: Option<String>,
    /// The words to write instead.
    pub fix: Option<String>,
}

/// A volume between two bounds, mm³.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct VolumeBounds {
    /// Surely so much.
    pub least: f64,
    /// No more than that.
    pub most: f64,
}

/// What a tool removes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StockTool {
    /// Its number.
    pub number: u32,
    /// What it removes.
    pub removed_mm3: VolumeBounds,
    /// The lowest place of its tip at feed, mm.
    pub lowest_mm: Option<f64>,
    /// Its time, its changes included, s.
    pub time_s: Option<f64>,
}

/// A part that was cut off on a lathe.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StockPart {
    /// The line that cut it off.
    pub line: u32,
    /// mm³.
    pub volume_mm3: f64,
}

/// What is left of the stock.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReportedStock {
    /// The side of a column, mm; without one where the stock is exact.
    pub resolution_mm: Option<f64>,
    /// What is removed.
    pub removed_mm3: VolumeBounds,
    /// What is left.
    pub left_mm3: VolumeBounds,
    /// `clean`, `problems` or `not-proved`.
    pub verdict: &'static str,
    /// The same as a sentence.
    pub sentence: &'static str,
    /// Parts that were cut off, which are part of what is left.
    pub parts: CappedRows<StockPart>,
    /// By tool, in the order of their first cut.
    pub tools: CappedRows<StockTool>,
}

/// A view of the path as SVG.
#[derive(Clone, Debug, PartialEq)]
pub struct PathPicture {
    /// What it shows, for people.
    pub caption: String,
    /// The drawing.
    pub svg: String,
}

/// How the cuts of a tool are drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolSign {
    /// Number of the tool.
    pub number: u32,
    /// A piece of its line as SVG.
    pub svg: String,
}

/// The path in views.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PathPictures {
    /// The views; none where nothing moves.
    pub views: Vec<PathPicture>,
    /// The stock that is left, where one is given.
    pub stock: Option<PathPicture>,
    /// The legend.
    pub tools: Vec<ToolSign>,
    /// Cuts whose place nobody knows are not drawn.
    pub cuts_left_out: bool,
    /// What is said of axes that the program does not name, and that are drawn at zero, and of moves that are left out for
    /// their work offset.
    pub remarks: Vec<String>,
}
