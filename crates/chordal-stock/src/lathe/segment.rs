//! Lines and arcs of an outline, as they come in and go out.

use core::f64::consts::TAU;

use chordal_geometry::Vec2;

/// A line or an arc of an outline, with the move that made it. Points are (z, r) in mm: `a` is z, along
/// the axis, `b` is r, from the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutlineSegment {
    /// Where it begins.
    pub start: Vec2,
    /// Where it ends. An arc that ends where it begins is a whole circle.
    pub end: Vec2,
    /// `None` for a line.
    pub bend: Option<SegmentArc>,
    /// The number of the move that made it; what it was before the first move has the number it was given.
    pub tag: u32,
}

/// The circle of an arc and the sense in which it is travelled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SegmentArc {
    /// The centre, mm.
    pub center: Vec2,
    /// The radius, mm.
    pub radius: f64,
    /// From z towards r. Seen with z to the right and r up.
    pub counterclockwise: bool,
}

impl OutlineSegment {
    /// A straight segment.
    #[must_use]
    pub fn line(start: Vec2, end: Vec2) -> OutlineSegment {
        OutlineSegment { start, end, bend: None, tag: 0 }
    }

    /// An arc about `center`. Its radius is the distance of the start.
    #[must_use]
    pub fn arc(start: Vec2, end: Vec2, center: Vec2, counterclockwise: bool) -> OutlineSegment {
        let radius = start.distance(center);
        OutlineSegment {
            start,
            end,
            bend: Some(SegmentArc { center, radius, counterclockwise }),
            tag: 0,
        }
    }

    /// The same with the number of a move.
    #[must_use]
    pub fn tagged(self, tag: u32) -> OutlineSegment {
        OutlineSegment { tag, ..self }
    }

    /// The angle it turns, rad, positive counter-clockwise; zero for a line.
    #[must_use]
    pub fn sweep(&self) -> f64 {
        let Some(bend) = self.bend else { return 0.0 };
        let angle = |p: Vec2| libm::atan2(p.b - bend.center.b, p.a - bend.center.a);
        let turned = angle(self.end) - angle(self.start);
        let turned = if bend.counterclockwise { turned } else { -turned };
        let mut turned = turned.rem_euclid(TAU);
        if turned == 0.0 {
            turned = if self.start == self.end { TAU } else { 0.0 };
        }
        if bend.counterclockwise { turned } else { -turned }
    }
}
