//! Programs of five-axis machines that begin at one of their lines, in tilted planes and under tool centre point control.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use chordal::motion::{MotionOptions, MotionStep};
use chordal::{Job, Machine, Source, SourceMap};
use chordal_rewrite::restart::{RefusalReason, restart};

/// The least number of lines of the frozen programs at which they can begin.
const PROVED: usize = 1682;

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/five-axes").join(name)
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).expect("a file")
}

fn job_on(text: &str, machine: &str) -> Job<'static> {
    let others = |name: &str| {
        std::fs::read_to_string(folder("machines").join(name)).map_err(|e| e.to_string())
    };
    let machine = Machine::from_toml("five.toml", machine, &others).expect("a machine");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    Job::new(sources, machine).expect("good settings")
}

/// The job of a frozen program.
fn job_of(text: &str) -> Job<'static> {
    let (_, after) = text.split_once("machine: ").expect("the machine of a program");
    let name = after.split(['\n', ')']).next().expect("a name").trim();
    job_on(text, &read(&folder("machines").join(format!("{name}.toml"))))
}

#[test]
fn every_line_is_proved_or_refused_with_a_reason() {
    let mut reasons = BTreeMap::<String, u32>::new();
    let (mut proved, mut lines) = (0, 0);
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder("right"))
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|ending| ending != "mpf"))
        .collect();
    paths.sort();
    for path in &paths {
        let text = read(path);
        let job = job_of(&text);
        let (mut own, mut all) = (0, 0);
        for line in 1..=text.lines().count() as u32 {
            match restart(&job, line) {
                Ok(done) => {
                    own += 1;
                    all += 1;
                    let from: Vec<&str> = text.lines().skip(line as usize - 1).collect();
                    let rest = from.join("\n");
                    let new = String::from_utf8(done.text).expect("text");
                    assert!(new.trim_end().ends_with(rest.trim()), "{}:{line}", path.display());
                }
                Err(refused) => {
                    let why = &refused.refusal;
                    assert!(!why.what.is_empty() && !why.help.is_empty());
                    if !matches!(refused.reason, RefusalReason::NoBlock | RefusalReason::Beginning)
                    {
                        all += 1;
                        let what = why.what.split(": ").last().unwrap_or("");
                        *reasons.entry(format!("{:?} {what}", refused.reason)).or_default() += 1;
                    }
                }
            }
        }
        println!("{}: {own} of {all}", path.file_stem().unwrap_or_default().to_string_lossy());
        proved += own;
        lines += all;
    }
    println!("{} programs, {proved} of {lines} lines", paths.len());
    reasons.iter().for_each(|(what, count)| println!("  {count} {what}"));
    assert!(proved >= PROVED, "{proved}");
}

/// A trunnion with tables A and C; the tool stands along Z of the machine whatever they do.
const TRUNNION: &str = "inherits = 'fanuc-ac-trunnion'
[rotary.A]
point = { Y = '-200 mm', Z = '-400 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
[work_offsets.G54]
X = '-300 mm'
Y = '-250 mm'
Z = '-380 mm'
[tools.1]
length = '100 mm'
diameter = '6 mm'
";

const SURFACE: &str = "\
%
O1
G21 G90 G17 G94 G40 G49 G80
T1 M6
S9000 M3
G54 G0 X0 Y0 A10. C135.
G43.4 H1 X0. Y0. Z40.
M8
G1 X0 Y0 Z10. F3000.
X5. Y1. A12. C130.
X10. Y2. Z8.5 A14. C120.
X15. Y2. A20. C100.
X20. Y2. A24. C90.
G0 Z60.
G49
M30
%
";

#[test]
fn the_tip_comes_back_along_the_tool() {
    let job = job_on(SURFACE, TRUNNION);
    let done = restart(&job, 12).expect("proved");
    // By hand: the tool leans by 14 degrees toward (sin 120, -cos 120), so that 31.5 mm above Z8.5 are 7.854 mm away; 16.802 and
    // -44.073 from C turn by -120 degrees to -46.569 and 7.486, and 7.486 and 60 from A by -14 degrees to 21.779.
    assert_eq!(
        done.head,
        [
            "G21 G17 G90 G40 G49 G80 G94",
            "T1 M6",
            "G0 G54 X-46.569 Y71.779 A14. C120. S9000 M3",
            "G43.4 H1 X16.802 Y5.927 Z40.",
            "M8",
            "G1 X10. Y2. Z8.5 F3000.",
            "G1",
        ]
    );
    let first = 1 + done.text[..done.head_bytes.start as usize]
        .iter()
        .filter(|byte| **byte == b'\n')
        .count() as u32;
    let (mut cuts, mut way_mm) = (0, 0.0);
    let new = job_on(&String::from_utf8(done.text).expect("text"), TRUNNION);
    let take = |step: &MotionStep, source: &chordal::motion::StepSource| {
        let in_head = (first..first + done.head.len() as u32).contains(&source.origin.line);
        if let (MotionStep::Move(motion), true) = (step, in_head) {
            let (from, to) = (motion.from(), motion.to());
            // On a trunnion the tool stands along Z of the machine.
            if motion.rotary_from == motion.rotary_to && from[2] != to[2] && motion.speed < 51.0 {
                cuts += 1;
                way_mm = from[2] - to[2];
                assert!((from[0] - to[0]).abs() < 2e-3 && (from[1] - to[1]).abs() < 2e-3);
            }
        }
        Ok(())
    };
    drop(new.motion(&MotionOptions::default(), take).expect("limits"));
    // From Z40 to Z8.5 along a tool that leans by 14 degrees.
    assert_eq!(cuts, 1);
    assert!((way_mm - 31.5 / 14_f64.to_radians().cos()).abs() < 2e-3, "{way_mm}");
}

#[test]
fn a_tilted_plane_is_said_again() {
    let text = SURFACE.replace(
        "G43.4 H1 X0. Y0. Z40.",
        "G68.2 X0 Y0 Z0 I30. J20. K0.\nG53.1\nG43 H1 X0. Y0. Z40.",
    );
    let text: String = text
        .lines()
        .filter(|line| !line.contains("A1") || line.contains("G54"))
        .map(|line| format!("{line}\n"))
        .collect();
    let text = text
        .replace("X15. Y2. A20. C100.\n", "X15. Y2.\n")
        .replace(" A24. C90.", "")
        .replace("G49\nM30", "G69\nG49\nM30");
    let job = job_on(&text, TRUNNION);
    let line = text.lines().position(|line| line == "X20. Y2.").expect("a line") as u32 + 1;
    let done = restart(&job, line).expect("proved");
    assert!(done.head.iter().any(|line| line.starts_with("G68.2 X0 Y0 Z0 I30. J20. K0.")));
    assert!(done.head.contains(&"G53.1".to_string()));
}
