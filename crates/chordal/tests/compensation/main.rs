//! Worked cases of cutter compensation on the five controls.

mod special;
mod support;

use support::{Ran, Step, Sweep, machine, run};

/// A case of `cases.txt`.
#[derive(Debug, Default)]
struct Case {
    name: String,
    unit: String,
    radius: f64,
    program: String,
    ways: Vec<Expected>,
}

/// What a kind of control makes of it.
#[derive(Debug, Default)]
struct Expected {
    name: String,
    steps: Vec<Step>,
    alarm: Option<String>,
    interferes: bool,
    unreached: bool,
}

fn cases() -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    for line in include_str!("cases.txt").lines() {
        let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
        if word == "case" {
            cases.push(Case { name: rest.to_string(), ..Case::default() });
            continue;
        }
        let Some(case) = cases.last_mut() else { continue };
        match word {
            "unit" => case.unit = rest.to_string(),
            "radius" => case.radius = rest.parse().expect("a radius"),
            ">" => case.program += &format!("{rest}\n"),
            "path" => case.ways.push(Expected { name: rest.to_string(), ..Expected::default() }),
            "" => {}
            _ => read_way(case.ways.last_mut().expect("a path"), word, rest),
        }
    }
    cases
}

fn read_way(way: &mut Expected, word: &str, rest: &str) {
    let numbers: Vec<f64> = rest.split(' ').map_while(|number| number.parse().ok()).collect();
    match word {
        "line" => way.steps.push(Step { to: [numbers[0], numbers[1]], arc: None }),
        "arc" => {
            let sweep = match rest.rsplit(' ').next() {
                Some("cw") => Sweep::Clockwise,
                Some("ccw") => Sweep::Counterclockwise,
                _ => Sweep::Degrees(numbers[4]),
            };
            let arc = Some(([numbers[2], numbers[3]], sweep));
            way.steps.push(Step { to: [numbers[0], numbers[1]], arc });
        }
        "alarm" => way.alarm = Some(rest.to_string()),
        "interferes" => way.interferes = true,
        "unreached" => way.unreached = true,
        other => panic!("`{other}` in cases.txt"),
    }
}

/// A machine, the settings that make its control go this way, and its alarms: where a block
/// interferes, and where offsets do not meet.
struct On {
    machine: &'static str,
    settings: &'static [&'static str],
    no_check: &'static str,
    alarms: [&'static str; 2],
}

const FANUC_OFF: &str = "settings.\"No. 5008#3\"=1";
const MITSUBISHI_OFF: &str = "settings.\"#8103\"=1";
const OFF: &str = "settings.compensation_check=off";
const FANUC: [&str; 2] = ["PS0041", "PS0033"];
const MITSUBISHI: [&str; 2] = ["P153", "P152"];
const HAAS: [&str; 2] = ["alarm 342", "alarm 342"];
const FADAL: [&str; 2] = ["TOOL DIAMETER TOO LARGE AT N=", "TOOL DIAMETER TOO LARGE AT N="];

/// The controls that go a way of `cases.txt`.
fn controls(way: &str) -> Vec<On> {
    let on = |machine, settings, no_check, alarms| On { machine, settings, no_check, alarms };
    match way {
        "typeA_linear" => vec![
            on("fanuc-30i", &[], FANUC_OFF, FANUC),
            on("mitsubishi-m700", &[], MITSUBISHI_OFF, MITSUBISHI),
            on("haas-vf2", &["settings.compensation_lead=any"], OFF, HAAS),
            on("fadal-4020", &["settings.format=2", "settings.outside_corner=linear"], OFF, FADAL),
        ],
        "typeB_linear" => vec![
            on("fanuc-30i", &["settings.\"No. 5003#0\"=1"], FANUC_OFF, FANUC),
            on("mitsubishi-m700", &["settings.\"#1229 set01/bit2\"=1"], MITSUBISHI_OFF, MITSUBISHI),
        ],
        "typeA_circular" => vec![
            on("fanuc-30i", &["settings.\"No. 19607#2\"=1"], FANUC_OFF, FANUC),
            on(
                "haas-vf2",
                &["settings.\"Setting 58\"=yasnac", "settings.compensation_lead=any"],
                OFF,
                HAAS,
            ),
            on("fadal-4020", &["settings.format=2"], OFF, FADAL),
        ],
        "linuxcnc" => vec![on("linuxcnc-mill", &[], OFF, ["", ""])],
        other => panic!("`{other}` in cases.txt"),
    }
}

#[test]
fn the_worked_cases_come_out() {
    let mut failures = Vec::new();
    let mut compared = 0;
    for case in &cases() {
        for way in &case.ways {
            for on in controls(&way.name) {
                if on.machine == "haas-vf2" && !case.program.contains("G17") {
                    continue;
                }
                compared += 1;
                let found = compare(case, way, &on);
                let place = format!("{} · {} · {}", case.name, way.name, on.machine);
                failures.extend(found.into_iter().map(|what| format!("{place}\n    {what}")));
            }
        }
    }
    assert!(compared > 200, "only {compared} ways were compared");
    assert!(failures.is_empty(), "{} failures:\n{}", failures.len(), failures.join("\n"));
}

fn compare(case: &Case, way: &Expected, on: &On) -> Vec<String> {
    let mm = if case.unit == "inch" { 25.4 } else { 1.0 };
    let go = |more: &[&str]| -> Ran {
        let settings: Vec<&str> = on.settings.iter().chain(more).copied().collect();
        run(&case.program, machine(on.machine, case.radius, &case.unit, &settings), mm)
    };
    let mut failures = Vec::new();
    let checked = go(&[]);
    let linuxcnc = way.name == "linuxcnc";
    let wanted = match (&way.alarm, way.interferes, way.unreached) {
        (Some(alarm), _, _) => Some(alarm.as_str()),
        (_, true, _) => Some(on.alarms[0]),
        (_, _, true) => Some(on.alarms[1]),
        _ => None,
    };
    match wanted {
        Some(alarm) if !checked.alarms.iter().any(|shown| shown.contains(alarm)) => {
            failures.push(format!("wanted the alarm `{alarm}`, shown {:?}", checked.alarms));
        }
        None if !checked.alarms.is_empty() => {
            failures.push(format!("no alarm is expected, shown {:?}", checked.alarms));
        }
        _ => {}
    }
    if !way.unreached {
        // A control that alarms goes no further; the figures go on as if it did not look.
        let ran = if wanted.is_some() && !linuxcnc { go(&[on.no_check]) } else { checked };
        let upto = if wanted.is_some() && linuxcnc { way.steps.len() } else { usize::MAX };
        failures.extend(difference(&ran.steps, &way.steps, upto));
    }
    failures
}

/// The first place where two paths differ; moves too short for the figures are left out.
pub fn difference(made: &[Step], wanted: &[Step], upto: usize) -> Option<String> {
    let (made, wanted) = (without_nothing(made), without_nothing(wanted));
    for (index, (made, wanted)) in made.iter().zip(&wanted).take(upto).enumerate() {
        if !agrees(made, wanted) {
            return Some(format!("step {index}: made {made:?}, wanted {wanted:?}"));
        }
    }
    let (made_count, wanted_count) = (made.len(), wanted.len());
    let ends = upto != usize::MAX || made_count == wanted_count;
    (!ends || made_count < wanted_count.min(upto))
        .then(|| format!("{made_count} moves made, {wanted_count} wanted: {made:?}"))
}

fn without_nothing(steps: &[Step]) -> Vec<Step> {
    let mut at = [f64::NAN; 2];
    let mut kept = Vec::new();
    for step in steps {
        let short = (step.to[0] - at[0]).hypot(step.to[1] - at[1]) < 3e-4;
        at = step.to;
        if !short || step.arc.is_some_and(|(center, _)| far(center, step.to)) {
            kept.push(*step);
        }
    }
    kept
}

fn far(center: [f64; 2], to: [f64; 2]) -> bool {
    (center[0] - to[0]).hypot(center[1] - to[1]) > 1e-3
}

/// Points to a ten-thousandth, sweeps to a hundredth of a degree.
fn agrees(made: &Step, wanted: &Step) -> bool {
    let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) <= 1.5e-4;
    near(made.to, wanted.to)
        && match (made.arc, wanted.arc) {
            (None, None) => true,
            (Some((center, Sweep::Degrees(made))), Some((other, sweep))) => {
                near(center, other)
                    && match sweep {
                        Sweep::Degrees(wanted) => (made - wanted).abs() <= 0.011,
                        Sweep::Clockwise => made < 0.0,
                        Sweep::Counterclockwise => made > 0.0,
                    }
            }
            _ => false,
        }
}
