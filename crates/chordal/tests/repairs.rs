//! Arcs that one changed word makes true: CH401 names the word, the simplest change first.

use std::f64::consts::{PI, TAU};

use chordal::diagnostics::{Code, Diagnostic};
use chordal::{Job, Machine, Source, SourceMap};

fn misfits(machine: &str, text: &str) -> Vec<Diagnostic> {
    let machine = Machine::from_builtin(machine).unwrap();
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    let found = Job::new(sources, machine).unwrap().check().diagnostics;
    found.into_iter().filter(|problem| problem.code == Code::RadiusMismatch).collect()
}

/// The replacements that the first misfit of a text is given, with the words that they replace.
fn repairs(machine: &str, text: &str) -> Vec<(String, String)> {
    let found = misfits(machine, text);
    let first = found.first().unwrap_or_else(|| panic!("no misfit on {machine}\n{text}"));
    let words = |fix: &chordal::diagnostics::Fix| {
        let range = fix.span.range;
        let old = text[range.start as usize..range.end as usize].to_string();
        (old, fix.replacement.clone())
    };
    first.fixes().map(words).collect()
}

/// The text with the first repair made has no misfit.
fn is_true_after_the_first(machine: &str, text: &str) -> bool {
    let fix = misfits(machine, text)[0].fix.clone().unwrap();
    let (start, end) = (fix.span.range.start as usize, fix.span.range.end as usize);
    let mended = format!("{}{}{}", &text[..start], fix.replacement, &text[end..]);
    misfits(machine, &mended).is_empty()
}

const HEAD: &str = "G90 G94 G17 G54\nS900 M3\nG0 X0 Y0 Z2.\nG1 Z-1. F90.\n";

#[test]
fn the_changed_word_is_named() {
    // What was typed, and the word that was meant for one of its words.
    let cases = [
        // A sign: of the centre, of the end, of the point before.
        ("G1 X3. Y0.\nG2 X4. Y-1. J1.\n", "J1.", "J-1."),
        ("G1 X3. Y0.\nG3 X-5. Y2. I0. J2.\n", "X-5.", "X5."),
        ("G1 X-2.5 Y1.\nG3 X4.5 Y3. I2. J0.\n", "X-2.5", "X2.5"),
        // The letter of a centre word, and of an end.
        ("G1 X5. Y5.\nG2 X9. Y5. J2.\n", "J2.", "I2."),
        ("G18 G1 X5. Z5.\nG3 X9. Z5. K2.\n", "K2.", "I2."),
        ("G19 G1 Y1. Z1.\nG2 X1.4657 Z.5343 J.4657 K0\n", "X1.4657", "Y1.4657"),
        // Digits that have changed places: here, and in the block before.
        ("G1 X0 Y0.\nG3 X7.364 Y0. I3.862 J0.\n", "I3.862", "I3.682"),
        ("G1 X1. Y-1.618\nG3 X4. Y-10.168 I3. J-4.\n", "Y-10.168", "Y-10.618"),
        ("G1 X2. Y-11.68\nG3 X4. Y-16.18 I1. J0.\n", "Y-11.68", "Y-16.18"),
        // The decimal point.
        ("G1 X0 Y0.\nG2 X5. Y0. I25. J0.\n", "I25.", "I2.5"),
        ("G1 X0 Y0.\nG3 X.36 Y0. I1.8 J0.\n", "X.36", "X3.6"),
        // Another digit.
        ("G1 X2. Y3.\nG2 X9. Y3. I8.5 J0.\n", "I8.5", "I3.5"),
        // A number where zero was meant.
        ("G1 X1. Y0.\nG3 X2.25 Y1.25 I2. J1.25\n", "I2.", "I0"),
        ("G1 X5. Y7.\nG2 X6. Y6. I2. J-1.\n", "I2.", "I0"),
    ];
    let mut wrong = Vec::new();
    for (body, old, new) in cases {
        for (machine, unit) in [
            ("fanuc-0i", "G21"),
            ("haas-vf2", "G20"),
            ("mitsubishi-m700", "G21"),
            ("linuxcnc-mill", "G20"),
        ] {
            let text = format!("{unit}\n{HEAD}{body}G0 Z2.\nM30\n");
            let found = repairs(machine, &text);
            let place = found.iter().position(|(was, is)| was == old && is == new);
            if place.is_none() || !is_true_after_the_first(machine, &text) {
                wrong.push(format!("{machine} {unit} {body}: {old} → {new}, found {found:?}"));
            }
            assert!(found.len() <= 3);
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

struct Chance(u64);

impl Chance {
    fn below(&mut self, most: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) % most
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.below(1 << 30) as f64 / f64::from(1 << 30)
    }
}

/// A number with three decimals, without zeros at its ends.
fn number(value: f64) -> String {
    let text = format!("{value:.3}").trim_end_matches('0').to_string();
    text.replace("0.", if value.abs() < 1.0 { "." } else { "0." })
}

#[test]
fn random_arcs_with_one_changed_word() {
    let mut chance = Chance(7);
    let (mut asked, mut named, mut first) = (0, 0, 0);
    for _ in 0..400 {
        let (x, y) = (chance.within(-40.0, 40.0), chance.within(-40.0, 40.0));
        let radius = chance.within(2.0, 25.0);
        let (from, sweep) = (chance.within(0.0, TAU), chance.within(0.3, PI * 1.6));
        let round = |value: f64| (value * 1e3).round() / 1e3;
        let start = [round(x + radius * from.cos()), round(y + radius * from.sin())];
        let end = [x + radius * (from + sweep).cos(), y + radius * (from + sweep).sin()];
        let mut words = [
            ("X", number(end[0])),
            ("Y", number(end[1])),
            ("I", number(x - start[0])),
            ("J", number(y - start[1])),
        ];
        let at = chance.below(4) as usize;
        let meant = format!("{}{}", words[at].0, words[at].1);
        let digits: Vec<usize> = (0..words[at].1.len())
            .filter(|place| words[at].1.as_bytes()[*place].is_ascii_digit())
            .collect();
        match chance.below(2) {
            0 => {
                let text = words[at].1.clone();
                words[at].1 = text.strip_prefix('-').map_or(format!("-{text}"), str::to_string);
            }
            _ if digits.len() > 2 => {
                let place = chance.below(digits.len() as u64 - 1) as usize;
                let mut bytes = words[at].1.clone().into_bytes();
                bytes.swap(digits[place], digits[place + 1]);
                words[at].1 = String::from_utf8(bytes).unwrap();
            }
            _ => continue,
        }
        let arc: Vec<String> =
            words.iter().map(|(letter, text)| format!("{letter}{text}")).collect();
        let text = format!(
            "G21\n{HEAD}G1 X{} Y{}\nG3 {}\nG0 Z2.\nM30\n",
            number(start[0]),
            number(start[1]),
            arc.join(" ")
        );
        let found = misfits("fanuc-0i", &text);
        // A slip of the last digits is not far off: there many words would do.
        let Some(problem) = found.first() else { continue };
        let off = problem.message.split(' ').nth(3).unwrap().parse::<f64>().unwrap();
        if off < 0.05 {
            assert!(problem.fixes().count() <= 3);
            continue;
        }
        asked += 1;
        let place = problem.fixes().position(|fix| fix.replacement == meant);
        named += u32::from(place.is_some());
        first += u32::from(place == Some(0));
    }
    println!("{asked} arcs with a changed word: named {named}, as the first {first}");
    assert!(asked > 250 && named * 100 >= asked * 98, "{named} of {asked}");
}

#[test]
fn arcs_without_a_slip_are_told_nothing() {
    let mut chance = Chance(11);
    let (mut asked, mut told) = (0, 0);
    for _ in 0..1500 {
        let mut place = || number(chance.within(-40.0, 40.0));
        let text = format!(
            "G21\n{HEAD}G1 X{} Y{}\nG2 X{} Y{} I{} J{}\nG0 Z2.\nM30\n",
            place(),
            place(),
            place(),
            place(),
            place(),
            place()
        );
        for problem in misfits("fanuc-0i", &text) {
            asked += 1;
            told += u32::from(problem.fix.is_some());
        }
    }
    println!("{asked} arcs of random numbers: {told} given a repair");
    assert!(asked > 1400 && told * 100 <= asked, "{told} of {asked}");
}
