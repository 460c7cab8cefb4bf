//! Computes the rows of a file.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use chordal::control::EndReason;
use chordal::control::ProgramPlace;
use chordal::diagnostics::TextRange;
use chordal::diagnostics::{Diagnostic, FileId, line_ends};
use chordal::machine::{AXES, AXIS_LETTERS};
use chordal::motion::{LimitError, MotionOptions};
use chordal::stock::{StockLeft, StockOptions, TileJob, VolumeInterval};
use chordal::{Job, Machine, Report, RunOptions, RunWatch, Source, SourceMap};
use chordal_export::sha256_hex;

use crate::columns::ARCHIVE_COLUMNS;
use crate::row::{ArchiveRow, ArchivedProblem, FileRecord, RanStock, RunTotals};

/// The most problems of a program that are listed; all are counted.
const MAX_PROBLEMS: usize = 20;

/// The most bytes that are searched for the programs of one file, because each program searches the whole text for
/// its subprograms. A file that needs more is run as one program.
const MAX_SEARCHED: u64 = 1 << 33;

/// A program with more moves than its text suggests (`MOVES_AT_ONCE` plus `MOVES_OF_A_LINE` per line) contains loops,
/// perhaps endless ones. It is planned only when it is known to end, because planning takes several times as long as
/// everything else.
const MOVES_AT_ONCE: u64 = 10_000;
const MOVES_OF_A_LINE: u64 = 4;

/// A file with everything on which its run depends.
#[derive(Clone, Debug)]
pub struct PreparedFile {
    /// Names and texts: first the program as a control reads it, then its subprograms.
    pub texts: Vec<(String, Vec<u8>)>,
    /// The machine on which it is run.
    pub machine: Machine,
    /// Why this machine was chosen, in a line or a word.
    pub chosen: String,
    /// The options of the run, such as its limit on blocks.
    pub options: RunOptions,
    /// The meshes that the setup of its machine names, by file name; empty when the stock is not cut.
    pub meshes: Vec<(String, Result<Vec<u8>, String>)>,
}

/// Loads files and their machines. Errors are one-line messages.
pub trait FileLoader {
    /// Whether the name alone shows that the file is not a program, so that it is not read.
    fn is_other_by_name(&self, path: &Path) -> bool;

    /// Reads a file.
    ///
    /// # Errors The message of the system.
    fn read(&mut self, path: &Path) -> Result<Vec<u8>, String>;

    /// Whether the content may be a program.
    fn may_be_program(&self, bytes: &[u8]) -> bool;

    /// Determines the machine of a program and loads its subprograms.
    ///
    /// # Errors A machine file or an assignment is wrong.
    fn prepare(&mut self, path: &Path, bytes: Vec<u8>) -> Result<PreparedFile, String>;

    /// Reads a mesh file that the setup of a machine names.
    ///
    /// # Errors The message of the system, or that there are no such files.
    fn named_file(&mut self, name: &str) -> Result<Vec<u8>, String> {
        Err(format!("there is no file {name}"))
    }
}

/// What is computed for every program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArchiveOptions {
    /// Plans the motion, for times with acceleration and jerk.
    pub plan: bool,
    /// Cuts the stock of the setup of each program.
    pub stock: bool,
}

/// A digest of everything on which the rows of a file depend: the versions of Chordal and of the columns, the
/// options, the machine, the file and the files of its subprograms.
pub fn file_key(file_sha256: &str, prepared: &PreparedFile, options: ArchiveOptions) -> String {
    let budget = prepared.options.max_repeated_blocks;
    let mut about = format!(
        "{ARCHIVE_COLUMNS}\n{}\n{}\n{budget}\n{file_sha256}\n{}\n",
        env!("CARGO_PKG_VERSION"),
        options.plan,
        prepared.chosen,
    );
    about.push_str(&sha256_hex(prepared.machine.to_toml().as_bytes()));
    if options.stock {
        about.push_str("\nstock");
    }
    for (name, mesh) in &prepared.meshes {
        let mesh = mesh.as_deref().unwrap_or_default();
        about.push_str(&format!("\n{name}\n{}", sha256_hex(mesh)));
    }
    for (name, text) in prepared.texts.iter().skip(1) {
        about.push_str(&format!("\n{name}\n{}", sha256_hex(text)));
    }
    sha256_hex(about.as_bytes())
}

/// Checks a file; `None` when `is_known` returns true for its key.
///
/// No content of a file is an error here: a file that cannot be read or run gets a row with a message.
pub fn check_file(
    loader: &mut impl FileLoader,
    path: &Path,
    options: ArchiveOptions,
    is_known: impl FnOnce(&str) -> bool,
) -> Option<FileRecord> {
    match gather(loader, path, options) {
        ClassifiedFile::Program { key, about, prepared } => {
            let is_new = !is_known(&key);
            is_new.then(|| FileRecord { rows: rows(&prepared, options), ..about.record(key) })
        }
        ClassifiedFile::Other(record) => (!is_known(&record.key)).then_some(record),
    }
}

/// The size and the digest of a file.
struct FileDigest {
    bytes: u64,
    sha256: String,
}

impl FileDigest {
    fn record(self, key: String) -> FileRecord {
        FileRecord { key, file_bytes: self.bytes, file_sha256: Some(self.sha256), rows: Vec::new() }
    }
}

/// A file classified before running it.
enum ClassifiedFile {
    Program { key: String, about: FileDigest, prepared: Box<PreparedFile> },
    Other(FileRecord),
}

fn gather(loader: &mut impl FileLoader, path: &Path, options: ArchiveOptions) -> ClassifiedFile {
    if loader.is_other_by_name(path) {
        return ClassifiedFile::Other(other(
            None,
            "other",
            "skipped",
            "its name says that it is not a program",
        ));
    }
    let bytes = match loader.read(path) {
        Ok(bytes) => bytes,
        Err(message) => {
            let key = sha256_hex(format!("unreadable\n{message}").as_bytes());
            return ClassifiedFile::Other(FileRecord::unreadable(key, message));
        }
    };
    let about = FileDigest { bytes: bytes.len() as u64, sha256: sha256_hex(&bytes) };
    let sample = &bytes[..bytes.len().min(1 << 16)];
    if bytes.iter().all(|byte| byte.is_ascii_whitespace() || matches!(byte, 0 | b'%')) {
        return ClassifiedFile::Other(other(
            Some(about),
            "empty",
            "failed",
            "there is no word in the file",
        ));
    }
    if chordal::syntax::decode(sample).binary {
        let message = "the file holds binary data, not an NC program";
        return ClassifiedFile::Other(other(Some(about), "binary", "failed", message));
    }
    if !loader.may_be_program(sample) {
        let message = "no line of the file begins like a block";
        return ClassifiedFile::Other(other(Some(about), "other", "skipped", message));
    }
    let prepare = || {
        let mut prepared = loader.prepare(path, bytes)?;
        if options.stock {
            let names = meshes(&prepared.machine);
            let read = |name: String| (name.clone(), loader.named_file(&name));
            prepared.meshes = names.into_iter().map(read).collect();
        }
        Ok(prepared)
    };
    match guarded(prepare) {
        Ok(prepared) => ClassifiedFile::Program {
            key: file_key(&about.sha256, &prepared, options),
            about,
            prepared: Box::new(prepared),
        },
        Err(message) => ClassifiedFile::Other(other(Some(about), "program", "failed", &message)),
    }
}

/// The files that the setup of a machine names.
fn meshes(machine: &Machine) -> Vec<String> {
    let setup = &machine.setup;
    let bodies = setup.stock.iter().chain(setup.fixtures.values()).chain(&setup.target);
    let mut names: Vec<String> = bodies.filter_map(|body| body.file.clone()).collect();
    names.sort();
    names.dedup();
    names
}

/// The record of a file of which no program is run.
fn other(about: Option<FileDigest>, kind: &str, status: &str, message: &str) -> FileRecord {
    let about = about.unwrap_or(FileDigest { bytes: 0, sha256: String::new() });
    let described = format!("{ARCHIVE_COLUMNS}\n{kind}\n{}\n{message}", about.sha256);
    let row = ArchiveRow {
        kind: kind.into(),
        status: status.into(),
        message: Some(message.into()),
        ..ArchiveRow::default()
    };
    let mut record = about.record(sha256_hex(described.as_bytes()));
    record.file_sha256 = record.file_sha256.filter(|digest| !digest.is_empty());
    record.rows.push(row);
    record
}

/// The rows of all programs of a file.
fn rows(prepared: &PreparedFile, options: ArchiveOptions) -> Vec<ArchiveRow> {
    // An empty range stands for the whole file.
    let nothing = TextRange::new(0, 0);
    let whole = ProgramPlace {
        file: FileId(0),
        name: None,
        head: nothing,
        range: nothing,
        line: 1,
        is_main: true,
    };
    let found = guarded(|| job(prepared).map(|job| job.programs()));
    let programs = match found {
        Ok(programs) => programs,
        Err(message) => return vec![failed(prepared, &whole, 0, message)],
    };
    let mains = programs.iter().filter(|program| program.is_main).count() as u64;
    if mains * prepared.texts[0].1.len() as u64 > MAX_SEARCHED {
        let mut row = one(prepared, &whole, None, options);
        let message =
            format!("{mains} programs in one file were run as one program; split the file");
        row.message = row.message.or(Some(message));
        return vec![row];
    }
    let alone = programs.len() == 1;
    programs
        .iter()
        .enumerate()
        .map(|(place, program)| one(prepared, program, (!alone).then_some(place), options))
        .collect()
}

/// The row of the program at `place`; `None` runs the file as a whole.
fn one(
    prepared: &PreparedFile,
    program: &ProgramPlace,
    place: Option<usize>,
    options: ArchiveOptions,
) -> ArchiveRow {
    if !program.is_main {
        let message = "run where it is called".to_string();
        let row = described(prepared, program, place.unwrap_or(0));
        return ArchiveRow {
            kind: "subprogram".into(),
            status: "called".into(),
            message: Some(message),
            ..row
        };
    }
    match guarded(|| run(prepared, place, options)) {
        Ok((ran, message)) => {
            let [errors, warnings, _] = ran.counts;
            let status = match (errors, warnings) {
                _ if ran.end == "budget" => "stopped",
                (1.., _) => "errors",
                (_, 1..) => "warnings",
                _ => "ok",
            };
            let row = described(prepared, program, place.unwrap_or(0));
            ArchiveRow { status: status.into(), message, ran: Some(ran), ..row }
        }
        Err(message) => failed(prepared, program, place.unwrap_or(0), message),
    }
}

fn failed(
    prepared: &PreparedFile,
    program: &ProgramPlace,
    place: usize,
    message: String,
) -> ArchiveRow {
    let row = described(prepared, program, place);
    ArchiveRow { status: "failed".into(), message: Some(message), ..row }
}

/// The values of a row that are known without running the program.
fn described(prepared: &PreparedFile, program: &ProgramPlace, place: usize) -> ArchiveRow {
    let text = &prepared.texts[0].1;
    let start = program.range.start as usize;
    // The program that represents the whole file has an empty range.
    let end = if program.range.end == 0 { text.len() } else { program.range.end as usize };
    let own = text.get(start..end).unwrap_or_default();
    ArchiveRow {
        kind: "program".into(),
        program: program.key(),
        place: place as u32,
        line: program.line,
        lines: lines(own),
        bytes: own.len() as u64,
        sha256: Some(sha256_hex(own)),
        control: Some(prepared.machine.control.as_str().into()),
        machine: Some(prepared.machine.name.clone()),
        chosen: Some(prepared.chosen.clone()),
        ..ArchiveRow::default()
    }
}

/// The number of lines of a text with any line ends; a last line without an end counts.
fn lines(text: &[u8]) -> u64 {
    let count = line_ends(text).count() as u64;
    count + u64::from(!matches!(text.last(), None | Some(b'\n' | b'\r')))
}

/// Calls a function and turns a panic in it into an error.
pub(crate) fn guarded<T>(question: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(question)).unwrap_or_else(|payload| {
        let reported = payload.downcast_ref::<String>().map(String::as_str);
        let reported =
            reported.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("a panic");
        Err(format!("Chordal itself failed on it: {reported}; please report the program"))
    })
}

pub(crate) fn job(prepared: &PreparedFile) -> Result<Job<'_>, String> {
    let mut sources = SourceMap::new();
    for (name, text) in &prepared.texts {
        sources.add(Source::new(name.as_str(), text.as_slice()));
    }
    let job = Job::new(sources, prepared.machine.clone()).map_err(|error| error.to_string())?;
    Ok(job.options(prepared.options.clone()))
}

/// Runs a program; the message says why its time or its stock is missing.
fn run(
    prepared: &PreparedFile,
    place: Option<usize>,
    options: ArchiveOptions,
) -> Result<(RunTotals, Option<String>), String> {
    let mut job = job(prepared)?;
    if let Some(place) = place {
        job = job.program_at(place);
    }
    let stock = if options.stock { Some(cut(&job, prepared)) } else { None };
    let (mut ran, message) = run_job(&job, prepared, options)?;
    let message = match stock {
        None => message,
        Some(Err(why)) => message.or(Some(why)),
        Some(Ok(found)) => {
            // This report has the problems of the run and of the stock.
            let counts = found.report().counts;
            (ran.codes, ran.problems) = problems(&job, found.report());
            ran.counts = [counts.errors, counts.warnings, counts.notes];
            let bounds = |amount: VolumeInterval| [amount.least, amount.most];
            let [removed, left] = found.volumes_mm3();
            ran.stock = Some(RanStock {
                verdict: found.verdict().as_str().into(),
                problems: found.problems(),
                removed_mm3: bounds(removed),
                left_mm3: bounds(left),
                resolution_mm: found.resolution_mm(),
            });
            message
        }
    };
    Ok((ran, message))
}

/// Computes what a program leaves of the stock of its setup.
fn cut(job: &Job<'_>, prepared: &PreparedFile) -> Result<StockLeft, String> {
    let files = |name: &str| {
        let own = prepared.meshes.iter().find(|(known, _)| known == name);
        own.map_or_else(|| Err(format!("there is no file {name}")), |(_, mesh)| mesh.clone())
    };
    // Programs already run in parallel, so the tiles of one program are computed in sequence.
    let one_by_one = |tiles: Vec<TileJob>| tiles.into_iter().map(TileJob::run).collect();
    job.stock_left(&StockOptions::default(), &files, &one_by_one).map_err(|error| error.to_string())
}

fn run_job(
    job: &Job<'_>,
    prepared: &PreparedFile,
    options: ArchiveOptions,
) -> Result<(RunTotals, Option<String>), String> {
    let ((report, timed), _) = run_planned(job, prepared, options.plan, || {});
    Ok(match timed {
        Ok(planned) => (ran(job, &report, planned), None),
        Err(error) => (ran(job, &report, None), Some(format!("no time: {error}"))),
    })
}

/// The report of a run with its cutting, rapid and other time, s, or why it has none. The times are `None` for a
/// program that reached its limit on blocks and for one that was not planned.
pub(crate) type PlannedRun = (Report, Result<Option<[f64; 3]>, LimitError>);

/// Runs a job and plans its motion if `plan` is set. Returns the watch of the decisive run: a program with very many
/// moves is run a second time once it is known to end.
pub(crate) fn run_planned<W: RunWatch>(
    job: &Job<'_>,
    prepared: &PreparedFile,
    plan: bool,
    watch: impl Fn() -> W,
) -> (PlannedRun, W) {
    let mut seen = watch();
    if !plan {
        return ((job.report_watched(&mut seen), Ok(None)), seen);
    }
    let lines = prepared.texts.iter().map(|(_, text)| lines(text)).sum::<u64>();
    let motion = MotionOptions::default();
    let (mut report, mut timed) =
        job.report_timed(&motion, MOVES_AT_ONCE + MOVES_OF_A_LINE * lines, &mut seen);
    let is_stopped = end_word(&report) == "budget";
    if matches!(timed, Ok(None)) && !is_stopped {
        seen = watch();
        (report, timed) = job.report_timed(&motion, u64::MAX, &mut seen);
    }
    // The time of a stopped program depends on the limit and not on the program.
    let times = timed.map(|timed| timed.filter(|_| !is_stopped).map(|timed| timed.time.times));
    let parts =
        times.map(|times| times.map(|times| [times.cutting_s, times.rapid_s, times.other_s]));
    ((report, parts), seen)
}

fn ran(job: &Job<'_>, report: &Report, planned: Option<[f64; 3]>) -> RunTotals {
    let summary = &report.summary;
    let mut travel = [None; AXES];
    for axis in &summary.axes {
        if let Some(place) = AXIS_LETTERS.find(axis.letter) {
            let (low, high) = axis.range;
            let of = |value: f64| if place < 3 { value } else { value.to_degrees() };
            travel[place] = Some((of(low), of(high)));
        }
    }
    let counts = report.counts;
    let (codes, problems) = problems(job, report);
    RunTotals {
        end: end_word(report).into(),
        inch: summary.inch,
        blocks: report.outcomes.iter().map(|outcome| outcome.blocks).sum(),
        cuts: summary.lines + summary.arcs + summary.helices + summary.spirals + summary.splines,
        rapids: summary.rapids,
        tools: summary.tools.iter().map(|tool| tool.number).collect(),
        travel,
        cut_length_mm: summary.feed_length_mm,
        rapid_length_mm: summary.rapid_length_mm,
        at_feed_s: summary.total_time_s(),
        planned,
        stock: None,
        counts: [counts.errors, counts.warnings, counts.notes],
        codes,
        problems,
    }
}

/// How a run ended; for several programs, the worst end.
fn end_word(report: &Report) -> &'static str {
    let words = [
        (EndReason::Budget, "budget"),
        (EndReason::Alarm, "alarm"),
        (EndReason::LostJump, "lost jump"),
        (EndReason::EndOfText, "end of text"),
        (EndReason::Repeats, "repeats"),
        (EndReason::ProgramEnd, "program end"),
    ];
    let ended = |reason: EndReason| report.outcomes.iter().any(|outcome| outcome.end == reason);
    words.iter().find(|(reason, _)| ended(*reason)).map_or("not run", |(_, word)| word)
}

/// The codes and the first problems, the most severe first and then by position.
fn problems(job: &Job<'_>, report: &Report) -> (Vec<String>, Vec<ArchivedProblem>) {
    let mut by_weight: Vec<&Diagnostic> = report.diagnostics.iter().collect();
    by_weight.sort_by_key(|diagnostic| std::cmp::Reverse(diagnostic.severity));
    let mut codes: Vec<String> = Vec::new();
    for diagnostic in &by_weight {
        let code = diagnostic.code.info().id;
        if !codes.iter().any(|own| own == code) {
            codes.push(code.into());
        }
    }
    let first = by_weight.iter().take(MAX_PROBLEMS);
    (codes, first.map(|diagnostic| problem(job, diagnostic)).collect())
}

/// A diagnostic in the form of a row.
pub(crate) fn problem(job: &Job<'_>, diagnostic: &Diagnostic) -> ArchivedProblem {
    ArchivedProblem {
        severity: diagnostic.severity.word().into(),
        code: diagnostic.code.info().id.into(),
        line: line_of(job, diagnostic),
        message: diagnostic.message.clone(),
    }
}

fn line_of(job: &Job<'_>, diagnostic: &Diagnostic) -> u32 {
    let span = diagnostic.primary.span;
    match job.sources().get(FileId(0)) {
        Some(source) if span.file == FileId(0) => source.line_of(span.range.start),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::lines;

    #[test]
    fn lines_end_in_all_three_ways() {
        for (text, count) in [
            ("", 0),
            ("a", 1),
            ("a\n", 1),
            ("a\nb", 2),
            ("a\r\nb\r\n", 2),
            ("a\rb\r", 2),
            ("\n\n", 2),
            ("\r\r\n\n", 3),
            ("a\n\r\rb\n\r\r", 2),
        ] {
            assert_eq!(lines(text.as_bytes()), count, "{text:?}");
        }
    }
}
