//! Datum tables: SEL TABLE, cycle 7 with a line of a table, and TRANS DATUM TABLE.

use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_kernel::ProgramName;

use super::interpreter::KlartextInterpreter;
use super::program_texts::{called_name, file_stem};
use super::transformations::Transformation;
use crate::alarms::{DATUM_NUMBER_MISSING, DATUM_TABLE_MISSING};
use crate::datum_table::TableDatum;
use crate::syntax::WordOperand;

impl KlartextInterpreter<'_> {
    /// SEL TABLE: the datum table from here on.
    pub(super) fn select_datum_table(&mut self, name: TextRange) {
        let name = called_name(self.text(), name);
        if self.programs.datum_table(&name).is_none() {
            self.report_missing_table(&name, self.here);
        }
        self.modes.datum_table = Some(name);
    }

    /// TRANS DATUM TABLE: a line of a table, which may be named.
    pub(super) fn datum_of_table(&mut self, line: WordOperand, table: Option<TextRange>) {
        let range = self.here;
        let Some(number) = self.operand(line, range) else { return };
        let name = table.map(|name| called_name(self.text(), name));
        let Some(datum) = self.table_datum(number, name, range) else { return };
        let mut shift = self.modes.chain.shift();
        self.take_datum(&datum, &mut shift, range);
        self.transform(Transformation::Shift(shift));
    }

    /// A line of the active datum table, or of one that is named; `None` if that is reported.
    pub(super) fn table_datum(
        &mut self,
        number: f64,
        table: Option<String>,
        range: TextRange,
    ) -> Option<TableDatum> {
        let tables = &self.programs.datum_tables;
        let name = table.or_else(|| self.modes.datum_table.clone());
        let found = match (&name, tables.as_slice()) {
            (Some(name), _) => self.programs.datum_table(name),
            // The control takes the table that the operator has activated; a single one is that.
            (None, [only]) => Some(only),
            (None, _) => None,
        };
        let Some((stem, table)) = found else {
            match name {
                Some(name) => self.report_missing_table(&name, range),
                None => self.report_no_table(range),
            }
            return None;
        };
        let whole = (number.fract() == 0.0 && number >= 0.0).then_some(number as u32);
        let datum = whole.and_then(|number| table.data.get(&number)).copied();
        if datum.is_none() {
            let message = format!("the datum table {stem} has no line {number}");
            let diagnostic = Diagnostic::new(Code::MissingLabel, self.span(range), message)
                .label(format!("it has {} lines", table.data.len()))
                .help("correct the number, or write the line into the table; the datum stays");
            self.report_alarm(DATUM_NUMBER_MISSING, diagnostic);
        }
        datum
    }

    /// The shift of a line: an axis without a value stays.
    pub(super) fn take_datum(
        &mut self,
        datum: &TableDatum,
        shift: &mut [f64; 3],
        range: TextRange,
    ) {
        for (own, value) in shift.iter_mut().zip(datum) {
            *own = value.unwrap_or(*own);
        }
        if datum[3..].iter().flatten().any(|degrees| *degrees != 0.0) {
            self.rotary_shift(range);
        }
    }

    /// A datum shift of a rotary axis, which is not carried out.
    pub(super) fn rotary_shift(&mut self, range: TextRange) {
        let what = "a datum shift of a rotary axis is not followed: its positions are those of the preset here";
        self.not_followed_once("datum of a rotary axis", range, what);
    }

    fn report_missing_table(&mut self, name: &str, range: TextRange) {
        self.missing.push(ProgramName::from(file_stem(name)));
        let message = format!("there is no datum table {name}");
        let diagnostic = Diagnostic::new(Code::MissingSubprogram, self.span(range), message);
        let help = "put the table next to the program; the datum stays here";
        self.report_alarm(DATUM_TABLE_MISSING, diagnostic.help(help));
    }

    fn report_no_table(&mut self, range: TextRange) {
        let count = self.programs.datum_tables.len();
        let message = match count {
            0 => "a line of a datum table is needed, and there is no table".to_string(),
            _ => {
                format!("a line of a datum table is needed, and none of {count} tables is selected")
            }
        };
        let diagnostic = Diagnostic::new(Code::MissingSubprogram, self.span(range), message);
        let help = match count {
            0 => "put the table (.D) next to the program; the datum stays here",
            _ => "write SEL TABLE with the name of the table before it; the datum stays here",
        };
        self.report_alarm(DATUM_TABLE_MISSING, diagnostic.help(help));
    }
}
