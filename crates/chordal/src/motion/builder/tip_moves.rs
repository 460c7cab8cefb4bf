//! Moves in a frame of the part: the tip follows the path, and the axes are planned.

use chordal_command::Command;
use chordal_geometry::ParamCurve;
use chordal_path::{Segment, axis_pieces, tip_pieces};

use super::MotionBuilder;
use crate::motion::corner::PieceEnd;
use crate::motion::{MotionSink, PlacedPartFrame};

impl<S: MotionSink> MotionBuilder<'_, S> {
    /// Makes steps of the axes while the tip follows the path segments. Returns false where the kinematics are not known.
    pub(super) fn follows_tip(
        &mut self,
        command: &Command,
        segments: &[Segment],
        placed: PlacedPartFrame,
    ) -> bool {
        let Some(motion) = command.kind.motion() else { return false };
        let tolerance_mm = self.axis_chord_tolerance_mm;
        let mut parts = Vec::new();
        let mut index = 0;
        tip_pieces(&command.kind, motion, |curve, ends| {
            let pieces = axis_pieces(&placed.frame, curve, ends, &placed.offsets, tolerance_mm);
            parts.extend(pieces.into_iter().flatten().map(|piece| (index, piece)));
            index += 1;
        });
        let count = parts.len();
        self.part_frame = Some(self.number_of_frame(placed));
        for (at, (index, piece)) in parts.iter().enumerate() {
            let Some(whole) = segments.get(*index) else { break };
            let part = Segment {
                curve: piece.curve,
                length_mm: piece.curve.length(),
                duration_s: whole.duration_s * piece.share,
                rotary_from: piece.rotary_from,
                rotary_to: piece.rotary_to,
                ..*whole
            };
            self.piece = self.pieces + *index as u64;
            let goes_on = parts.get(at + 1).is_some_and(|(next, _)| next == index);
            let end = PieceEnd {
                chord_tolerance_mm: goes_on.then_some(tolerance_mm),
                tip_length_mm: Some(whole.length_mm * piece.share),
                ..PieceEnd::new(command.origin.cycle, at + 1 < count)
            };
            self.segment(&part, end);
        }
        self.part_frame = None;
        count > 0
    }

    /// The number of a frame in the report, to which it is added where it is new.
    fn number_of_frame(&mut self, placed: PlacedPartFrame) -> u32 {
        let frames = &mut self.report.part_frames;
        // Mostly the last one goes on.
        if frames.last() != Some(&placed) {
            frames.push(placed);
        }
        frames.len() as u32 - 1
    }
}
