//! The parts of a curve that are outside of circles.

use chordal_geometry::{Circle2, Line2, Vec2, circle_circle, fractions_at_angle, line_circle};

use super::shape::{GougeCurve, angle_of};

/// The parts of a curve that are outside of all circles with these centres and this radius, mm.
pub(super) fn outside(curve: &GougeCurve, centers: &[Vec2], radius: f64) -> Vec<GougeCurve> {
    let mut cuts = vec![0.0, 1.0];
    for center in centers {
        cuts.extend(crossings(curve, *center, radius).into_iter().filter(|t| *t > 0.0 && *t < 1.0));
    }
    cuts.sort_unstable_by(f64::total_cmp);
    let is_outside = |t: f64| centers.iter().all(|center| curve.at(t).distance(*center) > radius);
    let mut kept: Vec<[f64; 2]> = Vec::new();
    for pair in cuts.windows(2).filter(|pair| is_outside(0.5 * (pair[0] + pair[1]))) {
        match kept.last_mut().filter(|last| last[1] == pair[0]) {
            Some(last) => last[1] = pair[1],
            None => kept.push([pair[0], pair[1]]),
        }
    }
    kept.into_iter().map(|[first, last]| curve.piece(first, last)).collect()
}

/// The fractions of a curve at which it crosses a circle.
fn crossings(curve: &GougeCurve, about: Vec2, radius: f64) -> Vec<f64> {
    let circle = Circle2 { center: about, radius };
    match *curve {
        GougeCurve::Line { from, to } => {
            let path = to - from;
            let meeting = line_circle(Line2 { point: from, direction: path }, circle, 0.0);
            meeting.points().map(|p| (p - from).dot(path) / path.dot(path)).collect()
        }
        GougeCurve::Arc { center, radius: own, start, sweep } => {
            let meeting = circle_circle(Circle2 { center, radius: own }, circle, 0.0);
            let angles = meeting.points().map(|p| angle_of(p - center));
            angles.flat_map(|angle| fractions_at_angle(start, sweep, angle)).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use super::*;

    #[test]
    fn what_lies_within_a_circle_is_cut_out() {
        let line = GougeCurve::line(Vec2::new(-5.0, 0.0), Vec2::new(5.0, 0.0));
        let parts = outside(&line, &[Vec2::ZERO], 2.0);
        assert_eq!(parts.len(), 2);
        assert!((parts[0].to().a + 2.0).abs() < 1e-12 && (parts[1].from().a - 2.0).abs() < 1e-12);
        let ends = [Vec2::new(-5.0, 0.0), Vec2::new(5.0, 0.0)];
        let parts = outside(&line, &ends, 1.0);
        assert!(parts.len() == 1 && (parts[0].length() - 8.0).abs() < 1e-12);
        assert!(outside(&line, &ends, 5.0).is_empty());
    }

    /// Compares with a count of points on the arc.
    #[test]
    fn an_arc_is_cut_whichever_way_it_runs() {
        let centers = [Vec2::new(0.0, 3.0), Vec2::new(3.0, -1.0)];
        for (start, sweep) in [(0.4, TAU), (2.0, -TAU), (0.4, 1.5 * TAU), (-3.0, 2.0), (3.0, -4.0)]
        {
            let arc = GougeCurve::Arc { center: Vec2::ZERO, radius: 3.0, start, sweep };
            let parts = outside(&arc, &centers, 2.0);
            let is_outside = |t: f64| centers.iter().all(|c| arc.at(t).distance(*c) > 2.0);
            let count = 40_000;
            let kept = (0..count).filter(|k| is_outside((f64::from(*k) + 0.5) / f64::from(count)));
            let share = kept.count() as f64 / f64::from(count);
            let length: f64 = parts.iter().map(GougeCurve::length).sum();
            assert!((length / arc.length() - share).abs() < 3e-4, "{start} {sweep}");
        }
        let whole = GougeCurve::Arc { center: Vec2::ZERO, radius: 3.0, start: 0.4, sweep: TAU };
        assert_eq!(outside(&whole, &[Vec2::new(9.0, 0.0)], 2.0), vec![whole]);
        assert!(outside(&whole, &[Vec2::ZERO], 4.0).is_empty());
    }
}
