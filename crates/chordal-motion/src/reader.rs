//! Evaluates a piece: the axes at a point of it and their derivatives by time.

use chordal_geometry::{AXES, Curve, Tracer, Vec3};

use crate::AxisValues;
use crate::piece::{AxisJet, PathPiece, SIXTH, is_even, is_still};
use crate::sample::{AxisState, MotionSample};
use crate::trajectory::ProfilePoint;

/// A view of a piece, whose curve may be stored apart from it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PieceView<'a> {
    /// As in [`PathPiece`]: the base curve, and how far from its start the piece begins.
    pub base: Option<(&'a Curve, f64)>,
    /// As in [`PathPiece`].
    pub start: &'a AxisJet,
    /// As in [`PathPiece`].
    pub tag: u64,
}

impl<'a> From<&'a PathPiece> for PieceView<'a> {
    #[inline(always)]
    fn from(piece: &'a PathPiece) -> PieceView<'a> {
        let base = piece.base.as_ref().map(|(curve, from)| (curve, *from));
        PieceView { base, start: &piece.start, tag: piece.tag }
    }
}

/// What is computed once for a piece that is evaluated at many points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PieceReader {
    form: PolynomialForm,
    /// The base curve, prepared for evaluation; `None` where there is none.
    tracer: Option<Tracer>,
}

/// The degree of the polynomials of a piece.
#[derive(Clone, Copy, Debug)]
enum PolynomialForm {
    /// Constant: the base curve alone moves the axes.
    Still,
    /// Linear.
    Even,
    /// Cubic or quadratic.
    Cubic,
}

impl PolynomialForm {
    #[inline]
    fn of(part: &PieceView<'_>) -> PolynomialForm {
        if !is_even(part.start) {
            PolynomialForm::Cubic
        } else if part.base.is_some() && is_still(part.start) {
            PolynomialForm::Still
        } else {
            PolynomialForm::Even
        }
    }
}

impl PieceReader {
    /// A reader of a piece.
    pub fn new(part: PieceView<'_>) -> PieceReader {
        let tracer = part.base.map(|(curve, _)| Tracer::new(curve));
        PieceReader { form: PolynomialForm::of(&part), tracer }
    }

    /// Changes to the next piece; if it has the same base curve, the prepared curve is kept.
    #[inline]
    pub fn go_on(&mut self, before: PieceView<'_>, next: PieceView<'_>) {
        self.form = PolynomialForm::of(&next);
        if self.tracer.is_some() || next.base.is_some() {
            self.change_curve(before, next);
        }
    }

    fn change_curve(&mut self, before: PieceView<'_>, next: PieceView<'_>) {
        let same = match (&before.base, &next.base) {
            (Some((before, _)), Some((next, _))) => before == next,
            _ => false,
        };
        if !same {
            self.tracer = next.base.map(|(curve, _)| Tracer::new(curve));
        }
    }

    /// Writes the axes and their derivatives at `sigma` from the start of the piece into a sample; its time is not
    /// changed.
    #[inline(always)]
    pub fn fill(
        &mut self,
        part: PieceView<'_>,
        sigma: f64,
        along: &ProfilePoint,
        out: &mut MotionSample,
    ) {
        out.tag = part.tag;
        match self.form {
            // Overwritten below.
            PolynomialForm::Still => {}
            PolynomialForm::Even => fill_even(part.start, sigma, along, out),
            PolynomialForm::Cubic => fill_cubic(part.start, sigma, along, out),
        }
        if let (Some(tracer), Some((_, from))) = (&mut self.tracer, part.base) {
            let ProfilePoint { speed, acceleration, jerk, .. } = *along;
            let by_time = [speed, acceleration, jerk];
            if matches!(self.form, PolynomialForm::Still) {
                let shift = &part.start[0];
                tracer
                    .with_motion_at(from + sigma, by_time, |motion| set_curve(shift, motion, out));
            } else {
                add_curve(tracer.motion_at(from + sigma, by_time), out);
            }
        }
    }
}

/// The axes at one point of a piece.
pub(crate) fn state_of(piece: &PathPiece, sigma: f64, along: &ProfilePoint) -> AxisState {
    let mut sample = MotionSample::default();
    PieceReader::new(piece.into()).fill(piece.into(), sigma, along, &mut sample);
    sample.into()
}

/// Evaluates linear polynomials.
#[inline(always)]
fn fill_even([x, d1, ..]: &AxisJet, sigma: f64, along: &ProfilePoint, out: &mut MotionSample) {
    let ProfilePoint { speed: v, acceleration: a, jerk: j, .. } = *along;
    for axis in 0..AXES {
        out.position[axis] = x[axis] + sigma * d1[axis];
        out.velocity[axis] = d1[axis] * v;
        out.acceleration[axis] = d1[axis] * a;
        out.jerk[axis] = d1[axis] * j;
    }
}

/// Evaluates cubic polynomials.
#[inline(always)]
fn fill_cubic([x, d1, d2, d3]: &AxisJet, sigma: f64, along: &ProfilePoint, out: &mut MotionSample) {
    let ProfilePoint { speed: v, acceleration: a, jerk: j, .. } = *along;
    let (half, sixth) = (sigma * 0.5, sigma * SIXTH);
    let (square, cube, mixed) = (v * v, v * v * v, 3.0 * v * a);
    for axis in 0..AXES {
        let third = d3[axis];
        let first = d1[axis] + sigma * (d2[axis] + half * third);
        let second = d2[axis] + sigma * third;
        out.position[axis] =
            x[axis] + sigma * (d1[axis] + sigma * (d2[axis] * 0.5 + sixth * third));
        out.velocity[axis] = first * v;
        out.acceleration[axis] = first * a + second * square;
        out.jerk[axis] = first * j + second * mixed + third * cube;
    }
}

/// Evaluates a base curve to which constants are added.
#[inline(always)]
fn set_curve([x, y, z, a, b, c]: &AxisValues, motion: [Vec3; 4], out: &mut MotionSample) {
    let [point, first, second, third] = motion;
    let axes = |of: Vec3| [of.x, of.y, of.z, 0.0, 0.0, 0.0];
    out.position = [x + point.x, y + point.y, z + point.z, *a, *b, *c];
    out.velocity = axes(first);
    out.acceleration = axes(second);
    out.jerk = axes(third);
}

/// Adds the base curve to X, Y and Z.
#[inline(always)]
fn add_curve(motion: [Vec3; 4], out: &mut MotionSample) {
    let [point, first, second, third] = motion.map(Vec3::to_array);
    for axis in 0..3 {
        out.position[axis] += point[axis];
        out.velocity[axis] += first[axis];
        out.acceleration[axis] += second[axis];
        out.jerk[axis] += third[axis];
    }
}
