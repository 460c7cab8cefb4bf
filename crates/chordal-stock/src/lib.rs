//! What tools remove from stock along exact moves, between two bounds that enclose the truth: what is
//! certainly removed, and what is certainly left.
//!
//! Lengths are in millimetres, angles in radians. The tool axis is Z; a position is that of the tool
//! tip. Turned stock is exact instead: see [`lathe`]. The crate knows no program, no control and no
//! machine, and uses no file and no thread.
//!
//! | to | see |
//! |---|---|
//! | describe a tool: its edges, its shank, its holder | [`cutter`], [`RevolvedBody`] |
//! | describe stock, fixtures and targets, and find what they fill over cells or how far a tool is from them | [`shape`] |
//! | read, check, make and write triangles | [`mesh`] |
//! | remove from stock what a tool sweeps, and measure it | [`columns`], [`ColumnStock::cut`], [`ColumnStock::removed`], [`ColumnStock::left`] |
//! | do so tile by tile on threads | [`ColumnStock::plan`], [`ColumnStock::jobs`] |
//! | find whether a rapid, a shank or a holder touches the stock | [`ColumnStock::touch`], [`ColumnStock::cut_watching`] |
//! | repeat with finer cells what cells cannot decide | [`StockCheck`] |
//! | measure the width, the depth and the chip of a cut | [`engagement`], [`ColumnStock::cut_measuring`] |
//! | remove what a tool sweeps while its direction turns | [`TurningTask`], [`AxialSolid`], [`ToolTurn`] |
//! | find how deep one exact move reaches above a point in plan | [`floor`] |
//! | cut turned stock: exact half sections, volumes, passes | [`lathe`] |
//!
//! ```
//! use chordal_geometry::{Aabb, Line, Vec3};
//! use chordal_stock::{RevolvedBody, CutterProfile, TipMove, ColumnOptions, ColumnStock, TouchAnswer};
//!
//! let bounds = Aabb::of_points(Vec3::new(0.0, 0.0, -20.0), Vec3::new(100.0, 60.0, 0.0));
//! // Cells of 0.2 mm, in at most 100 MB.
//! let mut stock = ColumnStock::new(bounds, ColumnOptions::new(0.2, 100_000_000))?;
//!
//! let slot = Line::new(Vec3::new(-20.0, 30.0, -5.0), Vec3::new(120.0, 30.0, -5.0));
//! let flat = CutterProfile::flat(10.0)?;
//! stock.cut(&flat, &[TipMove { curve: slot.into(), tag: 1 }]);
//! let removed = stock.removed();
//! assert!(removed.least <= 5000.0 && 5000.0 <= removed.most);
//!
//! // A rapid 2 mm below the top, 20 mm beside the slot.
//! let rapid = Line::new(Vec3::new(-20.0, 10.0, -2.0), Vec3::new(120.0, 10.0, -2.0));
//! let found = stock.touch(&RevolvedBody::of_cutter(&flat), &[TipMove { curve: rapid.into(), tag: 0 }]);
//! assert!(matches!(found[0].touch(0.001), TouchAnswer::Hit { least, .. } if least > 1.99));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![forbid(unsafe_code)]

pub mod columns;
pub mod cutter;
pub mod engagement;
pub mod floor;
pub mod lathe;
pub mod mesh;
mod oblique;
pub mod shape;
mod sweep;

pub use columns::{
    CellHeights, CheckedStock, ColumnOptions, ColumnStock, ContactDepth, LoweredColumn, Mode,
    StockCheck, StockError, StockTask, TouchAnswer, TurningTask, VolumeInterval,
};
pub use cutter::{CutterError, CutterProfile, Ring, RingElement, Undercut};
pub use floor::{CutterSweep, LowestPoint, RemovedSpan};
pub use mesh::Mesh;
pub use oblique::{AxialSolid, AxisTurn, ToolTurn};
pub use shape::SolidShape;
pub use sweep::{RevolvedBody, TipMove};
