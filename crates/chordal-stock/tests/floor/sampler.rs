//! The second method: many places of a move, then golden sections about the lowest of them.

use chordal_geometry::{Curve, Vec3};

use crate::moves;

/// What a move does over a column in one window of it.
#[derive(Clone, Copy, Debug)]
pub struct Sampled {
    pub floor: f64,
    pub top: f64,
}

pub struct Over {
    pub windows: Vec<Sampled>,
    /// The rim passes so near to the column that it is for rounding to say whether it is reached.
    pub grazes: bool,
}

impl Over {
    pub fn floor(&self) -> Option<f64> {
        self.windows.iter().map(|window| window.floor).reduce(f64::min)
    }

    pub fn top(&self) -> Option<f64> {
        self.windows.iter().map(|window| window.top).reduce(f64::max)
    }
}

/// Samples for a whole turn.
const BY_TURN: f64 = 800.0;
/// A rim so near to the column, mm, grazes it.
const NEAR: f64 = 1e-7;

/// Where a function is least between two places: golden sections.
fn least(value: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> (f64, f64) {
    const SHARE: f64 = 0.618_033_988_749_894_8;
    const STEPS: u32 = 75;
    let (mut a, mut b) = (high - SHARE * (high - low), low + SHARE * (high - low));
    let (mut at_a, mut at_b) = (value(a), value(b));
    let mut best = if at_a <= at_b { (a, at_a) } else { (b, at_b) };
    for _ in 0..STEPS {
        if at_a <= at_b {
            (high, b, at_b) = (b, a, at_a);
            a = high - SHARE * (high - low);
            at_a = value(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = low + SHARE * (high - low);
            at_b = value(b);
        }
        for (x, y) in [(a, at_a), (b, at_b)] {
            if y < best.1 {
                best = (x, y);
            }
        }
    }
    best
}

/// The last place that is inside, on the way from one that is to one that is not.
fn edge(inside: impl Fn(f64) -> bool, mut from: f64, mut to: f64) -> f64 {
    const STEPS: u32 = 70;
    for _ in 0..STEPS {
        let middle = 0.5 * (from + to);
        *(if inside(middle) { &mut from } else { &mut to }) = middle;
    }
    from
}

/// The least value in a window: at its samples, and about those that are lower than their neighbours.
fn least_of(value: &dyn Fn(f64) -> f64, places: &[f64]) -> f64 {
    let values: Vec<f64> = places.iter().map(|t| value(*t)).collect();
    let mut best = f64::INFINITY;
    for (k, &here) in values.iter().enumerate() {
        best = best.min(here);
        let before = k.saturating_sub(1);
        let after = (k + 1).min(places.len() - 1);
        // Nothing is to be found on a level stretch.
        let is_level = before < k && k < after && here == values[before] && here == values[after];
        if here <= values[before] && here <= values[after] && !is_level {
            // On both sides by themselves too: there may be a step at the place.
            for [from, to] in [[before, after], [before, k], [k, after]] {
                best = best.min(least(value, places[from], places[to]).1);
            }
        }
    }
    best
}

/// A tool whose lower and upper sides are given by the distance from the axis, along a move; `edges` are the
/// radii at which its sides have corners, the last one is its own.
pub fn over(
    curve: &Curve,
    place: [f64; 2],
    edges: &[f64],
    lower: &dyn Fn(f64) -> f64,
    upper: &dyn Fn(f64) -> f64,
) -> Over {
    let radius = edges[edges.len() - 1];
    let distance = |p: Vec3| {
        let (x, y) = (p.x - place[0], p.y - place[1]);
        (x * x + y * y).sqrt()
    };
    let rho = |t: f64| distance(moves::point(curve, t));
    let count = (BY_TURN * moves::turns(curve)) as usize;
    let samples: Vec<f64> = (0..=count).map(|k| k as f64 / count as f64).collect();
    let distances: Vec<f64> = samples.iter().map(|t| rho(*t)).collect();
    let mut grazes = false;
    // The nearest and farthest places between samples too, so that no window is missed.
    let mut places = vec![samples[0]];
    for k in 1..=count {
        if k < count {
            let [a, b, c] = [distances[k - 1], distances[k], distances[k + 1]];
            let sign = if b <= a && b <= c {
                1.0
            } else if b >= a && b >= c {
                -1.0
            } else {
                0.0
            };
            // The farthest ones only where the rim may be so near.
            let rim = (b - radius).abs() <= (a - b).abs() + (c - b).abs() + NEAR;
            if sign > 0.0 || sign < 0.0 && rim {
                let (t, far) = least(|t| sign * rho(t), samples[k - 1], samples[k + 1]);
                grazes |= edges.iter().any(|edge| (sign * far - edge).abs() <= NEAR);
                if t < samples[k] {
                    places.extend([t, samples[k]]);
                } else {
                    places.extend([samples[k], t]);
                }
                continue;
            }
        }
        places.push(samples[k]);
    }
    for end in [0, count] {
        grazes |= edges.iter().any(|edge| (distances[end] - edge).abs() <= NEAR);
    }
    let mut corners = Vec::new();
    for (k, pair) in places.windows(2).enumerate() {
        let [a, b] = [rho(pair[0]), rho(pair[1])];
        for &edge_radius in &edges[..edges.len() - 1] {
            if (a <= edge_radius) != (b <= edge_radius) {
                let (from, to) = if a < b { (pair[0], pair[1]) } else { (pair[1], pair[0]) };
                corners.push(edge(|t| rho(t) <= edge_radius, from, to));
                // About a corner there may be a hollow that is narrower than the samples.
                let near = &places[k.saturating_sub(1)..(k + 3).min(places.len())];
                near.windows(2).for_each(|pair| push_between(&mut corners, pair[0], pair[1]));
            }
        }
    }
    places.extend(corners);
    places.sort_by(f64::total_cmp);
    let inside = |t: f64| rho(t) <= radius;
    let mut parts: Vec<Vec<f64>> = Vec::new();
    let mut was_inside = false;
    for (k, &t) in places.iter().enumerate() {
        let is_inside = inside(t);
        if is_inside && !was_inside {
            parts.push(Vec::new());
            if k > 0 {
                let begin = edge(inside, t, places[k - 1]);
                push_between(parts.last_mut().unwrap(), begin, t);
            }
        }
        if is_inside {
            parts.last_mut().unwrap().push(t);
        } else if was_inside {
            let end = edge(inside, places[k - 1], t);
            let part = parts.last_mut().unwrap();
            push_between(part, places[k - 1], end);
            part.push(end);
        }
        was_inside = is_inside;
    }
    let low = |t: f64| {
        let p = moves::point(curve, t);
        p.z + lower(distance(p).min(radius))
    };
    let high = |t: f64| {
        let p = moves::point(curve, t);
        -(p.z + upper(distance(p).min(radius)))
    };
    let windows = parts
        .iter()
        .map(|part| Sampled { floor: least_of(&low, part), top: -least_of(&high, part) });
    Over { windows: windows.collect(), grazes }
}

/// Some places more between two, so that a narrow window has some.
fn push_between(part: &mut Vec<f64>, from: f64, to: f64) {
    const COUNT: usize = 16;
    part.extend((0..COUNT).map(|k| from + (to - from) * k as f64 / COUNT as f64));
}
