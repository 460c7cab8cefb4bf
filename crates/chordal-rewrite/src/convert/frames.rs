//! Mirror, scaling, rotation and polar coordinates: kept where both controls read them alike, else
//! what runs in them is written out in the work coordinate system.

use chordal::control::{Action, Control, FrameKinds, OnceCode};
use chordal::syntax::Block;

use super::codes;
use super::context::ConvertContext;
use super::draft::NeedsExpansion;
use crate::source::SourceBlocks;

/// True when every rotation of the program means the same on both controls: both coordinates of its
/// centre and its angle are written, with points and in G90.
pub(super) fn keeps_rotations(source: &SourceBlocks, from: &Control, to: &Control) -> bool {
    let rotation = Action::Once(OnceCode::Rotation);
    if codes::row(rotation, to).is_none() {
        return false;
    }
    (0..source.blocks.len())
        .filter(|at| source.has_action(*at, from, |action| action == rotation))
        .all(|at| is_plain(&source.blocks[at]))
}

fn is_plain(block: &Block) -> bool {
    let has_point =
        |letter: u8| block.last(letter).and_then(|word| word.number()).is_some_and(|n| n.has_point);
    let is_zero =
        |letter: u8| block.last(letter).and_then(|word| word.number()).is_some_and(|n| n.is_zero());
    let axes = b"XYZ".iter().filter(|axis| block.letters().has(**axis)).count();
    axes == 2
        && has_point(b'R')
        && b"XYZ"
            .iter()
            .all(|axis| !block.letters().has(*axis) || has_point(*axis) || is_zero(*axis))
}

impl ConvertContext<'_> {
    /// A block that sets a frame, or runs in one.
    pub(super) fn frames(&self, at: usize) -> Result<(), NeedsExpansion> {
        let Some(run) = self.run(at) else { return Ok(()) };
        // A surface has words of its own.
        let flat = |frames: FrameKinds| FrameKinds { surface: false, ..frames };
        let (before, after) = (flat(run.before.frames), flat(run.after.frames));
        let is_on_part = self.writes_axes && (before.part || after.part);
        if !(before.any() || after.any()) || self.same_control() && !is_on_part {
            return Ok(());
        }
        let title = self.to.table.title;
        if is_on_part {
            return Err(NeedsExpansion("it gives the tip of the tool, not the axes".into()));
        }
        if before.part || after.part {
            return Err(NeedsExpansion(format!("{title} may follow the tip in another way")));
        }
        let others =
            |frames: FrameKinds| frames.mirror || frames.scaling || frames.polar || frames.work;
        if others(before) || others(after) {
            return Err(NeedsExpansion(format!(
                "{title} reads the coordinates of this frame in another way"
            )));
        }
        let in_g91 = after.rotation && !before.rotation && run.after.incremental;
        if !self.keeps_rotations || in_g91 {
            return Err(NeedsExpansion(format!("{title} may read this rotation in another way")));
        }
        Ok(())
    }
}
