//! Runs a program of the set and takes down what it does.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use chordal::control::{AfterBlock, Command, CommandKind, Origin};
use chordal::diagnostics::FileId;
use chordal::geometry::Transform;
use chordal::path::PathCommand;
use chordal::{Diagnostic, Job, Machine, PathSink, RunOptions, RunSink, Sink, Source, SourceMap};
use chordal_heidenhain::syntax::LineReader;

/// Added to values that dwells record as seconds, so that negative ones can be recorded, too.
const VALUE_SHIFT: f64 = 100_000.0;

/// The commands of the tool centre, with the mark of those that compensation inserts.
#[derive(Default)]
pub struct KlartextPathRecord(Vec<(Command, bool)>);

impl PathSink for KlartextPathRecord {
    fn command(&mut self, path: PathCommand<'_>) {
        self.0.push((path.command.clone(), path.inserted));
    }

    fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}
}

/// The machine that a program names, with the preset at its zero and more travel than any program needs.
pub fn machine(text: &str) -> Machine {
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
pub struct RecordedMove {
    pub line: u32,
    pub kind: CommandKind,
    /// The tilted plane in whose coordinates it is.
    pub plane: Option<Transform>,
}

/// How often the blocks of the first text are carried out, by their first line.
#[derive(Default)]
pub struct BlockCount(BTreeMap<u32, usize>);

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
pub struct KlartextRunRecord {
    pub moves: Vec<RecordedMove>,
    /// How often each line is carried out.
    pub runs: BTreeMap<u32, usize>,
    /// One unit of the program, mm.
    pub unit_mm: f64,
    /// The values of each line in the order of its last run.
    pub values: BTreeMap<u32, Vec<f64>>,
    /// With the lines of the problem and of the blocks that called it.
    pub problems: Vec<(Vec<u32>, Diagnostic)>,
}

/// The expectations of a line.
pub fn notes(line: &str) -> Vec<String> {
    line.split("; = ").skip(1).map(|note| note.trim().to_string()).collect()
}

/// Whether the coordinates of a program are not those of the preset somewhere.
pub fn is_transformed(text: &str) -> bool {
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
pub fn parameters(notes: &[String]) -> Vec<String> {
    let names = notes.iter().filter(|note| note.starts_with('Q'));
    names.filter_map(|note| Some(note.split_once('=')?.0.to_string())).collect()
}

/// Whether a line expects a position of the tool tip in programmed coordinates.
pub fn expects_position(notes: &[String]) -> bool {
    notes.iter().any(|note| note.starts_with(['X', 'Y', 'Z']))
}

/// The text with dwells that record values after the lines that expect some, and the line of the file for each line.
pub fn with_values(text: &str) -> (String, Vec<u32>) {
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
pub fn run(path: &Path) -> KlartextRunRecord {
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

/// Whether a file is called by a program, or is a table of one.
pub fn is_called(path: &Path) -> bool {
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let part = stem.rsplit_once("-called").map(|(_, rest)| rest);
    matches!(part, Some("" | "-a" | "-b")) || path.extension().is_some_and(|own| own == "d")
}
