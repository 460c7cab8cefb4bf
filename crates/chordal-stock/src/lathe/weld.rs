//! Merges points that lie together into one vertex.

use chordal_geometry::Vec2;

/// Points, and which of them are merged. Reused between runs to save allocations.
#[derive(Debug, Default)]
pub(crate) struct PointWeld {
    pub points: Vec<Vec2>,
    /// The representative of each point.
    first: Vec<u32>,
    order: Vec<u32>,
}

impl PointWeld {
    pub fn clear(&mut self) {
        self.points.clear();
    }

    pub fn push(&mut self, place: Vec2) -> u32 {
        self.points.push(place);
        (self.points.len() - 1) as u32
    }

    /// Merges points that are at most `tolerance` (mm) apart, where `may` allows it.
    pub fn join(&mut self, tolerance: f64, may: impl Fn(u32, u32) -> bool) {
        let Self { points, first, order } = self;
        first.clear();
        first.extend(0..points.len() as u32);
        order.clear();
        order.extend(0..points.len() as u32);
        order.sort_unstable_by(|x, y| {
            let (p, q) = (points[*x as usize], points[*y as usize]);
            p.a.total_cmp(&q.a).then(p.b.total_cmp(&q.b)).then(x.cmp(y))
        });
        for (rank, at) in order.iter().enumerate() {
            let place = points[*at as usize];
            for other in &order[rank + 1..] {
                let off = points[*other as usize] - place;
                if off.a > tolerance {
                    break;
                }
                if off.b.abs() <= tolerance && may(*at, *other) {
                    unite(first, *at, *other);
                }
            }
        }
    }

    /// The representative of the points that are merged with this one.
    pub fn root(&self, at: u32) -> u32 {
        root(&self.first, at)
    }
}

fn root(first: &[u32], mut at: u32) -> u32 {
    while first[at as usize] != at {
        at = first[at as usize];
    }
    at
}

fn unite(first: &mut [u32], one: u32, other: u32) {
    let (one, other) = (root(first, one), root(first, other));
    let (low, high) = (one.min(other), one.max(other));
    first[high as usize] = low;
}
