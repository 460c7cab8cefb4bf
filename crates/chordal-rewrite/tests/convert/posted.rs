//! Programs to and from a language that is not word-address: by their run, there and back.

use chordal::{Job, Machine};
use chordal_rewrite::convert::{Conversion, ConversionOptions, convert};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use super::random::{Piece, piece, program};
use super::{converted, job, job_of, machine, suite_programs, text_of, verdict};

/// What a program came to on the way there and back again.
struct RoundTrip {
    there: Conversion,
    back: Option<Conversion>,
}

impl RoundTrip {
    fn of(old: &Job) -> RoundTrip {
        let there = converted(old, "sinumerik-mill");
        let middle = there.holds().then(|| job(&there.text, there.machine.clone()));
        let back =
            middle.map(|middle| convert(&middle, old.machine(), &ConversionOptions::default()));
        RoundTrip { there, back }
    }

    fn holds(&self) -> [bool; 2] {
        [self.there.holds(), self.back.as_ref().is_some_and(Conversion::holds)]
    }

    fn verdict(&self) -> String {
        match &self.back {
            Some(back) => format!("{}; back {}", verdict(&self.there), verdict(back)),
            None => verdict(&self.there),
        }
    }

    /// Nothing that is not proved is left without a sentence.
    fn is_proved_or_refused(&self) -> bool {
        let is_answered = |found: &Conversion| found.holds() || !found.refusals.is_empty();
        is_answered(&self.there) && self.back.as_ref().is_none_or(is_answered)
    }
}

#[test]
fn programs_of_the_suite() {
    let folders = ["fanuc", "haas", "mitsubishi", "linuxcnc", "fadal", "textbook"];
    let mut table = String::new();
    let (mut there_holds, mut back_holds, mut all) = (0, 0, 0);
    for path in suite_programs(&folders) {
        let trip = RoundTrip::of(&job_of(&text_of(&path), &[]));
        let [there, back] = trip.holds();
        all += 1;
        there_holds += usize::from(there);
        back_holds += usize::from(back);
        table += &format!("{path}\n    {}\n", trip.verdict());
    }
    table += &format!("\n{there_holds} of {all} proved, {back_holds} of them back again\n");
    insta::assert_snapshot!(table);
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
        main.extend((0..3).map(|sub| Piece::Call(sub, 1)));
        // The machine has three axes.
        let has_axis = |piece: &Piece| !matches!(piece, Piece::Turn(..));
        main.retain(has_axis);
        let subs: Vec<Vec<Piece>> =
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
fn with_lengths(text: &str) -> String {
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
fn wide(control: &str) -> Machine {
    let mut own = machine(control);
    own.axes.iter_mut().flatten().for_each(|axis| axis.travel = None);
    own.feed = Default::default();
    for tool in 1..10 {
        own.set(&format!("tools.{tool}.diameter=\"0.1 in\"")).expect("a good assignment");
    }
    own
}
