//! Faces and ruled surfaces: limits, levels, feeds.

use super::shop::{
    CALLED_AT, CycleData, NEAR_MM, START_MM, SeenMove, assert_feeds, assert_levels, assert_near,
    cut_points, each_cycle, feeds,
};

const TOOL_MM: f64 = 8.0;
const FROM: &[f64] = &[0.0, 12.0, -20.5];
const LEVEL: &[f64] = &[0.0, 2.5, 6.0];

fn limits(seen: &[SeenMove], below: f64) -> [[f64; 2]; 2] {
    let points = cut_points(seen);
    let mut found = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for (point, _) in points.iter().filter(|(point, _)| point[2] < below) {
        for axis in 0..2 {
            found[axis] = [found[axis][0].min(point[axis]), found[axis][1].max(point[axis])];
        }
    }
    found
}

fn end_level(seen: &[SeenMove]) -> f64 {
    seen.iter().rev().find_map(SeenMove::to).expect("a move")[2]
}

#[test]
fn multipass_milling_230() {
    let words: &[(u32, &[f64])] = &[
        (225, FROM),
        (226, FROM),
        (227, LEVEL),
        (218, &[100.0, -60.0, 45.5]),
        (219, &[50.0, -30.0, 75.0]),
        (240, &[1.0, 5.0, 12.0]),
        (206, &[100.0, 150.0, 175.0]),
        (207, &[500.0, 400.0, 450.0]),
        (209, &[200.0, 250.0, 300.0]),
        (200, &[1.0, 2.0, 3.5]),
    ];
    each_cycle(230, words, TOOL_MM, |data, seen| {
        assert_levels(seen, &[data.of(227)], data);
        assert_near(end_level(seen), data.of(227) + data.of(200), "the end", data);
        let [x, y] = limits(seen, data.of(227) + 0.5);
        // It begins a radius before the face and ends at its end.
        let begin = data.of(225) - TOOL_MM * data.of(218).signum();
        let end = data.of(225) + data.of(218);
        assert_near(x[0], begin.min(end), "the limit", data);
        assert_near(x[1], begin.max(end), "the limit", data);
        let end = data.of(226) + data.of(219);
        assert_near(y[0], data.of(226).min(end), "the limit", data);
        assert_near(y[1], data.of(226).max(end), "the limit", data);
        let (down, across) = feeds(seen);
        assert_feeds(&down, &[data.of(206)], "plunging", data);
        assert_feeds(&across, &[data.of(207), data.of(209)], "milling", data);
    });
}

#[test]
fn ruled_surfaces_231() {
    let words: &[(u32, &[f64])] = &[
        (225, FROM),
        (226, FROM),
        (227, LEVEL),
        (228, &[100.0, 90.0, 80.0]),
        (229, &[0.0, 5.0, -5.0]),
        (230, LEVEL),
        (231, &[100.0, 110.0, 95.5]),
        (232, &[100.0, 90.0, 80.0]),
        (233, LEVEL),
        (234, FROM),
        (235, &[100.0, 95.0, 85.0]),
        (236, LEVEL),
        (240, &[1.0, 4.0, 9.0]),
        (207, &[500.0, 400.0, 450.0]),
    ];
    each_cycle(231, words, TOOL_MM, |data, seen| {
        let corner = |first: u32| [first, first + 1, first + 2].map(|number| data.of(number));
        let [one, two, three, four] = [225, 228, 231, 234].map(corner);
        let has = |place: [f64; 3]| {
            seen.iter()
                .filter_map(SeenMove::to)
                .any(|to| (0..3).all(|axis| (to[axis] - place[axis]).abs() < NEAR_MM))
        };
        assert!([one, two, three, four].into_iter().all(has), "{data:?}");
        // Each point of a cut line lies on a line between the two edges.
        let on_surface = |point: &[f64; 3]| {
            let steps = 0..=data.of(240) as u32;
            steps.map(|step| f64::from(step) / data.of(240)).any(|part| {
                let mix = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * part);
                let (from, to) = (mix(one, four), mix(two, three));
                let along = (0..3).map(|k| (to[k] - from[k]) * (point[k] - from[k])).sum::<f64>();
                let whole = (0..3).map(|k| (to[k] - from[k]).powi(2)).sum::<f64>();
                let t = along / whole;
                (0..3).all(|k| (from[k] + (to[k] - from[k]) * t - point[k]).abs() < NEAR_MM)
            })
        };
        let mut at = [CALLED_AT[0], CALLED_AT[1], START_MM];
        for step in seen {
            let Some(to) = step.to() else { continue };
            let is_cut = matches!(step, SeenMove::Cut(..));
            assert!(!is_cut || on_surface(&to), "{to:?} {at:?} {data:?}");
            at = to;
        }
        let highest = [one, two, three, four].iter().map(|p| p[2]).fold(f64::MIN, f64::max);
        assert_near(at[2], highest + 2.0 * TOOL_MM, "the end", data);
        let (_, across) = feeds(seen);
        // The first line is cut at half the feed.
        assert_near(across[0], data.of(207) / 2.0, "the first line", data);
        assert_feeds(&across[1..], &[data.of(207)], "milling", data);
    });
}

/// The levels of cycle 232: equal infeeds to the allowance, and the allowance.
fn face_levels(data: &CycleData) -> Vec<f64> {
    let height = data.of(227) - data.of(386) - data.of(369);
    let count = (height / data.of(202) - 1e-9).ceil().max(1.0);
    let mut levels: Vec<f64> =
        (1..=count as u32).map(|k| data.of(227) - height * f64::from(k) / count).collect();
    if data.of(369) > 0.0 {
        levels.push(data.of(386));
    }
    levels
}

#[test]
fn face_milling_232() {
    let words: &[(u32, &[f64])] = &[
        (389, &[0.0, 1.0, 2.0]),
        (225, FROM),
        (226, FROM),
        (227, LEVEL),
        (386, &[-1.0, -3.5, -7.0]),
        (218, &[100.0, -60.0, 45.5]),
        (219, &[50.0, -30.0, 75.0]),
        (202, &[1.0, 2.0, 10.0]),
        (369, &[0.0, 0.3, 0.5]),
        (370, &[0.7, 1.0, 1.5]),
        (207, &[500.0, 400.0, 450.0]),
        (385, &[333.0, 350.0, 300.0]),
        (253, &[750.0, 800.0, 900.0]),
        (200, &[1.0, 2.0, 3.5]),
        (357, &[0.0, 2.0, 5.0]),
        (204, &[0.0, 20.0, 50.0]),
    ];
    each_cycle(232, words, TOOL_MM, |data, seen| {
        let levels = face_levels(data);
        let bottom = levels[levels.len() - 1];
        let points = cut_points(seen);
        let lowest = points.iter().map(|(point, _)| point[2]).fold(f64::INFINITY, f64::min);
        assert_near(lowest, bottom, "the bottom", data);
        if data.of(389) != 2.0 {
            assert_levels(seen, &levels, data);
        }
        let top = (data.of(227) + data.of(200)).max(data.of(227) + data.of(204));
        assert_near(end_level(seen), top, "the end", data);
        let [x, y] = limits(seen, bottom + 1e-6);
        let sign = data.of(218).signum();
        let [mut begin, mut end] = [data.of(225), data.of(225) + data.of(218)];
        match data.of(389) as u32 {
            // Strategy 1 turns inside of the face.
            1 => {
                begin += TOOL_MM * sign;
                end -= TOOL_MM * sign;
                // The first line of the first level begins outside.
                let outside = data.of(225) - (TOOL_MM + data.of(357)) * sign;
                let has_one_level = levels.len() == 1;
                begin = if has_one_level { outside } else { begin };
            }
            _ => {
                begin -= (TOOL_MM + data.of(357)) * sign;
                end += (TOOL_MM + data.of(357)) * sign;
            }
        }
        assert_near(x[0], begin.min(end), "the limit", data);
        assert_near(x[1], begin.max(end), "the limit", data);
        let end = data.of(226) + data.of(219);
        assert_near(y[0], data.of(226).min(end), "the limit", data);
        assert_near(y[1], data.of(226).max(end), "the limit", data);
        let (down, across) = feeds(seen);
        assert_feeds(&down, &[data.of(253)], "plunging", data);
        assert_feeds(&across, &[data.of(207), data.of(385), data.of(253)], "milling", data);
        // The allowance of the floor is cut at its own feed.
        if data.of(369) > 0.0 {
            let last = points.iter().filter(|(point, _)| (point[2] - bottom).abs() < 1e-9);
            let feeds: Vec<f64> = last.map(|(_, feed)| *feed).collect();
            assert_feeds(&feeds, &[data.of(385), data.of(253)], "finishing", data);
        }
    });
}
