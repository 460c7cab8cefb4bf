//! Values of words, parameters and FN.

use chordal_command::{Position, telling_number};
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_kernel::EndReason;

use super::interpreter::KlartextInterpreter;
use super::run_state::KlartextFlow;
use crate::syntax::{KlartextFormula, ParameterBank, ParameterName, TextPart, WordOperand};
use crate::values::{FormulaError, formula_value};

impl KlartextInterpreter<'_> {
    /// The value of a word; `None` if it has none, which is reported.
    pub(super) fn operand(&mut self, operand: WordOperand, range: TextRange) -> Option<f64> {
        let value = self.value_of(operand);
        if let (None, WordOperand::Parameter { name, .. }) = (value, operand) {
            self.report_unset(range, name);
        }
        value
    }

    /// The value of a word; `None` if it has none.
    pub(super) fn value_of(&self, operand: WordOperand) -> Option<f64> {
        match operand {
            WordOperand::Number(value) => Some(value),
            WordOperand::Parameter { is_negative, name } => {
                let value = self.parameters.number(name)?;
                Some(if is_negative { 0.0 - value } else { value })
            }
        }
    }

    /// `Q1 = …`, FN 0 to FN 8 and FN 13.
    pub(super) fn assign(&mut self, target: ParameterName, formula: &KlartextFormula) {
        match formula_value(formula, &self.parameters) {
            Ok(value) => self.parameters.set(target, value),
            Err(FormulaError::Unset(range, name)) if self.parameters.is_unknown(name) => {
                self.report_unset(range, name);
                self.parameters.set_unknown(target);
            }
            Err(error) => {
                self.report_formula(error);
                // What follows is read with a value, so that one problem does not become many.
                self.parameters.set(target, 0.0);
            }
        }
    }

    /// `QS1 = …`.
    pub(super) fn assign_text(&mut self, target: u32, parts: Option<&Vec<TextPart>>) {
        let range = self.here;
        let Some(parts) = parts else {
            return self.not_followed(range, "this formula of texts is not followed");
        };
        let mut text = String::new();
        for part in parts {
            match part {
                TextPart::Literal(literal) => text.push_str(literal),
                TextPart::Parameter(number) => match self.parameters.text(*number) {
                    Some(value) => text.push_str(value),
                    None => {
                        let name = ParameterName { bank: ParameterBank::Text, number: *number };
                        self.report_unset(range, name);
                    }
                },
            }
        }
        self.parameters.set_text(target, text);
    }

    /// FN 14: the program stops with an error of its own.
    pub(super) fn raise_error(&mut self, number: WordOperand) -> KlartextFlow {
        let range = self.here;
        let Some(number) = self.operand(number, range) else { return KlartextFlow::Next };
        let message = format!("the program stops itself with error {}", telling_number(number, 0));
        let diagnostic = Diagnostic::new(Code::ProgramAlarm, self.span(range), message);
        self.kernel.report(diagnostic.help("the condition before it says what is wrong"));
        KlartextFlow::End(EndReason::Alarm)
    }

    /// FN 18: what the program asks the control for.
    pub(super) fn system_read(&mut self, target: ParameterName, numbers: [Option<WordOperand>; 3]) {
        let range = self.here;
        let [id, number, index] = numbers.map(|operand| {
            operand.and_then(|operand| self.operand(operand, range)).map(|value| value.round())
        });
        let (id, number) = (id.unwrap_or(0.0) as i64, number.unwrap_or(0.0) as i64);
        let index = index.map_or(0, |value| value as i64);
        let value = self.system_value(id, number, index);
        if value.is_none() {
            let what =
                format!("FN 18 ID{id} NR{number} IDX{index} is not known here: it is read as 0");
            let subject = format!("SYSREAD {id} {number} {index}");
            self.assumed_once(&subject, range, &what);
        }
        self.parameters.set(target, value.unwrap_or(0.0));
    }

    /// The answer to FN 18; `None` where it is not known. Lengths are in the unit of the program.
    fn system_value(&mut self, id: i64, number: i64, index: i64) -> Option<f64> {
        let unit = self.unit_mm();
        let tool = self.kernel.state.tool;
        let of_tool = |index: i64| if index > 0 { index as u32 } else { tool };
        let mm = match (id, number) {
            (20, 1) => return Some(f64::from(tool)),
            (20, 2) => return self.kernel.state.selected_tool.map(f64::from),
            (20, 3) => return Some((2 - self.tool_axis() as i64) as f64),
            (20, 4) => return Some(self.kernel.state.rpm),
            (50, 1) => self.tools.get(&of_tool(index))?.length_mm()?,
            (50, 2) => self.tools.get(&of_tool(index))?.diameter_mm? / 2.0,
            (50, 3) => self.tools.get(&of_tool(index))?.corner_radius_mm?,
            (210, 1) => return Some(self.modes.chain.rotation_deg()),
            (270, 1) => {
                let axis = usize::try_from(index - 1).ok().filter(|axis| *axis < 6)?;
                let place: Position = self.programmed();
                if axis >= 3 {
                    return Some(place[axis].to_degrees());
                }
                place[axis]
            }
            _ => return None,
        };
        Some(mm / unit)
    }

    /// FN 15, 16, 17, 19, 20 and others: they move nothing; a value that they give is not known.
    pub(super) fn other_function(&mut self, number: u32, target: Option<ParameterName>) {
        let range = self.here;
        match number {
            15 | 16 | 17 | 38 => {}
            39.. => {
                let message = format!("there is no FN {number}");
                self.problem(Code::UnknownCode, range, message);
            }
            _ => {
                if self.is_first_report(&format!("FN {number}")) {
                    let what = format!("FN {number} is read and moves nothing here");
                    self.problem(Code::NotSimulated, range, what);
                }
            }
        }
        if let Some(target) = target {
            self.parameters.set_unknown(target);
        }
    }
}
