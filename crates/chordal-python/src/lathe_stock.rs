//! What is left of the stock of a lathe.

use chordal::Job;
use chordal::stock::TurnedReport;
use chordal::stock::section::PlaceSide;
use chordal_export::columns::{CutColumns, RowBatcher, section_columns};
use chordal_export::format::LATHE_STOCK_FILES;
use chordal_export::{
    OutputFormat, PlotOptions, section_dxf, section_png, section_svg, turned_json, turned_mesh,
};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::error;
use crate::table::Table;

/// The answers of a run on turned stock. They never change.
#[pyclass(frozen, module = "chordal._chordal")]
pub struct TurnedStock {
    found: TurnedReport,
    json: String,
    name: String,
    outline: Py<Table>,
    passes: Py<Table>,
}

impl TurnedStock {
    /// What a job has left.
    pub fn new(
        py: Python<'_>,
        found: TurnedReport,
        [outline, passes]: [Table; 2],
        name: &str,
    ) -> PyResult<TurnedStock> {
        let json = turned_json(&found, name);
        let (outline, passes) = (Py::new(py, outline)?, Py::new(py, passes)?);
        Ok(TurnedStock { found, json, name: name.to_string(), outline, passes })
    }

    /// The section of a run, and what every move takes.
    pub fn tables(job: &Job<'_>, found: &TurnedReport) -> PyResult<[Table; 2]> {
        let mut passes = CutColumns::new(job);
        found.moves.iter().for_each(|each| passes.cut(each));
        let outline = section_columns(job, found).and_then(Table::new);
        let passes = passes.take().and_then(Table::new);
        Ok([outline.map_err(error::inside)?, passes.map_err(error::inside)?])
    }
}

#[pymethods]
impl TurnedStock {
    /// The object of `chordal stock --format json`.
    #[getter]
    fn json(&self) -> &str {
        &self.json
    }

    /// Lines and arcs of everything that is left.
    #[getter]
    fn outline(&self, py: Python<'_>) -> Py<Table> {
        self.outline.clone_ref(py)
    }

    /// What every move at feed takes.
    #[getter]
    fn passes(&self, py: Python<'_>) -> Py<Table> {
        self.passes.clone_ref(py)
    }

    /// The radii between which material is at a z, from the axis out, mm.
    fn radii(&self, z_mm: f64) -> Vec<(f64, f64)> {
        self.found
            .sections()
            .flat_map(|section| section.radii_at(z_mm, PlaceSide::Higher))
            .collect()
    }

    /// The bytes of a file by its ending: half section (`dxf`, `svg`, `png`) or solid (`stl`, `3mf`, `glb`).
    fn file<'py>(
        &self,
        py: Python<'py>,
        ending: &str,
        name: &str,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let picture = || PlotOptions { title: self.name.clone(), ..PlotOptions::default() };
        let mesh =
            |format| turned_mesh(&self.found, format, name).map_err(|error| error.to_string());
        let bytes = py.detach(|| {
            Some(match LATHE_STOCK_FILES.named(ending)? {
                OutputFormat::Dxf => Ok(section_dxf(&self.found)),
                OutputFormat::Svg => Ok(section_svg(&self.found, &picture()).into_bytes()),
                OutputFormat::Png => {
                    section_png(&self.found, &picture()).map_err(|error| error.to_string())
                }
                format => mesh(format),
            })
        });
        let bytes = bytes.ok_or_else(|| {
            let message = format!("there is no format `{ending}`");
            error::usage(py, &message, Some("formats are dxf, svg, png, stl, 3mf, glb"))
        })?;
        Ok(PyBytes::new(py, &bytes.map_err(error::value)?))
    }
}
