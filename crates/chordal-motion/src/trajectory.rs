use crate::Axes;
use crate::piece::Piece;

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
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stretch {
    /// The path, in order.
    pub pieces: Vec<Piece>,
    /// The law of time, in order.
    pub phases: Vec<Phase>,
    /// How long before the end of the stretch before it begins, s. In that time the axes make
    /// both movements, which lets the tool pass the corner between them within its tolerance.
    pub overlap_s: f64,
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
#[inline]
pub(crate) fn state_of(piece: &Piece, sigma: f64, along: &Along) -> State {
    let [position, d1, d2, d3] = piece.at(sigma);
    let Along { speed: v, acceleration: a, jerk: j, .. } = *along;
    let mut state = State { position, tag: piece.tag, ..State::default() };
    for axis in 0..6 {
        state.velocity[axis] = d1[axis] * v;
        state.acceleration[axis] = d1[axis] * a + d2[axis] * v * v;
        state.jerk[axis] = d1[axis] * j + 3.0 * d2[axis] * v * a + d3[axis] * v * v * v;
    }
    state
}

/// Walks along a stretch in time.
#[derive(Clone, Debug, Default)]
pub struct Cursor {
    piece: usize,
    piece_from: f64,
    phase: usize,
    phase_from_s: f64,
}

impl Cursor {
    /// The axes at `t` s from the start of the stretch. Times must not go back; beyond the end
    /// the answer is its end.
    pub fn at(&mut self, stretch: &Stretch, t: f64) -> State {
        let (Some(last_phase), Some(last_piece)) =
            (stretch.phases.len().checked_sub(1), stretch.pieces.len().checked_sub(1))
        else {
            return State::default();
        };
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
        }
        let piece = &stretch.pieces[self.piece];
        state_of(piece, (along.sigma - self.piece_from).clamp(0.0, piece.length), &along)
    }
}
