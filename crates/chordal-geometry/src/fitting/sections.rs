//! Cuts the points at corners and where their plane changes, and fits what lies between.

use crate::{Arc, Curve, Line, Plane, Vec2, Vec3, math};

use super::flat::{Flat, Piece, Shape};
use super::reach::Reach;
use super::{FitOptions, FitPiece, Measure, tangent};

/// Parts of the tolerance that rows are also tried with: shorter arcs leave more room to be tangent.
const TRIED: [f64; 7] = [0.97, 0.93, 0.88, 0.8, 0.72, 0.64, 0.55];
/// A tangent row is good enough with this many times the pieces of one that is not.
const ENOUGH: (usize, usize) = (6, 5);
/// Halvings of the tolerance when a row is made even.
const HALVINGS: usize = 5;
/// Rounds in which a row is made tangent; in the first of them pieces may be cut in two.
const ROUNDS: usize = 8;
const CUT_ROUNDS: usize = 2;

/// A part of the points without a corner, in one plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section {
    from: usize,
    to: usize,
    plane: Plane,
}

/// The parts between corners, each in its plane.
pub(super) fn sections(points: &[Vec3], options: &FitOptions) -> Vec<Section> {
    let mut sections = Vec::new();
    let mut from = 0;
    for index in 1..points.len() {
        let is_end = index + 1 == points.len();
        if !is_end {
            let (a, b) = (points[index] - points[index - 1], points[index + 1] - points[index]);
            if math::atan2(a.cross(b).length(), a.dot(b)) <= options.corner {
                continue;
            }
        }
        match options.plane {
            Some(plane) => sections.push(Section { from, to: index, plane }),
            None => by_plane(points, [from, index], options.tolerance, &mut sections),
        }
        from = index;
    }
    sections
}

/// Cuts a part where its plane changes. What lies in no plane is taken as turns about Z.
fn by_plane(points: &[Vec3], [from, to]: [usize; 2], tolerance: f64, sections: &mut Vec<Section>) {
    /// Fewer chords are not worth a plane of their own.
    const FEW: usize = 4;
    let level = 1e-6 + tolerance / 1000.0;
    let reach = |start: usize, plane: Plane| {
        let height = plane.height(points[start]);
        (start + 1..=to)
            .take_while(|at| (plane.height(points[*at]) - height).abs() <= level)
            .count()
    };
    let (mut at, mut loose) = (from, from);
    while at < to {
        let [best, ..] = {
            let mut planes =
                [Plane::Xy, Plane::Zx, Plane::Yz].map(|plane| (reach(at, plane), plane));
            planes.sort_by_key(|(reach, _)| core::cmp::Reverse(*reach));
            planes
        };
        let is_all = at == from && best.0 == to - from;
        if best.0 < FEW && !is_all {
            at += 1;
            continue;
        }
        if loose < at {
            sections.push(Section { from: loose, to: at, plane: Plane::Xy });
        }
        sections.push(Section { from: at, to: at + best.0, plane: best.1 });
        at += best.0;
        loose = at;
    }
    if loose < to {
        sections.push(Section { from: loose, to, plane: Plane::Xy });
    }
}

/// Fits a section.
pub(super) fn fit(
    points: &[Vec3],
    section: &Section,
    options: &FitOptions,
    pieces: &mut Vec<FitPiece>,
) {
    let part = &points[section.from..=section.to];
    let at: Vec<Vec2> = part.iter().map(|point| section.plane.project(*point)).collect();
    let height = part.iter().map(|point| section.plane.height(*point)).collect();
    let flat = Flat::new(at, height, options.tolerance, options.measure);
    let row = circle(&flat, options).map_or_else(|| fit_flat(&flat, options), |one| vec![one]);
    pieces.extend(row.iter().map(|piece| {
        let span = piece.span.map(|place| place + section.from as f64);
        FitPiece {
            span,
            plane: section.plane,
            deviation: piece.deviation,
            curve: curve(piece, section.plane),
        }
    }));
}

fn curve(piece: &Piece, plane: Plane) -> Curve {
    let [start, end] = [0, 1].map(|end| plane.point(piece.ends[end], piece.heights[end]));
    let Shape::Arc { center, sweep } = piece.shape else {
        return Line::new(start, end).into();
    };
    let center = plane.point(center, piece.heights[0]);
    let spoke = start - center;
    let radius = spoke.length();
    let rise = piece.heights[1] - piece.heights[0];
    Arc { center, u: spoke / radius, w: plane.normal(), radius, sweep, rise, start, end }.into()
}

/// The whole circle, where the points go round once.
fn circle(flat: &Flat, options: &FitOptions) -> Option<Piece> {
    let last = flat.last();
    if last < 6 || flat.at[0] != flat.at[last] {
        return None;
    }
    let [a, b, c] = [0, last / 3, 2 * last / 3].map(|index| flat.at[index]);
    let (ab, ac) = (b - a, c - a);
    let twice = 2.0 * ab.cross(ac);
    let to_center = (ab * ac.dot(ac) - ac * ab.dot(ab)).turned_left() * (1.0 / twice);
    let radius = to_center.length();
    if !(radius > 0.0 && radius <= options.max_radius) {
        return None;
    }
    let sweep = math::TAU * twice.signum();
    let shape = Shape::Arc { center: a + to_center, sweep };
    let heights = [flat.height[0], flat.height[last]];
    let piece = Piece { ends: [a, a], heights, shape, span: [0.0, last as f64], deviation: 0.0 };
    let deviation = super::deviation::deviation(flat, &piece, options.measure, options.tolerance)?;
    Some(Piece { deviation, ..piece })
}

fn fit_flat(flat: &Flat, options: &FitOptions) -> Vec<Piece> {
    let chain = |tolerance: f64| {
        let FitOptions { measure, max_radius, .. } = *options;
        Reach { flat, tolerance, measure, max_radius }.chain()
    };
    let longest = chain(options.tolerance);
    if longest.len() < 2 {
        return longest;
    }
    let even = even(&longest, options.tolerance, chain);
    if !options.tangent {
        return even;
    }
    let mut best: Option<(usize, Vec<Piece>)> = None;
    let mut tried = Vec::new();
    for part in core::iter::once(None).chain(TRIED.map(Some)) {
        let row = part.map_or_else(|| even.clone(), |part| chain(part * options.tolerance));
        let least = row.len();
        if tried.contains(&least) || best.as_ref().is_some_and(|(cost, _)| least >= *cost) {
            continue;
        }
        tried.push(least);
        let (let_go, row) = smooth(flat, row, options.tolerance, options.measure);
        // A joint that is not tangent weighs as much as a piece more.
        let cost = row.len() + let_go;
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, row));
        }
        if best.as_ref().is_some_and(|(cost, _)| cost * ENOUGH.1 <= even.len() * ENOUGH.0) {
            break;
        }
    }
    best.map_or(even, |(_, row)| row)
}

/// As many pieces within as small a tolerance as that number allows: no last piece is left short, and
/// there is room for the joints to move.
fn even(longest: &[Piece], tolerance: f64, chain: impl Fn(f64) -> Vec<Piece>) -> Vec<Piece> {
    let mut best = longest.to_vec();
    let (mut low, mut high) = (0.0, tolerance);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        let row = chain(middle);
        if row.len() <= best.len() {
            (best, high) = (row, middle);
        } else {
            low = middle;
        }
    }
    best
}

/// Makes a row tangent. Where that leads beyond the tolerance a piece is cut in two; joints at which not
/// even that helps are let go.
fn smooth(flat: &Flat, first: Vec<Piece>, tolerance: f64, measure: Measure) -> (usize, Vec<Piece>) {
    let mut row = first.clone();
    let mut joints = tangent::smooth_joints(&row);
    let free = |joints: &[bool]| joints.iter().filter(|joint| **joint).count();
    let mut all = free(&joints);
    for round in 0..ROUNDS {
        let Some(mut new) = tangent::tangent(flat, &row, &joints) else { break };
        tangent::measure(flat, &mut new, measure);
        let beyond: Vec<bool> = new.iter().map(|piece| piece.deviation > tolerance).collect();
        if !beyond.contains(&true) {
            return (all - free(&joints), new);
        }
        if round < CUT_ROUNDS {
            let worst = worst_of_runs(&new, &beyond);
            if worst.iter().any(|index| cut(flat, &row[*index]).is_some()) {
                row = cut_at(flat, &row, &worst);
                joints = tangent::smooth_joints(&row);
                all = free(&joints);
                continue;
            }
        }
        for index in (0..beyond.len()).filter(|index| beyond[*index]) {
            joints[index] = false;
            if let Some(behind) = joints.get_mut(index + 1) {
                *behind = false;
            }
        }
    }
    (free(&tangent::smooth_joints(&first)), first)
}

/// Of pieces beside each other that are beyond the tolerance the one that is most.
fn worst_of_runs(pieces: &[Piece], beyond: &[bool]) -> Vec<usize> {
    let mut worst: Vec<usize> = Vec::new();
    for index in (0..pieces.len()).filter(|index| beyond[*index]) {
        match worst.last_mut() {
            Some(last) if (*last..index).all(|between| beyond[between]) => {
                if pieces[index].deviation > pieces[*last].deviation {
                    *last = index;
                }
            }
            _ => worst.push(index),
        }
    }
    worst
}

fn cut_at(flat: &Flat, row: &[Piece], at: &[usize]) -> Vec<Piece> {
    let mut new = Vec::with_capacity(row.len() + at.len());
    for (index, piece) in row.iter().enumerate() {
        let halves = if at.binary_search(&index).is_ok() { cut(flat, piece) } else { None };
        match halves {
            Some(halves) => new.extend(halves),
            None => new.push(*piece),
        }
    }
    new
}

/// An arc between points of the row as two; `None` where there are too few chords.
fn cut(flat: &Flat, piece: &Piece) -> Option<[Piece; 2]> {
    let [from, to] = piece.span.map(|place| place as usize);
    if piece.is_line() || to < from + 4 {
        return None;
    }
    let middle = 0.5 * (flat.along[from] + flat.along[to]);
    let at = flat.along.partition_point(|along| *along < middle).clamp(from + 2, to - 2);
    let part = |from: usize, to: usize| {
        let share =
            flat.length(from, to) / flat.length(piece.span[0] as usize, piece.span[1] as usize);
        let new = Piece::between(flat, from, to, piece.half() * share);
        Piece { deviation: piece.deviation, ..new }
    };
    Some([part(from, at), part(at, to)])
}
