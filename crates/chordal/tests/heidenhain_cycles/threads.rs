//! Threads: turns, hand, depth, feed, and the countersink at the front of the tool.

use super::shop::{
    CALLED_AT, NEAR_MM, START_MM, SeenMove, assert_ends, assert_near, cut_points, each_cycle,
};

const CLEARANCE: &[f64] = &[1.0, 2.0, 5.5];
const PLUNGE: &[f64] = &[100.0, 250.0, 333.0];
const MILL: &[f64] = &[500.0, 750.0, 612.0];
const INFEED: &[f64] = &[2.0, 5.0, 60.0];
const SURFACE: &[f64] = &[0.0, 10.0, -4.25];
const SECOND: &[f64] = &[0.0, 3.0, 50.0];

/// The helices of a thread: turns, the levels of both ends, and the feed.
fn helices(seen: &[SeenMove]) -> Vec<(f64, f64, f64, f64)> {
    let mut found = Vec::new();
    let mut at = START_MM;
    for step in seen {
        let Some(to) = step.to() else { continue };
        if let SeenMove::Round(_, _, sweep, feed) = step
            && (to[2] - at).abs() > 1e-9
        {
            found.push((sweep / std::f64::consts::TAU, at, to[2], *feed));
        }
        at = to[2];
    }
    found
}

/// Words that cycles 262 to 267 share.
const THREAD: &[(u32, &[f64])] = &[
    (335, &[20.0, 24.0, 30.0]),
    (239, &[1.5, -2.0, 2.5]),
    (201, &[-9.0, -16.5, -20.0]),
    (355, &[0.0, 1.0, 3.0]),
    (356, &[-18.0, -22.0, -24.0]),
    (253, &[750.0, 800.0, 900.0]),
    (351, &[1.0, -1.0, 1.0]),
    (202, INFEED),
    (258, &[0.2, 0.3, 0.5]),
    (358, &[0.0, -0.5, -1.5]),
    (359, &[1.0, 2.0, 2.5]),
    (360, &[0.0, 1.0, 1.0]),
    (200, CLEARANCE),
    (203, SURFACE),
    (204, SECOND),
    (206, PLUNGE),
    (254, &[150.0, 160.0, 170.0]),
    (207, MILL),
];

#[test]
fn threads_262_to_267() {
    for number in [262, 263, 264, 265, 267] {
        each_cycle(number, THREAD, 5.0, |data, seen| {
            let (top, bottom, end) = data.levels();
            assert_ends(seen, top, end, data);
            let is_outside = number == 267;
            let (edge, pitch, depth) = (data.of(335) / 2.0, data.of(239), -data.of(201));
            let radius = if is_outside { edge + 5.0 } else { edge - 5.0 };
            let found = helices(seen);
            // F counts at the edge that cuts.
            let feed = data.of(207) * radius / edge;
            // A right-hand thread goes counter-clockwise upwards or clockwise downwards; climb milling is
            // counter-clockwise inside and clockwise outside; cycle 265 always goes down.
            let climbs = data.of(351) >= 0.0;
            let is_counter = if number == 265 { pitch < 0.0 } else { climbs != is_outside };
            let goes_up = is_counter == (pitch > 0.0);
            let per_step = if matches!(number, 262 | 267) { data.of(355) } else { 1.0 };
            let whole = (depth / pitch.abs() - 1e-9).ceil();
            let (count, turns) = match per_step as u32 {
                0 => (1, 1.0),
                1 => (1, whole),
                steps => ((depth / (f64::from(steps) * pitch.abs()) - 1e-9).ceil() as usize, 1.0),
            };
            assert_eq!(found.len(), count, "{data:?}");
            for (index, (sweep, from, to, own)) in found.iter().enumerate() {
                assert_near(sweep.abs(), turns, "the turns", data);
                assert_eq!(*sweep > 0.0, is_counter, "{data:?}");
                assert_near((to - from).abs(), turns * pitch.abs(), "the height", data);
                assert_eq!(to > from, goes_up, "{data:?}");
                assert_near(
                    from.min(*to),
                    bottom + index as f64 * per_step * pitch.abs(),
                    "the end",
                    data,
                );
                assert_near(*own, feed, "the feed", data);
            }
            // The helix keeps its radius; the front of the tool is Q359 from the centre on the level Q358.
            let near = |point: &[f64; 3]| (point[0] - CALLED_AT[0]).hypot(point[1] - CALLED_AT[1]);
            let front = data.of(203) + data.of(358);
            let points = cut_points(seen);
            let has_front = data.of(358) != 0.0 && number != 262;
            if has_front {
                let full = seen.iter().any(|step| {
                    matches!(step, SeenMove::Round(to, center, sweep, feed)
                        if (to[2] - front).abs() < NEAR_MM
                            && (sweep.abs() - std::f64::consts::TAU).abs() < NEAR_MM
                            && (center[0] - CALLED_AT[0]).abs() < NEAR_MM
                            && (near(to) - data.of(359)).abs() < NEAR_MM
                            && (feed - data.of(254)).abs() < NEAR_MM)
                });
                assert!(full, "the circle of the countersink {data:?}");
            }
            let on_helix = |point: &[f64; 3]| !has_front || (point[2] - front).abs() > 1e-6;
            let reach =
                points.iter().filter(|(point, _)| point[2] < data.of(203) && on_helix(point));
            let reach: Vec<f64> = reach.map(|(point, _)| near(point)).collect();
            match is_outside {
                true => {
                    let least = reach.iter().copied().fold(f64::INFINITY, f64::min);
                    assert_near(least, radius, "the thread", data);
                }
                false => {
                    let most = reach.iter().copied().fold(0.0, f64::max);
                    assert_near(most, radius, "the thread", data);
                }
            }
            if number == 264 {
                let lowest = points.iter().map(|(point, _)| point[2]).fold(f64::INFINITY, f64::min);
                assert_near(lowest, (data.of(203) + data.of(356)).min(bottom), "the hole", data);
            }
        });
    }
}
