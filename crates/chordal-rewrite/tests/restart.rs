//! Programs that begin at one of their lines: every line is proved, or refused with a reason.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use chordal::control::RunOptions;
use chordal::{Job, Machine, Source, SourceMap};
use chordal_rewrite::restart::{Reason, restart};

fn job_on(text: &str, machine: Machine) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    let options = RunOptions { max_repeated_blocks: 2_000, ..RunOptions::default() };
    Job::new(sources, machine).expect("good settings").options(options)
}

fn job(text: &str, machine: &str) -> Job<'static> {
    job_on(text, Machine::from_builtin(machine).expect("a built-in machine"))
}

/// The text of the program that begins at a line.
fn begun(text: &str, machine: &str, line: u32) -> String {
    let done = restart(&job(text, machine), line).expect("proved");
    String::from_utf8(done.text).expect("text")
}

fn refused(text: &str, line: u32) -> (Reason, String) {
    let refused = restart(&job(text, "haas-vf2"), line).expect_err("refused");
    (refused.reason, format!("{}; {}", refused.refusal.what, refused.refusal.help))
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "nc" || ending == "ngc") {
            found.push(path);
        }
    }
}

/// The job of a program on the machine that its remarks or its folder say.
fn job_of(path: &Path) -> Option<Job<'static>> {
    let text = String::from_utf8_lossy(&std::fs::read(path).expect("a program")).into_owned();
    let remark = |mark: &str| text.split_once(mark)?.1.split(')').next();
    let beside = std::fs::read_to_string(path.with_file_name("chordal.toml")).unwrap_or_default();
    let name = remark("(machine: ").or_else(|| beside.split('"').nth(1))?;
    let mut machine = Machine::from_builtin(name).ok()?;
    for (_, rest) in text.match_indices("(set: ").map(|(at, mark)| text.split_at(at + mark.len())) {
        let assignment = rest.lines().next()?.trim_end().strip_suffix(')')?;
        machine.set(assignment).ok()?;
    }
    Some(job_on(&text, machine))
}

#[test]
fn every_line_is_proved_or_refused_with_a_reason() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut paths = Vec::new();
    files(&root.join("examples"), &mut paths);
    files(&root.join("tests/suite"), &mut paths);
    let (mut proved, mut controls) = (0, BTreeMap::<String, [u32; 2]>::new());
    let mut reasons = BTreeMap::<Reason, u32>::new();
    let mut messages = BTreeMap::<String, u32>::new();
    for path in &paths {
        let Some(job) = job_of(path) else { continue };
        let text = job.sources().get(Default::default()).expect("a text").text().to_vec();
        let lines = text.split(|byte| *byte == b'\n').count() as u32;
        let counts = controls.entry(job.control().table.title.to_string()).or_default();
        for line in 1..=lines {
            match restart(&job, line) {
                Ok(done) => {
                    proved += 1;
                    counts[0] += 1;
                    // What follows is the old text, byte for byte.
                    let from = text.split(|byte| *byte == b'\n').skip(line as usize - 1);
                    let rest: Vec<&[u8]> = from.collect();
                    let rest = rest.join(&b'\n');
                    let rest = rest.trim_ascii_start();
                    assert!(done.text.ends_with(rest), "{}:{line}", path.display());
                }
                Err(refused) => {
                    counts[1] += 1;
                    *reasons.entry(refused.reason).or_default() += 1;
                    let told = &refused.refusal;
                    assert!(!told.what.is_empty() && !told.help.is_empty());
                    if matches!(refused.reason, Reason::Unproved | Reason::Form) {
                        let name = path.file_name().unwrap_or_default().to_string_lossy();
                        if std::env::var_os("SHOWN").is_some() {
                            println!("{name}:{line}: {}", told.what);
                        }
                        *messages
                            .entry(told.what.split(": ").last().unwrap_or("").into())
                            .or_default() += 1;
                    }
                }
            }
        }
    }
    println!("{} programs, {proved} lines proved", paths.len());
    controls.iter().for_each(|(name, [yes, no])| println!("  {name}: {yes} proved, {no} refused"));
    reasons.iter().for_each(|(reason, count)| println!("  refused, {reason:?}: {count}"));
    messages.iter().for_each(|(what, count)| println!("    {count} {what}"));
    assert!(controls.len() >= 5 && controls.values().all(|[yes, _]| *yes > 0));
}
