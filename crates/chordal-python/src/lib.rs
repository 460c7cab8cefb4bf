//! What the Python package `chordal` is built on; `chordal-wheel` makes the module `chordal._chordal`
//! of it.
//!
//! This module is small and plain; what people use is written in Python around it
//! (`python/chordal`). Everything that takes long lets go of the interpreter lock. Results of many
//! rows are [`table::Table`]s: Arrow columns that other libraries read where they lie.

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a shell: it loads programs for Python"
)]

mod archive;
mod curve;
mod custom_codes;
mod error;
mod lathe_stock;
mod machine;
mod motion;
mod program;
mod signals;
mod stock;
mod table;

use pyo3::prelude::*;

/// What a diagnostic, a G or M code or a letter means is explained by the command; this is the list
/// of diagnostics: code, name, severity, summary and explanation of each.
#[pyfunction]
fn codes() -> Vec<(&'static str, &'static str, &'static str, &'static str, &'static str)> {
    let row = |code: chordal::Code| {
        let info = code.info();
        (info.id, info.name, info.severity.word(), info.summary, info.explanation)
    };
    chordal::Code::all().map(row).collect()
}

/// Fills the module `chordal._chordal`.
///
/// # Errors
/// What Python says where it cannot take a name.
pub fn fill(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<machine::Machine>()?;
    module.add_class::<program::Program>()?;
    module.add_class::<table::Table>()?;
    module.add_class::<table::NumberBuffer>()?;
    module.add_class::<curve::Curve>()?;
    module.add_class::<motion::Motion>()?;
    module.add_class::<stock::Stock>()?;
    module.add_class::<lathe_stock::TurnedStock>()?;
    module.add_class::<archive::ArchiveWorker>()?;
    module.add_class::<archive::Journal>()?;
    module.add_function(wrap_pyfunction!(codes, module)?)?;
    module.add_function(wrap_pyfunction!(machine::builtin_machines, module)?)?;
    module.add_function(wrap_pyfunction!(program::load_file, module)?)?;
    module.add_function(wrap_pyfunction!(program::load_text, module)?)?;
    module.add_function(wrap_pyfunction!(curve::line, module)?)?;
    module.add_function(wrap_pyfunction!(curve::arc_from_center, module)?)?;
    module.add_function(wrap_pyfunction!(curve::arc_through, module)?)?;
    module.add_function(wrap_pyfunction!(curve::arc_from_radius, module)?)?;
    module.add_function(wrap_pyfunction!(curve::spiral, module)?)?;
    module.add_function(wrap_pyfunction!(motion::plan, module)?)?;
    module.add_function(wrap_pyfunction!(archive::archive_walk, module)?)?;
    module.add_function(wrap_pyfunction!(archive::archive_calls, module)?)?;
    module.add_function(wrap_pyfunction!(archive::archive_failed, module)?)?;
    Ok(())
}
