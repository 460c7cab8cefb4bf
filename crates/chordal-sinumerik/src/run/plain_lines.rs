//! Carries out plain lines: straight moves between points that stand in the text.

use chordal_command::{AxisMask, Origin};
use chordal_diagnostics::Span;
use chordal_geometry::Plane;
use chordal_kernel::{ModalMotion, Statement, WordMeaning};

use super::interpreter::Interpreter;
use super::run_state::{PathMotion, TransverseReading};
use super::words::{center_words, name_of_word, span_of_words};
use crate::syntax::PlainLine;

impl Interpreter<'_> {
    /// The next line, if it is a plain one and does nothing but move to its coordinates; otherwise `None`, and nothing is
    /// read.
    pub(super) fn next_plain_line(&mut self) -> Option<PlainLine> {
        if !self.takes_plain_lines() {
            return None;
        }
        let needs_motion = !matches!(self.modes.motion, PathMotion::Rapid | PathMotion::Linear);
        self.running().reader.next_plain(needs_motion)
    }

    /// Whether no frame, no modal cycle and no rounding acts on a plain line.
    fn takes_plain_lines(&self) -> bool {
        let modes = &self.modes;
        self.modal_call.is_none()
            && !self.kernel.state.incremental
            && modes.is_plain_frame
            && modes.modal_rounding_mm == 0.0
            && modes.transverse == TransverseReading::Radius
            && modes.open_approach.is_none()
    }

    /// Carries out a plain line, as `block` would do it.
    pub(super) fn plain_line(&mut self, line: &PlainLine) {
        let (file, call) = (self.file(), self.running().call);
        let span = line.range.in_file(file);
        self.kernel.call = call;
        self.kernel.origin = Origin { span, line: line.line, call, cycle: false };
        if let Some(number) = line.number {
            self.kernel.block_number = Some(f64::from(number));
        }
        if let Some(is_rapid) = line.is_rapid {
            self.modes.motion = if is_rapid { PathMotion::Rapid } else { PathMotion::Linear };
        }
        if let Some(feed) = line.feed {
            self.set_feed_word(feed.value, feed.range);
        }
        let unit = self.unit_mm();
        let start = self.kernel.state.position;
        let mut end = start;
        let mut named = AxisMask::NONE;
        for (axis, word) in line.axes.iter().enumerate() {
            let Some(word) = word else { continue };
            end[axis] = word.value * unit;
            named.insert(axis);
        }
        if named == AxisMask::NONE {
            return;
        }
        (self.modes.polar_angle, self.modes.polar_radius) = (None, None);
        self.kernel.state.place(named);
        self.kernel.state.motion = match self.modes.motion {
            PathMotion::Rapid => ModalMotion::Rapid,
            _ => ModalMotion::Linear,
        };
        self.kernel.straight(&PlainLineView { span, line }, end, named);
        let end = self.kernel.state.position;
        let along: [f64; 3] = std::array::from_fn(|axis| end[axis] - start[axis]);
        if along != [0.0; 3] {
            self.modes.last_direction = Some(along);
        }
        self.kernel.corner_move_done();
    }
}

/// A plain line as the kernel sees it.
struct PlainLineView<'l> {
    span: Span,
    line: &'l PlainLine,
}

impl Statement for PlainLineView<'_> {
    fn span(&self) -> Span {
        self.span
    }

    fn words(&self, what: WordMeaning) -> Span {
        let WordMeaning::Axes(axes) = what else { return self.span };
        let words = self.line.axes.iter().enumerate().filter(|(axis, _)| axes.has(*axis));
        span_of_words(self.span, words.filter_map(|(_, word)| Some(word.as_ref()?.range)))
    }

    fn name(&self, what: WordMeaning) -> &'static str {
        name_of_word(what)
    }

    fn center_names(&self, plane: Plane) -> [&'static str; 2] {
        center_words(plane)
    }

    fn number(&self, _: WordMeaning) -> Option<String> {
        None
    }

    fn has(&self, what: WordMeaning) -> bool {
        let WordMeaning::Axes(axes) = what else { return false };
        self.line.axes.iter().enumerate().any(|(axis, word)| axes.has(axis) && word.is_some())
    }

    fn has_feed(&self) -> bool {
        self.line.feed.is_some()
    }
}
