//! Random free contours: made forwards from their angles and lengths, described by some of their values alone, and solved.

use chordal_geometry::TurnDirection;
use chordal_heidenhain::geometry::{
    FreeContourFault, FreeElementValues, SolvedFreeElement, solve_free_contour,
};

const TOLERANCE_MM: f64 = 0.01;
const POLE: [f64; 2] = [3.0, -7.0];

/// A sequence of numbers from 0 to 1.
struct NumberSequence(u64);

impl NumberSequence {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    fn below(&mut self, count: u32) -> u32 {
        (self.next() * f64::from(count)) as u32
    }
}

/// A contour while it is made.
struct MadeContour {
    numbers: NumberSequence,
    place: [f64; 2],
    /// The direction there, degrees.
    heading_deg: f64,
    values: Vec<FreeElementValues>,
    expected: Vec<SolvedFreeElement>,
}

fn polar(point: [f64; 2]) -> [Option<f64>; 2] {
    let [x, y] = [point[0] - POLE[0], point[1] - POLE[1]];
    [Some(x.hypot(y)), Some(y.atan2(x).to_degrees())]
}

fn cos_sin(degrees: f64) -> [f64; 2] {
    [degrees.to_radians().cos(), degrees.to_radians().sin()]
}

fn ahead(place: [f64; 2], degrees: f64, by: f64) -> [f64; 2] {
    let [cos, sin] = cos_sin(degrees);
    [place[0] + cos * by, place[1] + sin * by]
}

impl MadeContour {
    fn turn(&mut self, is_tangent: bool) {
        if !is_tangent {
            self.heading_deg = self.numbers.between(-180.0, 180.0);
        }
    }

    fn line_end(&mut self) -> ([f64; 2], f64) {
        let length = self.numbers.between(5.0, 50.0);
        (ahead(self.place, self.heading_deg, length), length)
    }

    fn add(&mut self, values: FreeElementValues, end: [f64; 2], center: Option<[f64; 2]>) {
        self.values.push(values);
        self.expected.push(SolvedFreeElement { end, center });
        self.place = end;
    }

    fn line(&mut self) {
        let is_tangent = self.numbers.below(2) == 0;
        self.turn(is_tangent);
        let (end, length) = self.line_end();
        let given = FreeElementValues { is_tangent, ..FreeElementValues::default() };
        let angle_deg = (!is_tangent).then_some(self.heading_deg);
        let across = cos_sin(self.heading_deg).map(f64::abs);
        let values = match self.numbers.below(4) {
            0 => FreeElementValues { end: end.map(Some), ..given },
            1 => FreeElementValues { angle_deg, length: Some(length), ..given },
            2 if across[0] > 0.2 => {
                FreeElementValues { angle_deg, end: [Some(end[0]), None], ..given }
            }
            2 => FreeElementValues { angle_deg, end: [None, Some(end[1])], ..given },
            _ => FreeElementValues { polar: polar(end), ..given },
        };
        self.add(values, end, None);
    }

    /// An arc from the present place and heading: sign, centre, radius, end.
    fn arc_of(&mut self) -> (f64, [f64; 2], f64, [f64; 2]) {
        let sign = if self.numbers.below(2) == 0 { 1.0 } else { -1.0 };
        let (radius, sweep_deg) =
            (self.numbers.between(5.0, 40.0), self.numbers.between(15.0, 300.0));
        let center = ahead(self.place, self.heading_deg + sign * 90.0, radius);
        self.heading_deg += sign * sweep_deg;
        let end = ahead(center, self.heading_deg - sign * 90.0, radius);
        (sign, center, radius, end)
    }

    fn arc(&mut self) {
        let is_tangent = self.numbers.below(2) == 0;
        self.turn(is_tangent);
        let (sign, center, radius, end) = self.arc_of();
        let turn = Some(if sign > 0.0 { TurnDirection::Ccw } else { TurnDirection::Cw });
        let given = FreeElementValues { turn, is_tangent, ..FreeElementValues::default() };
        let values = match (is_tangent, self.numbers.below(3)) {
            (true, 0) => FreeElementValues { radius: Some(radius), end: end.map(Some), ..given },
            (true, 1) => FreeElementValues { end: end.map(Some), ..given },
            (_, 2) => FreeElementValues {
                center: Some(center),
                radius: Some(radius),
                polar: polar(end),
                ..given
            },
            _ => FreeElementValues { center: Some(center), end: end.map(Some), ..given },
        };
        self.add(values, end, Some(center));
    }

    /// Two lines, of which the first has its angle alone.
    fn corner(&mut self) {
        self.turn(false);
        let (end, _) = self.line_end();
        let first = self.heading_deg;
        self.add(
            FreeElementValues { angle_deg: Some(first), ..FreeElementValues::default() },
            end,
            None,
        );
        self.heading_deg += self.numbers.between(20.0, 160.0);
        let (end, _) = self.line_end();
        let angle_deg = Some(self.heading_deg);
        let values =
            FreeElementValues { angle_deg, end: end.map(Some), ..FreeElementValues::default() };
        self.add(values, end, None);
    }

    /// A line, an arc of a radius and a line, of which the angles and the last end are given.
    fn rounding(&mut self) {
        self.turn(false);
        let (end, _) = self.line_end();
        let angle_deg = Some(self.heading_deg);
        self.add(FreeElementValues { angle_deg, ..FreeElementValues::default() }, end, None);
        let sign = if self.numbers.below(2) == 0 { 1.0 } else { -1.0 };
        let radius = self.numbers.between(2.0, 20.0);
        let center = ahead(self.place, self.heading_deg + sign * 90.0, radius);
        self.heading_deg += sign * self.numbers.between(20.0, 160.0);
        let end = ahead(center, self.heading_deg - sign * 90.0, radius);
        let turn = Some(if sign > 0.0 { TurnDirection::Ccw } else { TurnDirection::Cw });
        let arc = FreeElementValues {
            turn,
            is_tangent: true,
            radius: Some(radius),
            ..FreeElementValues::default()
        };
        self.add(arc, end, Some(center));
        let (end, _) = self.line_end();
        let line = FreeElementValues {
            is_tangent: true,
            angle_deg: Some(self.heading_deg),
            end: end.map(Some),
            ..FreeElementValues::default()
        };
        self.add(line, end, None);
    }

    /// An arc, a tangent line of which nothing is given, and another arc; both centres and radii are given.
    fn belt(&mut self) {
        self.turn(false);
        let (sign, center, radius, end) = self.arc_of();
        let turn =
            |sign: f64| Some(if sign > 0.0 { TurnDirection::Ccw } else { TurnDirection::Cw });
        let arc = |sign: f64, center: [f64; 2], radius: f64| FreeElementValues {
            turn: turn(sign),
            center: Some(center),
            radius: Some(radius),
            ..FreeElementValues::default()
        };
        self.add(arc(sign, center, radius), end, Some(center));
        let (end, _) = self.line_end();
        let line = FreeElementValues { is_tangent: true, ..FreeElementValues::default() };
        self.add(line, end, None);
        let (sign, center, radius, end) = self.arc_of();
        let last =
            FreeElementValues { is_tangent: true, end: end.map(Some), ..arc(sign, center, radius) };
        self.add(last, end, Some(center));
    }
}

fn made(seed: u64) -> ([f64; 2], [f64; 2], MadeContour) {
    let mut numbers = NumberSequence(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
    let place = [numbers.between(-50.0, 50.0), numbers.between(-50.0, 50.0)];
    let heading_deg = numbers.between(-180.0, 180.0);
    let mut contour =
        MadeContour { numbers, place, heading_deg, values: Vec::new(), expected: Vec::new() };
    let entry = cos_sin(heading_deg);
    for _ in 0..=contour.numbers.below(4) {
        match contour.numbers.below(5) {
            0 => contour.line(),
            1 => contour.arc(),
            2 => contour.corner(),
            3 => contour.rounding(),
            _ => contour.belt(),
        }
    }
    (place, entry, contour)
}

#[test]
fn random_contours_are_solved() {
    let (mut solved, mut farthest) = (0, 0.0_f64);
    for seed in 0..20_000 {
        let (start, entry, contour) = made(seed);
        let found =
            solve_free_contour(&contour.values, start, Some(entry), Some(POLE), TOLERANCE_MM);
        let found = found.unwrap_or_else(|fault| {
            panic!("{seed}: {fault:?}\n{:#?}\n{:#?}", contour.values, contour.expected)
        });
        for (found, expected) in found.iter().zip(&contour.expected) {
            let off = |one: [f64; 2], other: [f64; 2]| (one[0] - other[0]).hypot(one[1] - other[1]);
            farthest = farthest.max(off(found.end, expected.end));
            let centers = found.center.zip(expected.center);
            farthest = farthest.max(centers.map_or(0.0, |(one, other)| off(one, other)));
            assert_eq!(found.center.is_some(), expected.center.is_some(), "{seed}");
            assert!(farthest < 1e-4, "{seed}: {found:?} {expected:?}\n{:#?}", contour.values);
        }
        solved += found.len();
    }
    println!("{solved} elements, {farthest:.1e} mm off at most");
}

#[test]
fn too_little_is_not_guessed() {
    let line = FreeElementValues { angle_deg: Some(30.0), ..FreeElementValues::default() };
    let solve = |values: &[FreeElementValues]| {
        solve_free_contour(values, [0.0; 2], None, None, TOLERANCE_MM)
    };
    assert_eq!(solve(&[line]), Err(FreeContourFault::Undetermined(0)));
    // A circle meets a line twice.
    let arc = FreeElementValues {
        turn: Some(TurnDirection::Ccw),
        center: Some([10.0, 0.0]),
        ..FreeElementValues::default()
    };
    let after = FreeElementValues {
        angle_deg: Some(90.0),
        end: [Some(12.0), Some(50.0)],
        ..FreeElementValues::default()
    };
    assert_eq!(solve(&[arc, after]), Err(FreeContourFault::Undetermined(0)));
    let contradiction = FreeElementValues {
        end: [Some(10.0), Some(0.0)],
        length: Some(12.0),
        ..FreeElementValues::default()
    };
    assert_eq!(solve(&[contradiction]), Err(FreeContourFault::Contradiction(0)));
}
