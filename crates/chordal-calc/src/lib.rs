//! The mathematics of the shop: cutter offsets at corners, arcs, chords, holes on a circle, speeds and
//! feeds, threads, and programs that mill threads.
//!
//! Numbers in, a [`Worked`] result out: every formula as it stands in the books, the same with
//! the numbers put in, what comes out, and a [`Figure`] as plain data. Lengths are millimetres and
//! angles radians; [`Units`] says in which unit the texts speak. What cannot be is a
//! [`CalcError`] with the numbers that contradict each other.
//!
//! ```
//! use chordal_calc::{Axis, Bend, LineAxis, Units, corner_with_axis};
//!
//! // A line that leaves the Y axis by 60 degrees, and a cutter of half an inch.
//! let ask = LineAxis {
//!     cutter_radius: 6.35,
//!     angle: 60f64.to_radians(),
//!     axis: Axis::Y,
//!     bend: Bend::Outside,
//!     rise: None,
//! };
//! let worked = corner_with_axis(&ask, Units::Inch).unwrap();
//! assert!((worked.value("ΔY").unwrap() / 25.4 - 0.144).abs() < 0.0005);
//! ```

#![forbid(unsafe_code)]

mod arc_arc;
mod arc_points;
mod bolt_circle;
mod chords;
mod corner;
mod cutting;
mod error;
mod figure;
mod line_arc;
mod math;
mod mill;
mod numbers;
mod post;
mod tangent;
mod tap_drill;
mod thread;
mod worked;

pub use arc_arc::{ArcArc, arc_with_arc};
pub use arc_points::{ArcPoints, arc_points};
pub use bolt_circle::{BoltCircle, bolt_circle};
pub use chords::{ChordCount, chord_count};
pub use corner::{Axis, Bend, LineAxis, Side, TwoLines, corner_of_lines, corner_with_axis};
pub use cutting::{Cutting, EdgeSpeed, ToolFeed, cutting};
pub use error::CalcError;
pub use figure::{Figure, Mark, Style};
pub use line_arc::{LineArc, line_with_arc};
pub use mill::{Cut, Cutter, MillProgram, Ramp, ThreadMill, thread_mill};
pub use numbers::Units;
pub use tangent::{Tangent, tangent_point};
pub use tap_drill::{TapDrill, tap_drill};
pub use thread::{Class, Designation, Form, Hand, Thread, Where, Zone, named_thread, thread_data};
pub use worked::{Kind, Quantity, Step, Worked};
