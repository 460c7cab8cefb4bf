//! Random calls of the milling cycles: nothing outside the shape, nothing below the depth, all of it cut, equal infeeds, no
//! rapid in the material, the end on the retract plane.

mod mills;

use chordal_sinumerik::cycles::MillingContext;
use mills::{CutPiece, SweptMove, cuts, flat_levels, rapid_in_material, swept};
use proptest::prelude::*;

const RETRACT: f64 = 30.0;
const SAFETY: f64 = 2.0;

/// A tool and the numbers that all shapes share, as parts of what is allowed.
#[derive(Clone, Copy, Debug)]
struct MillingChoice {
    /// Radius of the tool as a part of half the width.
    tool: f64,
    edge_allowance: f64,
    base_allowance: f64,
    infeed: f64,
    stepover: f64,
    depth: f64,
    direction: u8,
    spindle: u8,
    degrees: f64,
    place: [f64; 2],
    /// The work is done upward.
    is_upward: bool,
    sample: [f64; 2],
}

impl MillingChoice {
    fn up(&self) -> f64 {
        if self.is_upward { -1.0 } else { 1.0 }
    }

    fn context(&self, radius: f64) -> MillingContext {
        MillingContext {
            position: [3.0, -7.0, 40.0 * self.up()],
            tool_radius: Some(radius),
            spindle_direction: self.spindle,
            ..MillingContext::default()
        }
    }

    fn planes(&self) -> String {
        let up = self.up();
        format!("{},0,{SAFETY},{}", RETRACT * up, -self.depth * up)
    }
}

fn choice() -> impl Strategy<Value = MillingChoice> {
    let shape =
        (0.1..1.0_f64, 0.0..0.3_f64, 0.0..0.4_f64, 0.05..1.2_f64, 0.1..1.0_f64, 0.5..20.0_f64);
    let place = (0_u8..4, 3_u8..5, -180.0..180.0_f64, [-99.0..99.0_f64, -99.0..99.0_f64]);
    (shape, place, any::<bool>(), [0.0..1.0_f64, 0.0..1.0_f64]).prop_map(
        |(shape, (direction, spindle, degrees, place), is_upward, sample)| {
            let (tool, edge_allowance, base_allowance, infeed, stepover, depth) = shape;
            MillingChoice {
                tool,
                edge_allowance,
                base_allowance,
                infeed,
                stepover,
                depth,
                direction,
                spindle,
                degrees,
                place,
                is_upward,
                sample,
            }
        },
    )
}

/// A point of the plane in the coordinates of a shape.
fn local(point: [f64; 2], place: [f64; 2], degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let [x, y] = [point[0] - place[0], point[1] - place[1]];
    [cos * x + sin * y, cos * y - sin * x]
}

/// A point of a shape in the plane.
fn global(point: [f64; 2], place: [f64; 2], degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [place[0] + cos * point[0] - sin * point[1], place[1] + sin * point[0] + cos * point[1]]
}

/// The signed distance from a rectangle with rounded corners, negative inside.
fn from_rectangle([x, y]: [f64; 2], [a, b]: [f64; 2], corner: f64) -> f64 {
    let [dx, dy] = [x.abs() - (a - corner), y.abs() - (b - corner)];
    dx.max(0.0).hypot(dy.max(0.0)) + dx.max(dy).min(0.0) - corner
}

/// The signed distance from a slot along a circle about the origin with its middle on the first axis.
fn from_arc_slot(point: [f64; 2], radius: f64, half_angle: f64, half_width: f64) -> f64 {
    let angle = point[1].atan2(point[0]).clamp(-half_angle, half_angle);
    let center = [radius * angle.cos(), radius * angle.sin()];
    (point[0] - center[0]).hypot(point[1] - center[1]) - half_width
}

/// A cycle that clears a shape: `distance` is signed, negative inside the finished shape.
#[derive(Clone, Copy)]
struct ClearedShape<'a> {
    choice: &'a MillingChoice,
    radius: f64,
    scale: f64,
    moves: &'a [SweptMove],
    distance: &'a dyn Fn([f64; 2]) -> f64,
}

impl ClearedShape<'_> {
    /// All points of all cuts keep inside and above the depth; the run ends on the retract plane.
    fn check_inside(&self, bottom: f64) {
        let up = self.choice.up();
        for piece in cuts(self.moves) {
            for index in 0..=12 {
                let point = piece.at(f64::from(index) / 12.0);
                let distance = (self.distance)([point[0], point[1]]) + self.radius;
                assert!(
                    distance <= 1e-9 * self.scale,
                    "{distance} outside at {point:?}: {piece:?}"
                );
                assert!((point[2] - bottom) * up >= -1e-9, "below the depth: {point:?}");
            }
        }
        let Some(SweptMove::Rapid(_, end)) = self.moves.last() else {
            panic!("no rapid at the end")
        };
        assert_eq!(end[2], RETRACT * up);
    }

    /// A point of the shape is cut at a level.
    fn check_cut(&self, point: [f64; 2], level: f64) {
        let up = self.choice.up();
        let nearest = cuts(self.moves)
            .iter()
            .filter(|piece| piece.is_below(level, up))
            .map(|piece| piece.distance(point))
            .fold(f64::INFINITY, f64::min);
        assert!(nearest <= self.radius + 1e-7 * self.scale, "{point:?} is {nearest} from the tool");
    }

    /// Equal infeeds, none larger than the programmed one, from the reference plane to a depth.
    fn check_infeeds(&self, roughing: &[SweptMove], depth: f64, largest: f64) {
        let up = self.choice.up();
        let levels: Vec<f64> = flat_levels(&cuts(roughing), up)
            .into_iter()
            .filter(|level| level * up < -1e-9)
            .collect();
        let first = -levels[0] * up;
        // A ramp and a helix lie in the plane above the levels, too, where they begin.
        for (index, level) in levels.iter().enumerate() {
            let expected = first * (index as f64 + 1.0);
            assert!((-level * up - expected).abs() <= 1e-7 * self.scale, "{levels:?}");
        }
        assert!(first <= largest + 1e-9, "{first} > {largest}");
        let last = -levels[levels.len() - 1] * up;
        assert!((last - depth).abs() <= 1e-9 * self.scale, "{last} is not {depth}");
    }

    fn check_rapids(&self) {
        let up = self.choice.up();
        let found = rapid_in_material(self.moves, SAFETY * up, self.radius, up, |_| false);
        assert_eq!(found, None);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn rectangular_pockets(
        choice in choice(),
        half in [2.0..60.0_f64, 2.0..60.0_f64],
        corner in 0.0..1.0_f64,
        tens in 1_u8..4,
        insertion in 0.05..1.0_f64,
    ) {
        let narrow = half[0].min(half[1]);
        let corner = corner * narrow;
        let radius = (choice.tool * narrow * 0.98).max(narrow / 40.0);
        let edge = (choice.edge_allowance * radius).min((narrow - radius) / 2.0);
        let base = choice.base_allowance * choice.depth * choice.infeed.min(1.0);
        let (infeed, stepover) = (choice.infeed * choice.depth, choice.stepover * 2.0 * radius);
        let room = narrow - radius - edge;
        let (first, second) = match tens {
            2 => (insertion * room, 0.3 * choice.depth),
            3 => (5.0 + 60.0 * insertion, 0.0),
            _ => (0.0, 0.0),
        };
        let call = |ones: u8| format!(
            "{},{},{},{corner},{},{},{},{infeed},{edge},{base},300,100,{},{tens}{ones},{stepover},,,,{first},{second}",
            choice.planes(), 2.0 * half[0], 2.0 * half[1], choice.place[0], choice.place[1],
            choice.degrees, choice.direction,
        );
        let context = choice.context(radius);
        let moves = swept("POCKET3", &[call(1), call(2)], &context).expect("moves");
        let roughing = swept("POCKET3", &[call(1)], &context).expect("moves");
        let at = |point| local(point, choice.place, choice.degrees);
        let distance = |point| from_rectangle(at(point), half, corner);
        let shape = ClearedShape {
            choice: &choice, radius, scale: 200.0, moves: &moves, distance: &distance,
        };
        shape.check_inside(-choice.depth * choice.up());
        let rough = ClearedShape { radius: radius + edge, moves: &roughing, ..shape };
        rough.check_inside(-(choice.depth - base) * choice.up());
        if tens == 1 {
            shape.check_infeeds(&roughing, choice.depth - base, infeed);
        }
        shape.check_rapids();
        let place = |point| global(point, choice.place, choice.degrees);
        let bottom = -choice.depth * choice.up();
        // What a round tool reaches: corners of its radius.
        let check = |point| {
            if from_rectangle(point, half, corner.max(radius)) <= 0.0 {
                shape.check_cut(place(point), bottom);
            }
        };
        check([0, 1].map(|axis| half[axis] * (2.0 * choice.sample[axis] - 1.0)));
        // Loops are furthest apart on the lines from the corners inward.
        for index in 0..40 {
            check(half.map(|side| side - narrow * f64::from(index) / 39.0));
        }
    }

    #[test]
    fn circular_pockets(
        choice in choice(),
        size in 2.0..60.0_f64,
        tens in 1_u8..3,
        insertion in 0.05..1.0_f64,
    ) {
        let radius = (choice.tool * size * 0.98).max(size / 40.0);
        let edge = (choice.edge_allowance * radius).min((size - radius) / 2.0);
        let base = choice.base_allowance * choice.depth * choice.infeed.min(1.0);
        let (infeed, stepover) = (choice.infeed * choice.depth, choice.stepover * 2.0 * radius);
        let helix = insertion * (size - radius - edge);
        let call = |ones: u8| format!(
            "{},{size},{},{},{infeed},{edge},{base},300,100,{},{tens}{ones},{stepover},,,{helix},1",
            choice.planes(), choice.place[0], choice.place[1], choice.direction,
        );
        let context = choice.context(radius);
        let moves = swept("POCKET4", &[call(1), call(2)], &context).expect("moves");
        let roughing = swept("POCKET4", &[call(1)], &context).expect("moves");
        let distance = |point: [f64; 2]| {
            (point[0] - choice.place[0]).hypot(point[1] - choice.place[1]) - size
        };
        let shape = ClearedShape {
            choice: &choice, radius, scale: 200.0, moves: &moves, distance: &distance,
        };
        shape.check_inside(-choice.depth * choice.up());
        let rough = ClearedShape { radius: radius + edge, moves: &roughing, ..shape };
        rough.check_inside(-(choice.depth - base) * choice.up());
        if tens == 1 {
            shape.check_infeeds(&roughing, choice.depth - base, infeed);
        }
        shape.check_rapids();
        let reach = size * choice.sample[0].sqrt();
        let point = global([reach, 0.0], choice.place, 360.0 * choice.sample[1]);
        shape.check_cut(point, -choice.depth * choice.up());
    }

    #[test]
    fn slots_that_point_to_a_center(
        choice in choice(),
        width in 2.0..30.0_f64,
        more in 0.0..60.0_f64,
        inner in 0.0..50.0_f64,
        count in 1_u8..4,
    ) {
        let length = width + more;
        let radius = (choice.tool * width / 2.0).max(width / 50.0);
        let edge = (choice.edge_allowance * radius).min((width / 2.0 - radius) / 2.0);
        let infeed = choice.infeed * choice.depth;
        // Far enough from the centre that slots do not meet.
        let inner = inner + 2.0 * width;
        let call = format!(
            "{},,{count},{length},{width},{},{},{inner},{},0,100,300,{infeed},{},{edge},0,0,400,900",
            choice.planes(), choice.place[0], choice.place[1], choice.degrees, choice.direction,
        );
        let moves = swept("SLOT1", &[call], &choice.context(radius)).expect("moves");
        let pitch = 360.0 / f64::from(count);
        let half = [length / 2.0, width / 2.0];
        let distance = |point: [f64; 2]| (0..count)
            .map(|slot| {
                let [x, y] = local(point, choice.place, choice.degrees + pitch * f64::from(slot));
                from_rectangle([x - inner - length / 2.0, y], half, width / 2.0)
            })
            .fold(f64::INFINITY, f64::min);
        let shape = ClearedShape {
            choice: &choice, radius, scale: 300.0, moves: &moves, distance: &distance,
        };
        shape.check_inside(-choice.depth * choice.up());
        shape.check_rapids();
        let point = [0, 1].map(|axis| half[axis] * (2.0 * choice.sample[axis] - 1.0));
        if from_rectangle(point, half, width / 2.0) <= 0.0 {
            let point = [point[0] + inner + length / 2.0, point[1]];
            let point = global(point, choice.place, choice.degrees + pitch * f64::from(count - 1));
            shape.check_cut(point, -choice.depth * choice.up());
        }
    }

    #[test]
    fn slots_along_a_circle(
        choice in choice(),
        width in 2.0..30.0_f64,
        middle in 0.6..5.0_f64,
        angle in 1.0..250.0_f64,
    ) {
        let radius = (choice.tool * width / 2.0).max(width / 50.0);
        let edge = (choice.edge_allowance * radius).min((width / 2.0 - radius) / 2.0);
        let infeed = choice.infeed * choice.depth;
        let middle = middle * width;
        let call = format!(
            "{},,1,{angle},{width},{},{},{middle},{},0,100,300,{infeed},{},{edge},0,0,400,900",
            choice.planes(), choice.place[0], choice.place[1], choice.degrees, choice.direction,
        );
        let moves = swept("SLOT2", &[call], &choice.context(radius)).expect("moves");
        let degrees = choice.degrees + angle / 2.0;
        let half_angle = (angle / 2.0).to_radians();
        let distance = |point| {
            from_arc_slot(local(point, choice.place, degrees), middle, half_angle, width / 2.0)
        };
        let shape = ClearedShape {
            choice: &choice, radius, scale: 300.0, moves: &moves, distance: &distance,
        };
        shape.check_inside(-choice.depth * choice.up());
        shape.check_rapids();
        let along = half_angle * (2.0 * choice.sample[0] - 1.0);
        let across = middle + width * (choice.sample[1] - 0.5);
        let point = [across * along.cos(), across * along.sin()];
        shape.check_cut(global(point, choice.place, degrees), -choice.depth * choice.up());
    }

    #[test]
    fn faces(
        choice in choice(),
        size in [3.0..90.0_f64, 3.0..90.0_f64],
        signs in [any::<bool>(), any::<bool>()],
        tens in 1_u8..5,
        overrun in 0.0..3.0_f64,
    ) {
        let radius = 1.0 + 20.0 * choice.tool;
        let base = choice.base_allowance * choice.depth * choice.infeed.min(1.0);
        let (infeed, stepover) = (choice.infeed * choice.depth, choice.stepover * 2.0 * radius);
        let signed: [f64; 2] =
            std::array::from_fn(|axis| if signs[axis] { size[axis] } else { -size[axis] });
        let call = |ones: u8| format!(
            "{},{},{},{},{},{},{infeed},{stepover},3,{base},300,{tens}{ones},{overrun}",
            choice.planes(), choice.place[0], choice.place[1], signed[0], signed[1], choice.degrees,
        );
        let context = choice.context(radius);
        let moves = swept("CYCLE71", &[call(1), call(2)], &context).expect("moves");
        // Not further than run-in, tool and overrun.
        let center = signed.map(|side| side / 2.0);
        let reach = size.map(|side| side / 2.0 + 2.0 * radius + 3.0 + overrun);
        let distance = |point| {
            let [x, y] = local(point, choice.place, choice.degrees);
            from_rectangle([x - center[0], y - center[1]], reach, 0.0)
        };
        let shape = ClearedShape {
            choice: &choice, radius, scale: 300.0, moves: &moves, distance: &distance,
        };
        shape.check_inside(-choice.depth * choice.up());
        let roughing = swept("CYCLE71", &[call(1)], &context).expect("moves");
        shape.check_infeeds(&roughing, choice.depth - base, infeed);
        let is_outside = |point: [f64; 2]| {
            let [x, y] = local(point, choice.place, choice.degrees);
            from_rectangle([x - center[0], y - center[1]], size.map(|side| side / 2.0), 0.0) >= 0.0
        };
        let up = choice.up();
        prop_assert_eq!(rapid_in_material(&moves, SAFETY * up, radius, up, is_outside), None);
        let point = [0, 1].map(|axis| signed[axis] * choice.sample[axis]);
        shape.check_cut(global(point, choice.place, choice.degrees), -choice.depth * up);
    }

    #[test]
    fn spigots(
        choice in choice(),
        half in [2.0..60.0_f64, 2.0..60.0_f64],
        corner in 0.0..1.0_f64,
        blank in 0.0..9.0_f64,
    ) {
        let radius = 1.0 + 20.0 * choice.tool;
        let corner = corner * half[0].min(half[1]);
        let (edge, base) = (choice.edge_allowance * radius, choice.base_allowance * choice.depth);
        let infeed = choice.infeed * choice.depth;
        let call = |ones: u8| format!(
            "{},,{},{},{corner},{},{},{},{infeed},{edge},{base},300,100,{},{ones},{},{}",
            choice.planes(), 2.0 * half[0], 2.0 * half[1], choice.place[0], choice.place[1],
            choice.degrees, choice.direction, 2.0 * (half[0] + blank), 2.0 * (half[1] + blank),
        );
        let moves = swept("CYCLE76", &[call(1), call(2)], &choice.context(radius)).expect("moves");
        let up = choice.up();
        let mut nearest = f64::INFINITY;
        for piece in cuts(&moves) {
            for index in 0..=12 {
                let point = piece.at(f64::from(index) / 12.0);
                let at = local([point[0], point[1]], choice.place, choice.degrees);
                let distance = from_rectangle(at, half, corner) - radius;
                prop_assert!(distance >= -2e-7, "{} into the spigot at {:?}", -distance, point);
                prop_assert!((point[2] + choice.depth * up) * up >= -1e-9);
                if (point[2] + choice.depth * up).abs() <= 1e-9 {
                    nearest = nearest.min(distance);
                }
            }
        }
        prop_assert!(nearest.abs() <= 2e-7, "the contour is not reached: {nearest}");
        // Every point of the contour is touched at the depth.
        let angle = std::f64::consts::TAU * choice.sample[0];
        let far = [angle.cos(), angle.sin()].map(|part| part * 300.0);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let part = (low + high) / 2.0;
            let inside = from_rectangle(far.map(|each| each * part), half, corner) < 0.0;
            if inside { low = part } else { high = part }
        }
        let contour = global(far.map(|each| each * low), choice.place, choice.degrees);
        let touched = cuts(&moves)
            .iter()
            .filter(|piece| piece.is_below(-choice.depth * up, up))
            .map(|piece| piece.distance(contour))
            .fold(f64::INFINITY, f64::min);
        prop_assert!(touched <= radius + 1e-6, "{touched} from the contour, not {radius}");
        let Some(SweptMove::Rapid(_, end)) = moves.last() else { panic!("no rapid at the end") };
        prop_assert_eq!(end[2], RETRACT * up);
    }

    /// The helix of a thread keeps its radius and goes down a lead a turn, without a jump between its pieces.
    #[test]
    fn threads(
        choice in choice(),
        nominal in 5.0..60.0_f64,
        lead in 0.3..4.0_f64,
        is_external in any::<bool>(),
    ) {
        let core = nominal * 0.85;
        let radius = if is_external { 1.0 + 9.0 * choice.tool } else { core * 0.48 * choice.tool };
        let call = format!(
            "{},,{nominal},{core},{lead},200,{},{},{},{}",
            choice.planes(), choice.direction, u8::from(is_external), choice.place[0], choice.place[1],
        );
        let moves = swept("CYCLE90", &[call], &choice.context(radius)).expect("moves");
        let expected = if is_external { core / 2.0 + radius } else { nominal / 2.0 - radius };
        let up = choice.up();
        for piece in cuts(&moves) {
            let CutPiece::Arc { center, radius: own, sweep, levels, .. } = piece else {
                panic!("a line in a thread")
            };
            let is_helix = (center[0] - choice.place[0]).hypot(center[1] - choice.place[1]) < 1e-9;
            if is_helix {
                prop_assert!((own - expected).abs() <= 1e-6);
                let drop = (levels[0] - levels[1]) * up;
                let turns = sweep.abs() / std::f64::consts::TAU;
                prop_assert!((drop - turns * lead).abs() <= 1e-6, "{drop} in {turns} turns of {lead}");
            }
        }
    }
}

/// An argument as a slip may write it.
fn odd_argument() -> impl Strategy<Value = String> {
    prop_oneof![
        Just(String::new()),
        Just("0".to_string()),
        (-9_i32..40).prop_map(|number| number.to_string()),
        (-50.0..50.0_f64).prop_map(|number| number.to_string()),
        prop_oneof![Just("1e-9"), Just("-1e10"), Just("1e10"), Just("720"), Just("11111")]
            .prop_map(str::to_string),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    /// Any arguments get moves of finite numbers, or a fault.
    #[test]
    fn odd_arguments(
        cycle in prop::sample::select(vec![
            "POCKET1", "POCKET2", "POCKET3", "POCKET4", "SLOT1", "SLOT2", "LONGHOLE", "CYCLE61",
            "CYCLE71", "CYCLE76", "CYCLE77", "CYCLE90",
        ]),
        list in prop::collection::vec(odd_argument(), 0..32),
        radius in prop_oneof![Just(0.0), 1e-6..1e-3_f64, 0.1..30.0_f64],
    ) {
        let context = MillingContext {
            tool_radius: Some(radius), max_repetitions: 300, ..MillingContext::default()
        };
        if let Ok(moves) = swept(cycle, &[list.join(",")], &context) {
            for each in &moves {
                let points = match each {
                    SweptMove::Rapid(from, to) => [*from, *to],
                    SweptMove::Cut(piece) => [piece.at(0.0), piece.at(1.0)],
                };
                prop_assert!(points.iter().flatten().all(|number| number.is_finite()), "{each:?}");
            }
        }
    }
}
