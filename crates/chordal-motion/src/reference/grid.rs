//! The grid of the reference: evenly spaced in time, so that it is dense near rest, where
//! b = σ̇² grows as σ^{4/3} and no polynomial in σ follows it.

use chordal_geometry::AXES;

use super::ReferenceQuality;
use crate::cube_root::cbrt;
use crate::time_bound::{PathRun, TimeBound};

/// Nodes this near to a seam, as a share of an interval, are left out.
const SEAM_CLEARANCE_SHARE: f64 = 0.3;
/// Seams are at least this share of an interval apart.
const MIN_SEAM_SPACING_SHARE: f64 = 1e-4;
/// Steps of less than this share of a limit are none.
const NEGLIGIBLE_STEP_SHARE: f64 = 1e-3;

/// Places and a first guess of b there.
#[derive(Clone, Debug)]
pub(crate) struct ReferenceGrid {
    /// σ from the start.
    pub(crate) sigma: Vec<f64>,
    /// The profile without jerk, eased at rest: b at the nodes, above zero but at ends at rest.
    pub(crate) square: Vec<f64>,
    /// Whether the first node is at rest.
    pub(crate) from_rest: bool,
    /// The time between nodes that was aimed at, s.
    pub(crate) step_s: f64,
}

/// The jerk along the path that the axes can do at a place where they are at rest.
pub(crate) fn jerk_at_rest(run: &PathRun<'_>, sigma: f64) -> f64 {
    let jet = run.jet(run.piece_at(sigma), sigma);
    let limits = run.limits().jerk();
    (0..AXES)
        .filter(|axis| jet[1][*axis] != 0.0)
        .fold(f64::MAX, |least, axis| least.min(limits[axis] / jet[1][axis].abs()))
}

/// b after a distance from rest at even jerk: σ = jt³/6 and σ̇ = jt²/2.
pub(crate) fn square_from_rest(jerk: f64, distance: f64) -> f64 {
    let root = cbrt(4.5 * jerk * distance * distance);
    root * root
}

impl ReferenceGrid {
    pub(crate) fn new(
        run: &PathRun<'_>,
        bound: &TimeBound,
        effort: &ReferenceQuality,
    ) -> ReferenceGrid {
        let length = run.length();
        let from_rest = bound.square[0] <= 0.0;
        let jerks = [jerk_at_rest(run, 0.0), jerk_at_rest(run, length)];
        let eased = |sigma: f64, square: f64| {
            let mut eased = square.min(square_from_rest(jerks[1], length - sigma));
            if from_rest {
                eased = eased.min(square_from_rest(jerks[0], sigma));
            }
            eased
        };
        let fine = refined(bound, length, from_rest);
        let profile: Vec<(f64, f64)> = fine.iter().map(|(s, b)| (*s, eased(*s, *b))).collect();
        let clock = clock(&profile, from_rest);
        let total = clock[clock.len() - 1];
        let count = (total / effort.step_s)
            .ceil()
            .clamp(effort.least_nodes.max(8) as f64, effort.most_nodes.max(8) as f64);
        let step_s = total / count;
        let mut sigma = even_in_time(&profile, &clock, count as usize, from_rest);
        add_seams(run, &profile, &mut sigma, effort.most_nodes);
        let square = along(&profile, &sigma, &eased);
        ReferenceGrid { sigma, square, from_rest, step_s }
    }
}

/// The nodes of the bound with more of them near rest, in a geometric series.
fn refined(bound: &TimeBound, length: f64, from_rest: bool) -> Vec<(f64, f64)> {
    let mut places = bound.sigma.clone();
    let mut distance = 0.25 * length;
    for _ in 0..100 {
        if from_rest {
            places.push(distance);
        }
        places.push(length - distance);
        distance *= 0.8;
    }
    places.retain(|place| *place >= 0.0 && *place <= length);
    places.sort_by(f64::total_cmp);
    places.dedup();
    let mut interval = 0;
    places
        .into_iter()
        .map(|place| {
            while interval + 2 < bound.sigma.len() && bound.sigma[interval + 1] < place {
                interval += 1;
            }
            let (s0, s1) = (bound.sigma[interval], bound.sigma[interval + 1]);
            let share = ((place - s0) / (s1 - s0)).clamp(0.0, 1.0);
            let square =
                bound.square[interval] * (1.0 - share) + bound.square[interval + 1] * share;
            (place, square)
        })
        .collect()
}

/// The time at each place of a profile; next to rest three times the distance by the speed.
fn clock(profile: &[(f64, f64)], from_rest: bool) -> Vec<f64> {
    let mut clock = vec![0.0];
    let mut now = 0.0;
    for (index, ends) in profile.windows(2).enumerate() {
        let distance = ends[1].0 - ends[0].0;
        let speeds = ends[0].1.max(0.0).sqrt() + ends[1].1.max(0.0).sqrt();
        let rest = (index == 0 && from_rest) || index + 2 == profile.len();
        let factor = if rest { 3.0 } else { 2.0 };
        now += if speeds > 0.0 { factor * distance / speeds } else { 0.0 };
        clock.push(now);
    }
    clock
}

fn even_in_time(profile: &[(f64, f64)], clock: &[f64], count: usize, from_rest: bool) -> Vec<f64> {
    let (total, length) = (clock[clock.len() - 1], profile[profile.len() - 1].0);
    let mut sigma = vec![0.0];
    let mut index = 0;
    for node in 1..count {
        let now = total * node as f64 / count as f64;
        while index + 2 < clock.len() && clock[index + 1] <= now {
            index += 1;
        }
        let span = clock[index + 1] - clock[index];
        let mut share =
            if span > 0.0 { ((now - clock[index]) / span).clamp(0.0, 1.0) } else { 0.0 };
        // Next to rest the distance grows as the cube of the time.
        if index == 0 && from_rest {
            share = share * share * share;
        }
        let place = profile[index].0 + share * (profile[index + 1].0 - profile[index].0);
        if place > sigma[sigma.len() - 1] && place < length {
            sigma.push(place);
        }
    }
    sigma.push(length);
    sigma
}

/// Puts a node at each seam where the profile may have to change, in place of those close by.
fn add_seams(run: &PathRun<'_>, profile: &[(f64, f64)], sigma: &mut Vec<f64>, most: usize) {
    let mut seams: Vec<f64> = Vec::new();
    let (mut interval, mut at) = (0, 0);
    for index in 1..run.pieces().len() {
        let seam = run.from(index);
        while interval + 2 < sigma.len() && sigma[interval + 1] <= seam {
            interval += 1;
        }
        while at + 2 < profile.len() && profile[at + 1].0 <= seam {
            at += 1;
        }
        let width = sigma[interval + 1] - sigma[interval];
        let is_separate =
            seams.last().is_none_or(|last| seam - last > MIN_SEAM_SPACING_SHARE * width);
        if is_separate && steps(run, index, profile[at].1.max(profile[at + 1].1)) {
            seams.push(seam);
        }
    }
    if seams.len() > most {
        return;
    }
    let last = sigma.len() - 1;
    let mut next = 0;
    let mut merged = Vec::with_capacity(sigma.len() + seams.len());
    for (index, node) in sigma.iter().enumerate() {
        while next < seams.len() && seams[next] <= *node {
            merged.push(seams[next]);
            next += 1;
        }
        let inner = index > 0 && index < last;
        let width = if inner {
            SEAM_CLEARANCE_SHARE * (sigma[index + 1] - sigma[index - 1]) / 2.0
        } else {
            0.0
        };
        let close = |seam: Option<&f64>| seam.is_some_and(|seam| (seam - node).abs() < width);
        let before = next.checked_sub(1).and_then(|index| seams.get(index));
        if !(inner && (close(before) || close(seams.get(next)))) {
            merged.push(*node);
        }
    }
    merged.dedup();
    *sigma = merged;
}

/// Whether the feed, or curvature or its change along the path, has a step at the start of a piece
/// that matters at b.
fn steps(run: &PathRun<'_>, index: usize, square: f64) -> bool {
    let sigma = run.from(index);
    let (before, after) = (run.jet(index - 1, sigma), run.jet(index, sigma));
    let (accelerations, jerks) = (run.limits().acceleration(), run.limits().jerk());
    run.feed(index) != run.feed(index - 1)
        || (0..AXES).any(|axis| {
            let bend = (after[2][axis] - before[2][axis]).abs() * square;
            let change = (after[3][axis] - before[3][axis]).abs() * square * square.sqrt();
            bend > NEGLIGIBLE_STEP_SHARE * accelerations[axis]
                || change > NEGLIGIBLE_STEP_SHARE * jerks[axis]
        })
}

/// The profile at other places.
fn along(profile: &[(f64, f64)], places: &[f64], eased: &impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let mut interval = 0;
    places
        .iter()
        .map(|place| {
            while interval + 2 < profile.len() && profile[interval + 1].0 < *place {
                interval += 1;
            }
            let ((s0, b0), (s1, b1)) = (profile[interval], profile[interval + 1]);
            let share = ((place - s0) / (s1 - s0)).clamp(0.0, 1.0);
            eased(*place, b0 * (1.0 - share) + b1 * share)
        })
        .collect()
}
