//! What is left of the stock.

use chordal::geometry::Vec3;
use chordal::stock::{StockReport, StockRunError};
use chordal_export::format::STOCK_FILES;
use chordal_export::{MeshSurface, OutputFormat, stock_json, stock_mesh, stock_png};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::error;
use crate::table::{NumberBuffer, indices, rows};

/// The answers of a run on stock. They never change.
#[pyclass(frozen, module = "chordal._chordal")]
pub struct Stock {
    found: StockReport,
    json: String,
}

impl Stock {
    pub fn new(found: StockReport, name: &str) -> Stock {
        let json = stock_json(&found, name);
        Stock { found, json }
    }
}

/// X, Y and Z, mm.
type StockPoint = (f64, f64, f64);

fn point(at: Vec3) -> StockPoint {
    (at.x, at.y, at.z)
}

#[pymethods]
impl Stock {
    /// The object of `chordal stock --format json`.
    #[getter]
    fn json(&self) -> &str {
        &self.json
    }

    /// Columns along X and Y.
    #[getter]
    fn shape(&self) -> (u32, u32) {
        let [columns, rows] = self.found.stock.grid().cells();
        (columns, rows)
    }

    /// The least and the largest corner of the stock's box, mm.
    #[getter]
    fn bounds(&self) -> (StockPoint, StockPoint) {
        let bounds = self.found.stock.grid().bounds();
        (point(bounds.min), point(bounds.max))
    }

    /// The least and the largest height of each column, mm: row by row from the least Y on, in each by X.
    fn heights(&self, py: Python<'_>) -> PyResult<NumberBuffer> {
        py.detach(|| {
            let bottom = self.found.stock.grid().bounds().min.z;
            let pairs = self.found.stock.height_pairs();
            let pair = pairs.iter().map(|pair| [pair.inner.max(bottom), pair.outer.max(bottom)]);
            rows(pair.collect())
        })
    }

    /// Vertices and triangles of what is left; heights that differ by no more than the tolerance are one face, mm.
    fn mesh(&self, py: Python<'_>, tolerance_mm: f64) -> PyResult<(NumberBuffer, NumberBuffer)> {
        let mesh = py.detach(|| self.found.surface(tolerance_mm));
        let mesh = mesh.map_err(|wrong| coarser(py, &wrong.to_string()))?.mesh;
        let vertices = mesh.vertices().iter().map(|vertex| vertex.to_array()).collect();
        Ok((rows(vertices)?, indices(mesh.triangles().to_vec())?))
    }

    /// The bytes of a mesh file, by its ending, or of a picture (`png`); smooth within so much, mm, or in steps.
    #[pyo3(signature = (ending, tolerance_mm, smooth_mm, name))]
    fn file<'py>(
        &self,
        py: Python<'py>,
        ending: &str,
        tolerance_mm: f64,
        smooth_mm: Option<f64>,
        name: &str,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let format = STOCK_FILES.named(ending).ok_or_else(|| {
            let help = format!("formats are {}", STOCK_FILES.names());
            error::usage(py, &format!("there is no format `{ending}`"), Some(&help))
        })?;
        if let Some(smooth) = smooth_mm.filter(|smooth| !(smooth.is_finite() && *smooth >= 0.0)) {
            let message = format!("smooth is {smooth}, and must be a length of 0 mm or more");
            return Err(error::usage(py, &message, Some("leave it out for a mesh in steps")));
        }
        let surface = smooth_mm.map_or(MeshSurface::Steps(tolerance_mm), MeshSurface::Smooth);
        let bytes = py.detach(|| match format {
            OutputFormat::Png => stock_png(&self.found).map_err(|error| error.to_string()),
            mesh => stock_mesh(&self.found, mesh, surface, name).map_err(|error| error.to_string()),
        });
        Ok(PyBytes::new(py, &bytes.map_err(|message| coarser(py, &message))?))
    }
}

fn coarser(py: Python<'_>, message: &str) -> PyErr {
    error::usage(py, message, Some("use a larger resolution"))
}

/// Why there is no run on stock, as the exception that says the same.
pub fn refused(py: Python<'_>, wrong: &StockRunError) -> PyErr {
    let help = match wrong {
        StockRunError::NoStock | StockRunError::StockNotPlaced(_) => {
            "give `[stock]` in the setup or machine"
        }
        StockRunError::Setup(setup) => setup.help.as_str(),
        StockRunError::Stock(_) => "choose a larger resolution_mm, or more memory",
        StockRunError::Turns => "`chordal stock` answers for lathes",
        StockRunError::Interrupted => "run it again",
    };
    let message = match wrong {
        StockRunError::Setup(setup) => setup.message.clone(),
        other => other.to_string(),
    };
    error::usage(py, &message, Some(help))
}
