//! Fits lines and arcs to a sequence of points within a tolerance, and simplifies a path to fewer chords.
//!
//! The deviation is the Fréchet distance between the new path and the chords of the old one: there is a matching of their
//! points, monotonic along both, in which no two points are farther apart. It is computed for every piece of the result
//! from one such matching, so it is an upper bound and not an estimate from samples.

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

/// What the deviation of a fitted path is measured from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FitMeasure {
    /// From the chords between the points: the path as it is programmed.
    #[default]
    Chords,
    /// From the points only, in their order: for points on the curve that is meant.
    Points,
}

/// How arcs and lines are fitted to points.
#[derive(Clone, Copy, Debug)]
pub struct FitOptions {
    /// The largest deviation of the new path from the old one, mm.
    pub tolerance: f64,
    /// What the deviation is measured from.
    pub measure: FitMeasure,
    /// Turns of the path by more than this are corners, which stay where they are, rad.
    pub corner: f64,
    /// The plane of arcs; `None` for the one of the three in which the points are, and XY for helices.
    pub plane: Option<Plane>,
    /// Pieces are tangent where the path has no corner.
    pub tangent: bool,
    /// Arcs with a larger radius become lines, mm.
    pub max_radius: f64,
}

impl FitOptions {
    /// Options for tangent arcs in any plane within `tolerance` (mm) of the chords; turns of more than 20° are corners.
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

/// A line or an arc that replaces a range of the points.
#[derive(Clone, Copy, Debug)]
pub struct FitPiece {
    /// The curve; it begins exactly at the end of the one before it.
    pub curve: Curve,
    /// The plane of an arc.
    pub plane: Plane,
    /// The indices of the points from which and to which it goes, with a fraction if an end is between two points.
    pub span: [f64; 2],
    /// An upper bound of its deviation from that range, mm.
    pub deviation: f64,
}

/// Why curves cannot be fitted to points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FitError {
    /// The tolerance is not a finite number above zero.
    Tolerance(f64),
    /// A coordinate of this point, counted from 0, is NaN or infinite.
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

/// Fits few lines and arcs to `points` (mm): on smooth curves about as many as any continuous path of arcs needs,
/// ∫(|κ′|/(72√3·e))^⅓ ds.
///
/// Chords that are too long for an arc within the tolerance stay lines between the same ends. If `tangent` is set but not
/// possible within the tolerance, two pieces meet at an angle, which [`breaks`] finds. A closed path without a corner at
/// its start is tangent there as well. Points equal to the one before them are ignored; fewer than two different points
/// give no pieces.
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

/// The angles between the directions of consecutive pieces, rad, each with the index of the piece after the joint. Angles
/// above [`FitOptions::corner`] are the corners of the path.
pub fn breaks(pieces: &[FitPiece]) -> impl Iterator<Item = (usize, f64)> + '_ {
    use crate::ParamCurve;
    pieces.windows(2).enumerate().map(|(index, pair)| {
        let (before, after) = (pair[0].curve, pair[1].curve);
        let (a, b) = (before.tangent_at(before.length()), after.tangent_at(0.0));
        (index + 1, math::atan2(a.cross(b).length(), a.dot(b)))
    })
}

/// Points without those that are equal to the one before them.
struct DistinctPoints {
    at: Vec<Vec3>,
    /// The index of each point in the input.
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

    /// Converts a position in these points to one in the input.
    fn place(&self, at: f64) -> f64 {
        let whole = (at as usize).min(self.index.len() - 1);
        let (here, fraction) = (self.index[whole] as f64, at - whole as f64);
        match self.index.get(whole + 1) {
            // The chord begins at the last of the equal points.
            Some(next) if fraction > 0.0 => (*next as f64 - 1.0) + fraction,
            _ => here,
        }
    }
}
