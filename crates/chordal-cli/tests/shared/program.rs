//! Random programs that have something of everything.

use std::collections::BTreeSet;

/// Numbers by chance, the same for a seed.
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Dice {
        Dice(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0xD1B5_4A32_D192_ED03)
    }

    pub fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % end.max(1) as u64) as usize
    }
}

/// Blocks that belong together; a move with the feed comes after each.
const EVERYWHERE: &[&str] = &[
    "M9\n{move}\nM8",
    "M9\n{move}\nM8\n{move}\nM9",
    "S{speed}",
    "M5\nS{speed} M4",
    "G4 P{dwell}",
    "M0",
    "M1",
    "F{feed}",
    "G0 Z20.\nG0 X{x} Y{y}\nG1 Z-1. F200.",
    "G0 Z20.\nG55\nG0 X{x} Y{y}\nZ15.\nG1 Z-1. F150.",
    "G0 Z20.\nG54\nG0 X{x} Y{y}\nZ15.\nG1 Z-1. F150.",
    "G0 Z50.\nM9\nT2\n{move}\nT{tool} M6\nS{speed} M3\nG0 X{x} Y{y}\nG43 H{tool} Z20.\nM8\nG1 Z-1. F120.",
    "G91\nX1. Y1.\nG90",
    "G41 D{tool} X{x} Y100. F100.\nY140.\nX150.\nG40 X180. Y180.",
    "G10 L2 P6 X{x} Y3.",
    "G61\n{move}\nG64",
    "/X{x}",
    "/M8",
    "/{move}",
    "G2 X{x} Y{y} R300.",
    "G3 X{x} Y{y} R300.",
    "G52 X2.\n{move}\nG52 X0",
    "M48\n{move}\nM49",
];

const MACROS: &[&str] = &[
    "M10",
    "M10\n{move}\nM11",
    "M51 P0",
    "M83\nM84",
    "#3006=1(TURN IT)",
    "#1100=1",
    "#501={tool}",
    "#5242={x}",
    "G10 L12 P3 R4.",
    "G10 L10 P3 R40.",
];

const OF_LINUXCNC: &[&str] = &[
    "M62 P1",
    "M62 P1\n{move}\nM63 P1",
    "M68 E0 Q5",
    "M51 P1",
    "(MSG,turn it)",
    "G10 L1 P3 Z40. R4.",
    "G28.1",
    "#5242={x}",
    "M64 P2",
];

/// Nobody knows what these come to.
const UNKNOWN: &[&str] = &[
    "X#500",
    "IF[#1000EQ1]GOTO{label}\n{move}\nN{label}",
    "IF[#1000EQ1]GOTO{label}\n{move}\nGOTO{other}\nN{label}#3000=1(NO CLAMP)\nN{other}",
    "G1 F#502\n{move}",
];

/// A program for a machine.
pub fn program(machine: &str, dice: &mut Dice) -> String {
    let linuxcnc = machine == "linuxcnc-mill";
    let mut lines = vec![
        "G21 G17 G90 G40 G49 G80 G94".to_string(),
        "G54".into(),
        "T1 M6".into(),
        "S1000 M3".into(),
        "G0 X0. Y0.".into(),
        "G43 H1 Z20.".into(),
        "G1 Z-1. F200.".into(),
    ];
    let own = if linuxcnc { OF_LINUXCNC } else { MACROS };
    let mut label = 100;
    let mut written = BTreeSet::new();
    for _ in 0..8 + dice.below(12) {
        let pick = dice.below(10);
        let block = match pick {
            0..=5 => EVERYWHERE[dice.below(EVERYWHERE.len())],
            6..=8 => own[dice.below(own.len())],
            _ if linuxcnc => own[dice.below(own.len())],
            _ => UNKNOWN[dice.below(UNKNOWN.len())],
        };
        // Where a later one writes the same place, the first is no difference.
        let writes = block.contains("G10 L") || block.contains("#5");
        if writes && !written.insert(block) {
            continue;
        }
        label += 10;
        let block = block.replace("{label}", &label.to_string());
        let block = block.replace("{other}", &(label + 1).to_string());
        for line in block.lines() {
            lines.push(filled(line, linuxcnc, dice));
        }
        lines.push(filled("G1 {move} F{feed}", linuxcnc, dice));
    }
    lines.push("G0 Z50.".into());
    lines.push("M30".into());
    lines.join("\n") + "\n"
}

fn filled(line: &str, linuxcnc: bool, dice: &mut Dice) -> String {
    let mut line = line.replace("{move}", "X{x} Y{y}");
    let mut put = |name: &str, text: String| line = line.replace(name, &text);
    put("{x}", format!("{}.{}", 10 + dice.below(80), 1 + dice.below(9)));
    put("{y}", format!("{}.{}", 10 + dice.below(80), 1 + dice.below(9)));
    put("{feed}", format!("{}.", 100 + dice.below(400)));
    put("{speed}", format!("{}", 500 + dice.below(2000)));
    put("{tool}", format!("{}", 3 + dice.below(4)));
    let dwell = 1 + dice.below(4);
    put("{dwell}", if linuxcnc { format!("{dwell}.5") } else { format!("{}", 500 * dwell) });
    line
}

/// The program without the blocks that depend on what nobody knows.
pub fn without_unknown(text: &str) -> String {
    let is_unknown = |line: &&str| {
        ["#500", "#1000", "#502", "#3000", "GOTO"].iter().any(|name| line.contains(name))
    };
    text.lines().filter(|line| !is_unknown(line)).map(|line| format!("{line}\n")).collect()
}
