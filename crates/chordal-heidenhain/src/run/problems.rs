//! Problems with the text that the control shows.

use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};

use super::interpreter::KlartextInterpreter;
use crate::alarms::ARITHMETICAL_ERROR;
use crate::syntax::{ParameterBank, ParameterName};
use crate::values::FormulaError;

impl KlartextInterpreter<'_> {
    /// Reports an error with the control's own words.
    pub(super) fn report_alarm(&mut self, alarm: &str, mut diagnostic: Diagnostic) {
        let title = self.kernel.alarms.title;
        diagnostic.severity = Severity::Error;
        diagnostic.alarm = Some(format!("{title}: {alarm}"));
        self.kernel.report(diagnostic);
    }

    /// The same for a message without notes or a help.
    pub(super) fn alarm(
        &mut self,
        alarm: &str,
        code: Code,
        range: TextRange,
        message: impl Into<String>,
    ) {
        let diagnostic = Diagnostic::new(code, self.span(range), message.into());
        self.report_alarm(alarm, diagnostic);
    }

    /// Reports a problem without words of the control.
    pub(super) fn problem(&mut self, code: Code, range: TextRange, message: impl Into<String>) {
        let diagnostic = Diagnostic::new(code, self.span(range), message.into());
        self.kernel.report(diagnostic);
    }

    /// Reports something that is read and not carried out: what follows from it is not verified.
    pub(super) fn not_followed(&mut self, range: TextRange, what: impl Into<String>) {
        self.problem(Code::NotFollowed, range, what);
    }

    /// The same once for each subject.
    pub(super) fn not_followed_once(&mut self, subject: &str, range: TextRange, what: &str) {
        if self.is_first_report(subject) {
            self.not_followed(range, what);
        }
    }

    /// Reports that a value or a path is assumed: what follows from it is not verified.
    pub(super) fn assumed_once(&mut self, subject: &str, range: TextRange, what: &str) {
        if self.is_first_report(subject) {
            self.problem(Code::UnknownPath, range, what);
        }
    }

    /// Reports a formula that has no value.
    pub(super) fn report_formula(&mut self, error: FormulaError) {
        match error {
            FormulaError::DivisionByZero(range) => {
                let message = "this divides by zero";
                self.alarm(ARITHMETICAL_ERROR, Code::DivisionByZero, range, message);
            }
            FormulaError::OutsideDomain(range, what) => {
                self.alarm(ARITHMETICAL_ERROR, Code::OutsideDomain, range, what);
            }
            FormulaError::Overflow(range) => {
                let message = "the result is too large";
                self.alarm(ARITHMETICAL_ERROR, Code::NumberOverflow, range, message);
            }
            FormulaError::Unset(range, name) => self.report_unset(range, name),
        }
    }

    /// Reports a parameter that is read and was never set, or whose value is not known here.
    pub(super) fn report_unset(&mut self, range: TextRange, name: ParameterName) {
        if self.parameters.is_unknown(name) {
            return self.report_unknown(range, name);
        }
        let message = format!("{name} is read, and nothing has set it");
        let diagnostic = Diagnostic::new(Code::BadVariable, self.span(range), message)
            .help("set it before; the control may keep a value of another program, which is not known here");
        self.kernel.report(diagnostic);
    }

    /// Reports, once for each parameter, that a value is not known here: no alarm of the control follows from it.
    fn report_unknown(&mut self, range: TextRange, name: ParameterName) {
        if !self.is_first_report(&format!("the value of {name}")) {
            return;
        }
        let tool = self.kernel.state.tool;
        let (why, help) = match (name.bank, name.number) {
            (ParameterBank::Shared, 108) => (
                format!("{name} is the radius of tool {tool}, which is not known"),
                format!("set it with --set tools.{tool}.diameter=\"…\""),
            ),
            (ParameterBank::Shared, 114) => (
                format!("{name} is the length of tool {tool}, which is not known"),
                format!("set it with --set tools.{tool}.length=\"…\""),
            ),
            (ParameterBank::Retained, _) => (
                format!("{name} keeps the value of an earlier program, which is not known here"),
                "assign it at the start of the program to prove what follows".to_string(),
            ),
            _ if name.is_of_control() => (
                format!("the control sets {name}, and its value is not known here"),
                "assign it at the start of the program to prove what follows".to_string(),
            ),
            _ => (format!("{name} depends on a value that is not known here"), String::new()),
        };
        let diagnostic = Diagnostic::new(Code::UnknownPath, self.span(range), why)
            .label("from here on the path is not known");
        let diagnostic = if help.is_empty() { diagnostic } else { diagnostic.help(help) };
        self.kernel.report(diagnostic);
    }
}
