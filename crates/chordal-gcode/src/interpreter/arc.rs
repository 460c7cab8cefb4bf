//! Reads the words of arcs and helices: centre words, R, number of turns.

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_dialect::CenterAndRadius;
use chordal_dialect::table::ArcTurns;
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::ArcWords;
use chordal_kernel::ModalMotion;
use chordal_kernel::rules::SpiralForm;
use chordal_syntax::{Block, Letters, Word};

use super::Interpreter;

const CENTER: Letters = Letters::of("IJK");

/// Centre letters by axis.
const CENTER_LETTERS: [u8; 3] = *b"IJK";

/// The centre letters of a plane: of its first, its second and its normal axis.
pub(super) fn center_letters(plane: Plane) -> (u8, u8, u8) {
    let (a, b, normal) = plane.axes();
    (CENTER_LETTERS[a], CENTER_LETTERS[b], CENTER_LETTERS[normal])
}

/// The name of a plane with its code, for messages.
pub(super) fn plane_name(plane: Plane) -> &'static str {
    match plane {
        Plane::Xy => "G17, the XY plane",
        Plane::Zx => "G18, the ZX plane",
        Plane::Yz => "G19, the YZ plane",
    }
}

impl Interpreter<'_> {
    /// The word that gives the radius: R, or R0 on controls where R names registers.
    pub(super) fn radius_word(&self, block: &Block) -> Option<Word> {
        if self.control.table.lexicon.registers {
            block.all(b'R').find(|word| word.register == Some(0)).copied()
        } else {
            block.last(b'R').copied()
        }
    }

    /// Carries out a block whose motion is an arc: by centre, by radius, or a spiral of the control.
    pub(super) fn arc_block(
        &mut self,
        block: &Block,
        direction: TurnDirection,
        mut target: Position,
        named: AxisMask,
        explicit: bool,
    ) {
        let at = self.at(block);
        let letters = block.letters();
        let (a_letter, b_letter, normal_letter) = center_letters(self.kernel.state.plane);
        let has_center = letters.has(a_letter) || letters.has(b_letter);
        let radius = if letters.has(b'R') { self.radius_word(block) } else { None };
        self.kernel.snap_to_start(&mut target);
        if self.is_spiral_of_type_two(block, &target) {
            return self.spiral_of_type_two(block, direction, target, named);
        }
        let outside = letters.has(normal_letter) && self.check_height_word(block);
        if has_center && radius.is_some() && !self.center_and_radius(block) {
            return self.kernel.straight_instead(&self.at(block), target, named);
        }
        let turns = self.extra_turns(block, &target, radius.is_some());
        let center = match radius {
            None if has_center => {
                [self.length_of(block, a_letter), self.length_of(block, b_letter)]
            }
            _ => [None; 2],
        };
        let arc = ArcWords { direction, center, turns };
        match radius {
            Some(word) => {
                let Some(value) = self.length(&word) else { return };
                let radius = (self.span(word.range), value);
                self.kernel.arc_by_radius(&at, radius, &arc, target, named);
            }
            None if has_center => {
                if let Some(misfit) = self.kernel.arc_about_center(&at, &arc, target, named) {
                    self.report_misfit(block, *misfit);
                }
            }
            None if self.control.parameters.arc_without_center_is_line => {
                self.line_in_arc_mode(block, target, named, explicit);
            }
            None => {
                // The wrong centre word was the only one and is already reported: one problem, not two.
                if !outside {
                    self.report_no_center(block, explicit);
                }
                self.kernel.straight_instead(&self.at(block), target, named);
            }
        }
    }

    /// P of an arc, as full turns in addition to the arc between start and end.
    fn extra_turns(&mut self, block: &Block, target: &Position, by_radius: bool) -> u32 {
        let rule = self.control.table.arc_turns;
        let has = self.control.parameters.build.turns;
        if rule == ArcTurns::None || !has || !block.letters().has(b'P') {
            return 0;
        }
        if matches!(rule, ArcTurns::Extra | ArcTurns::BeyondAngle) && by_radius {
            // A radius determines an arc of less than a turn.
            if let Some(word) = block.word(b'P').copied() {
                self.unused_word(&word);
            }
            return 0;
        }
        let turns = self.count_of(block, b'P').unwrap_or(0).min(9999);
        match rule {
            ArcTurns::Total => turns.saturating_sub(1),
            ArcTurns::BeyondAngle if self.ends_at_its_start(target) => turns.saturating_sub(1),
            ArcTurns::BeyondAngle | ArcTurns::Extra | ArcTurns::None => turns,
        }
    }

    /// True when start and end coincide in the plane: the arc is a full circle.
    fn ends_at_its_start(&self, target: &Position) -> bool {
        let (first, second, _) = self.kernel.state.plane.axes();
        let from = &self.kernel.state.position;
        target[first] == from[first] && target[second] == from[second]
    }

    /// Reports a centre word outside the plane. Controls with cones read it as the height word: there it is only ignored
    /// on other arcs, with a warning. A zero, as postprocessors write it, is accepted. True when reported as an error.
    pub(super) fn check_height_word(&mut self, block: &Block) -> bool {
        let (_, _, letter) = center_letters(self.kernel.state.plane);
        let Some(word) = block.last(letter) else { return false };
        let strict = self.control.table.strict_center_words;
        if !strict && self.is_zero(word) {
            return false;
        }
        let is_ignored = !strict && self.control.parameters.rules.arc.spiral != SpiralForm::None;
        let severity = if is_ignored { Severity::Warning } else { Severity::Error };
        let plane = self.kernel.state.plane;
        let (a, b, _) = center_letters(plane);
        let span = self.words_span(block, Letters(1 << (letter - b'A')));
        self.kernel.report(
            Diagnostic::new(
                Code::CenterOutsidePlane,
                span,
                format!("{} does not belong to {}", letter as char, plane_name(plane)),
            )
            .severity(severity)
            .label(format!("only {} and {} here", a as char, b as char))
            .help("remove the word, or choose the plane with G17, G18 or G19"),
        );
        !is_ignored
    }

    /// Reports an arc with both a centre and a radius; true when R is used.
    fn center_and_radius(&mut self, block: &Block) -> bool {
        let wins = self.control.parameters.center_and_radius == CenterAndRadius::RadiusWins;
        let span = self.words_span(block, Letters::of("IJKR"));
        let (what, severity) = if wins {
            ("R is followed", Severity::Warning)
        } else {
            ("the control refuses the block", Severity::Error)
        };
        self.kernel.report(
            Diagnostic::new(
                Code::CenterAndRadius,
                span,
                format!("this arc has both a centre and a radius; {what}"),
            )
            .severity(severity)
            .help("keep one of them"),
        );
        wins
    }

    fn report_no_center(&mut self, block: &Block, explicit: bool) {
        let span = self.span(block.range);
        let (a, b, _) = center_letters(self.kernel.state.plane);
        let message = if explicit {
            "this arc has neither a centre nor a radius"
        } else {
            "an arc is active from a block before, and this block has neither centre nor radius"
        };
        self.kernel.report(
            Diagnostic::new(Code::NoCenter, span, message)
                .label("shown as a straight line")
                .help(format!("give {} and {} or R, or write G1 for a line", a as char, b as char)),
        );
    }

    /// Fadal: reports G2 or G3 in a block without a centre, which is a line.
    pub(super) fn report_line_for_arc(&mut self, block: &Block) {
        let span = self.words_span(block, Letters::of("G"));
        let rapid = self.kernel.state.motion == ModalMotion::Rapid;
        let message = if rapid {
            "G2 or G3 without a centre, and G0 is active: this control makes a rapid"
        } else {
            "G2 or G3 without a centre: this control makes a straight line"
        };
        let mut diagnostic = Diagnostic::new(Code::NoCenter, span, message)
            .severity(Severity::Warning)
            .label("no I, J, K or R0 in this block")
            .help(if rapid {
                "give the centre; for a straight cut write G1"
            } else {
                "give the centre, or leave the G code out"
            });
        diagnostic.alarm = None;
        self.kernel.report(diagnostic);
    }

    /// Fadal: reports a block without a motion code after an arc that was cut while G0 is active.
    #[cold]
    fn report_rapid_after_arc(&mut self, block: &Block) {
        let span = self.span(block.range);
        self.kernel.report(
            Diagnostic::new(
                Code::RapidAfterArc,
                span,
                "this block is a rapid: G0 is still active, because G2 and G3 do not cancel it here",
            )
            .label("no motion code, after an arc")
            .help("write G1 for a cut, G0 for a rapid"),
        );
    }

    /// Remembers an arc that is cut while G0 is active, and reports a rapid in the block after it; `meant` when that
    /// block names its motion.
    #[inline]
    pub(super) fn watch_rapid_after_arc(&mut self, block: &Block, arc: bool, meant: bool) {
        let before = self.kernel.state.arc_over_rapid;
        self.kernel.state.arc_over_rapid = arc && self.kernel.state.motion == ModalMotion::Rapid;
        if before && !meant && self.kernel.state.motion == ModalMotion::Rapid {
            self.report_rapid_after_arc(block);
        }
    }

    /// Fadal: reports a centre before any G2 or G3.
    pub(super) fn unarmed_arc(&mut self, block: &Block, target: Position, named: AxisMask) {
        let by_radius = !block.letters().meets(CENTER);
        let span = self.words_span(block, Letters::of("IJKR"));
        let title = self.control.table.title;
        let message = if by_radius {
            "R0 in a move, and no G2 or G3 came before".to_string()
        } else {
            "a centre is given, but no G2 or G3 came before".to_string()
        };
        let mut diagnostic = Diagnostic::new(Code::NoCenter, span, message)
            .label("which direction?")
            .help("write G2 or G3 into this block");
        diagnostic.alarm = Some(if by_radius {
            format!("{title}: I, J, OR K MUST BE SPECIFIED")
        } else {
            let n = self.sequence.map_or("?".to_string(), |number| number.to_string());
            format!("{title}: BAD CIRCLE OR MISSING G AT N={n}")
        });
        self.kernel.report(diagnostic);
        if named != AxisMask::NONE {
            self.kernel.straight_instead(&self.at(block), target, named);
        }
    }
}
