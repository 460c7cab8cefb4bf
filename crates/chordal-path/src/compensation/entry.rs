//! The first and the last corner of a compensated contour, and changes of side.

use chordal_geometry::Vec2;
use chordal_kernel::rules::CompensationEntry;

use super::corner::{CornerPath, CornerRuleSet, corner, outside};
use super::plane::{OffsetEdge, meeting};

/// Cosine of 179 degrees: compensation of type B starts and ends as type A at sharper corners.
const NEARLY_REVERSED: f64 = -0.999_847_695_156_391_3;

/// The corner between the move that starts compensation and the first block of the contour.
pub(super) fn start(
    entry: CompensationEntry,
    at: Vec2,
    lead: &OffsetEdge,
    first: &OffsetEdge,
    rules: &CornerRuleSet,
) -> CornerPath {
    let square = at + first.normal * first.radius;
    match entry {
        CompensationEntry::A => CornerPath::at(square),
        CompensationEntry::Contour => corner(at, lead, first, rules),
        CompensationEntry::B => {
            let inside = lead.sign * lead.tangent.cross(first.tangent) > 0.0;
            let ahead = lead.tangent.dot(first.tangent);
            if inside || ahead < NEARLY_REVERSED {
                return CornerPath::at(square);
            }
            outside(at, lead, first, ahead)
        }
    }
}

/// The corner between the last block of the contour and the move that ends compensation.
pub(super) fn cancel(
    entry: CompensationEntry,
    at: Vec2,
    last: &OffsetEdge,
    lead: &OffsetEdge,
) -> CornerPath {
    let square = at + last.normal * last.radius;
    match entry {
        CompensationEntry::A | CompensationEntry::Contour => CornerPath::at(square),
        CompensationEntry::B => {
            let inside = last.sign * last.tangent.cross(lead.tangent) > 0.0;
            let ahead = last.tangent.dot(lead.tangent);
            if inside || ahead < NEARLY_REVERSED {
                return CornerPath::at(square);
            }
            outside(at, last, lead, ahead)
        }
    }
}

/// The last corner of a G40 with I J: where the offset of the last block intersects the offset of a line from the
/// corner in that direction. `None` if they do not intersect.
pub(super) fn toward(
    at: Vec2,
    last: &OffsetEdge,
    direction: Vec2,
    tolerance: f64,
) -> Option<CornerPath> {
    let line = super::plane::CompensationCurve::Line { from: at, to: at + direction };
    let start = OffsetEdge::start(line, last.sign, last.radius)?;
    meeting(at, last, &start, tolerance).map(CornerPath::at)
}

/// The corner of a change of side: where the old and the new offset curve intersect.
pub(super) fn side_change(
    at: Vec2,
    end: &OffsetEdge,
    start: &OffsetEdge,
    tolerance: f64,
) -> CornerPath {
    match meeting(at, end, start, tolerance) {
        Some(point) => CornerPath::at(point),
        None => CornerPath::at(at + start.normal * start.radius),
    }
}
