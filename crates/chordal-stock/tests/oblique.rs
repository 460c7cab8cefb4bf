//! Stock against dense sampling, with tools whose direction turns while they move. The truth is found here anew: whether
//! a point is in the tool at some pose of the move.
//!
//! More: `CHORDAL_ROUNDS=100000 cargo test --release -p chordal-stock --test oblique`.

#![allow(clippy::disallowed_methods, reason = "a test reads how many rounds it is to run")]

use std::f64::consts::{FRAC_PI_2, PI};

use chordal_geometry::{Aabb, Arc, Curve, Frame, Line, Vec3};
use chordal_stock::{
    AxialSolid, AxisTurn, CellHeights, ColumnOptions, ColumnStock, CutterProfile, RemovedSpan,
    TipMove, ToolTurn, TurningTask,
};

/// A generator of random numbers (SplitMix64).
struct RandomNumbers(u64);

impl RandomNumbers {
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    fn vector(&mut self, half: f64) -> Vec3 {
        let mut one = || self.between(-half, half);
        Vec3::new(one(), one(), one())
    }

    fn direction(&mut self) -> Vec3 {
        loop {
            let vector = self.vector(1.0);
            let length = vector.length();
            if length > 0.1 && length <= 1.0 {
                return vector * (1.0 / length);
            }
        }
    }
}

/// A cutter by its own formulas.
#[derive(Clone, Copy, Debug)]
enum SampledTool {
    Flat { radius: f64 },
    Ball { radius: f64 },
    Bull { radius: f64, corner: f64 },
    Cone { radius: f64, tip: f64, half_angle: f64 },
}

impl SampledTool {
    fn random(random: &mut RandomNumbers) -> SampledTool {
        let radius = random.between(0.5, 4.0);
        match (4.0 * random.share()) as u32 {
            0 => SampledTool::Flat { radius },
            1 => SampledTool::Ball { radius },
            2 => SampledTool::Bull { radius, corner: radius * random.between(0.05, 0.95) },
            _ => SampledTool::Cone {
                radius,
                tip: (radius * random.between(-0.5, 0.9)).max(0.0),
                half_angle: random.between(0.1, 1.5),
            },
        }
    }

    fn profile(&self) -> CutterProfile {
        let made = match *self {
            SampledTool::Flat { radius } => CutterProfile::flat(2.0 * radius),
            SampledTool::Ball { radius } => CutterProfile::ball(2.0 * radius),
            SampledTool::Bull { radius, corner } => CutterProfile::bull(2.0 * radius, corner),
            SampledTool::Cone { radius, tip, half_angle } => {
                CutterProfile::pointed(2.0 * radius, 2.0 * tip, 2.0 * half_angle)
            }
        };
        made.expect("a cutter")
    }

    /// Its radius at a height above the tip, mm.
    fn radius_at(&self, height: f64) -> f64 {
        let height = height.max(0.0);
        match *self {
            SampledTool::Flat { radius } => radius,
            SampledTool::Ball { radius } => {
                let below = (radius - height).max(0.0);
                (radius * radius - below * below).max(0.0).sqrt()
            }
            SampledTool::Bull { radius, corner } => {
                let below = (corner - height).max(0.0);
                radius - corner + (corner * corner - below * below).max(0.0).sqrt()
            }
            SampledTool::Cone { radius, tip, half_angle } => {
                (tip + height * half_angle.tan()).min(radius)
            }
        }
    }
}

/// A move, sampled.
struct SampledMove {
    tool: SampledTool,
    length: f64,
    path: Line,
    direction: Vec3,
    turns: Vec<AxisTurn>,
}

/// The rotation by Rodrigues' formula.
fn turned(v: Vec3, about: Vec3, angle: f64) -> Vec3 {
    v * angle.cos() + about.cross(v) * angle.sin() + about * (about.dot(v) * (1.0 - angle.cos()))
}

impl SampledMove {
    fn random(random: &mut RandomNumbers) -> SampledMove {
        let tool = SampledTool::random(random);
        let start = random.vector(8.0);
        let travel = match (4.0 * random.share()) as u32 {
            0 => Vec3::ZERO,
            1 => random.vector(0.5),
            _ => random.vector(10.0),
        };
        let mut direction = random.direction();
        if random.share() < 0.5 {
            // Near the upright, as machines have it.
            direction = (direction * 0.4 + Vec3::Z).normalized().expect("a direction");
        }
        let angle = random.between(0.0, 1.0);
        let most = angle * angle * angle * PI;
        let count = 1 + (2.0 * random.share()) as usize;
        let mut turns = Vec::new();
        for _ in 0..count {
            let about = match (4.0 * random.share()) as u32 {
                0 => Vec3::X,
                1 => Vec3::Z,
                _ => random.direction(),
            };
            let from = random.between(-PI, PI);
            let to = from + random.between(-most, most);
            turns.push(AxisTurn { about, from, to });
        }
        let length = random.between(3.0, 25.0);
        let path = Line { start, end: start + travel };
        SampledMove { tool, length, path, direction, turns }
    }

    fn pose(&self, share: f64) -> (Vec3, Vec3) {
        let tip = self.path.start + (self.path.end - self.path.start) * share;
        let turns = self.turns.iter();
        let axis = turns.fold(self.direction, |direction, turn| {
            turned(direction, turn.about, turn.from + share * (turn.to - turn.from))
        });
        (tip, axis)
    }

    /// How far a point is from being in the tool, mm; not above zero where it is in it.
    fn off(&self, point: Vec3, share: f64) -> f64 {
        let (tip, axis) = self.pose(share);
        let arm = point - tip;
        let height = arm.dot(axis);
        let radius = (arm - axis * height).length();
        (radius - self.tool.radius_at(height)).max(-height).max(height - self.length)
    }

    /// The least of these along the move.
    fn nearest(&self, point: Vec3, samples: u32) -> f64 {
        let at = |n: u32| f64::from(n) / f64::from(samples);
        let all: Vec<f64> = (0..=samples).map(|n| self.off(point, at(n))).collect();
        let mut best = all.iter().copied().fold(f64::INFINITY, f64::min);
        if best <= 0.0 {
            return best;
        }
        for n in 0..=samples as usize {
            let is_least =
                (n == 0 || all[n] <= all[n - 1]) && (n == samples as usize || all[n] <= all[n + 1]);
            if !is_least {
                continue;
            }
            let mut low = at((n as u32).saturating_sub(1));
            let mut high = at((n as u32 + 1).min(samples));
            for _ in 0..60 {
                let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
                if self.off(point, a) < self.off(point, b) { high = b } else { low = a }
            }
            best = best.min(self.off(point, 0.5 * (low + high)));
        }
        best
    }

    fn cut(&self, stock: &mut ColumnStock) {
        let solid = AxialSolid::of_cutter(&self.tool.profile(), self.length);
        let turn = ToolTurn::new(self.direction, &self.turns).expect("a turn");
        let task = TurningTask { turns: &[turn], removes: Some(&solid), may: None, bodies: &[] };
        stock.cut_turning(task, &[TipMove { curve: self.path.into(), tag: 1 }], 0.01);
    }
}

fn block(half: f64, resolution: f64) -> ColumnStock {
    let corner = Vec3::new(half, half, half);
    let bounds = Aabb { min: corner * -1.0, max: corner };
    ColumnStock::new(bounds, ColumnOptions::new(resolution, 1 << 28)).expect("a stock")
}

fn is_in(spans: &[RemovedSpan], z: f64) -> bool {
    spans.iter().any(|span| span.floor < z && z < span.top)
}

/// What the columns say of a height: certainly gone, certainly left.
fn claims(heights: CellHeights, [surely, maybe]: &[Vec<RemovedSpan>; 2], z: f64) -> [bool; 2] {
    let is_gone = z > heights.outer || is_in(surely, z);
    let is_left = z < heights.inner && !is_in(maybe, z);
    [is_gone, is_left]
}

/// Checks one random move; returns the numbers of points that are certainly gone, certainly left, and neither.
fn check(seed: u64) -> [u64; 3] {
    const HALF: f64 = 6.0;
    const ABOVE: f64 = 1e-4;
    let mut random = RandomNumbers(seed);
    let path = SampledMove::random(&mut random);
    let resolution = [0.3, 0.5, 1.0][(3.0 * random.share()) as usize];
    let mut stock = block(HALF, resolution);
    path.cut(&mut stock);
    let [columns, rows] = stock.grid().cells();
    let mut counts = [0; 3];
    for _ in 0..24 {
        let [column, row] = [columns, rows]
            .map(|count| ((f64::from(count) * random.share()) as u32).min(count - 1));
        let heights = stock.heights_at(column, row).expect("a cell");
        let gaps = stock.gaps_at(column, row);
        let [low, high] = stock.grid().corners(column, row);
        let mut across = |axis: usize| match (4.0 * random.share()) as u32 {
            0 => low[axis],
            1 => high[axis],
            _ => random.between(low[axis], high[axis]),
        };
        let (x, y) = (across(0), across(1));
        let mut levels = vec![
            random.between(-HALF, HALF),
            random.between(-HALF, HALF),
            heights.outer + ABOVE,
            heights.inner - ABOVE,
        ];
        for span in &gaps[0] {
            levels.extend([span.floor + ABOVE, span.top - ABOVE]);
        }
        for span in &gaps[1] {
            levels.extend([span.floor - ABOVE, span.top + ABOVE]);
        }
        levels.retain(|z| z.abs() < HALF);
        for z in levels {
            let [is_gone, is_left] = claims(heights, &gaps, z);
            assert!(!(is_gone && is_left));
            counts[if is_gone {
                0
            } else if is_left {
                1
            } else {
                2
            }] += 1;
            if !is_gone && !is_left {
                continue;
            }
            let point = Vec3::new(x, y, z);
            let mut off = path.nearest(point, 64);
            if is_gone && off > 1e-5 {
                off = path.nearest(point, 4096);
            }
            let said = format!(
                "seed {seed}: {:?} length {} {:?} {:?} {:?} at {point:?}: off {off}, {heights:?} {gaps:?}",
                path.tool, path.length, path.path, path.direction, path.turns
            );
            assert!(!is_gone || off < 1e-5, "said to be gone, and is not: {said}");
            assert!(!is_left || off > -1e-5, "said to be left, and is not: {said}");
        }
    }
    counts
}

#[test]
fn the_truth_is_between_the_bounds() {
    let rounds = std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok());
    let rounds: u64 = rounds.unwrap_or(200);
    // Two threads, each with every second seed.
    let half = |first: u64| {
        let seeds = (first..rounds).step_by(2);
        seeds.map(check).fold([0; 3], |sum, own| [0, 1, 2].map(|n| sum[n] + own[n]))
    };
    let counts = std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        let own = half(0);
        let other = other.join().expect("the other half of the moves");
        [0, 1, 2].map(|n| own[n] + other[n])
    });
    println!("{rounds} moves: gone, left, open: {counts:?}");
    // The bounds say something: most places are certainly gone or certainly left.
    assert!(counts[0] > rounds && counts[1] > rounds && counts[2] < counts[0] + counts[1]);
}

/// What a solid removes from a block while it turns about Y, with its tip on a path.
fn removed(solid: &AxialSolid, path: Curve, angles: [f64; 2], resolution: f64) -> [f64; 2] {
    let mut stock = block(15.0, resolution);
    let [from, to] = angles;
    let turn = ToolTurn::new(Vec3::Z, &[AxisTurn { about: Vec3::Y, from, to }]).expect("a turn");
    let task = TurningTask { turns: &[turn], removes: Some(solid), may: None, bodies: &[] };
    stock.cut_turning(task, &[TipMove { curve: path, tag: 1 }], 0.01);
    let removed = stock.removed();
    [removed.least, removed.most]
}

#[test]
fn a_ball_that_turns_about_its_centre_removes_a_ball() {
    // Half a ball of radius 3, with the axis from one side over the upright to the other side: together a whole ball.
    let radius = 3.0;
    let frame = Frame { origin: Vec3::ZERO, u: Vec3::X, v: Vec3::Z * -1.0, w: Vec3::Y };
    let path = Arc::new(frame, radius, PI, 0.0);
    let solid = AxialSolid::of_cutter(&CutterProfile::ball(2.0 * radius).expect("a ball"), radius);
    let truth = 4.0 / 3.0 * PI * radius * radius * radius;
    for (resolution, share) in [(0.2, 0.3), (0.1, 0.16)] {
        let [least, most] = removed(&solid, path.into(), [-FRAC_PI_2, FRAC_PI_2], resolution);
        assert!(least <= truth && truth <= most, "{least} {truth} {most}");
        assert!(most - least < share * truth, "{least} {truth} {most}");
    }
}

#[test]
fn a_cylinder_that_turns_about_its_tip() {
    // At each distance y from the plane of the turn, a rectangle of half the width w = √(r² − y²) and the length l turns
    // about the middle of its end: its far corners, at ±atan(w/l) of the axis, pass a sector of the radius √(w² + l²), and
    // a triangle of w·l/2 is left on each side.
    let (radius, length, angle) = (2.0_f64, 10.0_f64, FRAC_PI_2);
    let area = |y: f64| {
        let w = (radius * radius - y * y).max(0.0).sqrt();
        0.5 * (w * w + length * length) * (angle + 2.0 * (w / length).atan()) + w * length
    };
    // With y = r sin(v), which has no steep end.
    let count = 1000;
    let step = PI / f64::from(count);
    let truth: f64 = (0..count)
        .map(|n| (f64::from(n) + 0.5) * step - FRAC_PI_2)
        .map(|v| area(radius * v.sin()) * radius * v.cos() * step)
        .sum();
    let solid = AxialSolid::of_cutter(&CutterProfile::flat(2.0 * radius).expect("flat"), length);
    let path = Line { start: Vec3::ZERO, end: Vec3::ZERO };
    for (resolution, share) in [(0.2, 0.26), (0.1, 0.14)] {
        let [least, most] = removed(&solid, path.into(), [0.0, angle], resolution);
        assert!(least <= truth && truth <= most, "{least} {truth} {most}");
        assert!(most - least < share * truth, "{least} {truth} {most}");
    }
}

#[test]
fn a_tool_that_is_driven_into_the_block_certainly_touches_it() {
    let solid = AxialSolid::of_cutter(&CutterProfile::flat(6.0).expect("flat"), 25.0);
    let about = AxisTurn { about: Vec3::X, from: 0.0, to: -0.5 };
    let turn = ToolTurn::new(Vec3::Z, &[about]).expect("a turn");
    let path = Line { start: Vec3::new(0.0, -60.0, 55.0), end: Vec3::new(0.0, 12.0, 7.0) };
    let moves = [TipMove { curve: path.into(), tag: 1 }];
    let bodies = [solid];
    let task = TurningTask { turns: &[turn], removes: None, may: None, bodies: &bodies };
    for resolution in [0.8, 0.4, 0.2] {
        let mut stock = block(15.0, resolution);
        let found = stock.cut_turning(task, &moves, 0.01)[0][0];
        assert!(found.least > 4.0 && found.most < 12.0, "{found:?}");
        assert_eq!(stock.removed().most, 0.0);
    }
}

/// A block, with the points of it that are looked at: a grid with this spacing.
const SPACING: f64 = 0.5;

fn points(half: f64) -> impl Iterator<Item = Vec3> {
    let count = (2.0 * half / SPACING) as u32;
    let at = move |n: u32| -half + (f64::from(n) + 0.5) * SPACING;
    (0..count).flat_map(move |x| {
        (0..count).flat_map(move |y| (0..count).map(move |z| Vec3::new(at(x), at(y), at(z))))
    })
}

#[test]
fn contacts_are_between_their_bounds() {
    const HALF: f64 = 5.0;
    let mut found = [0; 2];
    for seed in 0..12 {
        let path = SampledMove::random(&mut RandomNumbers(seed + 7_000_000));
        let body = [AxialSolid::of_cutter(&path.tool.profile(), path.length)];
        let turn = ToolTurn::new(path.direction, &path.turns).expect("a turn");
        let task = TurningTask { turns: &[turn], removes: None, may: None, bodies: &body };
        let moves = [TipMove { curve: path.path.into(), tag: 1 }];
        let contact = block(HALF, 1.0).cut_turning(task, &moves, 0.01)[0][0];
        let deepest =
            points(HALF).map(|point| path.nearest(point, 24)).fold(f64::INFINITY, f64::min);
        let said = format!("seed {seed}: {contact:?} {deepest}");
        // A point of the block that is in the tool has a chord of the tool around it.
        assert!(deepest >= -1e-6 || contact.most >= -deepest, "{said}");
        // A chord over all of a cell contains points of the grid.
        assert!(contact.least <= 2.0 * SPACING || deepest <= 1e-6, "{said}");
        found[0] += u32::from(contact.least > 0.01);
        found[1] += u32::from(contact.most <= 0.01);
    }
    assert!(found[0] > 2 && found[1] > 0, "{found:?}");
}

#[test]
fn a_shank_in_what_its_edges_have_cut_is_no_touch() {
    // The edges are 12 mm long and go 8 mm deep, the shank above them is narrower: it never touches. With edges of 4 mm
    // it does.
    let cutter = CutterProfile::flat(6.0).expect("flat");
    let about = AxisTurn { about: Vec3::Y, from: 0.0, to: 0.3 };
    let turn = ToolTurn::new(Vec3::Z, &[about]).expect("a turn");
    let path = Line { start: Vec3::new(-20.0, 0.0, 7.0), end: Vec3::new(20.0, 0.0, 7.0) };
    let moves = [TipMove { curve: path.into(), tag: 1 }];
    for (length, touches) in [(12.0, false), (4.0, true)] {
        let edges = AxialSolid::of_cutter(&cutter, length);
        let shank = [AxialSolid::stack(length, &[[30.0, 5.0, 5.0]])];
        let task = TurningTask { turns: &[turn], removes: Some(&edges), may: None, bodies: &shank };
        let mut stock = block(15.0, 0.5);
        let contact = stock.cut_turning(task, &moves, 0.01)[0][0];
        assert_eq!(contact.least > 0.01, touches, "{contact:?}");
        assert_eq!(contact.most > 0.01, touches, "{contact:?}");
    }
}
