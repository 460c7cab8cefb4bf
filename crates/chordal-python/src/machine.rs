//! Machines.

use std::path::PathBuf;

use chordal_load::{LoadError, machine as load};
use pyo3::prelude::*;

use crate::error;

/// A machine: axes, limits, tools, offsets and settings. It never changes.
#[pyclass(frozen, module = "chordal")]
pub struct Machine(pub chordal::Machine);

#[pymethods]
impl Machine {
    /// The machine of a built-in name or, where there is none of it, of a file.
    #[staticmethod]
    fn named(py: Python<'_>, name: &str) -> PyResult<Machine> {
        made(py, load::named(name))
    }

    /// The machine of a TOML file.
    #[staticmethod]
    fn from_file(py: Python<'_>, path: PathBuf) -> PyResult<Machine> {
        made(py, load::from_file(&path))
    }

    /// The machine of a TOML text; `name` is what messages call the text.
    #[staticmethod]
    fn from_toml(py: Python<'_>, text: &str, name: &str) -> PyResult<Machine> {
        made(py, load::from_text(name, text))
    }

    /// The name it is called by.
    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    /// The name for people.
    #[getter]
    fn title(&self) -> &str {
        &self.0.title
    }

    /// Whose rules its programs are read by.
    #[getter]
    fn control(&self) -> &'static str {
        self.0.control.as_str()
    }

    /// The axes it has, as `XYZA`.
    #[getter]
    fn axes(&self) -> String {
        let axes = chordal::machine::Axis::ALL.into_iter();
        axes.filter(|axis| self.0.axis(*axis).is_some()).map(|axis| axis.letter()).collect()
    }

    /// The whole machine as TOML.
    fn to_toml(&self) -> String {
        self.0.to_toml()
    }

    /// The machine with assignments to its keys, as `tools.5.diameter="0.5 in"`.
    fn with_set(&self, py: Python<'_>, assignments: Vec<String>) -> PyResult<Machine> {
        let mut machine = self.0.clone();
        let errors: Vec<_> =
            assignments.iter().filter_map(|each| machine.set(each).err()).collect();
        if errors.is_empty() { Ok(Machine(machine)) } else { Err(error::of_machine(py, &errors)) }
    }

    fn __eq__(&self, other: &Machine) -> bool {
        self.0 == other.0
    }
}

/// The names of the built-in machines.
#[pyfunction]
pub fn builtin_machines() -> Vec<&'static str> {
    chordal::machine::builtin_names().to_vec()
}

fn made(py: Python<'_>, machine: Result<chordal::Machine, LoadError>) -> PyResult<Machine> {
    machine.map(Machine).map_err(|error| error::of_loading(py, &error))
}
