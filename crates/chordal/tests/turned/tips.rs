//! Nose radius compensation with every tip direction, held against circles: the nose, a circle about its centre,
//! touches the programmed contour everywhere and crosses it nowhere. The centre is found from the programmed point by
//! the definition of the tip; nothing of the compensation is used.

use chordal::geometry::ParamCurve;
use chordal::{Job, Machine, Source, SourceMap};

/// The nose, mm.
const NOSE: f64 = 0.8;
/// Points of each piece of path.
const POINTS: u32 = 1000;

/// From the programmed point to the centre of the nose by tip, (x, z) in radii.
const TO_CENTER: [(f64, f64); 10] = [
    (0.0, 0.0),
    (-1.0, -1.0),
    (-1.0, 1.0),
    (1.0, 1.0),
    (1.0, -1.0),
    (0.0, -1.0),
    (-1.0, 0.0),
    (0.0, 1.0),
    (1.0, 0.0),
    (0.0, 0.0),
];

/// A contour: blocks for G42, one for each element, and the same backwards for G41. (x radius, z) of its ends.
struct Contour {
    name: &'static str,
    approach: [(f64, f64); 2],
    elements: Vec<Element>,
    leave: (f64, f64),
    code: &'static str,
    /// Where the contour bends inward without an arc: nearer than half a nose no nose comes.
    inward: (f64, f64),
}

/// An element: its end and, of an arc, its centre and whether it is G3.
#[derive(Clone, Copy)]
struct Element {
    end: (f64, f64),
    arc: Option<((f64, f64), bool)>,
}

fn line(x: f64, z: f64) -> Element {
    Element { end: (x, z), arc: None }
}

fn arc(x: f64, z: f64, center: (f64, f64), g3: bool) -> Element {
    Element { end: (x, z), arc: Some((center, g3)) }
}

/// Outside: a face, a chamfer, a cone, a fillet, a round edge. In a bore: its mirror image with other sizes. Corners
/// that bend inward are round and larger than the nose, but for one.
fn contours() -> Vec<Contour> {
    let outside = |turn: bool| {
        let elements = vec![
            line(6.0, 0.0),
            line(8.0, -2.0),
            line(8.0, -20.0),
            line(12.0, -30.0),
            line(12.0, -40.0),
            arc(17.0, -45.0, (17.0, -40.0), false),
            line(20.0, -45.0),
            arc(24.0, -49.0, (20.0, -49.0), true),
            line(24.0, -60.0),
        ];
        let (from, to) = ((2.0, 0.0), (35.0, -60.0));
        contour("outside", turn, (2.0, 6.0), from, elements, to)
    };
    let inside = |turn: bool| {
        let elements = vec![
            line(25.0, -10.0),
            line(20.0, -14.0),
            arc(17.0, -17.0, (17.0, -14.0), true),
            line(14.0, -17.0),
            arc(11.0, -20.0, (14.0, -20.0), false),
            line(11.0, -35.0),
        ];
        let (from, to) = ((25.0, 1.0), (6.0, -38.0));
        contour("inside", turn, (20.0, 6.0), from, elements, to)
    };
    vec![outside(false), outside(true), inside(false), inside(true)]
}

/// A contour forwards, or backwards with the other code.
fn contour(
    name: &'static str,
    turn: bool,
    before: (f64, f64),
    from: (f64, f64),
    elements: Vec<Element>,
    leave: (f64, f64),
) -> Contour {
    let is_outside = name == "outside";
    let inward = if is_outside { (8.0, -20.0) } else { (25.0, -10.0) };
    if !turn {
        let code = if is_outside { "G42" } else { "G41" };
        return Contour { name, approach: [before, from], elements, leave, code, inward };
    }
    let mut starts = vec![from];
    starts.extend(elements.iter().map(|element| element.end));
    let count = elements.len();
    let back = (0..count).rev().map(|at| Element {
        end: starts[at],
        arc: elements[at].arc.map(|(center, g3)| (center, !g3)),
    });
    let code = if is_outside { "G41" } else { "G42" };
    let name = if is_outside { "outside, back" } else { "inside, back" };
    let approach = [leave, starts[count]];
    Contour { name, approach, elements: back.collect(), leave: before, code, inward }
}

impl Contour {
    fn program(&self) -> String {
        let mut text = String::from("G21 G18 G40 G97 G98\nS800 M3\nT0101\n");
        let [before, from] = self.approach;
        text += &format!("G0 X{:.4} Z{:.4}\n", 2.0 * before.0, before.1);
        text += &format!("{} G1 X{:.4} Z{:.4} F100.\n", self.code, 2.0 * from.0, from.1);
        let mut at = from;
        for element in &self.elements {
            let (x, z) = element.end;
            match element.arc {
                None => text += &format!("G1 X{:.4} Z{z:.4}\n", 2.0 * x),
                Some((center, g3)) => {
                    let word = if g3 { "G3" } else { "G2" };
                    let (i, k) = (center.0 - at.0, center.1 - at.1);
                    text += &format!("{word} X{:.4} Z{z:.4} I{i:.4} K{k:.4}\n", 2.0 * x);
                }
            }
            at = element.end;
        }
        text + &format!("G40 G1 X{:.4} Z{:.4}\nM30\n", 2.0 * self.leave.0, self.leave.1)
    }

    /// Points of the contour, (x, z).
    fn points(&self) -> Vec<(f64, f64)> {
        let mut points = Vec::new();
        let mut at = self.approach[1];
        for element in &self.elements {
            for step in 0..=100 {
                let part = f64::from(step) / 100.0;
                points.push(match element.arc {
                    None => {
                        let (x, z) = element.end;
                        (at.0 + part * (x - at.0), at.1 + part * (z - at.1))
                    }
                    Some(((x, z), g3)) => {
                        let angle = |p: (f64, f64)| (p.0 - x).atan2(p.1 - z);
                        let radius = (at.0 - x).hypot(at.1 - z);
                        let (from, to) = (angle(at), angle(element.end));
                        // From Z to X is G3.
                        let turn = std::f64::consts::TAU;
                        let way = if g3 {
                            (to - from).rem_euclid(turn)
                        } else {
                            -(from - to).rem_euclid(turn)
                        };
                        let here = from + part * way;
                        (x + radius * here.sin(), z + radius * here.cos())
                    }
                });
            }
            at = element.end;
        }
        points
    }
}

/// The centres of the nose on the blocks of the contour.
fn centers(contour: &Contour, tip: usize) -> Vec<(f64, f64)> {
    let setup = format!(
        "machine = 'fanuc-lathe'\n[tools.1]\nnose_radius = '{NOSE} mm'\ntip = {tip}\noffset.X = '-100 mm'\noffset.Z = '-50 mm'\n"
    );
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = Machine::from_toml("setup.toml", &setup, &none).expect("a good setup");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", contour.program().into_bytes()));
    let job = Job::new(sources, machine).expect("a job");
    let (first, last) = (6, 5 + contour.elements.len() as u32);
    let (x, z) = TO_CENTER[tip];
    let mut centers = Vec::new();
    job.path(|segment| {
        if !(first..=last).contains(&segment.origin.line) {
            return;
        }
        let length = segment.curve.length();
        for step in 0..=POINTS {
            let p = segment.curve.point_at(length * f64::from(step) / f64::from(POINTS));
            centers.push((p.x + NOSE * x, p.z + NOSE * z));
        }
    });
    centers
}

#[test]
fn the_nose_touches_everywhere_and_crosses_nowhere() {
    for contour in contours() {
        let points = contour.points();
        for tip in 0..10 {
            let centers = centers(&contour, tip);
            assert!(!centers.is_empty());
            for (x, z) in &points {
                let near =
                    centers.iter().map(|c| (c.0 - x).hypot(c.1 - z)).fold(f64::INFINITY, f64::min);
                let name = contour.name;
                assert!(
                    near >= NOSE - 1e-6,
                    "{name}, tip {tip}: {} inside at X{} Z{z}",
                    NOSE - near,
                    2.0 * x
                );
                if (contour.inward.0 - x).hypot(contour.inward.1 - z) < 0.5 * NOSE {
                    continue;
                }
                // As far apart as the sampled centres are.
                assert!(
                    near <= NOSE + 1e-2,
                    "{name}, tip {tip}: {} away at X{} Z{z}",
                    near - NOSE,
                    2.0 * x
                );
            }
        }
    }
}
