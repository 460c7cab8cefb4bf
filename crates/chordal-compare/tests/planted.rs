//! Changes one digit anywhere in a program: a different motion must be found at its place, and an equal motion must
//! compare as the same.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::path::{Path, PathBuf};

use chordal::{Job, Machine, Segment, Source, SourceMap};
use chordal_compare::{Category, ComparisonOptions, ComparisonVerdict, Difference, compare};

/// Examples with the machine of their folder.
fn examples() -> Vec<(PathBuf, &'static str)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let machines = [
        ("fadal", "fadal-4020"),
        ("haas", "haas-vf2"),
        ("fanuc", "fanuc-30i"),
        ("mitsubishi", "mitsubishi-m700"),
        ("linuxcnc", "linuxcnc-mill"),
    ];
    let mut all = Vec::new();
    for (folder, machine) in machines {
        let mut files: Vec<PathBuf> = std::fs::read_dir(root.join(folder))
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.extension().is_some_and(|ending| ending == "nc" || ending == "ngc"))
            .collect();
        files.sort();
        all.extend(files.into_iter().map(|file| (file, machine)));
    }
    all
}

fn job<'a>(text: &'a [u8], machine: &str) -> Job<'a> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text));
    Job::new(sources, Machine::from_builtin(machine).unwrap()).unwrap()
}

/// All segments, directly from the run.
fn segments(job: &Job) -> Vec<Segment> {
    let mut all = Vec::new();
    job.path(|segment| {
        if segment.length_mm > 0.0 || segment.rotary_from != segment.rotary_to {
            all.push(*segment);
        }
    });
    all
}

/// The digits of words, except those in comments, program numbers and block numbers.
fn digits(text: &[u8]) -> Vec<usize> {
    let mut found = Vec::new();
    let (mut depth, mut is_comment, mut letter) = (0, false, b' ');
    for (at, byte) in text.iter().enumerate() {
        match byte {
            b'\n' => (depth, is_comment, letter) = (0, false, b' '),
            b'(' => depth += 1,
            b')' => depth -= 1,
            b';' | b'%' => is_comment = true,
            byte if byte.is_ascii_alphabetic() => letter = byte.to_ascii_uppercase(),
            byte if byte.is_ascii_digit()
                && depth == 0
                && !is_comment
                && !b"NO".contains(&letter) =>
            {
                found.push(at);
            }
            _ => {}
        }
    }
    found
}

/// The largest distance of the ends and of a point between, when both have corresponding moves; `None` otherwise.
fn apart(a: &[Segment], b: &[Segment]) -> Option<f64> {
    use chordal::geometry::ParamCurve;
    if a.len() != b.len() {
        return None;
    }
    let mut most = 0.0f64;
    for (a, b) in a.iter().zip(b) {
        if a.known != b.known || a.kind != b.kind {
            return None;
        }
        if a.known {
            most = most.max((a.curve.start() - b.curve.start()).length());
            most = most.max((a.curve.end() - b.curve.end()).length());
            most = most.max((a.length_mm - b.length_mm).abs());
            let third = |segment: &Segment| segment.curve.point_at(segment.length_mm / 3.0);
            most = most.max((third(a) - third(b)).length());
        }
    }
    Some(most)
}

/// Whether the change divides the same path differently: a retract ends elsewhere, and the next rapid continues along
/// the same line.
const SAME_PATH: [&str; 5] = [
    "drilled-plate.nc:13",
    "parametric.nc:226",
    "parametric.nc:236",
    "parametric.nc:386",
    "parametric.nc:411",
];

/// `CHORDAL_DIGITS=1` changes each digit; without it, one in 19.
#[test]
fn a_planted_digit_is_found() {
    let step = std::env::var("CHORDAL_DIGITS").ok().and_then(|text| text.parse().ok());
    let step: usize = step.unwrap_or(19);
    let (mut planted, mut found, mut along, mut silent) = (0, 0, 0, Vec::new());
    for (file, machine) in examples() {
        let text = std::fs::read(&file).unwrap();
        let original = job(&text, machine);
        let plain = segments(&original);
        let own = compare(&original, &original, &ComparisonOptions::default());
        assert_eq!(
            own.verdict,
            ComparisonVerdict::Same,
            "{}: {:#?}",
            file.display(),
            own.differences
        );
        for (count, at) in digits(&text).into_iter().enumerate() {
            if count % step != 0 {
                continue;
            }
            let mut changed = text.clone();
            changed[at] = if text[at] == b'9' { b'8' } else { text[at] + 1 };
            let other = job(&changed, machine);
            let apart = apart(&plain, &segments(&other));
            let held = compare(&original, &other, &ComparisonOptions::default());
            planted += 1;
            let line = 1 + text[..at].iter().filter(|byte| **byte == b'\n').count() as u32;
            let name = format!("{}:{line}", file.file_name().unwrap().to_string_lossy());
            match apart {
                Some(0.0) => {
                    assert_eq!(held.max_distance_mm.unwrap_or(0.0), 0.0, "{name}");
                }
                Some(ends) if ends > 1e-6 => {
                    if held.verdict == ComparisonVerdict::Same {
                        silent.push(name);
                        continue;
                    }
                    found += 1;
                    assert_eq!(held.verdict, ComparisonVerdict::Different, "{name}");
                    // Along one line, only the point where a rapid and a cut or two feeds meet may have moved.
                    let is_path = |one: &Difference| one.category == Category::Path;
                    along += usize::from(!held.differences.iter().any(is_path));
                }
                _ => {
                    found += 1;
                    if held.verdict == ComparisonVerdict::Same {
                        silent.push(name);
                    }
                }
            }
        }
    }
    println!(
        "{planted} digits planted, {found} change the motion; along one line {along}; same: {silent:?}"
    );
    assert!(along * 20 < found, "{along} of {found}");
    assert!(planted > 200 && found > 100, "{planted} {found}");
    silent.retain(|name| !SAME_PATH.contains(&name.as_str()));
    assert!(silent.is_empty(), "{silent:?}");
}
