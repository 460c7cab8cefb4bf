//! Pockets, slots, studs and threads: levels, feeds, the end, and how near the tool comes to the finished wall.

use super::shop::{
    CALLED_AT, CycleData, NEAR_MM, START_MM, SeenMove, assert_ends, assert_feeds, assert_levels,
    assert_near, cut_points, each_cycle, feeds, infeeds, run,
};

const CLEARANCE: &[f64] = &[1.0, 2.0, 5.5];
const DEPTH: &[f64] = &[-4.0, -10.5, -16.0];
const PLUNGE: &[f64] = &[100.0, 250.0, 333.0];
const MILL: &[f64] = &[500.0, 750.0, 612.0];
const FINISH: &[f64] = &[401.0, 802.0, 333.3];
const INFEED: &[f64] = &[2.0, 5.0, 60.0];
const SURFACE: &[f64] = &[0.0, 10.0, -4.25];
const SECOND: &[f64] = &[0.0, 3.0, 50.0];
const ALLOWANCE: &[f64] = &[0.0, 0.2, 0.75];
const KIND: &[f64] = &[0.0, 1.0, 2.0];
const TURNED: &[f64] = &[0.0, 30.0, -77.5];
const OVERLAP: &[f64] = &[0.5, 1.0, 1.4];
const CENTER: &[f64] = &[0.0, 20.0, -15.5];

/// The distance of a point from a shape, mm: negative inside.
type Shape = Box<dyn Fn([f64; 2]) -> f64>;

fn turned([x, y]: [f64; 2], degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [x * cos - y * sin, x * sin + y * cos]
}

/// A rectangle with rounded corners about a centre.
fn rectangle(center: [f64; 2], halves: [f64; 2], corner: f64, degrees: f64) -> Shape {
    Box::new(move |[x, y]| {
        let [x, y] = turned([x - center[0], y - center[1]], -degrees);
        let q = [x.abs() - halves[0] + corner, y.abs() - halves[1] + corner];
        q[0].max(0.0).hypot(q[1].max(0.0)) + q[0].max(q[1]).min(0.0) - corner
    })
}

fn circle(center: [f64; 2], radius: f64) -> Shape {
    Box::new(move |[x, y]| (x - center[0]).hypot(y - center[1]) - radius)
}

/// A slot along an arc from an angle.
fn arc_slot(center: [f64; 2], radius: f64, width: f64, from: f64, length: f64) -> Shape {
    Box::new(move |[x, y]| {
        let [x, y] = [x - center[0], y - center[1]];
        let begin = from.min(from + length);
        let angle = (y.atan2(x).to_degrees() - begin).rem_euclid(360.0);
        let to_end = |degrees: f64| {
            let end = turned([radius, 0.0], degrees);
            (x - end[0]).hypot(y - end[1])
        };
        let from_line = match angle <= length.abs() {
            true => (x.hypot(y) - radius).abs(),
            false => to_end(from).min(to_end(from + length)),
        };
        from_line - width / 2.0
    })
}

/// How near the centre of the tool comes to a wall below the surface, mm; from inside, or from outside.
fn nearest(seen: &[SeenMove], shape: &Shape, is_inside: bool, below: f64) -> f64 {
    let cuts = cut_points(seen);
    let cuts = cuts.iter().filter(|(point, _)| point[2] < below - 1e-9);
    let distance = |point: &[f64; 3]| {
        let distance = shape([point[0], point[1]]);
        if is_inside { -distance } else { distance }
    };
    cuts.map(|(point, _)| distance(point)).fold(f64::INFINITY, f64::min)
}

fn pocket_levels(data: &CycleData) -> Vec<f64> {
    let floor = if data.of(215) == 1.0 { data.of(369) } else { 0.0 };
    infeeds(data.of(203), -data.of(201) - floor, data.of(202))
}

/// A pocket of the 250s: its shape from its data.
fn check_pocket(data: &CycleData, seen: &[SeenMove], shape: &Shape, tool: f64) {
    let (top, _, end) = data.levels();
    assert_ends(seen, top, end, data);
    let kind = data.of(215);
    let finishes = kind != 1.0 && data.of(368) > 0.0;
    if kind == 2.0 && !finishes {
        return;
    }
    let levels = pocket_levels(data);
    let expected = if kind == 2.0 { vec![levels[levels.len() - 1]] } else { levels };
    assert_levels(seen, &expected, data);
    let left = if finishes { 0.0 } else { data.of(368) };
    let found = nearest(seen, shape, true, data.of(203));
    assert_near(found, tool + left, "the distance from the wall", data);
    let (down, across) = feeds(seen);
    assert_feeds(&down, &[data.of(206)], "plunging", data);
    assert_feeds(&across, &[data.of(207), data.of(385)], "milling", data);
}

#[test]
fn rectangular_pockets_251() {
    let words: &[(u32, &[f64])] = &[
        (215, KIND),
        (218, &[60.0, 45.0, 81.5]),
        (219, &[30.0, 40.0, 25.5]),
        (220, &[0.0, 6.0, 10.0]),
        (368, ALLOWANCE),
        (224, TURNED),
        (367, &[0.0, 1.0, 2.0, 3.0, 4.0]),
        (207, MILL),
        (351, &[1.0, -1.0, 0.0]),
        (201, DEPTH),
        (202, INFEED),
        (369, ALLOWANCE),
        (206, PLUNGE),
        (338, &[0.0, 0.0, 0.0]),
        (200, CLEARANCE),
        (203, SURFACE),
        (204, SECOND),
        (370, OVERLAP),
        (385, FINISH),
    ];
    each_cycle(251, words, 5.0, |data, seen| {
        let halves = [data.of(218) / 2.0, data.of(219) / 2.0];
        let signs = [[0.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
        let sign = signs[data.of(367) as usize];
        let by = turned([sign[0] * halves[0], sign[1] * halves[1]], data.of(224));
        let center = [CALLED_AT[0] + by[0], CALLED_AT[1] + by[1]];
        check_pocket(data, seen, &rectangle(center, halves, data.of(220), data.of(224)), 5.0);
    });
}

#[test]
fn circular_pockets_252() {
    let words: &[(u32, &[f64])] = &[
        (215, KIND),
        (223, &[30.0, 44.5, 60.0]),
        (368, ALLOWANCE),
        (207, MILL),
        (201, DEPTH),
        (202, INFEED),
        (369, ALLOWANCE),
        (206, PLUNGE),
        (200, CLEARANCE),
        (203, SURFACE),
        (204, SECOND),
        (370, OVERLAP),
        (385, FINISH),
    ];
    each_cycle(252, words, 5.0, |data, seen| {
        check_pocket(data, seen, &circle(CALLED_AT, data.of(223) / 2.0), 5.0);
    });
}

#[test]
fn slots_253() {
    let words: &[(u32, &[f64])] = &[
        (215, KIND),
        (218, &[60.0, 45.0, 81.5]),
        (219, &[12.0, 14.0, 15.5]),
        (368, ALLOWANCE),
        (374, TURNED),
        (367, &[0.0, 1.0, 2.0, 3.0, 4.0]),
        (207, MILL),
        (201, DEPTH),
        (202, INFEED),
        (369, ALLOWANCE),
        (206, PLUNGE),
        (200, CLEARANCE),
        (203, SURFACE),
        (204, SECOND),
        (385, FINISH),
    ];
    each_cycle(253, words, 5.0, |data, seen| {
        let halves = [data.of(218) / 2.0, data.of(219) / 2.0];
        let along = match data.of(367) as i64 {
            1 => halves[0],
            2 => halves[0] - halves[1],
            3 => halves[1] - halves[0],
            4 => -halves[0],
            _ => 0.0,
        };
        let by = turned([along, 0.0], data.of(374));
        let center = [CALLED_AT[0] + by[0], CALLED_AT[1] + by[1]];
        check_pocket(data, seen, &rectangle(center, halves, halves[1], data.of(374)), 5.0);
    });
}

#[test]
fn circular_slots_254() {
    let words: &[(u32, &[f64])] = &[
        (215, KIND),
        (219, &[12.0, 14.0, 15.5]),
        (368, ALLOWANCE),
        (375, &[60.0, 80.0, 100.0]),
        (216, CENTER),
        (217, CENTER),
        (376, TURNED),
        (248, &[45.0, 90.0, -120.0]),
        (207, MILL),
        (201, DEPTH),
        (202, INFEED),
        (369, ALLOWANCE),
        (206, PLUNGE),
        (200, CLEARANCE),
        (203, SURFACE),
        (204, SECOND),
        (385, FINISH),
    ];
    each_cycle(254, words, 5.0, |data, seen| {
        let center = [data.of(216), data.of(217)];
        let shape = arc_slot(center, data.of(375) / 2.0, data.of(219), data.of(376), data.of(248));
        check_pocket(data, seen, &shape, 5.0);
    });
}

/// A stud of 256 or 257.
fn check_stud(
    data: &CycleData,
    seen: &[SeenMove],
    shape: &Shape,
    excess: f64,
    begin: f64,
    tool: f64,
) {
    let (top, _, end) = data.levels();
    assert_ends(seen, top, end, data);
    let kind = if data.has(215) { data.of(215) } else { 1.0 };
    let (allowance, depth) = (data.of(368), -data.of(201));
    let finishes = kind == 2.0 || kind == 0.0 && allowance > 0.0;
    let floor = if kind == 1.0 { data.of(369) } else { 0.0 };
    let mut levels = Vec::new();
    if kind != 2.0 {
        levels.extend(infeeds(data.of(203), depth - floor, data.of(202)));
    }
    if finishes {
        levels.extend(infeeds(data.of(203), depth, data.of(338)));
    }
    levels.sort_by(|a, b| b.total_cmp(a));
    levels.dedup_by(|a, b| (*a - *b).abs() < 1e-7);
    assert_levels(seen, &levels, data);
    let left = if finishes { 0.0 } else { allowance };
    assert_near(nearest(seen, shape, false, data.of(203)), tool + left, "the wall", data);
    // The edge of the tool goes down 2 mm from the blank.
    let down = cut_points(seen);
    let first = down.iter().find(|(point, _)| point[2] < data.of(203)).expect("a cut").0;
    let from_center = shape([first[0], first[1]]);
    assert_near(from_center, begin, "the start", data);
    let (down, across) = feeds(seen);
    assert_feeds(&down, &[data.of(206)], "plunging", data);
    assert_feeds(&across, &[data.of(207), data.of(385)], "milling", data);
    // Climb milling goes clockwise round a stud.
    let turns: f64 = seen
        .iter()
        .map(|step| match step {
            SeenMove::Round(_, center, sweep, _) if shape(*center) < 1e-6 => *sweep,
            _ => 0.0,
        })
        .sum();
    let is_clockwise = data.of(351) >= 0.0;
    assert!(turns == 0.0 || (turns < 0.0) == is_clockwise, "{data:?}");
    // Revolutions of a level: as many as the stepover needs.
    if kind != 2.0 {
        let needed = (excess / (data.of(370) * tool) - 1e-9).ceil().max(1.0);
        let rough = infeeds(data.of(203), depth - floor, data.of(202)).len() as f64;
        let last =
            if finishes { infeeds(data.of(203), depth, data.of(338)).len() as f64 } else { 0.0 };
        let revolutions = -turns.abs() / std::f64::consts::TAU;
        assert_near(-revolutions, rough * needed + last, "the revolutions", data);
    }
}

#[test]
fn rectangular_studs_256() {
    let words: &[(u32, &[f64])] = &[
        (218, &[40.0, 35.5, 60.0]),
        (424, &[60.0, 75.0, 95.5]),
        (219, &[30.0, 22.0, 50.0]),
        (425, &[50.0, 55.0, 80.0]),
        (220, &[0.0, 4.0, 10.0]),
        (368, ALLOWANCE),
        (224, TURNED),
        (367, &[0.0, 1.0, 2.0, 3.0, 4.0]),
        (207, MILL),
        (351, &[1.0, -1.0, 1.0]),
        (201, DEPTH),
        (202, INFEED),
        (206, PLUNGE),
        (200, CLEARANCE),
        (203, SURFACE),
        (204, SECOND),
        (370, OVERLAP),
        (437, &[0.0, 0.0, 0.0]),
        (215, KIND),
        (369, ALLOWANCE),
        (338, &[0.0, 3.0, 7.0]),
        (385, FINISH),
    ];
    each_cycle(256, words, 5.0, |data, seen| {
        let halves = [data.of(218) / 2.0, data.of(219) / 2.0];
        let signs = [[0.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
        let sign = signs[data.of(367) as usize];
        let by = turned([sign[0] * halves[0], sign[1] * halves[1]], data.of(224));
        let center = [CALLED_AT[0] + by[0], CALLED_AT[1] + by[1]];
        let shape = rectangle(center, halves, data.of(220), data.of(224));
        let blank = [data.of(424) / 2.0, data.of(425) / 2.0];
        let excess = (blank[0] - halves[0]).max(blank[1] - halves[1]) - data.of(368);
        let begin = (blank[0] - halves[0]).max(data.of(368)) + 2.0 + 5.0;
        check_stud(data, seen, &shape, excess, begin, 5.0);
    });
}

#[test]
fn circular_studs_257() {
    let words: &[(u32, &[f64])] = &[
        (223, &[40.0, 35.5, 60.0]),
        (222, &[60.0, 75.0, 95.5]),
        (368, ALLOWANCE),
        (207, MILL),
        (351, &[1.0, -1.0, 1.0]),
        (201, DEPTH),
        (202, INFEED),
        (206, PLUNGE),
        (200, CLEARANCE),
        (203, SURFACE),
        (204, SECOND),
        (370, OVERLAP),
        (376, &[-1.0, 0.0, 77.0, 200.0]),
        (215, KIND),
        (369, ALLOWANCE),
        (338, &[0.0, 3.0, 7.0]),
        (385, FINISH),
    ];
    each_cycle(257, words, 5.0, |data, seen| {
        let shape = circle(CALLED_AT, data.of(223) / 2.0);
        let excess = (data.of(222) - data.of(223)) / 2.0 - data.of(368);
        let begin = ((data.of(222) - data.of(223)) / 2.0).max(data.of(368)) + 2.0 + 5.0;
        check_stud(data, seen, &shape, excess, begin, 5.0);
    });
}

/// Cycles 212 to 215.
fn check_finishing(data: &CycleData, seen: &[SeenMove], shape: &Shape, is_inside: bool, tool: f64) {
    let (_, bottom, end) = data.levels();
    assert_ends(seen, end, end, data);
    let depth = data.of(203) - bottom;
    assert_levels(seen, &infeeds(data.of(203), depth, data.of(202)), data);
    assert_near(nearest(seen, shape, is_inside, data.of(203)), tool, "the wall", data);
    let (down, across) = feeds(seen);
    assert_feeds(&down, &[data.of(206)], "plunging", data);
    assert_feeds(&across, &[data.of(207)], "milling", data);
    let last = seen.iter().rev().find_map(SeenMove::to).expect("a move");
    assert_near(last[0], data.of(216), "the centre", data);
    assert_near(last[1], data.of(217), "the centre", data);
}

#[test]
fn finishing_212_to_215() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, DEPTH),
        (206, PLUNGE),
        (202, INFEED),
        (207, MILL),
        (203, SURFACE),
        (204, SECOND),
        (216, CENTER),
        (217, CENTER),
        (218, &[60.0, 45.0, 81.5]),
        (219, &[30.0, 40.0, 25.5]),
        (220, &[0.0, 6.0, 10.0]),
        (221, &[0.0, 0.5, 2.0]),
    ];
    for number in [212, 213] {
        each_cycle(number, words, 5.0, |data, seen| {
            let halves = [data.of(218) / 2.0, data.of(219) / 2.0];
            let shape = rectangle([data.of(216), data.of(217)], halves, data.of(220), 0.0);
            check_finishing(data, seen, &shape, number == 212, 5.0);
        });
    }
    let round: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, DEPTH),
        (206, PLUNGE),
        (202, INFEED),
        (207, MILL),
        (203, SURFACE),
        (204, SECOND),
        (216, CENTER),
        (217, CENTER),
        (222, &[30.0, 42.0, 41.0]),
        (223, &[44.0, 50.0, 61.5]),
    ];
    for number in [214, 215] {
        each_cycle(number, round, 5.0, |data, seen| {
            let shape = circle([data.of(216), data.of(217)], data.of(223) / 2.0);
            check_finishing(data, seen, &shape, number == 214, 5.0);
        });
    }
}

/// The levels at which the strokes of a reciprocating plunge end.
fn ramp_ends(seen: &[SeenMove], below: f64) -> Vec<f64> {
    let mut found: Vec<f64> = Vec::new();
    let mut at = [CALLED_AT[0], CALLED_AT[1], START_MM];
    for step in seen {
        let Some(to) = step.to() else { continue };
        let moves = (to[0] - at[0]).hypot(to[1] - at[1]) > 1e-9 && to[2] < at[2] - 1e-9;
        if moves && to[2] < below - 1e-9 {
            found.push(to[2]);
        }
        at = to;
    }
    found
}

fn check_old_slot(data: &CycleData, seen: &[SeenMove], shape: &Shape) {
    let (_, bottom, end) = data.levels();
    assert_ends(seen, end, end, data);
    let depth = data.of(203) - bottom;
    let kind = data.of(215);
    let is_wide = data.of(219) > 10.0;
    if kind != 2.0 {
        let expected = infeeds(data.of(203), depth, data.of(202));
        let found = ramp_ends(seen, data.of(203));
        let same = found.len() == expected.len()
            && found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < NEAR_MM);
        assert!(same, "{found:?} {expected:?} {data:?}");
    }
    if kind != 1.0 && is_wide {
        assert_near(nearest(seen, shape, true, data.of(203)), 5.0, "the wall", data);
    } else if kind != 2.0 {
        let middle = data.of(219) / 2.0;
        assert_near(nearest(seen, shape, true, data.of(203)), middle, "the middle line", data);
    }
    let (down, across) = feeds(seen);
    assert_feeds(&down, &[data.of(206), data.of(207)], "plunging", data);
    assert_feeds(&across, &[data.of(207)], "milling", data);
}

#[test]
fn old_slots_210_211() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, DEPTH),
        (207, MILL),
        (202, INFEED),
        (215, KIND),
        (203, SURFACE),
        (204, SECOND),
        (216, CENTER),
        (217, CENTER),
        (218, &[60.0, 45.0, 81.5]),
        (219, &[10.0, 12.0, 15.5]),
        (224, TURNED),
        (338, &[0.0, 3.0, 5.0]),
        (206, PLUNGE),
    ];
    each_cycle(210, words, 5.0, |data, seen| {
        let halves = [data.of(218) / 2.0, data.of(219) / 2.0];
        let center = [data.of(216), data.of(217)];
        check_old_slot(data, seen, &rectangle(center, halves, halves[1], data.of(224)));
    });
    let round: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, DEPTH),
        (207, MILL),
        (202, INFEED),
        (215, KIND),
        (203, SURFACE),
        (204, SECOND),
        (216, CENTER),
        (217, CENTER),
        (244, &[60.0, 80.0, 100.0]),
        (219, &[10.0, 12.0, 15.5]),
        (245, TURNED),
        (248, &[45.0, 90.0, 120.0]),
        (338, &[0.0, 3.0, 5.0]),
        (206, PLUNGE),
    ];
    each_cycle(211, round, 5.0, |data, seen| {
        let center = [data.of(216), data.of(217)];
        let shape = arc_slot(center, data.of(244) / 2.0, data.of(219), data.of(245), data.of(248));
        check_old_slot(data, seen, &shape);
    });
}

#[test]
fn bore_milling_208() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, DEPTH),
        (206, PLUNGE),
        (334, &[0.5, 1.0, 2.25]),
        (203, SURFACE),
        (204, SECOND),
        (335, &[12.0, 20.0, 31.5]),
        (342, &[0.0, 0.0, 0.0]),
        (351, &[1.0, 1.0, 0.0]),
    ];
    each_cycle(208, words, 5.0, |data, seen| {
        let (top, bottom, end) = data.levels();
        assert_ends(seen, top, end, data);
        let shape = circle(CALLED_AT, data.of(335) / 2.0);
        assert_near(nearest(seen, &shape, true, top + 1.0), 5.0, "the wall", data);
        let turns: f64 = seen
            .iter()
            .map(|step| if let SeenMove::Round(_, _, sweep, _) = step { *sweep } else { 0.0 })
            .sum();
        let expected = (top - bottom) / data.of(334) + 1.0;
        assert_near(turns / std::f64::consts::TAU, expected, "the turns", data);
        let (_, across) = feeds(seen);
        assert_feeds(&across, &[data.of(206)], "milling", data);
    });
}

#[test]
fn old_pockets_and_slots_3_4_5() {
    let data = CycleData(Default::default());
    for (index, clearance) in [1.0, 2.0, 4.5].into_iter().enumerate() {
        for (depth, infeed) in [(4.0, 4.0), (9.0, 2.5), (12.0, 5.0), (3.0, 9.0)] {
            for (long, wide) in [(60.0, 14.0), (-45.0, 12.0), (81.5, 10.0)] {
                for is_second_first in [false, true] {
                    let surface = START_MM - clearance;
                    let levels = infeeds(surface, depth, infeed);
                    let [x, y] = if is_second_first { ["Y", "X"] } else { ["X", "Y"] };
                    let feed = [111.0, 222.0, 333.0][index];
                    let head = |number: u32| {
                        format!(
                            "CYCL DEF {number}.0 A CYCLE\nCYCL DEF {number}.1 SET UP -{clearance}\n\
                             CYCL DEF {number}.2 DEPTH -{depth}\nCYCL DEF {number}.3 PECKG -{infeed} F{feed}\n"
                        )
                    };
                    let sides = |number: u32, last: &str| {
                        format!(
                            "{}CYCL DEF {number}.4 {x}{long}\nCYCL DEF {number}.5 {y}{wide}\n\
                             CYCL DEF {number}.6 F600{last}",
                            head(number)
                        )
                    };
                    let degrees = if is_second_first { 90.0 } else { 0.0 };
                    let halves = [f64::abs(long) / 2.0, wide / 2.0];
                    let slot = run(&sides(3, ""), 5.0);
                    let by = turned([(halves[0] - 5.0) * f64::signum(long), 0.0], degrees);
                    let center = [CALLED_AT[0] + by[0], CALLED_AT[1] + by[1]];
                    let shape = rectangle(center, halves, halves[1], degrees);
                    assert_levels(&slot, &levels, &data);
                    assert_near(nearest(&slot, &shape, true, surface), 5.0, "the wall", &data);
                    let (down, across) = feeds(&slot);
                    assert_feeds(&down, &[feed], "plunging", &data);
                    assert_feeds(&across, &[600.0], "milling", &data);
                    let last = slot.iter().rev().find_map(SeenMove::to).expect("a move");
                    assert_near(last[2], START_MM, "the end", &data);
                    assert_near(last[0], CALLED_AT[0], "the end", &data);
                    let pocket = run(&sides(4, " DR+ R6"), 5.0);
                    let shape = rectangle(CALLED_AT, halves, 0.0, degrees);
                    assert_levels(&pocket, &levels, &data);
                    assert_near(nearest(&pocket, &shape, true, surface), 5.0, "the wall", &data);
                    let round =
                        format!("{}CYCL DEF 5.4 RADIUS {}\nCYCL DEF 5.5 F600 DR+", head(5), wide);
                    let round = run(&round, 5.0);
                    assert_levels(&round, &levels, &data);
                    let shape = circle(CALLED_AT, wide);
                    assert_near(nearest(&round, &shape, true, surface), 5.0, "the wall", &data);
                }
            }
        }
    }
}
