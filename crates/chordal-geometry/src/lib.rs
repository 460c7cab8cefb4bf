//! The exact curves of machine motion: line, circular arc, helix, Archimedean spiral, cone and spline.
//!
//! A curve stays exact until it is divided into chords, and every tolerance is an argument. Lengths are in millimetres by
//! convention (the crate does not depend on it), angles in radians, all `f64`. The crate is independent of program
//! languages and machines. Results are bit-identical on every platform: transcendental functions come from `libm`, in one
//! module.
//!
//! ```
//! use chordal_geometry::{Arc, ParamCurve, Placement, Plane};
//!
//! // One turn of radius 10 that rises by 3.
//! let helix = Arc::new(Plane::Xy.frame(), 10.0, core::f64::consts::TAU, 3.0);
//! let exact = ((core::f64::consts::TAU * 10.0).powi(2) + 9.0).sqrt();
//! assert!((helix.length() - exact).abs() < 1e-12);
//! assert_eq!(helix.bounds().max.z, 3.0);
//!
//! let corners = helix.chords(0.001, Placement::Balanced)?;
//! assert_eq!(corners.count(), 159);
//! # Ok::<(), chordal_geometry::ChordError>(())
//! ```
//!
//! | to | see |
//! |---|---|
//! | get points, lengths, curvature, boxes and parts of a curve | [`ParamCurve`] |
//! | evaluate it at many points | [`Tracer`] |
//! | make a spline, divide it into its spans | [`Spline`], [`SplinePiece`] |
//! | make a curve from an arc command | [`arc_from_center`], [`spiral_from_center`], [`center_from_radius`] |
//! | divide it into chords | [`ParamCurve::chords`], [`Chords`] |
//! | fit lines and arcs to points, reduce points | [`fit_path`], [`simplify`] |
//! | know how far two convex solids are apart, or how deep one is in the other | [`ConvexSolid`], [`solid_distance`], [`solid_depth`] |
//! | intersect and offset | [`line_line`], [`line_circle`], [`circle_circle`], [`Line::offset`], [`Arc::offset`] |

#![forbid(unsafe_code)]

mod aabb;
mod arc;
mod axes;
mod bezier;
mod bspline;
mod chords;
mod convex;
mod convex_depth;
mod curve;
mod fit;
mod fitting;
mod frame;
mod growth;
mod intersect;
mod line;
mod math;
mod offset;
mod param_curve;
mod plane;
mod quadrature;
mod solve;
mod spiral;
mod spline_piece;
mod spline_run;
pub mod tolerance;
mod tracer;
mod transform;
mod vec2;
mod vec3;
mod winding;
mod winding_search;

pub use aabb::Aabb;
pub use arc::{Arc, Derivatives};
pub use axes::{AXES, AXIS_LETTERS, AXIS_NAMES, PerAxis};
pub use bspline::{Spline, SplineError};
pub use chords::{ChordError, Chords, MAX_CHORDS, Placement, chords_in_whole};
pub use convex::{ConvexSolid, PlacedSolid, SolidDistance, SolidError, solid_distance};
pub use convex_depth::{DepthBounds, solid_depth};
pub use curve::Curve;
pub use fit::{
    ArcFit, ArcSweep, HalfCircleTolerance, RadiusError, arc_from_center, arc_sweep,
    center_from_radius, spiral_from_center,
};
pub use fitting::{FitError, FitMeasure, FitOptions, FitPiece, breaks, fit_path, simplify};
pub use frame::Frame;
pub use intersect::{
    Circle2, Line2, LineCrossing, Meeting, circle_circle, fractions_at_angle, line_circle,
    line_line,
};
pub use line::Line;
pub use param_curve::{Nearest, ParamCurve};
pub use plane::{Plane, TurnDirection};
pub use spiral::Spiral;
pub use spline_piece::{EvenPart, SplinePiece};
pub use tracer::Tracer;
pub use transform::Transform;
pub use vec2::Vec2;
pub use vec3::Vec3;
