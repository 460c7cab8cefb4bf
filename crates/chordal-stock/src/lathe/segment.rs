//! Lines and arcs of an outline: the public form of the edges of a region.

use core::f64::consts::TAU;

use chordal_geometry::Vec2;

/// A line or an arc of an outline, with the move that made it. Points are (z, r) in mm: `a` is z along the axis, `b`
/// is r, the distance from the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutlineSegment {
    /// Its start, mm.
    pub start: Vec2,
    /// Its end, mm. An arc whose end is its start is a full circle.
    pub end: Vec2,
    /// The circle of an arc; `None` for a line.
    pub bend: Option<SegmentArc>,
    /// The number of the move that made it; segments of the initial stock keep the number they were given.
    pub tag: u32,
}

/// The circle of an arc, and its sense.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SegmentArc {
    /// The centre, mm.
    pub center: Vec2,
    /// The radius, mm.
    pub radius: f64,
    /// True for the sense from +z to +r: counter-clockwise with z to the right and r up.
    pub counterclockwise: bool,
}

impl OutlineSegment {
    /// A straight segment.
    #[must_use]
    pub fn line(start: Vec2, end: Vec2) -> OutlineSegment {
        OutlineSegment { start, end, bend: None, tag: 0 }
    }

    /// An arc about `center`. Its radius is the distance of `start` from it.
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

    /// The same segment with the number of a move.
    #[must_use]
    pub fn tagged(self, tag: u32) -> OutlineSegment {
        OutlineSegment { tag, ..self }
    }

    /// The angle of an arc, rad, positive counter-clockwise; zero for a line.
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
