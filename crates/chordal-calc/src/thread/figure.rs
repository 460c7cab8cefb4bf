//! The drawing of the 60° profile.

use chordal_geometry::Vec2;

use super::{INSIDE, MIDDLE, OUTSIDE, ThreadSize};
use crate::figure::{Figure, LineStyle};
use crate::math::PI;
use crate::numbers::{AnswerUnit, trimmed};

/// Two pitches of the profile: the hole's above, the bolt's root below.
pub(super) fn profile(thread: &ThreadSize, units: AnswerUnit) -> Figure {
    let p = thread.pitch;
    let (inside, root) = (INSIDE / 2.0 * p, OUTSIDE / 2.0 * p);
    let mut figure = Figure::default();
    let slope = 0.577_350_269_189_625_8;
    // Crest flat P/8 at the major diameter; flanks at 30° down to the root.
    let crest = p / 16.0;
    let mut last: Option<Vec2> = None;
    for turn in 0..3 {
        let middle = f64::from(turn) * p;
        let foot = crest + root * slope;
        let points = [
            Vec2::new(middle - foot, -root),
            Vec2::new(middle - crest, 0.0),
            Vec2::new(middle + crest, 0.0),
            Vec2::new(middle + foot, -root),
        ];
        if let Some(last) = last {
            figure.line(last, points[0], LineStyle::Part);
        }
        for pair in points.windows(2) {
            figure.line(pair[0], pair[1], LineStyle::Part);
        }
        last = Some(points[3]);
    }
    let (left, right) = (-0.75 * p, 2.75 * p);
    figure.line(Vec2::new(left, -inside), Vec2::new(right, -inside), LineStyle::Helper);
    figure.line(Vec2::new(left, 0.0), Vec2::new(right, 0.0), LineStyle::Helper);
    figure.line(
        Vec2::new(left, -MIDDLE / 2.0 * p),
        Vec2::new(right, -MIDDLE / 2.0 * p),
        LineStyle::Path,
    );
    let at = |share: f64| Vec2::new(right, share);
    figure.text(at(0.0), format!("D {}", units.number(thread.major)));
    figure.text(at(-MIDDLE / 2.0 * p), format!("D2 {}", units.number(thread.major - MIDDLE * p)));
    figure.text(at(-inside), format!("D1 {}", units.number(thread.minor_inside())));
    figure.text(Vec2::new(1.5 * p, -root), format!("d3 {}", units.number(thread.minor_outside())));
    figure.width(Vec2::ZERO, Vec2::new(p, 0.0), 0.42 * p, format!("P {}", units.number(p)));
    figure.height(
        Vec2::new(left, 0.0),
        Vec2::new(left, -inside),
        left - 0.22 * p,
        format!("t1 {}", units.number(inside)),
    );
    figure.height(
        Vec2::new(left, 0.0),
        Vec2::new(-p / 2.0, -root),
        left - 0.75 * p,
        format!("t3 {}", units.number(root)),
    );
    let vertex = Vec2::new(p / 2.0, -root - (p / 2.0 - crest - root * slope) / slope);
    let opening = PI / 6.0;
    figure.angle(
        vertex,
        0.75 * p,
        PI / 2.0 - opening,
        2.0 * opening,
        format!("{}°", trimmed(60.0, 0)),
    );
    figure
}
