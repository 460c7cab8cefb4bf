//! Both texts run: every command is the same but for feeds, what is cut is the same to the bit, no chip is thicker.

use std::collections::{BTreeMap, HashSet};

use chordal::control::FeedMode;
use chordal::diagnostics::FileId;
use chordal::geometry::tolerance::ROUNDING_SHARE;
use chordal::stock::EngagementReport;
use chordal::{Command, CommandKind, Diagnostic, Job, RunSink, Sink};

use super::OptimizeError;

/// What was compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FeedProof {
    /// Commands that are the same, feeds aside.
    pub commands: u64,
    /// Cells of the stock whose heights are the same to the bit.
    pub cells: u64,
}

/// The commands of a run, each with its line.
#[derive(Default)]
struct LineCommands(Vec<Command>);

impl Sink for LineCommands {
    fn command(&mut self, command: &Command) {
        if !matches!(command.kind, CommandKind::FeedRate { .. }) {
            self.0.push(command.clone());
        }
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for LineCommands {}

/// Compares the commands of both: all are equal, exactly, but for the feeds of blocks in `changed`.
pub(super) fn prove(
    old: &Job,
    new: &Job,
    changed: &HashSet<u32>,
) -> Result<FeedProof, OptimizeError> {
    let [old, new] = [old, new].map(|job| {
        let mut commands = LineCommands::default();
        job.run(&mut commands);
        commands.0
    });
    if old.len() != new.len() {
        return Err(OptimizeError::NotProved(format!(
            "there are {} commands, and {} before",
            new.len(),
            old.len()
        )));
    }
    for (before, after) in old.iter().zip(&new) {
        let origin = &before.origin;
        let mut same = after.kind.clone();
        if origin.span.file == FileId(0) && changed.contains(&origin.span.range.start) {
            keep_feed(&mut same, &before.kind);
        }
        let text = (&before.kind, &same);
        // Texts for the operator stand elsewhere now; they are the same text.
        let is_text = matches!(text, (CommandKind::Message(_), CommandKind::Message(_)));
        if origin.line != after.origin.line || (!is_text && *text.0 != *text.1) {
            return Err(OptimizeError::NotProved(format!(
                "line {} does something else than its feed",
                origin.line
            )));
        }
    }
    Ok(FeedProof { commands: old.len() as u64, cells: 0 })
}

/// Gives a command the feed of another one, where both are by time.
fn keep_feed(kind: &mut CommandKind, other: &CommandKind) {
    let Some(other) = other.feed().copied().filter(|feed| feed.mode == FeedMode::PerTime) else {
        return;
    };
    match kind {
        CommandKind::Line { feed, .. }
        | CommandKind::Arc { feed, .. }
        | CommandKind::Spiral { feed, .. }
        | CommandKind::Spline { feed, .. }
            if feed.mode == FeedMode::PerTime =>
        {
            feed.value = other.value;
        }
        _ => {}
    }
}

/// What is left of the stock is the same to the bit.
pub(super) fn same_cut(
    before: &EngagementReport,
    after: &EngagementReport,
) -> Result<u64, OptimizeError> {
    let [old, new] = [before, after].map(|report| report.stock.height_pairs());
    let bits = |pair: &chordal::stock::CellHeights| [pair.outer.to_bits(), pair.inner.to_bits()];
    let same = old.len() == new.len() && old.iter().zip(&new).all(|(a, b)| bits(a) == bits(b));
    if same {
        Ok(old.len() as u64)
    } else {
        Err(OptimizeError::NotProved("what is left of the stock is not the same".into()))
    }
}

/// What is left of the stock after moves in parts: cells that are the same to the bit. Where a move ends, its wall is
/// known to the width of a cell, so the others have other bounds; the truth lies between both.
pub(super) fn same_within(
    before: &EngagementReport,
    after: &EngagementReport,
) -> Result<u64, OptimizeError> {
    let [old, new] = [before, after].map(|report| report.stock.height_pairs());
    let mut same = 0;
    let mut fits = old.len() == new.len();
    for (a, b) in old.iter().zip(&new) {
        let bits = |pair: &chordal::stock::CellHeights| [pair.outer, pair.inner].map(f64::to_bits);
        same += u64::from(bits(a) == bits(b));
        fits &= a.inner <= b.outer && b.inner <= a.outer;
    }
    match fits {
        true => Ok(same),
        false => Err(OptimizeError::NotProved(
            "what is left of the stock is not the same after blocks are split".into(),
        )),
    }
}

/// No chip is thicker than its limit, none of a tool without one than before, no feed faster than asked.
pub(super) fn within(
    before: &EngagementReport,
    after: &EngagementReport,
    limits: &BTreeMap<u32, f64>,
    faster: f64,
) -> Result<(), OptimizeError> {
    let failed =
        |line: u32, what: String| Err(OptimizeError::NotProved(format!("line {line}: {what}")));
    for (old, new) in before.moves.iter().zip(&after.moves) {
        let line = new.origin.line;
        let most = old.feed_mm_per_s * faster * (1.0 + ROUNDING_SHARE);
        if new.feed_mm_per_s > most {
            return failed(line, "the feed is faster than asked".into());
        }
        let [was, is] = [old, new].map(|each| each.chip.map_or(0.0, |chip| chip.peak_mm.most));
        // What cannot be changed stays as it was.
        let limit = match limits.get(&new.tool) {
            Some(limit) if new.by_time && new.origin.span.file == FileId(0) => *limit,
            _ => was,
        };
        if is > limit * (1.0 + ROUNDING_SHARE) {
            let what = format!("the chip is up to {is:.4} mm thick, {limit:.4} mm is the limit");
            return failed(line, what);
        }
    }
    Ok(())
}
