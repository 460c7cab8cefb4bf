//! Canned cycles of each control on each other one: which stay, and what is told of their pecks.

use chordal::control::CycleKind::{self, *};
use chordal::control::{Action, ControlTable, table};
use chordal::{Command, CommandKind, Diagnostic, Job, Sink};
use chordal_compare::compare;
use chordal_rewrite::convert::{Conversion, ConversionOptions, convert};

use super::{MACHINES, job, machine, verdict};

/// A form of a cycle: the control it is for (all where none), the kind, the words after the code, and the
/// blocks after it.
struct Form {
    on: &'static [&'static str],
    kind: CycleKind,
    words: &'static str,
    more: &'static str,
}

const ALL: &[&str] = &[];
const FADAL: &str = "fadal-4020";
const HAAS: &str = "haas-vf2";
const FANUC: &str = "fanuc-30i";
const MITSUBISHI: &str = "mitsubishi-m700";
const LINUXCNC: &str = "linuxcnc-mill";
/// Those whose P without a point is milliseconds.
const ISO: &[&str] = &[FADAL, HAAS, FANUC, MITSUBISHI];

const fn form(
    on: &'static [&'static str],
    kind: CycleKind,
    words: &'static str,
    more: &'static str,
) -> Form {
    Form { on, kind, words, more }
}

const FORMS: &[Form] = &[
    form(ALL, Drill, "G98 X1. Y0. Z-.5 R F10.", "X2.\nX3."),
    form(ALL, Drill, "G99 X1. Y0. Z-.5 R F10.", "X2.\nY1."),
    form(ALL, Drill, "G99 X1. Y0. Z-.5 R F10.", "G91 X.5 {repeat}3\nG90"),
    form(&[HAAS, FANUC, MITSUBISHI, LINUXCNC], Drill, "G91 G98 X1. Y0. Z-.6 R-.9 F10.", "X.5\nG90"),
    form(ISO, DrillDwell, "G98 X1. Y0. Z-.5 R P500 F10.", "X2."),
    form(&[LINUXCNC], DrillDwell, "G98 X1. Y0. Z-.5 R P.5 F10.", "X2."),
    form(ALL, Peck, "G98 X1. Y0. Z-1. R Q.3 F10.", "X2.\nX3."),
    form(ALL, Peck, "G99 X1. Y0. Z-1. R Q.3 F10.", "X2."),
    form(ALL, Peck, "G99 X1. Y0. Z-1. R Q.3 F10.", "G91 X.5 {repeat}3\nG90"),
    form(ALL, Peck, "G99 X1. Y0. Z-1. R Q2. F10.", "X2."),
    form(&[HAAS, FADAL], Peck, "G98 X1. Y0. Z-1. R I.4 J.1 K.15 F10.", "X2."),
    form(&[HAAS], Peck, "G98 X1. Y0. Z-1. R Q.3 P500 F10.", "X2."),
    form(ALL, ChipBreak, "G98 X1. Y0. Z-1. R Q.3 F10.", "X2."),
    form(&[FADAL], ChipBreak, "G98 X1. Y0. Z-1. R Q.3 P.03 F10.", "X2."),
    form(&[HAAS], ChipBreak, "G98 X1. Y0. Z-1. R Q.2 K.4 F10.", "X2."),
    form(&[HAAS, FADAL], ChipBreak, "G98 X1. Y0. Z-1. R I.4 J.1 K.15 F10.", "X2."),
    form(&[MITSUBISHI], ChipBreak, "G98 X1. Y0. Z-1. R Q.3 P500 F10.", "X2."),
    form(ALL, BoreFeedOut, "G98 X1. Y0. Z-.5 R F10.", "X2."),
    form(ISO, BoreDwell, "G99 X1. Y0. Z-.5 R P500 F10.", "X2."),
    form(ISO, BoreDwell, "G98 X1. Y0. Z-.5 R P500 F10.", "X2."),
    form(&[FADAL, HAAS, FANUC], BoreStop, "G98 X1. Y0. Z-.5 R F10.", "X2."),
    form(&[MITSUBISHI], BoreStop, "G98 X1. Y0. Z-.5 R P500 F10.", "X2."),
    form(&[LINUXCNC], BoreStop, "G98 X1. Y0. Z-.5 R P.5 F10.", "X2."),
    form(&[FADAL, HAAS, FANUC], FineBore, "G98 X1. Y0. Z-.5 R Q.02 F10.", "X2."),
    form(&[HAAS], FineBore, "G98 X1. Y0. Z-.5 R I.02 J0. F10.", "X2."),
    form(&[MITSUBISHI], FineBore, "G98 X1. Y0. Z-.5 R I.02 J0. F10.", "X2."),
    form(&[HAAS, FANUC], BackBore, "G98 X1. Y0. Z-.5 R-1. Q.02 F10.", "X2."),
    form(&[HAAS, FANUC, MITSUBISHI], Tap, "G98 X1. Y0. Z-.5 R F50.", "X2."),
    form(&[LINUXCNC], Tap, "G99 X1. Y0. Z-.5 R F50.", "X2."),
    form(&[FADAL], Tap, "G98 X1. Y0. Z-.5 R F1000. Q.05", "X2."),
];

fn code(kind: CycleKind, table: &ControlTable) -> Option<String> {
    let row = table.g_codes.iter().find(|row| row.action == Action::Cycle(kind))?;
    Some(row.name(b'G'))
}

fn program(on: &str, form: &Form) -> Option<String> {
    let table = table(machine(on).control).expect("a table");
    let code = code(form.kind, table)?;
    let r = if on == FADAL { "R0+.1" } else { "R.1" };
    let words = form.words.replace(" R ", &format!(" {r} "));
    let more = form.more.replace("{repeat}", if on == FANUC { "K" } else { "L" });
    let offset = if on == FADAL { "E1" } else { "G54" };
    Some(format!(
        "G20 G90 G17\n{offset}\nT1 M6\nS1000 M3\nG0 X0. Y0.\nZ1.\n{code} {words}\n{more}\nG80\nG0 Z2.\nM2\n"
    ))
}

/// How many cuts canned cycles made.
#[derive(Default)]
struct Cuts(u32);

impl Sink for Cuts {
    fn command(&mut self, command: &Command) {
        self.0 +=
            u32::from(command.origin.cycle && matches!(command.kind, CommandKind::Line { .. }));
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl chordal::RunSink for Cuts {}

fn cuts(job: &Job) -> u32 {
    let mut cuts = Cuts::default();
    job.run(&mut cuts);
    cuts.0
}

fn became(found: &Conversion) -> String {
    if !found.holds() {
        return verdict(found);
    }
    let new = found.job("new").expect("a job");
    if cuts(&new) == 0 { "written out".into() } else { "kept".into() }
}

fn each(mut look: impl FnMut(&Form, &str, &Job, &str)) {
    for form in FORMS {
        for on in MACHINES.iter().filter(|on| form.on.is_empty() || form.on.contains(on)) {
            let Some(text) = program(on, form) else { continue };
            let old = job(&text, machine(on));
            for to in MACHINES.iter().filter(|to| *to != on) {
                look(form, on, &old, to);
            }
        }
    }
}

#[test]
fn each_cycle_on_each_control() {
    let mut table = String::new();
    let mut last = String::new();
    each(|form, on, old, to| {
        let found = convert(old, &machine(to), &ConversionOptions::default());
        let head =
            format!("{} {} | {}", form.kind_name(), form.words, form.more.replace('\n', " | "));
        if head != last {
            table += &format!("{head}\n");
            last = head;
        }
        table += &format!("    {on} to {to}: {}\n", became(&found));
        // The other blocks are as the first.
        if let Some(change) = found.pecks.first() {
            let side = |side: usize| {
                let one = &change.readings[side];
                let length = |mm: Option<f64>| mm.map_or("-".into(), |mm| format!("{mm:.3}"));
                format!(
                    "{} pecks of {:.3} mm, back to {} above ({}), {} above R",
                    one.pecks,
                    one.largest_step_mm,
                    length(one.clearance_mm),
                    one.clearance_setting.unwrap_or("-"),
                    length(one.above_r_mm.filter(|mm| *mm > 1e-6)),
                )
            };
            table += &format!(
                "        line {} to {}, {} {}: {} / {}\n",
                change.lines[0],
                change.lines[1],
                change.cycle,
                change.holes,
                side(0),
                side(1)
            );
        }
    });
    insta::assert_snapshot!(table);
}

impl Form {
    fn kind_name(&self) -> String {
        format!("{:?}", self.kind)
    }
}

/// The whole comparison of both runs differs only in blocks whose pecks are told; where none are told, in
/// nothing.
#[test]
fn nothing_but_the_told_pecks_differs() {
    let mut told = 0;
    each(|form, on, old, to| {
        let found = convert(old, &machine(to), &ConversionOptions::default());
        if !found.holds() {
            return;
        }
        let new = found.job("new").expect("a job");
        let options = chordal_compare::ComparisonOptions {
            tolerance_mm: 0.005,
            feed_tolerance: 1e-5,
            assume_known: true,
            ..Default::default()
        };
        let whole = compare(old, &new, &options);
        let of_machines: Vec<_> = found
            .certificate
            .iter()
            .flat_map(|one| &one.expected)
            .map(|one| one.category)
            .collect();
        let lines: Vec<u32> = found.pecks.iter().map(|change| change.lines[0]).collect();
        for difference in &whole.differences {
            let (from, to_line) = difference.blocks[0].expect("a block of the old text").lines();
            let is_told = lines.iter().any(|line| (from..=to_line).contains(line));
            assert!(
                is_told || of_machines.contains(&difference.category),
                "{on} to {to}, {:?} {}: {difference:?}\n{}",
                form.kind,
                form.words,
                found.text
            );
        }
        told += found.pecks.len();
    });
    assert!(told > 50, "{told}");
}

#[test]
fn exact_cycles_make_the_same_moves() {
    let exact = ConversionOptions { exact_cycles: true, ..ConversionOptions::default() };
    each(|form, on, old, to| {
        let found = convert(old, &machine(to), &exact);
        assert!(found.pecks.is_empty());
        let default = convert(old, &machine(to), &ConversionOptions::default());
        assert_eq!(found.holds(), default.holds(), "{on} to {to}: {:?} {}", form.kind, form.words);
        // What needs no word about its pecks is the same text with and without; of pecks this is known before
        // the run only where the settings are the same.
        let has_same_lifts = [on, to].iter().all(|name| [FANUC, MITSUBISHI].contains(name));
        let is_settled = !form.kind.is_peck() || has_same_lifts;
        if default.holds() && default.pecks.is_empty() && is_settled {
            assert_eq!(found.text, default.text, "{on} to {to}: {:?} {}", form.kind, form.words);
        }
    });
}
