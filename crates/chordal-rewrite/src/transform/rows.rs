//! Rows of straight cuts that stand after one another in the text and nowhere else: what may be
//! replaced as a whole.

use chordal::control::{Action, MotionCode};
use chordal::control::{CompensationSide, FeedMode};
use chordal::geometry::Vec3;
use chordal::syntax::{Block, BlockKind};

use super::record::{BlockEffect, BlockPass, RunRecord};
use super::roles::actions;
use super::writer::WordWriter;
use crate::blocks::blocks_of;

/// One straight cut.
#[derive(Clone, Debug)]
pub(super) struct StraightCut {
    pub(super) block: Block,
    pub(super) run: BlockPass,
}

impl StraightCut {
    pub(super) fn from(&self) -> Vec3 {
        Vec3::new(self.run.from[0], self.run.from[1], self.run.from[2])
    }

    pub(super) fn to(&self) -> Vec3 {
        Vec3::new(self.run.to[0], self.run.to[1], self.run.to[2])
    }
}

/// The slowest and the fastest feed of a row, mm/s; none where no feed is active.
#[derive(Clone, Copy, Debug)]
struct RowFeeds(Option<[f64; 2]>);

impl RowFeeds {
    fn of(run: &BlockPass) -> RowFeeds {
        RowFeeds(run.feed.map(|feed| [feed, feed]))
    }

    /// With those of one more cut; nothing where they are further apart than `tolerance` of the fastest.
    fn with(self, run: &BlockPass, tolerance: f64) -> Option<RowFeeds> {
        match (self.0, run.feed) {
            (None, None) => Some(self),
            (Some([slow, fast]), Some(feed)) => {
                let both = [slow.min(feed), fast.max(feed)];
                (both[0] >= both[1] * (1.0 - tolerance)).then_some(RowFeeds(Some(both)))
            }
            _ => None,
        }
    }
}

/// Emits each row of at least `least` cuts in one go, and the block after it. Feeds of one row differ by no
/// more than `feed_tolerance` of the fastest.
pub(super) fn rows(
    writer: &WordWriter,
    record: &RunRecord,
    least: usize,
    feed_tolerance: f64,
    mut see: impl FnMut(&[StraightCut], Option<&Block>),
) {
    let mut row: Vec<StraightCut> = Vec::new();
    let mut feeds = RowFeeds(None);
    let mut order = 0;
    let mut flush = |row: &mut Vec<StraightCut>, following: Option<&Block>| {
        if row.len() >= least {
            see(row, following);
        }
        row.clear();
    };
    for block in blocks_of(writer.text, writer.control) {
        let cut = cut(writer, record, &block);
        let goes_on = cut.as_ref().zip(row.last()).and_then(|((cut, its), last)| {
            let follows = *its == order + 1 && follows(&last.run, &cut.run);
            feeds.with(&cut.run, feed_tolerance).filter(|_| follows)
        });
        if goes_on.is_none() {
            flush(&mut row, Some(&block));
        }
        if let Some((cut, its)) = cut {
            feeds = goes_on.unwrap_or(RowFeeds::of(&cut.run));
            order = its;
            row.push(cut);
        }
    }
    flush(&mut row, None);
}

/// A block that is nothing but one straight cut between known places, and which block of the run it is.
fn cut(writer: &WordWriter, record: &RunRecord, block: &Block) -> Option<(StraightCut, u32)> {
    let is_plain = block.kind == BlockKind::Words
        && block.comments.is_empty()
        && block.delete.is_none()
        && block.problems.is_empty()
        && !block.words.is_empty();
    if !is_plain {
        return None;
    }
    let runs = record.blocks.get(&block.range.start)?;
    let run = runs.first;
    let context = run.context;
    let is_cut = runs.count == 1
        && context.did == BlockEffect::Line
        && run.moves == 1
        && !context.incremental
        && context.side == CompensationSide::Off
        && context.feed_mode == FeedMode::PerTime
        && run.known.iter().all(|known| (0..3).all(|axis| known.has(axis)));
    let words = block.words.iter().all(|word| {
        word.number().is_some()
            && !word.comma
            && word.register.is_none()
            && b"XYZNGF".contains(&word.letter)
    });
    let codes = actions(block, writer.control)
        .all(|(_, action)| action == Action::Motion(MotionCode::Linear))
        && block.all(b'G').count() == actions(block, writer.control).count();
    (is_cut && words && codes).then(|| (StraightCut { block: block.clone(), run }, runs.order))
}

/// A cut goes on where the one before it ended, in the same plane and units.
fn follows(before: &BlockPass, run: &BlockPass) -> bool {
    before.to == run.from
        && before.context.plane == run.context.plane
        && before.context.units == run.context.units
}
