//! The paths of the axes of moves under tool centre point control.

use chordal_command::{CommandKind, Move, PartFrame, Position, ProgramOffsets, TipCurve};
use chordal_geometry::{Curve, Line, ParamCurve, Transform, Vec3};
use chordal_kinematics::JointPath;

use crate::segment::{curve_of, curves_of, point};

/// A part of a move as the axes make it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisPiece {
    /// The curve of X, Y and Z: machine coordinates without the offsets of the program, mm.
    pub curve: Curve,
    /// A, B and C at its start, rad.
    pub rotary_from: [f64; 3],
    /// A, B and C at its end, rad.
    pub rotary_to: [f64; 3],
    /// Its share of the duration of the whole piece of the tip's path.
    pub share: f64,
}

/// Passes the curves of a move in program coordinates to `push`, each with the positions at its start and its end. The
/// rotary axes turn evenly along all of them.
pub fn tip_pieces(kind: &CommandKind, motion: &Move, mut push: impl FnMut(&Curve, [&Position; 2])) {
    let with_end = |position: &Position, curve: &Curve| {
        let mut to = *position;
        to[..3].copy_from_slice(&curve.end().to_array());
        to
    };
    if kind.spline().is_none() {
        let curve = match kind {
            CommandKind::Rapid { .. } => {
                let [start, end] = [&motion.from, &motion.to].map(point);
                Curve::Line(Line { start, end })
            }
            kind => curve_of(motion, kind.shape()),
        };
        return push(&curve, [&motion.from, &with_end(&motion.to, &curve)]);
    }
    let mut curves: Vec<Curve> = Vec::new();
    curves_of(kind, |curve| curves.push(curve));
    let whole: f64 = curves.iter().map(ParamCurve::length).sum();
    let (mut done, mut from) = (0.0, motion.from);
    let last = curves.len().saturating_sub(1);
    for (index, curve) in curves.iter().enumerate() {
        done += curve.length();
        let share = if index == last || whole <= 0.0 { 1.0 } else { done / whole };
        let mut to = with_end(&motion.to, curve);
        let turns = to.iter_mut().zip(motion.from.iter().zip(&motion.to)).skip(3);
        for (angle, (start, end)) in turns {
            *angle = start * (1.0 - share) + end * share;
        }
        push(curve, [&from, &to]);
        from = to;
    }
}

/// The path of the axes while the tip follows a curve: exact where the rotary axes rest, otherwise in straight motions that
/// keep the tip within `tolerance_mm` of its curve. `None` where the kinematics are not known.
pub fn axis_pieces(
    frame: &PartFrame,
    curve: &Curve,
    ends: [&Position; 2],
    offsets: &ProgramOffsets,
    tolerance_mm: f64,
) -> Option<AxisPieces> {
    let path = frame.joint_path(curve, ends, offsets)?;
    let rotary = ends.map(rotary);
    let is_exact = path.from == path.to;
    // How many chords are needed is decided for each part by itself: the bound of the curvature of a long part is far
    // above the truth.
    let count = if is_exact { 1 } else { path.chord_count(0.0, 1.0, tolerance_mm) };
    let parts = (count / CHORDS_OF_PART).clamp(1, MAX_PARTS);
    let mut pieces = AxisPieces {
        path,
        rotary,
        away: offsets.total(),
        tolerance_mm,
        is_exact,
        parts,
        part: 0,
        count: count.min(MAX_CHORDS),
        chord: 0,
        from: (Vec3::ZERO, rotary[0]),
        sigma: 0.0,
    };
    pieces.begin_part();
    pieces.from = if is_exact { pieces.from } else { pieces.at(0.0) };
    Some(pieces)
}

/// The parts of a move as the axes make them, in order.
#[derive(Clone, Debug)]
pub struct AxisPieces {
    path: JointPath<TipCurve>,
    /// A, B and C at the ends of the whole, rad.
    rotary: [[f64; 3]; 2],
    /// From positions without the offsets of the program to machine coordinates, mm.
    away: Vec3,
    tolerance_mm: f64,
    /// The rotary axes rest, so that the only piece is the curve of the tip, moved.
    is_exact: bool,
    /// The number of equal parts of σ, and the one that is cut into chords now.
    parts: u32,
    part: u32,
    /// The number of chords of this part, and of those that are done.
    count: u32,
    chord: u32,
    /// Where the next chord begins: X, Y and Z, and the rotary axes.
    from: (Vec3, [f64; 3]),
    sigma: f64,
}

impl AxisPieces {
    /// Whether the path of the axes is exact.
    pub fn is_exact(&self) -> bool {
        self.is_exact
    }

    /// σ at a share of the present part.
    fn place(&self, share: f64) -> f64 {
        (f64::from(self.part) + share) / f64::from(self.parts)
    }

    /// The number of chords of the present part: that of the whole where it is the only one.
    fn begin_part(&mut self) {
        self.chord = 0;
        if self.parts > 1 {
            let [from, to] = [0.0, 1.0].map(|share| self.place(share));
            self.count = self.path.chord_count(from, to, self.tolerance_mm).min(MAX_CHORDS);
        }
    }

    /// X, Y and Z without the offsets, and the rotary axes, at σ.
    fn at(&self, sigma: f64) -> (Vec3, [f64; 3]) {
        let [from, to] = &self.rotary;
        let rotary = std::array::from_fn(|axis| from[axis] * (1.0 - sigma) + to[axis] * sigma);
        (self.path.positions(sigma).gauge_point - self.away, rotary)
    }

    /// The curve of the tip where the axes bring it, while the rotary axes rest.
    fn moved_curve(&self) -> Curve {
        let path = &self.path;
        let to_axes = path.chain.part_transform(&path.from).inverse();
        let away = -path.chain.tool_on_heads(&path.from, path.tool) - self.away;
        path.tip.curve.transformed(&to_axes).transformed(&Transform::translation(away))
    }
}

impl Iterator for AxisPieces {
    type Item = AxisPiece;

    fn next(&mut self) -> Option<AxisPiece> {
        if self.chord == self.count {
            self.part += 1;
            if self.part >= self.parts {
                // It stays at the end.
                self.part = self.parts;
                return None;
            }
            self.begin_part();
        }
        self.chord += 1;
        if self.is_exact {
            let [rotary_from, rotary_to] = self.rotary;
            return Some(AxisPiece {
                curve: self.moved_curve(),
                rotary_from,
                rotary_to,
                share: 1.0,
            });
        }
        let sigma = self.place(f64::from(self.chord) / f64::from(self.count));
        let (from, to) = (self.from, self.at(sigma));
        let share = sigma - self.sigma;
        (self.from, self.sigma) = (to, sigma);
        let curve = Curve::Line(Line { start: from.0, end: to.0 });
        Some(AxisPiece { curve, rotary_from: from.1, rotary_to: to.1, share })
    }
}

impl std::iter::FusedIterator for AxisPieces {}

/// Chords of one part of a path, by the bound of the whole.
const CHORDS_OF_PART: u32 = 4;

/// Parts of one path at most.
const MAX_PARTS: u32 = 64;

/// Chords of one part at most: beyond some thousand turns in one move the tolerance is not kept.
const MAX_CHORDS: u32 = 1_000;

fn rotary(place: &Position) -> [f64; 3] {
    [place[3], place[4], place[5]]
}
