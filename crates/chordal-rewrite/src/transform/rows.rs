//! Rows of straight cuts that stand after one another in the text and nowhere else: what may be
//! replaced as a whole.

use chordal::control::{Action, MotionCode};
use chordal::control::{FeedMode, Side};
use chordal::diagnostics::FileId;
use chordal::geometry::Vec3;
use chordal::syntax::{Block, BlockKind, BlockReader};

use super::record::{Did, Record, Run};
use super::roles::actions;
use super::writer::Writer;

/// One straight cut.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    pub(super) block: Block,
    pub(super) run: Run,
}

impl Cut {
    pub(super) fn from(&self) -> Vec3 {
        Vec3::new(self.run.from[0], self.run.from[1], self.run.from[2])
    }

    pub(super) fn to(&self) -> Vec3 {
        Vec3::new(self.run.to[0], self.run.to[1], self.run.to[2])
    }
}

/// Emits each row of at least `least` cuts in one go, and the block after it.
pub(super) fn rows(
    writer: &Writer,
    record: &Record,
    least: usize,
    mut see: impl FnMut(&[Cut], Option<&Block>),
) {
    let mut reader = BlockReader::new(writer.text, FileId(0), writer.control.table.lexicon);
    let mut block = Block::new();
    let mut row: Vec<Cut> = Vec::new();
    let mut order = 0;
    let mut flush = |row: &mut Vec<Cut>, behind: Option<&Block>| {
        if row.len() >= least {
            see(row, behind);
        }
        row.clear();
    };
    while reader.read(&mut block) {
        let cut = cut(writer, record, &block, row.last());
        match cut {
            Some((cut, its)) if row.is_empty() || its == order + 1 => {
                order = its;
                row.push(cut);
            }
            _ => {
                flush(&mut row, Some(&block));
                // It may begin a row of its own.
                if let Some((cut, its)) = self::cut(writer, record, &block, None) {
                    order = its;
                    row.push(cut);
                }
            }
        }
    }
    flush(&mut row, None);
}

/// A block that is nothing but one straight cut between known places, and which block of the run it is.
fn cut(
    writer: &Writer,
    record: &Record,
    block: &Block,
    before: Option<&Cut>,
) -> Option<(Cut, u32)> {
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
        && context.did == Did::Line
        && run.moves == 1
        && !context.incremental
        && context.side == Side::Off
        && context.feed_mode == FeedMode::PerTime
        && run.known.iter().all(|known| (0..3).all(|axis| known.has(axis)));
    let words = block.words.iter().all(|word| {
        let is_first = before.is_none();
        word.number().is_some()
            && !word.comma
            && word.register.is_none()
            && (b"XYZNG".contains(&word.letter) || (word.letter == b'F' && is_first))
    });
    let codes = actions(block, writer.control)
        .all(|(_, action)| action == Action::Motion(MotionCode::Linear))
        && block.all(b'G').count() == actions(block, writer.control).count();
    let follows = before.is_none_or(|before| {
        before.run.to == run.from
            && before.run.feed == run.feed
            && before.run.context.plane == context.plane
            && before.run.context.units == context.units
    });
    (is_cut && words && codes && follows).then(|| (Cut { block: block.clone(), run }, runs.order))
}
