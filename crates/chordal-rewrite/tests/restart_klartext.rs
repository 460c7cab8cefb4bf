//! Conversational programs that begin at one of their lines.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use chordal::control::{AxisMask, Command, Origin, RunSink, Sink};
use chordal::{Job, Machine, Source, SourceMap};
use chordal_rewrite::restart::{RefusalReason, RestartProgram, prove_head, restart};

/// The least number of lines of the frozen programs that move and at which they can begin.
const PROVED: usize = 1026;

/// The same of all their lines, also of those that do not move.
const PROVED_OF_ALL: usize = 1640;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/heidenhain/programs")
}

fn read(path: &Path) -> String {
    String::from_utf8_lossy(&std::fs::read(path).expect("a file")).into_owned()
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The programs of the folder with an extension.
fn programs(extension: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder()).expect("a folder");
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|own| own == extension))
        .collect();
    paths.sort();
    paths
}

/// The machine that a program needs.
fn machine_of(text: &str) -> Machine {
    let five = ["PLANE ", "M128", "TCPM", "CYCL DEF 19"];
    let is_five = five.iter().any(|word| text.contains(word));
    let name = if is_five { "heidenhain-ac-trunnion" } else { "heidenhain-mill" };
    Machine::from_builtin(name).expect("a machine")
}

fn job_of(first: &str, text: &str, others: &[PathBuf]) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new(first, text.as_bytes().to_vec()));
    for other in others.iter().filter(|other| name(other) != first) {
        sources.add(Source::new(name(other), read(other).into_bytes()));
    }
    Job::new(sources, machine_of(text)).expect("good settings")
}

/// The moves of a run from where the main program first comes to a byte of its text.
struct MovesFrom {
    start: u32,
    has_begun: bool,
    /// The lines with moves, of the first text.
    lines: BTreeSet<u32>,
    /// Where each move ends, and the axes whose place is known.
    ends: Vec<([f64; 6], AxisMask)>,
    calls: chordal::control::CallPath,
}

impl Sink for MovesFrom {
    fn command(&mut self, command: &Command) {
        let Origin { span, line, call, .. } = command.origin;
        let is_first = span.file == chordal::diagnostics::FileId(0);
        let Some(motion) = command.kind.motion() else { return };
        let is_main = is_first && call == self.calls;
        self.has_begun |= is_main && span.range.start >= self.start;
        if is_first {
            self.lines.insert(line);
        }
        if self.has_begun {
            self.ends.push((motion.to, motion.to_known));
        }
    }

    fn diagnostic(&mut self, _: chordal::Diagnostic) {}
}

impl RunSink for MovesFrom {}

fn moves_from(job: &Job, start: u32) -> MovesFrom {
    let calls = chordal::control::CallPath::default();
    let mut moves =
        MovesFrom { start, has_begun: false, lines: BTreeSet::new(), ends: Vec::new(), calls };
    drop(job.run(&mut moves));
    moves
}

/// All moves of both programs end at the same places, counted from the last on.
fn ends_are_same(job: &Job, done: &RestartProgram, text: &str) -> Result<(), String> {
    let start: usize = text.split_inclusive('\n').take(done.line as usize - 1).map(str::len).sum();
    let old = moves_from(job, start as u32);
    let new = moves_from(&job.with_text(done.text.clone()), done.head_bytes.end);
    if old.ends.len() != new.ends.len() {
        return Err(format!("{} moves, and {} in the new program", old.ends.len(), new.ends.len()));
    }
    for (at, ((old, known), (new, also))) in old.ends.iter().zip(&new.ends).enumerate() {
        // Where the head does not go to the height, the first rapids may come from a place that is not known.
        let is_open = done.approaches && at < 2;
        let is_other =
            |axis: usize| known.has(axis) && also.has(axis) && (old[axis] - new[axis]).abs() > 1e-6;
        if (0..6).any(is_other) || known != also && !is_open {
            return Err(format!("move {at}: {old:?} is {new:?}"));
        }
    }
    Ok(())
}

/// What is refused without the numbers in it.
fn kind_of(reason: RefusalReason, what: &str) -> String {
    let words: Vec<&str> = what
        .split_whitespace()
        .map(|word| if word.chars().any(|c| c.is_ascii_digit()) { "#" } else { word })
        .collect();
    format!("{} {}", reason.word(), words.join(" "))
}

#[test]
fn every_line_that_moves_is_proved_or_refused_with_a_reason() {
    let paths = programs("h");
    let others: Vec<PathBuf> = ["h", "d"].iter().flat_map(|own| programs(own)).collect();
    let mut reasons = BTreeMap::<String, Vec<String>>::new();
    let (mut proved, mut proved_of_all, mut lines) = (0, 0, 0);
    let mut wrong = Vec::new();
    for path in &paths {
        let text = read(path);
        let called: Vec<PathBuf> = others
            .iter()
            .filter(|other| text.to_lowercase().contains(name(other).trim_end_matches(".h")))
            .cloned()
            .collect();
        let job = job_of(&name(path), &text, &called);
        let moving = moves_from(&job, 0).lines;
        let mut own = 0;
        for line in 1..=text.lines().count() as u32 {
            let moves = moving.contains(&line);
            match restart(&job, line) {
                Ok(done) => {
                    own += usize::from(moves);
                    proved_of_all += 1;
                    if let Err(what) = ends_are_same(&job, &done, &text) {
                        wrong.push(format!(
                            "{}:{line}: {what}\n{}",
                            name(path),
                            done.head.join("\n")
                        ));
                    }
                }
                Err(refused) => {
                    let why = &refused.refusal;
                    assert!(!why.what.is_empty() && !why.help.is_empty());
                    if !moves {
                        continue;
                    }
                    let kind = kind_of(refused.reason, &why.what);
                    reasons.entry(kind).or_default().push(format!("{}:{line}", name(path)));
                }
            }
        }
        println!("{}: {own} of {}", name(path), moving.len());
        proved += own;
        lines += moving.len();
    }
    println!("{} programs, {proved} of {lines} lines; {proved_of_all} of all", paths.len());
    for (what, places) in &reasons {
        println!("  {} {what}: {}", places.len(), places[..places.len().min(4)].join(" "));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(proved >= PROVED && proved_of_all >= PROVED_OF_ALL, "{proved}, {proved_of_all}");
}

/// A program by hand: a subprogram that is run where it stands and called again, a datum shift, a cycle, parameters.
const PLATE: &str = "\
0 BEGIN PGM PLATTE MM
1 BLK FORM 0.1 Z X+0 Y+0 Z-20
2 BLK FORM 0.2 X+100 Y+80 Z+0
3 TOOL DEF 4 L+0 R+3
4 FN 0: Q5 = +1.5
5 TOOL CALL 4 Z S3000 F500 DL+0.1
6 L Z+100 R0 FMAX M3
7 L X+10 Y+10 R0 FMAX M8
8 LBL 1
9 L Z+2 FMAX
10 L Z-Q5 F150
11 L IX+20 F400
12 L Z+2 FMAX
13 LBL 0
14 CYCL DEF 7.0 DATUM SHIFT
15 CYCL DEF 7.1 X+40
16 CYCL DEF 7.2 Y+30
17 CC X+5 Y+5
18 LP PR+12 PA+30 R0 FMAX
19 CALL LBL 1
20 L X+0 Y+0 FMAX
21 L Z-1 F200
22 APPR LT X+10 Y+10 LEN5 RL F300
23 L X+30
24 RND R2
25 L Y+30
26 DEP LT LEN5
27 L Z+100 FMAX
28 M30
29 END PGM PLATTE MM
";

fn plate() -> Job<'static> {
    job_of("platte.h", PLATE, &[])
}

/// The line of the text with a block number.
fn line_of(number: u32) -> u32 {
    number + 1
}

#[test]
fn a_head_says_what_holds_before_the_line() {
    let done = restart(&plate(), line_of(20)).expect("proved");
    assert_eq!(
        done.head,
        [
            "TOOL CALL 4 Z S3000 F500 DL+0.1",
            "CYCL DEF 7.0 DATUM SHIFT",
            "CYCL DEF 7.1 X+40",
            "CYCL DEF 7.2 Y+30",
            "CYCL DEF 7.3 Z+0",
            "FN 0: Q99 = +35.3923048454133",
            "L Z+100 R0 FMAX M3",
            "L X+Q99 Y+11 R0 FMAX M8",
            "L Z+2 R0 F400",
            "CC X+5 Y+5",
        ]
    );
    let text = String::from_utf8(done.text).expect("text");
    let (first, rest) = text.split_once("CC X+5 Y+5\n").expect("the last block of the head");
    assert!(first.contains("3 TOOL DEF 4 L+0 R+3\n; BEGINS AT LINE 21 OF PLATTE.H\n"), "{first}");
    assert!(rest.starts_with("20 L X+0 Y+0 FMAX\n") && rest.ends_with("29 END PGM PLATTE MM\n"));
}

#[test]
fn the_example_of_the_page_is_written() {
    let done = restart(&plate(), line_of(21)).expect("proved");
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/restart.md");
    let head = done.head.join("\n");
    assert!(read(&page).contains(&format!("{head}\n21 L Z-1 F200\n")), "{head}");
}

#[test]
fn a_head_that_says_something_else_is_not_proved() {
    let job = plate();
    let text = String::from_utf8(restart(&job, line_of(21)).expect("proved").text).expect("text");
    let same = text.replacen("L Z+100 R0 FMAX M3", "L Z+60 R0 FMAX M3", 1);
    assert!(prove_head(&job, line_of(21), same.as_bytes()).is_ok());
    let changes = [
        (" DL+0.1\n", "\n"),
        ("DL+0.1\nCYCL", "DL+0.1 DR+0.2\nCYCL"),
        ("S3000", "S2000"),
        (
            "CYCL DEF 7.1 X+40\nCYCL DEF 7.2 Y+30\nCYCL DEF 7.3",
            "CYCL DEF 7.1 X+41\nCYCL DEF 7.2 Y+30\nCYCL DEF 7.3",
        ),
        ("FMAX M3\nL X+0", "FMAX M4\nL X+0"),
        ("R0 FMAX M8\nL Z+2 R0", "R0 FMAX\nL Z+2 R0"),
        ("L Z+2 R0 F400", "L Z+3 R0 F400"),
    ];
    for (old, new) in changes {
        let changed = text.replacen(old, new, 1);
        assert_ne!(changed, text, "{old}");
        let refused = prove_head(&job, line_of(21), changed.as_bytes()).expect_err(new);
        assert_eq!(refused.reason, RefusalReason::Unproved, "{}", refused.refusal.what);
    }
}

#[test]
fn subprograms_before_the_line_stand_after_the_end() {
    let done = restart(&plate(), line_of(18)).expect("proved");
    assert!(done.head.contains(&"FN 0: Q5 = +1.5".to_string()), "{:?}", done.head);
    let text = String::from_utf8(done.text).expect("text");
    assert!(text.contains("28 M30\n8 LBL 1\n9 L Z+2 FMAX\n"), "{text}");
    assert!(text.ends_with("13 LBL 0\n29 END PGM PLATTE MM\n"), "{text}");
    // A program that runs to END PGM jumps over them.
    let job = job_of("platte.h", &PLATE.replace("28 M30\n", "28 STOP\n"), &[]);
    let text = String::from_utf8(restart(&job, line_of(18)).expect("proved").text).expect("text");
    assert!(text.contains("FN 9: IF +0 EQU +0 GOTO LBL 254\n8 LBL 1\n"), "{text}");
}

#[test]
fn refusals_name_the_line_to_begin_at() {
    let job = plate();
    let refused = |line: u32| {
        let refused = restart(&job, line).expect_err("refused");
        (refused.reason, refused.refusal.help)
    };
    let cases = [
        (line_of(2), RefusalReason::Beginning, "run the program itself"),
        (line_of(10), RefusalReason::Repeated, "before the label"),
        (line_of(16), RefusalReason::Open, "begin at line 15"),
        (line_of(23), RefusalReason::Compensation, "begin at line 23"),
        (line_of(25), RefusalReason::Compensation, "begin at line 23"),
        (line_of(29), RefusalReason::NoBlock, "an earlier line"),
        (0, RefusalReason::NoBlock, "ends at line 30"),
        (31, RefusalReason::NoBlock, "ends at line 30"),
    ];
    for (line, reason, help) in cases {
        let found = refused(line);
        assert!(found.0 == reason && found.1.contains(help), "{line}: {found:?}");
    }
}

#[test]
fn din_iso_programs_are_refused() {
    for path in programs("i") {
        let text = read(&path);
        let job = job_of(&name(&path), &text, &[]);
        for line in 1..=text.lines().count() as u32 {
            let refused = restart(&job, line).expect_err("refused");
            assert_eq!(refused.reason, RefusalReason::Form);
            assert!(refused.refusal.what.contains("DIN/ISO"), "{}", refused.refusal.what);
        }
    }
}

#[test]
fn no_text_is_too_short() {
    for path in programs("h").iter().step_by(9) {
        let text = read(path);
        for end in (0..text.len()).step_by(97).filter(|end| text.is_char_boundary(*end)) {
            let job = job_of("part.h", &text[..end], &[]);
            for line in [1, 4, 9, text[..end].lines().count() as u32] {
                drop(restart(&job, line));
            }
        }
    }
}
