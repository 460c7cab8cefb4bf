//! Part programs that are cut up, mixed and mistyped run to an end: no crash, no hang, no place outside of the text.
//! `CHORDAL_RANDOM_SECONDS=600` goes on for that long with other programs.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use chordal::control::Origin;
use chordal::diagnostics::FileId;
use chordal::path::PathCommand;
use chordal::{Diagnostic, Job, Machine, PathSink, RunOptions, Source, SourceMap};

/// Programs of one run of the tests.
const PROGRAMS: u32 = 1_500;

/// The lines of all programs of the sets.
fn lines() -> Vec<Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../chordal-sinumerik/tests/programs");
    let mut lines = Vec::new();
    for part in ["clean", "faults", "second/clean", "second/clean_lathe", "second/faults"] {
        let mut files: Vec<_> = fs::read_dir(root.join(part))
            .expect("the programs")
            .map(|entry| entry.expect("a file").path())
            .collect();
        files.sort();
        for file in files {
            let text = fs::read(file).expect("a program");
            lines.extend(text.split(|byte| *byte == b'\n').map(<[u8]>::to_vec));
        }
    }
    lines
}

/// A generator of numbers: SplitMix64.
struct RandomNumbers(u64);

impl RandomNumbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, most: usize) -> usize {
        (self.next() % most.max(1) as u64) as usize
    }
}

/// A program of runs of lines from several programs, with some bytes changed, lost or doubled.
fn program(lines: &[Vec<u8>], random: &mut RandomNumbers) -> Vec<u8> {
    let mut text = Vec::new();
    for _ in 0..1 + random.below(6) {
        let start = random.below(lines.len());
        let count = 1 + random.below(12);
        for line in lines.iter().skip(start).take(count) {
            text.extend_from_slice(line);
            text.push(b'\n');
        }
    }
    const BYTES: &[u8] = b"0123456789.-+=()[]\"',;:<>XYZIJKRGMTDFSAP \n$_";
    for _ in 0..random.below(8) {
        let at = random.below(text.len());
        match random.below(4) {
            0 => text[at] = BYTES[random.below(BYTES.len())],
            1 => {
                text.remove(at);
            }
            2 => text.insert(at, BYTES[random.below(BYTES.len())]),
            _ => text[at] = random.next() as u8,
        }
        if text.is_empty() {
            break;
        }
    }
    text
}

fn run(text: &[u8], machine: &Machine) {
    let mut sources = SourceMap::new();
    sources.add(Source::new("random.mpf", text.to_vec()));
    let options = RunOptions { max_repeated_blocks: 5_000, ..RunOptions::default() };
    let job = Job::new(sources, machine.clone()).expect("a machine").options(options);
    for found in job.check().diagnostics {
        if found.primary.span.file == FileId(0) {
            let range = found.primary.span.range;
            assert!(range.start <= range.end && range.end as usize <= text.len(), "{found:?}");
        }
    }
    job.path(|segment| assert!(segment.duration_s.is_finite(), "{segment:?}"));
}

#[test]
fn mixed_and_mistyped_programs_end() {
    let lines = lines();
    let machines = ["sinumerik-mill", "sinumerik-lathe"]
        .map(|name| Machine::from_builtin(name).expect("a built-in machine"));
    let seconds = std::env::var("CHORDAL_RANDOM_SECONDS").ok().and_then(|text| text.parse().ok());
    let deadline = seconds.map(|seconds| Instant::now() + Duration::from_secs(seconds));
    let seed = if deadline.is_some() { u64::from(std::process::id()) << 20 } else { 1 };
    let mut count = 0_u64;
    while deadline.map_or(count < u64::from(PROGRAMS), |end| Instant::now() < end) {
        let mut random = RandomNumbers(seed + count);
        let text = program(&lines, &mut random);
        let machine = &machines[random.below(2)];
        let outcome = std::panic::catch_unwind(|| run(&text, machine));
        assert!(outcome.is_ok(), "{}\n(number {count})", String::from_utf8_lossy(&text));
        count += 1;
    }
    println!("{count} programs");
}

/// The commands of a program as text, without their places in the text.
fn commands(text: &str) -> Vec<String> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("plain.mpf", text.as_bytes().to_vec()));
    let machine = Machine::from_builtin("sinumerik-mill").expect("a machine");
    let job = Job::new(sources, machine).expect("a machine of this control");
    let mut sink = CommandTexts::default();
    job.compensated(None, &mut sink);
    sink.0
}

/// The commands as text.
#[derive(Default)]
struct CommandTexts(Vec<String>);

impl PathSink for CommandTexts {
    fn command(&mut self, path: PathCommand<'_>) {
        self.0.push(format!("{:?}", path.command.kind));
    }

    fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}
}

/// Lines of coordinates alone are read in a way of their own: a comment at their end, which leads to the other way, changes
/// nothing.
#[test]
fn plain_lines_do_what_all_lines_do() {
    let mut random = RandomNumbers(7);
    let heads = [
        "G90",
        "G91",
        "G70",
        "G700",
        "TRANS X5",
        "ROT RPL=30",
        "RNDM=1",
        "G41",
        "G95 S500 M3",
        "G2 X1 Y1 CR=9",
        "AP=20 RP=5",
        "SUPA Z0",
    ];
    for _ in 0..300 {
        let mut lines: Vec<String> =
            vec!["G17 G710 G54".into(), "T1 D1 M6".into(), "S1000 M3 F100".into()];
        for _ in 0..40 {
            if random.below(8) == 0 {
                lines.push(heads[random.below(heads.len())].into());
                continue;
            }
            let mut line = String::new();
            for (word, most) in [("N", 6), ("G", 3), ("X", 2), ("Y", 2), ("Z", 4), ("F", 6)] {
                if random.below(most) > 0 {
                    continue;
                }
                let number = random.below(100_000) as f64 / 1000.0 - 50.0;
                match word {
                    "N" => line += &format!("N{} ", random.below(1000)),
                    "G" => line += &format!("G{}", random.below(2)),
                    "F" => line += &format!(" F{}", 1 + random.below(900)),
                    axis => line += &format!("{axis}{number:.3} "),
                }
            }
            lines.push(line);
        }
        let plain = lines.join("\n");
        let commented: Vec<String> = lines.iter().map(|line| format!("{line} ;")).collect();
        assert_eq!(commands(&plain), commands(&commented.join("\n")), "{plain}");
    }
}
