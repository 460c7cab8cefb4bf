//! Part programs that are cut up, mixed and mistyped run to an end: no crash, no hang, no place outside of the text.
//! `CHORDAL_RANDOM_SECONDS=600` goes on for that long with other programs.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use chordal::diagnostics::FileId;
use chordal::{Job, Machine, RunOptions, Source, SourceMap};

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
