//! What is left as a closed mesh: STL, 3MF, GLB.

use chordal::stock::StockReport;
use chordal::stock::mesh::{HeightField, HeightFieldError, HeightMesh, LengthUnit, write};

/// Columns that touch in an upright edge are parted by this share of a cell in STL, which shares no vertices.
const GAP: f64 = 1e-3;

/// A file format of meshes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MeshFormat {
    /// Triangles in millimetres, which the file does not say.
    Stl,
    /// 3D Manufacturing Format, millimetres.
    ThreeMf,
    /// glTF in one file: metres, Y up.
    Glb,
}

/// Why there is no mesh.
#[derive(Debug, thiserror::Error)]
pub enum StockMeshError {
    /// The columns make no surface.
    #[error(transparent)]
    Columns(#[from] HeightFieldError),
    /// The format has no room for it.
    #[error(transparent)]
    Write(#[from] write::WriteError),
}

/// The stock that is left: the middle between the two bounds of each column; columns whose heights differ by no
/// more than `tolerance_mm` are joined.
///
/// # Errors
/// When there are too many columns for one mesh.
pub fn stock_mesh(
    found: &StockReport,
    format: MeshFormat,
    tolerance_mm: f64,
    name: &str,
) -> Result<Vec<u8>, StockMeshError> {
    let surface = stock_surface(found, tolerance_mm)?;
    Ok(match format {
        MeshFormat::Stl => {
            let gap = GAP * found.stock.grid().resolution();
            write::write_stl(&surface.parted(gap), LengthUnit::Millimetre)?
        }
        MeshFormat::ThreeMf => write::write_threemf(&surface.mesh, name)?,
        MeshFormat::Glb => write::write_glb(&surface.mesh, name, None)?,
    })
}

/// The same as a closed surface.
///
/// # Errors
/// As [`stock_mesh`].
pub fn stock_surface(
    found: &StockReport,
    tolerance_mm: f64,
) -> Result<HeightMesh, HeightFieldError> {
    let grid = found.stock.grid();
    let bounds = grid.bounds();
    let [columns, rows] = grid.cells().map(|cells| cells as usize);
    let middle = |outer: f64, inner: f64| (0.5 * (outer + inner) - bounds.min.z).max(0.0) as f32;
    let heights: Vec<f32> = found
        .stock
        .height_pairs()
        .iter()
        .map(|pair| middle(pair.outer, pair.inner.max(bounds.min.z)))
        .collect();
    let field = HeightField {
        origin: bounds.min,
        cell: grid.resolution(),
        columns,
        rows,
        heights: &heights,
        floor: 0.0,
    };
    field.mesh(tolerance_mm)
}
