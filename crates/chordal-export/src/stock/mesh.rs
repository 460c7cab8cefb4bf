//! What is left as a closed mesh: STL, 3MF, GLB.

use chordal::stock::StockReport;
use chordal::stock::mesh::{HeightField, HeightFieldError, LengthUnit, Mesh, SmoothError, write};

use crate::format::OutputFormat;

/// Columns that touch in an upright edge are parted by this share of a cell in STL, which shares no vertices.
const EDGE_GAP_SHARE: f64 = 1e-3;

/// Why there is no mesh.
#[derive(Debug, thiserror::Error)]
pub enum StockMeshError {
    /// The columns make no surface.
    #[error(transparent)]
    Columns(#[from] HeightFieldError),
    /// They make no smooth one.
    #[error(transparent)]
    Smooth(#[from] SmoothError),
    /// Heights alone do not say what is left.
    #[error(
        "a smooth mesh has no undersides, and the part has some: undercuts, hollows or cuts from other sides"
    )]
    Undersides,
    /// The format has no room for it.
    #[error(transparent)]
    Write(#[from] write::WriteError),
    /// It is none of meshes.
    #[error("{0} is no format of meshes")]
    Format(&'static str),
}

/// How columns become a surface.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum MeshSurface {
    /// Flat tops and upright walls. Columns are joined to tops that are no further from them than this, mm; the volume
    /// is theirs.
    Steps(f64),
    /// Through the middles of the columns, no further from them than this along Z, mm; walls are as wide as a column.
    Smooth(f64),
}

/// The stock that is left: what is in the middle of each column.
///
/// # Errors
/// When there are too many columns for one mesh.
pub fn stock_mesh(
    found: &StockReport,
    format: OutputFormat,
    surface: MeshSurface,
    name: &str,
) -> Result<Vec<u8>, StockMeshError> {
    let mesh = match surface {
        MeshSurface::Steps(tolerance) => {
            let steps = found.surface(tolerance)?;
            match format {
                OutputFormat::Stl => steps.parted(EDGE_GAP_SHARE * found.stock.grid().resolution()),
                _ => steps.mesh,
            }
        }
        MeshSurface::Smooth(_) if found.has_undersides() => return Err(StockMeshError::Undersides),
        MeshSurface::Smooth(tolerance) => smooth(found, tolerance)?,
    };
    mesh_file(&mesh, format, name)
}

/// A mesh as the bytes of a file: STL in millimetres, which the file does not say, 3MF in millimetres, or glTF in one
/// file, in metres with Y up.
pub(super) fn mesh_file(
    mesh: &Mesh,
    format: OutputFormat,
    name: &str,
) -> Result<Vec<u8>, StockMeshError> {
    Ok(match format {
        OutputFormat::Stl => write::write_stl(mesh, LengthUnit::Millimetre)?,
        OutputFormat::ThreeMf => write::write_threemf(mesh, name)?,
        OutputFormat::Glb => write::write_glb(mesh, name, None)?,
        other => return Err(StockMeshError::Format(other.name())),
    })
}

/// The surface through the middles of columns, whose heights say all of what is left.
fn smooth(found: &StockReport, tolerance: f64) -> Result<Mesh, SmoothError> {
    let grid = found.stock.grid();
    let bounds = grid.bounds();
    let [columns, rows] = grid.cells().map(|cells| cells as usize);
    let heights: Vec<f32> =
        found.tops().iter().map(|top| (top - bounds.min.z).max(0.0) as f32).collect();
    let field = HeightField {
        origin: bounds.min,
        cell: grid.resolution(),
        columns,
        rows,
        size: [bounds.size().x, bounds.size().y],
        heights: &heights,
        floor: 0.0,
    };
    field.smooth(tolerance)
}
