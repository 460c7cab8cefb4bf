//! In which order a block is carried out, whatever the order of its words: pairs of codes, on each control that has them,
//! from the controls' manuals.

use chordal::control::{CompensationSide, FeedMode, SpindleState};
use chordal::geometry::Plane;
use chordal::{Command, CommandKind, Diagnostic, Job, Machine, RunSink, Sink, Source, SourceMap};

/// "Order of execution" in the G-code overview of the LinuxCNC documentation, 2.9: feed mode, F, S, T, outputs, tool change,
/// spindle, saved modes, coolant, overrides, own codes, dwell, plane, units, compensation, length, work offset, path mode,
/// distance, return level, reference points and offsets, motion, stop.
const LINUXCNC: &str = "LinuxCNC 2.9, G-code overview, order of execution";
/// The interpreter that Mach3 is written after has the table "Order of execution" (RS274/NGC version 3, section 3.8).
const MACH3: &str =
    "RS274/NGC version 3, table 8 (section 3.8); Mach3Mill manual, order of execution";
/// The comment and the steps of `gc_execute_line`: feed mode, F, S, T, spindle, coolant, dwell, plane, units (of the whole
/// block, F included), length, work offset, distance, G10, G28 and G92, motion, stop.
const GRBL: &str = "grbl/gcode.c, version 1.1h, steps of the execution of a line";
/// Builders choose which M codes act before and which after the motion; these are the usual ones.
const SHOP: &str =
    "usual; M codes beside a motion act as the builder of the machine chooses (B-63844EN 12.1)";
/// How the parts of a cycle block, of a plane and of a mode act together is in every manual.
const ALL: &str = "manuals of all of them: modes of a block are those of its motion";

const LINUX: &[&str] = &["linuxcnc-mill"];
const MACH: &[&str] = &["mach3-mill"];
const GRBLS: &[&str] = &["grbl", "grblhal", "fluidnc"];
const SHOPS: &[&str] = &["fanuc-0i", "haas-vf2", "mitsubishi-m700", "fadal-4020"];
/// Those with a tool changer and tool offsets.
const WITH_G43: &[&str] =
    &["fanuc-0i", "haas-vf2", "mitsubishi-m700", "fadal-4020", "linuxcnc-mill", "mach3-mill"];
const EVERY: &[&str] = &[
    "fanuc-0i",
    "haas-vf2",
    "mitsubishi-m700",
    "fadal-4020",
    "linuxcnc-mill",
    "mach3-mill",
    "grbl",
    "grblhal",
    "fluidnc",
];

/// What a block does on some controls.
struct Case {
    pair: &'static str,
    /// Lines before the block, after `HEAD`.
    before: &'static str,
    /// The block, in each order of its words that is tried.
    blocks: &'static [&'static str],
    /// Controls, what happens, and who says so.
    expected: &'static [(&'static [&'static str], &'static str, &'static str)],
}

/// The tool is at X5 Y0 Z10 of the first work offset, in millimetres, and turns.
const HEAD: &str = "G21 G17 G90\nS900 M3\nG0 X5. Y0. Z10.\nF200.\n";

const CASES: &[Case] = &[
    Case {
        pair: "M3 and motion",
        before: "M5\nS0\n",
        blocks: &["G1 X10. S1000 M3", "M3 S1000 G1 X10."],
        expected: &[(
            EVERY,
            "spindle cw 1000 | cut X10 at 200",
            "LinuxCNC, GRBL and RS274/NGC: spindle before motion; M3 of Fanuc and others: before, usual",
        )],
    },
    Case {
        pair: "M4 and motion",
        before: "M5\nS0\n",
        blocks: &["G1 X10. S1000 M4"],
        expected: &[(EVERY, "spindle ccw 1000 | cut X10 at 200", "as M3")],
    },
    Case {
        pair: "M5 and motion",
        before: "",
        blocks: &["G1 X10. M5", "M5 G1 X10."],
        expected: &[
            (LINUX, "spindle off | cut X10 at 200", LINUXCNC),
            (MACH, "spindle off | cut X10 at 200", MACH3),
            (GRBLS, "spindle off | cut X10 at 200", GRBL),
            (SHOPS, "cut X10 at 200 | spindle off", SHOP),
        ],
    },
    Case {
        pair: "M8 and motion",
        before: "",
        blocks: &["G1 X10. M8"],
        expected: &[(EVERY, "coolant on | cut X10 at 200", "as M3")],
    },
    Case {
        pair: "M9 and motion",
        before: "M8\n",
        blocks: &["G1 X10. M9", "M9 G1 X10."],
        expected: &[
            (LINUX, "coolant off | cut X10 at 200", LINUXCNC),
            (MACH, "coolant off | cut X10 at 200", MACH3),
            (GRBLS, "coolant off | cut X10 at 200", GRBL),
            (SHOPS, "cut X10 at 200 | coolant off", SHOP),
        ],
    },
    Case {
        pair: "M5 and M9",
        before: "M8\n",
        blocks: &["M9 M5", "M5 M9"],
        expected: &[
            (LINUX, "spindle off | coolant off", LINUXCNC),
            (MACH, "spindle off | coolant off", MACH3),
            (GRBLS, "spindle off | coolant off", GRBL),
        ],
    },
    Case {
        pair: "M3 and M8",
        before: "M5\nS0\n",
        blocks: &["M8 M3 S1000", "M3 M8 S1000"],
        expected: &[
            (LINUX, "spindle cw 1000 | coolant on", LINUXCNC),
            (MACH, "spindle cw 1000 | coolant on", MACH3),
            (GRBLS, "spindle cw 1000 | coolant on", GRBL),
        ],
    },
    Case {
        pair: "M0 and motion",
        before: "",
        blocks: &["G1 X10. M0", "M0 G1 X10."],
        expected: &[(EVERY, "cut X10 at 200 | stop", "all: a stop is the last of its block")],
    },
    Case {
        pair: "M1 and motion",
        before: "",
        blocks: &["M1 G1 X10."],
        expected: &[(
            WITH_G43,
            "cut X10 at 200 | optional stop",
            "all: a stop is the last of its block",
        )],
    },
    Case {
        pair: "M30 and motion",
        before: "",
        blocks: &["M30 G1 X10."],
        expected: &[(
            EVERY,
            "cut X10 at 200 | spindle off | end",
            "all: the end is the last of its block",
        )],
    },
    Case {
        pair: "M0 and M5",
        before: "",
        blocks: &["M0 M5", "M5 M0"],
        expected: &[
            (LINUX, "spindle off | stop", LINUXCNC),
            (MACH, "spindle off | stop", MACH3),
            (GRBLS, "spindle off | stop", GRBL),
        ],
    },
    Case {
        pair: "G4 and motion",
        before: "G1\n",
        blocks: &["G4 P1 X10.", "X10. G4 P1"],
        expected: &[
            (LINUX, "dwell 1 | cut X10 at 200", LINUXCNC),
            (GRBLS, "dwell 1 | cut X10 at 200", GRBL),
        ],
    },
    Case {
        pair: "G4 and M3",
        before: "M5\nS0\n",
        blocks: &["G4 P1 M3 S1000"],
        expected: &[
            (LINUX, "spindle cw 1000 | dwell 1", LINUXCNC),
            (GRBLS, "spindle cw 1000 | dwell 1", GRBL),
        ],
    },
    Case {
        pair: "G4 and M5",
        before: "",
        blocks: &["G4 P1 M5", "M5 G4 P1"],
        expected: &[
            (LINUX, "spindle off | dwell 1", LINUXCNC),
            (GRBLS, "spindle off | dwell 1", GRBL),
        ],
    },
    Case {
        pair: "T and M6",
        before: "M5\n",
        blocks: &["T2 M6", "M6 T2"],
        expected: &[(WITH_G43, "tool 2", "all: T is chosen before it is changed")],
    },
    Case {
        pair: "M6 and M3",
        before: "M5\nS0\n",
        blocks: &["T2 M6 M3 S1000", "M3 S1000 T2 M6"],
        expected: &[
            (LINUX, "tool 2 | spindle cw 1000", LINUXCNC),
            (MACH, "tool 2 | spindle cw 1000", MACH3),
        ],
    },
    Case {
        pair: "M6 and M8",
        before: "M5\n",
        blocks: &["T2 M6 M8", "M8 T2 M6"],
        expected: &[(LINUX, "tool 2 | coolant on", LINUXCNC), (MACH, "tool 2 | coolant on", MACH3)],
    },
    Case {
        pair: "M6 and motion",
        before: "M5\n",
        blocks: &["G0 X10. T2 M6"],
        expected: &[(LINUX, "tool 2 | rapid X10", LINUXCNC), (MACH, "tool 2 | rapid X10", MACH3)],
    },
    Case {
        pair: "G43 and motion",
        before: "T2 M6\n",
        blocks: &["G0 Z20. G43 H2", "G43 H2 G0 Z20."],
        expected: &[(WITH_G43, "length 2 | rapid X5", ALL)],
    },
    Case {
        pair: "G49 and motion",
        before: "T2 M6\nG43 H2 Z30.\n",
        blocks: &["G0 X10. G49"],
        expected: &[(WITH_G43, "length off | rapid X10", ALL)],
    },
    Case {
        pair: "G55 and motion",
        before: "",
        blocks: &["G0 X10. G55", "G55 G0 X10."],
        expected: &[(EVERY, "offset | rapid X10", ALL)],
    },
    Case {
        pair: "G91 and motion",
        before: "",
        blocks: &["G91 G1 X10.", "G1 G91 X10."],
        expected: &[(EVERY, "cut X15 at 200", ALL)],
    },
    Case {
        pair: "motion and G91 after it",
        before: "",
        blocks: &["G1 X10. G91"],
        expected: &[
            (&["fanuc-0i", "haas-vf2", "mitsubishi-m700"], "cut X15 at 200", ALL),
            (LINUX, "cut X15 at 200", LINUXCNC),
            (MACH, "cut X15 at 200", MACH3),
            (GRBLS, "cut X15 at 200", GRBL),
            (
                &["fadal-4020"],
                "cut X10 at 200",
                "Fadal manual 13: G90 and G91 act from left to right",
            ),
        ],
    },
    Case {
        pair: "G20 and motion",
        before: "",
        blocks: &["G20 G1 X1.", "G1 X1. G20"],
        expected: &[
            (LINUX, "cut X25.4 at 200", LINUXCNC),
            (MACH, "cut X25.4 at 200", MACH3),
            (GRBLS, "cut X25.4 at 200", GRBL),
        ],
    },
    Case {
        pair: "G20 and F, G21 before",
        before: "",
        blocks: &["G20 F10 G1 X1.", "G1 X1. F10 G20"],
        expected: &[
            // F is millimetres a minute still.
            (LINUX, "cut X25.4 at 10", LINUXCNC),
            (MACH, "cut X25.4 at 10", MACH3),
            (GRBLS, "cut X25.4 at 254", GRBL),
        ],
    },
    Case {
        pair: "G21 and F, G20 before",
        before: "G20\n",
        blocks: &["G21 F300 G1 X20.", "G1 X20. F300 G21"],
        expected: &[
            // 300 inches a minute.
            (LINUX, "cut X20 at 7620", LINUXCNC),
            (MACH, "cut X20 at 7620", MACH3),
            (GRBLS, "cut X20 at 300", GRBL),
        ],
    },
    Case {
        pair: "F and motion",
        before: "",
        blocks: &["G1 X10. F300.", "F300. G1 X10."],
        expected: &[(EVERY, "cut X10 at 300", ALL)],
    },
    Case {
        pair: "G93 and F",
        before: "",
        blocks: &["G93 G1 X10. F2.", "G1 X10. F2. G93"],
        expected: &[(EVERY, "cut X10 at 1/T 2", ALL)],
    },
    Case {
        pair: "S and motion",
        before: "",
        blocks: &["G1 X10. S1200"],
        expected: &[(EVERY, "spindle cw 1200 | cut X10 at 200", "as M3")],
    },
    Case {
        pair: "G41 and motion",
        before: "T2 M6\n",
        blocks: &["G1 X10. G41 D2", "G41 D2 G1 X10."],
        expected: &[(WITH_G43, "compensation | cut X10 at 200", ALL)],
    },
    Case {
        pair: "G40 and motion",
        before: "T2 M6\nG41 D2 G1 X20.\nX40.\n",
        blocks: &["G1 X60. G40"],
        expected: &[(WITH_G43, "compensation off | cut X60 at 200", ALL)],
    },
    Case {
        pair: "G18 and an arc",
        before: "",
        blocks: &["G2 X25. I10. G18", "G18 G2 X25. I10."],
        expected: &[(EVERY, "arc ZX X25 at 200", ALL)],
    },
    Case {
        pair: "G99 and a cycle",
        before: "",
        blocks: &["G81 X10. Z-5. R2. G99 F100.", "G99 G81 X10. Z-5. R2. F100."],
        expected: &[(
            &["fanuc-0i", "haas-vf2", "mitsubishi-m700", "linuxcnc-mill", "mach3-mill", "grblhal"],
            "hole to Z2",
            ALL,
        )],
    },
    Case {
        pair: "G98 and a cycle",
        before: "G99\n",
        blocks: &["G81 X10. Z-5. R2. G98 F100."],
        expected: &[(
            &["fanuc-0i", "haas-vf2", "mitsubishi-m700", "linuxcnc-mill", "mach3-mill", "grblhal"],
            "hole to Z10",
            ALL,
        )],
    },
    Case {
        pair: "G53 and G0",
        before: "",
        blocks: &["G53 G0 X0", "G0 G53 X0"],
        expected: &[(EVERY, "rapid X0", ALL)],
    },
    Case {
        pair: "G28 and G91",
        before: "",
        blocks: &["G91 G28 Z0", "G28 G91 Z0"],
        expected: &[
            (&["fanuc-0i", "haas-vf2", "mitsubishi-m700"], "rapid X5", ALL),
            (LINUX, "rapid X5", LINUXCNC),
            (MACH, "rapid X5", MACH3),
        ],
    },
    Case {
        pair: "G92 and G55",
        before: "",
        blocks: &["G92 X0 G55", "G55 G92 X0"],
        expected: &[
            // The tool is at X5 of G55, and G92 calls it zero: zero of G55, and then the preset.
            (LINUX, "offset | offset", LINUXCNC),
            (MACH, "offset | offset", MACH3),
            (GRBLS, "offset | offset", GRBL),
        ],
    },
    Case {
        pair: "G10 and G55",
        before: "",
        blocks: &["G55 G10 L2 P2 X1."],
        expected: &[(LINUX, "offset | offset", LINUXCNC), (GRBLS, "offset | offset", GRBL)],
    },
    Case {
        pair: "G64 and motion",
        before: "",
        blocks: &["G1 X10. G61"],
        expected: &[(
            &["fanuc-0i", "mitsubishi-m700", "haas-vf2", "linuxcnc-mill", "mach3-mill"],
            "path | cut X10 at 200",
            ALL,
        )],
    },
    Case {
        pair: "M49 and motion",
        before: "",
        blocks: &["G1 X10. M49"],
        expected: &[
            (LINUX, "overrides | cut X10 at 200", LINUXCNC),
            (MACH, "overrides | cut X10 at 200", MACH3),
        ],
    },
    Case {
        pair: "a message and motion",
        before: "",
        blocks: &["G1 X10. (MSG, HELLO)", "(MSG, HELLO) G1 X10."],
        expected: &[(LINUX, "message | cut X10 at 200", LINUXCNC)],
    },
    Case {
        pair: "M98 and motion",
        before: "",
        blocks: &["G1 X10. M98 P7", "M98 P7 G1 X10."],
        expected: &[(
            &["fanuc-0i", "mitsubishi-m700", "haas-vf2"],
            "cut X10 at 200",
            "Fanuc B-63844EN 13.3: the move of the block, then the call",
        )],
    },
    Case {
        pair: "G80 and motion",
        before: "G81 X10. Z-5. R2. F200.\n",
        blocks: &["G80 G0 X20.", "G0 X20. G80"],
        expected: &[(
            &["fanuc-0i", "haas-vf2", "mitsubishi-m700", "linuxcnc-mill"],
            "rapid X20",
            ALL,
        )],
    },
];

/// What happens in the block on a line.
struct Events {
    line: u32,
    said: Vec<String>,
    /// How high the tool is.
    z: f64,
    in_cycle: bool,
}

impl Events {
    fn motion(&mut self, kind: &CommandKind, in_cycle: bool) {
        let Some(motion) = kind.motion() else { return };
        self.z = motion.to[2];
        if in_cycle {
            self.in_cycle = true;
            return;
        }
        let x = motion.to[0];
        let feed = kind.feed().map(|feed| match feed.mode {
            FeedMode::InverseTime => format!(" at 1/T {}", rounded(feed.value * 60.0)),
            _ => format!(" at {}", rounded(feed.value * 60.0)),
        });
        let word = match kind {
            CommandKind::Rapid { .. } => "rapid".to_string(),
            CommandKind::Arc { shape, .. } => format!("arc {}", plane(shape.plane)),
            _ => "cut".to_string(),
        };
        self.said.push(format!("{word} X{}{}", rounded(x), feed.unwrap_or_default()));
    }
}

fn plane(plane: Plane) -> &'static str {
    match plane {
        Plane::Xy => "XY",
        Plane::Zx => "ZX",
        Plane::Yz => "YZ",
    }
}

fn rounded(value: f64) -> f64 {
    (value * 1e4).round() / 1e4 + 0.0
}

impl Sink for Events {
    fn command(&mut self, command: &Command) {
        if command.origin.line != self.line {
            return;
        }
        let said = match &command.kind {
            CommandKind::Spindle { state, rpm } => match state {
                SpindleState::Cw => format!("spindle cw {rpm}"),
                SpindleState::Ccw => format!("spindle ccw {rpm}"),
                SpindleState::Off => "spindle off".into(),
                SpindleState::Oriented => "spindle oriented".into(),
            },
            CommandKind::Coolant(coolant) => {
                let on = coolant.flood || coolant.mist || coolant.through_tool;
                if on { "coolant on".into() } else { "coolant off".into() }
            }
            CommandKind::Tool { number } => format!("tool {number}"),
            CommandKind::ToolLength { number: Some(number), .. } => format!("length {number}"),
            CommandKind::ToolLength { number: None, .. } => "length off".into(),
            CommandKind::WorkOffset { .. } => "offset".into(),
            CommandKind::Compensation { side, .. } => match side {
                CompensationSide::Off => "compensation off".into(),
                _ => "compensation".into(),
            },
            CommandKind::Dwell { seconds, .. } => format!("dwell {}", rounded(*seconds)),
            CommandKind::Stop { optional: false } => "stop".into(),
            CommandKind::Stop { optional: true } => "optional stop".into(),
            CommandKind::End => "end".into(),
            CommandKind::Message(_) => "message".into(),
            CommandKind::PathMode(_) => "path".into(),
            CommandKind::Overrides(_) => "overrides".into(),
            kind => return self.motion(kind, command.origin.cycle),
        };
        self.said.push(said);
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for Events {}

fn events(machine: &str, before: &str, block: &str) -> String {
    let text = format!("{HEAD}{before}{block}\nM30\nO7\nM99\n");
    events_of(machine, &text, 1 + HEAD.lines().count() as u32 + before.lines().count() as u32)
}

fn events_of(machine: &str, text: &str, line: u32) -> String {
    let mut sources = SourceMap::new();
    sources.add(Source::new("t.nc", text.as_bytes()));
    let job = Job::new(sources, Machine::from_builtin(machine).expect("a machine")).expect("a job");
    let mut events = Events { line, said: Vec::new(), z: 0.0, in_cycle: false };
    job.run(&mut events);
    if events.in_cycle {
        events.said.push(format!("hole to Z{}", rounded(events.z)));
    }
    events.said.join(" | ")
}

/// Before the program has said its units, those of power-on are a guess, and F is read with those of its block.
#[test]
fn units_of_power_on_change_no_feed() {
    for (machine, block, right) in [
        ("linuxcnc-mill", "G20 F10 G1 X1.", "cut X25.4 at 254"),
        ("mach3-mill", "G20 F10 G1 X1.", "cut X25.4 at 254"),
    ] {
        let text = format!("M3 S900\nG0 X0 Y0\n{block}\nM30\n");
        assert_eq!(events_of(machine, &text, 3), right, "{machine}");
    }
    // What it has said holds after the end of a subprogram, too, and nothing changes where they are the same.
    let same = "G21 M3 S900\nG0 X0 Y0\nG21 F10 G1 X1.\nM30\n";
    assert_eq!(events_of("linuxcnc-mill", same, 3), "cut X1 at 10");
}

#[test]
fn pairs_of_codes_in_a_block_act_in_the_order_of_the_manuals() {
    let (mut count, mut wrong) = (0, Vec::new());
    for case in CASES {
        for block in case.blocks {
            for (machines, expected, source) in case.expected {
                for machine in *machines {
                    count += 1;
                    let found = events(machine, case.before, block);
                    if found != *expected {
                        wrong.push(format!(
                            "{}: {machine} {block}: {found}; right {expected} ({source})",
                            case.pair
                        ));
                    }
                }
            }
        }
    }
    println!("{} pairs, {count} blocks, {} deviate", CASES.len(), wrong.len());
    assert!(wrong.is_empty(), "{} of {count}:\n{}", wrong.len(), wrong.join("\n"));
}
