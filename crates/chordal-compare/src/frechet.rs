//! The Fréchet distance between two polylines, after Alt and Godau (1995).

use chordal::geometry::Vec3;

/// The most cells of a free-space diagram, for time and memory; longer polylines keep the bound of their coupling.
pub(crate) const MAX_CELLS: usize = 1 << 20;

/// An upper bound of the Fréchet distance between two polylines, mm: the smallest distance within which two points
/// can move along both from beginning to end without going back. It exceeds the exact value by at most `precision`
/// (mm) and is at most `most`, which must itself be an upper bound.
pub(crate) fn frechet(a: &[Vec3], b: &[Vec3], most: f64, precision: f64) -> f64 {
    let (Some(first), Some(last)) = (a.first().zip(b.first()), a.last().zip(b.last())) else {
        return most;
    };
    let mut low = (*first.0 - *first.1).length().max((*last.0 - *last.1).length());
    let mut high = most;
    if low >= high || reachable(a, b, low) {
        return low.min(high);
    }
    while high - low > precision {
        let middle = low + (high - low) / 2.0;
        if middle <= low || middle >= high {
            break;
        }
        if reachable(a, b, middle) { high = middle } else { low = middle }
    }
    high
}

/// The part of a line that lies within a distance of a point, as fractions of the line; `None` when there is none.
fn within(place: Vec3, from: Vec3, to: Vec3, distance: f64) -> Option<(f64, f64)> {
    let (path, off) = (to - from, place - from);
    let square = path.length_squared();
    if square == 0.0 {
        return (off.length() <= distance).then_some((0.0, 1.0));
    }
    let foot = off.dot(path) / square;
    let aside = (off - path * foot).length_squared();
    let rest = (distance * distance - aside) / square;
    if rest < 0.0 {
        return None;
    }
    let half = rest.sqrt();
    let (from, to) = ((foot - half).max(0.0), (foot + half).min(1.0));
    (from <= to).then_some((from, to))
}

type FreeInterval = Option<(f64, f64)>;

/// Whether a monotone path leads from the beginning of the free-space diagram to its end.
///
/// `below[i]` is the reachable part of line i of `a` at point j of `b`, and `left` the reachable part of line j of
/// `b` at point i of `a`.
fn reachable(a: &[Vec3], b: &[Vec3], distance: f64) -> bool {
    let (n, m) = (a.len() - 1, b.len() - 1);
    let is_near = |a: Vec3, b: Vec3| (a - b).length() <= distance;
    if !(is_near(a[0], b[0]) && is_near(a[n], b[m])) {
        return false;
    }
    if n == 0 || m == 0 {
        let (point, chain) = if n == 0 { (a[0], b) } else { (b[0], a) };
        return chain.iter().all(|place| is_near(point, *place));
    }
    // Along the lower edge, points are reachable only up to the first gap in the free space.
    let mut below: Vec<FreeInterval> = vec![None; n];
    let mut is_open = true;
    for i in 0..n {
        let free = within(b[0], a[i], a[i + 1], distance);
        below[i] = free.filter(|free| is_open && free.0 == 0.0);
        is_open = below[i].is_some_and(|free| free.1 == 1.0);
    }
    let mut first_left_open = true;
    for j in 0..m {
        let free = within(a[0], b[j], b[j + 1], distance);
        let mut left = free.filter(|free| first_left_open && free.0 == 0.0);
        first_left_open = left.is_some_and(|free| free.1 == 1.0);
        for i in 0..n {
            let right = within(a[i + 1], b[j], b[j + 1], distance);
            let top = within(b[j + 1], a[i], a[i + 1], distance);
            let (from_left, from_below) = (left, below[i]);
            // The free space in a cell is convex: from its lower edge the whole free right edge is reachable, from
            // its left edge only what lies at or above the lowest reachable point.
            left = onward(right, from_below, from_left);
            below[i] = onward(top, from_left, from_below);
        }
        if j + 1 == m {
            return left.is_some_and(|free| free.1 == 1.0);
        }
    }
    false
}

/// The reachable part of an edge, from the adjacent edge (`across`) and from the opposite edge.
fn onward(edge: FreeInterval, across: FreeInterval, opposite: FreeInterval) -> FreeInterval {
    let (from, to) = edge?;
    if across.is_some() {
        return Some((from, to));
    }
    let from = from.max(opposite?.0);
    (from <= to).then_some((from, to))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(points: &[[f64; 2]]) -> Vec<Vec3> {
        points.iter().map(|p| Vec3::new(p[0], p[1], 0.0)).collect()
    }

    fn distance(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
        frechet(&chain(a), &chain(b), 1e3, 1e-9)
    }

    #[test]
    fn a_line_in_pieces_is_the_same_line() {
        let cut = [[0.0, 0.0], [3.0, 0.0], [4.0, 0.0], [10.0, 0.0]];
        assert!(distance(&[[0.0, 0.0], [10.0, 0.0]], &cut) < 1e-8);
    }

    #[test]
    fn parallel_lines() {
        let found = distance(&[[0.0, 0.0], [10.0, 0.0]], &[[0.0, 2.0], [5.0, 2.0], [10.0, 2.0]]);
        assert!((found - 2.0).abs() < 1e-8, "{found}");
    }

    /// As sets of points these are equal; moving along both, one point must wait halfway along the return.
    #[test]
    fn going_back_and_forth_is_another_path() {
        let forth = [[0.0, 0.0], [10.0, 0.0]];
        let back = [[0.0, 0.0], [7.0, 0.0], [3.0, 0.0], [10.0, 0.0]];
        let found = distance(&forth, &back);
        assert!((found - 2.0).abs() < 1e-8, "{found}");
    }

    #[test]
    fn the_other_way_round() {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]];
        let mut other = square;
        other.reverse();
        // Both begin and end at the same corner and meet again halfway; between, they are a quarter of the square
        // apart.
        let found = distance(&square, &other);
        assert!(found > 3.9 && found < 4.1 * 2f64.sqrt(), "{found}");
    }

    /// Compared with the discrete distance over many samples, which exceeds the exact one by at most a step.
    #[test]
    fn as_samples_say() {
        let a = [[0.0, 0.0], [3.0, 1.0], [5.0, -2.0], [9.0, 0.5]];
        let b = [[0.2, 0.1], [2.0, 2.0], [6.0, -1.0], [6.5, -2.5], [9.0, 0.0]];
        let samples = |points: &[[f64; 2]]| -> Vec<Vec3> {
            let points = chain(points);
            let lines = points.windows(2);
            lines
                .flat_map(|ends| {
                    let (from, to) = (ends[0], ends[1]);
                    (0..=100).map(move |i| from + (to - from) * (f64::from(i) / 100.0))
                })
                .collect()
        };
        let (p, q) = (samples(&a), samples(&b));
        let mut row = vec![f64::INFINITY; q.len()];
        for (i, x) in p.iter().enumerate() {
            let mut corner = f64::INFINITY;
            for (j, y) in q.iter().enumerate() {
                let before = if j > 0 { row[j - 1] } else { f64::INFINITY };
                let least = if i == 0 && j == 0 { 0.0 } else { row[j].min(before).min(corner) };
                corner = row[j];
                row[j] = least.max((*x - *y).length());
            }
        }
        let sampled = row[q.len() - 1];
        let found = distance(&a, &b);
        assert!(found <= sampled + 1e-9 && found >= sampled - 0.06, "{found}, sampled {sampled}");
    }
}
