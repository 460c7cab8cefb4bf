//! The mathematics of the shop: cutter offsets at corners, arcs, chords, holes on a circle, speeds and
//! feeds, threads, and programs that mill threads.
//!
//! Numbers in, a [`WorkedCalculation`] result out: every formula as it stands in the books, the same with
//! the numbers put in, what comes out, and a [`Figure`] as plain data. Lengths are millimetres and
//! angles radians; [`AnswerUnit`] says in which unit the texts speak. What cannot be is a
//! [`CalcError`] with the numbers that contradict each other.
//!
//! ```
//! use chordal_calc::{PlaneAxis, CornerSide, LineAxis, AnswerUnit, corner_with_axis};
//!
//! // A line that leaves the Y axis by 60 degrees, and a cutter of half an inch.
//! let ask = LineAxis {
//!     cutter_radius: 6.35,
//!     angle: 60f64.to_radians(),
//!     axis: PlaneAxis::Y,
//!     bend: CornerSide::Outside,
//!     rise: None,
//! };
//! let worked = corner_with_axis(&ask, AnswerUnit::Inch).unwrap();
//! assert!((worked.value("ΔY").unwrap() / 25.4 - 0.144).abs() < 0.0005);
//! ```

#![forbid(unsafe_code)]

mod arc_arc;
mod arc_points;
mod bolt_circle;
mod calculation;
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

pub use arc_arc::{ArcArc, arc_with_arc};
pub use arc_points::{ArcPoints, arc_points};
pub use bolt_circle::{BoltCircle, bolt_circle};
pub use calculation::{CalculationStep, Quantity, QuantityKind, WorkedCalculation};
pub use chords::{ChordCount, chord_count};
pub use corner::{
    CornerSide, LineAxis, PlaneAxis, TravelSide, TwoLines, corner_of_lines, corner_with_axis,
};
pub use cutting::{CuttingData, EdgeSpeed, ToolFeed, cutting};
pub use error::CalcError;
pub use figure::{Figure, FigureElement, LineStyle};
pub use line_arc::{LineArc, line_with_arc};
pub use mill::{
    MillProgram, MillingDirection, RampSweep, ThreadMill, ThreadMillCutter, thread_mill,
};
pub use numbers::AnswerUnit;
pub use tangent::{TangentTransition, tangent_point};
pub use tap_drill::{TapDrill, tap_drill};
pub use thread::{
    FitClass, ThreadDesignation, ThreadForm, ThreadHand, ThreadLocation, ThreadSize, ToleranceZone,
    named_thread, thread_data,
};
