//! Saving and restoring modes: M70 to M73 (LinuxCNC).

use chordal_command::{
    CompensationSide, Coolant, FeedMode, Overrides, SpindleState, Units, WorkName,
};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::BeforeCode;
use chordal_geometry::Plane;
use chordal_kernel::LengthOffset;
use chordal_kernel::PathState;
use chordal_kernel::rules::ArcCenter;
use chordal_syntax::Block;

use super::Interpreter;

/// The modes saved at one call level.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct KeptModes {
    /// The call depth.
    depth: usize,
    /// They are restored at the return (M73).
    until_return: bool,
    modes: WordModes,
}

/// The saved modes: all except motion code and position.
#[derive(Clone, Debug, PartialEq)]
struct WordModes {
    units: Units,
    /// Factor of X words: 0.5 for diameters.
    per_x: f64,
    plane: Plane,
    side: CompensationSide,
    incremental: bool,
    arc_center: ArcCenter,
    feed_mode: FeedMode,
    feed: Option<(f64, f64)>,
    work: WorkName,
    length: bool,
    return_to_r: bool,
    path: PathState,
    overrides: Overrides,
    rpm: f64,
    spindle: SpindleState,
    coolant: Coolant,
}

impl Interpreter<'_> {
    /// M70, M71 and M73, which act before all other codes of their block.
    pub(super) fn keep_modes(&mut self, block: &Block, code: BeforeCode, at: usize) {
        let depth = self.frames.len();
        let has = self.kept_modes.iter().any(|kept| kept.depth == depth);
        if let BeforeCode::SaveModes { until_return } = code {
            let modes = self.active_modes();
            self.kept_modes.retain(|kept| kept.depth < depth);
            self.kept_modes.push(KeptModes { depth, until_return, modes });
        } else if code == BeforeCode::ForgetModes {
            self.kept_modes.retain(|kept| kept.depth != depth);
        } else if code == BeforeCode::RestoreModes && !has {
            let span = self.span(block.words[at].range);
            self.kernel.report(
                Diagnostic::new(
                    Code::NoKeptModes,
                    span,
                    "M72 brings modes back, and none were kept at this level of calls",
                )
                .help("write M70 or M73 before it, in the same subprogram"),
            );
        }
    }

    fn active_modes(&self) -> WordModes {
        let state = &self.kernel.state;
        let tool = state.offsets.tool_in_force();
        WordModes {
            units: state.units,
            per_x: self.per_word[0],
            plane: state.plane,
            side: state.side,
            incremental: state.incremental,
            arc_center: state.arc_center,
            feed_mode: state.feed_mode,
            feed: state.feed.zip(state.feed_angular),
            work: state.offsets.active(),
            length: tool.iter().any(|offset| *offset != 0.0),
            return_to_r: state.return_to_r,
            path: state.path,
            overrides: state.overrides.by_code,
            rpm: state.rpm,
            spindle: state.spindle,
            coolant: state.coolant,
        }
    }

    /// M72, which acts after the modes of its block and before its motion.
    pub(super) fn restore_modes(&mut self, block: &Block) {
        let depth = self.frames.len();
        let kept = self.kept_modes.iter().find(|kept| kept.depth == depth);
        if let Some(modes) = kept.map(|kept| kept.modes.clone()) {
            self.apply_modes(block, modes);
        }
    }

    /// At the return from a call depth: removes its saved modes, and restores them after M73.
    pub(super) fn modes_at_return(&mut self, depth: usize) {
        while let Some(kept) = self.kept_modes.pop_if(|kept| kept.depth >= depth) {
            if kept.until_return && kept.depth == depth {
                let mut block = Block::new();
                block.range = self.kernel.origin.span.range;
                self.apply_modes(&block, kept.modes);
            }
        }
    }

    fn apply_modes(&mut self, block: &Block, modes: WordModes) {
        let span = self.span(block.range);
        self.set_units(modes.units);
        self.per_word[0] = modes.per_x;
        if self.kernel.state.side != modes.side {
            self.kernel.state.side = modes.side;
            let number = (modes.side != CompensationSide::Off).then_some(self.kernel.state.tool);
            self.kernel.emit_compensation(number, None, span);
        }
        self.kernel.set_plane(span, modes.plane);
        self.kernel.set_incremental(modes.incremental);
        self.kernel.state.arc_center = modes.arc_center;
        self.kernel.set_feed_mode(modes.feed_mode);
        self.select_work(modes.work);
        let tool = self.kernel.state.tool;
        let number = (modes.length && tool > 0).then_some(tool);
        if number.is_some() || self.active_modes().length {
            self.kernel.set_length(&self.at(block), LengthOffset { number, minus: false });
        }
        self.kernel.state.return_to_r = modes.return_to_r;
        if self.kernel.state.path != modes.path {
            self.kernel.change_path_mode(|path| *path = modes.path);
        }
        self.kernel.set_overrides(Some(modes.overrides.feed), Some(modes.overrides.rapid));
        if let Some((feed, angular)) = modes.feed
            && self.kernel.state.feed != Some(feed)
        {
            self.kernel.set_feed(span, feed, angular);
        }
        if self.kernel.state.rpm != modes.rpm {
            self.kernel.set_speed(modes.rpm);
        }
        if self.kernel.state.spindle != modes.spindle {
            self.kernel.set_spindle(modes.spindle);
        }
        self.kernel.set_coolant(|coolant| *coolant = modes.coolant);
    }
}
