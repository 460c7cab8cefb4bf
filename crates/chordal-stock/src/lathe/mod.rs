//! Turned stock: exact regions of the half plane, and what lathe tools remove from them.
//!
//! The half section of a turned body is a region of points (z, r): z along the axis, r the distance from it. A point
//! is a [`Vec2`](chordal_geometry::Vec2) whose `a` is z and whose `b` is r. All lengths are in millimetres; areas are
//! those of the half section, volumes those of the body. Regions are always bounded by lines and arcs: what an
//! outline of lines and arcs sweeps along lines and arcs is bounded by lines and arcs, too.
//!
//! | to | see |
//! |---|---|
//! | say what the stock is, measure, combine, draw it | [`Region`] |
//! | say what a tool is | [`Insert`], [`Blade`], [`ToolOutline`] |
//! | cut, and learn what went | [`LatheStock::cut`], [`TurnedPass`] |
//! | ask whether a rapid, a holder or a shank touches | [`LatheStock::touch`] |
//! | ask for radii, walls, grooves, a neck, loose parts | [`Region::radii_at`], [`Region::spans_at`], [`Region::neck`], [`Region::bodies`] |
//!
//! A pass is a boolean operation on exact curves. Crossings divide edges, points within 1e-11 of the size become one
//! vertex, coincident pieces are merged, winding numbers on both sides of a piece decide whether it bounds the
//! result, and loops are joined by vertex numbers, never by coordinates. Each operation is checked: area(A−B) +
//! area(A∩B) = area(A) within 1e-9 of it. Where the check fails, the sweep is shifted by 1e-7 of the size;
//! [`TurnedPass::bound`] gives the error. Only edges near the sweep are examined.
//!
//! | question about a program | answer |
//! |---|---|
//! | does a rapid touch the stock, and how deep? | [`LatheStock::touch`] along it: [`TurnedPass::touched`], [`TurnedPass::depth`], [`TurnedPass::place`] |
//! | is the holder in the shoulder? | the same with [`ToolOutline::polygon`] |
//! | what is in the cut at a place, what is the chip of one revolution? | the same without a move, or moved on by the feed: [`TurnedPass::area`] |
//! | is a wall left between grooves, is a groove wider than its blade? | [`Region::spans_at`] below the surface |
//! | is the part cut off, or does a pip hold it? | [`Region::neck`] over the range of the blade, [`Region::bodies`] |
//! | is the half section in a drawing? | [`read_dxf`] |
//! | what is left, what is gouged? | [`Region::difference`] with the target, both ways |
//!
//! Threads and driven tools do not leave a body of revolution, so they are not covered here.
//!
//! ```
//! use chordal_geometry::Vec2;
//! use chordal_stock::lathe::{Insert, Region, OutlineSegment, Tip, LatheStock};
//!
//! // Diameter 50 to 40 over 30 mm, with an ideal point.
//! let mut stock = LatheStock::new(&Region::bar(25.0, -60.0, 0.0)?);
//! let tool = Insert::ideal_point(Tip::new(3)?, 40.0)?.outline()?;
//! let pass = stock.cut(&tool, &OutlineSegment::line(Vec2::new(2.0, 20.0), Vec2::new(-30.0, 20.0)))?;
//! assert!((pass.volume - 6750.0 * core::f64::consts::PI).abs() < 1e-9);
//! assert_eq!((pass.across, pass.along), (5.0, 30.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arrange;
mod convex;
mod crossing;
mod dxf;
mod edge;
mod hull;
mod loops;
mod overlay;
mod polygon;
mod questions;
mod region;
mod segment;
mod stock;
mod store;
mod sweep;
mod tool;
mod weld;

pub use dxf::{DxfError, read_dxf};
pub use overlay::OverlayError;
pub use questions::PlaceSide;
pub use region::{CombinedRegion, Region, RegionError};
pub use segment::{OutlineSegment, SegmentArc};
pub use stock::{LatheStock, PassError, TurnedPass};
pub use tool::{Blade, BladeFacing, BladePoint, Insert, InsertShape, Tip, ToolError, ToolOutline};
