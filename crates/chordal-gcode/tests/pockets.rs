//! Pocket blocks of pseudo-random words, sensible and not: no crash, no hang, no number that is
//! not finite, and a path without gaps.

#![allow(missing_docs)]

use chordal_command::{Command, CommandKind, Sink};
use chordal_diagnostics::{Diagnostic, Source, SourceMap};
use chordal_dialect::Control;
use chordal_gcode::{Library, run};
use chordal_kernel::{RunOptions, RunSink};
use chordal_machine::{Machine, PerAxis};

/// A xorshift, so that every run reads the same programs.
struct Random(u64);

impl Random {
    fn next(&mut self, below: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % below
    }

    /// A number that is mostly sensible.
    fn number(&mut self) -> String {
        match self.next(24) {
            0 => "0".into(),
            1 => format!("-{}.{}", self.next(3), self.next(1000)),
            2 => "99999999999.".into(),
            3 => ".0000001".into(),
            4 => format!("{}", self.next(100_000)),
            _ => format!("{}.{:03}", self.next(3), self.next(1000)),
        }
    }

    fn words(&mut self, letters: &[&str]) -> String {
        let mut text = String::new();
        for letter in letters {
            if self.next(12) > 0 {
                text += &format!(" {letter}{}", self.number());
            }
        }
        text
    }
}

/// Looks at every motion.
#[derive(Default)]
struct Watching {
    last: Option<PerAxis<f64>>,
    motions: u64,
    of_cycles: u64,
}

impl Sink for Watching {
    fn command(&mut self, command: &Command) {
        let Some(motion) = command.kind.motion() else { return };
        assert!(motion.from.iter().chain(&motion.to).all(|value| value.is_finite()));
        if let Some(last) = self.last {
            assert_eq!(last, motion.from, "a gap in the path");
        }
        if let CommandKind::Arc { shape, .. } = &command.kind {
            assert!(shape.sweep.is_finite() && shape.radius_from.is_finite());
            let off = (shape.radius_from - shape.radius_to).abs();
            assert!(off <= 1e-3, "an arc from {} to {}", shape.radius_from, shape.radius_to);
        }
        self.last = Some(motion.to);
        self.motions += 1;
        self.of_cycles += u64::from(command.origin.cycle);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        assert!(!diagnostic.message.is_empty());
    }
}

impl RunSink for Watching {}

fn watch(machine: &Machine, text: &str) -> Watching {
    let mut sources = SourceMap::new();
    sources.add(Source::new("pockets", text.as_bytes()));
    let (control, _) = Control::of(machine).expect("a word-address control");
    let library = Library::new(&sources, &control.table.lexicon);
    let mut sink = Watching::default();
    let options = RunOptions { max_repeated_blocks: 50, ..RunOptions::default() };
    run(&library, 0, machine, &control, &options, &mut sink);
    sink
}

fn machine(name: &str) -> Machine {
    let mut machine = Machine::from_builtin(name).expect("a built-in machine");
    for assignment in ["tools.1.diameter=0.25 in", "tools.2.diameter=1e-7 in"] {
        machine.set(assignment).expect("a good assignment");
    }
    machine
}

#[test]
fn any_words_of_fixed_routines() {
    let machine = machine("fadal-4020");
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let mut cut = 0;
    for _ in 0..1500 {
        let tool = 1 + random.next(8) / 7;
        let routine = 91 + random.next(9);
        let count = random.next(4);
        let corner = random.next(14);
        let words = format!(" R1+.{corner:02}") + &random.words(&["R0+", "R2+", "R3+"]);
        let text = format!(
            "M6 T{tool}\nG90 G0 S100 M3 E1 X0 Y0\nH{tool} D{tool} Z.1\nG1 Z0 F1.\n\
             L{routine}0{count}{words}\nM2\n"
        );
        cut += u64::from(watch(&machine, &text).of_cycles > 0);
    }
    assert!(cut > 200, "{cut} of the programs mill");
}

#[test]
fn any_words_of_pocket_blocks() {
    let machine = machine("haas-vf2");
    let mut random = Random(0xD1B5_4A32_D192_ED03);
    let mut cut = 0;
    for _ in 0..1500 {
        let code = ["G12", "G13", "G91 G12"][random.next(3) as usize];
        let (words, repeats) = (random.words(&["Z-", "I", "K1", "Q"]), random.next(3));
        let repeats = if repeats == 0 { String::new() } else { format!(" L{repeats}") };
        let text = format!(
            "G90 G17 S100 M3 F10.\nG0 X0 Y0 Z1.\n{code}{words}{repeats} D{}\nM30\n",
            random.next(4)
        );
        cut += u64::from(watch(&machine, &text).of_cycles > 0);
    }
    assert!(cut > 200, "{cut} of the programs mill");
}

#[test]
fn any_outline() {
    let machine = machine("haas-vf2");
    let mut random = Random(0xA076_1D64_78BD_642F);
    let mut cut = 0;
    for turn in 0..1500 {
        let side = 41 + random.next(2);
        let mut words =
            random.words(&["Z-1", "R", "Q1", "J"]) + [" K.01", ""][random.next(2) as usize];
        if random.next(8) == 0 {
            words += &random.words(&["I", "P"]);
        }
        let tool = u64::from(turn % 9 != 0);
        let mut text = format!(
            "G90 G17 S100 M3 F10.\nG0 X0 Y0 Z1.\nG150 G{side} P7{words} X2. Y2. D{tool}\nM30\n\
             N7 G1 X4. Y2.\n"
        );
        // The corners go round the hole, most of them where they should.
        let reach = |random: &mut Random| format!("{}.{}", random.next(2), random.next(10));
        for corner in 0..4 {
            let (x, y) = (reach(&mut random), reach(&mut random));
            let (sx, sy) = [("4.", "4."), ("-", "4."), ("-", "-"), ("4.", "-")][corner];
            let number = |sign: &str, size: &str| match sign {
                "4." => format!("{}", 3.0 + size.parse::<f64>().unwrap_or(0.0)),
                _ => format!("-{size}"),
            };
            let code = match random.next(6) {
                0 => "G3",
                1 => "G2",
                _ => "G1",
            };
            let radius = if code == "G1" { String::new() } else { " R8.".into() };
            text += &format!("{code} X{} Y{}{radius}\n", number(sx, &x), number(sy, &y));
        }
        text += "G1 X4. Y2.\nM99\n";
        cut += u64::from(watch(&machine, &text).of_cycles > 0);
    }
    assert!(cut > 100, "{cut} of the programs mill");
}
