//! Conversational programs with what is expected of them on the line; `tests/heidenhain/README.md` has the format.
//!
//! The first run of the first 68 programs and 89 faults, before anything was mended: 45 programs clean, 855 of 1033
//! expectations, 86 faults. The first run of the set of 120 and 300: 108, 2486 of 2576, 278.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use chordal::control::{AfterBlock, Command, CommandKind, Origin};
use chordal::diagnostics::FileId;
use chordal::geometry::{Transform, Vec3};
use chordal::path::PathCommand;
use chordal::{
    Diagnostic, Job, Machine, PathSink, RunOptions, RunSink, Severity, Sink, Source, SourceMap,
};
use chordal_heidenhain::syntax::LineReader;

/// Programs without an error or a warning, of all; may only become more.
const MIN_CLEAN: usize = 117;

/// Expectations that hold, of all; may only become more.
const MIN_RIGHT: usize = 2569;

/// Faults that are reported at their line, of all; may only become more.
const MIN_FAULTS: usize = 297;

/// How far a coordinate may be off: the set is rounded to three decimals, mm.
const TOLERANCE_MM: f64 = 1.1e-3;

/// How far an angle may be off, degrees.
const TOLERANCE_DEG: f64 = 1.1e-3;

/// Added to values that dwells record as seconds, so that negative ones can be recorded, too.
const VALUE_SHIFT: f64 = 100_000.0;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/heidenhain")
}

/// The commands of the tool centre, with the mark of those that compensation inserts.
#[derive(Default)]
struct KlartextPathRecord(Vec<(Command, bool)>);

impl PathSink for KlartextPathRecord {
    fn command(&mut self, path: PathCommand<'_>) {
        self.0.push((path.command.clone(), path.inserted));
    }

    fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}
}

/// The machine that a program names, with the preset at its zero and more travel than any program needs.
fn machine(text: &str) -> Machine {
    let name = match text.contains("machine with the tables A and C") {
        true => "heidenhain-ac-trunnion",
        false => "heidenhain-mill",
    };
    let mut machine = Machine::from_builtin(name).expect("a built-in machine");
    machine.axes.iter_mut().flatten().for_each(|axis| axis.travel = Some((-10_000.0, 10_000.0)));
    let offset = machine.work_offsets.entry("G54".to_string()).or_default();
    offset.values = [Some(0.0); 6];
    machine
}

/// A move of the tool's centre.
#[derive(Clone, Debug)]
struct RecordedMove {
    line: u32,
    kind: CommandKind,
    /// The tilted plane in whose coordinates it is.
    plane: Option<Transform>,
}

/// How often the blocks of the first text are carried out, by their first line.
#[derive(Default)]
struct BlockCount(BTreeMap<u32, usize>);

impl Sink for BlockCount {
    fn command(&mut self, _: &Command) {}

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for BlockCount {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, _: &AfterBlock) {
        if origin.span.file == FileId(0) {
            *self.0.entry(origin.line).or_default() += 1;
        }
    }
}

/// What a run leaves.
struct KlartextRunRecord {
    moves: Vec<RecordedMove>,
    /// How often each line is carried out.
    runs: BTreeMap<u32, usize>,
    /// One unit of the program, mm.
    unit_mm: f64,
    /// The values of each line in the order of its last run.
    values: BTreeMap<u32, Vec<f64>>,
    /// With the lines of the problem and of the blocks that called it.
    problems: Vec<(Vec<u32>, Diagnostic)>,
}

/// The expectations of a line.
fn notes(line: &str) -> Vec<String> {
    line.split("; = ").skip(1).map(|note| note.trim().to_string()).collect()
}

/// Whether the coordinates of a program are not those of the preset somewhere.
fn is_transformed(text: &str) -> bool {
    const WORDS: [&str; 10] = [
        "DEF 7.",
        "DEF 8.",
        "DEF 10.",
        "DEF 11.",
        "DEF 26.",
        "DEF 19.",
        "TRANS DATUM",
        "PLANE",
        "G54",
        "G28",
    ];
    WORDS.iter().any(|word| text.contains(word))
}

/// The parameters whose values a line expects.
fn parameters(notes: &[String]) -> Vec<String> {
    let names = notes.iter().filter(|note| note.starts_with('Q'));
    names.filter_map(|note| Some(note.split_once('=')?.0.to_string())).collect()
}

/// Whether a line expects a position of the tool tip in programmed coordinates.
fn expects_position(notes: &[String]) -> bool {
    notes.iter().any(|note| note.starts_with(['X', 'Y', 'Z']))
}

/// The text with dwells that record values after the lines that expect some, and the line of the file for each line.
fn with_values(text: &str) -> (String, Vec<u32>) {
    let (mut out, mut lines) = (String::new(), vec![0]);
    let records_places = is_transformed(text);
    // The same blocks in the other form of programs.
    let is_iso = text.starts_with('%');
    for (index, line) in text.lines().enumerate() {
        let number = index as u32 + 1;
        let notes = notes(line);
        let mut add = |text: &str| {
            out.push_str(text);
            out.push('\n');
            lines.push(number);
        };
        add(line);
        let dwell = match is_iso {
            true => "G04 F+Q1997*",
            false => "CYCL DEF 9.0 DWELL\nCYCL DEF 9.1 DWELL +Q1997",
        };
        let shifted = |name: &str| match is_iso {
            true => format!("D01 Q1997 P01 +{name} P02 +{VALUE_SHIFT}*"),
            false => format!("Q1997 = {name} + {VALUE_SHIFT}"),
        };
        for name in parameters(&notes) {
            add(&shifted(&name));
            dwell.lines().for_each(&mut add);
        }
        if records_places && expects_position(&notes) {
            for axis in 1..=3 {
                add(&match is_iso {
                    true => format!("D18 Q1997 ID270 NR1 IDX{axis}*"),
                    false => format!("FN 18: SYSREAD Q1997 = ID270 NR1 IDX{axis}"),
                });
                add(&shifted("Q1997"));
                dwell.lines().for_each(&mut add);
            }
        }
    }
    (out, lines)
}

/// Runs a program with those of its folder that others call.
fn run(path: &Path) -> KlartextRunRecord {
    let text = fs::read_to_string(path).expect("a program");
    let (with_values, lines) = with_values(&text);
    let mut sources = SourceMap::new();
    sources.add(Source::new(path.to_string_lossy().into_owned(), with_values.into_bytes()));
    for entry in fs::read_dir(path.parent().expect("a folder")).expect("a folder") {
        let other = entry.expect("a file").path();
        if is_called(&other) {
            let text = fs::read(&other).expect("a program");
            sources.add(Source::new(other.to_string_lossy().into_owned(), text));
        }
    }
    let options = RunOptions { max_repeated_blocks: 20_000, ..RunOptions::default() };
    let job = Job::new(sources, machine(&text)).expect("a job").options(options);
    let source = job.sources().get(FileId(0)).expect("the program");
    // The line of the file on which a block of several lines ends.
    let mut last_lines: BTreeMap<u32, u32> = BTreeMap::new();
    for block in LineReader::new(source.text()) {
        let last = source.line_of(block.range.end.saturating_sub(1).max(block.range.start));
        let last_line = lines.get(last as usize).copied().unwrap_or(0);
        (block.line..=last.max(block.line)).for_each(|line| _ = last_lines.insert(line, last_line));
    }
    let file_line = |line: u32| last_lines.get(&line).copied().unwrap_or(0);
    let mut record = KlartextPathRecord::default();
    let outcomes = job.compensated(None, &mut record);
    let calls = outcomes.first().map(|outcome| outcome.calls.clone()).unwrap_or_default();
    let line_of = |command: &Command| match command.origin.span.file {
        FileId(0) => file_line(command.origin.line),
        // What another program moves belongs to the block that calls it.
        _ => calls
            .resolve(command.origin.call)
            .last()
            .map_or(0, |span| file_line(source.line_of(span.range.start))),
    };
    let mut moves: Vec<RecordedMove> = Vec::new();
    let mut values: BTreeMap<u32, Vec<f64>> = BTreeMap::new();
    let mut plane = None;
    for (command, is_inserted) in &record.0 {
        if let CommandKind::PartFrame { frame, .. } = &command.kind {
            plane = frame.as_ref().map(|frame| frame.plane);
        }
        let line = match moves.last() {
            // The arc of a corner belongs to the block before it.
            Some(last) if *is_inserted => last.line,
            _ => line_of(command),
        };
        match &command.kind {
            CommandKind::Dwell { seconds, .. } if *seconds > VALUE_SHIFT / 2.0 => {
                values.entry(line).or_default().push(seconds - VALUE_SHIFT);
            }
            kind if kind.motion().is_some() => {
                moves.push(RecordedMove { line, kind: kind.clone(), plane });
            }
            _ => {}
        }
    }
    let mut counts = BlockCount::default();
    job.run(&mut counts);
    let runs = counts.0.into_iter().map(|(line, count)| (file_line(line), count)).collect();
    let is_inch = text.lines().any(|line| line.contains("BEGIN PGM") && line.contains("INCH"))
        || text.starts_with('%') && text.contains(" G70");
    let unit_mm = if is_inch { 25.4 } else { 1.0 };
    let report = job.check();
    let problems = report.diagnostics.into_iter().map(|found| {
        let spans = found.calls.iter().chain([&found.primary.span]);
        let own = spans.filter(|span| span.file == FileId(0));
        let lines = own.flat_map(|span| {
            let line = source.line_of(span.range.start);
            [lines.get(line as usize).copied().unwrap_or(0), file_line(line)]
        });
        (lines.collect(), found)
    });
    let problems = problems.collect();
    KlartextRunRecord { moves, runs, unit_mm, values, problems }
}

/// The value after a letter: `X+10.5`.
fn value(words: &str, letter: char) -> Option<f64> {
    words.split_whitespace().find_map(|word| word.strip_prefix(letter)?.parse().ok())
}

/// The coordinates that an expectation names, by axis.
fn place(words: &str) -> [Option<f64>; 3] {
    ['X', 'Y', 'Z'].map(|letter| value(words, letter))
}

fn is_near(found: [f64; 3], expected: [Option<f64>; 3]) -> bool {
    (0..3).all(|axis| expected[axis].is_none_or(|mm| (found[axis] - mm).abs() <= TOLERANCE_MM))
}

fn end_of(step: &RecordedMove) -> [f64; 3] {
    let to = step.kind.motion().expect("a move").to;
    [to[0], to[1], to[2]]
}

/// The map of the plane from programmed coordinates to those of the preset, by two points of lines that expect both.
#[derive(Default)]
struct ExpectedPlaneMap {
    pairs: Vec<([f64; 2], [f64; 2])>,
}

impl ExpectedPlaneMap {
    fn note(&mut self, notes: &[String]) {
        let find = |prefix: &str| {
            let note = notes.iter().find_map(|note| match prefix {
                "" => note.starts_with(['X', 'Y']).then_some(note.as_str()),
                prefix => note.strip_prefix(prefix),
            })?;
            let [x, y, _] = place(note);
            Some([x?, y?])
        };
        if let (Some(own), Some(work)) = (find(""), find("work "))
            && self.pairs.last().is_none_or(|(last, _)| *last != own)
        {
            self.pairs.push((own, work));
        }
    }

    /// A point of the preset in programmed coordinates: where the map turns, moves and enlarges alone, and where it
    /// mirrors, too.
    fn programmed(&self, point: [f64; 2]) -> [[f64; 2]; 2] {
        let [.., (own1, work1), (own2, work2)] = self.pairs.as_slice() else { return [point; 2] };
        let minus = |one: &[f64; 2], two: &[f64; 2]| [one[0] - two[0], one[1] - two[1]];
        let divide = |n: [f64; 2], d: [f64; 2]| {
            let squared = d[0] * d[0] + d[1] * d[1];
            [(n[0] * d[0] + n[1] * d[1]) / squared, (n[1] * d[0] - n[0] * d[1]) / squared]
        };
        [1.0, -1.0].map(|sign| {
            let flipped = |by: [f64; 2]| [by[0], sign * by[1]];
            let factor = divide(minus(own2, own1), flipped(minus(work2, work1)));
            let by = flipped(minus(&point, work1));
            [
                own1[0] + by[0] * factor[0] - by[1] * factor[1],
                own1[1] + by[0] * factor[1] + by[1] * factor[0],
            ]
        })
    }
}

/// The values that the last run of a line has recorded: those of its parameters in their order, then X, Y and Z.
fn recorded_values(record: &KlartextRunRecord, line: u32, count: usize) -> Option<&[f64]> {
    let all = record.values.get(&line)?;
    all.len().checked_sub(count).map(|from| &all[from..])
}

/// The moves of the last time that a line is carried out: those without a move of another line between them.
fn last_run(record: &KlartextRunRecord, line: u32) -> Vec<&RecordedMove> {
    let is_own = |step: &&RecordedMove| step.line == line;
    let mut own: Vec<&RecordedMove> =
        record.moves.iter().rev().skip_while(|step| !is_own(step)).take_while(is_own).collect();
    own.reverse();
    own
}

/// The last move of a line; without one, that before it.
fn last_move(record: &KlartextRunRecord, line: u32) -> Option<&RecordedMove> {
    let own = record.moves.iter().rposition(|step| step.line == line);
    let before = || record.moves.iter().rposition(|step| step.line <= line);
    own.or_else(before).map(|at| &record.moves[at])
}

/// Whether the rotary axes are where an expectation names them, degrees.
fn rotary_axes_agree(note: &str, step: Option<&RecordedMove>) -> bool {
    let named = [('A', 3), ('C', 5)].map(|(letter, axis)| (value(note, letter), axis));
    named.into_iter().filter_map(|(expected, axis)| Some((expected?, axis))).all(
        |(expected, axis)| {
            let to = step.and_then(|step| step.kind.motion()).map(|motion| motion.to[axis]);
            to.is_some_and(|angle| (angle.to_degrees() - expected).abs() <= TOLERANCE_DEG)
        },
    )
}

/// A number that an expectation names.
fn expected_number<T: std::str::FromStr>(words: &str) -> Result<T, String> {
    words.trim().parse().map_err(|_| "it names no number".to_string())
}

/// Checks an expectation of a line.
///
/// # Errors
/// What is found in its place.
fn check(
    note: &str,
    line: u32,
    notes: &[String],
    record: &KlartextRunRecord,
    map: Option<&ExpectedPlaneMap>,
) -> Result<(), String> {
    let own = last_run(record, line);
    // The axis of the tool is that of the deepest point.
    let deepest = notes.iter().find_map(|note| note.strip_prefix("lowest "));
    let tool_axis = deepest.and_then(|words| place(words).iter().position(Option::is_some));
    let tool_axis = tool_axis.unwrap_or(2);
    let names = parameters(notes);
    let has_places = map.is_some() && expects_position(notes);
    let recorded = || {
        let count = names.len() + if has_places { 3 } else { 0 };
        recorded_values(record, line, count).ok_or("nothing is recorded".to_string())
    };
    let (kind, words) = note.split_once(' ').unwrap_or((note, ""));
    let is_place = |found: Option<[f64; 3]>, words: &str| match found {
        Some(found) if is_near(found, place(words)) => Ok(()),
        found => Err(format!("{found:?}")),
    };
    let is_equal = |found: usize| match expected_number::<usize>(words)? {
        expected if expected == found => Ok(()),
        _ => Err(found.to_string()),
    };
    match kind {
        "clean" | "called" | "kind" | "says" | "fault" | "path" => Ok(()),
        "end" => is_place(record.moves.last().map(end_of), words),
        "work" => {
            let found = last_move(record, line).map(|step| {
                let end = Vec3::from_array(end_of(step));
                step.plane.map_or(end, |plane| plane.apply_point(end)).to_array()
            });
            is_place(found, words)
        }
        "centre" => {
            let arc = own.iter().rev().find_map(|step| Some((step.kind.shape()?, step.plane)));
            let (shape, plane) = arc.ok_or("no arc")?;
            let (a, b, _) = shape.plane.axes();
            // Coordinates of a tilted plane are those of the program.
            let centers = match map.filter(|_| plane.is_none()) {
                Some(map) => map.programmed(shape.center),
                None => [shape.center; 2],
            };
            let expected = place(words);
            let is_right = |center: &[f64; 2]| {
                [(a, center[0]), (b, center[1])].into_iter().all(|(axis, mm)| {
                    expected[axis].is_none_or(|expected| (mm - expected).abs() <= TOLERANCE_MM)
                })
            };
            if centers.iter().any(is_right) { Ok(()) } else { Err(format!("{centers:?}")) }
        }
        "runs" => is_equal(record.runs.get(&line).copied().unwrap_or(0)),
        "strokes" => is_equal(strokes(&own, tool_axis)),
        "lowest" => {
            let axis = tool_axis;
            let lowest = own.iter().map(|step| end_of(step)[axis]).fold(f64::INFINITY, f64::min);
            let lowest = match map.filter(|_| axis == 2) {
                // The shift of Z is that of the end of the line.
                Some(_) => {
                    let z = recorded()?.last().copied().ok_or("no position is recorded")?;
                    let z = z * record.unit_mm;
                    lowest - own.last().map_or(0.0, |step| end_of(step)[2]) + z
                }
                None => lowest,
            };
            let expected = place(words)[axis].ok_or("it names no axis")?;
            match (lowest - expected).abs() <= TOLERANCE_MM {
                true => Ok(()),
                false => Err(lowest.to_string()),
            }
        }
        "min" | "max" => {
            let sign = if kind == "min" { 1.0 } else { -1.0 };
            let mut found = [f64::INFINITY; 2];
            for step in own.iter().filter(|step| step.kind.feed().is_some()) {
                for point in points_of(step) {
                    (0..2).for_each(|axis| found[axis] = found[axis].min(sign * point[axis]));
                }
            }
            let [x, y, _] = place(words);
            let found = [sign * found[0], sign * found[1], 0.0];
            if is_near(found, [x, y, None]) { Ok(()) } else { Err(format!("{found:?}")) }
        }
        _ if note.starts_with('Q') => {
            let (name, expected) = note.split_once('=').ok_or("it names no value")?;
            let expected: f64 = expected_number(expected)?;
            let at = names.iter().position(|own| own == name).ok_or("it is not recorded")?;
            let found = recorded()?[at];
            match (found - expected).abs() <= TOLERANCE_MM {
                true => Ok(()),
                false => Err(found.to_string()),
            }
        }
        _ if note.starts_with(['X', 'Y', 'Z', 'A', 'C']) => {
            let step = last_move(record, line);
            if !rotary_axes_agree(note, step) {
                return Err(format!("{:?}", step.and_then(|step| step.kind.motion())));
            }
            match has_places {
                true => {
                    let [.., x, y, z] = *recorded()? else { return Err("no position".into()) };
                    is_place(Some([x, y, z].map(|length| length * record.unit_mm)), note)
                }
                false => is_place(step.map(end_of), note),
            }
        }
        _ => Err("is not checked".into()),
    }
}

/// The feed moves along the axis of the tool to a new depth, of the last hole.
fn strokes(own: &[&RecordedMove], axis: usize) -> usize {
    let (mut count, mut depth) = (0, f64::INFINITY);
    for step in own {
        let motion = step.kind.motion().expect("a move");
        let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
        let across = (motion.to[a] - motion.from[a]).hypot(motion.to[b] - motion.from[b]);
        let is_rapid = step.kind.feed().is_none();
        // Further than a boring tool leaves its wall is the next hole.
        if is_rapid && across > 1.0 {
            (count, depth) = (0, f64::INFINITY);
        }
        let deeper = motion.to[axis] < depth - 1e-6 && motion.to[axis] < motion.from[axis];
        if !is_rapid && deeper {
            count += 1;
            depth = motion.to[axis];
        }
    }
    count
}

/// Points of a move, close to each other on arcs.
fn points_of(step: &RecordedMove) -> Vec<[f64; 2]> {
    let motion = step.kind.motion().expect("a move");
    let mut points = vec![[motion.from[0], motion.from[1]], [motion.to[0], motion.to[1]]];
    if let Some(shape) = step.kind.shape() {
        let from = [motion.from[0] - shape.center[0], motion.from[1] - shape.center[1]];
        for part in 0..=720 {
            let (sin, cos) = (shape.sweep * f64::from(part) / 720.0).sin_cos();
            points.push([
                shape.center[0] + from[0] * cos - from[1] * sin,
                shape.center[1] + from[0] * sin + from[1] * cos,
            ]);
        }
    }
    points
}

/// The points of a compensated path that a line expects, in their order; what is wrong for each.
fn check_path(notes: &[String], line: u32, text: &str, record: &KlartextRunRecord) -> Vec<String> {
    // The end of an element at a corner stands on the line of the corner.
    let is_corner = ["RND", "CHF", "G24", "G25"].iter().any(|word| text.contains(word));
    let first = if is_corner { line - 1 } else { line };
    let of_line = || record.moves.iter().filter(move |step| (first..=line).contains(&step.line));
    // A rounding is named with the point where it begins.
    let start = of_line().next().map(|step| {
        let from = step.kind.motion().expect("a move").from;
        [from[0], from[1], from[2]]
    });
    let mut own = start.into_iter().chain(of_line().map(end_of));
    let mut wrong = Vec::new();
    for note in notes {
        let Some(words) = note.strip_prefix("path ") else { continue };
        let expected = place(words);
        if !own.any(|end| is_near(end, expected)) {
            wrong.push(format!("line {line}: `{note}`: not in the path"));
        }
    }
    wrong
}

/// Whether a file is called by a program, or is a table of one.
fn is_called(path: &Path) -> bool {
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let part = stem.rsplit_once("-called").map(|(_, rest)| rest);
    matches!(part, Some("" | "-a" | "-b")) || path.extension().is_some_and(|own| own == "d")
}

/// What a program shows.
struct ProgramResult {
    expectations: usize,
    wrong: Vec<String>,
    problems: Vec<String>,
}

fn text_of(found: &Diagnostic) -> String {
    let alarm = found.alarm.as_deref().unwrap_or("");
    format!("{} [{alarm}] {}", found.code.info().id, found.message)
}

fn check_program(path: &Path) -> ProgramResult {
    let text = fs::read_to_string(path).expect("a program");
    let record = run(path);
    let is_mapped = is_transformed(&text);
    let mut map = ExpectedPlaneMap::default();
    let (mut expectations, mut wrong) = (0, Vec::new());
    for (index, line) in text.lines().enumerate() {
        let number = index as u32 + 1;
        let notes = notes(line);
        map.note(&notes);
        let is_counted = |note: &&String| !matches!(note.as_str(), "clean" | "called");
        expectations += notes.iter().filter(is_counted).count();
        let own_map = is_mapped.then_some(&map);
        for note in &notes {
            if let Err(found) = check(note, number, &notes, &record, own_map) {
                wrong.push(format!("line {number}: `{note}`: {found}"));
            }
        }
        wrong.extend(check_path(&notes, number, line, &record));
    }
    let is_problem = |found: &Diagnostic| found.severity != Severity::Note;
    let problems = record.problems.iter().filter(|(_, found)| is_problem(found));
    let problems = problems.map(|(lines, found)| format!("{lines:?} {}", text_of(found)));
    ProgramResult { expectations, wrong, problems: problems.collect() }
}

fn programs(part: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder().join(part)).expect("the programs");
    let files = entries.map(|entry| entry.expect("a file").path());
    let is_program = |path: &PathBuf| {
        !is_called(path) && path.extension().is_some_and(|own| own == "h" || own == "i")
    };
    let mut files: Vec<PathBuf> = files.filter(is_program).collect();
    files.sort();
    files
}

#[test]
fn right_programs_do_what_they_say() {
    let (mut clean, mut all, mut right) = (0, 0, 0);
    let files = programs("programs");
    for path in &files {
        let result = check_program(path);
        let name = path.file_name().expect("a name").to_string_lossy();
        clean += usize::from(result.problems.is_empty());
        all += result.expectations;
        right += result.expectations - result.wrong.len();
        if !result.problems.is_empty() || !result.wrong.is_empty() {
            println!("{name}: {} of {} wrong", result.wrong.len(), result.expectations);
            result.problems.iter().take(3).for_each(|problem| println!("    ! {problem}"));
            result.wrong.iter().take(3).for_each(|problem| println!("    {problem}"));
        }
    }
    println!("{clean} of {} programs are clean, {right} of {all} expectations hold", files.len());
    assert!(clean >= MIN_CLEAN, "{clean} programs are clean");
    assert!(right >= MIN_RIGHT, "{right} expectations hold");
}

#[test]
fn faults_are_found_at_their_line() {
    let (mut found, mut said, mut sayings) = (0, 0, 0);
    let files = programs("faults");
    for path in &files {
        let text = fs::read_to_string(path).expect("a program");
        let record = run(path);
        let lines: Vec<u32> = text
            .lines()
            .enumerate()
            .filter(|(_, line)| notes(line).iter().any(|note| note == "fault"))
            .map(|(index, _)| index as u32 + 1)
            .collect();
        let says = text
            .lines()
            .flat_map(notes)
            .find_map(|note| note.strip_prefix("says ").map(str::to_string));
        let own = || {
            record.problems.iter().filter(|(at, found)| {
                found.severity != Severity::Note && at.iter().any(|line| lines.contains(line))
            })
        };
        let is_found = own().next().is_some();
        found += usize::from(is_found);
        let is_said = |words: &String| {
            own().any(|(_, found)| found.alarm.as_ref().is_some_and(|alarm| alarm.contains(words)))
        };
        if let Some(words) = &says {
            sayings += 1;
            said += usize::from(is_said(words));
        }
        let name = path.file_name().expect("a name").to_string_lossy();
        if !is_found {
            println!("{name}: not at {lines:?}");
            for (at, problem) in &record.problems {
                println!("    {at:?} {}", text_of(problem));
            }
        } else if says.as_ref().is_some_and(|words| !is_said(words)) {
            println!("{name}: is found and does not say {says:?}");
        }
    }
    println!(
        "{found} of {} faults are found, {said} of {sayings} with the control's words",
        files.len()
    );
    assert!(found >= MIN_FAULTS, "{found} faults are found");
}
