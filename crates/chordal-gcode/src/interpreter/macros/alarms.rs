//! Alarms (#3000) and messages (#3006) that a program shows to the operator.

use chordal_command::CommandKind;
use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};

use super::super::{EndReason, Interpreter};

impl Interpreter<'_> {
    /// `#3000=n (TEXT)`.
    pub(super) fn alarm(&mut self, value: f64, range: TextRange) {
        let rules = self.rules();
        let shown = libm::round(value) + f64::from(rules.alarm_base);
        let text = self.message_text();
        self.emit_alarm(libm::round(value), &text);
        let shown = format!("{shown} {text}").trim_end().to_string();
        let span = self.kernel.origin.span;
        let title = self.control.table.title;
        let mut diagnostic = Diagnostic::new(
            Code::ProgramAlarm,
            span,
            format!("the program stops itself with alarm {shown}"),
        )
        .label("the run ends here")
        .alarm(format!("{title}: {shown}"))
        .help("check the conditions that lead to this block");
        if self.macros.unknown.branch_assumed() {
            diagnostic = diagnostic
                .severity(Severity::Note)
                .note("a branch before it depends on a value that is not known, and was assumed");
        }
        let last = rules.alarm_last;
        if value > f64::from(last) {
            diagnostic = diagnostic.note(format!("the control accepts numbers up to {last}"));
        }
        let _ = range;
        self.kernel.report(diagnostic);
        self.stopped = Some(EndReason::Alarm);
    }

    /// `#3006=n (TEXT)`.
    pub(super) fn message_stop(&mut self) {
        let text = self.message_text();
        if let Some(range) = self.message {
            self.kernel.emit(CommandKind::Message(range));
        }
        self.report_once(
            Diagnostic::new(
                Code::ProgramStop,
                self.kernel.origin.span,
                format!("the program stops and shows `{text}`"),
            )
            .severity(Severity::Note),
        );
        self.kernel.emit(CommandKind::Stop { optional: false });
    }

    /// The comment next to the assigned value.
    fn message_text(&self) -> String {
        let range = self.message.unwrap_or_default();
        String::from_utf8_lossy(range.slice(self.reader.text())).trim().to_string()
    }
}
