//! Programs that give the tip of the tool, written for machines whose axes are programmed.

use chordal::control::{Command, CommandKind, Move};
use chordal::geometry::Vec3;
use chordal::machine::KinematicChain;
use chordal::{Diagnostic, RunSink, Sink};

use super::*;

const OFFSETS: &str = "
[work_offsets.G54]
X = '-300 mm'
Y = '-200 mm'
Z = '-380 mm'
[tools.1]
length = '100 mm'
diameter = '10 mm'
";

/// The offsets of G54 and of the tool together, mm.
const GAUGE_POINT: Vec3 = Vec3::new(-300.0, -200.0, -280.0);

/// C on A, each through a point that may be elsewhere.
fn trunnion(control: &str, away: f64) -> Machine {
    let text = format!(
        "inherits = '{control}'
[axes.A]
travel = ['-120 deg', '120 deg']
[axes.C]
travel = ['-3600 deg', '3600 deg']
[rotary.A]
turns = 'table'
point = {{ Y = '{} mm', Z = '{} mm' }}
[rotary.C]
turns = 'table'
point = {{ X = '{} mm', Y = '{} mm' }}
{OFFSETS}",
        -200.0 - away,
        -400.0 - 2.0 * away,
        -300.0 + away,
        -200.0 - away,
    );
    let read = |name: &str| Err(format!("no {name}"));
    let mut machine = Machine::from_toml("trunnion.toml", &text, &read).expect("a machine");
    machine.axes[4] = None;
    machine
}

fn options(axis_positions: bool) -> ConversionOptions {
    ConversionOptions { axis_positions, tolerance_mm: 0.01, ..ConversionOptions::default() }
}

/// The moves of a run, each with its feed.
#[derive(Default)]
struct MovesOfRun(Vec<(Move, Option<f64>)>);

impl Sink for MovesOfRun {
    fn command(&mut self, command: &Command) {
        assert!(!matches!(command.kind, CommandKind::PartFrame { frame: Some(_), .. }), "a frame");
        if let Some(motion) = command.kind.motion() {
            self.0.push((*motion, command.kind.feed().map(|feed| feed.value)));
        }
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for MovesOfRun {}

fn moves(job: &Job) -> Vec<(Move, Option<f64>)> {
    let mut moves = MovesOfRun::default();
    job.run(&mut moves);
    moves.0
}

/// The tip on the part, relative to G54 with the tables at zero, of a position of the axes.
fn tip(chain: &KinematicChain, place: &[f64; 6]) -> Vec3 {
    let gauge = Vec3::new(place[0], place[1], place[2]) + GAUGE_POINT;
    let pose = chain.pose(gauge, &[place[3], place[4], place[5]], Vec3::new(0.0, 0.0, -100.0));
    pose.tip - Vec3::new(-300.0, -200.0, -380.0)
}

const START: &str = "O1\nG21 G90 G17 G94\nT1 M6\nS5000 M3\nG54 G0 X0 Y0 A0 C0\n";

#[test]
fn the_tip_stays_on_its_line() {
    let text = format!("{START}G43.4 H1 Z50.\nG1 X50. Y0 Z0 A30. C90. F500.\nG49\nM30\n");
    let old = job(&text, trunnion("fanuc-ac-trunnion", 0.0));
    let found = convert(&old, &trunnion("fanuc-ac-trunnion", 0.0), &options(true));
    assert!(found.holds(), "{}\n{}", verdict(&found), found.text);
    assert!(found.text.contains("G93") && !found.text.contains("G43.4"), "{}", found.text);
    let chain = old.machine().kinematic_chain().expect("a chain");
    let new = found.job("new").expect("a job");
    let (from, to) = (Vec3::new(0.0, 0.0, 50.0), Vec3::new(50.0, 0.0, 0.0));
    let (mut cuts, mut farthest, mut seconds) = (0, 0.0_f64, 0.0);
    for (motion, feed) in moves(&new) {
        let Some(feed) = feed else { continue };
        cuts += 1;
        seconds += feed.recip();
        for share in [0.0, 0.25, 0.5, 0.75, 1.0] {
            let place: [f64; 6] = std::array::from_fn(|axis| {
                motion.from[axis] * (1.0 - share) + motion.to[axis] * share
            });
            let tip = tip(&chain, &place);
            let along = ((tip - from).dot(to - from) / (to - from).dot(to - from)).clamp(0.0, 1.0);
            farthest = farthest.max(tip.distance(from.lerp(to, along)));
        }
    }
    assert!(cuts > 10 && farthest < 0.01, "{cuts} cuts, {farthest} mm");
    // 70.71 mm at 500 mm/min.
    let due = from.distance(to) / 500.0 * 60.0;
    assert!((seconds / due - 1.0).abs() < 1e-3, "{seconds} s, not {due} s");
}

#[test]
fn planes_become_rotated_coordinates() {
    let text = format!(
        "{START}G43 H1 Z100.\nG68.2 X50. Y0 Z0 I0 J30. K0\nG53.1\nG0 X0 Y0 Z20.\nG1 Z-2. F200.\nG3 X0 Y0 I10. J0 F300.\nG0 Z20.\nG81 X5. Y5. Z-8. R2. F100.\nX15.\nG80\nG69\nG0 Z200.\nM30\n"
    );
    let old = job(&text, trunnion("fanuc-ac-trunnion", 0.0));
    for target in [
        trunnion("fanuc-ac-trunnion", 0.0),
        trunnion("linuxcnc-mill", 0.0),
        trunnion("mitsubishi-m700", 5.0),
    ] {
        let found = convert(&old, &target, &options(true));
        assert!(found.holds(), "{}: {}\n{}", target.name, verdict(&found), found.text);
        assert!(!found.text.contains("G68.2"), "{}", found.text);
        // The circle stays one: the table lays the plane level.
        assert!(found.text.lines().any(|line| line.contains("G3")), "{}", found.text);
    }
}

#[test]
fn what_nobody_knows_is_refused() {
    let text = format!("{START}G43.4 H1 Z50.\nG1 X50. Y0 Z0 A30. C90. F500.\nG49\nM30\n");
    let mut unknown = trunnion("fanuc-ac-trunnion", 0.0);
    unknown.work_offsets.clear();
    let found = convert(&job(&text, unknown), &trunnion("linuxcnc-mill", 0.0), &options(true));
    assert!(verdict(&found).contains("line 6: where the axes are"), "{}", verdict(&found));
    let old = job(&text, trunnion("fanuc-ac-trunnion", 0.0));
    let read = |name: &str| Err(format!("no {name}"));
    let other = "inherits = 'linuxcnc-mill'
[rotary.A]
turns = 'table'
reversed = true
point = { Y = '-200 mm', Z = '-400 mm' }
[rotary.C]
turns = 'table'
point = { X = '-300 mm', Y = '-200 mm' }
";
    let mut other = Machine::from_toml("other.toml", other, &read).expect("a machine");
    let found = convert(&old, &other, &options(true));
    assert!(verdict(&found).contains("`rotary.B.turns` is not given"), "{}", verdict(&found));
    other.axes[4] = None;
    let found = convert(&old, &other, &options(true));
    assert!(verdict(&found).contains("turn the tool in another way"), "{}", verdict(&found));
}

/// Random programs: lines with turning axes, arcs and holes in planes, rapids. CHORDAL_ROUNDS is their number.
#[test]
#[allow(clippy::disallowed_methods, reason = "how long a random test runs is for its caller")]
fn random_programs_are_proved() {
    let rounds: u64 =
        std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok()).unwrap_or(60);
    let (mut proved, mut farthest) = (0, 0.0_f64);
    for seed in 0..rounds {
        let (text, ends) = random_program(seed);
        let old = job(&text, trunnion("fanuc-ac-trunnion", 0.0));
        let (name, away) =
            [("fanuc-ac-trunnion", 0.0), ("linuxcnc-mill", 0.0), ("mitsubishi-m700", 7.0)]
                [(seed % 3) as usize];
        let target = trunnion(name, away);
        let found = convert(&old, &target, &options(true));
        assert!(found.holds(), "{seed} {name}: {}\n{text}\n{}", verdict(&found), found.text);
        proved += 1;
        // The tips of the ends, by the formulas of the new machine, are those of the program.
        let chain = target.kinematic_chain().expect("a chain");
        let new = found.job("new").expect("a job");
        let mut tips: Vec<Vec3> =
            moves(&new).iter().map(|(motion, _)| tip(&chain, &motion.to)).collect();
        for end in ends {
            let near = tips.iter().position(|tip| tip.distance(end) < 0.004);
            let Some(near) = near else {
                panic!("{seed}: no move ends at {end:?}\n{}", found.text)
            };
            farthest = farthest.max(tips[near].distance(end));
            tips.drain(..near);
        }
    }
    println!("{proved} of {rounds} proved, ends within {farthest:.4} mm");
}

/// The next number of a sequence, from 0 to 1.
fn next(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

/// A program, and the ends of the moves of the tip in work coordinates.
fn random_program(seed: u64) -> (String, Vec<Vec3>) {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x1234_5678;
    let mut between =
        |low: f64, high: f64| ((low + (high - low) * next(&mut state)) * 1000.0).round() / 1000.0;
    let mut text = format!("{START}G43.4 H1 Z60.\n");
    let mut ends = Vec::new();
    for _ in 0..8 {
        let [x, y, z] = [between(-60.0, 60.0), between(-60.0, 60.0), between(-5.0, 40.0)];
        ends.push(Vec3::new(x, y, z));
        let kind = between(0.0, 10.0);
        let rotary = match kind {
            0.0..2.0 => String::new(),
            2.0..4.0 => format!(" C{:.3}", between(-300.0, 300.0)),
            _ => format!(" A{:.3} C{:.3}", between(-40.0, 60.0), between(-300.0, 300.0)),
        };
        let code = if kind > 9.0 { "G0" } else { "G1" };
        text += &format!("{code} X{x:.3} Y{y:.3} Z{z:.3}{rotary} F{:.3}\n", between(100.0, 3000.0));
    }
    text += "G0 Z80.\nG0 X0 Y0 A0 C0\nG49\nG43 H1 Z90.\n";
    let (tilt, turn) = (between(0.0, 40.0), between(-90.0, 90.0));
    text += &format!("G68.2 X10. Y-5. Z3. I{turn:.3} J{tilt:.3} K0\nG53.1\nG0 X0 Y0 Z30.\n");
    text += &format!("G1 Z{:.3} F300.\n", between(-3.0, 3.0));
    text += &format!("G2 X{:.3} Y0 R{:.3} F500.\n", between(5.0, 20.0), between(12.0, 40.0));
    text += &format!(
        "G0 Z30.\nG81 X{:.3} Y{:.3} Z-4. R3. F200.\nG80\n",
        between(-20.0, 20.0),
        between(-20.0, 20.0)
    );
    text += "G0 Z60.\nG69\nG0 Z120.\nM30\n";
    (text, ends)
}
