//! What the targets that write programs share: words drawn from a list, so that nearly every
//! input is a program, and what must hold of every run.

use std::sync::OnceLock;

use chordal::machine::{Machine, builtin_names};
use chordal::{Job, Report, RunOptions, Source, SourceMap};
use chordal_geometry::AXES;

/// Every built-in machine with tools and offsets, so that nothing is left out for want of a
/// number.
#[allow(dead_code, reason = "not every target chooses among all machines")]
fn machines() -> &'static [Machine] {
    static MACHINES: OnceLock<Vec<Machine>> = OnceLock::new();
    MACHINES.get_or_init(|| {
        let given = [
            "tools.1.diameter=0.4 in",
            "tools.2.diameter=6 mm",
            "tools.3.diameter=-3 mm",
            "tools.1.length=2 in",
            "work_offsets.G54.X=1 in",
            "work_offsets.E1.Z=-3 in",
        ];
        let machines = builtin_names().iter().map(|name| {
            let mut machine = Machine::from_builtin(name).expect("a built-in machine");
            for assignment in given {
                machine.set(assignment).expect("a good assignment");
            }
            machine
        });
        machines.collect()
    })
}

/// Writes a program: each byte is a word of the list, after one that chooses the machine.
#[allow(dead_code, reason = "not every target draws its programs from words")]
pub fn program(bytes: &[u8], head: &str, words: &[&str]) -> Option<(Machine, String)> {
    let (choice, rest) = bytes.split_first()?;
    let machine = machines()[*choice as usize % machines().len()].clone();
    let mut text = String::from(head);
    for byte in rest.iter().take(400) {
        text += words[*byte as usize % words.len()];
    }
    Some((machine, text + "\nM30\n"))
}

/// Runs a program with every check; nothing may be out of place.
pub fn run(machine: Machine, text: &[u8]) -> Report {
    let mut sources = SourceMap::new();
    sources.add(Source::new("fuzz", text));
    let options = RunOptions { max_repeated_blocks: 2_000, ..RunOptions::default() };
    let job = Job::new(sources, machine).expect("a good machine").options(options);
    let report = job.report_with(|command, segments| {
        if let Some(motion) = command.kind.motion() {
            for axis in 0..AXES {
                assert!(motion.from[axis].is_finite() && motion.to[axis].is_finite());
            }
        }
        for segment in segments {
            assert!(segment.length_mm.is_finite(), "{command:?}");
            assert!(segment.duration_s.is_finite(), "{command:?}");
        }
    });
    for diagnostic in &report.diagnostics {
        let span = diagnostic.primary.span;
        let source = job.sources().get(span.file).expect("a file of the job");
        assert!(span.range.start <= span.range.end);
        assert!(span.range.end as usize <= source.text().len());
        assert!(!diagnostic.message.is_empty());
    }
    report
}

/// The same of a program drawn from words, which has no text that could look like a number gone
/// wrong.
#[allow(dead_code, reason = "not every target draws its programs from words")]
pub fn run_words(machine: Machine, text: &str) {
    for diagnostic in run(machine, text.as_bytes()).diagnostics {
        assert!(!diagnostic.message.contains("NaN") && !diagnostic.message.contains("inf "));
    }
}
