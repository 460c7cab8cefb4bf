//! Fixed routines of Fadal that clear pockets: L96 and L97 rectangles, L98 and L99 circles.
//!
//! Fadal User Manual, sections 6 and 18 (messages), and the programs of section 13.

use chordal_command::{AxisMask, CompensationSide, SpindleState};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::FixedRoutineCount;
use chordal_dialect::table::FixedRoutine;
use chordal_geometry::tolerance::COINCIDENT_MM;
use chordal_geometry::{TurnDirection, Vec2};
use chordal_kernel::shapes::{CORNER_STEP, Step, rectangle, rings};
use chordal_syntax::{Block, Word};

use crate::interpreter::Interpreter;
use chordal_kernel::MAX_RINGS;
use chordal_kernel::is_over;

/// The data of a pocket routine's call.
struct PocketCall {
    /// Its feed, mm/s.
    feed: f64,
    /// Radius of the tool, mm.
    tool: f64,
    /// Radius of the flat end of the tool: its radius minus the corner radius, mm.
    flat: f64,
}

impl Interpreter<'_> {
    /// Carries out a fixed routine; false when the control has none with this number.
    pub(in crate::interpreter) fn fixed_routine(
        &mut self,
        block: &Block,
        word: &Word,
        value: u32,
    ) -> bool {
        let (number, count) = (value / 100, value % 100);
        let routines = self.control.table.fixed_routines;
        let Some((_, routine)) = routines.iter().find(|(own, _)| *own == number) else {
            return false;
        };
        match *routine {
            FixedRoutine::Probe => self.probe_routine(block, word),
            FixedRoutine::Engrave => self.engrave_routine(block, word),
            FixedRoutine::BoltCircle => self.bolt_circle(block, word, count),
            FixedRoutine::Bore(direction) => self.bore_routine(block, word, direction, count),
            FixedRoutine::Rectangle(direction) => self.rectangle_routine(block, word, direction),
            FixedRoutine::Circle(direction) => self.circle_routine(block, word, direction),
        }
        true
    }

    fn rectangle_routine(&mut self, block: &Block, word: &Word, direction: TurnDirection) {
        let Some(call) = self.pocket_call(block, word, &[0, 1, 2, 3]) else { return };
        let (Some(x), Some(y)) = (self.register_length(block, 2), self.register_length(block, 3))
        else {
            return;
        };
        let half = Vec2::new(0.5 * x - call.tool, 0.5 * y - call.tool);
        if !self.fits(block, word, if y < x { (3, y) } else { (2, x) }, call.tool) {
            return;
        }
        let half = Vec2::new(half.a.max(0.0), half.b.max(0.0));
        let step = (CORNER_STEP * call.flat).min(self.control.parameters.rules.pocket_stepover_mm);
        match rectangle(half, step, direction, MAX_RINGS) {
            Some(steps) => self.run_pocket(word, &steps, &call),
            None => self.kernel.report_too_many_passes(self.span(word.range), "rings"),
        }
    }

    fn circle_routine(&mut self, block: &Block, word: &Word, direction: TurnDirection) {
        let Some(call) = self.pocket_call(block, word, &[0, 1, 2]) else { return };
        let Some(diameter) = self.register_length(block, 2) else { return };
        if !self.fits(block, word, (2, diameter), call.tool) {
            return;
        }
        let last = (0.5 * diameter - call.tool).max(0.0);
        let step = (2.0 * call.flat).min(self.control.parameters.rules.pocket_stepover_mm);
        let count = (last / step - COINCIDENT_MM).ceil().max(0.0);
        if count > f64::from(MAX_RINGS) {
            return self.kernel.report_too_many_passes(self.span(word.range), "rings");
        }
        let radii: Vec<f64> =
            (1..=count as u32).map(|ring| last * (f64::from(ring) / count)).collect();
        self.run_pocket(word, &rings(&radii, 1, direction), &call);
    }

    /// Runs the path as often as the count of the call, and reports what is assumed.
    fn run_pocket(&mut self, word: &Word, steps: &[Step], call: &PocketCall) {
        let count = self.literal(word).and_then(|n| n.to_integer()).unwrap_or(1).rem_euclid(100);
        if count == 0 {
            return self.report_no_passes(word);
        }
        let text = self.kernel.length_text(call.tool * 2.0);
        let name = format!("L{}", self.routine_number(word));
        let choice = "rings from the middle to the walls, evenly spaced, are shown";
        let label = format!("with a tool of {text}");
        self.kernel.note_assumed_path(self.span(word.range), &name, choice, label);
        let repeats = match self.control.parameters.fixed_routine_count {
            FixedRoutineCount::Repeat => count,
            FixedRoutineCount::Once => 1,
        };
        let center = Vec2::new(self.kernel.state.position[0], self.kernel.state.position[1]);
        let placed: Vec<Step> = steps.iter().map(|step| step.shifted(center)).collect();
        let feed = self.kernel.routine_feed(call.feed);
        for _ in 0..repeats {
            if repeats > 1 && !self.kernel.count_repeated() {
                return;
            }
            self.kernel.follow(&placed, feed, AxisMask::NONE);
        }
    }

    /// The number of the routine that an L word calls: 96 for L9601.
    pub(super) fn routine_number(&self, word: &Word) -> i64 {
        self.literal(word).and_then(|n| n.to_integer()).unwrap_or(0) / 100
    }

    /// Reports a call without a pass (L9600).
    pub(super) fn report_no_passes(&mut self, word: &Word) {
        let number = self.routine_number(word);
        self.kernel.report(
            Diagnostic::new(
                Code::BadWordValue,
                self.span(word.range),
                format!("L{number}00 asks for no pass at all"),
            )
            .help(format!("write L{number}01 for one")),
        );
    }

    /// Checks what all pocket routines need. `None` when the control would not run the routine.
    fn pocket_call(&mut self, block: &Block, word: &Word, registers: &[u8]) -> Option<PocketCall> {
        let feed = self.routine_start(block, word, registers)?;
        let tool = self.routine_tool(word)?;
        let corner = self.register_length(block, 1)?;
        let flat = tool - corner;
        if flat <= COINCIDENT_MM || corner < 0.0 {
            let (corner, tool) = (self.kernel.length_text(corner), self.kernel.length_text(tool));
            let span = self.register_span(block, 1);
            self.kernel.report(
                Diagnostic::new(
                    Code::ImproperFixedRoutine,
                    span,
                    format!(
                        "a corner radius of {corner} leaves no flat end on a tool with radius {tool}"
                    ),
                )
                .label("R1 is the corner radius of the tool, not its radius")
                .help("give 0 for a square end mill, or the radius of its rounded corners"),
            );
            return None;
        }
        Some(PocketCall { feed, tool, flat })
    }

    /// Checks the words of a routine and that no cycle or compensation is active, then makes the block's own move.
    /// Returns the feed R0, mm/s; `None` when the control would not run the routine.
    pub(super) fn routine_start(
        &mut self,
        block: &Block,
        word: &Word,
        registers: &[u8],
    ) -> Option<f64> {
        let missing: Vec<String> = registers
            .iter()
            .filter(|register| self.register_word(block, **register).is_none())
            .map(|register| format!("R{register}"))
            .collect();
        if !missing.is_empty() {
            let number = self.routine_number(word);
            let all: Vec<String> =
                registers.iter().map(|register| format!("R{register}")).collect();
            self.improper(
                word,
                format!("L{number} without {}", missing.join(", ")),
                &format!("it takes {} in its own block", all.join(", ")),
            );
            return None;
        }
        if !self.routine_allowed(word) {
            return None;
        }
        let (target, named) = self.target(block);
        if named != AxisMask::NONE {
            self.kernel.straight(&self.at(block), target, named);
        }
        self.register_feed(block)
    }

    /// True when neither a cycle nor compensation is active.
    pub(super) fn routine_allowed(&mut self, word: &Word) -> bool {
        if self.kernel.state.cycle.is_some() {
            let message = "a fixed routine while a drilling cycle is active".to_string();
            self.improper(word, message, "cancel the cycle with G80 in a block before it");
            return false;
        }
        if self.kernel.state.side != CompensationSide::Off {
            let message = "a fixed routine while cutter compensation is on".to_string();
            self.improper(
                word,
                message,
                "cancel compensation with G40 before it; the routine offsets itself",
            );
            return false;
        }
        true
    }

    /// The radius of the tool by the active offset, mm; `None` when it is not known, which is reported.
    pub(super) fn routine_tool(&mut self, word: &Word) -> Option<f64> {
        let Some(number) = self.active_radius_offset().filter(|number| *number > 0) else {
            let message = "no tool offset is active, so the routine has no diameter".to_string();
            self.improper(word, message, "call the offset with H or D before it");
            return None;
        };
        match self.kernel.state.offsets.radius_mm(number) {
            Some(radius) if radius > 0.0 => Some(radius),
            Some(_) => {
                let message = format!("the diameter of tool {number} is zero in the table");
                self.improper(word, message, "enter the diameter of the tool");
                None
            }
            None => {
                self.report_diameter_unknown(self.span(word.range), number);
                None
            }
        }
    }

    /// Reports a missing diameter in the machine file, without which no path can be shown.
    pub(super) fn report_diameter_unknown(&mut self, span: chordal_diagnostics::Span, number: u32) {
        self.kernel.report(
            Diagnostic::new(
                Code::PocketWithoutDiameter,
                span,
                format!("the machine file gives no diameter for tool {number}"),
            )
            .label("its motion is missing from the path")
            .help(format!("set it with --set tools.{number}.diameter=\"…\"")),
        );
    }

    /// Reports that a rule of the fixed routines is violated.
    pub(super) fn improper(&mut self, word: &Word, message: String, help: &str) {
        self.kernel.report(
            Diagnostic::new(Code::ImproperFixedRoutine, self.span(word.range), message)
                .label("not carried out")
                .help(help),
        );
    }

    /// True when the tool fits into the pocket; otherwise it is reported.
    pub(super) fn fits(
        &mut self,
        block: &Block,
        word: &Word,
        (register, size): (u8, f64),
        tool: f64,
    ) -> bool {
        if size >= 2.0 * tool - COINCIDENT_MM {
            return true;
        }
        let span = self.register_span(block, register);
        let number = self.routine_number(word);
        let (size, tool) = (self.kernel.length_text(size), self.kernel.length_text(2.0 * tool));
        self.kernel.report(
            Diagnostic::new(
                Code::PocketTooSmall,
                span,
                format!("a tool with diameter {tool} does not fit into a pocket of {size}"),
            )
            .label(format!("L{number} is not carried out"))
            .help("use a smaller tool, or check the size and the diameter in the table"),
        );
        false
    }

    pub(super) fn register_word(&self, block: &Block, register: u8) -> Option<Word> {
        let mut words = block.all(b'R');
        words.find(|word| word.register == Some(register)).copied()
    }

    pub(super) fn register_span(&self, block: &Block, register: u8) -> chordal_diagnostics::Span {
        let range = self.register_word(block, register).map_or(block.range, |word| word.range);
        self.span(range)
    }

    /// A register word of the block as a length, mm.
    pub(super) fn register_length(&mut self, block: &Block, register: u8) -> Option<f64> {
        let word = self.register_word(block, register)?;
        self.length(&word)
    }

    /// R0 as a feed, mm/s; `None` when it is not positive.
    fn register_feed(&mut self, block: &Block) -> Option<f64> {
        let word = self.register_word(block, 0)?;
        let feed = self.scale.length(self.literal(&word)?) / 60.0;
        if feed <= 0.0 {
            self.improper(&word, "a fixed routine at feed zero".into(), "give the feed with R0+");
            return None;
        }
        if let Some(max) = self.machine.feed.max_mm_per_s
            && is_over(feed, Some(max))
        {
            self.kernel.report_feed_over(self.span(word.range), feed, max, false);
        }
        if self.kernel.state.spindle == SpindleState::Off {
            self.kernel.report_spindle_stopped(&self.at(block));
        }
        Some(feed)
    }
}
