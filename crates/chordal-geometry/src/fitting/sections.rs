//! Divides the points at corners and where their plane changes, and fits each section.

use crate::{Arc, Curve, Line, Plane, Vec2, Vec3, math};

use super::flat::{FittedPiece, FittedShape, PlanarPoints};
use super::smooth::{RowEnds, SectionFit};
use super::{FitOptions, FitPiece};

/// A range of the points without a corner, in one plane.
#[derive(Clone, Copy, Debug)]
struct PlanarSection {
    from: usize,
    to: usize,
    plane: Plane,
}

/// The sections between corners, each in its plane.
fn sections(points: &[Vec3], options: &FitOptions) -> Vec<PlanarSection> {
    let mut sections = Vec::new();
    let mut from = 0;
    for index in 1..points.len() {
        let is_end = index + 1 == points.len();
        if !is_end && !is_corner(points[index - 1], points[index], points[index + 1], options) {
            continue;
        }
        match options.plane {
            Some(plane) => sections.push(PlanarSection { from, to: index, plane }),
            None => by_plane(points, [from, index], options.tolerance, &mut sections),
        }
        from = index;
    }
    sections
}

fn is_corner(before: Vec3, at: Vec3, after: Vec3, options: &FitOptions) -> bool {
    let (a, b) = (at - before, after - at);
    let (sin, cos) = math::sin_cos(options.corner.clamp(0.0, math::PI));
    // Compares the angle with that of a corner by the sine of their difference.
    a.cross(b).length() * cos > a.dot(b) * sin
}

/// Whether the points end where they begin, without a corner there.
fn is_closed(points: &[Vec3], options: &FitOptions) -> bool {
    let last = points.len().saturating_sub(1);
    last > 2
        && points[0] == points[last]
        && !is_corner(points[last - 1], points[0], points[1], options)
}

/// Divides a section where its plane changes. Points in no coordinate plane are treated as turns about Z.
fn by_plane(
    points: &[Vec3],
    [from, to]: [usize; 2],
    tolerance: f64,
    sections: &mut Vec<PlanarSection>,
) {
    /// Fewer chords do not become a section of their own.
    const MIN_SECTION_CHORDS: usize = 4;
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
        if best.0 < MIN_SECTION_CHORDS && !is_all {
            at += 1;
            continue;
        }
        if loose < at {
            sections.push(PlanarSection { from: loose, to: at, plane: Plane::Xy });
        }
        sections.push(PlanarSection { from: at, to: at + best.0, plane: best.1 });
        at += best.0;
        loose = at;
    }
    if loose < to {
        sections.push(PlanarSection { from: loose, to, plane: Plane::Xy });
    }
}

/// Fits all sections; a closed path without a corner at its start becomes tangent there.
pub(super) fn fit(points: &[Vec3], options: &FitOptions, pieces: &mut Vec<FitPiece>) {
    let sections = sections(points, options);
    let is_closed = options.tangent && is_closed(points, options);
    let mut first: Option<(Plane, Vec2)> = None;
    for (index, section) in sections.iter().enumerate() {
        let is_last = index + 1 == sections.len();
        let ends = RowEnds {
            is_closed: is_closed && sections.len() == 1,
            directions: [
                None,
                first
                    .filter(|(plane, _)| is_closed && is_last && *plane == section.plane)
                    .map(|(_, start)| start),
            ],
        };
        let row = fit_section(points, section, ends, options, pieces);
        if index == 0 {
            first = row.first().map(|piece| (section.plane, piece.direction()));
        }
    }
}

fn fit_section(
    points: &[Vec3],
    section: &PlanarSection,
    ends: RowEnds,
    options: &FitOptions,
    pieces: &mut Vec<FitPiece>,
) -> Vec<FittedPiece> {
    let part = &points[section.from..=section.to];
    let at: Vec<Vec2> = part.iter().map(|point| section.plane.project(*point)).collect();
    let height = part.iter().map(|point| section.plane.height(*point)).collect();
    let flat = PlanarPoints::new(at, height, ends.is_closed, options.tolerance, options.measure);
    let row = match circle(&flat, options) {
        Some(one) => vec![one],
        None => SectionFit::of(&flat, options).row(ends),
    };
    pieces.extend(row.iter().map(|piece| {
        let span = piece.span.map(|place| place + section.from as f64);
        FitPiece {
            span,
            plane: section.plane,
            deviation: piece.deviation,
            curve: curve(piece, section.plane),
        }
    }));
    row
}

fn curve(piece: &FittedPiece, plane: Plane) -> Curve {
    let [start, end] = [0, 1].map(|end| plane.point(piece.ends[end], piece.heights[end]));
    let FittedShape::Arc { center, sweep } = piece.shape else {
        return Line::new(start, end).into();
    };
    let center = plane.point(center, piece.heights[0]);
    let spoke = start - center;
    let radius = spoke.length();
    let rise = piece.heights[1] - piece.heights[0];
    Arc { center, u: spoke / radius, w: plane.normal(), radius, sweep, rise, start, end }.into()
}

/// The full circle, if the points follow one; otherwise `None`.
fn circle(flat: &PlanarPoints, options: &FitOptions) -> Option<FittedPiece> {
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
    let shape = FittedShape::Arc { center: a + to_center, sweep };
    let heights = [flat.height[0], flat.height[last]];
    let piece =
        FittedPiece { ends: [a, a], heights, shape, span: [0.0, last as f64], deviation: 0.0 };
    let deviation = super::deviation::deviation(flat, &piece, options.measure, options.tolerance)?;
    Some(FittedPiece { deviation, ..piece })
}
