//! Drilling, boring, tapping: every stroke.

use super::shop::{CALLED_AT, CycleData, RPM, START_MM, SeenMove, each_cycle, run, same};

const CLEARANCE: &[f64] = &[1.0, 2.0, 5.5];
const DEPTH: &[f64] = &[-4.0, -20.5, -33.0];
const PLUNGE: &[f64] = &[100.0, 250.0, 333.0];
const INFEED: &[f64] = &[2.0, 5.0, 7.3, 60.0];
const WAIT: &[f64] = &[0.0, 0.5, 2.0];
const SURFACE: &[f64] = &[0.0, 10.0, -4.25];
const SECOND: &[f64] = &[0.0, 3.0, 50.0];

/// A record of strokes in the axis of the tool, as the manuals write them.
struct Strokes(Vec<SeenMove>, f64);

impl Strokes {
    fn new() -> Strokes {
        Strokes(Vec::new(), START_MM)
    }

    fn at(&self, z: f64) -> [f64; 3] {
        [CALLED_AT[0], CALLED_AT[1], z]
    }

    fn rapid(&mut self, z: f64) {
        if (z - self.1).abs() > 1e-9 {
            self.0.push(SeenMove::Rapid(self.at(z)));
            self.1 = z;
        }
    }

    fn feed(&mut self, z: f64, feed: f64) {
        if (z - self.1).abs() > 1e-9 {
            self.0.push(SeenMove::Cut(self.at(z), feed));
            self.1 = z;
        }
    }

    fn across(&mut self, by: [f64; 2]) {
        let to = [CALLED_AT[0] + by[0], CALLED_AT[1] + by[1], self.1];
        self.0.push(SeenMove::Rapid(to));
    }

    fn wait(&mut self, seconds: f64) {
        if seconds > 0.0 {
            self.0.push(SeenMove::Wait(seconds));
        }
    }
}

fn check(found: &[SeenMove], expected: &Strokes, data: &CycleData) {
    assert!(same(found, &expected.0), "{data:?}\nfound {found:#?}\nexpected {:#?}", expected.0);
}

/// The depths of strokes that become shorter by Q212, but not under Q205.
fn strokes(depth: f64, first: f64, less: f64, least: f64) -> Vec<f64> {
    let (mut found, mut reached, mut stroke) = (Vec::new(), 0.0, first);
    while reached < depth - 1e-9 {
        reached = if first == 0.0 { depth } else { (reached + stroke).min(depth) };
        found.push(reached);
        stroke = if stroke - less < least { least.min(stroke) } else { stroke - less };
    }
    found
}

#[test]
fn drilling_200() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, DEPTH),
        (206, PLUNGE),
        (202, INFEED),
        (210, WAIT),
        (203, SURFACE),
        (204, SECOND),
        (211, WAIT),
    ];
    each_cycle(200, words, 3.0, |data, seen| {
        let (top, bottom, end) = data.levels();
        let mut own = Strokes::new();
        own.rapid(top);
        let mut z = data.of(203);
        loop {
            z = (z - data.of(202)).max(bottom);
            own.feed(z, data.of(206));
            if z <= bottom + 1e-9 {
                break;
            }
            own.rapid(top);
            own.wait(data.of(210));
            own.rapid((z + 0.2).min(top));
        }
        own.wait(data.of(211));
        own.rapid(end);
        check(seen, &own, data);
    });
}

#[test]
fn reaming_and_boring_201_202() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, DEPTH),
        (206, PLUNGE),
        (211, WAIT),
        (208, &[0.0, 400.0, 777.0]),
        (203, SURFACE),
        (204, SECOND),
        (214, &[0.0, 1.0, 2.0, 3.0, 4.0]),
    ];
    for number in [201, 202] {
        each_cycle(number, words, 3.0, |data, seen| {
            let (top, bottom, end) = data.levels();
            let out = if data.of(208) == 0.0 { data.of(206) } else { data.of(208) };
            let by = [[0.0, 0.0], [-0.2, 0.0], [0.0, -0.2], [0.2, 0.0], [0.0, 0.2]];
            let by = by[data.of(214) as usize];
            let moves_off = number == 202 && data.of(214) != 0.0;
            let mut own = Strokes::new();
            own.rapid(top);
            own.feed(bottom, data.of(206));
            own.wait(data.of(211));
            if moves_off {
                own.across(by);
                own.0.push(SeenMove::Cut([CALLED_AT[0] + by[0], CALLED_AT[1] + by[1], top], out));
                own.1 = top;
                own.across([0.0; 2]);
            } else {
                own.feed(top, out);
            }
            own.rapid(end);
            check(seen, &own, data);
        });
    }
}

#[test]
fn universal_drilling_203() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, DEPTH),
        (206, PLUNGE),
        (202, INFEED),
        (210, WAIT),
        (203, SURFACE),
        (204, SECOND),
        (212, &[0.0, 0.5, 1.5]),
        (213, &[0.0, 1.0, 3.0]),
        (205, &[1.0, 1.5, 2.0]),
        (211, WAIT),
        (208, &[0.0, 500.0, 999.0]),
        (256, &[0.2, 0.5, 1.0]),
    ];
    each_cycle(203, words, 3.0, |data, seen| {
        let (top, _, end) = data.levels();
        let out = if data.of(208) == 0.0 { data.of(206) } else { data.of(208) };
        let depths = strokes(-data.of(201), data.of(202), data.of(212), data.of(205));
        let mut own = Strokes::new();
        own.rapid(top);
        let mut breaks = 0.0;
        for (index, depth) in depths.iter().enumerate() {
            let z = data.of(203) - depth;
            own.feed(z, data.of(206));
            if index + 1 == depths.len() {
                break;
            }
            if breaks < data.of(213) {
                breaks += 1.0;
                own.feed(z + data.of(256), out);
            } else {
                breaks = 0.0;
                own.feed(top, out);
                own.wait(data.of(210));
                own.rapid((z + 0.2).min(top));
            }
        }
        own.wait(data.of(211));
        own.feed(top, out);
        own.rapid(end);
        check(seen, &own, data);
    });
}

#[test]
fn back_boring_204() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (249, &[2.0, 5.0, 8.0]),
        (250, &[15.0, 20.0, 25.5]),
        (251, &[2.0, 3.5, 4.0]),
        (252, &[10.0, 15.0, 12.0]),
        (253, &[700.0, 750.0, 800.0]),
        (254, &[150.0, 200.0, 250.0]),
        (255, WAIT),
        (203, SURFACE),
        (204, SECOND),
        (214, &[1.0, 2.0, 3.0, 4.0]),
    ];
    each_cycle(204, words, 3.0, |data, seen| {
        let (top, _, end) = data.levels();
        let e = data.of(251);
        let by = [[0.0, 0.0], [-e, 0.0], [0.0, -e], [e, 0.0], [0.0, e]][data.of(214) as usize];
        let edge_below = data.of(203) - data.of(250) - data.of(252);
        let below = edge_below - data.of(200);
        let off = |z: f64| [CALLED_AT[0] + by[0], CALLED_AT[1] + by[1], z];
        let mut own = Strokes::new();
        own.rapid(top);
        own.across(by);
        own.0.push(SeenMove::Cut(off(below), data.of(253)));
        own.1 = below;
        own.across([0.0; 2]);
        own.feed(edge_below + data.of(249), data.of(254));
        own.wait(data.of(255));
        own.feed(below, data.of(253));
        own.across(by);
        own.0.push(SeenMove::Cut(off(top), data.of(253)));
        own.1 = top;
        own.across([0.0; 2]);
        own.rapid(end);
        check(seen, &own, data);
    });
}

#[test]
fn deep_drilling_205() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, DEPTH),
        (206, PLUNGE),
        (202, INFEED),
        (203, SURFACE),
        (204, SECOND),
        (212, &[0.0, 0.5, 1.5]),
        (205, &[1.0, 1.5, 2.0]),
        (258, &[0.2, 0.5, 0.8]),
        (259, &[0.2, 0.9, 1.0]),
        (257, &[0.0, 1.7, 4.0]),
        (256, &[0.2, 0.5, 1.0]),
        (211, WAIT),
    ];
    each_cycle(205, words, 3.0, |data, seen| {
        let (top, bottom, end) = data.levels();
        let whole = data.of(203) - bottom;
        let depths = strokes(whole, data.of(202), data.of(212), data.of(205));
        let mut own = Strokes::new();
        own.rapid(top);
        let mut from = data.of(203);
        for (index, depth) in depths.iter().enumerate() {
            let z = data.of(203) - depth;
            let mut stop = from - data.of(257);
            while data.of(257) > 0.0 && stop > z + 1e-9 {
                own.feed(stop, data.of(206));
                own.rapid(stop + data.of(256));
                stop -= data.of(257);
            }
            own.feed(z, data.of(206));
            from = z;
            if index + 1 == depths.len() {
                break;
            }
            own.rapid(top);
            let near = data.of(258) + (data.of(259) - data.of(258)) * depth / whole;
            own.rapid((z + near).min(top));
        }
        own.wait(data.of(211));
        own.rapid(end);
        check(seen, &own, data);
    });
}

#[test]
fn tapping_206_207() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, DEPTH),
        (206, PLUNGE),
        (239, &[1.0, -1.5, 1.75]),
        (211, WAIT),
        (203, SURFACE),
        (204, SECOND),
    ];
    for number in [206, 207] {
        each_cycle(number, words, 3.0, |data, seen| {
            let (top, bottom, end) = data.levels();
            let feed = if number == 206 { data.of(206) } else { RPM * data.of(239).abs() };
            let mut own = Strokes::new();
            own.rapid(top);
            own.feed(bottom, feed);
            own.wait(data.of(211));
            own.feed(top, feed);
            own.rapid(end);
            check(seen, &own, data);
        });
    }
}

#[test]
fn tapping_in_steps_209() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, DEPTH),
        (239, &[1.0, -1.5, 1.75]),
        (203, SURFACE),
        (204, SECOND),
        (257, &[3.0, 5.0, 40.0]),
        (256, &[0.0, 0.5, 1.0]),
        (403, &[1.0, 1.5, 2.0]),
    ];
    each_cycle(209, words, 3.0, |data, seen| {
        let (top, bottom, end) = data.levels();
        let pitch = data.of(239).abs();
        let (feed, back) = (RPM * pitch, RPM * pitch * data.of(403));
        let mut own = Strokes::new();
        own.rapid(top);
        let mut z = data.of(203);
        loop {
            z = (z - data.of(257)).max(bottom);
            own.feed(z, feed);
            if z <= bottom + 1e-9 {
                break;
            }
            let up = if data.of(256) == 0.0 { top } else { z + data.of(256) * pitch };
            own.feed(up.min(top), back);
        }
        own.feed(top, back);
        own.rapid(end);
        check(seen, &own, data);
    });
}

#[test]
fn centring_240() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (343, &[0.0, 0.0, 0.0]),
        (201, &[-1.0, -2.0, -3.5]),
        (206, PLUNGE),
        (211, WAIT),
        (203, SURFACE),
        (204, SECOND),
    ];
    each_cycle(240, words, 3.0, |data, seen| {
        let (top, bottom, end) = data.levels();
        let mut own = Strokes::new();
        own.rapid(top);
        own.feed(bottom, data.of(206));
        own.wait(data.of(211));
        own.rapid(end);
        check(seen, &own, data);
    });
}

#[test]
fn single_lip_drilling_241() {
    let words: &[(u32, &[f64])] = &[
        (200, CLEARANCE),
        (201, &[-40.0, -60.5, -100.0]),
        (206, PLUNGE),
        (211, WAIT),
        (203, SURFACE),
        (204, SECOND),
        (379, &[0.0, 5.0, 16.0]),
        (253, &[500.0, 750.0, 900.0]),
        (208, &[0.0, 1000.0, 2000.0]),
        (426, &[3.0, 4.0, 5.0]),
        (427, &[20.0, 50.0, 100.0]),
        (428, &[500.0, 900.0, 1790.0]),
        (429, &[8.0, 7.0, 500.0]),
        (430, &[9.0, 9.0, 501.0]),
        (435, &[0.0, 33.0, 39.0]),
        (401, &[100.0, 80.0, 50.0]),
        (202, &[0.0, 10.0, 25.0]),
    ];
    each_cycle(241, words, 3.0, |data, seen| {
        let (top, bottom, end) = data.levels();
        let surface = data.of(203);
        let out = if data.of(208) == 0.0 { data.of(206) } else { data.of(208) };
        let mut own = Strokes::new();
        own.rapid(top);
        let begin = surface - data.of(379);
        if data.of(379) > 0.0 {
            own.feed(begin + data.of(200), data.of(253));
        }
        // The stops: each infeed from the start, and the dwell depth.
        let mut stops = Vec::new();
        let mut z = begin;
        while z > bottom + 1e-9 {
            z = if data.of(202) == 0.0 { bottom } else { (z - data.of(202)).max(bottom) };
            stops.push(z);
        }
        let slow = surface - data.of(435);
        if data.of(435) > 0.0 && !stops.iter().any(|stop| (stop - slow).abs() < 1e-9) {
            stops.push(slow);
        }
        stops.sort_by(|a, b| b.total_cmp(a));
        for stop in stops {
            let part =
                if data.of(435) > 0.0 && stop < slow - 1e-9 { data.of(401) / 100.0 } else { 1.0 };
            own.feed(stop, data.of(206) * part);
            own.wait(data.of(211));
        }
        own.feed(top, out);
        own.rapid(end);
        check(seen, &own, data);
    });
}

#[test]
fn old_cycles_1_2_17() {
    for clearance in [1.0, 2.0, 4.5] {
        for depth in [3.0, 14.0, 40.0, 90.0] {
            for stroke in [0.0, 3.0, 6.5] {
                for wait in [0.0, 1.0, 2.5] {
                    for feed in [50.0, 120.0, 301.0] {
                        let data = CycleData(Default::default());
                        let surface = START_MM - clearance;
                        let bottom = surface - depth;
                        let lines = format!(
                            "CYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP -{clearance}\nCYCL DEF 1.2 DEPTH -{depth}\n\
                             CYCL DEF 1.3 PECKG -{stroke}\nCYCL DEF 1.4 DWELL {wait}\nCYCL DEF 1.5 F{feed}"
                        );
                        let mut own = Strokes::new();
                        let stop = if depth <= 30.0 { 0.6 } else { (depth / 50.0).min(7.0) };
                        let mut z = surface;
                        loop {
                            z = if stroke == 0.0 { bottom } else { (z - stroke).max(bottom) };
                            own.feed(z, feed);
                            if z <= bottom {
                                break;
                            }
                            own.rapid(START_MM);
                            own.rapid((z + stop).min(START_MM));
                        }
                        own.wait(wait);
                        own.rapid(START_MM);
                        check(&run(&lines, 3.0), &own, &data);
                        let tap = format!(
                            "CYCL DEF 2.0 TAPPING\nCYCL DEF 2.1 SET UP -{clearance}\nCYCL DEF 2.2 DEPTH -{depth}\n\
                             CYCL DEF 2.3 DWELL {wait}\nCYCL DEF 2.4 F{feed}"
                        );
                        let mut own = Strokes::new();
                        own.feed(bottom, feed);
                        own.wait(wait);
                        own.feed(START_MM, feed);
                        check(&run(&tap, 3.0), &own, &data);
                        let pitch = feed / 100.0;
                        let rigid = format!(
                            "CYCL DEF 17.0 RIGID TAPPING\nCYCL DEF 17.1 SET UP -{clearance}\n\
                             CYCL DEF 17.2 DEPTH -{depth}\nCYCL DEF 17.3 PITCH {pitch}"
                        );
                        let mut own = Strokes::new();
                        own.feed(bottom, RPM * pitch);
                        own.feed(START_MM, RPM * pitch);
                        check(&run(&rigid, 3.0), &own, &data);
                    }
                }
            }
        }
    }
}
