//! Reads the words of turning cycles.

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_dialect::table::TurnFault;
use chordal_kernel::rules::TurnCycle;
use chordal_kernel::{PeckWords, RoughWords, ThreadWords, TurnPass};
use chordal_syntax::{Block, Letters};

use super::Interpreter;
use super::thread_height::ThreadSizes;
use super::turning_contour::ContourBlocks;

const X: usize = 0;
const Z: usize = 2;

impl Interpreter<'_> {
    /// G90, G92 and G94: a turning pass. Later blocks repeat it with the words that they name.
    pub(super) fn turn_block(
        &mut self,
        block: &Block,
        pass: TurnPass,
        target: Position,
        named: AxisMask,
        explicit: bool,
    ) {
        let taper_letters: &[u8] = if pass == TurnPass::Facing { b"RK" } else { b"RI" };
        let taper = taper_letters.iter().find_map(|letter| self.cycle_length(block, *letter));
        let lead = if pass == TurnPass::Thread { self.length_of(block, b'F') } else { None };
        let memory = &mut self.kernel.state.turning;
        if explicit {
            memory.pass_end = [target[X], target[Z]];
            memory.pass_taper = 0.0;
        }
        for (place, axis) in memory.pass_end.iter_mut().zip([X, Z]) {
            if named.has(axis) {
                *place = target[axis];
            }
        }
        memory.pass_taper = taper.unwrap_or(memory.pass_taper);
        memory.pass_lead = lead.unwrap_or(memory.pass_lead);
        let without_lead = pass == TurnPass::Thread && memory.pass_lead <= 0.0;
        if without_lead {
            let span = self.span(block.range);
            return self.report_no_lead(span);
        }
        self.kernel.turn_pass(&self.at(block), pass);
    }

    /// The lead of a thread, mm: F of its block, or the active one; `None` without one, which is reported.
    pub(super) fn lead_by_feed(&mut self, block: &Block) -> Option<f64> {
        let lead = self.length_of(block, b'F').or(self.kernel.state.feed);
        let lead = lead.filter(|lead| *lead > 0.0);
        if lead.is_none() && !self.kernel.state.unknown.feed {
            self.report_no_lead(self.span(block.range));
        }
        lead
    }

    /// Reports a thread without a lead.
    fn report_no_lead(&mut self, span: chordal_diagnostics::Span) {
        let message = "a thread without F, its lead";
        self.kernel.report(
            Diagnostic::new(Code::MissingFeed, span, message)
                .label("nothing is cut")
                .help("give the lead with F, above zero"),
        );
    }

    /// Carries out G70 to G76.
    pub(super) fn turning_cycle(&mut self, block: &Block, at: usize, cycle: TurnCycle) {
        if self.kernel.collected.is_some() {
            let name = self.code_text(block, at);
            let span = self.span(block.words[at].range);
            self.kernel.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    span,
                    format!("{name} in the contour of another cycle"),
                )
                .label("skipped")
                .help("a contour has moves only: end it with the block that Q names"),
            );
            return;
        }
        let ends = !matches!(
            cycle,
            TurnCycle::Finish | TurnCycle::Rough | TurnCycle::RoughFace | TurnCycle::Pattern
        );
        let angle =
            cycle == TurnCycle::Thread || self.control.parameters.rules.turning.contour_program;
        self.unused_axes(block, |axis, letter| {
            ends && (axis == X || axis == Z) || angle && letter == b'A'
        });
        match cycle {
            TurnCycle::Finish => self.finish_contour(block, at),
            TurnCycle::Rough | TurnCycle::RoughFace => self.rough_contour(block, at, cycle),
            TurnCycle::Pattern => self.pattern_contour(block, at),
            TurnCycle::PeckZ | TurnCycle::PeckX => self.peck_cycle(block, cycle),
            TurnCycle::Thread => self.thread_cycle(block),
            TurnCycle::FinishSubroutine => self.finish_subroutine(block, at),
            TurnCycle::RoughSubroutine(pockets) => {
                self.rough_subroutine(block, at, false, pockets);
            }
            TurnCycle::RoughFaceSubroutine(pockets) => {
                self.rough_subroutine(block, at, true, pockets);
            }
            TurnCycle::LineThread => self.line_thread(block, at),
        }
    }

    /// G70: cuts the programmed contour, and returns.
    fn finish_contour(&mut self, block: &Block, at: usize) {
        let Some(contour) = self.contour(block, at, true) else { return };
        let position = &self.kernel.state.position;
        let start = [position[X], position[Z]];
        self.kernel.contour_again = true;
        self.run_contour(&contour, block);
        self.kernel.contour_again = false;
        self.kernel.turn_back(start);
    }

    /// G71 and G72: roughing.
    fn rough_contour(&mut self, block: &Block, at: usize, cycle: TurnCycle) {
        let along_x = cycle == TurnCycle::RoughFace;
        let letters = block.letters();
        let depth_letter = if along_x { b'W' } else { b'U' };
        let two_blocks = self.control.parameters.rules.turning.two_blocks;
        if two_blocks && !letters.meets(Letters::of("PQ")) {
            if let Some(depth) = self.cycle_length(block, depth_letter) {
                self.kernel.state.turning.rough_depth = depth.abs();
            }
            if let Some(retract) = self.cycle_length(block, b'R') {
                self.kernel.state.turning.rough_retract = retract.abs();
            }
            return;
        }
        if !letters.meets(Letters::of("PQ")) {
            // Reports what is missing.
            self.contour(block, at, false);
            return;
        }
        if let Some(depth) = self.cycle_length(block, b'D') {
            self.kernel.state.turning.rough_depth = depth.abs();
        }
        let depth = self.kernel.state.turning.rough_depth;
        let name = self.code_text(block, at);
        if depth <= 0.0 {
            let span = self.span(block.words[at].range);
            let help = match two_blocks {
                true => format!("write `{name} {}… R…` before it", depth_letter as char),
                false => "give the depth of a pass with D".to_string(),
            };
            let message = format!("{name} has no depth of a pass");
            return self.refuse_cycle(span, message, &help, TurnFault::Depth);
        }
        let allowance = self.allowance(block);
        let Some((contour, mut profile)) = self.read_contour(block, at) else { return };
        if self.control.parameters.rules.turning.return_left_out {
            let position = &self.kernel.state.position;
            profile.without_return(along_x, [position[X], position[Z]]);
        }
        let words = RoughWords {
            along_x,
            allowance,
            depth,
            rough_allowance: self.rough_allowance(block, allowance),
            retract: self.kernel.state.turning.rough_retract,
            pockets: self.cuts_pockets(block, &contour),
        };
        if self.check_contour_direction(block, &profile, along_x) {
            self.kernel.rough(&self.at(block), &words, &profile);
        }
        self.continue_after(&contour);
    }

    /// I and K of a roughing cycle in one block: the allowance of a first contour pass, mm, on the side of U and W.
    fn rough_allowance(&mut self, block: &Block, allowance: [f64; 2]) -> [f64; 2] {
        let sign = |value: f64| if value < 0.0 { -1.0 } else { 1.0 };
        let mut along = |letter: u8| self.cycle_length(block, letter).unwrap_or(0.0).abs();
        [along(b'I') * sign(allowance[0]), along(b'K') * sign(allowance[1])]
    }

    /// True for type II, which cuts pockets: by the axes of the first block of the contour, or by a letter.
    fn cuts_pockets(&mut self, block: &Block, contour: &ContourBlocks) -> bool {
        let word = self.control.parameters.rules.turning.pockets_by.and_then(|by| block.last(by));
        match word.and_then(|word| self.literal(word)) {
            Some(number) => number.mantissa != 0,
            None => contour.names_both,
        }
    }

    /// G73: pattern repeating.
    fn pattern_contour(&mut self, block: &Block, at: usize) {
        let letters = block.letters();
        if !letters.meets(Letters::of("PQ")) {
            if let Some(along_x) = self.cycle_length(block, b'U') {
                self.kernel.state.turning.pattern[0] = along_x;
            }
            if let Some(along_z) = self.cycle_length(block, b'W') {
                self.kernel.state.turning.pattern[1] = along_z;
            }
            if let Some(passes) = self.passes_of_pattern(block, b'R') {
                self.kernel.state.turning.pattern_passes = passes;
            }
            return;
        }
        if letters.has(b'D') {
            // In one block: the distances by I and K, the passes by D.
            let (x, z) = (self.cycle_length(block, b'I'), self.cycle_length(block, b'K'));
            let Some(passes) = self.passes_of_pattern(block, b'D') else { return };
            let turning = &mut self.kernel.state.turning;
            turning.pattern = [x.unwrap_or(0.0), z.unwrap_or(0.0)];
            turning.pattern_passes = passes;
        }
        let allowance = self.allowance(block);
        let Some((contour, profile)) = self.read_contour(block, at) else { return };
        self.kernel.turn_pattern(&self.at(block), allowance, &profile);
        self.continue_after(&contour);
    }

    /// The number of passes of G73, with or without a decimal point; `None` when it is wrong, which is reported.
    fn passes_of_pattern(&mut self, block: &Block, letter: u8) -> Option<u32> {
        let word = *block.last(letter)?;
        let number = self.literal(&word)?;
        let passes = number.to_f64();
        if !(1.0..=9999.0).contains(&passes) {
            let span = self.span(word.range);
            let letter = letter as char;
            let message = format!("this cycle needs one pass or more, not {letter}{number}");
            let help = format!("{letter} is the number of passes");
            self.refuse_cycle(span, message, &help, TurnFault::Passes);
            return None;
        }
        Some(passes as u32)
    }

    /// G74 and G75: pecking.
    fn peck_cycle(&mut self, block: &Block, cycle: TurnCycle) {
        let letters = block.letters();
        if !letters.meets(Letters::of("XZUW")) {
            if let Some(retract) = self.cycle_length(block, b'R') {
                self.kernel.state.turning.peck_retract = retract.abs();
            }
            return;
        }
        let along_x = cycle == TurnCycle::PeckX;
        let end = self.turned_end(block);
        // P is along X and Q along Z.
        let along = |s: &mut Self, letter: u8| {
            let size = s.quiet_length(block, letter)?.abs();
            (size > 0.0).then_some(size)
        };
        // In one block I is along X and K along Z.
        let one_line = letters.meets(Letters::of("IK"));
        let (p, q) = match one_line {
            true => (along(self, b'I'), along(self, b'K')),
            false => (along(self, b'P'), along(self, b'Q')),
        };
        let (peck, step) = if along_x { (p, q) } else { (q, p) };
        let cross = if along_x { Z } else { X };
        let moves_across = end[cross / Z] != self.kernel.state.position[cross];
        if moves_across && step.is_none() {
            let span = self.span(block.range);
            let letter = match (along_x, one_line) {
                (true, true) => 'K',
                (true, false) => 'Q',
                (false, true) => 'I',
                (false, false) => 'P',
            };
            let message = format!("the plunges of this cycle need {letter}, their distance");
            return self.refuse_cycle(span, message, "give the distance", TurnFault::Step);
        }
        let aside = self.cycle_length(block, if one_line { b'D' } else { b'R' });
        let aside = aside.unwrap_or(0.0).abs();
        let step = step.filter(|_| moves_across);
        let words = PeckWords { along_x, end, peck, step, aside };
        self.kernel.peck(&self.at(block), &words);
    }

    /// G76.
    fn thread_cycle(&mut self, block: &Block) {
        let letters = block.letters();
        if !letters.meets(Letters::of("XZUW")) {
            return self.thread_setup(block);
        }
        let end = self.turned_end(block);
        let span = self.span(block.range);
        let one_line = letters.has(b'K') || letters.has(b'D');
        let height = self.quiet_length(block, if one_line { b'K' } else { b'P' });
        let first = self.quiet_length(block, if one_line { b'D' } else { b'Q' });
        let taper = self.cycle_length(block, if one_line { b'I' } else { b'R' }).unwrap_or(0.0);
        let packed = self.kernel.state.turning.thread;
        if one_line {
            // All words are in this block: those of an earlier first block do not count.
            let angle = block.last(b'A').and_then(|word| self.literal(word));
            let rules = &self.control.parameters.rules.turning;
            let thread = &mut self.kernel.state.turning.thread;
            thread.angle_deg = angle.map_or(0.0, |angle| angle.to_f64());
            thread.finish_passes = rules.thread_finish_passes;
            thread.exit_leads = rules.thread_exit_leads;
        }
        let (Some(height), Some(first)) = (height, first) else {
            let (k, d) = if one_line { ('K', 'D') } else { ('P', 'Q') };
            let message =
                format!("a thread needs {k}, its height, and {d}, the depth of the first pass");
            return self.refuse_cycle(span, message, "give both", TurnFault::ThreadDepth);
        };
        if end[1] == self.kernel.state.position[Z] {
            let message = "a thread without length: Z is missing, or is where the tool is".into();
            return self.refuse_cycle(span, message, "give its end with Z", TurnFault::ThreadDepth);
        }
        if height <= 0.0 || first <= 0.0 {
            let message =
                "the height of a thread and the depth of its first pass are above zero".into();
            return self.refuse_cycle(span, message, "give both", TurnFault::ThreadDepth);
        }
        let Some(lead) = self.lead_by_feed(block) else { return };
        if !one_line {
            if self.is_least_above_height(span, height) {
                return;
            }
            self.check_thread_point(block, b"PQ");
        }
        let letters = if one_line { *b"KD" } else { *b"PQ" };
        let root = end[0].abs();
        let root_radius = Some(root).filter(|root| *root > 0.0);
        let sizes = ThreadSizes { height, first, lead, root_radius };
        self.check_thread_height(block, letters, &sizes);
        let words = ThreadWords { end, taper, height, first, lead };
        self.kernel.thread_passes(&self.at(block), &words);
        self.kernel.state.turning.thread = packed;
    }

    /// `G76 P(passes, exit, angle) Q(least depth) R(finishing depth)`.
    fn thread_setup(&mut self, block: &Block) {
        if let Some(packed) = self.count_of(block, b'P') {
            let thread = &mut self.kernel.state.turning.thread;
            thread.finish_passes = packed / 10_000;
            thread.exit_leads = f64::from(packed / 100 % 100) / 10.0;
            thread.angle_deg = f64::from(packed % 100);
        }
        self.check_thread_point(block, b"Q");
        if let Some(least) = self.quiet_length(block, b'Q') {
            self.kernel.state.turning.thread.least = least.abs();
        }
        if let Some(finish) = self.quiet_length(block, b'R') {
            self.kernel.state.turning.thread.finish = finish.abs();
        }
    }

    /// X (a radius) and Z at the end of a cycle, mm; other letters of its block are not axes.
    fn turned_end(&mut self, block: &Block) -> [f64; 2] {
        let increments = self.control.parameters.increments;
        [X, Z].map(|axis| {
            let here = self.kernel.state.position[axis];
            if let Some(value) = self.axis_value_of(block, axis) {
                return if self.kernel.state.incremental { here + value } else { value };
            }
            let letter = increments.iter().find(|(_, of)| *of == b"XYZ"[axis]);
            let word = letter.and_then(|(letter, _)| block.last(*letter)).copied();
            word.and_then(|word| self.axis_value(&word, axis)).map_or(here, |by| here + by)
        })
    }

    /// A length that is usually written in least increments, mm: a missing point is not reported.
    pub(super) fn quiet_length(&mut self, block: &Block, letter: u8) -> Option<f64> {
        let number = self.literal(block.last(letter)?)?;
        Some(match number.has_point {
            true => self.scale.length(number),
            false => {
                let units = self.kernel.state.units;
                number.to_f64() * self.control.parameters.rules.least_increment(units)
            }
        })
    }

    /// The finishing allowance: U on the radius, and W, mm.
    fn allowance(&mut self, block: &Block) -> [f64; 2] {
        let u = self.cycle_length(block, b'U').unwrap_or(0.0) * self.per_word[X];
        [u, self.cycle_length(block, b'W').unwrap_or(0.0)]
    }

    /// Reports a cycle that the control refuses; nothing of it is shown.
    pub(super) fn refuse_cycle(
        &mut self,
        span: chordal_diagnostics::Span,
        message: String,
        help: &str,
        fault: TurnFault,
    ) {
        let diagnostic =
            Diagnostic::new(Code::BadWordValue, span, message).label("not carried out").help(help);
        self.report_turn_fault(diagnostic, fault);
    }

    /// Reports a problem of a cycle with the alarm of this control.
    pub(super) fn report_turn_fault(&mut self, diagnostic: Diagnostic, fault: TurnFault) {
        let table = self.control.table;
        match table.turning_alarms.iter().find(|(of, _)| *of == fault) {
            Some((_, alarm)) => self.report_refused(diagnostic, alarm),
            None => self.kernel.report(diagnostic.severity(Severity::Error)),
        }
    }

    /// Cuts a line in a block without a centre while an arc code is active, and reports it.
    pub(super) fn line_in_arc_mode(
        &mut self,
        block: &Block,
        target: Position,
        named: AxisMask,
        explicit: bool,
    ) {
        if explicit || !self.control.parameters.line_after_arc_is_usual {
            let span = self.span(block.range);
            let message = match explicit {
                true => "this arc has neither a centre nor a radius: it is a straight line",
                false => {
                    "an arc is active from a block before, and this block has neither centre nor radius: it is a straight line"
                }
            };
            self.kernel.report(
                Diagnostic::new(Code::NoCenter, span, message)
                    .severity(Severity::Warning)
                    .label("a straight line on this control")
                    .help("write G1 for a line; for an arc give its centre or R"),
            );
        }
        self.kernel.line(&self.at(block), target, named);
    }
}
