//! The programs of the suite, whatever they are about: what becomes of each on each control.

use chordal::RunOptions;
use chordal_rewrite::convert::{ConversionOptions, convert};

use super::{MACHINES, VerdictTable, converted, job_of, suite_programs, text_of, verdict};

#[test]
fn all_programs() {
    let mut table = VerdictTable::default();
    let folders = ["fadal", "haas", "fanuc", "mitsubishi", "linuxcnc", "textbook", "five"];
    for path in suite_programs(&folders) {
        let old = job_of(&text_of(&path), &[]);
        let first = converted(&old, MACHINES[0]);
        if first.text.is_empty() {
            table.text += &format!("{path}\n    {}\n", verdict(&first));
            assert!(!first.holds() && !first.refusals.is_empty(), "{path}");
            continue;
        }
        table.add(&path, &old, &MACHINES);
    }
    insta::assert_snapshot!(table.finish());
}

/// Programs with a few bytes changed, errors and all: an answer for each, whatever it is.
#[test]
#[allow(clippy::disallowed_methods, reason = "the rounds are a variable of the environment")]
fn changed_bytes_get_an_answer() {
    let mut seed = 0x2545_f491_4f6c_dd1d_u64;
    let mut next = |most: usize| {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed % most.max(1) as u64) as usize
    };
    let rounds =
        std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    let despite = ConversionOptions { despite_errors: true, ..ConversionOptions::default() };
    let paths = suite_programs(&["fadal", "haas", "fanuc", "mitsubishi", "linuxcnc"]);
    for path in paths.iter().flat_map(|path| std::iter::repeat_n(path, rounds)) {
        let whole = text_of(path);
        let own = job_of(&whole, &[]);
        let mut bytes = whole.clone().into_bytes();
        for _ in 0..4 {
            let at = next(bytes.len());
            match next(4) {
                0 => bytes[at] = b"GMXYZIJKRLPNTH0123456789.-+#[]()=/;%\n "[next(38)],
                1 => drop(bytes.drain(at..(at + next(20)).min(bytes.len()))),
                2 => bytes.insert(at, b"0123456789.-LG"[next(14)]),
                _ => {
                    let part = bytes[at..(at + next(60)).min(bytes.len())].to_vec();
                    let to = next(bytes.len());
                    bytes.splice(to..to, part);
                }
            }
        }
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let old = super::job(&text, own.machine().clone())
            .options(RunOptions { max_repeated_blocks: 2000, ..RunOptions::default() });
        let to = MACHINES[next(MACHINES.len())];
        let found = convert(&old, &super::machine(to), &despite);
        assert!(found.holds() || !verdict(&found).is_empty(), "{path}");
    }
}
