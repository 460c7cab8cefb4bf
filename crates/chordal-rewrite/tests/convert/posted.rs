//! Programs to and from a language that is not word-address: by their run, there and back.

use chordal::{Job, Machine, Source, SourceMap};
use chordal_rewrite::convert::{Conversion, ConversionOptions, convert};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use super::random::{RandomBlock, piece, program};
use super::{VerdictTable, converted, job, job_of, machine, suite_programs, text_of, verdict};

/// What a program came to on the way there and back again.
pub(super) struct RoundTrip {
    pub there: Conversion,
    pub back: Option<Conversion>,
}

impl RoundTrip {
    fn of(old: &Job) -> RoundTrip {
        RoundTrip::through(old, &machine("sinumerik-mill"))
    }

    /// Through another machine.
    pub fn through(old: &Job, middle: &Machine) -> RoundTrip {
        let there = convert(old, middle, &ConversionOptions::default());
        let middle = there.holds().then(|| job(&there.text, there.machine.clone()));
        let back =
            middle.map(|middle| convert(&middle, old.machine(), &ConversionOptions::default()));
        RoundTrip { there, back }
    }

    pub fn holds(&self) -> [bool; 2] {
        [self.there.holds(), self.back.as_ref().is_some_and(Conversion::holds)]
    }

    pub fn verdict(&self) -> String {
        match &self.back {
            Some(back) => format!("{}; back {}", verdict(&self.there), verdict(back)),
            None => verdict(&self.there),
        }
    }

    /// Nothing that is not proved is left without a sentence.
    pub fn is_proved_or_refused(&self) -> bool {
        let is_answered = |found: &Conversion| found.holds() || !found.refusals.is_empty();
        is_answered(&self.there) && self.back.as_ref().is_none_or(is_answered)
    }
}

/// What became of programs on the way there and back again, for a golden file.
#[derive(Default)]
struct TripTable {
    text: String,
    proved: [usize; 2],
    all: usize,
}

impl TripTable {
    fn add(&mut self, name: &str, old: &Job) {
        let trip = RoundTrip::of(old);
        self.all += 1;
        for (proved, holds) in self.proved.iter_mut().zip(trip.holds()) {
            *proved += usize::from(holds);
        }
        self.text += &format!("{name}\n    {}\n", trip.verdict());
    }

    fn finish(self) -> String {
        let (text, [there, back], all) = (self.text, self.proved, self.all);
        format!("{text}\n{there} of {all} proved, {back} of them back again\n")
    }
}

#[test]
fn programs_of_the_suite() {
    let folders = ["fanuc", "haas", "mitsubishi", "linuxcnc", "fadal", "textbook"];
    let mut table = TripTable::default();
    for path in suite_programs(&folders) {
        table.add(&path, &job_of(&text_of(&path), &[]));
    }
    insta::assert_snapshot!(table.finish());
}

/// The examples for mills with three axes.
#[test]
fn examples() {
    let machines = [
        ("fadal", "fadal-4020"),
        ("fanuc", "fanuc-30i"),
        ("haas", "haas-vf2"),
        ("linuxcnc", "linuxcnc-mill"),
        ("mitsubishi", "mitsubishi-m700"),
    ];
    let mut table = TripTable::default();
    for (folder, name) in machines {
        let folder = format!("examples/{folder}");
        let programs = names_in(&folder);
        for program in programs.iter().filter(|name| name.contains(".n")) {
            let text = text_of(&format!("{folder}/{program}"));
            table.add(&format!("{folder}/{program}"), &job(&text, wide(name)));
        }
    }
    insta::assert_snapshot!(table.finish());
}

/// The part programs of the repository for word-address controls.
#[test]
fn part_programs() {
    let folder = "crates/chordal-sinumerik/tests/programs/clean";
    let mut table = VerdictTable::default();
    for name in names_in(folder) {
        let text = text_of(&format!("{folder}/{name}"));
        if !name.ends_with(".mpf") {
            continue;
        }
        let old = part_job(folder, &name, &text);
        table.add(&name, &old, &["fanuc-30i", "haas-vf2", "linuxcnc-mill"]);
    }
    insta::assert_snapshot!(table.finish());
}

/// A part program with the subprograms next to it.
fn part_job(folder: &str, name: &str, text: &str) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new(name, text.as_bytes().to_vec()));
    for other in names_in(folder).iter().filter(|other| other.ends_with(".spf")) {
        let text = text_of(&format!("{folder}/{other}"));
        sources.add(Source::new(other.as_str(), text.into_bytes()));
    }
    let mut machine = wide("sinumerik-mill");
    for (at, name) in tool_names(text).iter().enumerate() {
        machine.tools.entry(at as u32 + 21).or_default().description = Some(name.clone());
    }
    Job::new(sources, machine).expect("a machine without settings")
}

/// The names in `T="…"`.
fn tool_names(text: &str) -> Vec<String> {
    let after = text.split("T=\"").skip(1);
    let mut names: Vec<String> =
        after.filter_map(|rest| Some(rest.split_once('"')?.0.to_string())).collect();
    names.sort();
    names.dedup();
    names
}

#[allow(clippy::disallowed_methods, reason = "tests read folders")]
pub(super) fn names_in(folder: &str) -> Vec<String> {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let entries = std::fs::read_dir(root.join(folder)).expect("a folder").flatten();
    let mut names: Vec<String> =
        entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// Random programs of two controls; each tool with its length and its radius.
#[test]
fn random_programs() {
    #[allow(clippy::disallowed_methods, reason = "the number of rounds")]
    let rounds = std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok());
    let rounds: usize = rounds.unwrap_or(30);
    let mut runner = TestRunner::default();
    let pieces = || prop::collection::vec(piece(), 1..9);
    let strategy = (pieces(), prop::collection::vec(pieces(), 3..4));
    let (mut proved, mut back, mut refused) = (0, 0, Vec::new());
    for _ in 0..rounds {
        let (mut main, subs) = strategy.new_tree(&mut runner).expect("a program").current();
        main.extend((0..3).map(|sub| RandomBlock::Call(sub, 1)));
        // The machine has three axes.
        let has_axis = |piece: &RandomBlock| !matches!(piece, RandomBlock::Turn(..));
        main.retain(has_axis);
        let subs: Vec<Vec<RandomBlock>> =
            subs.into_iter().map(|sub| sub.into_iter().filter(has_axis).collect()).collect();
        for control in ["fanuc-30i", "haas-vf2"] {
            let text = with_lengths(&program(control, &main, &subs));
            let old = job(&text, wide(control));
            let trip = RoundTrip::of(&old);
            let [there, again] = trip.holds();
            proved += usize::from(there);
            back += usize::from(again);
            if !(there && again) {
                refused.push(trip.verdict());
            }
            assert!(
                trip.is_proved_or_refused(),
                "{control}: {}\n{text}\n====\n{}\n====\n{}",
                trip.verdict(),
                trip.there.text,
                trip.back.map(|back| back.text).unwrap_or_default()
            );
        }
    }
    refused.sort();
    println!("{proved} of {} proved, {back} of them back again; {refused:#?}", 2 * rounds);
    assert!(back * 2 > rounds, "{refused:#?}");
}

/// The program with the length and the radius of each tool.
pub(super) fn with_lengths(text: &str) -> String {
    let mut tool = 1;
    let mut lines = Vec::new();
    for line in text.lines() {
        if let Some(number) = line.strip_suffix(" M6").and_then(|line| line.strip_prefix('T')) {
            tool = number.parse().expect("a tool");
            lines.push(line.to_string());
            lines.push(format!("G43 H{tool}"));
            continue;
        }
        lines.push(line.replace(" D1 ", &format!(" D{tool} ")));
    }
    lines.join("\n") + "\n"
}

/// A machine without limits, whose tools all have a radius.
pub(super) fn wide(control: &str) -> Machine {
    let mut own = machine(control);
    own.axes.iter_mut().flatten().for_each(|axis| axis.travel = None);
    own.feed = Default::default();
    for tool in 1..10 {
        own.set(&format!("tools.{tool}.diameter=\"0.1 in\"")).expect("a good assignment");
    }
    own
}

const BRACKET: &str = "\
%
O1234 (BRACKET)
(FIRST SIDE)
N10 G21 G90 G17 G40 G80
N20 T1 M6 (MILL D10)
N30 G54 G0 X0 Y0 S1200 M3
N40 G43 H1 Z50. M8
N50 Z2.
N60 G1 Z-3. F200.
N70 X40. F500.
N80 G3 X50. Y10. I0 J10.
N90 G2 X60. Y20. R10.
N100 G3 I-10. (FULL CIRCLE)
G1 G41 D1 X0 Y0
Y10.
G40 X20.
G4 P500
G0 Z50. M9
G91 G28 Z0
G90
T2 M6
(DRILL)
G0 G55 X10. Y-10. S2000 M3
G43 H2 Z30.
G98 G81 X10. Y10. Z-5. R2. F100.
X20.
G80
G99 G82 X10. Y30. Z-5. R2. P300
X20.
G80
G83 X30. Y30. Z-13. R2. Q5.
G80
G0 Z30.
T3 M6
G54.1 P2 X5. Y5. S500 M3
G43 H3 Z10.
G84 X5. Y5. Z-8. R3. F500.
G80
M98 P100 L2
G53 G0 Z0
M30
O100
G91
G1 X5. F300.
G90
M99
%
";

#[test]
fn a_program_in_the_words_of_the_other_language() {
    let old = job(BRACKET, wide("fanuc-30i"));
    let found = converted(&old, "sinumerik-mill");
    assert!(found.holds(), "{}\n{}", verdict(&found), found.text);
    insta::assert_snapshot!(found.text);
    let middle = job(&found.text, found.machine.clone());
    let back = convert(&middle, old.machine(), &ConversionOptions::default());
    assert!(back.holds(), "{}\n{}", verdict(&back), back.text);
    insta::assert_snapshot!(back.text);
}

/// Each change of the new program is seen by the proof.
#[test]
fn the_proof_sees_changes() {
    let old = job(BRACKET, wide("fanuc-30i"));
    let found = converted(&old, "sinumerik-mill");
    let changes = [
        // The length of a tool, and its radius.
        ("Z50 D1", "Z50 D0"),
        ("SUPA G0 Z0 D0", "SUPA G0 Z0"),
        ("SUPA G0 Z0 D0", "G0 Z0"),
        ("SUPA G0 Z0 D0", "SUPA G0 Z1 D0"),
        ("G41", "G42"),
        ("T2 M6", "T3 M6"),
        // Offsets, units, feeds, speeds, times.
        ("G55", "G54"),
        ("G508", "G507"),
        ("G710", "G700"),
        ("F500", "F501"),
        ("S1200", "S1201"),
        ("G4 F0.5", "G4 F0.6"),
        ("G4 F0.5", "G4 S0.5"),
        // Arcs and holes.
        ("G3 X50 Y10 I0 J10", "G2 X50 Y10 I0 J10"),
        ("G3 I-10 J0", "G3 I-10.02 J0"),
        ("CYCLE81(30,2,0,-5)", "CYCLE81(30,2,0,-5.01)"),
        ("CYCLE81(30,2,0,-5)", "CYCLE81(25,2,0,-5)"),
        ("CYCLE81(30,2,0,-5)", "CYCLE81(30,2,1,-5)"),
        ("CYCLE82(2,2,0,-5,,0.3)", "CYCLE82(2,2,0,-5,,0.4)"),
        (",1,0,500)", ",1.25,0,500)"),
        (",1,0,500)", ",-1,0,500)"),
        ("M8", "M7"),
        ("M9", ""),
    ];
    assert_changes_are_seen(&old, &found, &changes);
}

/// The new text is proved, and with each of these changes it is not.
pub(super) fn assert_changes_are_seen(old: &Job, found: &Conversion, changes: &[(&str, &str)]) {
    let options = ConversionOptions::default();
    let holds = |text: String| {
        let proof = chordal_rewrite::convert::prove_text(old, found, text, &options);
        proof.expect("a machine of the control").holds()
    };
    assert!(holds(found.text.clone()), "{}", found.text);
    for (before, after) in changes {
        assert!(found.text.contains(before), "{before} is not in\n{}", found.text);
        assert!(!holds(found.text.replacen(before, after, 1)), "{before} -> {after}");
    }
}

/// What is refused, each with its sentence.
#[test]
fn refusals_have_a_sentence() {
    let reason = |text: &str, from: &str, to: &str| {
        let found = converted(&job(text, wide(from)), to);
        assert!(!found.holds() && found.text.is_empty(), "{text}\n{}", found.text);
        found.refusals[0].reason.clone()
    };
    let to = |text: &str| reason(text, "fanuc-30i", "sinumerik-mill");
    let from = |text: &str| reason(text, "sinumerik-mill", "haas-vf2");
    let mut table = String::new();
    for text in [
        "G21 G91 S900 M3\nG0 X5. Z5.\nG90 G1 X0 F100.\nM30\n",
        "G21 G90 G54 S900 M3\nG0 X0 Y0 Z5.\n/G1 X10. F100.\nM30\n",
        "G21 G90 G54 T2 M6\nS900 M3\nG0 X0 Y0\nG43 H12 Z5.\nG1 X10. F100.\nM30\n",
        "G21 G90 G54 T2 M6\nS900 M3\nG0 X0 Y0\nG43 H2 Z5.\nG1 G41 D5 X10. Y10. F100.\nG40 X20.\nM30\n",
        "G21 G90 G54 S900 M3\nG0 X0 Y0 Z5.\nG10 L2 P1 X5.\nG1 X10. F100.\nM30\n",
        "G21 G90 G54 S900 M3\nG0 X0 Y0 Z5.\nG1 X#500 F100.\nM30\n",
        "G21 G90 G54 S900 M3\nG0 X0 Y0 Z5.\nG92 X10.\nG1 X#5021 F100.\nM30\n",
        "G21 G90 G54 S900 M3\nG0 X0 Y0 Z5.\nG1 X0 A10. F100.\nM30\n",
    ] {
        table += &format!("{text}    {}\n", to(text));
    }
    for text in [
        "G90 G54 S900 M3\nG0 X0 Y0 Z5\nG451 G41 G1 X10 F100\nM30\n",
        "T=\"MILL\" M6\nG90 G54 S900 M3\nG0 X0 Y0 Z5\nG1 X10 F100\nM30\n",
        "T1 M6\nG90 G54 S900 M3\nG0 X0 Y0 Z5\nSUPA Z0\nM30\n",
        "G90 G500 S900 M3\nG0 X0 Y0 Z5\nG1 X10 F100\nM30\n",
        "G90 G54 S900 M3\nG0 X0 Y0 Z5\nG1 X=R5 F100\nM30\n",
    ] {
        table += &format!("{text}    {}\n", from(text));
    }
    insta::assert_snapshot!(table);
}
