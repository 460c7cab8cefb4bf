//! Divides a simple polygon into triangles, by ear clipping.

use chordal_geometry::Vec2;

/// Most corners, more than a tool's outline has: the search for ears takes cubic time.
const MAX_CORNERS: usize = 4096;

/// The counter-clockwise triangles of a counter-clockwise polygon; `None` where it crosses itself so that no ear is
/// found, or has too many corners.
pub(crate) fn triangles(corners: &[Vec2]) -> Option<Vec<[Vec2; 3]>> {
    let mut left: Vec<Vec2> = corners.to_vec();
    left.dedup();
    let mut found = Vec::new();
    if left.len() > MAX_CORNERS {
        return None;
    }
    while left.len() > 3 {
        let count = left.len();
        let at = |at: usize| [left[(at + count - 1) % count], left[at], left[(at + 1) % count]];
        if let Some(flat) = (0..count).find(|corner| doubled(at(*corner)) == 0.0) {
            left.remove(flat);
            continue;
        }
        let ear = (0..count).find(|corner| {
            let triangle = at(*corner);
            let others = left.iter().filter(|other| !triangle.contains(other));
            doubled(triangle) > 0.0 && !others.copied().any(|other| holds(triangle, other))
        })?;
        found.push(at(ear));
        left.remove(ear);
    }
    if let [a, b, c] = left[..] {
        match doubled([a, b, c]) {
            area if area > 0.0 => found.push([a, b, c]),
            area if area < 0.0 => return None,
            _ => {}
        }
    }
    (!found.is_empty()).then_some(found)
}

/// Twice the signed area.
fn doubled([a, b, c]: [Vec2; 3]) -> f64 {
    (b - a).cross(c - b)
}

fn holds([a, b, c]: [Vec2; 3], p: Vec2) -> bool {
    let sides = [(a, b), (b, c), (c, a)];
    sides.iter().all(|(from, to)| (*to - *from).cross(p - *from) >= 0.0)
}
