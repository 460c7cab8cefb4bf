//! One interval of the grid: the speeds at its two ends that the accelerations of the axes allow.
//!
//! With x and y for b = σ̇² at its ends and b linear between them, the acceleration of an axis at
//! the start is q′(y − x)/2Δ + q″x, at the end q′(y − x)/2Δ + q″y: each limit is a strip in the
//! plane of x and y.

use chordal_geometry::AXES;

use super::PathRun;

/// A strip |cx·x + cy·y| ≤ limit.
#[derive(Clone, Copy, Debug)]
struct AccelerationStrip {
    cx: f64,
    cy: f64,
    limit: f64,
}

/// The speeds that are possible at the ends of an interval.
pub(crate) struct SpeedRegion {
    /// Largest b at its start from the speed limits alone.
    pub(crate) cap_from: f64,
    /// Largest b at its end from the speed limits alone.
    pub(crate) cap_to: f64,
    strips: [AccelerationStrip; 12],
    count: usize,
}

/// The largest number of corners of the convex polygon: each of the strips adds at most two.
struct SpeedPolygon {
    corners: [(f64, f64); 32],
    count: usize,
}

impl SpeedRegion {
    /// The region of the interval from `from` to `to` of a piece.
    pub(crate) fn new(run: &PathRun<'_>, piece: usize, from: f64, to: f64) -> SpeedRegion {
        let (first, last) = (run.jet(piece, from), run.jet(piece, to));
        let rate = 0.5 / (to - from);
        let limits = run.limits().acceleration();
        let square = |speed: f64| speed * speed;
        let mut room = SpeedRegion {
            cap_from: square(run.speed_cap(piece, &first)),
            cap_to: square(run.speed_cap(piece, &last)),
            strips: [AccelerationStrip { cx: 0.0, cy: 0.0, limit: 1.0 }; 12],
            count: 0,
        };
        for axis in 0..AXES {
            let limit = limits[axis];
            let (d0, d1) = (first[1][axis] * rate, last[1][axis] * rate);
            let (c0, c1) = (first[2][axis], last[2][axis]);
            let mut add = |cx: f64, cy: f64| {
                // A limit that the largest speeds cannot reach is left out.
                let reach = (cx * room.cap_from).abs() + (cy * room.cap_to).abs();
                if reach > limit {
                    room.strips[room.count] = AccelerationStrip { cx, cy, limit };
                    room.count += 1;
                }
            };
            add(c0 - d0, d0);
            if (c0, c1, d0) != (0.0, 0.0, d1) {
                add(-d1, c1 + d1);
            }
        }
        room
    }

    /// The largest b at the start from which a b of at most `to` at the end can be reached.
    pub(crate) fn largest_before(&self, to: f64) -> f64 {
        let mut polygon = SpeedPolygon::rectangle(self.cap_from, self.cap_to.min(to));
        for strip in &self.strips[..self.count] {
            polygon.clip(strip.cx, strip.cy, strip.limit);
            polygon.clip(-strip.cx, -strip.cy, strip.limit);
        }
        polygon.corners[..polygon.count].iter().fold(0.0, |best: f64, corner| best.max(corner.0))
    }

    /// The largest b at the end, at most `to`, when it is `from` at the start.
    pub(crate) fn largest_after(&self, from: f64, to: f64) -> f64 {
        let mut best = self.cap_to.min(to);
        for AccelerationStrip { cx, cy, limit } in self.strips[..self.count].iter().copied() {
            if cy != 0.0 {
                best = best.min((limit - cy.signum() * cx * from) / cy.abs());
            }
        }
        best.max(0.0)
    }
}

impl SpeedPolygon {
    fn rectangle(x: f64, y: f64) -> SpeedPolygon {
        let mut corners = [(0.0, 0.0); 32];
        corners[..4].copy_from_slice(&[(0.0, 0.0), (x, 0.0), (x, y), (0.0, y)]);
        SpeedPolygon { corners, count: 4 }
    }

    /// Reduces the polygon to the part with cx·x + cy·y ≤ limit. The origin is always inside.
    fn clip(&mut self, cx: f64, cy: f64, limit: f64) {
        let over = |(x, y): (f64, f64)| cx * x + cy * y - limit;
        let old = &self.corners[..self.count];
        if old.iter().all(|corner| over(*corner) <= 0.0) {
            return;
        }
        let mut clipped = [(0.0, 0.0); 32];
        let mut count = 0;
        let mut push = |corner| {
            if count < clipped.len() {
                clipped[count] = corner;
                count += 1;
            }
        };
        for (index, corner) in old.iter().copied().enumerate() {
            let next = old[(index + 1) % old.len()];
            let (here, there) = (over(corner), over(next));
            if here <= 0.0 {
                push(corner);
            }
            if (here < 0.0 && there > 0.0) || (here > 0.0 && there < 0.0) {
                let share = here / (here - there);
                push((
                    corner.0 + share * (next.0 - corner.0),
                    corner.1 + share * (next.1 - corner.1),
                ));
            }
        }
        *self = SpeedPolygon { corners: clipped, count };
    }
}
