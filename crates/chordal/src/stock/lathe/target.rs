//! The target part: where cuts go into it, and what is left on it.

use chordal_geometry::Vec2;
use chordal_stock::lathe::{LatheStock, OutlineSegment, Region};

use super::bodies::{is_on_axis, without_skin};
use super::report::TurnedTarget;

/// A target part with its tolerance, mm, and the core that no cut may reach.
pub(super) struct TurnedTargetPart {
    pub section: Region,
    pub tolerance: f64,
    /// The part without a skin as thick as the tolerance. Cuts into it are removed from it, so that each is reported
    /// once.
    pub core: LatheStock,
}

impl TurnedTargetPart {
    pub fn new(section: Region, tolerance: f64) -> TurnedTargetPart {
        let core = without_skin(&section, &section, tolerance);
        TurnedTargetPart { core, section, tolerance }
    }

    /// Depth (mm) and place of the deepest point of what was removed from the part; `None` where nothing was.
    pub fn depth(&self, removed: &Region) -> Option<(f64, Vec2)> {
        farthest(removed, &self.section)
    }

    /// Compares what is left with the part. The bar in the chuck behind the part does not count.
    pub fn compare(&self, sections: &[&Region]) -> TurnedTarget {
        let mut answer =
            TurnedTarget { left_over_mm3: 0.0, highest_mm: 0.0, at: Vec2::ZERO, gouged_mm3: 0.0 };
        let Some((low, high)) = self.section.bounds() else { return answer };
        let mut missing = self.section.clone();
        for section in sections {
            let Some((from, to)) = section.bounds() else { continue };
            if let Ok(rest) = missing.difference(section) {
                missing = rest.region;
            }
            // A section that does not overlap the part along Z is another part.
            if to.a <= low.a || from.a >= high.a {
                continue;
            }
            let Ok(over) = section.difference(&self.section) else { continue };
            let mut over = over.region;
            if from.a < low.a
                && let Ok(bar) = Region::bar(2.0 * to.b, from.a - 1.0, low.a)
                && let Ok(rest) = over.difference(&bar)
            {
                over = rest.region;
            }
            answer.left_over_mm3 += over.volume();
            if let Some((height, at)) = farthest(&over, &self.section)
                && height > answer.highest_mm
            {
                (answer.highest_mm, answer.at) = (height, at);
            }
        }
        answer.gouged_mm3 = missing.volume().max(0.0);
        answer
    }
}

/// Sample points on a segment at which distances are measured.
const POINTS: u32 = 64;

/// The sample point of a region's outline that is farthest from the outline `from`, and its distance, mm.
fn farthest(region: &Region, from: &Region) -> Option<(f64, Vec2)> {
    let outline: Vec<OutlineSegment> =
        from.shape().into_iter().flatten().filter(|segment| !is_on_axis(segment)).collect();
    let near =
        |p: Vec2| outline.iter().map(|segment| distance(segment, p)).fold(f64::INFINITY, f64::min);
    let points = region.shape().into_iter().flatten().flat_map(|segment| {
        (0..POINTS).map(move |at| point_at(&segment, f64::from(at) / f64::from(POINTS)))
    });
    points.map(|p| (near(p), p)).max_by(|x, y| x.0.total_cmp(&y.0))
}

fn point_at(segment: &OutlineSegment, part: f64) -> Vec2 {
    match segment.bend {
        None => segment.start + (segment.end - segment.start) * part,
        Some(bend) => {
            let (sine, cosine) = libm::sincos(segment.sweep() * part);
            let to = segment.start - bend.center;
            bend.center + to * cosine + to.turned_left() * sine
        }
    }
}

fn distance(segment: &OutlineSegment, p: Vec2) -> f64 {
    let ends = segment.start.distance(p).min(segment.end.distance(p));
    match segment.bend {
        None => {
            let path = segment.end - segment.start;
            let square = path.dot(path);
            if square == 0.0 {
                return ends;
            }
            let part = ((p - segment.start).dot(path) / square).clamp(0.0, 1.0);
            p.distance(segment.start + path * part)
        }
        Some(bend) => {
            let on = OutlineSegment::arc(segment.start, p, bend.center, bend.counterclockwise);
            let within = on.sweep().abs() <= segment.sweep().abs();
            if within { (p.distance(bend.center) - bend.radius).abs() } else { ends }
        }
    }
}
