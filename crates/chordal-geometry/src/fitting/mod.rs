//! From points back to curves: lines and arcs through a row of points within a tolerance, and the
//! same path in fewer chords.
//!
//! The distance is that of Fréchet between the new path and the chords of the old: two who walk along
//! them from end to end without going back are nowhere further apart. It is computed for every piece
//! that is handed out, by a walk that is one such way to go, so it is a bound and not a sample.

mod band;
mod deviation;
mod flat;
mod reach;
mod relax;
mod row;
mod sections;
mod simplify;
mod smooth;

use crate::{Curve, Plane, Vec3, math};

pub use simplify::simplify;

/// What the distance of a fitted path is measured from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FitMeasure {
    /// From the chords between the points: the path as it was written.
    #[default]
    Chords,
    /// From the points alone, in their order: for points that lie on the curve that is meant.
    Points,
}

/// How arcs and lines are laid through points.
#[derive(Clone, Copy, Debug)]
pub struct FitOptions {
    /// Largest distance of the new path from the old one, mm.
    pub tolerance: f64,
    /// What it is measured from.
    pub measure: FitMeasure,
    /// Turns of the path by more than this, radians, are corners: they stay where they are.
    pub corner: f64,
    /// The plane of arcs; without it, whichever of the three the points lie in, and XY for helices.
    pub plane: Option<Plane>,
    /// Pieces meet in one direction where the path has no corner.
    pub tangent: bool,
    /// Arcs of a larger radius are lines, mm.
    pub max_radius: f64,
}

impl FitOptions {
    /// Tangent arcs in any plane within `tolerance` (mm) of the chords; turns of more than 20° are
    /// corners.
    #[must_use]
    pub fn within(tolerance: f64) -> FitOptions {
        FitOptions {
            tolerance,
            measure: FitMeasure::Chords,
            corner: math::PI / 9.0,
            plane: None,
            tangent: true,
            max_radius: 10_000.0,
        }
    }
}

/// A line or an arc that stands for a part of the points.
#[derive(Clone, Copy, Debug)]
pub struct FitPiece {
    /// The curve; it begins exactly where the one before ends.
    pub curve: Curve,
    /// The plane of an arc.
    pub plane: Plane,
    /// From which to which point it goes; with a fraction where an end lies between two.
    pub span: [f64; 2],
    /// It is nowhere further from that part, mm.
    pub deviation: f64,
}

/// Why points cannot be fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FitError {
    /// The tolerance is not a number above zero.
    Tolerance(f64),
    /// This point, counted from 0, is no point.
    NotFinite(usize),
}

impl core::fmt::Display for FitError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            FitError::Tolerance(value) => {
                write!(f, "the tolerance must be above zero, not {value}")
            }
            FitError::NotFinite(index) => {
                write!(f, "point {index} has a coordinate that is NaN or infinite")
            }
        }
    }
}

impl core::error::Error for FitError {}

/// Lines and arcs along `points` (mm), few of them: on smooth curves about as many as any path of
/// arcs without gaps needs, ∫(|κ′|/(72√3·e))^⅓ ds.
///
/// Chords too long for an arc within the tolerance stay lines with their ends. Where `tangent` is
/// asked and cannot be had within the tolerance, two pieces meet at an angle; [`breaks`] says where.
/// A path that ends where it begins, without a corner there, is tangent there, too.
/// Points that repeat the one before count for nothing; fewer than two others give no piece.
///
/// ```
/// use chordal_geometry::{Arc, Curve, FitOptions, ParamCurve, Placement, Plane, Vec3, fit_path};
///
/// let circle = Arc::new(Plane::Xy.frame(), 10.0, core::f64::consts::PI, 0.0);
/// let points: Vec<Vec3> = circle.chords(0.001, Placement::Inscribed)?.collect();
/// let pieces = fit_path(&points, &FitOptions::within(0.001))?;
/// assert!(matches!(pieces[..], [one] if matches!(one.curve, Curve::Arc(_))));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
///
/// # Errors
/// See [`FitError`].
pub fn fit_path(points: &[Vec3], options: &FitOptions) -> Result<Vec<FitPiece>, FitError> {
    let points = DistinctPoints::of(points, options.tolerance)?;
    let mut pieces = Vec::new();
    sections::fit(&points.at, options, &mut pieces);
    for piece in &mut pieces {
        piece.span = piece.span.map(|at| points.place(at));
    }
    Ok(pieces)
}

/// The angles, radians, by which the direction steps where pieces meet, with the number of the piece
/// behind. Steps above `corner` (radians) are the corners of the path.
pub fn breaks(pieces: &[FitPiece]) -> impl Iterator<Item = (usize, f64)> + '_ {
    use crate::ParamCurve;
    pieces.windows(2).enumerate().map(|(index, pair)| {
        let (before, after) = (pair[0].curve, pair[1].curve);
        let (a, b) = (before.tangent_at(before.length()), after.tangent_at(0.0));
        (index + 1, math::atan2(a.cross(b).length(), a.dot(b)))
    })
}

/// Points without those that repeat the one before.
struct DistinctPoints {
    at: Vec<Vec3>,
    /// Which point of those given it is.
    index: Vec<usize>,
}

impl DistinctPoints {
    fn of(points: &[Vec3], tolerance: f64) -> Result<DistinctPoints, FitError> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(FitError::Tolerance(tolerance));
        }
        let mut kept = DistinctPoints { at: Vec::with_capacity(points.len()), index: Vec::new() };
        for (index, point) in points.iter().enumerate() {
            if !point.is_finite() {
                return Err(FitError::NotFinite(index));
            }
            if kept.at.last() != Some(point) {
                kept.at.push(*point);
                kept.index.push(index);
            }
        }
        Ok(kept)
    }

    /// A place among the points kept, as one among those given.
    fn place(&self, at: f64) -> f64 {
        let whole = (at as usize).min(self.index.len() - 1);
        let (here, fraction) = (self.index[whole] as f64, at - whole as f64);
        match self.index.get(whole + 1) {
            // The chord leads from the last of the points that are one.
            Some(next) if fraction > 0.0 => (*next as f64 - 1.0) + fraction,
            _ => here,
        }
    }
}
