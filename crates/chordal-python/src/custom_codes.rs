//! Codes of a shop's own, answered by Python.

use std::sync::Arc;

use chordal::control::Units;
use chordal::machine::AXES;
use chordal::{ShopAnswer, ShopCall, ShopCodes};
use pyo3::prelude::*;

use crate::error;
use crate::signals::PythonSignals;

/// What Python answers: what it is, seconds, and a label, blocks or a reason.
type CustomReply = Option<(String, f64, Option<String>)>;

/// Asks a function of `chordal._shop`.
pub struct PyCustomCodes {
    hook: Py<PyAny>,
    signals: Arc<PythonSignals>,
}

impl PyCustomCodes {
    pub fn new(hook: Py<PyAny>, signals: Arc<PythonSignals>) -> PyCustomCodes {
        PyCustomCodes { hook, signals }
    }

    fn ask(&self, py: Python<'_>, call: &ShopCall<'_>) -> PyResult<ShopAnswer> {
        let words: Vec<(String, f64)> =
            call.words.iter().map(|(letter, value)| (letter.to_string(), *value)).collect();
        let position = (0..AXES).map(|axis| {
            let value = call.position[axis];
            let shown = if axis < 3 { value } else { value.to_degrees() };
            call.known.has(axis).then_some(shown)
        });
        let answer: CustomReply = self
            .hook
            .call1(
                py,
                (
                    call.code.to_string(),
                    call.file,
                    call.line,
                    call.text.trim(),
                    words,
                    call.arguments.to_vec(),
                    call.tool,
                    position.collect::<Vec<Option<f64>>>(),
                    call.units == Units::Inch,
                    call.incremental,
                    call.spindle_rpm,
                    call.nth,
                ),
            )?
            .extract(py)?;
        let Some((kind, seconds, text)) = answer else { return Ok(ShopAnswer::NotMine) };
        let text = text.as_deref();
        match kind.as_str() {
            "wait" => Ok(ShopAnswer::Wait { seconds, label: text.map(Arc::from) }),
            "blocks" => Ok(ShopAnswer::text(text.unwrap_or_default())),
            "refusal" => Ok(ShopAnswer::Refused(text.unwrap_or_default().to_string())),
            other => Err(error::inside(format!("an answer of the kind {other}"))),
        }
    }
}

impl ShopCodes for PyCustomCodes {
    fn answer(&self, call: &ShopCall<'_>) -> ShopAnswer {
        // The run ends soon: nothing more is asked after an error.
        if self.signals.has_raised() {
            return ShopAnswer::NotMine;
        }
        Python::attach(|py| {
            self.ask(py, call).unwrap_or_else(|error| {
                let (file, line, text) = (call.file, call.line, call.text.trim());
                let note = format!("asked about {} in {file}, line {line}: {text}", call.code);
                // A note that cannot be added is missing; the error itself is what matters.
                let _ = error.value(py).call_method1("add_note", (note,));
                let why = error.to_string();
                self.signals.raise(error);
                ShopAnswer::Refused(why)
            })
        })
    }
}
