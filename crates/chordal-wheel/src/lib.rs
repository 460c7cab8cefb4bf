//! `chordal._chordal`: the compiled half of the Python package, and the command that its wheel brings.

use pyo3::prelude::*;

/// Runs the command `chordal` with its arguments, of which the first is its own name, and
/// returns its exit code.
#[pyfunction]
fn main(py: Python<'_>, arguments: Vec<std::ffi::OsString>) -> u8 {
    py.detach(|| chordal_cli::run(arguments))
}

#[pymodule]
fn _chordal(module: &Bound<'_, PyModule>) -> PyResult<()> {
    chordal_python::fill(module)?;
    module.add_function(wrap_pyfunction!(main, module)?)?;
    Ok(())
}
