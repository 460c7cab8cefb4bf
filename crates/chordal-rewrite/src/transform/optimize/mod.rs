//! Feeds by what the tool meets: F words are changed so that chips stay at a thickness, and nothing else is.
//!
//! | what | file |
//! |---|---|
//! | which share of its feed each block may have | `shares.rs` |
//! | the order in which blocks run, and the F words | `words.rs` |
//! | along one block: its slices, the share of each place, where splits pay | `slices.rs`, `profile.rs` |
//! | which points of a block are exact, and how its parts are written | `exact.rs`, `parts.rs` |
//! | the text in parts, proved and fed | `split.rs` |
//! | both texts run, and compared command by command | `proof.rs` |

mod exact;
mod parts;
mod profile;
mod proof;
mod shares;
mod slices;
mod split;
mod words;

use std::collections::{BTreeMap, HashMap, HashSet};

use chordal::Job;
use chordal::diagnostics::SourceMap;
use chordal::motion::{LimitError, MotionOptions};
use chordal::stock::{EngagementOptions, EngagementReport, StockRunError};

use super::edit::{TransformRefusal, WordEdit, apply, changes};
use crate::Change;
use crate::source::first_text;
use crate::word_address::refuse_other_languages;
use slices::MoveSlices;

pub use proof::FeedProof;
pub use split::{NotSplit, SplitResult};

/// How thick chips may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ChipLimit {
    /// As thick as those of the program's own best passes: the thickest that a tool has for half a second or longer
    /// in all.
    Best,
    /// So thick for every tool, mm.
    Thickness(f64),
}

/// How feeds are changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OptimizeOptions {
    /// How engagement is measured.
    pub engagement: EngagementOptions,
    /// How thick chips may be.
    pub limit: ChipLimit,
    /// The largest feed, by the programmed one; 1 only lowers.
    pub faster: f64,
    /// Blocks are split where that saves time.
    pub split: bool,
    /// How times are planned.
    pub motion: MotionOptions,
}

/// Why feeds stay as they are.
#[derive(Clone, Debug, thiserror::Error)]
pub enum OptimizeError {
    /// There is no run on stock.
    #[error(transparent)]
    Stock(#[from] StockRunError),
    /// There are no times.
    #[error(transparent)]
    Limits(#[from] LimitError),
    /// A block stands in the way.
    #[error(transparent)]
    Refused(#[from] TransformRefusal),
    /// What is known of program and setup is not enough.
    #[error("{what}")]
    NotKnown {
        /// What is missing.
        what: String,
        /// What to do.
        help: String,
    },
    /// The new text failed its proof.
    #[error("the proof of the new feeds failed: {0}")]
    NotProved(String),
}

/// The chips of a tool, at most, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolChips {
    /// Its number.
    pub tool: u32,
    /// How thick they may be.
    pub limit_mm: f64,
    /// The thickest with the old feeds and the new ones.
    pub peak_mm: [f64; 2],
}

/// A program with other feeds.
#[derive(Debug)]
pub struct OptimizedProgram {
    /// The new text.
    pub text: Vec<u8>,
    /// What was changed.
    pub changes: Vec<Change>,
    /// Blocks whose feed is another one, and all blocks that cut by a feed that may be changed.
    pub blocks: [usize; 2],
    /// Chips by tool.
    pub chips: Vec<ToolChips>,
    /// What is to be known in addition.
    pub notes: Vec<String>,
    /// The time of both, planned with jerk, s.
    pub seconds: [f64; 2],
    /// The time in material at the programmed feeds of both, s.
    pub engaged_s: [f64; 2],
    /// What was compared.
    pub proof: FeedProof,
    /// What was split; `None` where nothing was.
    pub splits: Option<SplitResult>,
    /// What would be split but for its form.
    pub not_split: Vec<NotSplit>,
}

/// Gives the bytes of a file that a setup names.
type SetupFiles<'f> = &'f dyn Fn(&str) -> Result<Vec<u8>, String>;

/// Changes the F words of the first text of a job, and proves that nothing else changes.
///
/// # Errors
/// Where stock, tools or the program are not known well enough, a block stands in the way, or the proof fails.
pub fn optimize(
    job: &Job,
    options: &OptimizeOptions,
    files: SetupFiles<'_>,
) -> Result<OptimizedProgram, OptimizeError> {
    refuse_other_languages(job).map_err(TransformRefusal::from)?;
    let mut slices = MoveSlices::default();
    let before = job.engagement_with(&options.engagement, files, &mut |number, slice| {
        if options.split {
            slices.add(number, slice);
        }
    })?;
    is_known(&before, job.sources())?;
    let limits = limits(job, &before, options)?;
    let mut fed = feed(job, &before, &limits, options, files)?;
    let mut all_changes = changes(first_text(job), &fed.edits);
    let mut notes = notes(&before);
    let mut splits = None;
    let mut not_split = Vec::new();
    if options.split {
        let choice = split::JointChoice {
            job,
            before: &before,
            slices: &slices,
            limits: &limits,
            options,
            files,
        };
        match choice.in_parts() {
            Ok((parted, why)) => {
                not_split = why;
                match parted {
                    Some(parted) if parted.fed.seconds < fed.seconds => {
                        (fed, all_changes) = (parted.fed, parted.changes);
                        splits = Some(parted.splits);
                    }
                    _ => notes.push("no block is split: it would save nothing".into()),
                }
            }
            // Whole blocks are proved already.
            Err(error @ (OptimizeError::Refused(_) | OptimizeError::NotProved(_))) => {
                notes.push(format!("no block is split: {error}"));
            }
            Err(error) => return Err(error),
        }
    }
    let before_s = job.time(&options.motion).map(|timed| timed.time.total_s())?;
    let peak = |report: &EngagementReport, tool: u32| {
        let found = report.tools.iter().find(|each| each.number == tool);
        found.and_then(|each| each.chip_mm).map_or(0.0, |chip| chip.peak)
    };
    let chips = limits
        .iter()
        .map(|(&tool, &limit_mm)| ToolChips {
            tool,
            limit_mm,
            peak_mm: [peak(&before, tool), peak(&fed.after, tool)],
        })
        .collect();
    let engaged =
        |report: &EngagementReport| report.tools.iter().map(|tool| tool.engaged_s).sum::<f64>();
    Ok(OptimizedProgram {
        changes: all_changes,
        blocks: [fed.changed.len(), fed.shares.len()],
        chips,
        notes,
        seconds: [before_s, fed.seconds],
        engaged_s: [engaged(&before), engaged(&fed.after)],
        proof: fed.proof,
        splits,
        not_split,
        text: first_text(&fed.new).to_vec(),
    })
}

/// A text with other feeds, proved.
struct FeedEdits {
    new: Job<'static>,
    edits: Vec<WordEdit>,
    /// The blocks whose moves have another feed, and the share of each block that may have one.
    changed: HashSet<u32>,
    shares: HashMap<u32, f64>,
    after: EngagementReport,
    proof: FeedProof,
    /// Planned with jerk, s.
    seconds: f64,
}

/// Changes the F words of a text whose engagement is known, and proves them.
fn feed(
    job: &Job,
    before: &EngagementReport,
    limits: &BTreeMap<u32, f64>,
    options: &OptimizeOptions,
    files: SetupFiles<'_>,
) -> Result<FeedEdits, OptimizeError> {
    let shares = shares::ShareInputs::new(job, before, limits, options).by_block();
    let mut written = words::write(job, &shares)?;
    let new = job.with_text(apply(first_text(job), &mut written.edits));
    let after = new.engagement(&options.engagement, files)?;
    let mut proof = proof::prove(job, &new, &written.changed)?;
    proof.cells = proof::same_cut(before, &after)?;
    proof::within(before, &after, limits, options.faster.max(1.0))?;
    let seconds = new.time(&options.motion)?.time.total_s();
    let words::FeedText { edits, changed } = written;
    Ok(FeedEdits { new, edits, changed, shares, after, proof, seconds })
}

/// Refuses where what tools meet is not known.
fn is_known(found: &EngagementReport, sources: &SourceMap) -> Result<(), OptimizeError> {
    let not_known = |what: &str, help: &str| {
        Err(OptimizeError::NotKnown { what: what.to_string(), help: help.to_string() })
    };
    if let Some((_, line)) = found.report.not_verified_line(sources) {
        let what = format!("from line {line} on the path is not known");
        return not_known(&what, "`chordal check` says why");
    }
    if found.report.counts.errors > 0 {
        return not_known(
            "the program has errors",
            "`chordal check` lists them; feeds are changed only in a program that runs",
        );
    }
    if !found.is_whole {
        return not_known(
            "some moves are not cut from the stock, so what comes after them is not known",
            "`chordal stock --engagement` says which and why",
        );
    }
    Ok(())
}

/// The thickest chips that are allowed, by tool.
fn limits(
    job: &Job,
    found: &EngagementReport,
    options: &OptimizeOptions,
) -> Result<BTreeMap<u32, f64>, OptimizeError> {
    let mut limits = BTreeMap::new();
    for tool in &found.tools {
        let Some(lasting) = tool.lasting_chip_mm.filter(|chip| *chip > 0.0) else { continue };
        let limit = match options.limit {
            ChipLimit::Best => lasting,
            ChipLimit::Thickness(mm) => mm,
        };
        let own = job.machine().tools.get(&tool.number).and_then(|tool| tool.max_chip_mm);
        limits.insert(tool.number, own.map_or(limit, |own| own.min(limit)));
    }
    if limits.is_empty() {
        return Err(OptimizeError::NotKnown {
            what: "no tool has a chip: teeth, speed or feed are not known, or nothing is cut"
                .into(),
            help: "give `teeth` of the tools in the setup file".into(),
        });
    }
    Ok(limits)
}

fn notes(found: &EngagementReport) -> Vec<String> {
    let without: Vec<String> = found
        .tools
        .iter()
        .filter(|tool| tool.lasting_chip_mm.is_none())
        .map(|tool| tool.number.to_string())
        .collect();
    let mut notes = Vec::new();
    if !without.is_empty() {
        notes.push(format!(
            "the feeds of tool {} stay: without the number of its teeth, or a cut, it has no chip",
            without.join(", ")
        ));
    }
    if !found.not_measured.is_empty() {
        let tools: Vec<String> = found.not_measured.iter().map(u32::to_string).collect();
        notes.push(format!(
            "the feeds of tool {} stay: what an undercut engages is not measured",
            tools.join(", ")
        ));
    }
    notes
}
