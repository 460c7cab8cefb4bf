use chordal_geometry::Vec3;

use crate::Axes;
use crate::piece::{Piece, Shape};
use crate::sampler::Sample;

/// A time of constant jerk along the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase {
    /// How long, s.
    pub duration_s: f64,
    /// Where it begins in σ, from the start of the stretch.
    pub from: f64,
    /// σ per s at its start.
    pub speed: f64,
    /// σ per s² at its start.
    pub acceleration: f64,
    /// σ per s³ all along.
    pub jerk: f64,
}

/// The law of time at an instant: σ and its derivatives by time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Along {
    /// σ from the start of the stretch.
    pub sigma: f64,
    /// σ per s.
    pub speed: f64,
    /// σ per s².
    pub acceleration: f64,
    /// σ per s³.
    pub jerk: f64,
}

impl Phase {
    /// The law of time `t` s after its start.
    #[inline]
    pub fn at(&self, t: f64) -> Along {
        let Phase { from, speed, acceleration, jerk, .. } = *self;
        Along {
            sigma: from + t * (speed + t * (acceleration / 2.0 + t * (jerk / 6.0))),
            speed: speed + t * (acceleration + t * (jerk / 2.0)),
            acceleration: acceleration + t * jerk,
            jerk,
        }
    }
}

/// Where the axes are and how they move.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// mm and rad.
    pub position: Axes,
    /// mm/s and rad/s.
    pub velocity: Axes,
    /// mm/s² and rad/s².
    pub acceleration: Axes,
    /// mm/s³ and rad/s³.
    pub jerk: Axes,
    /// The tag of the move that is under way.
    pub tag: u64,
}

/// Path and time between two instants without acceleration: from rest to rest, or to a place
/// that is passed at even speed, where the next stretch goes on.
#[derive(Debug, Default, PartialEq)]
pub struct Stretch {
    /// The path, in order.
    pub pieces: Vec<Piece>,
    /// The law of time, in order.
    pub phases: Vec<Phase>,
    /// How long before the end of the stretch before it begins, s. In that time the axes make
    /// both movements, which lets the tool pass the corner between them within its tolerance.
    pub overlap_s: f64,
}

impl Clone for Stretch {
    fn clone(&self) -> Stretch {
        Stretch {
            pieces: self.pieces.clone(),
            phases: self.phases.clone(),
            overlap_s: self.overlap_s,
        }
    }

    /// Into the memory that is there already.
    fn clone_from(&mut self, source: &Stretch) {
        self.pieces.clone_from(&source.pieces);
        self.phases.clone_from(&source.phases);
        self.overlap_s = source.overlap_s;
    }
}

impl Stretch {
    /// How long it takes, s.
    pub fn duration_s(&self) -> f64 {
        self.phases.iter().map(|phase| phase.duration_s).sum()
    }

    /// Its length in σ.
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.length).sum()
    }

    /// Where it begins.
    pub fn from(&self) -> Axes {
        self.pieces.first().map_or([0.0; 6], |piece| piece.at(0.0)[0])
    }

    /// Where it ends.
    pub fn to(&self) -> Axes {
        self.pieces.last().map_or([0.0; 6], |piece| piece.at(piece.length)[0])
    }
}

/// What happens next on a machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step<'a> {
    /// A movement.
    Stretch(&'a Stretch),
    /// Nothing moves for a time, s; with the tag that the caller gave.
    Wait {
        /// How long, s.
        seconds: f64,
        /// The caller's.
        tag: u64,
    },
}

/// The axes at a place of a piece, moved by the law of time.
pub(crate) fn state_of(piece: &Piece, sigma: f64, along: &Along) -> State {
    let mut sample = Sample { tag: piece.tag, ..Sample::default() };
    fill_bent(piece, sigma, along, &mut sample);
    sample.into()
}

impl From<Sample> for State {
    fn from(sample: Sample) -> State {
        let Sample { position, velocity, acceleration, jerk, tag, .. } = sample;
        State { position, velocity, acceleration, jerk, tag }
    }
}

/// The same written into a sample.
#[inline]
fn fill_bent(piece: &Piece, sigma: f64, along: &Along, out: &mut Sample) {
    let [position, d1, d2, d3] = piece.at(sigma);
    let Along { speed: v, acceleration: a, jerk: j, .. } = *along;
    out.position = position;
    for axis in 0..6 {
        out.velocity[axis] = d1[axis] * v;
        out.acceleration[axis] = d1[axis] * a + d2[axis] * v * v;
        out.jerk[axis] = d1[axis] * j + 3.0 * d2[axis] * v * a + d3[axis] * v * v * v;
    }
}

/// The same where the path is straight and even.
#[inline(always)]
fn fill_even(piece: &Piece, sigma: f64, along: &Along, out: &mut Sample) {
    let [x, d1, ..] = &piece.start;
    let Along { speed: v, acceleration: a, jerk: j, .. } = *along;
    for axis in 0..6 {
        out.position[axis] = x[axis] + sigma * d1[axis];
        out.velocity[axis] = d1[axis] * v;
        out.acceleration[axis] = d1[axis] * a;
        out.jerk[axis] = d1[axis] * j;
    }
}

/// The same over a curve, where the polynomial is even.
#[inline]
fn fill_over(piece: &Piece, sigma: f64, base: [Vec3; 4], along: &Along, out: &mut Sample) {
    fill_even(piece, sigma, along, out);
    let Along { speed: v, acceleration: a, jerk: j, .. } = *along;
    let [point, tangent, d2, d3] = base.map(Vec3::to_array);
    for axis in 0..3 {
        let d1 = piece.start[1][axis] + tangent[axis];
        out.position[axis] += point[axis];
        out.velocity[axis] = d1 * v;
        out.acceleration[axis] = d1 * a + d2[axis] * v * v;
        out.jerk[axis] = d1 * j + 3.0 * d2[axis] * v * a + d3[axis] * v * v * v;
    }
}

/// The same by the piece's shape.
#[inline(always)]
pub(crate) fn fill_by(shape: &Shape, piece: &Piece, sigma: f64, along: &Along, out: &mut Sample) {
    match shape {
        Shape::Even => fill_even(piece, sigma, along, out),
        Shape::Over { base, from } => {
            fill_over(piece, sigma, base.jet_at(*from + sigma), along, out);
        }
        Shape::Bent => fill_bent(piece, sigma, along, out),
    }
}

/// Walks along a stretch in time.
#[derive(Clone, Debug, Default)]
pub struct Cursor {
    piece: usize,
    piece_from: f64,
    phase: usize,
    phase_from_s: f64,
    /// Of the piece it stands on.
    shape: Option<Shape>,
}

impl Cursor {
    /// The axes at `t` s from the start of the stretch. Times must not go back; beyond the end
    /// the answer is its end.
    pub fn at(&mut self, stretch: &Stretch, t: f64) -> State {
        let mut sample = Sample::default();
        self.fill(stretch, t, &mut sample);
        sample.into()
    }

    /// The same written into a sample, whose time stays. A stretch of nothing changes nothing.
    #[inline(always)]
    pub(crate) fn fill(&mut self, stretch: &Stretch, t: f64, out: &mut Sample) {
        let Some(along) = self.along(stretch, t) else { return };
        let piece = &stretch.pieces[self.piece];
        let sigma = (along.sigma - self.piece_from).clamp(0.0, piece.length);
        out.tag = piece.tag;
        let shape = self.shape.get_or_insert_with(|| Shape::of(piece));
        fill_by(shape, piece, sigma, &along, out);
    }

    /// Goes to the phase and the piece at `t`; `None` where there is nothing.
    #[inline(always)]
    fn along(&mut self, stretch: &Stretch, t: f64) -> Option<Along> {
        let last_phase = stretch.phases.len().checked_sub(1)?;
        let last_piece = stretch.pieces.len().checked_sub(1)?;
        while self.phase < last_phase
            && t - self.phase_from_s >= stretch.phases[self.phase].duration_s
        {
            self.phase_from_s += stretch.phases[self.phase].duration_s;
            self.phase += 1;
        }
        let phase = &stretch.phases[self.phase];
        let along = phase.at((t - self.phase_from_s).clamp(0.0, phase.duration_s));
        while self.piece < last_piece
            && along.sigma - self.piece_from >= stretch.pieces[self.piece].length
        {
            self.piece_from += stretch.pieces[self.piece].length;
            self.piece += 1;
            self.shape = None;
        }
        Some(along)
    }
}
