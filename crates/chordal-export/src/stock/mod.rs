//! What a run on stock answers: text, JSON, a shaded picture, meshes.

mod engagement;
mod json;
mod lathe;
mod mesh;
#[cfg(feature = "pictures")]
mod picture;
mod text;

pub use engagement::{engagement_json, engagement_text};
pub use json::stock_json;
pub use lathe::{
    section_dxf, turned_json, turned_mesh, turned_text, turned_verdict_text, turning_json,
    turning_text,
};
pub use mesh::{MeshSurface, StockMeshError, stock_mesh};
#[cfg(feature = "pictures")]
pub use picture::stock_png;
pub use text::{stock_text, stock_verdict_text, stock_volume};

use chordal::stock::StockLeft;
use serde_json::{Map, Value};

/// The answer for people, of a mill or of a lathe; the problems are printed apart.
pub fn stock_left_text(left: &StockLeft) -> String {
    match left {
        StockLeft::Columns(found) => stock_text(found),
        StockLeft::Section(found) => turned_text(found),
    }
}

/// The members of its object in schema `chordal.stock/1` but for schema and file.
pub(crate) fn left_members(left: &StockLeft) -> Map<String, Value> {
    match left {
        StockLeft::Columns(found) => json::stock_members(found),
        StockLeft::Section(found) => lathe::turned_members(found),
    }
}
