//! RND and CHF: blocks of their own, which change the end of the move before them.

use chordal_command::{AxisMask, Origin};
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_kernel::{CornerForm, ProgrammedCorner};

use super::interpreter::KlartextInterpreter;
use crate::alarms::{CHAMFER_NOT_PERMITTED, ROUNDING_UNDEFINED};
use crate::geometry::ContourElement;
use crate::syntax::{FeedValue, FeedWord, KlartextStatement, OperandWord, PathFunction};

/// The words of a block that is a corner.
const CORNER_WORDS: [&[u8]; 4] = [b"RND", b"CHF", b"G24", b"G25"];

impl KlartextInterpreter<'_> {
    /// Requests the corner that the next block programs at the end of the move that follows.
    pub(super) fn request_corner(&mut self, element: &ContourElement) {
        self.modes.has_corner = false;
        let Some(block) = self.running().reader.peek_with(&CORNER_WORDS) else { return };
        let (size, feed, form, name) = match &block.statement {
            KlartextStatement::Rounding(words) => {
                (words.radius, words.feed, CornerForm::Rounding, "RND")
            }
            KlartextStatement::Chamfer(size, words) => {
                (*size, words.feed, CornerForm::Chamfer, "CHF")
            }
            _ => return,
        };
        // What is wrong with the size is reported at the block itself.
        self.modes.has_corner = true;
        let Some(value) = size.and_then(|size| self.operand(size.value, size.range)) else {
            return;
        };
        if value <= 0.0 {
            return;
        }
        let is_at_arc =
            matches!(element, ContourElement::Arc { .. }) || self.arc_comes_after_corner();
        if form == CornerForm::Chamfer && is_at_arc {
            let message =
                "a chamfer stands between straight lines, and one of its elements is an arc";
            return self.alarm(CHAMFER_NOT_PERMITTED, Code::CornerBlock, block.range, message);
        }
        let plane = self.tool_plane();
        let size_mm = value * self.unit_mm() * self.modes.frame.factor(plane);
        let (file, call) = (self.file(), self.running().call);
        let span = block.range.in_file(file);
        let origin = Origin { span, line: block.line, call, cycle: false };
        let feed = self.corner_feed(feed);
        let corner =
            ProgrammedCorner { word: span, name, form, size_mm, block: Some(origin), feed };
        self.kernel.request_corner(corner);
    }

    /// F of a corner: it counts for the corner alone.
    fn corner_feed(&mut self, feed: Option<FeedWord>) -> Option<f64> {
        let feed = feed?;
        let FeedValue::Value(value) = feed.value else { return None };
        let value = self.operand(value, feed.range)?;
        (value > 0.0).then(|| self.feed_mm(value, self.kernel.state.feed_mode))
    }

    /// Whether the element after the corner block that comes next is an arc.
    fn arc_comes_after_corner(&mut self) -> bool {
        let mut reader = self.running().reader.clone();
        let is_other = |block: &crate::syntax::KlartextBlock| {
            !matches!(
                block.statement,
                KlartextStatement::Rounding(_)
                    | KlartextStatement::Chamfer(..)
                    | KlartextStatement::Center(_)
                    | KlartextStatement::FreePole(_)
                    | KlartextStatement::FreeSelection(_)
                    | KlartextStatement::Nothing
            )
        };
        match reader.find(is_other).map(|block| block.statement) {
            Some(KlartextStatement::FreeElement(words)) => words.is_arc,
            Some(KlartextStatement::Path(function, _)) => matches!(
                function,
                PathFunction::CenterArc
                    | PathFunction::PolarArc
                    | PathFunction::RadiusArc
                    | PathFunction::TangentArc
                    | PathFunction::PolarTangentArc
            ),
            _ => false,
        }
    }

    /// A block RND or CHF itself: its size, and whether a move came before it.
    pub(super) fn check_corner_block(&mut self, name: &str, size: Option<OperandWord>) {
        let range: TextRange = self.here;
        let had_move = std::mem::take(&mut self.modes.has_corner);
        let Some(size) = size else {
            return self.problem(Code::MissingWord, range, format!("{name} has no size"));
        };
        let Some(value) = self.operand(size.value, size.range) else { return };
        if value < 0.0 {
            let message = format!("the size of {name} is {value}: it must be above zero");
            return self.bad_value(size.range, message, "the control finds the side by itself");
        }
        // A move that goes to a place that is not known here is no element, and none is missing.
        let is_lost = self.kernel.state.astray != AxisMask::NONE;
        if !had_move && !is_lost {
            let message = format!("no element of the contour comes before this {name}");
            let diagnostic = Diagnostic::new(Code::CornerBlock, self.span(range), message);
            let help = "write it between two elements that cut in the plane";
            self.report_alarm(ROUNDING_UNDEFINED, diagnostic.help(help));
        }
    }
}
