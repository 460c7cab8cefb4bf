//! The five-axis programs of `tests/five-axes`: right ones of which nothing may be said and whose axes must be where the
//! kinematics say, faults planted in them, and the alarms of the controls.
//!
//! `cargo test -p chordal --test five_axes -- --nocapture` prints what became of each.

#![allow(clippy::disallowed_methods, reason = "a test reads the programs of its set")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

use chordal::motion::{MotionOptions, MotionStep, StepSource};
use chordal::stock::StockOptions;
use chordal::{Diagnostic, Job, Machine, Severity, Source, SourceMap};

/// How many there must be at least; more is better.
const RIGHT: usize = 40;
const PLACES: usize = 237;
const FAULTS: usize = 99;
const ALARMS: usize = 56;

/// A code that Chordal does not carry out: it finds no fault.
const NOT_FOLLOWED: &str = "CH312";

/// The axes of the machine agree within this, mm and degrees.
const TOLERANCE: f64 = 0.002;

/// Half of a turn and of a whole one, degrees.
const TURN: f64 = 360.0;

fn folder(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../tests/five-axes").join(name)
}

fn read(path: &PathBuf) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The files of a folder by name.
fn programs(name: &str) -> BTreeMap<String, String> {
    let files = fs::read_dir(folder(name)).expect("a folder");
    files
        .map(|file| file.expect("a file").path())
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), read(&path)))
        .collect()
}

/// The name of the machine, in the head of a program.
fn machine_of(program: &str) -> &str {
    let (_, after) = program.split_once("machine: ").expect("the machine of a program");
    after.split(['\n', ')']).next().expect("a name").trim()
}

fn job(program: &str, machine: &str, stock: Option<&str>) -> Result<Job<'static>, String> {
    let text = stock.map_or_else(
        || read(&folder("machines").join(format!("{machine}.toml"))),
        |stock| setup(machine, stock),
    );
    let others =
        |name: &str| fs::read_to_string(folder("machines").join(name)).map_err(|e| e.to_string());
    let machine = Machine::from_toml("five.toml", &text, &others).map_err(|e| format!("{e:?}"))?;
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.as_bytes().to_vec()));
    Job::new(sources, machine).map_err(|error| format!("{error:?}"))
}

/// A box to cut from, of `X-60..35 Y-35..60 Z-60..0`.
fn setup(machine: &str, stock: &str) -> String {
    let side = |end: usize| {
        let sides = stock.split(' ').map(|axis| {
            let (from, to) = axis[1..].split_once("..").expect("two ends");
            format!("{} = \"{} mm\"", &axis[..1], [from, to][end])
        });
        sides.collect::<Vec<_>>().join(", ")
    };
    format!(
        "machine = \"{machine}.toml\"\n[stock]\nshape = \"box\"\nwork_offset = \"G54\"\nfrom = {{ {} }}\nto = {{ {} }}\n",
        side(0),
        side(1)
    )
}

/// An error or a warning.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Told {
    line: u32,
    code: &'static str,
    text: String,
}

fn words_of(diagnostic: &Diagnostic) -> String {
    let more =
        [Some(&diagnostic.primary.text), diagnostic.alarm.as_ref(), diagnostic.help.as_ref()];
    let mut text = diagnostic.message.clone();
    for part in more.into_iter().flatten().chain(&diagnostic.notes) {
        text.push_str(" / ");
        text.push_str(part);
    }
    text
}

fn check(program: &str, machine: &str) -> Result<Vec<Told>, String> {
    let job = job(program, machine, None)?;
    let source = job.sources().iter().next().map(|(_, source)| source).expect("a text");
    let told = job.check().diagnostics;
    let told = told.iter().filter(|each| each.severity != Severity::Note).map(|each| Told {
        line: source.line_of(each.primary.span.range.start),
        code: each.code.info().id,
        text: words_of(each),
    });
    Ok(told.collect())
}

/// What touches the stock as it must not.
fn cut(program: &str, machine: &str, stock: &str) -> Result<Vec<Told>, String> {
    let job = job(program, machine, Some(stock))?;
    let options = StockOptions { resolution_mm: Some(1.0), ..StockOptions::default() };
    let report = job.stock(&options, &|name| Err(format!("no file {name}")));
    let report = report.map_err(|error| format!("{error:?}"))?;
    // A move that is not cut is no fault that is found.
    let problems = report.problems.iter();
    let problems = problems.filter(|problem| problem.code.info().name != "stock-not-followed");
    let told = problems.map(|problem| Told {
        line: problem.line,
        code: problem.code.info().id,
        text: problem.code.info().name.into(),
    });
    Ok(told.collect())
}

/// What an item `(= … )` of a line says.
fn expectation(line: &str) -> Option<&str> {
    line.split_once("(= ").and_then(|(_, after)| after.strip_suffix(')'))
}

/// The places of the axes at the ends of lines: in degrees A, B and C.
type Places = BTreeMap<u32, [Option<f64>; 6]>;

fn expected_places(program: &str) -> Places {
    let lines = (1..).zip(program.lines());
    let places = lines.filter_map(|(number, line)| {
        let words = expectation(line)?.strip_prefix("machine ")?;
        let mut place = [None; 6];
        for word in words.split(' ') {
            let axis = "XYZABC".find(&word[..1]).expect("an axis");
            place[axis] = Some(word[1..].parse().expect("a number"));
        }
        Some((number, place))
    });
    places.collect()
}

/// Where the axes are at the ends of lines, apart from a distance that is the same for the whole program.
fn places(job: &Job) -> BTreeMap<u32, [f64; 6]> {
    let mut ends = BTreeMap::new();
    let taken = job.motion(&MotionOptions::default(), |step: &MotionStep, source: &StepSource| {
        if let MotionStep::Move(motion) = step {
            let mut to = motion.to();
            to[3..].iter_mut().for_each(|angle| *angle = angle.to_degrees());
            ends.insert(source.origin.line, to);
        }
        Ok(())
    });
    drop(taken);
    ends
}

/// The lines whose axes are where they must be, and what is wrong with the others.
fn compare_places(program: &str, machine: &str) -> (usize, Vec<String>) {
    let expected = expected_places(program);
    let found = match job(program, machine, None) {
        Ok(job) => places(&job),
        Err(error) => return (0, vec![error]),
    };
    // The distance is what most lines say.
    let away = |line: &u32| -> Option<[f64; 3]> {
        let (end, place) = (found.get(line)?, &expected[line]);
        Some([0, 1, 2].map(|axis| place[axis].unwrap_or(f64::NAN) - end[axis]))
    };
    let distances: Vec<[f64; 3]> = expected.keys().filter_map(away).collect();
    let same = |a: &[f64; 3], b: &[f64; 3]| (0..3).all(|i| (a[i] - b[i]).abs() <= TOLERANCE);
    let votes = |a: &[f64; 3]| distances.iter().filter(|b| same(a, b)).count();
    let Some(distance) = distances.iter().max_by_key(|a| votes(a)) else {
        return (0, vec!["no line with a place moves".into()]);
    };
    let mut right = 0;
    let mut wrong = Vec::new();
    for (line, place) in &expected {
        let Some(end) = found.get(line) else {
            wrong.push(format!("line {line}: no motion"));
            continue;
        };
        let off: Vec<f64> = (0..6)
            .filter_map(|axis| {
                let off = place[axis]? - end[axis];
                Some(if axis < 3 {
                    off - distance[axis]
                } else {
                    off - TURN * (off / TURN).round()
                })
            })
            .collect();
        if off.iter().all(|off| off.abs() <= TOLERANCE) {
            right += 1;
        } else {
            wrong.push(format!("line {line}: {off:.3?} off"));
        }
    }
    (right, wrong)
}

/// A fault of `faults.txt`.
#[derive(Debug, Default)]
struct Fault {
    title: String,
    program: String,
    machine: Option<String>,
    stock: Option<String>,
    /// The lines of the right program that go, with their text.
    gone: BTreeMap<usize, String>,
    /// What comes at a line or after it.
    new: BTreeMap<usize, Vec<String>>,
    at: Vec<(u32, String)>,
    says: String,
}

fn faults() -> Vec<Fault> {
    let text = read(&folder("faults.txt"));
    let mut faults: Vec<Fault> = Vec::new();
    for line in text.lines() {
        if let Some(title) = line.strip_prefix("=== ") {
            faults.push(Fault { title: title.into(), ..Fault::default() });
            continue;
        }
        let Some(fault) = faults.last_mut() else { continue };
        let numbered = |text: &str, by: char| {
            let (number, text) = text.split_once(by).expect("a number and a text");
            (number.parse::<usize>().expect("a number"), text.trim_start().to_string())
        };
        if let Some(rest) = line.strip_prefix("- ") {
            let (number, text) = numbered(rest, ':');
            fault.gone.insert(number, text);
        } else if let Some(rest) = line.strip_prefix("+ ") {
            let (number, text) = numbered(rest, ':');
            fault.new.entry(number).or_default().push(text);
        } else if let Some((key, value)) = line.split_once(": ") {
            match key {
                "program" => fault.program = value.into(),
                "machine" => fault.machine = Some(value.into()),
                "stock" => fault.stock = Some(value.into()),
                "at" => {
                    let (number, text) = numbered(value, ' ');
                    fault.at.push((number as u32, text));
                }
                "says" => fault.says = value.into(),
                "rule" => {}
                _ => panic!("{}: {line}", fault.title),
            }
        }
    }
    faults
}

/// A line without its expectation.
fn bare(line: &str) -> &str {
    line.split("(= ").next().unwrap_or(line).trim_end_matches([' ', ';'])
}

/// The changed program, and the line of the right one that each of its lines was.
fn plant(fault: &Fault, right: &str) -> (String, Vec<Option<u32>>) {
    let mut text = String::new();
    let mut was = Vec::new();
    for (number, line) in (1..).zip(right.lines()) {
        let gone = fault.gone.get(&number);
        if let Some(gone) = gone {
            assert_eq!(bare(line), gone, "{}", fault.title);
        } else {
            text.push_str(line);
            text.push('\n');
            was.push(Some(number as u32));
        }
        for new in fault.new.get(&number).into_iter().flatten() {
            text.push_str(new);
            text.push('\n');
            was.push(gone.map(|_| number as u32));
        }
    }
    for (line, expected) in &fault.at {
        assert_eq!(
            bare(text.lines().nth(*line as usize - 1).unwrap_or("")),
            expected,
            "{}",
            fault.title
        );
    }
    (text, was)
}

fn note(lines: &mut Vec<String>, name: &str, outcome: &str, why: &[String]) {
    lines.push(format!("{outcome:<16} {name}"));
    lines.extend(why.iter().take(4).map(|why| format!("{:16}   {why}", "")));
}

fn brief(told: &[Told]) -> Vec<String> {
    told.iter().map(|told| format!("{} line {}: {}", told.code, told.line, told.text)).collect()
}

#[test]
fn nothing_is_said_of_right_programs() {
    let (mut right, mut not_followed) = (0, 0);
    let (mut near, mut all) = (0, 0);
    let mut lines = Vec::new();
    let programs = programs("right");
    for (name, text) in &programs {
        let told = match check(text, machine_of(text)) {
            Ok(told) => told,
            Err(error) => {
                note(&mut lines, name, "no machine", &[error]);
                continue;
            }
        };
        let outcome = if told.is_empty() {
            right += 1;
            "right"
        } else if told.iter().any(|told| told.code == NOT_FOLLOWED) {
            not_followed += 1;
            "not carried out"
        } else {
            "false"
        };
        note(&mut lines, name, outcome, &brief(&told));
        let expected = expected_places(text).len();
        all += expected;
        let (found, wrong) = compare_places(text, machine_of(text));
        near += found;
        if outcome != "not carried out" && !wrong.is_empty() {
            note(&mut lines, name, "places", &wrong);
        }
    }
    println!("{}", lines.join("\n"));
    println!(
        "{right} of {} right programs are clean, {not_followed} not carried out",
        programs.len()
    );
    println!("{near} of {all} places of the axes");
    assert!(right >= RIGHT && near >= PLACES, "{right} programs, {near} places");
}

/// What is said of a program, with its stock where there is one.
fn say(program: &str, machine: &str, stock: Option<&str>) -> Result<Vec<Told>, String> {
    match stock {
        Some(stock) => cut(program, machine, stock),
        None => check(program, machine),
    }
}

/// How a fault came out, next to what is said of the right program.
fn outcome_of(
    fault: &Fault,
    right: &str,
    before: &[Told],
) -> Result<(&'static str, Vec<Told>), String> {
    let (text, was) = plant(fault, right);
    let machine = fault.machine.as_deref().unwrap_or_else(|| machine_of(right));
    let after = say(&text, machine, fault.stock.as_deref())?;
    let known: BTreeSet<(u32, &str)> = before.iter().map(|told| (told.line, told.code)).collect();
    let is_new = |told: &&Told| {
        let line = was.get(told.line as usize - 1).copied().flatten();
        told.code != NOT_FOLLOWED && line.is_none_or(|line| !known.contains(&(line, told.code)))
    };
    let new: Vec<Told> = after.iter().filter(is_new).cloned().collect();
    let at: Vec<&Told> =
        new.iter().filter(|told| fault.at.iter().any(|(line, _)| *line == told.line)).collect();
    let first = fault.at.iter().map(|(line, _)| *line).min().unwrap_or(0);
    let lost = after.iter().any(|told| told.code == NOT_FOLLOWED && told.line < first);
    let is_lost_here = after.iter().any(|told| told.code == NOT_FOLLOWED && told.line == first);
    let numbered = fault.says.chars().any(|c| c.is_ascii_digit());
    let named = numbered && at.iter().any(|told| told.text.contains(&fault.says));
    // Where the path is lost before, what is found is luck unless it is the alarm itself.
    let outcome = match (at.is_empty(), new.is_empty()) {
        (false, _) if named => "found",
        _ if lost || at.is_empty() && is_lost_here => "not carried out",
        (false, _) if numbered => "found, no number",
        (false, _) => "found",
        (true, true) => "missed",
        (true, false) => "elsewhere",
    };
    Ok((outcome, if new.is_empty() { after } else { new }))
}

#[test]
fn faults_are_found_at_their_lines() {
    let programs = programs("right");
    let faults = faults();
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut lines = Vec::new();
    // What is said of the right programs.
    let mut said: BTreeMap<(&str, Option<&str>), Vec<Told>> = BTreeMap::new();
    for fault in &faults {
        let right = &programs[&fault.program];
        let stock = fault.stock.as_deref();
        let before = said
            .entry((&fault.program, stock))
            .or_insert_with(|| say(right, machine_of(right), stock).unwrap_or_default());
        let (outcome, told) = match outcome_of(fault, right, before) {
            Ok(outcome) => outcome,
            Err(error) => ("no machine", vec![Told { line: 0, code: "", text: error }]),
        };
        *counts.entry(outcome).or_default() += 1;
        note(&mut lines, &format!("{} [{}]", fault.title, fault.says), outcome, &brief(&told));
    }
    println!("{}\n{counts:?}", lines.join("\n"));
    let found = counts.get("found").unwrap_or(&0) + counts.get("found, no number").unwrap_or(&0);
    println!("{found} of {} faults found at their line", faults.len());
    assert!(found >= FAULTS, "{found}");
}

/// The lines of which one is the alarm, with what the control says there.
fn expected_alarms(program: &str) -> BTreeMap<u32, &str> {
    let lines = (1..).zip(program.lines());
    let marked = lines.filter_map(|(number, line)| Some((number, line.split_once("(= !")?.1)));
    marked.map(|(number, says)| (number, says.trim_matches([' ', ')', '"']))).collect()
}

fn outcome_of_alarm(told: &[Told], expected: &BTreeMap<u32, &str>) -> &'static str {
    let Some((&first, says)) = expected.first_key_value() else {
        let lost = told.iter().any(|told| told.code == NOT_FOLLOWED);
        return match (told.is_empty(), lost) {
            (true, _) => "right",
            (false, true) => "not carried out",
            (false, false) => "false",
        };
    };
    let followed = |told: &&Told| told.code != NOT_FOLLOWED;
    let is_here = |told: &&Told| expected.contains_key(&told.line);
    let here: Vec<&Told> = told.iter().filter(followed).filter(is_here).collect();
    let is_early = told.iter().filter(followed).any(|told| told.line < first);
    let last_followed = first + u32::from(here.is_empty());
    let is_lost = told.iter().any(|told| told.code == NOT_FOLLOWED && told.line < last_followed);
    let is_named = here.iter().any(|told| told.text.contains(says));
    match here.is_empty() {
        false if is_named && !says.is_empty() && !is_early => "right",
        _ if is_lost => "not carried out",
        _ if told.first().is_some_and(|told| told.line == 0) => "no machine",
        true if told.is_empty() => "missed",
        true => "elsewhere",
        false if is_early => "and another",
        false if is_named => "right",
        false => "other number",
    }
}

#[test]
fn alarms_are_those_of_the_controls() {
    let programs = programs("alarms");
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut lines = Vec::new();
    for (name, text) in &programs {
        let told = check(text, machine_of(text))
            .unwrap_or_else(|error| vec![Told { line: 0, code: "", text: error }]);
        let expected = expected_alarms(text);
        let outcome = outcome_of_alarm(&told, &expected);
        *counts.entry(outcome).or_default() += 1;
        let says = expected
            .values()
            .next()
            .map_or("nothing", |says| if says.is_empty() { "alarm" } else { says });
        note(&mut lines, &format!("{name} [{says}]"), outcome, &brief(&told));
    }
    let right = counts.get("right").copied().unwrap_or(0);
    println!("{}\n{counts:?}\n{right} of {} alarms", lines.join("\n"), programs.len());
    assert!(right >= ALARMS, "{right}");
}
