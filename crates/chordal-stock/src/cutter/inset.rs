//! Insets of cutters given by an outline. The inset's surface is the envelope of circles about the outline's points,
//! bounded from both sides by polygons of chords and of tangents.

use libm::{cos, sin};

use super::{CutterError, CutterProfile};
use chordal_geometry::tolerance::COINCIDENT_MM;

/// Chords of half a circle: they are within 0.5 % of the radius of it.
const CHORDS: u32 = 16;
/// Outlines with more points have no inset.
const MAX_POINTS: usize = 100;
/// A straight piece of a surface, from one radius to a larger one.
#[derive(Clone, Copy, Debug)]
struct SurfacePiece {
    from: [f64; 2],
    to: [f64; 2],
}

impl SurfacePiece {
    fn height_at(&self, radius: f64) -> f64 {
        let share = (radius - self.from[0]) / (self.to[0] - self.from[0]);
        self.from[1] + (self.to[1] - self.from[1]) * share
    }

    fn has(&self, radius: f64) -> bool {
        self.from[0] <= radius && radius <= self.to[0]
    }

    /// The radius at which two pieces cross; `None` where they do not.
    fn crossing(&self, other: &SurfacePiece) -> Option<f64> {
        let slope =
            |piece: &SurfacePiece| (piece.to[1] - piece.from[1]) / (piece.to[0] - piece.from[0]);
        let separate = slope(self) - slope(other);
        if separate == 0.0 {
            return None;
        }
        let radius = (other.from[1] - self.from[1] + slope(self) * self.from[0]
            - slope(other) * other.from[0])
            / separate;
        (self.has(radius) && other.has(radius)).then_some(radius)
    }
}

impl CutterProfile {
    /// The inset by `depth` (mm) of a cutter with an outline as in [`CutterProfile::outline`], as two cutters with
    /// the same tip: the first contains the inset, the second is contained in it. They differ by at most a hundredth
    /// of the depth. `None` where nothing is left, or the outline has more than 100 points.
    ///
    /// # Errors
    /// As [`CutterProfile::outline`].
    pub fn outline_inside(
        points: &[[f64; 2]],
        depth: f64,
    ) -> Result<Option<[CutterProfile; 2]>, CutterError> {
        let whole = CutterProfile::outline(points)?;
        let reach = whole.radius() - depth;
        if reach <= COINCIDENT_MM || points.len() > MAX_POINTS || depth <= 0.0 || !depth.is_finite()
        {
            return Ok(None);
        }
        let mut made = [Vec::new(), Vec::new()];
        for (tangents, points_of) in [false, true].into_iter().zip(&mut made) {
            let pieces = pieces(points, depth, tangents);
            *points_of = outline(&pieces, reach);
        }
        let [holds, within] = made.map(|points| CutterProfile::outline(&points));
        Ok(Some([holds?, within?]))
    }
}

/// The pieces whose upper envelope is the surface of the inset, with circles as chords or as tangents.
fn pieces(points: &[[f64; 2]], depth: f64, tangents: bool) -> Vec<SurfacePiece> {
    // Points of radius and height, from the axis on.
    let first = [0.0, points[0][0]];
    let corners: Vec<[f64; 2]> = core::iter::once(first)
        .chain(points.iter().map(|&[height, radius]| [radius, height]))
        .collect();
    let mut pieces = Vec::new();
    let mut add = |from: [f64; 2], to: [f64; 2]| {
        if to[0] - from[0] > COINCIDENT_MM {
            pieces.push(SurfacePiece { from, to });
        }
    };
    for pair in corners.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        if b[0] - a[0] <= COINCIDENT_MM {
            continue;
        }
        let slope = (b[1] - a[1]) / (b[0] - a[0]);
        let arm = depth / (1.0 + slope * slope).sqrt();
        let moved = |[radius, height]: [f64; 2]| [radius - slope * arm, height + arm];
        let [a, b] = [moved(a), moved(b)];
        add(a, b);
        // The mirror image on the other side of the axis.
        add([-b[0], b[1]], [-a[0], a[1]]);
    }
    let circle = circle(depth, tangents);
    for &[radius, height] in &corners {
        for middle in [radius, -radius] {
            for pair in circle.windows(2) {
                let moved = |[x, y]: [f64; 2]| [middle + x, height + y];
                add(moved(pair[0]), moved(pair[1]));
            }
            if radius <= COINCIDENT_MM {
                break;
            }
        }
    }
    pieces
}

/// The upper half of a circle, from left to right.
fn circle(radius: f64, tangents: bool) -> Vec<[f64; 2]> {
    let step = core::f64::consts::PI / f64::from(CHORDS);
    let at = |angle: f64, radius: f64| [-radius * cos(angle), radius * sin(angle)];
    if tangents {
        let far = radius / cos(0.5 * step);
        return (0..CHORDS).map(|k| at(step * (f64::from(k) + 0.5), far)).collect();
    }
    (0..=CHORDS).map(|k| at(step * f64::from(k), radius)).collect()
}

/// The upper envelope of pieces from the axis to a radius, as points of height and radius, made to never fall.
fn outline(pieces: &[SurfacePiece], reach: f64) -> Vec<[f64; 2]> {
    let mut ends: Vec<f64> = vec![0.0, reach];
    let mut add = |radius: f64| {
        if radius > 0.0 && radius < reach {
            ends.push(radius);
        }
    };
    for (number, piece) in pieces.iter().enumerate() {
        add(piece.from[0]);
        add(piece.to[0]);
        for other in &pieces[number + 1..] {
            if other.from[0] <= piece.to[0] && piece.from[0] <= other.to[0] {
                piece.crossing(other).into_iter().for_each(&mut add);
            }
        }
    }
    ends.sort_by(f64::total_cmp);
    ends.dedup_by(|a, b| *a - *b <= COINCIDENT_MM);
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut high = f64::NEG_INFINITY;
    for pair in ends.windows(2) {
        let middle = 0.5 * (pair[0] + pair[1]);
        let over = pieces.iter().filter(|piece| piece.has(middle));
        let Some(top) = over.max_by(|a, b| a.height_at(middle).total_cmp(&b.height_at(middle)))
        else {
            continue;
        };
        for radius in [pair[0], pair[1]] {
            // Chords may fall slightly where the true surface does not.
            high = high.max(top.height_at(radius));
            points.push([high, radius]);
        }
    }
    // Points on a line with their neighbours are left out.
    let mut kept: Vec<[f64; 2]> = Vec::new();
    for point in points {
        if let [.., a, b] = kept[..] {
            let cross = (b[0] - a[0]) * (point[1] - a[1]) - (point[0] - a[0]) * (b[1] - a[1]);
            if cross == 0.0 {
                kept.pop();
            }
        }
        if kept.last() != Some(&point) {
            kept.push(point);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The surface so much inside of an outline, by places of the outline near together.
    fn sampled(points: &[[f64; 2]], depth: f64, radius: f64) -> f64 {
        let whole = CutterProfile::outline(points).unwrap();
        let count = 4000;
        (0..=count)
            .map(|k| {
                let away = depth * (2.0 * f64::from(k) / f64::from(count) - 1.0);
                let at = (radius + away).abs().min(whole.radius() - 1e-12);
                whole.height_at(at) + (depth * depth - away * away).max(0.0).sqrt()
            })
            .fold(f64::NEG_INFINITY, f64::max)
    }

    #[test]
    fn insets_of_outlines_stand_between_their_bounds() {
        let step: &[[f64; 2]] = &[[0.0, 1.0], [0.0, 3.0], [4.0, 3.0], [4.0, 6.0], [7.0, 8.0]];
        let point: &[[f64; 2]] = &[[0.0, 0.0], [2.0, 1.0], [2.3, 3.0], [9.0, 4.0]];
        // A round by chords, shorter than the depth, and a groove that the depth closes.
        let round: Vec<[f64; 2]> = (0..=40)
            .map(|k| {
                let angle = core::f64::consts::FRAC_PI_2 * f64::from(k) / 40.0;
                [2.0 * (1.0 - cos(angle)), 3.0 + 2.0 * sin(angle)]
            })
            .collect();
        for outline in [step, point, &round] {
            for depth in [0.02, 0.05, 0.3, 1.1] {
                let [holds, within] =
                    CutterProfile::outline_inside(outline, depth).unwrap().unwrap();
                let whole = CutterProfile::outline(outline).unwrap();
                assert_eq!(holds.radius(), whole.radius() - depth);
                assert_eq!(within.radius(), whole.radius() - depth);
                for k in 0..200 {
                    let radius = holds.radius() * (f64::from(k) + 0.37) / 200.0;
                    let [low, high] =
                        [0.99, 1.01].map(|share| sampled(outline, share * depth, radius));
                    let truth = sampled(outline, depth, radius);
                    let [holds, within] = [&holds, &within].map(|cutter| cutter.height_at(radius));
                    // A wall is found by samples to a step of theirs.
                    let found = [low - 1e-9, truth + 2e-3, truth - 2e-3, high + 1e-9];
                    let is_wall = found[3] - found[0] > 0.1 * depth + 0.05;
                    assert!(
                        is_wall || found[0] <= holds && holds <= found[1],
                        "{depth} {radius} {holds} {found:?}"
                    );
                    assert!(
                        is_wall || found[2] <= within && within <= found[3],
                        "{depth} {radius} {within} {found:?}"
                    );
                    assert!(holds <= within + 1e-12);
                }
            }
        }
        assert!(CutterProfile::outline_inside(step, 8.0).unwrap().is_none());
        assert!(CutterProfile::outline_inside(&[[1.0, 2.0], [0.0, 3.0]], 0.1).is_err());
    }
}
