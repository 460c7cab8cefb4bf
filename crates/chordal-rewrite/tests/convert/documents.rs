//! Every program of the documents on every other control: clean there, the same motion, and a list of
//! changes that a person can read.

use std::collections::BTreeSet;

use chordal::Severity;
use chordal_rewrite::convert::{ConversionOptions, convert};

use super::{MACHINES, converted, job_of, text_of, verdict};

/// The programs, each in the form that runs on its own control, and what the machine needs to know.
const PROGRAMS: &[(&str, &[&str])] = &[
    ("tests/suite/fadal/bore.nc", &[]),
    ("tests/suite/fadal/boss.nc", &[]),
    ("tests/suite/fadal/slot.nc", &[]),
    ("tests/suite/fadal/quadrants.nc", &[]),
    ("tests/suite/fadal/r0-arcs.nc", &[]),
    ("tests/suite/fadal/partial-helices.nc", &[]),
    ("tests/suite/fadal/repeats.nc", &[]),
    ("tests/suite/fadal/od-thread.nc", &[]),
    ("tests/suite/fadal/id-thread.nc", &[]),
    ("tests/suite/fadal/g18-g90.nc", &[]),
    ("tests/suite/fadal/g18-g91.nc", &[]),
    ("tests/suite/fadal/g19-g90.nc", &[]),
    ("tests/suite/fadal/g19-g91.nc", &[]),
    ("tests/suite/fadal/subprograms.nc", &[]),
    ("tests/suite/fadal/subroutines.nc", &["tools.1.diameter=\"0.5 in\""]),
    ("tests/suite/haas/O60021.nc", &[]),
    ("tests/suite/haas/O60022.nc", &[]),
    ("tests/suite/haas/O60023.nc", &[]),
    ("tests/suite/haas/O60024.nc", &[]),
    ("tests/suite/haas/O60025.nc", &[]),
    ("tests/suite/haas/O60131.nc", &[]),
    ("tests/suite/textbook/corner-absolute.nc", &[]),
    ("tests/suite/textbook/corner-from-center.nc", &[]),
    ("tests/suite/textbook/corner-radius.nc", &[]),
    ("tests/suite/textbook/corner-to-center.nc", &[]),
    ("tests/suite/textbook/offsets-path.nc", &[]),
    ("tests/suite/textbook/plane-codes.nc", &[]),
    ("examples/textbook/switch-housing.nc", &[]),
    ("tests/suite/mitsubishi/turns.nc", &[]),
    ("tests/suite/mitsubishi/semicircle.nc", &[]),
    ("examples/mitsubishi/cone.nc", &[]),
    ("examples/mitsubishi-type2/cone.nc", &["name=\"mitsubishi-m700-type2\""]),
];

#[test]
fn every_program_on_every_control() {
    for (path, set) in PROGRAMS {
        let text = text_of(path);
        let text = with_folder_machine(path, text);
        let set: Vec<&str> = set.iter().copied().filter(|set| !set.starts_with("name")).collect();
        let old = job_of(&text, &set);
        let own = old.machine().control;
        let mut page = String::new();
        for to in MACHINES.iter().filter(|to| super::machine(to).control != own) {
            let found = converted(&old, to);
            assert!(found.holds(), "{path} on {to}: {}", verdict(&found));
            let new = found.job("converted").expect("a job");
            let errors = new.check().diagnostics.into_iter().filter(|one| {
                one.severity == Severity::Error
                    && !found.certificate.as_ref().is_some_and(|certificate| {
                        certificate.expected.iter().any(|expected| {
                            format!("{:?}", expected.values).contains(one.code.id())
                        })
                    })
            });
            let errors: Vec<String> = errors.map(|one| one.message).collect();
            assert_eq!(errors, Vec::<String>::new(), "{path} on {to}");
            page += &format!("==== {to}: {}\n", verdict(&found));
            for change in &found.changes {
                let (before, after) = (&change.before, change.after.replace('\n', " | "));
                page += &format!("{}: {before} -> {after}\n    {}\n", change.line, change.reason);
            }
            page += &format!("----\n{}\n", found.text);
            // Back again: the same motion as at the beginning.
            let twice = ConversionOptions { tolerance_mm: 0.01, ..ConversionOptions::default() };
            let back = convert(&new, old.machine(), &twice);
            assert!(
                back.certificate.as_ref().is_some_and(|certificate| certificate.holds()),
                "{path} from {to} back: {}",
                verdict(&back)
            );
        }
        let name = path.trim_start_matches("tests/suite/").replace(['/', '.'], "-");
        insta::assert_snapshot!(name, page);
    }
}

/// Without the mark of the block's end, which begins a comment on some controls.
fn bare(line: &str) -> String {
    line.replace(" ;", "").trim_end().to_string()
}

fn without_comment(line: &str) -> String {
    bare(line.split('(').next().unwrap_or_default())
}

/// Examples say their machine in their folder, not in their text.
fn with_folder_machine(path: &str, text: String) -> String {
    if !path.starts_with("examples/") || text.contains("(machine: ") {
        return text;
    }
    let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
    let file = text_of(&format!("{folder}/chordal.toml"));
    let name = file.split('"').nth(1).expect("a machine");
    format!("(machine: {name})\n{text}")
}

/// There and back: lines that no change is listed for, on either way, are the lines of the beginning.
#[test]
fn unlisted_lines_come_back_as_they_were() {
    let (mut lines, mut same) = (0, 0);
    for (path, set) in PROGRAMS {
        let text = with_folder_machine(path, text_of(path));
        let set: Vec<&str> = set.iter().copied().filter(|set| !set.starts_with("name")).collect();
        let old = job_of(&text, &set);
        for to in MACHINES.iter().filter(|to| super::machine(to).control != old.machine().control) {
            let there = converted(&old, to);
            let new = there.job("converted").expect("a job");
            let twice = ConversionOptions { tolerance_mm: 0.01, ..ConversionOptions::default() };
            let back = convert(&new, old.machine(), &twice);
            let listed = |change: &chordal_rewrite::Change| change.line as usize;
            let gone: BTreeSet<usize> = there.changes.iter().map(listed).collect();
            let changed: BTreeSet<usize> = back.changes.iter().map(listed).collect();
            let kept = |text: &str, listed: &BTreeSet<usize>| -> Vec<String> {
                let lines = text.lines().enumerate();
                let lines =
                    lines.filter(|(at, line)| !line.is_empty() && !listed.contains(&(at + 1)));
                lines.map(|(_, line)| bare(line)).collect()
            };
            // Each text has the unlisted lines of the one before it; so the last has those of the first that are
            // listed on neither way.
            for (old, listed, new) in
                [(&text, &gone, &there.text), (&there.text, &changed, &back.text)]
            {
                // Sections change their places, so that only the lines themselves count.
                let mut new: Vec<String> = new.lines().map(bare).collect();
                for line in kept(old, listed) {
                    let at = new.iter().position(|one| *one == line);
                    let at = at.unwrap_or_else(|| {
                        panic!("{path} to {to}: `{line}` is not there, and no change is listed")
                    });
                    new.swap_remove(at);
                }
            }
            let all: Vec<&str> = text.lines().filter(|line| !line.is_empty()).collect();
            let mut end: Vec<String> = back.text.lines().map(bare).collect();
            // What one control switches after a motion and the other before it stands in a block of its own since.
            let words: Vec<String> = end.iter().map(|line| without_comment(line)).collect();
            let mut divided: Vec<String> = words.windows(2).map(|two| two.join(" ")).collect();
            lines += all.len();
            for line in &all {
                if let Some(at) = end.iter().position(|one| *one == bare(line)) {
                    end.swap_remove(at);
                    same += 1;
                } else if let Some(at) =
                    divided.iter().position(|one| *one == without_comment(line))
                {
                    divided.swap_remove(at);
                    same += 1;
                }
            }
        }
    }
    assert!(same * 100 >= lines * 82, "{same} of {lines} lines");
}
