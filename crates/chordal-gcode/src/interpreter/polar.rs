//! End points by radius and angle about the work origin: `@` and `^` (LinuxCNC).

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};
use chordal_dialect::{Action, CodeRow, OnceCode};
use chordal_geometry::Plane;
use chordal_syntax::{Block, Letters, Word};

use super::Interpreter;

impl Interpreter<'_> {
    /// Computes X and Y from radius and angle; an omitted one keeps its present value.
    #[cold]
    pub(super) fn radius_and_angle(
        &mut self,
        block: &Block,
        target: &mut Position,
        named: &mut AxisMask,
    ) {
        let from = self.kernel.state.position;
        let incremental = self.kernel.state.incremental;
        let last = |letter: u8| block.polar.iter().rfind(|word| word.letter == letter).copied();
        let (radius_word, angle_word) = (last(b'@'), last(b'^'));
        let now = libm::hypot(from[0], from[1]);
        let base = if incremental { now } else { 0.0 };
        let radius = match radius_word {
            Some(word) => self.length(&word).map(|radius| base + radius),
            None => Some(now),
        };
        let angle_now = libm::atan2(from[1], from[0]);
        let base = if incremental { angle_now } else { 0.0 };
        let angle = match angle_word {
            Some(word) => self.literal(&word).map(|angle| base + angle.to_f64().to_radians()),
            None => Some(angle_now),
        };
        let (Some(radius), Some(angle)) = (radius, angle) else { return };
        target[0] = radius * libm::cos(angle);
        target[1] = radius * libm::sin(angle);
        named.insert(0);
        named.insert(1);
    }

    /// True when the polar words of a block are permitted; otherwise this is reported and the block does not move.
    #[cold]
    pub(super) fn check_polar(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
    ) -> bool {
        let taker = codes.iter().find(|(row, _)| row.takes_axes());
        let span = polar_span(&block.polar);
        let at_origin = self.kernel.state.position[..2] == [0.0; 2];
        let only = |letter: u8| block.polar.iter().all(|word| word.letter == letter);
        let in_increments = at_origin && self.kernel.state.incremental;
        let machine = Action::Once(OnceCode::MachineCoordinates);
        let (message, alarm, help) = if let Some((row, at)) =
            taker.filter(|(row, _)| !is_probe(row))
        {
            let name = row.name(block.words[*at].letter);
            (
                format!("{name} cannot take its axes from polar words"),
                match row.action == machine {
                    true => "Cannot use polar coordinates with G53".to_string(),
                    false => "Polar coordinates can only be used for motion".to_string(),
                },
                "write X and Y in this block",
            )
        } else if block.letters().meets(Letters::of("XY")) {
            let letter = if block.letters().has(b'X') { 'X' } else { 'Y' };
            (
                format!("this block has polar words and {letter}"),
                format!("Cannot specify both polar coordinate and {letter} word"),
                "write either @ and ^, or X and Y",
            )
        } else if self.kernel.state.plane != Plane::Xy {
            (
                "polar words work only in G17, the XY plane".to_string(),
                "Cannot use polar coordinate except in G17 plane".to_string(),
                "write G17 before, or the axes themselves",
            )
        } else if in_increments {
            (
                "polar words in G91 at the work origin, where there is no angle to add to"
                    .to_string(),
                "Incremental motion with polar coordinates is indeterminate when at the origin"
                    .to_string(),
                "write G90, or move away from the origin before",
            )
        } else if at_origin && only(b'@') {
            (
                "`@` without `^` at the work origin, where there is no angle to keep".to_string(),
                "Must specify angle in polar coordinate if at the origin".to_string(),
                "write the angle: `@10 ^0`",
            )
        } else {
            return true;
        };
        let title = self.control.table.title;
        let diagnostic = Diagnostic::new(Code::PolarWords, self.span(span), message)
            .label("nothing moves in this block")
            .alarm(format!("{title}: {alarm}"))
            .severity(Severity::Error)
            .help(help);
        self.kernel.report(diagnostic);
        false
    }
}

fn is_probe(row: &CodeRow) -> bool {
    matches!(row.action, Action::Once(OnceCode::Probe { .. }))
}

fn polar_span(words: &[Word]) -> TextRange {
    words.iter().map(|word| word.range).reduce(TextRange::cover).unwrap_or_default()
}
