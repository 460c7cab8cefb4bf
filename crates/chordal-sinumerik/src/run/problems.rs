//! Problems with the alarm that the control shows.

use chordal_diagnostics::{Code, Diagnostic, Severity, Span, TextRange};

use super::interpreter::Interpreter;
use crate::alarms::{NO_ALARM, text_of};
use crate::values::{DIVISION_BY_ZERO, EvaluationError};

impl Interpreter<'_> {
    /// A part of the running program's text as a span.
    pub(super) fn span(&self, range: TextRange) -> Span {
        self.macro_use.unwrap_or(range).in_file(self.file())
    }

    /// Reports a problem with the number of the control's alarm.
    pub(super) fn alarm(
        &mut self,
        alarm: u32,
        code: Code,
        range: TextRange,
        message: impl Into<String>,
    ) {
        let diagnostic = Diagnostic::new(code, self.span(range), message.into());
        self.report_alarm(alarm, diagnostic);
    }

    /// The same for a diagnostic with notes or a help.
    pub(super) fn report_alarm(&mut self, alarm: u32, mut diagnostic: Diagnostic) {
        if alarm == NO_ALARM {
            return self.kernel.report(diagnostic);
        }
        let title = self.kernel.alarms.title;
        diagnostic.severity = Severity::Error;
        diagnostic.alarm = Some(match text_of(alarm) {
            Some(text) => format!("{title}: {text}"),
            None => format!("{title}: {alarm}"),
        });
        self.kernel.report(diagnostic);
    }

    /// Reports a problem that is an alarm of the control only if it has nothing more than what is given here.
    pub(super) fn report_possible_alarm(&mut self, alarm: u32, mut diagnostic: Diagnostic) {
        let title = self.kernel.alarms.title;
        diagnostic.alarm = text_of(alarm).map(|text| format!("{title}: {text}"));
        self.kernel.report(diagnostic);
    }

    /// Reports an expression that has no value.
    pub(super) fn report_evaluation(&mut self, error: EvaluationError) {
        let code = match error.alarm {
            NO_ALARM => return self.not_followed(error.range, error.message),
            14051 if error.message == DIVISION_BY_ZERO => Code::DivisionByZero,
            14051 => Code::OutsideDomain,
            12400 | 17020 | 17030 | 12550 => Code::BadVariable,
            _ => Code::BadExpression,
        };
        self.alarm(error.alarm, code, error.range, error.message);
    }

    /// True the first time that a run asks for a subject; for problems that are reported once.
    pub(super) fn is_first_report(&mut self, subject: &str) -> bool {
        self.reported.insert(subject.to_string())
    }

    /// Reports the R parameters that were read before the program set them: the control keeps the values of programs
    /// before, which nobody knows here.
    pub(super) fn report_unset_reads(&mut self) {
        for (number, range) in std::mem::take(&mut self.variables.unset_reads) {
            if !self.is_first_report(&format!("R{number}")) {
                continue;
            }
            let message = format!("R{number} is read before the program sets it: it is taken as 0");
            let help = "the control keeps the value of the program before; set it at the start of the program";
            let diagnostic = Diagnostic::new(Code::UnknownPath, self.span(range), message);
            self.kernel.report(diagnostic.help(help));
        }
    }

    /// Says once for each cycle that its path is not that of the control in every move.
    pub(super) fn report_assumed_path(&mut self, name: &str, range: TextRange) {
        if !self.is_first_report(&format!("path of {name}")) {
            return;
        }
        let message = format!("the manuals do not give every move of {name}: its path is assumed");
        let help = "shape, depth and end are those of the control; the order of the cuts and the time may differ";
        let diagnostic = Diagnostic::new(Code::CyclePathAssumed, self.span(range), message);
        self.kernel.report(diagnostic.help(help));
    }

    /// Reports something that is read and not carried out: what follows from it is not verified.
    pub(super) fn not_followed(&mut self, range: TextRange, what: impl Into<String>) {
        let span = self.span(range);
        self.kernel.report(Diagnostic::new(Code::NotFollowed, span, what.into()));
    }
}
