//! The signs by which programs are recognized.

use chordal_kernel::{ControlCandidate, ControlProfile, FoundSign};
use chordal_machine::ControlName;

/// A word that stands in programs, its weight, and the sign in words.
const SIGNS: [(&str, i32, &str); 10] = [
    ("BEGIN PGM", 20, "BEGIN PGM"),
    ("END PGM", 10, "END PGM"),
    ("TOOL CALL", 8, "TOOL CALL"),
    ("CYCL DEF", 8, "CYCL DEF"),
    ("BLK FORM", 8, "BLK FORM"),
    ("FMAX", 6, "FMAX is a rapid"),
    ("CALL LBL", 4, "CALL LBL calls a label"),
    ("DR+", 4, "DR+ turns an arc"),
    ("DR-", 4, "DR- turns an arc"),
    ("FN 0:", 6, "FN calculates"),
];

/// The weight from which on a text is one of the language.
const MIN_WEIGHT: i32 = 8;

/// Lines that are looked at; programs show their signs at the start.
const MAX_LINES: usize = 2000;

/// The control with the signs of a text; empty where they are too few.
pub fn candidates(text: &[u8], profile: ControlProfile) -> Vec<ControlCandidate> {
    let mut signs: Vec<FoundSign> = Vec::new();
    let mut offset = 0_u32;
    for (index, line) in text.split_inclusive(|byte| *byte == b'\n').take(MAX_LINES).enumerate() {
        let code = line.split(|byte| *byte == b';').next().unwrap_or(line).to_ascii_uppercase();
        for (word, weight, sign) in SIGNS {
            let is_new = !signs.iter().any(|found| found.sign == sign);
            if is_new && memchr::memmem::find(&code, word.as_bytes()).is_some() {
                let line = index as u32 + 1;
                signs.push(FoundSign { sign, line, offset, weight, machine: None });
            }
        }
        offset += line.len() as u32;
    }
    let weight: i32 = signs.iter().map(|sign| sign.weight).sum();
    if weight < MIN_WEIGHT {
        return Vec::new();
    }
    signs.sort_by_key(|sign| -sign.weight);
    vec![ControlCandidate {
        name: profile.name,
        title: profile.title,
        control: ControlName::Heidenhain,
        not_read: false,
        weight,
        signs,
        errors: None,
    }]
}

/// Whether some line begins a program, calls a tool or moves as this language does.
pub fn begins_like_klartext(text: &[u8]) -> bool {
    text.split(|byte| *byte == b'\n').take(MAX_LINES).any(|line| {
        let line = line.trim_ascii_start();
        let digits = line.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let line = line[digits..].trim_ascii_start();
        const BEGINNINGS: [&[u8]; 4] = [b"BEGIN PGM", b"TOOL CALL", b"CYCL DEF", b"BLK FORM"];
        BEGINNINGS.iter().any(|beginning| {
            line.get(..beginning.len()).is_some_and(|start| start.eq_ignore_ascii_case(beginning))
        })
    })
}
