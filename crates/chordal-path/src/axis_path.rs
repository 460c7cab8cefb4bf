//! The paths of the axes of moves under tool centre point control.

use chordal_command::{CommandKind, Move, PartFrame, Position, ProgramOffsets, TipCurve};
use chordal_geometry::{Curve, Line, ParamCurve, Transform};
use chordal_kinematics::JointPath;

use crate::segment::{curves_of, point};

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
    let mut curves: Vec<Curve> = Vec::new();
    match kind {
        CommandKind::Rapid { motion, .. } => {
            let [start, end] = [&motion.from, &motion.to].map(point);
            curves.push(Curve::Line(Line { start, end }));
        }
        kind => curves_of(kind, |curve| curves.push(curve)),
    }
    let whole: f64 = curves.iter().map(ParamCurve::length).sum();
    let (mut done, mut from) = (0.0, motion.from);
    let last = curves.len().saturating_sub(1);
    for (index, curve) in curves.iter().enumerate() {
        done += curve.length();
        let share = if index == last || whole <= 0.0 { 1.0 } else { done / whole };
        let mut to = motion.to;
        to[..3].copy_from_slice(&curve.end().to_array());
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
) -> Option<Vec<AxisPiece>> {
    let path = frame.joint_path(curve, ends, offsets)?;
    let [rotary_from, rotary_to] = ends.map(rotary);
    let all = offsets.total();
    if path.from == path.to {
        let on_part = path.tip.curve;
        let to_axes = path.chain.part_transform(&path.from).inverse();
        let away = -path.chain.tool_on_heads(&path.from, path.tool) - all;
        let curve = on_part.transformed(&to_axes).transformed(&Transform::translation(away));
        return Some(vec![AxisPiece { curve, rotary_from, rotary_to, share: 1.0 }]);
    }
    let at = |sigma: f64| {
        let rotary: [f64; 3] =
            std::array::from_fn(|axis| rotary_from[axis] * (1.0 - sigma) + rotary_to[axis] * sigma);
        (path.positions(sigma).gauge_point - all, rotary)
    };
    let mut pieces = Vec::new();
    let (mut from, mut sigma) = (at(0.0), 0.0);
    for end in chord_ends(&path, tolerance_mm) {
        let to = at(end);
        let curve = Curve::Line(Line { start: from.0, end: to.0 });
        let share = end - sigma;
        pieces.push(AxisPiece { curve, rotary_from: from.1, rotary_to: to.1, share });
        (from, sigma) = (to, end);
    }
    Some(pieces)
}

/// The ends of the chords of a path of the axes, from 0 to 1. How many are needed is decided for each part by itself: the
/// bound of the curvature of a long part is far above the truth.
fn chord_ends(path: &JointPath<TipCurve>, tolerance_mm: f64) -> Vec<f64> {
    let whole = path.chord_count(0.0, 1.0, tolerance_mm);
    let parts = (whole / CHORDS_OF_PART).clamp(1, MAX_PARTS);
    let mut ends = Vec::new();
    for part in 0..parts {
        let place = |share: f64| (f64::from(part) + share) / f64::from(parts);
        let count = path.chord_count(place(0.0), place(1.0), tolerance_mm).min(MAX_CHORDS);
        ends.extend((1..=count).map(|chord| place(f64::from(chord) / f64::from(count))));
    }
    ends
}

/// Chords of one part of a path, by the bound of the whole.
const CHORDS_OF_PART: u32 = 4;

/// Parts of one path at most.
const MAX_PARTS: u32 = 64;

/// Chords of one part at most: beyond some thousand turns in one move the tolerance is not kept.
const MAX_CHORDS: u32 = 1_000;

fn rotary(place: &Position) -> [f64; 3] {
    [place[3], place[4], place[5]]
}
