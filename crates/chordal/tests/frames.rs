//! Mirror, scaling and rotation held against matrices that are multiplied here, without the kernel:
//! a program in frames, and the same program with every place multiplied out and written without a
//! frame, must make the same path of the tool centre.
//!
//! With equal factors the frames nest: the one commanded first is the outermost. That is another
//! formula than the kernel's, which keeps one order of layers and moves their centres.

use chordal::control::CommandKind;
use chordal::{Job, Machine, PathCommand, Severity, Source, SourceMap};

/// Rows of a matrix that takes (x, y, z, 1) to a place.
type Matrix = [[f64; 4]; 3];

const IDENTITY: Matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];

/// First `inner`, then `outer`.
fn product(outer: &Matrix, inner: &Matrix) -> Matrix {
    let mut of = [[0.0; 4]; 3];
    for row in 0..3 {
        for column in 0..4 {
            of[row][column] = (0..3).map(|k| outer[row][k] * inner[k][column]).sum::<f64>()
                + if column == 3 { outer[row][3] } else { 0.0 };
        }
    }
    of
}

fn place(of: &Matrix, p: [f64; 3]) -> [f64; 3] {
    of.map(|row| row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3])
}

fn way(of: &Matrix, p: [f64; 3]) -> [f64; 3] {
    of.map(|row| row[0] * p[0] + row[1] * p[1] + row[2] * p[2])
}

fn inverse(of: &Matrix) -> Matrix {
    // The matrices here are turns times one factor: the inverse is the transpose over its square.
    let size = (0..3).map(|row| of[row][0] * of[row][0]).sum::<f64>();
    let mut inverse = [[0.0; 4]; 3];
    for row in 0..3 {
        for column in 0..3 {
            inverse[row][column] = of[column][row] / size;
        }
    }
    let moved = way(&inverse, [of[0][3], of[1][3], of[2][3]]);
    for row in 0..3 {
        inverse[row][3] = -moved[row];
    }
    inverse
}

fn is_mirrored(of: &Matrix) -> bool {
    of[0][0] * of[1][1] - of[0][1] * of[1][0] < 0.0
}

/// A small generator of numbers, the same on every machine.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self, below: u32) -> u32 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as u32) % below
    }

    /// A length of three decimals between −50 and 50.
    fn length(&mut self) -> f64 {
        f64::from(self.next(100_001)) / 1000.0 - 50.0
    }

    fn angle(&mut self) -> f64 {
        match self.next(3) {
            0 => f64::from(self.next(8)) * 45.0,
            _ => f64::from(self.next(72_001)) / 100.0 - 360.0,
        }
    }
}

/// A program in frames and the same program multiplied out.
struct Pair {
    framed: String,
    plain: String,
    frames: Matrix,
    /// Where the tool stands, in the work coordinate system.
    work: [f64; 3],
    incremental: bool,
    /// The code of the side that is on, as the framed program writes it.
    side: Option<u8>,
}

impl Pair {
    fn new() -> Pair {
        let head = "G21 G17 G90 G94 G40 S500 M3\nF200.\nG0 X0 Y0 Z0\n";
        Pair {
            framed: head.into(),
            plain: head.into(),
            frames: IDENTITY,
            work: [0.0; 3],
            incremental: false,
            side: None,
        }
    }

    fn here(&self) -> [f64; 3] {
        place(&inverse(&self.frames), self.work)
    }

    /// A frame inside those in force.
    fn enter(&mut self, text: &str, frame: Matrix) {
        self.framed += text;
        self.framed += "\n";
        self.frames = product(&self.frames, &frame);
    }

    fn g91(&mut self, on: bool) {
        if self.incremental != on {
            self.incremental = on;
            self.framed += if on { "G91\n" } else { "G90\n" };
        }
    }

    /// The words of an end point in the frame; the place in the work coordinate system.
    fn words(&mut self, to: [f64; 3]) -> String {
        let from = self.here();
        let to_write = match self.incremental {
            true => [to[0] - from[0], to[1] - from[1], to[2] - from[2]],
            false => to,
        };
        let [x, y, z] = to_write;
        self.work = place(&self.frames, to);
        format!("X{x:.9} Y{y:.9} Z{z:.9}")
    }

    fn work_words(&self) -> String {
        let [x, y, z] = self.work;
        format!("X{x:.9} Y{y:.9} Z{z:.9}")
    }

    fn line(&mut self, code: &str, to: [f64; 3]) {
        let words = self.words(to);
        self.framed += &format!("{code} {words}\n");
        let words = self.work_words();
        self.plain += &format!("{code} {words}\n");
    }

    /// An arc of a quarter to three quarters of a turn about a centre at some distance.
    fn arc(&mut self, radius: f64, from_angle: f64, sweep: f64, rise: f64, by_radius: bool) {
        let from = self.here();
        let (c, s) = (from_angle.to_radians().cos(), from_angle.to_radians().sin());
        let to_center = [-radius * c, -radius * s, 0.0];
        let end_angle = (from_angle + sweep).to_radians();
        let to = [
            from[0] + to_center[0] + radius * end_angle.cos(),
            from[1] + to_center[1] + radius * end_angle.sin(),
            from[2] + rise,
        ];
        let work_center = way(&self.frames, to_center);
        let mirrored = is_mirrored(&self.frames);
        let code = |ccw: bool| if ccw { "G3" } else { "G2" };
        let words = self.words(to);
        let work_words = self.work_words();
        let [i, j, _] = to_center;
        let [wi, wj, _] = work_center;
        let (center, work_center) = match by_radius {
            true => {
                let sign = if sweep.abs() > 180.0 { -1.0 } else { 1.0 };
                let factor = (wi * wi + wj * wj).sqrt() / radius;
                (format!("R{:.9}", sign * radius), format!("R{:.9}", sign * radius * factor))
            }
            false => (format!("I{i:.9} J{j:.9}"), format!("I{wi:.9} J{wj:.9}")),
        };
        self.framed += &format!("{} {words} {center}\n", code(sweep > 0.0));
        self.plain += &format!("{} {work_words} {work_center}\n", code((sweep > 0.0) != mirrored));
    }

    fn compensation(&mut self, left: bool) {
        let code = |left: bool| if left { "G41" } else { "G42" };
        let mirrored = is_mirrored(&self.frames);
        self.side = Some(if left { 41 } else { 42 });
        self.framed += &format!("{} D1 ", code(left));
        self.plain += &format!("{} D1 ", code(left != mirrored));
    }

    fn end_compensation(&mut self) {
        self.side = None;
        self.framed += "G40 ";
        self.plain += "G40 ";
    }

    /// Holes: places and levels go through the frames.
    fn holes(&mut self, numbers: &mut Numbers) {
        self.g91(false);
        let here = self.here();
        let up = self.frames[2][2] > 0.0;
        if !up {
            return;
        }
        let (r, z) = (here[2] - 1.0, here[2] - 5.0);
        let level = |of: &Matrix, z: f64| of[2][2] * z + of[2][3];
        let (work_r, work_z) = (level(&self.frames, r), level(&self.frames, z));
        for at in 0..2 {
            let to = [numbers.length(), numbers.length(), here[2]];
            let work = place(&self.frames, to);
            let (code, levels, work_levels) = match at {
                0 => {
                    ("G98 G81 ", format!(" Z{z:.9} R{r:.9}"), format!(" Z{work_z:.9} R{work_r:.9}"))
                }
                _ => ("", String::new(), String::new()),
            };
            self.framed += &format!("{code}X{:.9} Y{:.9}{levels}\n", to[0], to[1]);
            self.plain += &format!("{code}X{:.9} Y{:.9}{work_levels}\n", work[0], work[1]);
            self.work = work;
        }
        self.framed += "G80\n";
        self.plain += "G80\n";
    }
}

fn mirror_x(line: f64) -> Matrix {
    [[-1.0, 0.0, 0.0, 2.0 * line], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]
}

fn scale(center: [f64; 3], by: f64) -> Matrix {
    let off = center.map(|c| c - by * c);
    [[by, 0.0, 0.0, off[0]], [0.0, by, 0.0, off[1]], [0.0, 0.0, by, off[2]]]
}

fn turn(center: [f64; 2], degrees: f64) -> Matrix {
    let (s, c) = degrees.to_radians().sin_cos();
    let [x, y] = center;
    [[c, -s, 0.0, x - c * x + s * y], [s, c, 0.0, y - s * x - c * y], [0.0, 0.0, 1.0, 0.0]]
}

/// Motions for one nesting of frames.
fn motions(pair: &mut Pair, numbers: &mut Numbers) {
    for _ in 0..4 {
        let incremental = numbers.next(3) == 0;
        pair.g91(incremental);
        let to = [numbers.length(), numbers.length(), numbers.length()];
        match numbers.next(5) {
            0 => pair.line("G0", to),
            1 | 2 => pair.line("G1", to),
            _ => {
                let radius = 2.0 + f64::from(numbers.next(2000)) / 100.0;
                let sweep = 20.0 + f64::from(numbers.next(280));
                let sweep = if numbers.next(2) == 0 { -sweep } else { sweep };
                // At half a circle a radius decides nothing.
                let by_radius = numbers.next(2) == 0 && (sweep.abs() - 180.0).abs() > 2.0;
                let angle = numbers.angle();
                let rise = if numbers.next(2) == 0 { 0.0 } else { numbers.length() };
                pair.arc(radius, angle, sweep, rise, by_radius);
            }
        }
    }
    if numbers.next(3) == 0 {
        pair.holes(numbers);
    }
    if numbers.next(3) == 0 {
        square(pair, numbers);
    }
}

/// A square outside of which the tool goes round, with compensation.
fn square(pair: &mut Pair, numbers: &mut Numbers) {
    pair.g91(false);
    let [x, y, z] = [numbers.length(), numbers.length(), pair.here()[2]];
    pair.line("G0", [x - 30.0, y - 25.0, z]);
    pair.compensation(true);
    pair.line("G1", [x, y - 15.0, z]);
    for [dx, dy] in [[0.0, 40.0], [40.0, 40.0], [40.0, 0.0], [-20.0, 0.0]] {
        pair.line("G1", [x + dx, y + dy, z]);
    }
    pair.end_compensation();
    pair.line("G1", [x - 40.0, y - 30.0, z]);
}

/// Enters up to three frames in any order, moves, and leaves them in reverse order.
fn nesting(numbers: &mut Numbers) -> Pair {
    let mut pair = Pair::new();
    let mut kinds = vec![0, 1, 2];
    let mut entered: Vec<(u32, Matrix)> = Vec::new();
    for _ in 0..=numbers.next(3) {
        let kind = kinds.remove(numbers.next(kinds.len() as u32) as usize);
        let before = pair.frames;
        pair.g91(false);
        let center = [numbers.length(), numbers.length(), numbers.length()];
        let [x, y, z] = center;
        match kind {
            0 => pair.enter(&format!("G51.1 X{x:.3}"), mirror_x(x)),
            1 => {
                let by = f64::from(numbers.next(2900) + 100) / 1000.0;
                let text = format!("G51 X{x:.3} Y{y:.3} Z{z:.3} P{by:.3}");
                pair.enter(&text, scale(center, by));
            }
            _ => {
                let degrees = numbers.angle();
                let text = format!("G68 X{x:.3} Y{y:.3} R{degrees:.3}");
                pair.enter(&text, turn([x, y], degrees));
            }
        }
        entered.push((kind, before));
        motions(&mut pair, numbers);
    }
    for (kind, before) in entered.into_iter().rev() {
        pair.framed += ["G50.1 X0\n", "G50\n", "G69\n"][kind as usize];
        pair.frames = before;
        pair.g91(numbers.next(2) == 0);
        pair.line("G1", [numbers.length(), numbers.length(), numbers.length()]);
    }
    pair
}

/// The commands of the tool centre: kind, ends, and the arc.
fn path(machine: &Machine, text: &str) -> Vec<(&'static str, Vec<f64>)> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("frames.nc", text.as_bytes().to_vec()));
    let job = Job::new(sources, machine.clone()).expect("good settings");
    let mut made = Vec::new();
    let report = job.report_of_path(|path: PathCommand<'_>, _| {
        let kind = match &path.command.kind {
            CommandKind::Rapid { .. } => "rapid",
            CommandKind::Line { .. } => "line",
            CommandKind::Arc { .. } => "arc",
            _ => return,
        };
        let motion = path.command.kind.motion().expect("a move");
        let mut numbers = [&motion.from[..3], &motion.to[..3]].concat();
        if let Some(shape) = path.command.kind.shape() {
            numbers.extend([shape.center[0], shape.center[1], shape.sweep]);
            numbers.extend([shape.radius_from, shape.radius_to]);
        }
        made.push((kind, numbers));
    });
    let errors: Vec<_> =
        report.diagnostics.iter().filter(|one| one.severity == Severity::Error).collect();
    let gouges = |code: &str| code.starts_with("CH5");
    assert!(errors.iter().all(|one| gouges(one.code.id())), "{text}\n{errors:#?}");
    made
}

#[test]
fn ten_thousand_nestings_multiplied_out() {
    let machine = Machine::from_toml(
        "frames.toml",
        "control = 'fanuc'\n[settings]\nexcess_decimals = 'exact'\n\
         [tools.1]\ndiameter = '6 mm'\n",
        &|_| Err("no neighbours".into()),
    );
    let machine = machine.unwrap_or_else(|errors| panic!("{errors:#?}"));
    let mut numbers = Numbers(1);
    let mut most: f64 = 0.0;
    for case in 0..10_000 {
        let pair = nesting(&mut numbers);
        let (framed, plain) = (path(&machine, &pair.framed), path(&machine, &pair.plain));
        let about = || format!("case {case}\n{}\n{}", pair.framed, pair.plain);
        assert_eq!(framed.len(), plain.len(), "{}", about());
        for (at, ((kind, one), (other_kind, other))) in framed.iter().zip(&plain).enumerate() {
            assert_eq!(kind, other_kind, "motion {at}: {}", about());
            assert_eq!(one.len(), other.len(), "motion {at}: {}", about());
            for (a, b) in one.iter().zip(other) {
                most = most.max((a - b).abs());
                assert!((a - b).abs() < 1e-5, "motion {at}: {one:?} {other:?} {}", about());
            }
        }
    }
    // Numbers are written to 1e-9; radii by R amplify that at nearly half circles.
    assert!(most > 0.0 && most < 1e-5, "{most}");
}
