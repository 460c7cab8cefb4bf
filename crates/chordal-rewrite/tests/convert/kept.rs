//! How many blocks of canned cycles stay canned cycles, over all programs of the repository.

use chordal::control::{Action, AfterBlock, Origin};
use chordal::{Command, Diagnostic, Job, RunSink, Sink};

use super::{MACHINES, converted, job_of, suite_programs, text_of};

/// How often a block drilled by a cycle.
#[derive(Default)]
struct Drilled {
    blocks: u32,
    open: bool,
}

impl Sink for Drilled {
    fn command(&mut self, command: &Command) {
        self.open |= command.origin.cycle && command.kind.motion().is_some();
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for Drilled {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, _: &Origin, after: &AfterBlock) {
        let motion = (after.modal)().motion;
        let in_cycle = motion.is_some_and(|motion| Action::from(motion).cycle().is_some());
        self.blocks += u32::from(std::mem::take(&mut self.open) && in_cycle);
    }
}

fn drilled(job: &Job) -> u32 {
    let mut drilled = Drilled::default();
    job.run(&mut drilled);
    drilled.blocks
}

/// Blocks that drill by cycles in all programs, and how many of them do so after the conversion to another
/// control, where it is proved.
#[test]
fn cycles_that_stay() {
    let (mut kept, mut out, mut refused) = (0, 0, 0);
    let folders = ["fadal", "haas", "fanuc", "mitsubishi", "linuxcnc", "textbook"];
    for path in suite_programs(&folders) {
        let old = job_of(&text_of(&path), &[]);
        let before = drilled(&old);
        if before == 0 {
            continue;
        }
        for to in MACHINES.iter().filter(|to| super::machine(to).control != old.machine().control) {
            let found = converted(&old, to);
            let new = found.job("new").filter(|_| found.holds());
            match new.map(|new| drilled(&new).min(before)) {
                None => refused += before,
                Some(stay) => {
                    kept += stay;
                    out += before - stay;
                }
            }
        }
    }
    insta::assert_snapshot!(format!(
        "blocks that drill by a cycle, for each other control\n\
         kept as cycles: {kept}\nwritten out: {out}\nin programs that are refused: {refused}\n"
    ));
}
