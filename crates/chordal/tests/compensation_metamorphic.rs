//! Compensation does not depend on how a contour is written down: the same closed contour,
//! read backwards, begun elsewhere, turned, mirrored, scaled or in inches, has the same path
//! of the tool centre.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use chordal::control::Origin;
use chordal::geometry::Vec2;
use chordal::{
    BlockRole, CompensationCurve, ContourPiece, Diagnostic, Job, Machine, PathCommand, PathSink,
    Severity, Source, SourceMap,
};
use proptest::prelude::*;

/// A closed contour: vertices, each with the bulge (tangent of a quarter of the sweep) of the
/// edge after it; the first edge is straight.
#[derive(Clone, Debug)]
struct Contour {
    vertices: Vec<(Vec2, f64)>,
    left: bool,
    radius: f64,
    /// Joints closer than this are tangent, mm.
    tangent: f64,
    inch: bool,
}

impl Contour {
    fn map(&self, point: impl Fn(Vec2) -> Vec2, bulge: f64) -> Contour {
        let vertices = self.vertices.iter().map(|(p, b)| (point(*p), b * bulge)).collect();
        Contour { vertices, ..self.clone() }
    }

    fn other_side(mut self) -> Contour {
        self.left = !self.left;
        self
    }

    /// Begun on the straight edge number `edge`.
    fn begun_at(&self, edge: usize) -> Contour {
        let straight: Vec<usize> =
            (0..self.vertices.len()).filter(|i| self.vertices[*i].1 == 0.0).collect();
        let mut contour = self.clone();
        contour.vertices.rotate_left(straight[edge % straight.len()]);
        contour
    }

    /// Run the other way, on the other side; it begins on the same edge.
    fn backwards(&self) -> Contour {
        let count = self.vertices.len();
        let vertices = (0..count)
            .map(|i| {
                // Edge i of the new contour is edge (count - i) of the old one.
                let edge = (count - i) % count;
                (self.vertices[(edge + 1) % count].0, -self.vertices[edge].1)
            })
            .collect();
        Contour { vertices, ..self.clone() }.other_side()
    }

    /// With a vertex more on a straight edge.
    fn divided(&self, edge: usize, part: f64) -> Contour {
        let mut contour = self.begun_at(edge);
        let (from, to) = (contour.vertices[0].0, contour.vertices[1].0);
        contour.vertices.insert(1, (from + (to - from) * part, 0.0));
        contour
    }

    /// How far the path may be from that of a contour with a divided edge, mm. At a tangent joint, whose
    /// ends are `tangent` apart or less, the edge leans by `tangent`²/2r over its length; a piece of it does
    /// so over its own.
    fn divided_by(&self) -> f64 {
        1e-6 + self.tangent * self.tangent / (2.0 * self.radius)
    }

    fn program(&self) -> String {
        let unit = if self.inch { 1.0 / 25.4 } else { 1.0 };
        let place = |p: Vec2| format!("X{:.12} Y{:.12}", p.a * unit, p.b * unit);
        let count = self.vertices.len();
        let (first, second) = (self.vertices[0].0, self.vertices[1].0);
        let start = first + (second - first) * 0.5;
        let along = (second - first).normalized().expect("an edge");
        let aside = start + along.turned_left() * if self.left { 20.0 } else { -20.0 };
        let mut text = format!(
            "{} G17 G90 G40\nG0 {}\nF100.\n{} D1 G1 {}\nG1 {}\n",
            if self.inch { "G20" } else { "G21" },
            place(aside),
            if self.left { "G41" } else { "G42" },
            place(start),
            place(second),
        );
        for i in 1..count {
            let (from, bulge) = self.vertices[i];
            let to = self.vertices[(i + 1) % count].0;
            if bulge == 0.0 {
                let _ = writeln!(text, "G1 {}", place(to));
            } else {
                let chord = to - from;
                let rise = (1.0 - bulge * bulge) / (4.0 * bulge);
                let center = chord * 0.5 + chord.turned_left() * rise;
                let code = if bulge > 0.0 { "G3" } else { "G2" };
                let (i, j) = (center.a * unit, center.b * unit);
                let _ = writeln!(text, "{code} {} I{i:.12} J{j:.12}", place(to));
            }
        }
        let _ = writeln!(text, "G1 {}\nG40 G1 {}\nM30", place(start), place(aside));
        text
    }

    /// The tool-centre path of the contour alone; `None` where the control alarms.
    fn path(&self) -> Option<Vec<CompensationCurve>> {
        let mut machine = Machine::from_builtin("fanuc-30i").expect("a built-in machine");
        machine.set(&format!("tools.1.diameter=\"{} mm\"", 2.0 * self.radius)).expect("a tool");
        let tangent = format!("settings.compensation_tangent_joint=\"{} mm\"", self.tangent);
        machine.set(&tangent).expect("a setting");
        // The contours have more decimals than the controls.
        for setting in ["settings.excess_decimals=exact", "settings.most_digits=0"] {
            machine.set(setting).expect("a setting");
        }
        let text = self.program();
        let mut sources = SourceMap::new();
        sources.add(Source::new("contour.nc", text.as_bytes()));
        let job = Job::new(sources, machine).expect("a job");
        let mut seen = Seen::default();
        job.compensated(None, &mut seen);
        (!seen.alarmed).then_some(seen.curves)
    }
}

#[derive(Default)]
struct Seen {
    curves: Vec<CompensationCurve>,
    alarmed: bool,
}

impl PathSink for Seen {
    fn command(&mut self, _: PathCommand<'_>) {}

    fn diagnostic(&mut self, diagnostic: Diagnostic, _: &Origin) {
        self.alarmed |= diagnostic.severity == Severity::Error;
    }

    fn contour(&mut self, piece: &ContourPiece) {
        if piece.role == BlockRole::Contour {
            self.curves.extend(&piece.centre);
        }
    }
}

fn distance(p: Vec2, curve: &CompensationCurve) -> f64 {
    let (from, to) = (curve.from(), curve.to());
    let ends = p.distance(from).min(p.distance(to));
    match *curve {
        CompensationCurve::Line { .. } => {
            let way = to - from;
            let part = (p - from).dot(way) / way.dot(way);
            if (0.0..=1.0).contains(&part) { p.distance(from + way * part) } else { ends }
        }
        CompensationCurve::Arc { center, sweep, radius_from, radius_to, .. } => {
            let (a, b) = (from - center, p - center);
            let angle = a.cross(b).atan2(a.dot(b)) * sweep.signum();
            let angle = if angle < 0.0 { angle + TAU } else { angle };
            let on = angle <= sweep.abs();
            // At a tangent joint the two radii differ by less than the tolerance.
            let radius = radius_from + (radius_to - radius_from) * angle / sweep.abs();
            if on { (p.distance(center) - radius).abs() } else { ends }
        }
    }
}

fn samples(curve: &CompensationCurve) -> Vec<Vec2> {
    let at = |part: f64| match *curve {
        CompensationCurve::Line { from, to } => from + (to - from) * part,
        CompensationCurve::Arc { from, center, sweep, radius_from, radius_to, .. } => {
            let (sin, cos) = (sweep * part).sin_cos();
            let radius = radius_from + (radius_to - radius_from) * part;
            let arm = (from - center) * (radius / radius_from);
            center + Vec2::new(arm.a * cos - arm.b * sin, arm.a * sin + arm.b * cos)
        }
    };
    [0.0, 0.31, 0.5, 0.83, 1.0].map(at).to_vec()
}

/// How far the points of one path are from the other, both ways.
fn apart(one: &[CompensationCurve], other: &[CompensationCurve]) -> f64 {
    let reach = |a: &[CompensationCurve], b: &[CompensationCurve]| {
        a.iter()
            .flat_map(samples)
            .map(|p| b.iter().map(|curve| distance(p, curve)).fold(f64::INFINITY, f64::min))
            .fold(0.0, f64::max)
    };
    reach(one, other).max(reach(other, one))
}

fn moved(
    path: &[CompensationCurve],
    point: impl Fn(Vec2) -> Vec2,
    turn: f64,
) -> Vec<CompensationCurve> {
    let move_one = |curve: &CompensationCurve| match *curve {
        CompensationCurve::Line { from, to } => {
            CompensationCurve::Line { from: point(from), to: point(to) }
        }
        CompensationCurve::Arc { from, to, center, sweep, .. } => {
            let (from, to, center) = (point(from), point(to), point(center));
            let (radius_from, radius_to) = (from.distance(center), to.distance(center));
            CompensationCurve::Arc { from, to, center, sweep: sweep * turn, radius_from, radius_to }
        }
    };
    path.iter().map(move_one).collect()
}

/// Star-shaped: vertices about the origin, so that no edge crosses another.
fn contours() -> impl Strategy<Value = Contour> {
    let vertex = (0.15..0.85f64, 15.0..60.0f64, prop_oneof![Just(0.0), -0.45..0.45f64]);
    (prop::collection::vec(vertex, 3..11), any::<bool>(), 0.2..4.0f64).prop_map(
        |(spokes, left, radius)| {
            let count = spokes.len() as f64;
            let vertices = spokes
                .iter()
                .enumerate()
                .map(|(i, (part, length, bulge))| {
                    let angle = (i as f64 + part) / count * TAU;
                    let bulge = if i == 0 || bulge.abs() < 0.02 { 0.0 } else { *bulge };
                    (Vec2::new(angle.cos() * length, angle.sin() * length), bulge)
                })
                .collect();
            Contour { vertices, left, radius, tangent: 0.002, inch: false }
        },
    )
}

fn same(
    one: Option<Vec<CompensationCurve>>,
    other: Option<Vec<CompensationCurve>>,
) -> Result<(), TestCaseError> {
    prop_assert_eq!(one.is_some(), other.is_some(), "one alarms, the other does not");
    if let (Some(one), Some(other)) = (one, other) {
        prop_assert!(!one.is_empty());
        let by = apart(&one, &other);
        prop_assert!(by < 1e-6, "{} mm apart", by);
    }
    Ok(())
}

fn rotated(p: Vec2, angle: f64) -> Vec2 {
    let (sin, cos) = angle.sin_cos();
    Vec2::new(p.a * cos - p.b * sin, p.a * sin + p.b * cos)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn backwards_on_the_other_side(contour in contours()) {
        same(contour.path(), contour.backwards().path())?;
    }

    #[test]
    fn begun_elsewhere(contour in contours(), edge in 0..10usize) {
        // Beginning on an edge divides it; its halves may be too short for their corners.
        if let (Some(one), Some(other)) = (contour.path(), contour.begun_at(edge).path()) {
            prop_assert!(apart(&one, &other) < contour.divided_by());
        }
    }

    #[test]
    fn a_line_in_two_pieces(contour in contours(), edge in 0..10usize, part in 0.05..0.45f64) {
        // Pieces shorter than the offset may fit no more between their corners.
        let divided = contour.divided(edge, part);
        if let (Some(one), Some(other)) = (contour.begun_at(edge).path(), divided.path()) {
            prop_assert!(apart(&one, &other) < contour.divided_by());
        }
    }

    #[test]
    fn turned_by_a_right_angle(contour in contours()) {
        let turn = |p: Vec2| p.turned_left();
        let path = contour.path().map(|path| moved(&path, turn, 1.0));
        same(path, contour.map(turn, 1.0).path())?;
    }

    #[test]
    fn turned(contour in contours(), angle in -PI..PI) {
        let turn = |p: Vec2| rotated(p, angle);
        let path = contour.path().map(|path| moved(&path, turn, 1.0));
        same(path, contour.map(turn, 1.0).path())?;
    }

    #[test]
    fn mirrored_on_the_other_side(contour in contours()) {
        let mirror = |p: Vec2| Vec2::new(-p.a, p.b);
        let path = contour.path().map(|path| moved(&path, mirror, -1.0));
        same(path, contour.map(mirror, -1.0).other_side().path())?;
    }

    #[test]
    fn scaled(contour in contours(), factor in 0.5..4.0f64) {
        let scale = |p: Vec2| p * factor;
        let path = contour.path().map(|path| moved(&path, scale, 1.0));
        let mut large = contour.map(scale, 1.0);
        large.radius *= factor;
        large.tangent *= factor;
        same(path, large.path())?;
    }

    #[test]
    fn in_inches(contour in contours()) {
        let inch = Contour { inch: true, ..contour.clone() };
        same(contour.path(), inch.path())?;
    }
}

#[test]
fn most_random_contours_run() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;

    let mut runner = TestRunner::deterministic();
    let run = (0..200)
        .filter(|_| {
            let tree = contours().new_tree(&mut runner).expect("a contour");
            tree.current().path().is_some()
        })
        .count();
    assert!(run > 100, "{run} of 200 run without an alarm");
}
