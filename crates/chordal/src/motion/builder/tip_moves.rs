//! Moves in a frame of the part: the tip follows the path, and the axes are planned.

use chordal_command::Command;
use chordal_geometry::{Curve, ParamCurve};
use chordal_path::{Segment, axis_pieces, tip_pieces};

use super::MotionBuilder;
use crate::motion::corner::PieceEnd;
use crate::motion::{MotionSink, PlacedPartFrame};

/// A tip that goes less than this share of what the axes go rests: distances along its path would be too small a measure.
const LEAST_TIP_SHARE: f64 = 1e-3;

/// The radius at which turns of rotary axes count as distances there, mm.
const RADIUS_OF_TURNS_MM: f64 = 100.0;

/// The length of the tip's path, mm, along which a move of the axes is measured while rotary axes turn; `None` where that of
/// the axes' own path is the better measure.
pub(super) fn path_length(segment: &Segment, tip_mm: f64) -> Option<f64> {
    let turns =
        segment.rotary_from.iter().zip(&segment.rotary_to).map(|(from, to)| (to - from).abs());
    let turn: f64 = turns.sum();
    let axes_mm = segment.length_mm + RADIUS_OF_TURNS_MM * turn;
    let is_measure = turn > 0.0 && tip_mm > LEAST_TIP_SHARE * axes_mm;
    (is_measure && matches!(segment.curve, Curve::Line(_))).then_some(tip_mm)
}

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
        let mut parts = std::mem::take(&mut self.tip_parts);
        parts.clear();
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
        self.tip_parts = parts;
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
