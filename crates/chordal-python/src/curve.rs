//! The exact curves, alone.

use chordal::geometry::{
    Arc, Curve as Exact, Frame, HalfCircleTolerance, Line, ParamCurve, Placement, Plane, Spiral,
    TurnDirection, Vec3, arc_from_center as fit, center_from_radius,
};
use pyo3::prelude::*;

use crate::error;
use crate::table::{NumberBuffer, rows};

type PyPoint = [f64; 3];

/// A line, an arc, a helix, a spiral or a curve on a cone. It never changes.
#[pyclass(frozen, module = "chordal.geometry", from_py_object)]
#[derive(Clone, Copy)]
pub struct Curve(pub Exact);

/// A straight line between two points.
#[pyfunction]
pub fn line(start: PyPoint, end: PyPoint) -> PyResult<Curve> {
    finite(&[start, end])?;
    Ok(Curve(Exact::Line(Line::new(Vec3::from_array(start), Vec3::from_array(end)))))
}

/// The curve from start to end about a centre, given in the plane's own two coordinates.
#[pyfunction]
#[pyo3(signature = (start, end, center, *, plane, clockwise, extra_turns, radius_tolerance))]
pub fn arc_from_center(
    start: PyPoint,
    end: PyPoint,
    center: (f64, f64),
    plane: &str,
    clockwise: bool,
    extra_turns: u32,
    radius_tolerance: f64,
) -> PyResult<Curve> {
    finite(&[start, end, [center.0, center.1, 0.0]])?;
    let (start, end) = (Vec3::from_array(start), Vec3::from_array(end));
    let direction = direction(clockwise);
    let plane = plane_of(plane)?;
    Ok(Curve(fit(plane, start, end, center, direction, extra_turns, radius_tolerance).curve))
}

/// The arc from start to end with a radius: below zero for the one of more than half a turn.
#[pyfunction]
#[pyo3(signature = (start, end, radius, *, plane, clockwise, midpoint_tolerance))]
pub fn arc_from_radius(
    start: PyPoint,
    end: PyPoint,
    radius: f64,
    plane: &str,
    clockwise: bool,
    midpoint_tolerance: f64,
) -> PyResult<Curve> {
    finite(&[start, end])?;
    let (start, end) = (Vec3::from_array(start), Vec3::from_array(end));
    let (plane, direction) = (plane_of(plane)?, direction(clockwise));
    let center = center_from_radius(
        plane,
        start,
        end,
        radius,
        direction,
        HalfCircleTolerance::either(midpoint_tolerance),
    )
    .map_err(error::value)?;
    let tolerance = midpoint_tolerance + 1e-9 * radius.abs();
    Ok(Curve(fit(plane, start, end, center, direction, 0, tolerance).curve))
}

/// The arc of less than one turn through three points.
#[pyfunction]
pub fn arc_through(start: PyPoint, via: PyPoint, end: PyPoint) -> PyResult<Curve> {
    finite(&[start, via, end])?;
    let [start, via, end] = [start, via, end].map(Vec3::from_array);
    let arc = Arc::through(start, via, end);
    let none = || error::value("the three points lie on a line, or two of them are the same");
    arc.map(|arc| Curve(Exact::Arc(arc))).ok_or_else(none)
}

/// A spiral that begins at `radius_from` along `towards` from the centre, turns about the normal
/// and rises along it.
#[pyfunction]
#[pyo3(signature = (center, radius_from, radius_to, sweep, *, rise, normal, towards))]
pub fn spiral(
    center: PyPoint,
    radius_from: f64,
    radius_to: f64,
    sweep: f64,
    rise: f64,
    normal: PyPoint,
    towards: PyPoint,
) -> PyResult<Curve> {
    finite(&[center, normal, towards, [radius_from, radius_to, sweep], [rise, 0.0, 0.0]])?;
    if radius_from < 0.0 || radius_to < 0.0 {
        return Err(error::value(format!(
            "radii of {radius_from} and {radius_to} mm: a radius must not be below zero"
        )));
    }
    let [center, normal, towards] = [center, normal, towards].map(Vec3::from_array);
    let none = || error::value("`normal` and `towards` are parallel, or one of them is zero");
    let frame = Frame::from_normal(center, normal, towards).ok_or_else(none)?;
    Ok(Curve(if radius_from == radius_to {
        Exact::Arc(Arc::new(frame, radius_from, sweep, rise))
    } else {
        Exact::Spiral(Spiral::new(frame, (radius_from, radius_to), sweep, rise))
    }))
}

fn direction(clockwise: bool) -> TurnDirection {
    if clockwise { TurnDirection::Cw } else { TurnDirection::Ccw }
}

fn plane_of(word: &str) -> PyResult<Plane> {
    match word {
        "xy" => Ok(Plane::Xy),
        "zx" => Ok(Plane::Zx),
        "yz" => Ok(Plane::Yz),
        other => Err(error::value(format!("there is no plane `{other}`: write xy, zx or yz"))),
    }
}

fn finite(points: &[PyPoint]) -> PyResult<()> {
    match points.iter().flatten().find(|value| !value.is_finite()) {
        Some(value) => Err(error::value(format!("{value} is not a finite number"))),
        None => Ok(()),
    }
}

#[pymethods]
impl Curve {
    /// `line`, `arc`, `spiral` or `spline`.
    #[getter]
    fn kind(&self) -> &'static str {
        match self.0 {
            Exact::Line(_) => "line",
            Exact::Arc(_) => "arc",
            Exact::Spiral(_) => "spiral",
            Exact::Spline(_) => "spline",
        }
    }

    /// Where it begins, mm.
    #[getter]
    fn start(&self) -> (f64, f64, f64) {
        self.0.start().to_array().into()
    }

    /// Where it ends, mm.
    #[getter]
    fn end(&self) -> (f64, f64, f64) {
        self.0.end().to_array().into()
    }

    /// Its length, mm.
    #[getter]
    fn length(&self) -> f64 {
        self.0.length()
    }

    /// Its largest curvature, 1/mm.
    #[getter]
    fn max_curvature(&self) -> f64 {
        self.0.max_curvature()
    }

    /// Its centre at the height of the start, mm; `None` for a line and a spline.
    #[getter]
    fn center(&self) -> Option<(f64, f64, f64)> {
        match self.0 {
            Exact::Line(_) | Exact::Spline(_) => None,
            Exact::Arc(arc) => Some(arc.center.to_array().into()),
            Exact::Spiral(spiral) => Some(spiral.center.to_array().into()),
        }
    }

    /// Its radii at start and end, mm; `None` for a line and a spline.
    #[getter]
    fn radii(&self) -> Option<(f64, f64)> {
        match self.0 {
            Exact::Line(_) | Exact::Spline(_) => None,
            Exact::Arc(arc) => Some((arc.radius, arc.radius)),
            Exact::Spiral(spiral) => Some((spiral.radius_start, spiral.radius_end)),
        }
    }

    /// The angle that it turns, rad, counter-clockwise above zero; 0 for a line and a spline.
    #[getter]
    fn sweep(&self) -> f64 {
        match self.0 {
            Exact::Line(_) | Exact::Spline(_) => 0.0,
            Exact::Arc(arc) => arc.sweep,
            Exact::Spiral(spiral) => spiral.sweep,
        }
    }

    /// The corners of the smallest box around it, mm.
    #[getter]
    fn bounds(&self) -> ((f64, f64, f64), (f64, f64, f64)) {
        let bounds = self.0.bounds();
        (bounds.min.to_array().into(), bounds.max.to_array().into())
    }

    /// The points at these arc lengths, mm.
    fn points(&self, py: Python<'_>, s: Vec<f64>) -> PyResult<NumberBuffer> {
        py.detach(|| rows(s.iter().map(|s| self.0.point_at(*s).to_array()).collect()))
    }

    /// The unit vectors of travel at these arc lengths.
    fn tangents(&self, py: Python<'_>, s: Vec<f64>) -> PyResult<NumberBuffer> {
        py.detach(|| rows(s.iter().map(|s| self.0.tangent_at(*s).to_array()).collect()))
    }

    /// The curvature vectors at these arc lengths, 1/mm.
    fn curvatures(&self, py: Python<'_>, s: Vec<f64>) -> PyResult<NumberBuffer> {
        py.detach(|| rows(s.iter().map(|s| self.0.curvature_at(*s).to_array()).collect()))
    }

    /// The corners of chords within a tolerance, mm.
    fn chords(&self, py: Python<'_>, tolerance: f64, balanced: bool) -> PyResult<NumberBuffer> {
        let placement = if balanced { Placement::Balanced } else { Placement::Inscribed };
        py.detach(|| {
            let chords = self.0.chords(tolerance, placement).map_err(error::value)?;
            // As many as memory may hold: a curve is a piece of a path.
            const MAX_POINTS: u64 = 1 << 28;
            if chords.chord_count() > MAX_POINTS {
                let count = chords.chord_count();
                return Err(error::value(format!(
                    "{count} chords would be needed; the limit is {MAX_POINTS}"
                )));
            }
            rows(chords.map(Vec3::to_array).collect())
        })
    }

    /// The nearest point to a point: its arc length, itself, and its distance, mm.
    fn nearest(&self, point: PyPoint) -> PyResult<(f64, (f64, f64, f64), f64)> {
        finite(&[point])?;
        let nearest = self.0.nearest(Vec3::from_array(point));
        Ok((nearest.s, nearest.point.to_array().into(), nearest.distance))
    }

    /// The part before an arc length and the part after it.
    fn split(&self, s: f64) -> (Curve, Curve) {
        let (before, after) = self.0.split_at(s);
        (Curve(before), Curve(after))
    }

    /// The same points from the end to the start.
    fn reversed(&self) -> Curve {
        Curve(self.0.reversed())
    }

    fn __eq__(&self, other: &Curve) -> bool {
        self.0 == other.0
    }

    fn __repr__(&self) -> String {
        let [a, b] = [self.0.start(), self.0.end()];
        format!(
            "<Curve {} from ({}, {}, {}) to ({}, {}, {}), {} mm>",
            self.kind(),
            a.x,
            a.y,
            a.z,
            b.x,
            b.y,
            b.z,
            self.0.length()
        )
    }
}
