//! Path modes: G61, G64, G9, G187, G05.1 and similar codes.

use chordal_command::{CommandKind, PathMode};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_dialect::PathCode;
use chordal_dialect::{CodeGroup, CodeRow};
use chordal_syntax::Block;

use super::Interpreter;

impl Interpreter<'_> {
    /// Carries out a code of the path modes.
    pub(super) fn take_path_mode(
        &mut self,
        block: &Block,
        row: &'static CodeRow,
        code: PathCode,
        at: usize,
    ) {
        let rules = self.control.parameters.rules.path;
        let path = &mut self.kernel.state.path;
        match code {
            PathCode::Exact => path.set_mode(PathMode::ExactPath),
            PathCode::ExactStop => path.set_mode(PathMode::ExactStop),
            PathCode::ExactStopOnce => path.once = true,
            PathCode::Continuous | PathCode::Tapping | PathCode::CornerOverride => {
                if code == PathCode::CornerOverride {
                    self.report_no_corner_override(block, row, at);
                }
                let own = if row.words.has(b'P') { self.length_of(block, b'P') } else { None };
                if row.words.has(b'Q') {
                    self.report_lines_stay(block);
                }
                let tolerance_mm = own.or(rules.of_level(rules.level));
                self.kernel.state.path.set_mode(rules.continuous(tolerance_mm, false));
            }
            PathCode::HighAccuracy => {
                let tolerance_mm = rules.look_ahead_mm.or(rules.of_level(rules.level));
                path.set_mode(rules.continuous(tolerance_mm, true));
            }
            PathCode::LookAhead { letter, on } => {
                match self.count_of(block, letter) {
                    Some(0) => self.kernel.state.path.set_look_ahead(&rules, false),
                    Some(value) if on.contains(&value) => {
                        self.kernel.state.path.set_look_ahead(&rules, true);
                    }
                    // The code has another meaning with this value, or an unknown one.
                    _ => return self.not_simulated(&block.words[at], row),
                }
            }
            PathCode::Smoothness => self.smoothness(block),
        }
        self.kernel.emit(CommandKind::PathMode(self.kernel.state.path.in_force()));
        if row.group == CodeGroup::PathMode {
            self.kernel.set_tapping_mode(code == PathCode::Tapping);
        }
    }

    /// Reports G62, which reduces the feed at inside corners of a compensated contour.
    fn report_no_corner_override(&mut self, block: &Block, row: &CodeRow, at: usize) {
        let name = row.name(b'G');
        self.kernel.report(
            Diagnostic::new(
                Code::NotSimulated,
                self.span(block.words[at].range),
                format!("{name} slows down in inside corners while G41 or G42 is active; Chordal does not"),
            )
            .label("the path is right, the time a little short"),
        );
    }

    /// Reports Q of LinuxCNC's G64, with which the control joins nearly straight lines into one move.
    fn report_lines_stay(&mut self, block: &Block) {
        let Some(within) = self.length_of(block, b'Q').filter(|mm| *mm > 0.0) else { return };
        let word = block.last(b'Q').map_or(block.range, |word| word.range);
        self.kernel.report(
            Diagnostic::new(
                Code::NotSimulated,
                self.span(word),
                format!(
                    "Chordal does not join lines within {} of one straight line into one move",
                    self.kernel.length_text(within)
                ),
            )
            .label("the control may join them")
            .help("corners are rounded within P; path and time are those of the programmed lines")
            .severity(Severity::Note),
        );
    }

    /// Haas G187: P selects a level, E gives the tolerance itself; without both the settings apply.
    fn smoothness(&mut self, block: &Block) {
        let rules = self.control.parameters.rules.path;
        let own = self.length_of(block, b'E').filter(|mm| *mm >= 0.0);
        let level = self.count_of(block, b'P');
        if let Some(level) = level.filter(|level| !(1..=3).contains(level)) {
            let word = block.last(b'P').map_or(block.range, |word| word.range);
            self.kernel.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word),
                    format!("G187 has the levels P1, P2 and P3; this is P{level}"),
                )
                .help("write P1 (rough), P2 (medium) or P3 (finish)"),
            );
            return;
        }
        let of_level = level.and_then(|level| rules.of_level(level as u8));
        self.kernel.state.path.set_distance(own.or(of_level));
    }
}
