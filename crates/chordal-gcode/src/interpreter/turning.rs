//! The cycles of lathes: their words, and the blocks between P and Q that they take as a contour.

use chordal_command::{AxisMask, Position, Side};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_dialect::{Action, OnceCode, code_number};
use chordal_kernel::rules::TurnCycle;
use chordal_kernel::{PeckWords, Profile, RoughWords, ThreadWords, TurnPass};
use chordal_syntax::{Block, Letters, Position as TextPosition};

use super::{EndReason, Flow, Interpreter};

const X: usize = 0;
const Z: usize = 2;

/// The blocks of a contour.
struct Contour {
    first: TextPosition,
    /// Its first block names both axes, be it by W0.
    names_both: bool,
    /// After its last block.
    end: TextPosition,
}

impl Interpreter<'_> {
    /// G90, G92 and G94: a pass of a lathe. Blocks after it repeat it with the words that they name.
    pub(super) fn turn_block(
        &mut self,
        block: &Block,
        pass: TurnPass,
        target: Position,
        named: AxisMask,
        explicit: bool,
    ) {
        let taper_letters: &[u8] = if pass == TurnPass::Facing { b"RK" } else { b"RI" };
        let taper = taper_letters.iter().find_map(|letter| self.length_of(block, *letter));
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

    /// The lead of a thread: F of its block, or the one in force.
    pub(super) fn lead_by_feed(&mut self, block: &Block) -> Option<f64> {
        let lead = self.length_of(block, b'F').or(self.kernel.state.feed);
        let lead = lead.filter(|lead| *lead > 0.0);
        if lead.is_none() {
            self.report_no_lead(self.span(block.range));
        }
        lead
    }

    /// A thread needs a lead.
    fn report_no_lead(&mut self, span: chordal_diagnostics::Span) {
        let message = "a thread without F, its lead";
        self.kernel.report(
            Diagnostic::new(Code::MissingFeed, span, message)
                .label("nothing is cut")
                .help("give the lead with F, above zero"),
        );
    }

    /// G70 to G76.
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
        let ends = matches!(cycle, TurnCycle::PeckZ | TurnCycle::PeckX | TurnCycle::Thread);
        let angle = cycle == TurnCycle::Thread;
        self.unused_axes(block, |axis, letter| {
            ends && (axis == X || axis == Z) || angle && letter == b'A'
        });
        match cycle {
            TurnCycle::Finish => self.finish_contour(block, at),
            TurnCycle::Rough | TurnCycle::RoughFace => self.rough_contour(block, at, cycle),
            TurnCycle::Pattern => self.pattern_contour(block, at),
            TurnCycle::PeckZ | TurnCycle::PeckX => self.peck_cycle(block, cycle),
            TurnCycle::Thread => self.thread_cycle(block),
        }
    }

    /// G70: the contour as it is written, and back.
    fn finish_contour(&mut self, block: &Block, at: usize) {
        let Some(contour) = self.contour(block, at) else { return };
        let position = &self.kernel.state.position;
        let start = [position[X], position[Z]];
        self.kernel.contour_again = true;
        self.run_contour(&contour, block);
        self.kernel.contour_again = false;
        self.kernel.turn_back(start);
    }

    /// G71 and G72.
    fn rough_contour(&mut self, block: &Block, at: usize, cycle: TurnCycle) {
        let along_x = cycle == TurnCycle::RoughFace;
        let letters = block.letters();
        let depth_letter = if along_x { b'W' } else { b'U' };
        if !letters.meets(Letters::of("PQ")) {
            if let Some(depth) = self.length_of(block, depth_letter) {
                self.kernel.state.turning.rough_depth = depth.abs();
            }
            if let Some(retract) = self.length_of(block, b'R') {
                self.kernel.state.turning.rough_retract = retract.abs();
            }
            return;
        }
        if let Some(depth) = self.length_of(block, b'D') {
            self.kernel.state.turning.rough_depth = depth.abs();
        }
        let depth = self.kernel.state.turning.rough_depth;
        let name = self.code_text(block, at);
        if depth <= 0.0 {
            let span = self.span(block.words[at].range);
            let help = format!("write `{name} {}… R…` before it", depth_letter as char);
            let message = format!("{name} has no depth of a pass");
            return self.refuse_cycle(span, message, &help, "PS0062 ILLEGAL COMMAND IN THE BLOCK");
        }
        self.lose_rough_allowances(block);
        let allowance = self.allowance(block);
        let Some((contour, profile)) = self.read_contour(block, at) else { return };
        let words = RoughWords {
            along_x,
            allowance,
            depth,
            retract: self.kernel.state.turning.rough_retract,
            pockets: contour.names_both,
        };
        if self.contour_goes_on(block, &profile, along_x) {
            self.kernel.rough(&self.at(block), &words, &profile);
        }
        self.continue_after(&contour);
    }

    /// I and K of a roughing cycle in one block: a further pass before the last one.
    fn lose_rough_allowances(&mut self, block: &Block) {
        for letter in *b"IK" {
            if let Some(word) = block.last(letter).copied()
                && !self.is_zero(&word)
            {
                let letter = letter as char;
                self.lose_path(word.range, format!("{letter} of a roughing cycle is not followed"));
            }
        }
    }

    /// G73.
    fn pattern_contour(&mut self, block: &Block, at: usize) {
        let letters = block.letters();
        if !letters.meets(Letters::of("PQ")) {
            if let Some(along_x) = self.length_of(block, b'U') {
                self.kernel.state.turning.pattern[0] = along_x;
            }
            if let Some(along_z) = self.length_of(block, b'W') {
                self.kernel.state.turning.pattern[1] = along_z;
            }
            if let Some(passes) = self.passes_of_pattern(block) {
                self.kernel.state.turning.pattern_passes = passes;
            }
            return;
        }
        let allowance = self.allowance(block);
        let Some((contour, profile)) = self.read_contour(block, at) else { return };
        self.kernel.turn_pattern(&self.at(block), allowance, &profile);
        self.continue_after(&contour);
    }

    /// R of G73: passes, written as a whole number or with a point.
    fn passes_of_pattern(&mut self, block: &Block) -> Option<u32> {
        let word = *block.last(b'R')?;
        let number = self.literal(&word)?;
        let passes = number.to_f64();
        if !(1.0..=9999.0).contains(&passes) {
            let span = self.span(word.range);
            let message = format!("G73 needs one pass or more, not R{number}");
            self.refuse_cycle(span, message, "R is the number of passes", "PS0321");
            return None;
        }
        Some(passes as u32)
    }

    /// G74 and G75.
    fn peck_cycle(&mut self, block: &Block, cycle: TurnCycle) {
        let letters = block.letters();
        if !letters.meets(Letters::of("XZUW")) {
            if let Some(retract) = self.length_of(block, b'R') {
                self.kernel.state.turning.peck_retract = retract.abs();
            }
            return;
        }
        let along_x = cycle == TurnCycle::PeckX;
        let (target, _) = self.target(block);
        // P is along X and Q along Z.
        let along = |s: &mut Self, letter: u8| {
            let size = s.quiet_length(block, letter)?.abs();
            (size > 0.0).then_some(size)
        };
        let (p, q) = (along(self, b'P'), along(self, b'Q'));
        let (peck, step) = if along_x { (p, q) } else { (q, p) };
        let cross = if along_x { Z } else { X };
        let moves_across = target[cross] != self.kernel.state.position[cross];
        if moves_across && step.is_none() {
            let span = self.span(block.range);
            let letter = if along_x { 'Q' } else { 'P' };
            let message = format!("the plunges of this cycle need {letter}, their distance");
            return self.refuse_cycle(span, message, "give the distance", "PS0320");
        }
        let aside = self.length_of(block, b'R').unwrap_or(0.0).abs();
        let step = step.filter(|_| moves_across);
        let words = PeckWords { along_x, end: [target[X], target[Z]], peck, step, aside };
        self.kernel.peck(&self.at(block), &words);
    }

    /// G76.
    fn thread_cycle(&mut self, block: &Block) {
        let letters = block.letters();
        if !letters.meets(Letters::of("XZUW")) {
            return self.thread_setup(block);
        }
        let (target, _) = self.target(block);
        let span = self.span(block.range);
        let one_line = letters.has(b'K') || letters.has(b'D');
        let height = self.quiet_length(block, if one_line { b'K' } else { b'P' });
        let first = self.quiet_length(block, if one_line { b'D' } else { b'Q' });
        let taper = self.length_of(block, if one_line { b'I' } else { b'R' }).unwrap_or(0.0);
        if one_line && letters.has(b'A') {
            let angle = block.last(b'A').and_then(|word| self.literal(word));
            self.kernel.state.turning.thread.angle_deg = angle.map_or(0.0, |angle| angle.to_f64());
        }
        let (Some(height), Some(first)) = (height, first) else {
            let (k, d) = if one_line { ('K', 'D') } else { ('P', 'Q') };
            let message =
                format!("a thread needs {k}, its height, and {d}, the depth of the first pass");
            return self.refuse_cycle(span, message, "give both", "PS0317");
        };
        if height <= 0.0 || first <= 0.0 {
            let message =
                "the height of a thread and the depth of its first pass are above zero".into();
            return self.refuse_cycle(span, message, "give both", "PS0317");
        }
        let Some(lead) = self.lead_by_feed(block) else { return };
        let end = [target[X], target[Z]];
        let words = ThreadWords { end, taper, height, first, lead };
        self.kernel.thread_passes(&self.at(block), &words);
    }

    /// `G76 P(passes, exit, angle) Q(least depth) R(finishing depth)`.
    fn thread_setup(&mut self, block: &Block) {
        if let Some(packed) = self.count_of(block, b'P') {
            let thread = &mut self.kernel.state.turning.thread;
            thread.finish_passes = packed / 10_000;
            thread.exit_leads = f64::from(packed / 100 % 100) / 10.0;
            thread.angle_deg = f64::from(packed % 100);
        }
        if let Some(least) = self.quiet_length(block, b'Q') {
            self.kernel.state.turning.thread.least = least.abs();
        }
        if let Some(finish) = self.quiet_length(block, b'R') {
            self.kernel.state.turning.thread.finish = finish.abs();
        }
    }

    /// A length that is usually written in least increments: without a point is no slip.
    fn quiet_length(&mut self, block: &Block, letter: u8) -> Option<f64> {
        let number = self.literal(block.last(letter)?)?;
        Some(match number.has_point {
            true => self.scale.length(number),
            false => {
                let units = self.kernel.state.units;
                number.to_f64() * self.control.parameters.rules.least_increment(units)
            }
        })
    }

    /// U, a diameter, and W: what is left for finishing.
    fn allowance(&mut self, block: &Block) -> [f64; 2] {
        let u = self.length_of(block, b'U').unwrap_or(0.0) * self.per_word[X];
        [u, self.length_of(block, b'W').unwrap_or(0.0)]
    }

    /// A cycle that the control refuses: nothing of it is shown.
    fn refuse_cycle(
        &mut self,
        span: chordal_diagnostics::Span,
        message: String,
        help: &str,
        alarm: &str,
    ) {
        let diagnostic =
            Diagnostic::new(Code::BadWordValue, span, message).label("not carried out").help(help);
        self.report_refused(diagnostic, alarm);
    }

    /// The contour goes on along the passes without turning back.
    fn contour_goes_on(&mut self, block: &Block, profile: &Profile, along_x: bool) -> bool {
        let axis = usize::from(!along_x);
        let (first, last) = (profile.start[axis], profile.end()[axis]);
        let forth = if last < first { -1.0 } else { 1.0 };
        let back = profile.edges.iter().find(|edge| {
            let by = (edge.to[axis] - edge.from[axis]) * forth;
            by < -1e-6
        });
        let Some(edge) = back else { return true };
        let letter = if along_x { 'X' } else { 'Z' };
        let by = self.kernel.length_text((edge.to[axis] - edge.from[axis]).abs());
        let span = edge.origin.span;
        let cycle = self.span(block.range);
        let diagnostic = Diagnostic::new(
            Code::BadWordValue,
            span,
            format!("this contour turns back in {letter}, by {by}: a roughing cycle cannot cut it"),
        )
        .also(cycle, "the cycle; it is not carried out")
        .help(format!("write the contour so that {letter} goes one way only"));
        let alarm = if along_x { "PS0064 (X)" } else { "PS0064" };
        self.report_refused(diagnostic, alarm);
        false
    }

    /// The blocks from N P to N Q.
    fn contour(&mut self, block: &Block, at: usize) -> Option<Contour> {
        let name = self.code_text(block, at);
        let span = self.span(block.words[at].range);
        let (p, q) = (self.count_of(block, b'P'), self.count_of(block, b'Q'));
        let (Some(p), Some(q)) = (p, q) else {
            let message = format!("{name} needs P and Q, the first and last block of its contour");
            let help = "write the N numbers of these blocks with P and Q";
            let diagnostic = Diagnostic::new(Code::MissingWord, span, message).help(help);
            self.report_refused(
                diagnostic,
                "PS0061 P OR Q COMMAND IS NOT IN THE MULTIPLE REPETITIVE CYCLES BLOCK",
            );
            return None;
        };
        let below = block.range.start;
        let first = self.label_below(self.program, i64::from(p), below);
        let first = match first {
            Some(first) => first,
            None => {
                self.report_missing_label(block, b'P', &p.to_string());
                return None;
            }
        };
        let last = self.label_below(self.program, i64::from(q), first.offset.saturating_sub(1));
        let Some(last) = last.filter(|last| last.offset >= first.offset) else {
            self.report_missing_label(block, b'Q', &q.to_string());
            return None;
        };
        let mut reader = self.reader_of(self.program);
        reader.seek(last);
        let mut found = Block::new();
        reader.read(&mut found);
        let end = reader.position();
        reader.seek(first);
        reader.read(&mut found);
        let letters = found.letters();
        let names_both = letters.meets(Letters::of("XU")) && letters.meets(Letters::of("ZW"));
        Some(Contour { first, names_both, end })
    }

    /// Carries out the blocks of a contour for its moves alone: nothing else of them stays.
    fn read_contour(&mut self, block: &Block, at: usize) -> Option<(Contour, Profile)> {
        let contour = self.contour(block, at)?;
        let memory = self.kernel.memory();
        self.kernel.collected = Some(Vec::new());
        // Feed and spindle are those of the cycle's block.
        self.kernel.reported.missing_feed = true;
        self.kernel.reported.spindle_for_tool = Some(self.kernel.state.tool);
        let side = std::mem::replace(&mut self.kernel.state.side, Side::Off);
        self.run_contour(&contour, block);
        let commands = self.kernel.collected.take().unwrap_or_default();
        let repeated = self.kernel.repeated;
        self.kernel.recall(memory);
        self.kernel.repeated = repeated;
        self.kernel.state.side = side;
        self.set_units(self.kernel.state.units);
        let profile = Profile::of(&commands);
        if profile.as_ref().is_none_or(|profile| profile.edges.is_empty()) {
            let span = self.span(block.range);
            let message = "the contour of this cycle has no moves".to_string();
            self.refuse_cycle(
                span,
                message,
                "it needs a first move and a contour after it",
                "PS0065",
            );
            self.continue_after(&contour);
            return None;
        }
        Some((contour, profile?))
    }

    /// A program continues after the contour, where that stands after the cycle.
    fn continue_after(&mut self, contour: &Contour) {
        if contour.end.offset > self.reader.position().offset {
            self.reader.seek(contour.end);
        }
    }

    /// Carries out the blocks of a contour, and continues after the block of the cycle.
    fn run_contour(&mut self, contour: &Contour, cycle: &Block) {
        let here = self.reader.position();
        let origin = self.kernel.origin;
        self.reader.seek(contour.first);
        let mut block = Block::new();
        let depth = self.frames.len();
        while self.reader.position().offset < contour.end.offset && self.reader.read(&mut block) {
            if !self.kernel.count_repeated() {
                break;
            }
            if let Some(word) = self.forbidden_in_contour(&block) {
                let range = block.words[word].range;
                let name = self.code_text(&block, word);
                let span = self.span(range);
                self.kernel.report(
                    Diagnostic::new(
                        Code::CallNotAllowed,
                        span,
                        format!("{name} may not be in the contour of a cycle"),
                    )
                    .also(self.span(cycle.range), "the cycle")
                    .label("this block is skipped")
                    .help("a contour has moves, feeds and speeds only"),
                );
                continue;
            }
            if let Flow::End(EndReason::Budget) = self.execute(&mut block) {
                break;
            }
            if block.commas || self.kernel.waits_at_corner() {
                self.end_corner_block(&block);
            }
        }
        while self.frames.len() > depth {
            self.leave(None);
        }
        self.reader.seek(here);
        self.kernel.origin = origin;
    }

    /// The place of a word that a contour cannot have: calls, ends, further cycles.
    fn forbidden_in_contour(&self, block: &Block) -> Option<usize> {
        block.words.iter().position(|word| {
            let code = word.number().and_then(code_number);
            let row = code.and_then(|code| match word.letter {
                b'G' => self.control.g_code(code),
                b'M' => self.control.m_code(code),
                _ => None,
            });
            row.is_some_and(|row| {
                matches!(
                    row.action,
                    Action::Call(_)
                        | Action::Once(OnceCode::Turning(_))
                        | Action::After(chordal_dialect::AfterCode::ProgramEnd { .. })
                )
            })
        })
    }

    /// S in the block of the code that presets coordinates limits the spindle.
    pub(super) fn take_speed_limit(&mut self, block: &Block) {
        let Some(number) = block.last(b'S').and_then(|word| self.literal(word)) else { return };
        if number.to_f64() >= 0.0 {
            self.kernel.limit_speed(number.to_f64());
        }
    }

    /// `T0101`: station 1 with offset 1, which acts at once.
    pub(super) fn take_station(&mut self, block: &Block, digits: u32) {
        let Some(word) = block.last(b'T').copied() else { return };
        let Some(number) = self.count(&word) else { return };
        // Five digits and more have three for the offset (No. 5028 = 3).
        let digits = if number >= 10_000 { 3 } else { digits };
        let split = 10_u32.pow(digits);
        let (station, offset) = (number / split, number % split);
        let tool = if station > 0 { station } else { offset };
        if tool > 0 && tool != self.kernel.state.tool {
            self.kernel.state.selected_tool = Some(tool);
            let stops = self.control.table.spindle_stops_at_tool_change;
            self.kernel.tool_change(self.span(word.range), stops);
        }
        let before = self.kernel.state.radius_offset;
        self.kernel.state.radius_offset = (offset > 0).then_some(offset);
        let length =
            chordal_kernel::LengthOffset { number: (offset > 0).then_some(offset), minus: false };
        if length != self.kernel.state.offsets.length() {
            self.kernel.set_length(&self.at(block), length);
        }
        if self.kernel.state.side != Side::Off && before != self.kernel.state.radius_offset {
            let span = self.span(word.range);
            self.kernel.emit_compensation(self.kernel.state.radius_offset, None, span);
        }
    }

    /// G10 P without L: geometry and wear of a turning tool.
    pub(super) fn write_turning_tool(&mut self, block: &Block) {
        let Some(number) = self.count_of(block, b'P') else {
            let span = self.span(block.range);
            let message = "G10 needs P, the number of the offset".to_string();
            return self.kernel.missing_word(span, message, "P1 is wear 1, P10001 geometry 1");
        };
        let axes = self.control.axes();
        self.unused_axes(block, |axis, _| axes.has(axis));
        let words = self.axis_words(block);
        let mut added = [None; chordal_machine::AXES];
        for (letter, axis) in self.control.parameters.increments {
            let axis = usize::from(super::literals::AXIS_OF[usize::from(*axis)]);
            added[axis] =
                block.last(*letter).copied().and_then(|word| self.axis_value(&word, axis));
        }
        let radius = self.length_of(block, b'R');
        let tip = if block.letters().has(b'Q') { self.count_of(block, b'Q') } else { None };
        let geometry = number > 10_000;
        if number == 0 {
            return self.kernel.write_work_values("EXT", &words, false);
        }
        let tool = if geometry { number - 10_000 } else { number };
        self.kernel.state.shift_coordinates(|offsets| {
            let tool = offsets.tool_mut(tool);
            let values = if geometry { &mut tool.offset } else { &mut tool.offset_wear };
            for axis in 0..values.len() {
                if let Some(value) = words[axis] {
                    values[axis] = Some(value);
                } else if let Some(by) = added[axis] {
                    values[axis] = Some(values[axis].unwrap_or(0.0) + by);
                }
            }
            if geometry {
                tool.nose_radius_mm = radius.or(tool.nose_radius_mm);
                tool.tip = tip.or(tool.tip);
            } else if let Some(radius) = radius {
                tool.diameter_wear_mm = Some(2.0 * radius);
            }
        });
        self.kernel.emit_tool_length();
    }

    /// An arc code in force, and no centre in the block: the control cuts a line.
    pub(super) fn line_in_arc_mode(
        &mut self,
        block: &Block,
        target: Position,
        named: AxisMask,
        explicit: bool,
    ) {
        if explicit {
            let span = self.span(block.range);
            self.kernel.report(
                Diagnostic::new(Code::NoCenter, span, "this arc has neither a centre nor a radius")
                    .severity(Severity::Warning)
                    .label("a straight line on this control")
                    .help("give R, or write G1 for a line"),
            );
        }
        self.kernel.line(&self.at(block), target, named);
    }
}
