//! Unknown values: how a run records them, and what a block with such values does.
//!
//! A variable that the program reads before it sets it contains a value from an earlier program. It is unknown, and
//! so is every value computed from it (`macros/value.rs`). This module draws the consequences: feeds with unknown
//! time, axes with unknown position, assumed branches.

use std::collections::{BTreeMap, BTreeSet};

use chordal_command::AxisMask;
use chordal_diagnostics::{Code, Diagnostic, FileId, Span, TextRange, TextShift};
use chordal_dialect::macros::{SystemVariable, VariableRetention};
use chordal_dialect::{Action, CallCode, OnceCode, code_number};
use chordal_kernel::ModalMotion;
use chordal_machine::AXIS_LETTERS;
use chordal_syntax::{Block, Letters, Word};

use super::super::Interpreter;
use super::ConditionOf;
use crate::macros::value::{MacroValue, UnknownCause};

/// Largest number of unknown variables that are recorded.
const MAX_NOTED: usize = 1000;

/// How often an IF is assumed to be fulfilled; a limit, so that a backward jump ends.
const MAX_FULFILLED: u32 = 100;

/// Largest number of variables in a message.
const MAX_NAMED: usize = 20;

/// Words that stay when the motion of a block is dropped: they do not change the position.
const KEPT_WORDS: Letters = Letters::of("GMNFSTDH");

/// The unknown values that a run has used.
#[derive(Clone, Default, Debug, PartialEq)]
pub(in super::super) struct UnknownValues {
    /// Variables that were read.
    read: BTreeSet<UnknownCause>,
    /// The first read of an unknown variable of programs; `None` before one.
    first: Option<Span>,
    /// The first read of an unknown system variable; `None` before one.
    first_of_system: Option<Span>,
    /// It was reported that the path is not known.
    path_lost: bool,
    /// It was reported that the time of some moves is not known.
    time_lost: bool,
    /// A branch was assumed.
    branch_assumed: bool,
    /// How often each condition that this run assumes to be fulfilled was evaluated.
    assumed: BTreeMap<(FileId, u32), u32>,
    /// The names of [`UnknownCause::Name`].
    names: Vec<String>,
    /// The causes why R0 to R9 are unknown after an assignment; `None` otherwise.
    registers: [Option<UnknownCause>; 10],
}

impl UnknownValues {
    /// True when a condition with an unknown value was assumed.
    pub fn branch_assumed(&self) -> bool {
        self.branch_assumed
    }

    /// Records that a register got an unknown value.
    pub fn lose_register(&mut self, index: usize, cause: UnknownCause) {
        self.registers[index] = Some(cause);
    }

    /// Moves its spans to a text that was changed elsewhere; `None` when one of them was deleted.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        for span in [&mut self.first, &mut self.first_of_system].into_iter().flatten() {
            if span.file == FileId(0) {
                span.range = shift.range(span.range)?;
            }
        }
        Some(())
    }
}

/// The role of a word with an unknown value.
#[derive(Clone, Copy, PartialEq, Debug)]
enum WordRole {
    Feed,
    Speed,
    Tool,
    RadiusOffset,
    LengthOffset,
    /// How long a dwell takes.
    Wait,
    /// The program or the block that is called.
    Callee,
    /// How often it is called.
    Repeats,
    /// A block number, which nothing needs.
    Label,
    /// The place of an axis.
    Place(usize),
    /// A centre, a radius, a level, a code: the shape of the motion.
    Shape,
}

impl Interpreter<'_> {
    /// Records the read of an unknown variable.
    pub(super) fn note_unknown(&mut self, value: MacroValue, range: TextRange) {
        let MacroValue::Unknown(cause) = value else { return };
        // Date and time have a message of their own.
        if let UnknownCause::Variable(number) = cause
            && let Some((SystemVariable::Date | SystemVariable::Time, _)) =
                self.rules().system_at(number)
        {
            return;
        }
        let span = self.span(range);
        let is_own = self.is_own(cause);
        let unknown = &mut self.macros.unknown;
        if unknown.read.len() < MAX_NOTED {
            unknown.read.insert(cause);
        }
        let first = if is_own { &mut unknown.first } else { &mut unknown.first_of_system };
        first.get_or_insert(span);
    }

    /// True for a variable of programs, false for a system variable.
    fn is_own(&self, cause: UnknownCause) -> bool {
        match cause {
            UnknownCause::Variable(number) => self.rules().common_range(number).is_some(),
            UnknownCause::Letters(letters, _) => matches!(self.letters_name(letters), "V" | "R"),
            UnknownCause::Name(_) => false,
        }
    }

    /// The cause for a named variable of the control.
    pub(super) fn cause_of_name(&mut self, name: &str) -> UnknownCause {
        let names = &mut self.macros.unknown.names;
        let at = names.iter().position(|known| known == name).unwrap_or_else(|| {
            if names.len() < MAX_NOTED {
                names.push(name.to_string());
            }
            names.len() - 1
        });
        UnknownCause::Name(at as u32)
    }

    fn name_of(&self, cause: UnknownCause) -> String {
        match cause {
            UnknownCause::Variable(number) => format!("#{number}"),
            UnknownCause::Letters(letters, number) => {
                format!("{}{number}", self.letters_name(letters))
            }
            UnknownCause::Name(at) => format!("#<{}>", self.macros.unknown.names[at as usize]),
        }
    }

    /// Reports once that the path is not known from here on, because `what` has an unknown value.
    pub(super) fn lose_path_by(&mut self, range: TextRange, what: &str, cause: UnknownCause) {
        if self.macros.unknown.path_lost {
            return;
        }
        let name = self.name_of(cause);
        let message = format!("{what} is computed from {name}, which is not known");
        let help = self.give_it(cause, &name);
        self.lose_path_once(self.span(range), message, help);
    }

    /// Reports once a run that the path is not known from here on.
    pub(in super::super) fn lose_path_once(&mut self, span: Span, message: String, help: String) {
        if std::mem::replace(&mut self.macros.unknown.path_lost, true) {
            return;
        }
        self.kernel.report(
            Diagnostic::new(Code::UnknownPath, span, message)
                .label("from here on the path is not known")
                .help(help),
        );
    }

    /// Reports once that the time of following moves is not known.
    fn lose_time_by(&mut self, range: TextRange, letter: u8, cause: UnknownCause) {
        if std::mem::replace(&mut self.macros.unknown.time_lost, true) {
            return;
        }
        let (name, letter) = (self.name_of(cause), char::from(letter));
        self.kernel.report(
            Diagnostic::new(
                Code::UnknownTime,
                self.span(range),
                format!("`{letter}` is computed from {name}, which is not known"),
            )
            .label("the time of what it feeds or waits is not counted")
            .help(self.give_it(cause, &name)),
        );
    }

    /// Assumes a condition that depends on an unknown value: not fulfilled, unless the run options name it as fulfilled.
    pub(super) fn assume(
        &mut self,
        range: TextRange,
        cause: UnknownCause,
        of: ConditionOf,
    ) -> bool {
        self.macros.unknown.branch_assumed = true;
        let is_fulfilled = self.takes_as_fulfilled(range, of);
        let name = self.name_of(cause);
        let side = if is_fulfilled { "fulfilled" } else { "not fulfilled" };
        self.report_once(
            Diagnostic::new(
                Code::AssumedBranch,
                self.span(range),
                format!("this depends on {name}, which is not known: it is taken as {side}"),
            )
            .label("from here on the path is assumed")
            .help(self.give_it(cause, &name)),
        );
        is_fulfilled
    }

    fn takes_as_fulfilled(&mut self, range: TextRange, of: ConditionOf) -> bool {
        let place = (self.file, range.start);
        if !self.options.fulfilled.contains(&place) {
            return false;
        }
        let times = self.macros.unknown.assumed.entry(place).or_insert(0);
        *times += 1;
        match of {
            // Each loop makes one pass.
            ConditionOf::Loop => *times % 2 == 1,
            // A backward jump must end.
            ConditionOf::Branch => *times <= MAX_FULFILLED,
        }
    }

    /// Reports the unknown variables that the run has read.
    pub(in super::super) fn report_unknown_variables(&mut self) {
        let unknown = &self.macros.unknown;
        let (own, others): (Vec<UnknownCause>, Vec<UnknownCause>) =
            unknown.read.iter().copied().partition(|cause| self.is_own(*cause));
        let (first, first_of_system) = (unknown.first, unknown.first_of_system);
        if let (Some(span), Some(&cause)) = (first, own.first()) {
            let one = own.len() == 1;
            let (names, it) = (self.names_of(&own), if one { "it" } else { "them" });
            let what = if one { "its value is" } else { "their values are" };
            let message =
                format!("{names}: read before the program sets {it}, so {what} not known");
            let mut diagnostic = Diagnostic::new(Code::UnknownVariable, span, message)
                .label("the first one")
                .help(self.give(cause, &self.name_of(cause)));
            let retained = |retention: VariableRetention| -> Vec<UnknownCause> {
                let is_retained = |cause: &UnknownCause| match *cause {
                    UnknownCause::Variable(number) => self
                        .rules()
                        .common_range(number)
                        .is_some_and(|range| range.retention == retention),
                    UnknownCause::Letters(..) | UnknownCause::Name(_) => false,
                };
                own.iter().copied().filter(is_retained).collect()
            };
            let keep = |some: &[UnknownCause]| {
                if some.len() == 1 { "keeps its value" } else { "keep their values" }
            };
            let over = retained(VariableRetention::OverPowerOff);
            let until = retained(VariableRetention::UntilPowerOff);
            for (some, how) in [(over, "over power-off"), (until, "until power-off")] {
                if !some.is_empty() {
                    let text = format!("{} {} {how}", self.names_of(&some), keep(&some));
                    diagnostic = diagnostic.note(text);
                }
            }
            self.kernel.report(diagnostic);
        }
        if let (Some(span), Some(&cause)) = (first_of_system, others.first()) {
            let names = self.names_of(&others);
            let show = if others.len() == 1 { "shows a state" } else { "show states" };
            let message =
                format!("{names} {show} of the machine, and Chordal cannot know the value");
            let diagnostic = Diagnostic::new(Code::SystemVariable, span, message)
                .label("the first one")
                .help(self.give(cause, &self.name_of(cause)));
            self.kernel.report(diagnostic);
        }
    }

    /// The help for giving a value, in short.
    fn give_it(&self, cause: UnknownCause, name: &str) -> String {
        match cause {
            UnknownCause::Letters(letters, number) => self.give_letters(letters, number, name),
            UnknownCause::Variable(number) => match self.place_of(number) {
                Some(place) => place,
                None => format!("give the value with `--set '{name}=1.5'`"),
            },
            UnknownCause::Name(_) => format!("give the value with `--set '{name}=1.5'`"),
        }
    }

    /// The help with all ways of giving a value.
    fn give(&self, cause: UnknownCause, name: &str) -> String {
        let UnknownCause::Variable(number) = cause else { return self.give_it(cause, name) };
        if let Some(place) = self.place_of(number) {
            return place;
        }
        format!(
            "give the value with `--set '{name}=1.5'`, in the machine file (`[macros.variables]`, `{number} = 1.5`), \
             or put the control's file of variables (MACRO.TXT, COMMON.VAR) next to the program"
        )
    }

    fn give_letters(&self, letters: u8, number: u32, name: &str) -> String {
        match self.letters_name(letters) {
            "FX" | "FY" | "FZ" | "FA" | "FB" => {
                format!("give the offset in the machine file: `[work_offsets.E{number}]`")
            }
            "H" | "D" => format!("give the tool in the machine file: `[tools.{number}]`"),
            _ => format!("set {name} at the start of the program"),
        }
    }

    /// The help for a system variable whose value follows from other data; `None` for other variables.
    fn place_of(&self, number: u32) -> Option<String> {
        let (what, _) = self.system_at(number)?;
        Some(match what {
            SystemVariable::BlockEnd
            | SystemVariable::MachinePosition
            | SystemVariable::WorkPosition => {
                "name the axis in G90 before this, and give the work offset in the machine file"
                    .into()
            }
            SystemVariable::SkipPosition
            | SystemVariable::ProbePosition
            | SystemVariable::ProbeResult => {
                "read it after a probe move, or give the value in the machine file".into()
            }
            SystemVariable::ActiveToolOffset
            | SystemVariable::LengthGeometry
            | SystemVariable::LengthWear
            | SystemVariable::RadiusGeometry
            | SystemVariable::RadiusWear
            | SystemVariable::SpindleTool
            | SystemVariable::ToolDiameter => {
                "give the tool in the machine file: `[tools.1]`".into()
            }
            SystemVariable::ExternalOffset
            | SystemVariable::WorkOffsets
            | SystemVariable::ExtendedOffsets
            | SystemVariable::WorkOffsetsOfAxis(_)
            | SystemVariable::WorkTable => {
                "give the work offset in the machine file: `[work_offsets.G54]`".into()
            }
            _ => return None,
        })
    }

    fn names_of(&self, causes: &[UnknownCause]) -> String {
        let mut names: Vec<String> =
            causes.iter().take(MAX_NAMED).map(|cause| self.name_of(*cause)).collect();
        match causes.len().saturating_sub(MAX_NAMED) {
            0 => {}
            more => names.push(format!("{more} more")),
        }
        match names.as_slice() {
            [] => String::new(),
            [one] => one.clone(),
            [most @ .., last] => format!("{} and {last}", most.join(", ")),
        }
    }

    /// The cause for a word that names an unset register; `None` if it is set, also by a word before it.
    pub(super) fn unset_register(&self, word: &Word, before: &[Word]) -> Option<UnknownCause> {
        let chordal_syntax::WordValue::Register { index, .. } = word.value else { return None };
        let is_set = self.registers[index as usize].is_some()
            || before.iter().any(|word| word.register == Some(index));
        if is_set {
            return None;
        }
        let names = self.control.table.lexicon.grammar.letter_variables;
        let letters = names.iter().position(|name| *name == "R")?;
        Some(self.cause_of_register(letters as u8, u32::from(index)))
    }

    /// The cause why a register is unknown: an unknown value was assigned, or none.
    pub(super) fn cause_of_register(&self, letters: u8, index: u32) -> UnknownCause {
        let written = self.macros.unknown.registers.get(index as usize).copied().flatten();
        written.unwrap_or(UnknownCause::Letters(letters, index))
    }

    /// Applies the words with unknown values, which are already removed from the block, and removes from it what cannot
    /// be carried out without them.
    pub(super) fn take_unknown_words(
        &mut self,
        block: &mut Block,
        unknown: &[(Word, UnknownCause)],
    ) {
        let actions: Vec<Action> =
            block.words.iter().filter_map(|word| self.action_of(word)).collect();
        let mut drops = DroppedWords::default();
        let mut astray = AxisMask::NONE;
        for (word, cause) in unknown {
            let letter = char::from(word.letter);
            match self.part_of(word, &actions) {
                WordRole::Feed => {
                    self.kernel.set_unknown_feed();
                    self.lose_time_by(word.range, word.letter, *cause);
                }
                WordRole::Speed => {
                    self.kernel.set_unknown_speed();
                    self.lose_time_by(word.range, word.letter, *cause);
                }
                WordRole::Tool => {
                    self.kernel.select_unknown_tool();
                    self.lose_path_by(word.range, "`T`", *cause);
                }
                WordRole::RadiusOffset => {
                    self.kernel.state.radius_offset = None;
                    self.kernel.state.unknown.radius_offset = true;
                    self.lose_path_by(word.range, "`D`", *cause);
                }
                WordRole::LengthOffset => {
                    drops.length = true;
                    self.lose_path_by(word.range, "`H`", *cause);
                }
                WordRole::Label => {}
                WordRole::Wait => {
                    drops.once = true;
                    self.lose_time_by(word.range, word.letter, *cause);
                }
                WordRole::Callee => {
                    drops.call = true;
                    self.lose_path_by(word.range, &format!("`{letter}`"), *cause);
                }
                WordRole::Repeats => self.lose_path_by(word.range, &format!("`{letter}`"), *cause),
                WordRole::Place(axis) => {
                    astray.insert(axis);
                    drops.motion |= !self.goes_straight(block, &actions);
                    self.lose_path_by(word.range, &format!("`{letter}`"), *cause);
                }
                WordRole::Shape => {
                    drops.motion = true;
                    self.lose_path_by(word.range, &format!("`{letter}`"), *cause);
                }
            }
        }
        if drops.motion {
            astray = astray.or(self.axes_of_shape(block, &actions));
            if actions.iter().any(|action| action.cycle().is_some()) {
                self.kernel.end_cycle_if(true);
            }
        }
        self.kernel.go_astray(astray);
        self.drop_words(block, drops);
    }

    fn action_of(&self, word: &Word) -> Option<Action> {
        let code = code_number(word.number()?)?;
        match word.letter {
            b'G' => self.control.g_code(code).map(|row| row.action),
            b'M' => self.control.m_code(code).map(|row| row.action),
            _ => None,
        }
    }

    fn part_of(&self, word: &Word, actions: &[Action]) -> WordRole {
        let has = |test: fn(&Action) -> bool| actions.iter().any(test);
        let calls = has(|action| matches!(action, Action::Call(_)));
        let waits = has(|action| *action == Action::Once(OnceCode::Dwell));
        let alone = has(|action| action.cycle().is_some() || matches!(action, Action::Once(_)));
        let axis = AXIS_LETTERS.find(char::from(word.letter)).or_else(|| self.increment_axis(word));
        match word.letter {
            _ if word.comma => WordRole::Shape,
            b'N' | b'O' => WordRole::Label,
            b'P' | b'Q' if calls => WordRole::Callee,
            b'L' if calls => WordRole::Repeats,
            b'P' | b'X' | b'U' | b'S' | b'F' if waits => WordRole::Wait,
            b'F' => WordRole::Feed,
            b'S' => WordRole::Speed,
            b'T' => WordRole::Tool,
            _ if axis.is_some() => WordRole::Place(axis.unwrap_or(0)),
            b'D' if !alone => WordRole::RadiusOffset,
            b'H' if !alone && !calls => WordRole::LengthOffset,
            _ => WordRole::Shape,
        }
    }

    /// True for a rapid or a straight cut, where a missing axis does not affect the others.
    fn goes_straight(&self, block: &Block, actions: &[Action]) -> bool {
        let own = actions.iter().rev().find_map(|action| action.motion());
        let straight = match own {
            Some(code) => matches!(
                code,
                chordal_dialect::MotionCode::Rapid | chordal_dialect::MotionCode::Linear
            ),
            None => {
                matches!(
                    self.kernel.state.motion,
                    ModalMotion::Rapid | ModalMotion::Linear | ModalMotion::None
                )
            }
        };
        let special = |action: &Action| {
            action.cycle().is_some()
                || matches!(action, Action::Once(code) if *code != OnceCode::Dwell)
        };
        straight
            && !actions.iter().any(special)
            && !block.letters().meets(Letters::of("IJKR"))
            && block.polar.is_empty()
    }

    /// The axes whose position is unknown when the shape of a motion is: those that the block names, for an arc those of
    /// its plane, for a cycle also the drilling axis.
    fn axes_of_shape(&self, block: &Block, actions: &[Action]) -> AxisMask {
        let mut axes = AxisMask::NONE;
        for word in &block.words {
            let axis = AXIS_LETTERS.find(char::from(word.letter));
            if let Some(axis) = axis.or_else(|| self.increment_axis(word)) {
                axes.insert(axis);
            }
        }
        let (first, second, normal) = self.kernel.state.plane.axes();
        if block.letters().meets(Letters::of("IJK")) || !block.polar.is_empty() {
            axes.insert(first);
            axes.insert(second);
        }
        let in_cycle = self.kernel.state.cycle.is_some();
        if in_cycle || actions.iter().any(|action| action.cycle().is_some()) {
            axes.insert(normal);
        }
        axes
    }

    fn drop_words(&self, block: &mut Block, drops: DroppedWords) {
        if drops == DroppedWords::default() {
            return;
        }
        // The words of a macro call are its arguments.
        if drops.call && self.is_macro_call(block) {
            return block.truncate(0);
        }
        let words: Vec<Word> = block.words.iter().chain(&block.polar).copied().collect();
        block.truncate(0);
        for word in words {
            let action = self.action_of(&word);
            let is_motion = match action {
                Some(action) => action.cycle().is_some() || matches!(action, Action::Once(_)),
                None => !KEPT_WORDS.has(word.letter) || word.comma,
            };
            let is_wait = action == Some(Action::Once(OnceCode::Dwell));
            let is_call = match action {
                Some(Action::Call(code)) => code != CallCode::Return,
                _ => matches!(word.letter, b'P' | b'Q' | b'L'),
            };
            let is_length = matches!(action, Some(Action::Length(_)));
            let is_dropped = drops.motion && is_motion
                || drops.once && is_wait
                || drops.call && is_call
                || drops.length && is_length;
            if !is_dropped {
                block.push_any(word);
            }
        }
    }
}

/// The parts of a block that are dropped.
#[derive(Clone, Copy, Default, PartialEq, Debug)]
struct DroppedWords {
    /// The words of its motion.
    motion: bool,
    /// The dwell.
    once: bool,
    /// The call.
    call: bool,
    /// The code of the tool length.
    length: bool,
}
