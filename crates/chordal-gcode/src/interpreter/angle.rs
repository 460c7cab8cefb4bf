//! Lines by their angle (`,A`), as dimensioned on drawings of turned parts.

use chordal_command::{AxisMask, Origin, Position};
use chordal_diagnostics::TextRange;
use chordal_kernel::{ModalMotion, ProgrammedCorner};
use chordal_machine::Axis;
use chordal_syntax::{Block, Word};

use super::Interpreter;

const X: usize = Axis::X as usize;
const Z: usize = Axis::Z as usize;

/// A line with an angle but no end point: it ends where it meets the line of the next block.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct OpenLine {
    origin: Origin,
    word: TextRange,
    degrees: f64,
    feed: Option<f64>,
    /// The rounding or chamfer at its end.
    corner: Option<ProgrammedCorner>,
}

fn angle_word(block: &Block) -> Option<&Word> {
    block.words.iter().find(|word| word.comma && word.letter == b'A')
}

impl Interpreter<'_> {
    /// `,A`: a straight cut at an angle from +Z, with one end coordinate; or with none, if the next block has both and
    /// its own angle.
    pub(super) fn line_by_angle(
        &mut self,
        block: &Block,
        target: &mut Position,
        named: &mut AxisMask,
    ) {
        let Some(word) = angle_word(block).copied() else { return };
        let Some(degrees) = self.literal(&word).map(|number| number.to_f64()) else { return };
        let tangent = libm::tan(degrees.to_radians());
        let from = self.kernel.state.position;
        match (named.has(X), named.has(Z)) {
            (false, true) => target[X] = from[X] + (target[Z] - from[Z]) * tangent,
            (true, false) if tangent.abs() > 1e-9 => {
                target[Z] = from[Z] + (target[X] - from[X]) / tangent;
            }
            (true, true) => return,
            (false, false) if self.kernel.state.motion == ModalMotion::Linear => {
                self.lose_open_line("the next block does not end it");
                let corner = self.kernel.take_requested_corner();
                let feed = self.kernel.state.feed;
                let origin = self.kernel.origin;
                self.open_line = Some(OpenLine { origin, word: word.range, degrees, feed, corner });
                return;
            }
            (false, false) | (true, false) => {
                let message = "a line by its angle (`,A`) has no end here";
                return self.lose_path(word.range, message.to_string());
            }
        }
        named.insert(X);
        named.insert(Z);
    }

    /// Ends the line of the previous block, which has only an angle, where it meets the line of this block.
    pub(super) fn end_open_line(&mut self, block: &Block, target: &Position, named: AxisMask) {
        let Some(open) = self.open_line.take() else { return };
        let angle = angle_word(block).copied().and_then(|word| self.literal(&word));
        let whole = named.has(X) && named.has(Z) && self.kernel.state.motion == ModalMotion::Linear;
        let Some(angle) = angle.filter(|_| whole) else {
            self.open_line = Some(open);
            return self.lose_open_line("the next block needs G1, X, Z and `,A`");
        };
        let from = self.kernel.state.position;
        let (sin, cos) = libm::sincos(open.degrees.to_radians());
        let (next_sin, next_cos) = libm::sincos(angle.to_f64().to_radians());
        let (dz, dx) = (target[Z] - from[Z], target[X] - from[X]);
        let cross = cos * next_sin - sin * next_cos;
        let along = (dz * next_sin - dx * next_cos) / cross;
        if cross.abs() < 1e-9 || along <= 0.0 || !along.is_finite() {
            self.open_line = Some(open);
            return self.lose_open_line("it does not meet the line of the next block");
        }
        let mut corner = from;
        corner[Z] += along * cos;
        corner[X] += along * sin;
        // The move belongs to its own block, with the corner and the feed of that block.
        let own = self.kernel.take_requested_corner();
        let (origin, feed) = (self.kernel.origin, self.kernel.state.feed);
        (self.kernel.origin, self.kernel.state.feed) = (open.origin, open.feed);
        open.corner.into_iter().for_each(|corner| self.kernel.request_corner(corner));
        self.kernel.straight(&self.at(block), corner, AxisMask((1 << X) | (1 << Z)));
        self.kernel.corner_move_done();
        (self.kernel.origin, self.kernel.state.feed) = (origin, feed);
        own.into_iter().for_each(|corner| self.kernel.request_corner(corner));
    }

    /// Reports a line with only an angle that no following block ends.
    pub(super) fn lose_open_line(&mut self, why: &str) {
        if let Some(open) = self.open_line.take() {
            let message = format!("a line by its angle alone (`,A`) is not followed: {why}");
            self.lose_path(open.word, message);
        }
    }
}
