//! Part programs with what is expected of them on the line; `tests/programs/README.md` has the format.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use chordal::control::{Command, CommandKind, Origin};
use chordal::diagnostics::FileId;
use chordal::machine::{SettingEntry, SettingValue, Tool};
use chordal::path::PathCommand;
use chordal::{Diagnostic, Job, Machine, PathSink, RunOptions, Severity, Source, SourceMap};

/// What a run leaves: the commands of the tool centre, each with its line of the main program.
#[derive(Default)]
struct RunRecord {
    commands: Vec<(u32, Command)>,
    /// With the lines of the problem and of the blocks that called it.
    problems: Vec<(Vec<u32>, Diagnostic)>,
}

/// The commands of the tool centre, before the calls are resolved.
#[derive(Default)]
struct PathRecord {
    commands: Vec<Command>,
    /// The arcs of compensation before the next command of the program.
    corners: Vec<Command>,
}

impl PathSink for PathRecord {
    fn command(&mut self, path: PathCommand<'_>) {
        // G450: the arc of a corner belongs to the block after it (Fundamentals 11/2006, 8.10).
        if path.inserted {
            return self.corners.push(path.command.clone());
        }
        for mut corner in self.corners.drain(..) {
            corner.origin = path.command.origin;
            self.commands.push(corner);
        }
        self.commands.push(path.command.clone());
    }

    fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../chordal-sinumerik/tests/programs")
}

/// The machine of the programs: the first edges of the tools of TOOLS.INI.
fn machine(name: &str) -> Machine {
    let mut machine = Machine::from_builtin(name).expect("a built-in machine");
    let text = fs::read_to_string(folder().join("TOOLS.INI")).expect("the tools");
    let mut tools: BTreeMap<u32, Tool> = BTreeMap::new();
    for line in text.lines().filter(|line| line.starts_with("$TC_")) {
        let (name, rest) = line.split_once('[').expect("an index");
        let (indices, value) = rest.split_once("]=").expect("a value");
        let indices: Vec<u32> =
            indices.split(',').map(|index| index.parse().expect("a number")).collect();
        if indices.get(1).is_some_and(|edge| *edge != 1) {
            continue;
        }
        let tool = tools.entry(indices[0]).or_default();
        let number = || value.parse::<f64>().expect("a number");
        match name {
            "$TC_TP2" => tool.description = Some(value.trim_matches('"').to_string()),
            "$TC_DP3" => tool.offset[2] = Some(number()),
            "$TC_DP6" => tool.diameter_mm = Some(2.0 * number()),
            _ => {}
        }
    }
    if !machine.turns() {
        machine.tools.extend(tools);
    }
    // The programs stand alone: a name that they do not define is none of the control either.
    let setting = SettingEntry { value: SettingValue::Text("alarm".into()), location: None };
    machine.settings.insert("undefined_names".to_string(), setting);
    // The programs are about the control, not about the travel of a machine.
    let travel = (-FAR_MM, FAR_MM);
    machine.axes.iter_mut().flatten().for_each(|axis| axis.travel = Some(travel));
    for name in ["G54", "G55", "G56", "G57", "G505", "G506", "G507", "G599", "G500"] {
        let offset = machine.work_offsets.entry(name.to_string()).or_default();
        offset.values = [Some(0.0), Some(0.0), Some(ZERO_Z_MM), None, None, None];
    }
    machine
}

/// The height of the part's zero below the reference point, so that homes are above the part.
const ZERO_Z_MM: f64 = -500.0;

/// Whether a program is one of the second set.
fn is_second_set(path: &Path) -> bool {
    path.components().any(|part| part.as_os_str() == "second")
}

/// The travel of the axes: less than what a lost decimal point programs.
const FAR_MM: f64 = 10_000.0;

/// The text with a dwell of the value after each line that expects one, and the line of the file for each line. Seconds
/// say what a variable holds.
fn with_values(text: &str) -> (String, Vec<u32>) {
    let (mut out, mut lines) = (String::new(), vec![0]);
    for (index, line) in text.lines().enumerate() {
        let number = index as u32 + 1;
        out.push_str(line);
        out.push('\n');
        lines.push(number);
        for note in line.split(';').skip(1).filter_map(|note| note.trim().strip_prefix("= value "))
        {
            let name = note.split_whitespace().next().expect("a name");
            out.push_str(&format!("G4 F={name}+{VALUE_SHIFT}\n"));
            lines.push(number);
        }
        // The blocks of a part that is repeated have their own lines: a dwell says where the repetition ends.
        if line.contains("= at") && line.contains("REPEAT") {
            out.push_str(&format!("G4 F={REPEAT_MARK}\n"));
            lines.push(number);
        }
    }
    (out, lines)
}

/// The dwell after a part that is repeated.
const REPEAT_MARK: f64 = 54_321.0;

/// Added to values that are told as seconds, so that negative ones can be told, too.
const VALUE_SHIFT: f64 = 100_000.0;

/// Runs a program with the subprograms of its folder.
fn run(path: &Path) -> (String, RunRecord) {
    let text = fs::read_to_string(path).expect("a program");
    let (with_values, lines) = with_values(&text);
    let mut sources = SourceMap::new();
    sources.add(Source::new(path.to_string_lossy().into_owned(), with_values.into_bytes()));
    for entry in fs::read_dir(path.parent().expect("a folder")).expect("a folder") {
        let other = entry.expect("a file").path();
        let ends_with =
            |end: &str| other.extension().is_some_and(|own| own.eq_ignore_ascii_case(end));
        let is_sub = ends_with("spf");
        if is_sub && other != path {
            let text = fs::read(&other).expect("a subprogram");
            sources.add(Source::new(other.to_string_lossy().into_owned(), text));
        }
    }
    let own = path.with_file_name("TOOLS.INI");
    let tools = if own.exists() { own } else { folder().join("TOOLS.INI") };
    let tools = fs::read(tools).expect("the tools");
    sources.add(Source::new("TOOLS.INI", tools));
    let options = RunOptions { max_repeated_blocks: 20_000, ..RunOptions::default() };
    let is_lathe = path.components().any(|part| part.as_os_str() == "clean_lathe");
    let machine = machine(if is_lathe { "sinumerik-lathe" } else { "sinumerik-mill" });
    let job = Job::new(sources, machine).expect("a job").options(options);
    let source = job.sources().get(FileId(0)).expect("the program");
    let file_line = |line: u32| lines.get(line as usize).copied().unwrap_or(0);
    let mut path = PathRecord::default();
    let outcomes = job.compensated(None, &mut path);
    let calls = outcomes.first().map(|outcome| outcome.calls.clone()).unwrap_or_default();
    let main_line = |command: &Command| match calls.resolve(command.origin.call).last() {
        Some(span) => source.line_of(span.range.start),
        None => command.origin.line,
    };
    let report = job.check();
    let problems = report.diagnostics.into_iter().map(|found| {
        let spans = found.calls.iter().chain([&found.primary.span]);
        let own = spans.filter(|span| span.file == FileId(0));
        let lines = own.map(|span| file_line(source.line_of(span.range.start))).collect();
        (lines, found)
    });
    let problems = problems.collect();
    let commands =
        path.commands.into_iter().map(|command| (file_line(main_line(&command)), command));
    (text, RunRecord { commands: commands.collect(), problems })
}

/// The value after a letter: `X10.5`.
fn value(words: &str, letter: char) -> Option<f64> {
    words.split_whitespace().find_map(|word| word.strip_prefix(letter)?.parse().ok())
}

/// What is wrong with a program: an empty list where all expectations hold.
fn faults(path: &Path) -> Vec<String> {
    let (text, record) = run(path);
    let text_of = |found: &Diagnostic| {
        let alarm = found.alarm.as_deref().unwrap_or("no alarm");
        format!("{} [{alarm}] {}", found.code.info().id, found.message)
    };
    let problems = record.problems.iter();
    let errors: Vec<(Vec<u32>, String)> = problems
        .filter(|(_, found)| found.severity == Severity::Error)
        .map(|(lines, found)| (lines.clone(), text_of(found)))
        .collect();
    let mut wrong = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let number = index as u32 + 1;
        for note in line.split(';').skip(1).map(str::trim) {
            if let Some(alarm) = note.strip_prefix('!') {
                let alarm = alarm.split_whitespace().next().unwrap_or("");
                if !errors.iter().any(|(at, text)| at.contains(&number) && text.contains(alarm)) {
                    wrong.push(format!("line {number}: no alarm {alarm}; there is {errors:?}"));
                }
            } else if let Some(expected) = note.strip_prefix('=') {
                let in_machine = ["SUPA", "G53", "G153"]
                    .iter()
                    .any(|word| line.split(';').next().is_some_and(|line| line.contains(word)));
                let has_offsets = text.contains("$P_UIFR");
                let machine_z =
                    if in_machine && !has_offsets && is_second_set(path) { ZERO_Z_MM } else { 0.0 };
                wrong.extend(check(expected.trim(), number, &record.commands, machine_z));
            }
        }
    }
    if text.contains("EXPECT clean") {
        wrong.extend(errors.iter().map(|(lines, text)| format!("line {lines:?}: {text}")));
    }
    wrong
}

/// Checks an expectation of a line against the commands; `machine_z` is added to Z: the sets say where the tool is as if
/// all offsets were zero.
fn check(expected: &str, line: u32, commands: &[(u32, Command)], machine_z: f64) -> Option<String> {
    let of_line = || commands.iter().filter(|(own, _)| *own == line).map(|(_, command)| command);
    let (kind, words) = expected.split_once(' ')?;
    match kind {
        "at" => {
            let up_to =
                || commands.iter().filter(|(own, _)| *own <= line).map(|(_, command)| command);
            let is_mark = |kind: &CommandKind| matches!(kind, CommandKind::Dwell { seconds, .. } if (seconds - REPEAT_MARK).abs() < 0.5);
            let mark = commands.iter().position(|(own, c)| *own == line && is_mark(&c.kind));
            let before_mark = mark.and_then(|mark| {
                commands[..mark].iter().rev().find_map(|(_, command)| command.kind.motion())
            });
            let last =
                before_mark.or_else(|| of_line().filter_map(|c| c.kind.motion()).next_back());
            let last = last.or_else(|| up_to().filter_map(|c| c.kind.motion()).next_back());
            let Some(motion) = last else {
                return Some(format!("line {line}: no move for `{expected}`"));
            };
            ['X', 'Y', 'Z'].into_iter().enumerate().find_map(|(axis, letter)| {
                let wanted = value(words, letter)?;
                let found = motion.to[axis] + if axis == 2 { machine_z } else { 0.0 };
                ((found - wanted).abs() > 1e-3)
                    .then(|| format!("line {line}: {letter} is {found}, not {wanted}"))
            })
        }
        "arc" => {
            let Some(shape) = of_line().filter_map(|c| c.kind.shape()).next_back() else {
                return Some(format!("line {line}: no arc"));
            };
            let (a, b, _) = shape.plane.axes();
            let letters = ['X', 'Y', 'Z'];
            let far = |at: usize, letter: char| {
                value(words, letter).is_some_and(|wanted| (shape.center[at] - wanted).abs() > 1e-3)
            };
            let degrees = words.split_whitespace().last().and_then(|n| n.parse::<f64>().ok());
            let sweep = shape.sweep.to_degrees();
            let is_wrong = far(0, letters[a])
                || far(1, letters[b])
                || degrees.is_some_and(|degrees| (sweep.abs() - degrees).abs() > 0.02)
                || (sweep < 0.0) != words.contains(" cw")
                || value(words, 'R')
                    .is_some_and(|radius| (shape.radius_from - radius).abs() > 2e-3);
            is_wrong.then(|| {
                let (center, radius) = (shape.center, shape.radius_from);
                format!("line {line}: {center:?} R{radius} {sweep}, not {words}")
            })
        }
        "moves" => {
            let wanted: usize = words.trim().parse().expect("a count");
            let found = commands.iter().filter(|(_, command)| has_length(command)).count();
            (found != wanted).then(|| format!("line {line}: {found} moves, not {wanted}"))
        }
        "value" => {
            let wanted: f64 = words.split_whitespace().nth(1)?.parse().ok()?;
            let dwells = of_line().filter_map(|command| match command.kind {
                CommandKind::Dwell { seconds, .. } => Some(seconds - VALUE_SHIFT),
                _ => None,
            });
            // Of several values of a line each is told once.
            let found: Vec<f64> = dwells.collect();
            let is_told = found.iter().any(|value| (value - wanted).abs() <= 1e-4);
            (!is_told).then(|| format!("line {line}: {found:?}, not {words}"))
        }
        _ => Some(format!("line {line}: `{expected}` is not checked")),
    }
}

/// Whether a command moves; a full circle does.
fn has_length(command: &Command) -> bool {
    let moves = command.kind.motion().is_some_and(|motion| motion.from != motion.to);
    moves || command.kind.shape().is_some()
}

fn programs(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the programs");
    let files = entries.map(|entry| entry.expect("a file").path());
    let mut files: Vec<PathBuf> =
        files.filter(|path| path.extension().is_some_and(|end| end == "mpf")).collect();
    files.sort();
    files
}

/// The programs that are known not to do what they say, and why; the list may only shrink.
const KNOWN: &[(&str, &str)] = &[
    (EXACT_SWEEP, "the sweep of the table is that about the programmed centre"),
    ("clean/row13_involute", "involutes are not followed"),
];

/// The same for the second set.
const KNOWN_OF_SECOND_SET: &[(&str, &str)] = &[
    (
        "second/clean/hand_trc_kont_front",
        "on which side of the contour KONT goes round is not sure",
    ),
    (
        "second/clean/mastercam_contour",
        "its lead-in and lead-out do cut the wall of its own contour",
    ),
    (CONTRADICTING_DEPTHS, "_AMODE chooses DPR, which is not given: not verified, and no alarm"),
    ("second/faults/feed_modal_ok", "the same contour as mastercam_contour"),
    (
        SMALL_CORNER,
        "whether POCKET3 refuses the tool differs between versions: a warning with the alarm",
    ),
];

/// Programs of the second set with a note or a warning in place of an error.
const CONTRADICTING_DEPTHS: &str = "second/faults/cyc_plane_14";
const SMALL_CORNER: &str = "second/faults/pocket_corner";

/// The one program that runs otherwise than its expectation without an error.
const EXACT_SWEEP: &str = "clean/row01_centre_rounding";

/// The programs of some folders that do not do what they say, by `folder/name`, and how many programs there are.
fn wrong_programs(parts: &[&str]) -> (BTreeMap<String, Vec<String>>, usize) {
    let mut wrong = BTreeMap::new();
    let mut count = 0;
    for part in parts {
        for path in programs(&folder().join(part)) {
            count += 1;
            let name = format!("{part}/{}", path.file_stem().expect("a name").to_string_lossy());
            let found = faults(&path);
            if !found.is_empty() {
                wrong.insert(name, found);
            }
        }
    }
    for (name, found) in &wrong {
        println!("{name}");
        found.iter().take(3).for_each(|line| println!("    {line}"));
    }
    println!("{} of {count} programs as expected", count - wrong.len());
    (wrong, count)
}

/// Compares with the list of what is known. All others than those without an error say by an error that they are not
/// followed.
fn assert_known(
    wrong: &BTreeMap<String, Vec<String>>,
    known: &[(&str, &str)],
    without_error: &[&str],
) {
    let names: Vec<&str> = wrong.keys().map(String::as_str).collect();
    let known: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, known);
    for (name, found) in wrong.iter().filter(|(name, _)| !without_error.contains(&name.as_str())) {
        assert!(found.iter().any(|line| line.contains("[no alarm]")), "{name}: {found:?}");
    }
}

#[test]
fn programs_do_what_they_say() {
    let (wrong, _) = wrong_programs(&["clean", "faults"]);
    assert_known(&wrong, KNOWN, &[EXACT_SWEEP]);
}

/// The second set, by another author.
#[test]
fn programs_of_the_second_set_do_what_they_say() {
    let (wrong, _) = wrong_programs(&["second/clean", "second/clean_lathe", "second/faults"]);
    assert_known(&wrong, KNOWN_OF_SECOND_SET, &[CONTRADICTING_DEPTHS, SMALL_CORNER]);
}

/// The point between of CIP is a length of the program's unit, as the end point is.
#[test]
fn an_arc_through_a_point_is_read_in_inches_too() {
    let program = |height: &str| {
        let text = format!(
            "G17 G54 G90 G70\nT1 D1 M6\nS3000 M3\nG0 X0 Y0 Z0.1\nG1 F20 X1\n\
             CIP X3 Y0 I1=2 J1=1 K1={height}\nG0 Z2\nM30\n"
        );
        let mut sources = SourceMap::new();
        sources.add(Source::new("cip.mpf", text.into_bytes()));
        Job::new(sources, machine("sinumerik-mill")).expect("a machine of this control")
    };
    let mut radii_mm = Vec::new();
    program("0.1").path(|segment| {
        if let chordal::geometry::Curve::Arc(arc) = &segment.curve {
            radii_mm.push(arc.radius);
        }
    });
    assert_eq!(radii_mm.len(), 1, "{radii_mm:?}");
    assert!((radii_mm[0] - 25.4).abs() < 1e-9, "{radii_mm:?}");
    let is_tilted = |height| {
        let found = program(height).check().diagnostics;
        found.iter().any(|each| each.message.contains("outside of the machine's planes"))
    };
    assert!(!is_tilted("0.1"));
    assert!(is_tilted("2.54"));
}
