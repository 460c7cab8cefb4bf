//! What a run on stock answers: text, JSON, a shaded picture, meshes.

mod engagement;
mod json;
mod mesh;
mod picture;
mod text;

pub use engagement::{engagement_json, engagement_text};
pub use json::stock_json;
pub(crate) use json::stock_members;
pub use mesh::{MeshFormat, MeshSurface, StockMeshError, stock_mesh, stock_surface};
pub use picture::stock_png;
pub use text::{stock_text, stock_verdict_text, stock_volume};
