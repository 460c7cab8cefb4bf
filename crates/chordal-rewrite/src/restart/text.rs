//! The text of a program that begins at a line.

use std::ops::Range;

use chordal::control::{Action, AfterCode};
use chordal::diagnostics::FileId;

use super::trace::ReplacedRange;
use super::{RestartDraft, RestartRequest};
use crate::convert::{CycleContour, CycleContours};
use crate::word_address::BlockControl;

impl RestartRequest<'_, '_> {
    /// The text, and how places of the old one are places of it.
    pub(super) fn text(&self, draft: &RestartDraft) -> (Vec<u8>, ReplacedRange) {
        let old = self.source.text;
        let crlf = old.windows(2).any(|pair| pair == b"\r\n");
        let line_end = if crlf { "\r\n" } else { "\n" };
        let from = self.source.start_of(self.source.blocks_on(self.line, u32::MAX).start);
        let mut text = old[..draft.first as usize].to_vec();
        let reported = format!("(BEGINS AT LINE {} OF {})", self.line, self.file());
        let put = |text: &mut Vec<u8>, line: &str| {
            text.extend_from_slice(line.as_bytes());
            text.extend_from_slice(line_end.as_bytes());
        };
        put(&mut text, &reported);
        let (above, after) = self.contours_needed(draft);
        let mut contours = Vec::new();
        for blocks in above {
            self.copy(blocks, &mut text, &mut contours);
        }
        for line in &draft.lines {
            put(&mut text, line);
        }
        let to = text.len() as u32;
        let end = self.source.end_of(self.last_of(draft.at)) as usize;
        text.extend_from_slice(&old[from as usize..end.max(from as usize)]);
        if !after.is_empty() && !text.ends_with(b"\n") {
            put(&mut text, "");
        }
        for blocks in after {
            self.copy(blocks, &mut text, &mut contours);
        }
        text.extend_from_slice(&old[end.max(from as usize)..]);
        (text, ReplacedRange { kept: draft.first, from: [from, to], contours })
    }

    /// Copies blocks of the old text.
    fn copy(
        &self,
        blocks: Range<usize>,
        text: &mut Vec<u8>,
        contours: &mut Vec<(Range<u32>, u32)>,
    ) {
        let old = self.source.start_of(blocks.start)..self.source.end_of(blocks.end - 1);
        contours.push((old.clone(), text.len() as u32));
        text.extend_from_slice(&self.source.text[old.start as usize..old.end as usize]);
    }

    /// Contours that stand before the line and that cycles after it take: subroutines, which must stand above, and blocks
    /// between two numbers, which are found anywhere and must not be run.
    pub(super) fn contours_needed(
        &self,
        draft: &RestartDraft,
    ) -> (Vec<Range<usize>>, Vec<Range<usize>>) {
        let contours = CycleContours::of(self.source, self.job).list;
        let needed = contours.iter().filter(|contour| {
            contour.blocks.end <= draft.at
                && self.source.start_of(contour.blocks.start) >= draft.first
                && contour.cycles.iter().any(|(cycle, _)| *cycle >= draft.at)
        });
        let (above, after): (Vec<_>, Vec<_>) =
            needed.partition(|contour| contour.is_subroutine(self.source));
        let blocks =
            |list: Vec<&CycleContour>| list.into_iter().map(|one| one.blocks.clone()).collect();
        (blocks(above), blocks(after))
    }

    /// The block that ends the main program.
    fn last_of(&self, at: usize) -> usize {
        let ends = |at: &usize| {
            self.source.has_action(*at, self.job.control(), |action| {
                matches!(action, Action::After(AfterCode::ProgramEnd { .. }))
            })
        };
        (at..self.source.blocks.len()).find(ends).unwrap_or(self.source.blocks.len() - 1)
    }

    /// The name of the file, without what a comment cannot have.
    fn file(&self) -> String {
        let name = self.job.sources().get(FileId(0)).map_or("", |source| source.name());
        let name = name.rsplit(['/', '\\']).next().unwrap_or(name).to_ascii_uppercase();
        name.chars()
            .map(|c| if c.is_ascii_alphanumeric() || ".-_".contains(c) { c } else { ' ' })
            .collect()
    }
}
