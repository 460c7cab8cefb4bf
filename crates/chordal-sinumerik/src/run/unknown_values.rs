//! Values that nobody gave: what they are used for is left out, and the run is not verified from there on.

use std::sync::Arc;

use chordal_command::AxisMask;
use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};

use super::interpreter::Interpreter;
use super::similar_names::nearest_name;
use super::words::BlockWords;
use crate::cycles::CYCLES;
use crate::settings::UndefinedNames;
use crate::vocabulary::{is_known_name, known_names};

/// How often a branch with a condition of unknown value is taken as fulfilled, where a run is told to do so.
const MAX_FULFILLED: u32 = 1;

/// The label of the place from which on the path is not known.
const UNKNOWN_FROM_HERE: &str = "from here on the path is not known";

/// The label of a value without which a time is not known.
const TIME_NOT_COUNTED: &str = "the time of what it feeds or waits is not counted";

/// What an unknown value is used for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UnknownUse {
    /// A feed, a speed, a dwell: the path stays.
    Time,
    /// The end of an axis, by its index.
    Axis(usize),
    /// The form of the path: a centre, a radius, an angle, an offset.
    Path,
    /// Neither path nor time.
    Nothing,
}

/// Addresses whose value decides on the time alone.
const TIME_ADDRESSES: [&str; 10] =
    ["F", "S", "FB", "FZ", "FRC", "FRCM", "LIMS", "OVR", "ACC", "CTOL"];

/// Addresses whose value decides on neither path nor time.
const WITHOUT_EFFECT: [&str; 7] = ["H", "SPOS", "SETMS", "SPCON", "FP", "SF", "OTOL"];

impl UnknownUse {
    /// What the value of an address is used for.
    pub fn of_address(name: &str) -> UnknownUse {
        match name {
            _ if TIME_ADDRESSES.contains(&name) => UnknownUse::Time,
            _ if WITHOUT_EFFECT.contains(&name) => UnknownUse::Nothing,
            _ => UnknownUse::Path,
        }
    }
}

impl Interpreter<'_> {
    /// Takes a word whose value depends on something that nobody gave.
    pub(super) fn take_unknown_word(
        &mut self,
        words: &mut BlockWords,
        name: &str,
        range: TextRange,
        used_for: UnknownUse,
        cause: &Arc<str>,
    ) {
        match used_for {
            UnknownUse::Nothing => {}
            UnknownUse::Time => {
                match name {
                    "F" => self.kernel.set_unknown_feed(),
                    "S" => self.kernel.set_unknown_speed(),
                    _ => {}
                }
                self.lose_time(range, name, cause);
            }
            UnknownUse::Axis(axis) => {
                words.astray.insert(axis);
                self.lose_path(range, name, cause);
            }
            UnknownUse::Path => {
                words.has_unknown_path = true;
                self.lose_path(range, name, cause);
            }
        }
    }

    /// A program that is not given may have set tool, feed and speed: what follows needs no such word any more.
    pub(super) fn lose_state(&mut self) {
        self.modes.is_state_unknown = true;
        let state = &mut self.kernel.state;
        state.unknown.feed |= state.feed.is_none();
        state.unknown.speed |= state.rpm == 0.0;
        state.unknown.tool |= state.tool == 0;
        state.unknown.radius_offset |= state.radius_offset.is_none();
    }

    /// Reports once that the path is not known from here on.
    pub(super) fn lose_path(&mut self, range: TextRange, what: &str, cause: &str) {
        self.report_unknown_once(Code::UnknownPath, UNKNOWN_FROM_HERE, range, what, cause);
    }

    fn lose_time(&mut self, range: TextRange, what: &str, cause: &str) {
        self.report_unknown_once(Code::UnknownTime, TIME_NOT_COUNTED, range, what, cause);
    }

    /// Reports the first value of a run that is not known, with the code that says what it leaves unknown.
    fn report_unknown_once(
        &mut self,
        code: Code,
        label: &str,
        range: TextRange,
        what: &str,
        cause: &str,
    ) {
        if !self.is_first_report(code.id()) {
            return;
        }
        let message = format!("{what} depends on {cause}, which is not known");
        let diagnostic = Diagnostic::new(code, self.span(range), message);
        self.kernel.report(diagnostic.label(label).help(help_of(cause)));
    }

    /// Reports that the path is not known from here on, once for each cause.
    pub(super) fn lose_path_because(&mut self, range: TextRange, cause: String) {
        if !self.is_first_report(&cause) {
            return;
        }
        let diagnostic = Diagnostic::new(Code::UnknownPath, self.span(range), cause);
        self.kernel.report(diagnostic.label(UNKNOWN_FROM_HERE));
    }

    /// Assumes a condition of unknown value: not fulfilled, unless the run options name it as fulfilled.
    pub(super) fn assume(&mut self, range: TextRange, cause: &str) -> bool {
        let place = (self.file(), range.start);
        let mut is_fulfilled = self.programs.options.fulfilled.contains(&place);
        if is_fulfilled {
            let times = self.assumed.entry(place).or_insert(0);
            *times += 1;
            is_fulfilled = *times <= MAX_FULFILLED;
        }
        if self.is_first_report(&format!("condition {place:?}")) {
            let side = if is_fulfilled { "fulfilled" } else { "not fulfilled" };
            let message =
                format!("this depends on {cause}, which is not known: it is taken as {side}");
            let diagnostic = Diagnostic::new(Code::AssumedBranch, self.span(range), message)
                .label("from here on the path is assumed")
                .help(help_of(cause));
            self.kernel.report(diagnostic);
        }
        is_fulfilled
    }

    /// A cycle is not carried out: where it leaves the tool along the normal of the plane is not known.
    pub(super) fn lose_cycle(&mut self, range: TextRange, cause: String) {
        let (_, _, normal) = self.kernel.state.plane.axes();
        let mut axes = AxisMask::NONE;
        axes.insert(normal);
        self.kernel.go_astray(axes);
        self.lose_path_because(range, cause);
    }

    /// The axes of the plane and those that a block names are at an unknown place.
    pub(super) fn go_astray(&mut self, words: &BlockWords) {
        let (a, b, _) = self.kernel.state.plane.axes();
        let mut axes = words.axis_mask().or(words.astray);
        axes.insert(a);
        axes.insert(b);
        self.kernel.go_astray(self.modes.frame.reached(axes));
    }

    /// Reports names that nothing defines. One that resembles a name of the program is a typing error; any other may be
    /// user data of the control, which its files of definitions would tell.
    pub(super) fn report_undefined_names(&mut self) {
        for (name, range) in std::mem::take(&mut self.variables.undefined) {
            if !self.is_first_report(&format!("name {name}")) {
                continue;
            }
            let similar = self.similar_name(&name);
            let message = format!("the name {name} is not defined");
            let diagnostic = Diagnostic::new(Code::BadVariable, self.span(range), message);
            let diagnostic = match &similar {
                Some(similar) => diagnostic.help(format!("is {similar} meant?")),
                None => diagnostic.help(
                    "put the control's file of definitions (GUD, .DEF) next to the program, or define the name with DEF",
                ),
            };
            self.report_missing_name(12550, diagnostic, similar.is_some());
        }
    }

    /// Reports a name that the given files do not have: an alarm where it is a typing error or the machine file says
    /// that there is nothing else, otherwise a warning that names the alarm.
    pub(super) fn report_missing_name(
        &mut self,
        alarm: u32,
        diagnostic: Diagnostic,
        is_typing_error: bool,
    ) {
        let setting = self.programs.settings.undefined_names;
        if is_typing_error || setting == UndefinedNames::Alarm {
            return self.report_alarm(alarm, diagnostic);
        }
        let range = diagnostic.primary.span.range;
        self.report_possible_alarm(alarm, diagnostic.severity(Severity::Warning));
        self.lose_path(range, "what follows", "the control's own programs and data");
    }

    /// A name of the program or of the language that differs from another one by a typing error.
    pub(super) fn similar_name(&self, name: &str) -> Option<String> {
        if is_known_name(name) {
            return None;
        }
        let mut others: Vec<&str> = Vec::new();
        let locals = self.variables.locals.last().into_iter().flat_map(|locals| locals.keys());
        let own = locals.chain(self.variables.user_data.keys()).map(String::as_str);
        others.extend(own.filter(|other| *other != name));
        others.extend(self.programs.texts.iter().map(|text| text.name.as_str()));
        for cycle in CYCLES {
            others.push(cycle.name);
        }
        for known in known_names() {
            others.push(known);
        }
        nearest_name(name, others).map(str::to_string)
    }

    /// The axes of a block with words of unknown value, after its move.
    pub(super) fn lose_axes(&mut self, astray: AxisMask) {
        if astray != AxisMask::NONE {
            self.kernel.go_astray(self.modes.frame.reached(astray));
        }
    }
}

/// How the user can give a value.
fn help_of(cause: &str) -> String {
    if cause.starts_with('$') {
        "it depends on the machine: what follows from it is not verified".to_string()
    } else {
        format!("give the program or the file of definitions that sets {cause}")
    }
}
