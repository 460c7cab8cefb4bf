//! POPEN, DPRNT, PCLOS.

use chordal_command::CommandKind;
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_syntax::OutputCode;

use super::super::Interpreter;
use crate::macros::evaluate::ValuePurpose;
use crate::macros::output::{NumberFormat, OutputPart, next_part, write_number};

/// Largest number of bytes that a run prints.
const MAX_OUTPUT: usize = 1 << 20;

impl Interpreter<'_> {
    pub(super) fn print(&mut self, range: TextRange, output: OutputCode) {
        match output {
            OutputCode::Open => self.macros.port_open = true,
            OutputCode::Close => self.macros.port_open = false,
            OutputCode::Text(text) => self.print_line(range, text),
            OutputCode::Binary(_) => self.report_once(
                Diagnostic::new(
                    Code::UnsupportedMacro,
                    self.span(range),
                    "BPRNT sends bytes, not text; they are not kept",
                )
                .severity(chordal_diagnostics::Severity::Warning)
                .help("print with DPRNT to see the values"),
            ),
        }
    }

    fn print_line(&mut self, range: TextRange, text: TextRange) {
        if !self.macros.port_open && self.rules().output_needs_open {
            self.report_once(
                Diagnostic::new(
                    Code::OutputClosed,
                    self.span(range),
                    "nothing opened the port for this text",
                )
                .help("put POPEN before it, and PCLOS after the last DPRNT"),
            );
        }
        let Some(line) = self.format_line(text) else { return };
        self.print_text(range, line);
    }

    /// Prints a line, up to the limit of output.
    pub(super) fn print_text(&mut self, range: TextRange, line: String) {
        if self.macros.printed + line.len() > MAX_OUTPUT {
            let kept = MAX_OUTPUT >> 20;
            self.report_once(
                Diagnostic::new(
                    Code::OutputLimit,
                    self.span(range),
                    format!("the program prints more than {kept} MiB; the rest is not kept"),
                )
                .help("look for a loop that does not end"),
            );
            return;
        }
        self.macros.printed += line.len() + 1;
        self.kernel.emit(CommandKind::Output { text: line });
    }

    /// The line with its values; `None` when it cannot be read, which is reported.
    fn format_line(&mut self, text: TextRange) -> Option<String> {
        let whole = self.reader.text();
        let blanks = self.rules().output_blanks;
        let mut line = String::new();
        let mut rest = text;
        while let Some(part) = next_part(whole, &mut rest) {
            match part {
                // Terminal control characters are dropped.
                OutputPart::Text(byte) if byte < b' ' => {}
                OutputPart::Text(byte) => line.push(byte as char),
                OutputPart::Value { expression, format } => {
                    let value = self.word_value(expression, ValuePurpose::VALUE)?;
                    let format = format.unwrap_or_else(|| {
                        self.report_format(expression);
                        NumberFormat { whole: 4, decimals: 4 }
                    });
                    match value.known() {
                        Some(value) => write_number(&mut line, value, format, blanks),
                        None => line.push('?'),
                    }
                }
            }
        }
        Some(line)
    }

    fn report_format(&mut self, range: TextRange) {
        self.report_once(
            Diagnostic::new(
                Code::BadOutput,
                self.span(range),
                "the number of digits is missing after this variable",
            )
            .label("printed with four digits and four decimals")
            .help("write the numbers of digits in brackets: `#1[44]`"),
        );
    }
}
