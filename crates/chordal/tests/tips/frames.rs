//! Work offsets, shifts, presets, machine coordinates and reference returns against a small model of the place.

use chordal::geometry::{ParamCurve, Vec3};
use chordal::stock::StockVerdict;
use chordal::{Job, Source, SourceMap};

use crate::{Random, machine, rounds, run};

/// A plate of 60 by 40 by 20 mm below Z0 of G54.
const PLATE: [[f64; 3]; 2] = [[0.0, 0.0, -20.0], [60.0, 40.0, 0.0]];
const RADIUS_MM: f64 = 5.0;
/// Where G54 is, machine coordinates, mm.
const G54: [f64; 3] = [-300.0, -250.0, -300.0];

/// How long the tools 1 and 2 are, mm.
const LENGTHS: [f64; 2] = [80.0, 120.0];

/// A machine, and what its G92 does to a shift of G52.
struct Control {
    machine: &'static str,
    preset_clears_shift: bool,
}

const CONTROLS: [Control; 3] = [
    Control { machine: "fanuc-0i", preset_clears_shift: true },
    Control { machine: "haas-vf2", preset_clears_shift: true },
    Control { machine: "mitsubishi-m700", preset_clears_shift: false },
];

/// What the setup says of work offsets.
#[derive(Clone, Copy, PartialEq, Debug)]
enum GivenOffsets {
    Both,
    First,
    None,
}

/// The lengths of the first `lengths` tools are given.
fn setup(machine: &str, given: GivenOffsets, lengths: usize, g55: [f64; 3]) -> String {
    let system = |name: &str, [x, y, z]: [f64; 3]| {
        format!("[work_offsets.{name}]\nX = \"{x} mm\"\nY = \"{y} mm\"\nZ = \"{z} mm\"\n")
    };
    let systems = match given {
        GivenOffsets::Both => system("G54", G54) + &system("G55", g55),
        GivenOffsets::First => system("G54", G54),
        GivenOffsets::None => String::new(),
    };
    let [[ax, ay, az], [bx, by, bz]] = PLATE;
    format!(
        "machine = \"{machine}\"\n[stock]\nshape = \"box\"\nwork_offset = \"G54\"\n\
         from = {{ X = \"{ax} mm\", Y = \"{ay} mm\", Z = \"{az} mm\" }}\n\
         to = {{ X = \"{bx} mm\", Y = \"{by} mm\", Z = \"{bz} mm\" }}\n{systems}{}",
        tools(lengths)
    )
}

fn tools(lengths: usize) -> String {
    let tool = |(at, mm): (usize, &f64)| {
        let length = if at < lengths { format!("length = \"{mm} mm\"\n") } else { String::new() };
        format!(
            "[tools.{}]\nshape = \"flat\"\ndiameter = \"{} mm\"\nflute_length = \"300 mm\"\n{length}",
            at + 1,
            2.0 * RADIUS_MM
        )
    };
    LENGTHS.iter().enumerate().map(tool).collect()
}

/// The model: where the tip is, and what is added to program coordinates.
struct Model {
    preset_clears_shift: bool,
    /// The tool in the spindle and the length in force, by places in [`LENGTHS`].
    tool: usize,
    length: usize,
    text: String,
    /// The tip in coordinates of G54, mm; none where it is not known.
    tip: [Option<f64>; 3],
    /// The systems G54 and G55 as offsets from G54, mm.
    systems: [[f64; 3]; 2],
    active: usize,
    shift: [f64; 3],
    preset: [f64; 3],
    /// The tip goes through the plate, or may touch it.
    touches: bool,
    is_near: bool,
    /// The ends of moves, in coordinates of G54.
    ends: Vec<[Option<f64>; 3]>,
}

impl Model {
    fn zero(&self, axis: usize) -> f64 {
        let zero = self.systems[self.active][axis] + self.shift[axis] + self.preset[axis];
        if axis == 2 { zero + LENGTHS[self.length] - LENGTHS[self.tool] } else { zero }
    }

    /// Z of the tip where the slide stands at its zero.
    fn top(&self) -> f64 {
        -G54[2] - LENGTHS[self.tool]
    }

    /// Another tool, high above the part, and most often its own length.
    fn change_tool(&mut self, random: &mut Random) {
        self.text += "G53 G0 Z0\n";
        self.arrive(2, self.top(), true);
        self.tool = 1 - self.tool;
        self.text += &format!("T{} M6\nS3000 M3\n", self.tool + 1);
        self.tip[2] = Some(self.top());
        let is_right = random.share() < 0.7;
        self.length = if is_right { self.tool } else { 1 - self.tool };
        self.text += &format!("G43 H{}\n", self.length + 1);
        // A cut with a wrong length is an error wherever it is.
        self.is_near |= !is_right;
    }

    /// One axis to a place of G54.
    fn go(&mut self, code: &str, axis: usize, to: f64) {
        let program = to - self.zero(axis);
        let written = (program * 1000.0).round() / 1000.0;
        let letter = ["X", "Y", "Z"][axis];
        self.text += &format!("{code} {letter}{written:.3}\n");
        self.arrive(axis, written + self.zero(axis), code.starts_with("G0"));
    }

    fn arrive(&mut self, axis: usize, to: f64, is_rapid: bool) {
        let from = self.tip;
        self.tip[axis] = Some(to);
        self.ends.push(self.tip);
        if !is_rapid {
            return;
        }
        let (Some(_), [Some(x), Some(y), Some(z)]) = (from[axis], self.tip) else { return };
        let end = [x, y, z];
        let mut start = end;
        start[axis] = from[axis].unwrap_or(to);
        let meets = |grow: f64, below: f64| {
            (0..3).all(|axis| {
                let grow = if axis == 2 { below } else { grow };
                let (low, high) = (PLATE[0][axis] - grow, PLATE[1][axis] + grow);
                start[axis].max(end[axis]) > low && start[axis].min(end[axis]) < high
            })
        };
        // A retract leaves what it has touched before.
        let lifts = axis == 2 && end[2] >= start[2];
        self.touches |= meets(-2.0, -2.0) && !lifts;
        self.is_near |= meets(RADIUS_MM + 1.0, 1.0);
    }

    fn step(&mut self, random: &mut Random) {
        let mm = |random: &mut Random| (random.between(-25.0, 25.0) * 10.0).round() / 10.0;
        match (random.share() * 13.0) as usize {
            0 => {
                let by = [mm(random), mm(random), mm(random)];
                self.shift = by;
                self.text += &format!("G52 X{:.1} Y{:.1} Z{:.1}\n", by[0], by[1], by[2]);
            }
            1 => {
                self.shift = [0.0; 3];
                self.text += "G52 X0 Y0 Z0\n";
            }
            2 => {
                // One axis gets a coordinate where it stands.
                let axis = (random.share() * 3.0) as usize;
                let Some(tip) = self.tip[axis] else { return };
                let value = mm(random);
                // Fanuc takes G52 back on the axes that G92 names.
                if self.preset_clears_shift {
                    self.shift[axis] = 0.0;
                }
                self.preset[axis] += tip - value - self.zero(axis);
                self.text += &format!("G92 {}{value:.1}\n", ["X", "Y", "Z"][axis]);
            }
            3 => {
                self.active = 1 - self.active;
                self.text += if self.active == 0 { "G54\n" } else { "G55\n" };
            }
            4 => {
                self.text += "G53 G0 Z0\n";
                // The machine's zero, less the tool.
                self.arrive(2, self.top(), true);
            }
            5 => {
                self.text += "G91 G28 Z0\nG90\n";
                self.arrive(2, self.top(), true);
            }
            6 => {
                self.go("G0", 2, [40.0, 12.0][(random.share() * 2.0) as usize]);
            }
            7 => {
                self.go("G0", 2, random.between(-8.0, 12.0));
            }
            8 | 9 => {
                let axis = (random.share() * 2.0) as usize;
                let to = random.between(-20.0, 75.0);
                self.go("G0", axis, to);
            }
            10 => {
                // G55 is written anew.
                let by = [mm(random), mm(random), mm(random)];
                self.systems[1] = by;
                let [x, y, z] = std::array::from_fn(|axis| G54[axis] + by[axis]);
                self.text += &format!("G10 L2 P2 X{x:.1} Y{y:.1} Z{z:.1}\n");
            }
            11 => self.change_tool(random),
            _ => {
                // A cut far from the plate.
                self.go("G0", 2, 60.0);
                self.go("G0", 0, 90.0);
                self.go("G1 F300.", 2, 50.0);
            }
        }
    }
}

fn program(control: &Control, random: &mut Random, g55: [f64; 3]) -> Model {
    let from_first = std::array::from_fn(|axis| g55[axis] - G54[axis]);
    let begin = "O1\nG21 G17 G40 G49 G80 G90 G94\nT1 M6\nG54 S3000 M3\nG0 X90. Y10.\nG43 H1 Z60.\n";
    let mut model = Model {
        preset_clears_shift: control.preset_clears_shift,
        tool: 0,
        length: 0,
        text: begin.to_string(),
        tip: [Some(90.0), Some(10.0), Some(60.0)],
        systems: [[0.0; 3], from_first],
        active: 0,
        shift: [0.0; 3],
        preset: [0.0; 3],
        touches: false,
        is_near: false,
        ends: Vec::new(),
    };
    for _ in 0..12 {
        model.step(random);
    }
    // In G54, so that the frame of the run is known where nothing was cut before.
    model.go("G0", 2, 60.0);
    model.go("G0", 0, 90.0);
    model.go("G1 F300.", 2, 50.0);
    model.text += "M30\n";
    model
}

/// The ends of the moves of a run, in its frame.
fn ends(setup: &str, program: &str) -> Vec<(Vec3, bool)> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.as_bytes().to_vec()));
    let job = Job::new(sources, machine(setup)).expect("settings of the control");
    let mut found = Vec::new();
    job.path(|segment| {
        found.push((segment.curve.end(), segment.known && segment.unrelated_zero.is_none()));
    });
    found
}

#[test]
fn the_tip_is_where_a_model_of_the_machine_has_it() {
    let (mut touched, mut clean, mut placed) = (0, 0, 0);
    for round in 0..36 * rounds() {
        let mut random = Random::new(0xf4a3e + round);
        let given =
            [GivenOffsets::Both, GivenOffsets::First, GivenOffsets::None][(round % 3) as usize];
        let near = |value: f64, random: &mut Random| value + (random.between(-20.0, 20.0)).round();
        let g55 = std::array::from_fn(|axis| near(G54[axis], &mut random));
        let control = &CONTROLS[(round / 3 % 3) as usize];
        let model = program(control, &mut random, g55);
        let lengths = (round / 9 % 3) as usize;
        let first = model.text.find("G1 ").expect("a cut");
        let is_second = model.text[..first].rfind("G55") > model.text[..first].rfind("G54");
        if is_second && given != GivenOffsets::Both {
            // Where the plate is is not known: there is no run.
            continue;
        }
        let setup = setup(control.machine, given, lengths, g55);
        let all_known = given == GivenOffsets::Both && lengths == LENGTHS.len();
        let found = run(&setup, &model.text);
        if model.touches {
            touched += 1;
            assert_ne!(
                found.verdict,
                StockVerdict::Clean,
                "round {round} {given:?} {lengths} on {}\n{}",
                control.machine,
                model.text
            );
        }
        if !all_known {
            continue;
        }
        // Everything is known: a path that stays away is clean, and each place is the model's.
        if !model.is_near {
            clean += 1;
            let said = &found.report.diagnostics;
            assert_eq!(
                found.verdict,
                StockVerdict::Clean,
                "round {round}: {said:?}\n{}",
                model.text
            );
        }
        let set_up = std::array::from_fn(|axis| g55[axis] - G54[axis]);
        let origin = if is_second { set_up } else { [0.0; 3] };
        let ends = ends(&setup, &model.text);
        // Moves that go nowhere are no piece of path.
        let mut at = 0;
        for place in &model.ends {
            let [Some(x), Some(y), Some(z)] = *place else { continue };
            let place = Vec3::new(x - origin[0], y - origin[1], z - origin[2]);
            let same = |(end, known): &(Vec3, bool)| *known && (*end - place).length() < 1e-6;
            if let Some(next) = ends[at..].iter().position(same) {
                (at, placed) = (at + next, placed + 1);
            } else {
                panic!("round {round}: no move ends at {place:?}\n{}\n{ends:?}", model.text);
            }
        }
    }
    assert!(touched > 30 && clean > 90 && placed > 1500, "{touched} {clean} {placed}");
}
