//! TRAORI, directions of the tool and CYCLE800 on a machine with two tables. The positions of the axes are those of the
//! kinematic formulas, worked out apart from this code.

use chordal::diagnostics::{Code, Severity};
use chordal::motion::{MotionOptions, MotionStep, StepSource};
use chordal::{Job, Machine, Source, SourceMap};

/// C through X-300 Y-200 on A through Y-200 Z-400; G54 at (-300, -200, -380), and above it a tool of 100 mm.
const MACHINE: &str = "inherits = 'sinumerik-ac-trunnion'
[rotary.A]
point = { Y = '-200 mm', Z = '-400 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
[work_offsets.G54]
X = '-300 mm'
Y = '-200 mm'
Z = '-380 mm'
[tools.1]
length = '100 mm'
diameter = '10 mm'
";

fn job(text: &str, machine: &str) -> Job<'static> {
    let machine = Machine::from_toml("five.toml", machine, &|name| Err(format!("no {name}")));
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.mpf", text.as_bytes().to_vec()));
    Job::new(sources, machine.expect("a machine")).expect("a machine of this control")
}

fn clean(job: &Job) {
    let report = job.check();
    let told: Vec<_> = report
        .diagnostics
        .iter()
        .filter(|found| found.severity != Severity::Note)
        .map(|found| (found.code, found.message.clone()))
        .collect();
    assert_eq!(told, []);
    assert!(report.verified());
}

/// Where the last move of the axes ends, machine coordinates: mm and degrees.
fn last(job: &Job) -> [f64; 6] {
    let mut end = [f64::NAN; 6];
    let taken = job.motion(&MotionOptions::default(), |step: &MotionStep, _: &_| {
        if let MotionStep::Move(motion) = step {
            let to = motion.to();
            let gauge_point = [-300.0, -200.0, -280.0];
            end = std::array::from_fn(|axis| match axis {
                0..3 => to[axis] + gauge_point[axis],
                _ => to[axis].to_degrees(),
            });
        }
        Ok(())
    });
    assert!(taken.is_ok());
    drop(taken);
    end
}

fn assert_near(found: [f64; 6], expected: [f64; 6]) {
    let near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-4);
    assert!(near, "{found:?}, not {expected:?}");
}

const HEAD: &str = "G17 G90 G710 G94 G54\nT1 M6\nD1 S5000 M3\nG0 X10 Y0 Z20 A0 C0\n";

#[test]
fn traori_follows_the_tip_by_angles_and_by_the_direction_of_the_tool() {
    let expected = [-292.9289, -186.1237, -261.8234, 30.0, 0.0, 45.0];
    let by_angles = format!("{HEAD}TRAORI\nG1 X10 Y0 Z20 A30 C45 F500\nTRAFOOF\nM30\n");
    let job_by_angles = job(&by_angles, MACHINE);
    clean(&job_by_angles);
    assert_near(last(&job_by_angles), expected);
    // The direction at A30 C45 is (sin A sin C, -sin A cos C, cos A); its length does not matter.
    let by_vector = format!(
        "{HEAD}TRAORI(1)\nG1 X10 Y0 Z20 A3=0.7071067812 B3=-0.7071067812 C3=1.7320508076 F500\n\
         TRAFOOF\nM30\n"
    );
    let job_by_vector = job(&by_vector, MACHINE);
    clean(&job_by_vector);
    assert_near(last(&job_by_vector), expected);
}

/// The largest angle between the tool and a plane through the origin, degrees, from a program with one cut.
fn away_from_plane(text: &str, normal: [f64; 3]) -> (f64, usize) {
    let job = job(text, MACHINE);
    clean(&job);
    let (mut away, mut count): (f64, usize) = (0.0, 0);
    let taken = job.motion(&MotionOptions::default(), |step: &MotionStep, source: &StepSource| {
        if let MotionStep::Move(motion) = step
            && source.origin.line == CUT_LINE
        {
            let to = motion.to();
            let (a, c) = (to[3], to[5]);
            let tool = [a.sin() * c.sin(), -a.sin() * c.cos(), a.cos()];
            let across: f64 = tool.iter().zip(normal).map(|(tool, normal)| tool * normal).sum();
            (away, count) = (away.max(across.abs().asin().to_degrees()), count + 1);
        }
        Ok(())
    });
    assert!(taken.is_ok(), "limits");
    (away, count)
}

/// The line of the cut after `HEAD` and the two lines before it.
const CUT_LINE: u32 = 7;

#[test]
fn orivect_turns_the_tool_in_a_plane() {
    // From 30 degrees towards -Y to 30 degrees towards +X: in between it is 26 degrees upright in the plane of both.
    let (sin, cos) = (0.5, 0.75_f64.sqrt());
    let (from, to) = ([0.0, -sin, cos], [sin, 0.0, cos]);
    let cross: [f64; 3] = std::array::from_fn(|at| {
        let (b, c) = ((at + 1) % 3, (at + 2) % 3);
        from[b] * to[c] - from[c] * to[b]
    });
    let length = cross.iter().map(|part| part * part).sum::<f64>().sqrt();
    let normal = cross.map(|part| part / length);
    let program = |mode: &str| {
        format!(
            "{HEAD}TRAORI\n{mode} G1 A30 F500\nX20 A3={} B3={} C3={}\nTRAFOOF\nM30\n",
            to[0], to[1], to[2]
        )
    };
    let (away, count) = away_from_plane(&program("ORIVECT"), normal);
    assert!(away < 0.006 && count > 8, "{away} in {count}");
    let (away, _) = away_from_plane(&program("ORIAXES"), normal);
    assert!((away - 10.0).abs() < 3.0, "{away}");
    // Both end at the same angles.
    for mode in ["ORIVECT", "ORIAXES"] {
        let end = last(&job(&program(mode), MACHINE));
        assert!((end[3] - 30.0).abs() < 1e-6 && (end[5] - 90.0).abs() < 1e-6, "{mode}: {end:?}");
    }
    // From the pole C would have to turn before the tool tilts, which is not followed and is said.
    let from_pole = program("ORIVECT").replace("A30", "A0").replace("A3=0.5 B3=0", "A3=0.3 B3=0.4");
    let found = job(&from_pole, MACHINE).check().diagnostics;
    let told = found.iter().find(|found| found.code == Code::NotFollowed);
    assert!(told.is_some_and(|found| found.message.contains("out of its plane")), "{found:?}");
}

#[test]
fn cycle800_turns_the_plane_and_the_tables() {
    // Mode 57: X, Y, Z axis by axis; 30 degrees about X, the plane through X50.
    let text = format!(
        "{HEAD}G0 Z100\nCYCLE800(0,\"TABLE\",0,57,50,0,0,30,0,0,0,0,0,1,,1)\nG1 X10 Y5 Z2 F500\n\
         CYCLE800()\nM30\n"
    );
    let swivelled = job(&text, MACHINE);
    clean(&swivelled);
    assert_near(last(&swivelled), [-240.0, -185.0, -280.6795, 30.0, 0.0, 0.0]);
    let mut tip = [f64::NAN; 3];
    swivelled.path(|segment| tip = chordal::geometry::ParamCurve::end(&segment.curve).to_array());
    let near = tip.iter().zip([60.0, 3.3301, 4.2321]).all(|(a, b)| (a - b).abs() < 1e-4);
    assert!(near, "{tip:?}");
    // A plane that A cannot reach.
    let far = job(&text.replace(",30,0,0,", ",170,0,0,"), MACHINE);
    let found = far.check().diagnostics;
    assert!(found.iter().any(|each| each.code == Code::TiltedPlane), "{found:?}");
}

#[test]
fn save_gives_the_plane_of_the_caller_back() {
    let sub = "%_N_SIDE_SPF\nPROC SIDE SAVE\nCYCLE800(0,\"TABLE\",0,57,0,0,0,30,0,0,0,0,0,0,,1)\nG1 Z30 F500\nRET\n";
    let text = format!("%_N_PART_MPF\n{HEAD}G0 Z100\nSIDE\nG1 X10 Y5 Z2 F500\nM30\n{sub}");
    let mut tip = [f64::NAN; 3];
    job(&text, MACHINE)
        .path(|segment| tip = chordal::geometry::ParamCurve::end(&segment.curve).to_array());
    assert_eq!(tip, [10.0, 5.0, 2.0]);
}

#[test]
fn without_rotary_axes_the_time_is_not_verified() {
    let text = format!("{HEAD}TRAORI\nG1 X30 Y0 Z20 F500\nTRAFOOF\nM30\n").replace(" A0 C0", "");
    let unknown = MACHINE
        .replace("sinumerik-ac-trunnion", "sinumerik-mill")
        .replace("[rotary.A]\npoint = { Y = '-200 mm', Z = '-400 mm' }\n", "")
        .replace("[rotary.C]\npoint = { X = '-300 mm', Y = '-200 mm' }\n", "[axes.C]\n");
    let report = job(&text, &unknown).check();
    let codes: Vec<Code> = report.diagnostics.iter().map(|found| found.code).collect();
    assert!(codes.contains(&Code::KinematicsNotKnown), "{codes:?}");
    assert!(!report.verified() && report.is_path_verified());
}
