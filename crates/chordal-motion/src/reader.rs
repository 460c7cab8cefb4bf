//! The axes at a place of a piece, moved by the velocity profile.

use chordal_geometry::{AXES, Tracer, Vec3};

use crate::piece::{Piece, SIXTH};
use crate::sample::{Sample, State};
use crate::trajectory::Along;

/// What is worth knowing of a piece before it is asked at many places.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reader {
    form: Form,
    /// The curve below, made ready.
    tracer: Option<Tracer>,
}

/// What the polynomials of a piece are like.
#[derive(Clone, Copy, Debug)]
enum Form {
    /// Constant: the curve alone moves.
    Still,
    /// Of the first degree.
    Even,
    /// Anything else.
    Cubic,
}

impl Form {
    #[inline]
    fn of(piece: &Piece) -> Form {
        if !piece.is_even() {
            Form::Cubic
        } else if piece.base.is_some() && piece.is_still() {
            Form::Still
        } else {
            Form::Even
        }
    }
}

impl Reader {
    /// Of a piece.
    pub fn new(piece: &Piece) -> Reader {
        let tracer = piece.base.as_ref().map(|(curve, _)| Tracer::new(curve));
        Reader { form: Form::of(piece), tracer }
    }

    /// Goes over to another piece; where that lies over the same curve, the curve stays ready.
    #[inline]
    pub fn go_on(&mut self, before: &Piece, next: &Piece) {
        self.form = Form::of(next);
        if self.tracer.is_some() || next.base.is_some() {
            self.change_curve(before, next);
        }
    }

    fn change_curve(&mut self, before: &Piece, next: &Piece) {
        let same = match (&before.base, &next.base) {
            (Some((before, _)), Some((next, _))) => before == next,
            _ => false,
        };
        if !same {
            self.tracer = next.base.as_ref().map(|(curve, _)| Tracer::new(curve));
        }
    }

    /// Writes what the axes do at `sigma` from the start of the piece into a sample, whose time
    /// stays.
    #[inline(always)]
    pub fn fill(&mut self, piece: &Piece, sigma: f64, along: &Along, out: &mut Sample) {
        out.tag = piece.tag;
        match self.form {
            // Written below.
            Form::Still => {}
            Form::Even => fill_even(piece, sigma, along, out),
            Form::Cubic => fill_cubic(piece, sigma, along, out),
        }
        if let (Some(tracer), Some((_, from))) = (&mut self.tracer, &piece.base) {
            let Along { speed, acceleration, jerk, .. } = *along;
            let by_time = [speed, acceleration, jerk];
            if matches!(self.form, Form::Still) {
                tracer
                    .with_motion_at(from + sigma, by_time, |motion| set_curve(piece, motion, out));
            } else {
                add_curve(tracer.motion_at(from + sigma, by_time), out);
            }
        }
    }
}

/// The axes at one place of a piece.
pub(crate) fn state_of(piece: &Piece, sigma: f64, along: &Along) -> State {
    let mut sample = Sample::default();
    Reader::new(piece).fill(piece, sigma, along, &mut sample);
    sample.into()
}

/// Polynomials of the first degree.
#[inline(always)]
fn fill_even(piece: &Piece, sigma: f64, along: &Along, out: &mut Sample) {
    let [x, d1, ..] = &piece.start;
    let Along { speed: v, acceleration: a, jerk: j, .. } = *along;
    for axis in 0..AXES {
        out.position[axis] = x[axis] + sigma * d1[axis];
        out.velocity[axis] = d1[axis] * v;
        out.acceleration[axis] = d1[axis] * a;
        out.jerk[axis] = d1[axis] * j;
    }
}

/// Polynomials of the third degree.
#[inline(always)]
fn fill_cubic(piece: &Piece, sigma: f64, along: &Along, out: &mut Sample) {
    let [x, d1, d2, d3] = &piece.start;
    let Along { speed: v, acceleration: a, jerk: j, .. } = *along;
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

/// The curve below alone, with nothing but a shift on top.
#[inline(always)]
fn set_curve(piece: &Piece, motion: [Vec3; 4], out: &mut Sample) {
    let [x, y, z, a, b, c] = piece.start[0];
    let [point, first, second, third] = motion;
    let axes = |of: Vec3| [of.x, of.y, of.z, 0.0, 0.0, 0.0];
    out.position = [x + point.x, y + point.y, z + point.z, a, b, c];
    out.velocity = axes(first);
    out.acceleration = axes(second);
    out.jerk = axes(third);
}

/// What the curve below adds.
#[inline(always)]
fn add_curve(motion: [Vec3; 4], out: &mut Sample) {
    let [point, first, second, third] = motion.map(Vec3::to_array);
    for axis in 0..3 {
        out.position[axis] += point[axis];
        out.velocity[axis] += first[axis];
        out.acceleration[axis] += second[axis];
        out.jerk[axis] += third[axis];
    }
}
