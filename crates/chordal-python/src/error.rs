//! From the errors of Rust to the exceptions of `chordal.errors`.

use chordal::machine::MachineError;
use chordal_load::LoadError;
use pyo3::exceptions::{PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;

/// What could not be loaded, as the exception that says the same.
pub fn of_loading(py: Python<'_>, error: &LoadError) -> PyErr {
    match error {
        LoadError::Read { .. } => PyOSError::new_err(error.to_string()),
        LoadError::Machine(errors) => of_machine(py, errors),
        LoadError::Request { message, help } => usage(py, message, help.as_deref()),
    }
}

/// What is wrong with a machine, each problem as file, line, message, help, the underlined words
/// and the text that draws it.
pub fn of_machine(py: Python<'_>, errors: &[MachineError]) -> PyErr {
    let problems: Vec<_> = errors
        .iter()
        .map(|error| {
            let drawn = chordal_export::machine_error_text(error, false);
            let underlined = error.underlined().to_string();
            (error.file.clone(), error.line(), &error.message, &error.help, underlined, drawn)
        })
        .collect();
    made(py, "machine_error", (problems,))
}

/// A request that makes no sense, and what to do instead.
pub fn usage(py: Python<'_>, message: &str, help: Option<&str>) -> PyErr {
    made(py, "usage_error", (message, help))
}

/// A number that cannot be.
pub fn value(message: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(message.to_string())
}

/// An error that nothing which a caller gives should cause.
pub fn inside(error: impl std::fmt::Display) -> PyErr {
    PyRuntimeError::new_err(error.to_string())
}

/// The exception that a function of `chordal.errors` makes.
fn made<'py, A>(py: Python<'py>, function: &str, arguments: A) -> PyErr
where
    A: pyo3::call::PyCallArgs<'py>,
{
    let exception = py
        .import("chordal.errors")
        .and_then(|module| module.getattr(function))
        .and_then(|function| function.call1(arguments));
    match exception {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}
