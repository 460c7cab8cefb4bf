//! Canned cycles in every plane with both returns: the steps of each cycle are written down
//! here once, from the manuals, and the planes and returns are put in.
//!
//! The hole: initial level 20, R 2, bottom -5, pecks of 3, a dwell of 0.1 s, a shift of 0.5.

use chordal::control::{CommandKind, SpindleState};
use chordal::{Job, Machine, Severity, Source, SourceMap};

/// A cycle: its code, its words other than position, depth and R, and its steps.
///
/// `@` goes to the place; `r` and `f` go to a level (`I`, `R`, `Z`, `c` for the level of the
/// return, or a number) at rapid and at feed; `D` waits; `off`, `cw`, `ccw`, `oriented` are of
/// the spindle, `stop` is a program stop; `+` steps aside, `f+` does so at the feed, `-` steps
/// back. In the words `{a}`, `{b}`, `{n}` are the letters of I, J and K along the plane's axes
/// and its normal.
struct Cycle {
    code: &'static str,
    words: &'static str,
    steps: &'static str,
}

const fn cycle(code: &'static str, words: &'static str, steps: &'static str) -> Cycle {
    Cycle { code, words, steps }
}

/// A control and how its machine is set up for the cells of the table.
struct Table {
    machine: &'static str,
    set: &'static [&'static str],
    /// Drills along Z in every plane.
    always_z: bool,
    /// Q shifts along the second axis of the plane.
    second: bool,
    /// What stands before the R level's number.
    r: &'static str,
    cycles: &'static [Cycle],
}

const FANUC: Table = Table {
    machine: "fanuc-30i",
    set: &[
        "settings.\"No. 5101#0\"=1",
        "settings.\"No. 5114\"=\"1 mm\"",
        "settings.\"No. 5115\"=\"1 mm\"",
    ],
    always_z: false,
    second: false,
    r: "R",
    cycles: &[
        cycle("G73", "Q3.", "@ rR f-1 r0 f-4 r-3 fZ rc"),
        cycle("G74", "P100", "@ rR fZ off D cw fR off ccw rc"),
        cycle("G76", "Q.5 P100", "@ rR fZ D oriented + rc - cw"),
        cycle("G81", "", "@ rR fZ rc"),
        cycle("G82", "P100", "@ rR fZ D rc"),
        cycle("G83", "Q3.", "@ rR f-1 rR r0 f-4 rR r-3 fZ rc"),
        cycle("G84", "P100", "@ rR fZ off D ccw fR off cw rc"),
        cycle("G85", "", "@ rR fZ fR rc"),
        cycle("G86", "", "@ rR fZ off rc cw"),
        cycle("G87", "Q.5 P100", "@ oriented + r-10 - cw fZ D oriented + rI - cw"),
        cycle("G88", "P100", "@ rR fZ D off stop rc cw"),
        cycle("G89", "P100", "@ rR fZ D fR rc"),
    ],
};

const MITSUBISHI: Table = Table {
    machine: "mitsubishi-m700",
    set: &[
        "settings.\"#1080 Dril_Z\"=0",
        "settings.\"#8012\"=\"1 mm\"",
        "settings.\"#8013\"=\"1 mm\"",
    ],
    always_z: false,
    second: false,
    r: "R",
    cycles: &[
        cycle("G73", "Q3. P100", "@ rR f-1 D r0 f-4 D r-3 fZ D rc"),
        cycle("G74", "P100", "@ rR fZ off D cw fR off ccw rc"),
        cycle("G76", "{a}.5 {b}0. P100", "@ rR fZ D oriented f+ rc - cw"),
        cycle("G81", "", "@ rR fZ rc"),
        cycle("G82", "P100", "@ rR fZ D rc"),
        cycle("G83", "Q3.", "@ rR f-1 rR r0 f-4 rR r-3 fZ rc"),
        cycle("G84", "P100", "@ rR fZ off D ccw fR off cw rc"),
        cycle("G85", "", "@ rR fZ fR rc"),
        cycle("G86", "P100", "@ rR fZ D off rc cw"),
        cycle("G87", "{a}.5 {b}0. P100", "@ oriented + r-10 - cw fZ D oriented + rI - cw"),
        cycle("G88", "P100", "@ rR fZ D off stop rc cw"),
        cycle("G89", "P100", "@ rR fZ D fR rc"),
    ],
};

const LINUXCNC: Table = Table {
    machine: "linuxcnc-mill",
    set: &[],
    always_z: false,
    second: false,
    r: "R",
    cycles: &[
        cycle("G73", "Q3.", "@ rR f-1 r-.746 f-4 r-3.746 fZ rc"),
        cycle("G74", "P.1", "@ rR fZ off cw D fc off ccw"),
        cycle("G81", "", "@ rR fZ rc"),
        cycle("G82", "P.1", "@ rR fZ D rc"),
        cycle("G83", "Q3.", "@ rR f-1 rR r-.746 f-4 rR r-3.746 fZ rc"),
        cycle("G84", "P.1", "@ rR fZ off ccw D fc off cw"),
        cycle("G85", "", "@ rR fZ fR rc"),
        cycle("G86", "P.1", "@ rR fZ D off rc cw"),
        cycle(
            "G87",
            "{a}.5 {b}0. {n}-2.",
            "@ rR + off oriented rZ - cw f-2 fZ off oriented + rc - cw",
        ),
        cycle("G88", "P.1", "@ rR fZ D off stop rc cw"),
        cycle("G89", "P.1", "@ rR fZ D fc"),
    ],
};

const HAAS: Table = Table {
    machine: "haas-vf2",
    set: &["settings.\"Setting 22\"=\"1 mm\""],
    always_z: true,
    second: false,
    r: "R",
    cycles: &[
        cycle("G73", "Q3. P100", "@ rR f-1 r0 f-4 r-3 fZ D rc"),
        cycle("G74", "", "@ rR fZ off cw fR off ccw rc"),
        cycle("G76", "Q.5 P.1", "@ rR fZ D oriented + rc - cw"),
        cycle("G77", "Q.5 P100", "@ oriented + r-10 - cw fZ D oriented + rI - cw"),
        cycle("G81", "", "@ rR fZ rc"),
        cycle("G82", "P.1", "@ rR fZ D rc"),
        cycle("G83", "Q3. P100", "@ rR f-1 rR r0 f-4 rR r-3 fZ D rc"),
        cycle("G84", "", "@ rR fZ off ccw fR off cw rc"),
        cycle("G85", "", "@ rR fZ fR rc"),
        cycle("G86", "", "@ rR fZ off rc cw"),
        cycle("G88", "P100", "@ rR fZ D off stop rc cw"),
        cycle("G89", "P100", "@ rR fZ D fR rc"),
    ],
};

const FADAL: Table = Table {
    machine: "fadal-4020",
    set: &[],
    always_z: true,
    second: true,
    r: "R0+",
    cycles: &[
        cycle("G73", "Q3. P1.", "@ rR f-1 r0 f-4 r-3 fZ rc"),
        cycle("G74", "Q1.5", "@ rR fZ off cw fR off ccw rc"),
        cycle("G74.1", "Q1.5", "@ rR fZ off cw fR off ccw rc"),
        cycle("G75", "Q1.5", "@ rR fZ fR rc"),
        cycle("G76", "Q.5 P100", "@ rR fZ D oriented + rc - cw"),
        cycle("G81", "", "@ rR fZ rc"),
        cycle("G82", "P100", "@ rR fZ D rc"),
        // The clearance where nothing else says it: .05 in.
        cycle("G83", "Q3.", "@ rR f-1 rR r.27 f-4 rR r-2.73 fZ rc"),
        cycle("G84", "Q1.5", "@ rR fZ off ccw fR off cw rc"),
        cycle("G84.1", "Q1.5", "@ rR fZ off ccw fR off cw rc"),
        cycle("G85", "", "@ rR fZ fR rc"),
        cycle("G86", "", "@ rR fZ off rc cw"),
        cycle("G87", "", "@ rR fZ fR rc"),
        cycle("G88", "", "@ rR fZ fR rc"),
        cycle("G89", "P100", "@ rR fZ D fR rc"),
    ],
};

const INITIAL: f64 = 20.0;
const DEPTH: f64 = -5.0;
const PLACE: [f64; 2] = [10.0, 4.0];

/// A plane's code, its two axes in their order, and its normal.
const PLANES: [(&str, [usize; 3]); 3] =
    [("G17", [0, 1, 2]), ("G18", [2, 0, 1]), ("G19", [1, 2, 0])];

/// A hole somewhere: which axes are across and along it, and where the tool goes after it.
struct Cell {
    axes: [usize; 3],
    to_r: bool,
    r: f64,
    second: bool,
}

impl Cell {
    fn level(&self, text: &str) -> f64 {
        match text {
            "I" => INITIAL,
            "R" => self.r,
            "Z" => DEPTH,
            "c" if self.to_r => self.r,
            "c" => INITIAL,
            number => number.parse().expect("a level is a letter or a number"),
        }
    }

    /// The steps in the words of `happened`; a way that leads nowhere is no step.
    fn expand(&self, steps: &str) -> Vec<String> {
        let mut at = [0.0; 3];
        at[self.axes[2]] = INITIAL;
        let mut done = Vec::new();
        for step in steps.split(' ') {
            let before = at;
            let (how, target) = step.split_at(usize::from(step.starts_with(['r', 'f'])));
            match (how, target) {
                ("", "@") => {
                    at[self.axes[0]] = PLACE[0];
                    at[self.axes[1]] = PLACE[1];
                }
                ("" | "f", "+") => at[self.axes[usize::from(self.second)]] += 0.5,
                ("", "-") => at[self.axes[usize::from(self.second)]] -= 0.5,
                ("r" | "f", level) => at[self.axes[2]] = self.level(level),
                (_, "D") => done.push("dwell 0.1".to_string()),
                (_, event) => done.push(event.to_string()),
            }
            if at != before {
                done.push(way(if how == "f" { "line" } else { "rapid" }, at));
            }
        }
        done
    }
}

fn way(kind: &str, at: [f64; 3]) -> String {
    let number = |value: f64| (value * 1e6).round() / 1e6 + 0.0;
    format!("{kind} {} {} {}", number(at[0]), number(at[1]), number(at[2]))
}

/// What the last block but one of a program does, and the warnings and errors of all.
fn happened(table: &Table, text: &str) -> (Vec<String>, Vec<&'static str>) {
    let mut machine = Machine::from_builtin(table.machine).expect("a built-in machine");
    for assignment in table.set {
        machine.set(assignment).expect("a setting");
    }
    let line = text.lines().count() as u32 - 2;
    let mut sources = SourceMap::new();
    sources.add(Source::new("cycle.nc", text.as_bytes()));
    let job = Job::new(sources, machine).expect("good settings");
    let mut done = Vec::new();
    let report = job.report_of_commands(|command| {
        if command.origin.line != line {
            return;
        }
        let to = |motion: &chordal::control::Move| [motion.to[0], motion.to[1], motion.to[2]];
        done.push(match &command.kind {
            CommandKind::Rapid { motion, .. } => way("rapid", to(motion)),
            CommandKind::Line { motion, .. } => way("line", to(motion)),
            CommandKind::Dwell { seconds, .. } => format!("dwell {seconds}"),
            CommandKind::Stop { .. } => "stop".into(),
            CommandKind::Spindle { state, .. } => match state {
                SpindleState::Off => "off".into(),
                SpindleState::Cw => "cw".into(),
                SpindleState::Ccw => "ccw".into(),
                SpindleState::Oriented => "oriented".into(),
            },
            _ => return,
        });
    });
    let told = report.diagnostics.iter().filter(|told| told.severity > Severity::Note);
    (done, told.map(|told| told.code.info().id).collect())
}

/// A cut of a tap as LinuxCNC 2.9 makes it outside of G17: its coordinates are exchanged.
fn exchange(step: &str, plane: &str) -> String {
    let words: Vec<&str> = step.split(' ').collect();
    match words[..] {
        ["line", x, y, z] if plane == "G18" => format!("line {y} {z} {x}"),
        ["line", x, y, z] => format!("line {z} {x} {y}"),
        _ => step.to_string(),
    }
}

/// Runs every cell of a control's table; gives their number.
fn check(table: &Table) -> usize {
    let (mut cells, mut wrong) = (0, Vec::new());
    for cycle in table.cycles {
        for (plane, axes) in PLANES {
            let axes = if table.always_z { [0, 1, 2] } else { axes };
            for back in ["G98", "G99"] {
                cells += 1;
                // The R of a back bore that is cut upwards lies below the bore.
                let r = if cycle.steps.contains("r-10") { -10.0 } else { 2.0 };
                let cell = Cell { axes, to_r: back == "G99", r, second: table.second };
                let [a, b, n] = axes.map(|axis| b"XYZ"[axis] as char);
                let [i, j, k] = axes.map(|axis| b"IJK"[axis] as char);
                let words = cycle.words.replace("{a}", &i.to_string());
                let words = words.replace("{b}", &j.to_string()).replace("{n}", &k.to_string());
                let turn = if cycle.code.starts_with("G74") { "M4" } else { "M3" };
                let text = format!(
                    "G21 {plane} G90 G94 F100.\nS1000 {turn}\nG0 X0. Y0. Z0.\n{n}{INITIAL}.\n\
                     {back} {} {a}{}. {b}{}. {n}{DEPTH}. {}{r}. {words} F100.\nG80\nM30\n",
                    cycle.code, PLACE[0], PLACE[1], table.r
                );
                let (done, told) = happened(table, &text);
                let doubtful =
                    table.always_z && table.second && ["G87", "G88"].contains(&cycle.code);
                let mut expected = cell.expand(cycle.steps);
                let exchanged = table.machine == "linuxcnc-mill"
                    && plane != "G17"
                    && ["G74", "G84"].contains(&cycle.code);
                if exchanged {
                    expected.iter_mut().for_each(|step| *step = exchange(step, plane));
                }
                let allowed: &[&str] = match (doubtful, exchanged) {
                    (true, _) => &["CH812"],
                    (_, true) => &["CH840"],
                    _ => &[],
                };
                if done != expected || told != allowed {
                    let name = format!("{} {} {plane} {back}", table.machine, cycle.code);
                    wrong.push(format!("{name}\n  made     {done:?}\n  expected {expected:?}\n  told {told:?}\n{text}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {cells} cells:\n{}", wrong.len(), wrong.join("\n"));
    cells
}

#[test]
fn fanuc() {
    assert_eq!(check(&FANUC), 12 * 6);
}

#[test]
fn mitsubishi() {
    assert_eq!(check(&MITSUBISHI), 12 * 6);
}

#[test]
fn linuxcnc() {
    assert_eq!(check(&LINUXCNC), 11 * 6);
}

#[test]
fn haas() {
    assert_eq!(check(&HAAS), 12 * 6);
}

#[test]
fn fadal() {
    assert_eq!(check(&FADAL), 15 * 6);
}

#[test]
fn the_table_is_read_as_it_is_written() {
    let cell = Cell { axes: [2, 0, 1], to_r: true, r: 2.0, second: false };
    let steps = ["rapid 4 20 10", "rapid 4 2 10", "line 4 -5 10", "oriented", "rapid 4 -5 10.5"];
    assert_eq!(cell.expand("@ rR fZ oriented +"), steps);
}
