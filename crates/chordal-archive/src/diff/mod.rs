//! Compares programs that came back from the machines with the released ones.
//!
//! Equal motion is proved, not sampled: the curves, rapids and rotary axes of both runs have exactly equal numbers in
//! the same order. When they differ, the distance is the Hausdorff distance of the two paths as sets of points (cuts
//! to cuts, rapids to rapids), enclosed in an interval no wider than the requested tolerance, up to the rounding of
//! doubles: see [`distance()`].

mod columns;
mod distance;
mod motion;
mod problems;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use chordal::Job;
use chordal_compare::{Category, Comparison, ComparisonOptions, ComparisonVerdict};
use chordal_export::sha256_hex;
use serde::Serialize;

use crate::archive_walk::walk;
use crate::check::{FileLoader, PreparedFile, guarded, job, run_planned};
use crate::row::ArchivedProblem;
use crate::run::{ArchiveProgress, with_jobs};
use motion::RunMotion;
use problems::{AddedProblems, ProblemList};

pub use columns::{DIFF_COLUMNS, diff_reference, write_table};
pub use distance::{DistanceBounds, PathCurve, distance};

/// The result for a pair of files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FileStatus {
    /// The same bytes.
    Same,
    /// The text differs; motion, feeds, speeds and functions are equal.
    Text,
    /// The motion is equal; something else that two programs must have in common differs: tools, offsets, codes,
    /// stops, messages, values.
    Functions,
    /// No difference was found, but one of the two does something that the simulation cannot follow.
    NotVerified,
    /// The motion is equal; feeds, spindle speeds or times differ.
    Feeds,
    /// The motion differs.
    Path,
    /// The files differ and are not programs.
    Other,
    /// At least one of the two cannot be read or run.
    Unreadable,
    /// Released and not returned.
    Missing,
    /// Returned and never released.
    New,
}

impl FileStatus {
    /// All results in the order in which they are reported.
    pub const ALL: [FileStatus; 10] = [
        FileStatus::Same,
        FileStatus::Text,
        FileStatus::NotVerified,
        FileStatus::Functions,
        FileStatus::Feeds,
        FileStatus::Path,
        FileStatus::Other,
        FileStatus::Unreadable,
        FileStatus::Missing,
        FileStatus::New,
    ];

    /// The name in output.
    pub fn word(self) -> &'static str {
        match self {
            FileStatus::Same => "same",
            FileStatus::Text => "text",
            FileStatus::NotVerified => "not-verified",
            FileStatus::Functions => "functions",
            FileStatus::Feeds => "feeds",
            FileStatus::Path => "path",
            FileStatus::Other => "other",
            FileStatus::Unreadable => "unreadable",
            FileStatus::Missing => "missing",
            FileStatus::New => "new",
        }
    }
}

/// The row of a file in the two archives.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DiffRow {
    /// Its path relative to the folders.
    pub path: String,
    /// The result.
    pub status: FileStatus,
    /// What else differs, or why the files could not be compared or only in part; `None` otherwise.
    pub message: Option<String>,
    /// SHA-256 of the released file; `None` without a readable one.
    pub released_sha256: Option<String>,
    /// SHA-256 of the returned file; `None` without a readable one.
    pub returned_sha256: Option<String>,
    /// The lines of the first difference in both files, in the sense of the status; `None` when there is none or it
    /// is unknown.
    pub lines: Option<(u32, u32)>,
    /// Whether feeds, spindle speeds or times differ; `None` when not compared.
    pub feeds_differ: Option<bool>,
    /// Whether something else than motion, feeds, speeds and times differs; `None` when not compared.
    pub functions_differ: Option<bool>,
    /// The bounds of the distance between the paths, mm; `None` when the paths are equal or the distance is not
    /// defined.
    pub distance_mm: Option<(f64, f64)>,
    /// The times without acceleration of the released and the returned program, s; `None` when not run.
    pub at_feed_s: Option<(f64, f64)>,
    /// Their times with acceleration and jerk, s; `None` unless both were planned.
    pub time_s: Option<(f64, f64)>,
    /// The number of problems of the returned program in excess of the released one, counted by code.
    pub new_problems: u64,
    /// The number of problems of the released program in excess of the returned one, counted by code.
    pub gone_problems: u64,
    /// The first of the new problems, the most severe first.
    pub problems: Vec<ArchivedProblem>,
}

impl DiffRow {
    fn new(path: &str, status: FileStatus) -> DiffRow {
        DiffRow {
            path: path.into(),
            status,
            message: None,
            released_sha256: None,
            returned_sha256: None,
            lines: None,
            feeds_differ: None,
            functions_differ: None,
            distance_mm: None,
            at_feed_s: None,
            time_s: None,
            new_problems: 0,
            gone_problems: 0,
            problems: Vec::new(),
        }
    }

    fn brings(&mut self, new: AddedProblems, gone: &AddedProblems) {
        (self.new_problems, self.gone_problems) = (new.count, gone.count);
        self.problems = new.listed;
    }
}

/// How every pair of files is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiffOptions {
    /// The tolerance within which distances are found, mm.
    pub tolerance_mm: f64,
    /// Plans the motion, for times with acceleration and jerk.
    pub plan: bool,
}

/// Compares the files with equal relative paths in two folders, with `jobs` threads. The rows are sorted by path.
pub fn compare_all<L: FileLoader>(
    released: &Path,
    returned: &Path,
    jobs: usize,
    options: DiffOptions,
    loader: impl Fn() -> L + Sync,
    progress: &dyn ArchiveProgress,
) -> Vec<DiffRow> {
    let pairs = pairs(released, returned);
    let rows = Mutex::new(vec![None; pairs.len()]);
    let next = AtomicUsize::new(0);
    with_jobs(jobs.min(pairs.len()), || {
        let mut loader = loader();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some((name, pair)) = pairs.get(index) else { break };
            let row = compare(&mut loader, name, pair, options);
            progress.file(0, true);
            rows.lock().unwrap_or_else(std::sync::PoisonError::into_inner)[index] = Some(row);
        }
    });
    let rows = rows.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    rows.into_iter().flatten().collect()
}

/// Compares one file with another.
pub fn compare_files(
    loader: &mut impl FileLoader,
    released: &Path,
    returned: &Path,
    options: DiffOptions,
) -> DiffRow {
    let name = released.to_string_lossy().into_owned();
    let pair = [Some(released.to_path_buf()), Some(returned.to_path_buf())];
    compare(loader, &name, &pair, options)
}

/// The released and the returned file of a name.
type ReleasedAndReturned = [Option<PathBuf>; 2];

fn pairs(released: &Path, returned: &Path) -> Vec<(String, ReleasedAndReturned)> {
    let mut pairs: BTreeMap<Vec<u8>, (String, ReleasedAndReturned)> = BTreeMap::new();
    for (side, folder) in [released, returned].into_iter().enumerate() {
        for entry in walk(&[folder.to_path_buf()], &[]) {
            let below = entry.path.strip_prefix(folder).unwrap_or(&entry.path).to_path_buf();
            let key = below.as_os_str().as_encoded_bytes().to_vec();
            let name = below.to_string_lossy().into_owned();
            pairs.entry(key).or_insert((name, [None, None])).1[side] = Some(entry.path);
        }
    }
    pairs.into_values().collect()
}

fn compare(
    loader: &mut impl FileLoader,
    name: &str,
    pair: &ReleasedAndReturned,
    options: DiffOptions,
) -> DiffRow {
    let (released, returned) = match pair {
        [Some(released), Some(returned)] => (released, returned),
        [Some(_), None] => return DiffRow::new(name, FileStatus::Missing),
        [None, Some(returned)] => return new(loader, name, returned, options),
        [None, None] => return DiffRow::new(name, FileStatus::Missing),
    };
    let mut row = DiffRow::new(name, FileStatus::Unreadable);
    let texts = (loader.read(released), loader.read(returned));
    let digest = |text: &Result<Vec<u8>, String>| text.as_ref().ok().map(|text| sha256_hex(text));
    (row.released_sha256, row.returned_sha256) = (digest(&texts.0), digest(&texts.1));
    let (before, after) = match texts {
        (Ok(before), Ok(after)) => (before, after),
        (Err(message), _) | (_, Err(message)) => {
            row.message = Some(message);
            return row;
        }
    };
    if before == after {
        row.status = FileStatus::Same;
        return row;
    }
    row.lines = Some(first_line(&before, &after));
    let is_other = |loader: &mut _, path: &Path, text: &[u8]| is_no_program(loader, path, text);
    match (is_other(loader, released, &before), is_other(loader, returned, &after)) {
        (true, true) => {
            row.status = FileStatus::Other;
            return row;
        }
        (false, false) => {}
        (first, _) => {
            let which = if first { "released" } else { "returned" };
            row.message = Some(format!("the {which} file has no program"));
            return row;
        }
    }
    let both = [(released, before), (returned, after)].map(|(path, text)| {
        guarded(|| {
            let prepared = loader.prepare(path, text)?;
            let ran = ProgramOutcome::of(&prepared, options)?;
            Ok((prepared, ran))
        })
    });
    match both {
        [Ok((first, before)), Ok((second, after))] => {
            row.brings(
                after.problems.more_than(&before.problems),
                &before.problems.more_than(&after.problems),
            );
            row.time_s = before.time_s.zip(after.time_s);
            row.at_feed_s = Some((before.motion.time_s, after.motion.time_s));
            let (before, after) = (&before.motion, &after.motion);
            if let Some(lines) = before.first_other(after) {
                return other_path(row, [before, after], lines, options.tolerance_mm);
            }
            let found = guarded(|| Ok(compare_shared(&job(&first)?, &job(&second)?)));
            match found {
                Ok(found) => judge(row, [before, after], &found),
                Err(message) => {
                    row.message = Some(message);
                    row
                }
            }
        }
        [Err(message), _] | [_, Err(message)] => {
            row.message = Some(message);
            row
        }
    }
}

/// The motion, the time and the problems of a program.
struct ProgramOutcome {
    motion: RunMotion,
    time_s: Option<f64>,
    problems: ProblemList,
}

impl ProgramOutcome {
    fn of(prepared: &PreparedFile, options: DiffOptions) -> Result<ProgramOutcome, String> {
        let job = job(prepared)?;
        let ((report, planned), mut motion) =
            run_planned(&job, prepared, options.plan, RunMotion::default);
        motion.time_s = report.summary.total_time_s();
        // A machine without limits has no times; this is not an error of the program.
        let time_s = planned.ok().flatten().map(|parts| parts.iter().sum());
        Ok(ProgramOutcome { motion, time_s, problems: ProblemList::of(&job, &report) })
    }
}

/// The row of a file that was never released: all its problems are new.
fn new(loader: &mut impl FileLoader, name: &str, path: &Path, options: DiffOptions) -> DiffRow {
    let mut row = DiffRow::new(name, FileStatus::New);
    let text = match loader.read(path) {
        Ok(text) => text,
        Err(message) => {
            row.message = Some(message);
            return row;
        }
    };
    row.returned_sha256 = Some(sha256_hex(&text));
    if is_no_program(loader, path, &text) {
        return row;
    }
    match guarded(|| ProgramOutcome::of(&loader.prepare(path, text)?, options)) {
        Ok(ran) => {
            row.brings(ran.problems.more_than(&ProblemList::default()), &AddedProblems::default())
        }
        Err(message) => row.message = Some(message),
    }
    row
}

fn is_no_program(loader: &mut impl FileLoader, path: &Path, text: &[u8]) -> bool {
    let sample = &text[..text.len().min(1 << 16)];
    loader.is_other_by_name(path)
        || chordal::syntax::decode(sample).binary
        || !loader.may_be_program(sample)
}

/// Compares everything that two programs must have in common.
fn compare_shared(before: &Job, after: &Job) -> Comparison {
    chordal_compare::compare(
        before,
        after,
        &ComparisonOptions { ready_tools: true, ..ComparisonOptions::default() },
    )
}

fn other_path(
    mut row: DiffRow,
    [before, after]: [&RunMotion; 2],
    lines: (u32, u32),
    tolerance_mm: f64,
) -> DiffRow {
    row.status = FileStatus::Path;
    row.lines = Some(lines);
    row.feeds_differ = Some(!before.has_feeds_of(after));
    row.functions_differ = Some(before.functions != after.functions);
    let found = before.distance_to(after, tolerance_mm);
    row.distance_mm = found.map(|within| (within.low, within.high));
    row.message = (found.is_none()).then(|| {
        "the distance is not defined: one path has no cuts or no rapids, or rotary axes move".into()
    });
    row
}

/// Completes the row of two programs with equal moves.
fn judge(mut row: DiffRow, [before, after]: [&RunMotion; 2], found: &Comparison) -> DiffRow {
    let is_speed = |category: Category| {
        matches!(category, Category::Feed | Category::Spindle | Category::Time)
    };
    let others = || found.differences.iter();
    let mut words: Vec<&str> = others()
        .map(|one| one.category)
        .filter(|one| !is_speed(*one))
        .map(Category::word)
        .collect();
    words.sort_unstable();
    words.dedup();
    row.feeds_differ =
        Some(!before.has_feeds_of(after) || others().any(|one| is_speed(one.category)));
    row.functions_differ = Some(!words.is_empty() || before.functions != after.functions);
    row.status = match (row.feeds_differ, row.functions_differ) {
        (Some(true), _) => FileStatus::Feeds,
        (_, Some(true)) => FileStatus::Functions,
        _ if found.verdict == ComparisonVerdict::NotVerified => FileStatus::NotVerified,
        _ => FileStatus::Text,
    };
    if row.status == FileStatus::Feeds {
        row.lines = before.first_other_feed(after).or(row.lines);
    }
    if !words.is_empty() {
        row.message = Some(format!("other: {}", words.join(", ")));
    }
    if row.status == FileStatus::NotVerified {
        let lines = found.reports.each_ref().map(|report| report.not_verified_from.is_some());
        let which = match lines {
            [true, true] => "both programs do",
            _ => "one of the programs does",
        };
        row.message =
            Some(format!("no difference was found, and {which} something that is not followed"));
    }
    row
}

/// The line on which two texts first differ; it has the same number in both.
fn first_line(before: &[u8], after: &[u8]) -> (u32, u32) {
    let same = before.iter().zip(after).take_while(|(a, b)| a == b).count();
    let line = 1 + before[..same].iter().filter(|byte| **byte == b'\n').count() as u32;
    (line, line)
}
