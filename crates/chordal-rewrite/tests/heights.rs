//! Programs bent over a map of heights, and what is refused.

use chordal::geometry::Vec3;
use chordal::{Command, CommandKind, Diagnostic, Job, Machine, RunSink, Sink, Source, SourceMap};
use chordal_rewrite::{HeightCorrection, HeightMap, HeightOptions, TransformRefusal, warp};

fn job(text: &str, machine: &str) -> Job<'static> {
    let machine = Machine::from_builtin(machine).expect("a built-in machine");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    Job::new(sources, machine).expect("good settings")
}

const FINE: HeightOptions = HeightOptions { tolerance_mm: 0.01, clamp: false };

fn map(text: &str) -> HeightMap {
    HeightMap::read(text.as_bytes(), 1.0).expect("a map")
}

/// A map of a formula over a grid.
fn map_of(columns: &[f64], rows: &[f64], height: impl Fn(f64, f64) -> f64) -> HeightMap {
    let mut text = String::new();
    for x in columns {
        for y in rows {
            text += &format!("{x},{y},{}\n", height(*x, *y));
        }
    }
    map(&text)
}

fn bent(text: &str, map: &HeightMap) -> HeightCorrection {
    let done = warp(&job(text, "haas-vf2"), map, &FINE).expect("bent");
    assert!(done.done.certificate.holds(), "{:?}", done.done.notes);
    done
}

fn text_of(warped: &HeightCorrection) -> String {
    String::from_utf8(warped.done.text.clone()).expect("text")
}

const HEAD: &str = "G21 G90 G17 G94\nT1 M6\nS1000 M3\nG54\n";

#[test]
fn a_map_of_zeros_changes_nothing() {
    let text = format!(
        "{HEAD}G0 X10. Y10.\nG43 H1 Z5.\nG1 Z-1. F100.\nX40.\nG2 X50. Y20. R10. (ROUND)\nG3 I-5.\nG0 Z5.\nM30\n"
    );
    let flat = map_of(&[0.0, 100.0], &[0.0, 50.0, 100.0], |_, _| 0.0);
    let done = bent(&text, &flat);
    assert_eq!(text_of(&done), text);
    assert_eq!(done.moves[0], done.moves[1]);
}

#[test]
fn over_a_slope_a_line_stays_one_and_an_arc_rises() {
    let slope = map_of(&[0.0, 50.0, 100.0], &[0.0, 50.0, 100.0], |x, y| 0.01 * x - 0.002 * y);
    let text = format!(
        "{HEAD}G0 X10. Y10.\nG43 H1 Z5.\nG1 Z-1. F100.\nX90. Y60.\nX80. M8\nG0 Z5.\nX10.\nM30\n"
    );
    let new = text_of(&bent(&text, &slope));
    let wanted = format!(
        "{HEAD}G0 X10. Y10.\nG43 H1 Z6.\nG1 Z-0.92 F100.\nX90. Y60. Z-0.22\nX80. Z-0.32 M8\nG0 Z6.\n\
         X10.\nM30\n"
    );
    assert_eq!(new, wanted);
    // A short arc is straight enough; a long one is cut, each piece about the same centre.
    let arcs = format!(
        "{HEAD}G0 X50. Y30.\nG43 H1 Z5.\nG1 Z-1. F100.\nG3 X50.5 Y30. R10.\nG3 X50.5 Y30. J20.\nG0 Z5.\nM30\n"
    );
    let new = text_of(&bent(&arcs, &slope));
    let pieces: Vec<&str> = new.lines().filter(|line| line.starts_with("G3")).collect();
    assert_eq!(pieces[0], "G3 X50.5 Y30. Z-0.555 R10.");
    assert!((6..20).contains(&pieces.len()) && pieces[1..].iter().all(|line| line.contains('I')));
}

/// Rapids are never nearer to the surface than they were, whatever lies between their ends.
#[test]
fn rapids_go_over_the_whole_map() {
    let ridge =
        map_of(
            &[0.0, 45.0, 50.0, 55.0, 100.0],
            &[0.0, 100.0],
            |x, _| if x == 50.0 { 3.0 } else { 0.0 },
        );
    let text = format!(
        "{HEAD}G0 X10. Y10.\nG43 H1 Z1.72\nX90. Z1.6\nG1 Z-1. F100.\nX80.\nG0 X20.\nG1 X10.\nG0 Z1.\nM30\n"
    );
    let new = text_of(&bent(&text, &ridge));
    let wanted = format!(
        "{HEAD}G0 X10. Y10.\nG43 H1 Z4.72\nX90. Z4.6\nG1 Z-1. F100.\nX80.\nG0 Z2.\nG0 X20.\nG1 Z-1.\nX10.\n\
         G0 Z4.\nM30\n"
    );
    assert_eq!(new, wanted);
    // Below zero everywhere: nothing is lowered over what is not measured, such as a clamp.
    let low = map_of(&[0.0, 100.0], &[0.0, 100.0], |_, _| -2.0);
    let text = format!("{HEAD}G0 X10. Y10.\nG43 H1 Z1.\nG1 Z-1. F100.\nX80.\nG0 Z1.\nM30\n");
    assert_eq!(text_of(&bent(&text, &low)), text.replace("Z-1.", "Z-3."));
}

/// A line across a ridge bends there, and nowhere else.
#[test]
fn a_line_bends_where_the_surface_does() {
    let ridge =
        map_of(&[0.0, 30.0, 60.0, 90.0], &[0.0, 90.0], |x, _| if x == 30.0 { 1.0 } else { 0.0 });
    let text = format!(
        "{HEAD}G0 X0 Y9.\nG43 H1 Z5.\nG1 Z-1. F100.\nN10 X90. Y18. F200. (ACROSS)\nG0 Z5.\nM30\n"
    );
    let new = text_of(&bent(&text, &ridge));
    assert!(
        new.contains("\nN10 X30. Y12. Z0. F200. (ACROSS)\nX60. Y15. Z-1.\nX90. Y18.\n"),
        "{new}"
    );
}

#[test]
fn places_of_the_machine_stay() {
    let high = map_of(&[0.0, 100.0], &[0.0, 100.0], |_, _| 0.5);
    let text = format!(
        "{HEAD}G28 G91 Z0\nG90\nG0 X10. Y10.\nG43 H1 Z5.\nG1 Z-1. F100.\nX20.\nG0 Z5.\nG53 Z0\nG0 X30.\nZ5.\nM30\n"
    );
    let new = text_of(&bent(&text, &high));
    let wanted = text.replace("Z5.", "Z5.5").replace("Z-1.", "Z-0.5");
    assert_eq!(new, wanted);
}

#[test]
fn what_does_not_lie_on_the_map_is_refused_with_its_line() {
    let bowl = map_of(&[0.0, 100.0], &[0.0, 100.0], |x, y| 0.0002 * x * y);
    let refused = |body: &str, words: &str| {
        let text = format!("{HEAD}G0 X10. Y10.\nG43 H1 Z5.\n{body}\nG0 Z9.\nM30\n");
        let refusal: TransformRefusal =
            warp(&job(&text, "haas-vf2"), &bowl, &FINE).err().unwrap_or_else(|| panic!("{body}"));
        assert!(refusal.what.contains(words), "{body}: {refusal}");
        assert!(refusal.line >= 7 && !refusal.help.is_empty(), "{body}: {refusal}");
    };
    refused("G81 Z-5. R2. F100.\nG80", "canned cycle");
    refused("G1 Z-1. F100.\nG91 X5.", "G91");
    refused("G1 Z-1. F100.\nG41 D1 X30.\nG40 X10.", "compensation");
    refused("G1 Z-1. F100.\nG18 G2 X20. Z-1. R5.", "G18 or G19");
    refused("G1 Z-1. F100.\nX120.", "20.0000 mm beyond the map");
    refused("G1 Z-1. F100.\nG3 X10. Y10. I90. J0.", "beyond the map");
    refused("G68 X0 Y0 R30.\nG1 Z-1. F100.\nG69", "no places");
    refused("#1=20.\nG1 Z-1. F100.\nX#1", "computed");
    refused("G1 Z-1. F100.\nG93 X90. Y80. F5.", "G93");
    refused("G1 Z-1. F100.\n/X40. Z-2.", "may be left out");
    refused("G1 Z-1. F100.\nG9 X90. Y80.", "is for one");
    refused("G55\nG1 Z-1. F100.", "one work offset");
    refused("G52 X5.\nG1 Z-1. F100.", "moves the zero");
    refused("G1 Z-1. F100.\nG20 X1.", "in inches and in millimetres");
    refused("G3 X15. Y15. R5. F100.", "height of a rapid");
    refused("G28 G91 Z0\nG90 G1 X20. F100.", "not given by the program");
    let far = format!("{HEAD}G0 X10. Y10.\nG43 H1 Z5.\nG1 Z-1. F100.\nX120.\nG0 Z5.\nM30\n");
    let clamp = HeightOptions { clamp: true, ..FINE };
    let done = warp(&job(&far, "haas-vf2"), &bowl, &clamp).expect("the edge goes on");
    assert!(done.done.certificate.holds() && text_of(&done).contains("X100. Z-0.8\nX120.\n"));
}

#[test]
fn a_bad_map_says_where() {
    let error = |text: &str| HeightMap::read(text.as_bytes(), 1.0).expect_err("no map");
    let not_a_number = error("x,y,z\n0,0,0\n0,10,no\n10,0,0\n10,10,0\n");
    assert_eq!((not_a_number.line, not_a_number.text.as_str()), (Some(3), "0,10,no"));
    assert!(not_a_number.what.contains("`no` in column 3"));
    assert!(error("0,0,0\n0,10,nan\n").what.contains("no number"));
    assert!(error("0,0,0\n0,10\n").what.contains("no Z"));
    let missing = error("0,0,0\n0,10,0\n10,0,0\n20,0,1\n20,10,1\n");
    assert!(
        missing.what.contains("lacks 1 point,") && missing.what.contains("X10 Y10"),
        "{missing}"
    );
    let twice = error("0,0,0\n0,10,0\n10,0,0\n10,10,0\n10,10.001,3\n");
    assert_eq!(twice.line, Some(5));
    assert!(twice.what.contains("line 4"));
    assert!(error("").what.contains("0 points") && error("0,0,1\n0,5,1\n").what.contains("1 in X"));
    let slanting: String = (0..20_000).map(|k| format!("{k},{k},0\n")).collect();
    assert!(error(&slanting).what.contains("20000 by 20000 lacks 399980000 points"));
    assert!(error("a,b,c\n0,0,0\n").what.contains("column x"));
    // Blanks, remarks, another order, decimal commas: all of them the same map.
    let plain = map("0,0,1\n10,0,2\n0,10,3\n10,10,4\n");
    for text in [
        "; probed\n# today\n0 0 1\n10\t0 2 # low\n\n0 10 3\n10 10 4",
        "Z;X;Y\r\n1,0;0,0;0\r\n2;10;0\r\n3;0;10\r\n4;10;10\r\n",
        "\u{feff}x [mm], y [mm], z [mm]\n10,10,4\n0,10,3\n10,0,2\n0,0,1\n",
        "0,0,1,0,0\n10,0.002,2,0,0\n0,10,3,0,0\n10,10,4,0,0\n",
    ] {
        let other = map(text);
        assert_eq!((other.size(), other.range()), (plain.size(), plain.range()), "{text}");
        assert!((other.height([2.5, 7.5]) - plain.height([2.5, 7.5])).abs() < 1e-3, "{text}");
    }
    assert_eq!(plain.height([2.5, 7.5]), 1.0 + 0.25 + 1.5);
    assert_eq!(plain.with_zero_at([10.0, 10.0]).range(), [-3.0, 0.0]);
}

/// A generator of its own, so that a round can be run again.
struct Dice(u64);

impl Dice {
    fn unit(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

/// The grid and its heights, read off naively in the test.
struct Grid {
    columns: Vec<f64>,
    rows: Vec<f64>,
    heights: Vec<Vec<f64>>,
}

impl Grid {
    fn any(dice: &mut Dice) -> Grid {
        let places = |dice: &mut Dice| {
            let count = 2 + (dice.unit() * 6.0) as usize;
            let mut at = -60.0;
            let step = 120.0 / (count - 1) as f64;
            let mut places = vec![at];
            for _ in 1..count - 1 {
                at += step * dice.between(0.7, 1.1);
                places.push((at * 100.0).round() / 100.0);
            }
            places.push(60.0);
            places
        };
        let (columns, rows) = (places(dice), places(dice));
        let rough = [0.1, 1.5, 25.0][(dice.unit() * 3.0) as usize];
        let heights = columns
            .iter()
            .map(|_| rows.iter().map(|_| dice.between(-rough, rough)).collect())
            .collect();
        Grid { columns, rows, heights }
    }

    fn text(&self) -> String {
        let mut text = String::from("x,y,z\n");
        for (x, column) in self.columns.iter().zip(&self.heights) {
            for (y, height) in self.rows.iter().zip(column) {
                text += &format!("{x},{y},{height}\n");
            }
        }
        text
    }

    fn height(&self, x: f64, y: f64) -> f64 {
        let cell = |places: &[f64], value: f64| {
            (0..places.len() - 2).find(|k| value < places[k + 1]).unwrap_or(places.len() - 2)
        };
        let (i, j) = (cell(&self.columns, x), cell(&self.rows, y));
        let u = (x - self.columns[i]) / (self.columns[i + 1] - self.columns[i]);
        let v = (y - self.rows[j]) / (self.rows[j + 1] - self.rows[j]);
        let z = &self.heights;
        let low = z[i][j] + (z[i + 1][j] - z[i][j]) * u;
        let high = z[i][j + 1] + (z[i + 1][j + 1] - z[i][j + 1]) * u;
        low + (high - low) * v
    }
}

/// A program of lines, arcs, circles and helices within ±60 mm.
fn program(dice: &mut Dice, inch: bool) -> String {
    let unit = if inch { 25.4 } else { 1.0 };
    let n = |mm: f64| if inch { format!("{:.4}", mm / unit) } else { format!("{mm:.3}") };
    let mut text = format!(
        "{}\nT1 M6\nS1000 M3\nG54\n",
        if inch { "G20 G90 G17 G94" } else { "G21 G90 G17 G94" }
    );
    let (mut x, mut y) = (dice.between(-50.0, 50.0), dice.between(-50.0, 50.0));
    text += &format!("G0 X{} Y{}\nG43 H1 Z{}\nG1 Z{} F50.\n", n(x), n(y), n(5.0), n(-1.0));
    for _ in 0..6 {
        let kind = dice.unit();
        if kind < 0.5 {
            (x, y) = (dice.between(-55.0, 55.0), dice.between(-55.0, 55.0));
            let z = if dice.unit() < 0.3 {
                format!(" Z{}", n(dice.between(-3.0, 0.0)))
            } else {
                String::new()
            };
            text += &format!("G1 X{} Y{}{z}\n", n(x), n(y));
        } else if kind < 0.85 {
            // About a centre nearer to the middle than the place.
            let share = dice.between(0.1, 0.5);
            let (cx, cy) = (x * (1.0 - share), y * (1.0 - share));
            let radius = (x - cx).hypot(y - cy);
            if radius < 1.0 || cx.hypot(cy) + radius > 58.0 {
                continue;
            }
            let turn = dice.between(0.2, 6.0);
            let start = (y - cy).atan2(x - cx);
            let way = if dice.unit() < 0.5 { 1.0 } else { -1.0 };
            let end = start + way * turn;
            let (i, j) = (cx - x, cy - y);
            (x, y) = (cx + radius * end.cos(), cy + radius * end.sin());
            let z = if dice.unit() < 0.3 {
                format!(" Z{}", n(dice.between(-3.0, 0.0)))
            } else {
                String::new()
            };
            let code = if way > 0.0 { "G3" } else { "G2" };
            text += &format!("{code} X{} Y{}{z} I{} J{}\n", n(x), n(y), n(i), n(j));
        } else {
            let radius = dice.between(2.0, 6.0);
            text += &format!("G1 X0 Y0\nG2 I{}\n", n(radius));
            (x, y) = (0.0, 0.0);
        }
    }
    text + &format!("G0 Z{}\nM30\n", n(5.0))
}

/// Points of the cuts of a run, near to each other.
#[derive(Default)]
struct Points(Vec<Vec3>);

impl Sink for Points {
    fn command(&mut self, command: &Command) {
        let Some(motion) = command.kind.motion() else { return };
        if matches!(command.kind, CommandKind::Rapid { .. }) {
            return;
        }
        let from = Vec3::new(motion.from[0], motion.from[1], motion.from[2]);
        let to = Vec3::new(motion.to[0], motion.to[1], motion.to[2]);
        let shape = command.kind.shape();
        if shape.is_none() && (from.x, from.y) == (to.x, to.y) {
            // Straight down from where rapids go, which is another height.
            return;
        }
        let length = match shape {
            Some(shape) => shape.radius_from * shape.sweep.abs(),
            // In the plane: both paths have as many points wherever they rise.
            None => (from.x - to.x).hypot(from.y - to.y),
        };
        let count = (length / 0.05).ceil().max(1.0);
        for k in 0..=count as u32 {
            let t = f64::from(k) / count;
            let z = from.z + (to.z - from.z) * t;
            self.0.push(match shape {
                None => from + (to - from) * t,
                Some(shape) => {
                    let [cx, cy] = shape.center;
                    let angle = (from.y - cy).atan2(from.x - cx) + shape.sweep * t;
                    let radius = shape.radius_from + (shape.radius_to - shape.radius_from) * t;
                    Vec3::new(cx + radius * angle.cos(), cy + radius * angle.sin(), z)
                }
            });
        }
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for Points {}

/// How far the farthest of some points is from the nearest of others, in the same order.
fn farthest(points: &[Vec3], others: &[Vec3]) -> f64 {
    let mut most = 0f64;
    for (index, point) in points.iter().enumerate() {
        let around = index as f64 / points.len() as f64 * others.len() as f64;
        let reach = 0.03 * others.len() as f64 + 40.0;
        let low = (around - reach).max(0.0) as usize;
        let high = ((around + reach) as usize).min(others.len());
        let near = others[low..high].windows(2).map(|pair| {
            let (a, way) = (pair[0], pair[1] - pair[0]);
            let square = way.dot(way);
            let t =
                if square > 0.0 { ((*point - a).dot(way) / square).clamp(0.0, 1.0) } else { 0.0 };
            point.distance(a + way * t)
        });
        most = most.max(near.fold(f64::INFINITY, f64::min));
    }
    most
}

/// Random programs over random maps, held against the surface by points of both paths.
#[test]
fn random_programs_lie_on_random_surfaces() {
    let rounds: u64 =
        option_env!("CHORDAL_ROUNDS").and_then(|count| count.parse().ok()).unwrap_or(24);
    let (mut worst, mut moves) = (0f64, [0, 0]);
    for seed in 0..rounds {
        let mut dice = Dice(seed.wrapping_mul(7919) + 17);
        let grid = Grid::any(&mut dice);
        let map = map(&grid.text());
        let inch = dice.unit() < 0.3;
        let machine = ["haas-vf2", "fanuc-30i", "mitsubishi-m700", "linuxcnc-mill"]
            [(dice.unit() * 4.0) as usize];
        let text = program(&mut dice, inch);
        // On the roughest surfaces a rounded place has a height of its own.
        let steep = map.range()[1] > 5.0;
        let tolerance_mm =
            [0.01, 0.02, 0.1][(dice.unit() * 3.0) as usize] * if steep { 4.0 } else { 1.0 };
        let old = job(&text, machine);
        let done = warp(&old, &map, &HeightOptions { tolerance_mm, clamp: false })
            .unwrap_or_else(|refusal| panic!("{seed}: {refusal}\n{text}"));
        assert!(
            done.done.certificate.holds(),
            "{seed} {machine}: {:?} {:?}\n{text}",
            done.done.notes,
            done.done.certificate.comparison.differences
        );
        let [mut meant, mut made] = [Points::default(), Points::default()];
        old.run(&mut meant);
        old.with_text(done.done.text.clone()).run(&mut made);
        for point in &mut meant.0 {
            point.z += grid.height(point.x, point.y);
        }
        let off = farthest(&meant.0, &made.0).max(farthest(&made.0, &meant.0));
        // Points are 0.05 mm apart: between them the surface bends by less than a micron.
        assert!(off <= tolerance_mm + 0.001, "{seed} {machine}: {off} of {tolerance_mm}\n{text}");
        let told = done.done.certificate.comparison.max_distance_mm.expect("a distance");
        assert!(off <= told + 0.001 && told <= tolerance_mm, "{seed}: {off}, told {told}");
        worst = worst.max(off / tolerance_mm);
        moves = [moves[0] + done.moves[0], moves[1] + done.moves[1]];
    }
    println!(
        "{rounds} programs, {} moves became {}, at most {worst:.2} of the tolerance",
        moves[0], moves[1]
    );
    assert!(moves[1] > 2 * moves[0]);
}
