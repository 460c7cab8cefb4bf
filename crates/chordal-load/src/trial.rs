//! Where the signs do not decide: short runs on the controls that may be meant, and their errors counted.

use chordal::control::{ANOTHER_KIND, Candidate, Recognition, RunOptions, Strength};
use chordal::machine::ControlName;
use chordal::{Code, Job, Machine, Severity, Source, SourceMap};

use crate::text::whole_lines;

/// So much of the beginning is run, bytes: some thousand blocks.
const HEAD: usize = 32 << 10;

/// Repeated blocks in each of these runs.
const MOST_REPEATED: u64 = 2_000;

/// A control that nothing speaks for must save so many errors to be assumed instead.
const WORTH: u64 = 3;

/// Runs the beginning of a text on the controls that may be meant, where the signs do not decide; `typical`
/// makes the machine of a control.
pub fn settle(
    mut found: Recognition,
    text: &[u8],
    typical: fn(ControlName) -> Machine,
) -> Recognition {
    if found.is_decided() {
        return found;
    }
    let weak = found.strength() == Strength::Weak;
    let head = whole_lines(text, HEAD);
    let first = errors_of(&mut found.ranking[0], head, typical);
    // With no error there is nothing to save: most programs end here.
    if first == 0 {
        return found;
    }
    let least =
        if weak { found.chosen().weight - chordal::control::recognition::LEAD } else { i32::MIN };
    let others = found.ranking.iter_mut().skip(1);
    let may_be = |other: &&mut Candidate| !other.not_read && other.weight > least.max(ANOTHER_KIND);
    for other in others.filter(may_be) {
        errors_of(other, head, typical);
    }
    found.ranking[1..].sort_by_key(|other| other.errors.unwrap_or(u64::MAX));
    let enough = if weak { 1 } else { WORTH };
    let better = |other: &&Candidate| {
        let errors = other.errors.unwrap_or(u64::MAX);
        errors.saturating_add(enough) <= first && errors <= first / 3
    };
    if let Some(name) = found.ranking.get(1).filter(better).map(|other| other.name) {
        found.choose(name);
    }
    found
}

fn errors_of(candidate: &mut Candidate, text: &[u8], typical: fn(ControlName) -> Machine) -> u64 {
    let errors = errors_on(typical(candidate.control), text);
    candidate.errors = Some(errors);
    errors
}

/// Errors that say something about the control: not those of files that are not there.
fn errors_on(machine: Machine, text: &[u8]) -> u64 {
    let mut sources = SourceMap::new();
    sources.add(Source::new("", text));
    let options = RunOptions {
        max_repeated_blocks: MOST_REPEATED,
        assumed_machine: true,
        ..RunOptions::default()
    };
    let Ok(job) = Job::new(sources, machine) else { return u64::MAX };
    let report = job.options(options).check();
    let elsewhere = report.diagnostics.iter().filter(|diagnostic| {
        diagnostic.severity == Severity::Error
            && matches!(diagnostic.code, Code::MissingSubprogram | Code::BudgetReached)
    });
    report.counts.errors - elsewhere.count() as u64
}
