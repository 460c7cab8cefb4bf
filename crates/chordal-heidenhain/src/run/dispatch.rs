//! Carries out the statement of a block.

use chordal_command::CommandKind;
use chordal_kernel::EndReason;

use super::interpreter::KlartextInterpreter;
use super::run_state::KlartextFlow;
use crate::syntax::{
    CycleCallForm, KlartextBlock, KlartextStatement, MachineFunction, PathWords, UnfollowedFunction,
};

impl KlartextInterpreter<'_> {
    /// Carries out a statement.
    pub(super) fn statement(&mut self, block: &KlartextBlock) -> KlartextFlow {
        match &block.statement {
            KlartextStatement::Nothing
            | KlartextStatement::Unknown
            // What it selects was taken when the contour was solved.
            | KlartextStatement::FreeSelection(_)
            | KlartextStatement::Begin { .. } => KlartextFlow::Next,
            KlartextStatement::End { .. } => self.program_ends(),
            KlartextStatement::Blank { corner, words } => {
                self.blank(*corner, words);
                KlartextFlow::Next
            }
            KlartextStatement::Path(function, words) => self.path_block(*function, words),
            KlartextStatement::FreePole(words) => {
                self.set_free_pole(words);
                self.functions_alone(words)
            }
            KlartextStatement::FreeElement(words) => self.free_element(words),
            KlartextStatement::Center(words) => {
                self.set_center(words);
                self.functions_alone(words)
            }
            KlartextStatement::Rounding(words) => {
                self.check_corner_block("RND", words.radius);
                KlartextFlow::Next
            }
            KlartextStatement::Chamfer(size, _) => {
                self.check_corner_block("CHF", *size);
                KlartextFlow::Next
            }
            KlartextStatement::Approach(form, words) => self.approach(*form, words),
            KlartextStatement::Departure(form, words) => self.departure(*form, words),
            KlartextStatement::Functions(words) => self.functions_alone(words),
            KlartextStatement::Stop(words) => {
                let flow = self.functions_alone(words);
                self.kernel.emit(CommandKind::Stop { optional: false });
                flow
            }
            KlartextStatement::ToolCall(words) => {
                self.tool_call(words);
                let words =
                    PathWords { functions: words.functions.clone(), ..PathWords::default() };
                self.functions_alone(&words)
            }
            KlartextStatement::ToolDefinition { number, length, radius } => {
                self.define_tool(*number, *length, *radius);
                KlartextFlow::Next
            }
            KlartextStatement::Label(name) => self.label(name),
            KlartextStatement::CallLabel { label, repeats } => self.call_label(label, *repeats),
            KlartextStatement::CallProgram(name) => self.call_program(*name),
            KlartextStatement::Jump { condition, label } => self.jump(condition, label),
            KlartextStatement::Assign { target, formula } => {
                self.assign(*target, formula);
                KlartextFlow::Next
            }
            KlartextStatement::AssignText { target, parts } => {
                self.assign_text(*target, parts.as_ref());
                KlartextFlow::Next
            }
            KlartextStatement::RaiseError(number) => self.raise_error(*number),
            KlartextStatement::SystemRead { target, numbers } => {
                self.system_read(*target, *numbers);
                KlartextFlow::Next
            }
            KlartextStatement::OtherFunction { number, target } => {
                self.other_function(*number, *target);
                KlartextFlow::Next
            }
            KlartextStatement::CycleParameters { number, values } => {
                self.define_cycle(*number, values)
            }
            KlartextStatement::CycleLine { number, line, words, rest } => {
                self.cycle_line(*number, *line, words, *rest);
                KlartextFlow::Next
            }
            KlartextStatement::CycleCall(form, words) => match form {
                CycleCallForm::Here => self.cycle_call_block(words),
                CycleCallForm::AtPosition => self.cycle_at_position(words),
                CycleCallForm::AtPattern => self.cycle_at_pattern(words),
            },
            KlartextStatement::Pattern(groups) => {
                self.modes.pattern.clone_from(groups);
                KlartextFlow::Next
            }
            KlartextStatement::DatumShift(words) => {
                self.datum_shift(words);
                KlartextFlow::Next
            }
            KlartextStatement::DatumReset => {
                self.reset_datum();
                KlartextFlow::Next
            }
            KlartextStatement::DatumOfTable { line, table } => {
                self.datum_of_table(*line, *table);
                KlartextFlow::Next
            }
            KlartextStatement::SelectDatumTable(name) => {
                self.select_datum_table(*name);
                KlartextFlow::Next
            }
            KlartextStatement::Plane(words) => {
                self.plane(words);
                KlartextFlow::Next
            }
            KlartextStatement::ToolCenterPoint(is_on) => {
                self.tool_center_point(*is_on, self.here, "FUNCTION TCPM");
                KlartextFlow::Next
            }
            KlartextStatement::Iso(words) => self.iso_block(words),
            KlartextStatement::NotFollowed(what) => {
                self.unfollowed(*what);
                KlartextFlow::Next
            }
        }
    }

    /// Functions of the language that are read and not carried out.
    fn unfollowed(&mut self, what: UnfollowedFunction) {
        let range = self.here;
        let (subject, message) = match what {
            UnfollowedFunction::Function => {
                ("FUNCTION", "this FUNCTION is not followed: what it switches is missing here")
            }
            UnfollowedFunction::Probe => {
                ("TCH PROBE", "probing cycles are not followed: what they measure is not known")
            }
            UnfollowedFunction::Selection => ("SEL", "this selection is not followed here"),
        };
        self.not_followed_once(subject, range, message);
        if what == UnfollowedFunction::Probe {
            // What is measured is not known; the run is not verified from here on.
            (115..=119).chain(150..=160).for_each(|number| self.parameters.set_shared(number, 0.0));
        }
    }

    /// A block that has M functions and does not move.
    pub(super) fn functions_alone(&mut self, words: &PathWords) -> KlartextFlow {
        self.functions_at_start(words);
        self.apply_feed(words.feed);
        self.functions_at_end(&words.functions)
    }

    /// The M functions that act at the end of a block, and a cycle that M99 calls.
    pub(super) fn functions_at_end(&mut self, functions: &[MachineFunction]) -> KlartextFlow {
        let mut calls = false;
        let mut flow = KlartextFlow::Next;
        for function in functions {
            match function.number {
                0 | 1 => self.kernel.emit(CommandKind::Stop { optional: function.number == 1 }),
                5 => self.kernel.set_spindle(chordal_command::SpindleState::Off),
                9 => self.kernel.set_coolant(|coolant| *coolant = Default::default()),
                2 | 30 => flow = KlartextFlow::End(EndReason::ProgramEnd),
                99 => calls = true,
                129 => self.tool_center_point(false, function.range, "M129"),
                _ => {}
            }
        }
        if calls {
            let called = self.call_cycle();
            if matches!(called, KlartextFlow::End(_)) {
                return called;
            }
        }
        flow
    }
}
