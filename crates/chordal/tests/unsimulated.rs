//! Nothing is left out without a word: every row of every control's tables, with every letter.
//!
//! A code that the table calls *without effect* or *not simulated* must not change the motion after it,
//! nor take an axis word from its block. A code that is *not followed* must be an error, and the run not
//! verified. A letter that a row does not take must do something or be reported.

use chordal::control::table::LineRepeat;
use chordal::control::{
    Action, AfterCode, CONTROLS, CallCode, CodeRow, ControlTable, OnceCode, table,
};
use chordal::{CommandKind, Job, Machine, Severity, Source, SourceMap};

/// What stands before and after the block that is tried. Compensation, a length and a cut without codes
/// come after it, so that what the block leaves behind shows.
const HEAD: &str = "\
G90 G94 G17 G40 G49 G80
S500 M3
F200.
G0 X-40. Y2. Z50.
G43 H1 Z51.
G41 D1 G1 X-30.
X-10.
G40 X-2.
G49
G1 X1. Y2. F90.
";
const TAIL: &str = "\
X3.
G80 G1 X20. Y5. Z10.
G41 X30. Y9.
X52.
G40 X80.
G43 Z12.
G90 G1 X1. Y1. Z1. F50.
M30
";
/// The same for a lathe with X and Z: it has no lengths to choose, and G1 ends its passes.
const LATHE_HEAD: &str = "\
G98 G18 G40 G80
S500 M3
T0101
F200.
G0 X-40. Z50.
G42 G1 X-30. Z40.
X-10.
G40 X-2. Z38.
G1 X1. Z37. F90.
";
const LATHE_TAIL: &str = "\
G1 X3.
G80 G1 X20. Z10.
G42 X30. Z9.
X52.
G40 X80. Z8.
G1 X1. Z1. F50.
M30
";

/// The same for a control without cutter compensation, tool table and cycles.
const SMALL_HEAD: &str = "\
G90 G94 G17 G40 G49
S500 M3
F200.
G0 X-40. Y2. Z50.
G43.1 Z3.
G0 Z51.
G49
G1 X1. Y2. F90.
";
const SMALL_TAIL: &str = "\
X3.
G1 X20. Y5. Z10.
G90 G1 X1. Y1. Z1. F50.
M30
";

/// The same for a control that takes one command a line.
const LINE_HEAD: &str = "\
G90
M3 S500
G0 X-40 Y2 Z50 F200
G1 X1 Y2 F90
";
const LINE_TAIL: &str = "\
X3
G1 X20 Y5 Z10
G90
G1 X1 Y1 Z1 F50
";

/// What stands before and after a block on a machine.
fn around(machine: &Machine) -> (&'static str, String) {
    let (head, tail) = match machine.turns() {
        true => (LATHE_HEAD, LATHE_TAIL),
        false if table(machine.control).expect("a table").command_line.is_some() => {
            (LINE_HEAD, LINE_TAIL)
        }
        false if table(machine.control).expect("a table").firmware.is_some() => {
            (SMALL_HEAD, SMALL_TAIL)
        }
        false => (HEAD, TAIL),
    };
    let number =
        if needs_number(table(machine.control).expect("a table")) { "G43 H1" } else { "G43" };
    (head, tail.replace("G43", number))
}

/// G43 without H is not followed.
fn needs_number(table: &ControlTable) -> bool {
    table.word_rules.iter().any(|rule| rule.code == (b'G', 430))
}

/// Tools of which each number gives another path.
const TOOLS: [&str; 4] = [
    "tools.1.diameter='6 mm'",
    "tools.1.length='100 mm'",
    "tools.3.diameter='8 mm'",
    "tools.3.length='130 mm'",
];

/// Words with which a block is tried: alone, and such as its code may need.
const WORDS: [&str; 6] =
    ["", "X5. Y6.", "X5. Y2. I1.5", "X5. Z-5. R2.5", "X5. Z-5. R2.5 Q1. P1", "P1"];

struct Ran {
    /// Everything that the program makes the machine do.
    commands: Vec<String>,
    /// The moves alone.
    moves: Vec<String>,
    /// Code, message and severity of what was reported.
    told: Vec<(&'static str, String, Severity)>,
    /// The block that is tried, or one after it, has an error.
    has_error: bool,
    verified: bool,
}

fn run(machine: &Machine, block: &str) -> Ran {
    let mut sources = SourceMap::new();
    let (head, tail) = around(machine);
    let text = format!("{head}{block}\n{tail}");
    sources.add(Source::new("row.nc", text.into_bytes()));
    let job = Job::new(sources, machine.clone()).expect("a built-in machine");
    let (mut commands, mut moves) = (Vec::new(), Vec::new());
    let report = job.report_of_commands(|command| {
        if command.kind == CommandKind::Idle {
            return;
        }
        let said = format!("{:?}", command.kind);
        if command.kind.motion().is_some() {
            moves.push(said.clone());
        }
        commands.push(said);
    });
    let has_error = report.counts.errors > 0;
    let told = report.diagnostics.iter();
    let told = told.map(|one| (one.code.id(), one.message.clone(), one.severity)).collect();
    Ran { commands, moves, told, has_error, verified: report.verified() }
}

fn machine_of(table: &ControlTable) -> Machine {
    let mut machine = Machine::from_builtin(table.default_machine).unwrap();
    TOOLS.iter().for_each(|tool| machine.set(tool).unwrap());
    // Not every control has a code for it.
    machine.set("settings.units=\"mm\"").unwrap();
    // Codes that not every build of a firmware has are there.
    for setting in table.settings {
        if setting.field.is_build_option() {
            machine.set(&format!("settings.\"{}\"=\"on\"", setting.name)).unwrap();
        }
    }
    machine
}

/// Every row of every control, with the control's built-in machine.
fn each_row(mut see: impl FnMut(&Machine, &ControlTable, u8, &'static CodeRow)) {
    for table in CONTROLS {
        let machine = machine_of(table);
        for (letter, rows) in [(b'G', table.g_codes), (b'M', table.m_codes)] {
            for row in rows {
                see(&machine, table, letter, row);
            }
        }
    }
}

/// A word with a number that its letter may have.
fn word(letter: char) -> String {
    if "XYZABCUVWIJKRQEF".contains(letter) { format!("{letter}3.") } else { format!("{letter}3") }
}

/// The letters that a row takes, and the axes. A speed acts whatever stands next to it.
fn taken(row: &CodeRow) -> impl Iterator<Item = char> {
    let of_row = |letter: char| row.words.has(letter as u8) && letter != 'S';
    ('A'..='Z').filter(move |letter| of_row(*letter) || "XYZ".contains(*letter))
}

/// Letters that are carried out and make no difference in these programs.
fn takes_unseen(table: &ControlTable, action: Action, letter: char) -> bool {
    let is_axis = "XYZABC".contains(letter);
    match action {
        // It repeats a block that a second time changes nothing.
        _ if letter == 'L' && table.line_repeat != LineRepeat::None => true,
        // It writes a register.
        _ if letter == 'R' && table.lexicon.registers => true,
        // The offsets they choose are for moves after it, and there are none.
        Action::After(AfterCode::ProgramEnd { .. }) => "DH".contains(letter),
        Action::Call(CallCode::Return) => "DH".contains(letter),
        Action::Call(CallCode::SubroutineEnd) => "DH".contains(letter),
        // The mirror of a rotary axis that does not move; the end of a mirror that is not on.
        Action::Once(OnceCode::Mirror { .. } | OnceCode::MirrorOff) => is_axis,
        // A centre about which nothing is turned or scaled, without an angle or a factor.
        Action::Once(OnceCode::Rotation | OnceCode::Scaling) => is_axis,
        _ => false,
    }
}

#[test]
fn what_is_said_to_change_no_motion_changes_none() {
    let mut wrong = Vec::new();
    each_row(|machine, table, letter, row| {
        if !matches!(row.action, Action::NoEffect | Action::NotSimulated) {
            return;
        }
        let name = row.name(letter);
        for word in std::iter::once(String::new()).chain(taken(row).map(word)) {
            // A line is one command: its words move nothing.
            let moves = table.command_line.is_none()
                && word.starts_with(['X', 'Y', 'Z'])
                && !row.words.has(word.as_bytes()[0]);
            if word.starts_with('Y') && machine.turns() {
                continue;
            }
            let plain = run(machine, if moves { &word } else { "" });
            let ran = run(machine, &format!("{name} {word}"));
            if ran.moves != plain.moves || !ran.verified {
                wrong.push(format!("{} {name} {word} ({})", table.name, row.title));
            }
            let told = ran.told.iter().any(|(id, ..)| *id == "CH306");
            if told != (row.action == Action::NotSimulated) {
                wrong.push(format!("{} {name} {word}: CH306 {told}", table.name));
            }
        }
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_is_not_followed_is_an_error_and_not_verified() {
    let mut wrong = Vec::new();
    each_row(|machine, table, letter, row| {
        if row.action != Action::NotFollowed {
            return;
        }
        let name = row.name(letter);
        for word in std::iter::once(String::new()).chain(taken(row).map(word)) {
            let ran = run(machine, &format!("{name} {word}"));
            let error = |(id, _, severity): &(&str, String, Severity)| {
                *id == "CH312" && *severity == Severity::Error
            };
            if ran.verified || !ran.told.iter().any(error) {
                wrong.push(format!("{} {name} {word} ({})", table.name, row.title));
            }
        }
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_word_that_a_code_does_not_take_does_something_or_is_reported() {
    for table in CONTROLS {
        // What stands before and after is right everywhere: an error is one of the block that is tried.
        let plain = run(&machine_of(table), "");
        assert!(!plain.has_error, "{}: {:?}", table.name, plain.told);
    }
    let mut wrong = Vec::new();
    let mut tried = 0_usize;
    each_row(|machine, table, letter, row| {
        let name = row.name(letter);
        // The rest of such a line is a text.
        let is_text = |number: &u16| letter == b'M' && number * 10 == row.code;
        if table.command_line.is_some_and(|line| line.texts.iter().any(is_text)) {
            return;
        }
        for words in WORDS {
            let block = format!("{name} {words}");
            let without = run(machine, &block);
            if without.has_error {
                continue;
            }
            for extra in 'A'..='Z' {
                let stands = words.contains(extra) || row.words.has(extra as u8);
                if stands || "GMNO".contains(extra) || takes_unseen(table, row.action, extra) {
                    continue;
                }
                tried += 1;
                let block = format!("{block} {}", word(extra));
                let with = run(machine, &block);
                if with.told == without.told && with.commands == without.commands {
                    wrong.push(format!("{} {block} ({})", table.name, row.title));
                }
            }
        }
    });
    assert!(tried > 20_000, "{tried}");
    assert!(wrong.is_empty(), "{} of {tried}\n{}", wrong.len(), wrong.join("\n"));
}
