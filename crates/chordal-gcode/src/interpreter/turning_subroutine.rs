//! Turning cycles whose contour is a subroutine, and threads measured from a drive line (LinuxCNC).

use chordal_command::CompensationSide;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::Plane;
use chordal_kernel::rules::PocketHandling;
use chordal_kernel::{ContourEdge, DescentFault, DescentWords, LineThreadWords};
use chordal_syntax::{Block, Letters};

use super::Interpreter;
use super::thread_height::ThreadSizes;
use super::turning_contour::ContourBlocks;

const X: usize = 0;
const Z: usize = 2;

/// Largest number of passes of a finishing cycle.
const MAX_FINISHES: u32 = 10_000;

impl Interpreter<'_> {
    /// G70: finishes the contour of subroutine Q in P passes, from distance D to distance E.
    pub(super) fn finish_subroutine(&mut self, block: &Block, at: usize) {
        let Some(contour) = self.contour_of_subroutine(block, at) else { return };
        let start = self.start_of_subroutine(block);
        let first = self.length_of(block, b'D').unwrap_or(0.0);
        let last = self.length_of(block, b'E').unwrap_or(0.0);
        let passes = self.count_of(block, b'P').unwrap_or(1);
        if !(1..=MAX_FINISHES).contains(&passes) {
            let span = self.words_span(block, Letters::of("P"));
            let message = format!("G70 makes 1 to {MAX_FINISHES} passes, not {passes}");
            let diagnostic = Diagnostic::new(Code::BadWordValue, span, message)
                .label("not carried out")
                .help("P is the number of passes");
            return self.report_refused(diagnostic, "G7X error: P must be greater than zero.");
        }
        let step = (first - last) / f64::from(passes);
        let distances: Vec<f64> =
            (0..passes).rev().map(|pass| last + f64::from(pass) * step).collect();
        let done = self.kernel.finish_passes(&self.at(block), start, &distances, &contour);
        self.report_descent(block, at, done);
    }

    /// G71 and G72: roughs down to the contour of subroutine Q.
    pub(super) fn rough_subroutine(
        &mut self,
        block: &Block,
        at: usize,
        along_x: bool,
        pockets: PocketHandling,
    ) {
        let name = self.code_text(block, at);
        if self.kernel.state.side != CompensationSide::Off {
            let span = self.span(block.words[at].range);
            let diagnostic = Diagnostic::new(
                Code::CycleInCompensation,
                span,
                format!("{name} while compensation is on"),
            )
            .label("not carried out")
            .help("write G40 before it; D leaves an allowance, and G70 may be compensated");
            let alarm = format!("{name} cannot be used with cutter compensation enabled");
            return self.report_refused(diagnostic, &alarm);
        }
        let Some(contour) = self.contour_of_subroutine(block, at) else { return };
        let start = self.start_of_subroutine(block);
        let depth = self.length_of(block, b'I').unwrap_or_else(|| self.unit());
        let retract = self.length_of(block, b'R').unwrap_or_else(|| self.unit() / 2.0);
        let left = self.length_of(block, b'D').unwrap_or(0.0);
        for (letter, value) in [(b'I', depth), (b'R', retract)] {
            if value <= 0.0 {
                let letter_text = letter as char;
                let span = self.words_span(block, Letters(1 << (letter - b'A')));
                let message = format!("{name} needs {letter_text} above zero");
                let diagnostic = Diagnostic::new(Code::BadWordValue, span, message)
                    .label("not carried out")
                    .help("I is the depth of a pass, R how far it backs off");
                let alarm = format!("G7X error: {letter_text} must be greater than zero.");
                return self.report_refused(diagnostic, &alarm);
            }
        }
        let words = DescentWords { along_x, start, left, depth, retract, pockets };
        let done = self.kernel.rough_descent(&self.at(block), &words, &contour);
        self.report_descent(block, at, done);
    }

    /// The start of the cycle: X (a radius) and Z of its block, else of the present position, mm.
    fn start_of_subroutine(&mut self, block: &Block) -> [f64; 2] {
        let (target, _) = self.target(block);
        [target[X], target[Z]]
    }

    fn report_descent(&mut self, block: &Block, at: usize, done: Result<(), DescentFault>) {
        let Err(fault) = done else { return };
        let name = self.code_text(block, at);
        let cycle = self.span(block.range);
        match fault {
            DescentFault::Empty => {
                let message = format!("the subroutine of {name} has no moves");
                let diagnostic = Diagnostic::new(Code::MissingWord, cycle, message)
                    .label("not carried out")
                    .help("write the contour between sub and endsub");
                self.kernel.report(diagnostic);
            }
            DescentFault::TurnsBack(origin) => {
                let message = format!("the contour of {name} turns back here");
                let diagnostic = Diagnostic::new(Code::BadWordValue, origin.span, message)
                    .also(cycle, "the cycle; it is not carried out")
                    .help("write the contour so that it goes one way only along the passes");
                self.report_refused(diagnostic, "G7X error: Not monotonic");
            }
        }
    }

    /// The moves of the subroutine that Q names; `None` when it cannot be read, which is reported.
    fn contour_of_subroutine(&mut self, block: &Block, at: usize) -> Option<Vec<ContourEdge>> {
        let name = self.code_text(block, at);
        let span = self.span(block.words[at].range);
        let Some(word) = block.last(b'Q').copied() else {
            let message = format!("{name} needs Q, the number of the subroutine of its contour");
            let diagnostic = Diagnostic::new(Code::MissingWord, span, message)
                .help("write the contour between `o100 sub` and `o100 endsub`, and Q100 here");
            self.report_refused(diagnostic, "G7x.x requires a Q word");
            return None;
        };
        if self.kernel.state.plane != Plane::Zx {
            let message =
                format!("{name} turns in the plane of X and Z, and another one is active");
            let diagnostic = Diagnostic::new(Code::BadWordValue, span, message)
                .label("not carried out")
                .help("write G18 before it");
            let alarm = format!("{name} can only be used in XZ plane (G18)");
            self.report_refused(diagnostic, &alarm);
            return None;
        }
        let label = self.count(&word)?.to_string();
        let lines = self.lines_of_sub(&label);
        let Some((first, end)) = lines.filter(|(_, end)| end.offset <= block.range.start) else {
            let message = format!("there is no subroutine `{label}` above this block");
            let diagnostic = Diagnostic::new(Code::MissingSubprogram, span, message)
                .label("not carried out")
                .help(format!("write `o{label} sub` and its contour before the cycle"));
            self.report_refused(diagnostic, "EOF in file seeking o-word");
            return None;
        };
        let start = self.start_of_subroutine(block);
        let contour = ContourBlocks { first, names_both: false, end };
        let commands = self.collect_contour(&contour, block, Some(start));
        Some(chordal_kernel::ContourProfile::moves(&commands))
    }

    /// Carries out G76 P Z I J K.
    pub(super) fn line_thread(&mut self, block: &Block, at: usize) {
        let name = self.code_text(block, at);
        let span = self.span(block.words[at].range);
        let turns = matches!(
            self.kernel.state.spindle,
            chordal_command::SpindleState::Cw | chordal_command::SpindleState::Ccw
        );
        if self.kernel.state.side != CompensationSide::Off {
            let diagnostic = Diagnostic::new(
                Code::CycleInCompensation,
                span,
                format!("{name} while compensation is on"),
            )
            .label("not carried out")
            .help("write G40 before it");
            let alarm = "Cannot use G76 threading cycle with cutter radius compensation on";
            return self.report_refused(diagnostic, alarm);
        }
        if !block.letters().meets(Letters::of("XYZ")) {
            let diagnostic =
                Diagnostic::new(Code::MissingWord, span, "a thread without Z, its end")
                    .label("not carried out")
                    .help("give its end with Z");
            return self.report_refused(diagnostic, "All axes missing with motion code");
        }
        // I, J and K are diameters if X is.
        let x = self.per_word[X];
        let lead = self.length_of(block, b'P');
        let crest = self.length_of(block, b'I').map(|value| value * x);
        let first = self.length_of(block, b'J').map(|value| value * x);
        let height = self.length_of(block, b'K').map(|value| value * x);
        let Some(lead) = lead else {
            return self.refuse_line_thread(
                span,
                "a thread needs P, its lead",
                "P word missing with G76",
            );
        };
        let (Some(crest), Some(first), Some(height)) = (crest, first, height) else {
            let message = "a thread needs I, J and K: the crest, the first pass and the height";
            return self.refuse_line_thread(span, message, "I J or K words missing with G76");
        };
        if crest == 0.0 {
            let message = "I is how far the crest lies from the start: it is not 0";
            return self.refuse_line_thread(span, message, "In G76, I must not be 0");
        }
        if first <= 0.0 {
            let message = "J, the depth of the first pass, is above 0";
            return self.refuse_line_thread(span, message, "In G76, J must be greater than 0");
        }
        if height <= first {
            let message = "K, the height of the thread, is above J, the depth of the first pass";
            return self.refuse_line_thread(span, message, "In G76, K must be greater than J");
        }
        if !turns {
            let diagnostic = Diagnostic::new(
                Code::SpindleStopped,
                span,
                format!("{name} moves in step with the spindle, which does not turn"),
            )
            .help("start the spindle (S… M3) before");
            self.report_refused(diagnostic, "Chosen spindle (0) not turning in G76");
        }
        let plain = |s: &Self, letter: u8| {
            block.last(letter).and_then(|word| s.literal(word)).map(|number| number.to_f64())
        };
        let root = plain(self, b'R').unwrap_or(1.0);
        let angle_deg = plain(self, b'Q').unwrap_or(0.0);
        let spring = self.count_of(block, b'H').unwrap_or(0);
        let ends = self.count_of(block, b'L').unwrap_or(0);
        let taper = self.length_of(block, b'E').unwrap_or(0.0).max(0.0);
        let sizes = ThreadSizes { height, first, lead, root_radius: None };
        self.check_thread_height(block, *b"KJ", &sizes);
        let (target, _) = self.target(block);
        let words = LineThreadWords {
            end_z: target[Z],
            lead,
            crest,
            first,
            height,
            root,
            angle_deg,
            spring,
            taper,
            tapered: (ends & 1 != 0, ends & 2 != 0),
        };
        self.kernel.line_thread(&self.at(block), &words);
    }

    fn refuse_line_thread(&mut self, span: chordal_diagnostics::Span, message: &str, alarm: &str) {
        let diagnostic = Diagnostic::new(Code::BadWordValue, span, message)
            .label("not carried out")
            .help("`G76 P1.5 Z-20 I-1 J0.2 K0.92`: lead, end, crest from the start, first pass, height");
        self.report_refused(diagnostic, alarm);
    }

    /// D in the block of G96 limits the spindle speed (LinuxCNC); S is required there.
    pub(super) fn limit_of_surface_speed(&mut self, block: &Block, at: usize) {
        if !block.letters().has(b'S') {
            let span = self.span(block.words[at].range);
            let diagnostic =
                Diagnostic::new(Code::MissingWord, span, "G96 without S, the cutting speed")
                    .help("write S in the block of G96");
            self.report_refused(diagnostic, "S word missing with G96");
        }
        let limit = block.last(b'D').and_then(|word| self.literal(word));
        self.kernel.limit_speed(limit.map_or(f64::INFINITY, |limit| limit.to_f64().abs()));
    }
}
