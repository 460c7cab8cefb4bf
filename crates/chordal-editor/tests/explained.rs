//! `explain` names what the programs of the suite meet: each alarm at a code is on the page of that code.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use chordal::control::{Action, CodeRow, Control, OnceCode, RunOptions};
use chordal::diagnostics::{Code, FileId};
use chordal::syntax::{Block, BlockReader};
use chordal::{Job, Machine, Source, SourceMap};
use chordal_editor::explain::explain;
use chordal_editor::meaning::{ControlView, code_name, code_of, code_text};

fn view(machine: &str) -> ControlView {
    ControlView::of(
        &Control::of(&Machine::from_builtin(machine).unwrap()).expect("a word-address control").0,
    )
}

#[track_caller]
fn says(machine: &str, word: &str, texts: &[&str]) {
    let text = explain(word, &[view(machine)]).unwrap_or_else(|error| panic!("{}", error.message));
    for wanted in texts {
        assert!(text.contains(wanted), "`{wanted}` is not in\n{text}");
    }
}

#[test]
fn numbers_that_say_something_are_explained() {
    says(
        "fadal-4020",
        "L9601",
        &["fixed routine L96", "rectangular pocket, counter-clockwise, once"],
    );
    says("fadal-4020", "L9803", &["circular pocket", "3 times"]);
    says("fadal-4020", "L9306", &["at 6 places on a circle"]);
    says("fadal-4020", "L104", &["calls subroutine 1 4 times"]);
    says("fadal-4020", "L100", &["begins subroutine 1"]);
    says("fadal-4020", "L5", &["its block runs 5 times"]);
    says("fadal-4020", "R0", &["register R0", "radius of an arc", "R level"]);
    says("fadal-4020", "r3", &["register R3"]);
    says("fadal-4020", "E1", &["work offset 1"]);
    says("fadal-4020", "E0", &["machine coordinates"]);
    says("fadal-4020", "H0", &["no length offset"]);
    says("haas-vf2", "H0", &["no length offset"]);
    says("linuxcnc-mill", "H0", &["length of the tool in the spindle"]);
    says("fanuc-0i", "D0", &["radius or diameter of zero"]);
    says("fanuc-0i", "X-12.5", &["an axis"]);
    assert!(explain("E1", &[view("fanuc-0i")]).is_err(), "no Fanuc chooses work offsets by E");
    assert!(explain("L104x", &[view("fadal-4020")]).is_err());
}

#[test]
fn letters_of_spirals_say_what_they_are() {
    says("mitsubishi-m700-type2", "K", &["rise of a spiral in one turn"]);
    says("mitsubishi-m700-type2", "L", &["with G2 G3: spiral: number of turns"]);
    says("mitsubishi-m700-type2", "Q", &["with G2 G3: spiral: change of the radius in one turn"]);
    says("fanuc-30i", "L", &["spiral: number of turns"]);
    says("haas-vf2", "L", &["with G12 G13: how often the pocket is cut"]);
}

#[test]
fn codes_have_the_alarms_of_what_they_do() {
    says("linuxcnc-mill", "G38.2", &["CH744", "without making contact", "CH406"]);
    says("linuxcnc-mill", "M72", &["CH341", "missing M70/M73"]);
    says("haas-vf2", "G43", &["CH604"]);
    says("linuxcnc-mill", "M6", &["CH523", "Cannot change tools"]);
    says("linuxcnc-mill", "G18", &["CH504", "Cannot change planes"]);
    says("linuxcnc-mill", "G92", &["CH517"]);
    says("linuxcnc-mill", "G55", &["CH517"]);
    says("fadal-4020", "G28", &["CH522", "CANCEL CRC"]);
    says("grbl", "G38.2", &["CH744", "ALARM:5"]);
}

/// The codes that an alarm names, `G02` as 20, and the letters of words; neither the number of the alarm itself nor `a`.
fn names_in(alarm: &str) -> (Vec<(u8, u16)>, Vec<u8>) {
    let parts = alarm.split(|c: char| !c.is_ascii_alphanumeric() && c != '.');
    let parts = parts.map(|part| part.trim_matches('.').to_ascii_uppercase());
    let (mut codes, mut letters) = (Vec::new(), Vec::new());
    for part in parts {
        match part.as_bytes() {
            [letter] if b"DEHIJKLPQR".contains(letter) => letters.push(*letter),
            [b'G' | b'M', b'0'..=b'9', ..] => codes.extend(code_of(&part)),
            _ => {}
        }
    }
    (codes, letters)
}

#[test]
fn an_alarm_that_names_a_code_or_a_word_is_on_its_page() {
    let (mut met, mut missing) = (0, BTreeSet::new());
    for view in ControlView::all() {
        let table = view.table;
        for (code, alarm) in table.alarms {
            let says = |letter: u8, row: &CodeRow| {
                let text = code_text(letter, row.code, std::slice::from_ref(&view));
                text.is_some_and(|text| text.contains(code.id()))
            };
            let (names, letters) = names_in(alarm);
            for (letter, number) in names {
                let rows = if letter == b'G' { table.g_codes } else { table.m_codes };
                let row = rows.iter().find(|row| row.code == number);
                // A lathe has the mill's alarms, and cycles of its own at these numbers.
                let Some(row) = row.filter(|row| row.action.turning_cycle().is_none()) else {
                    continue;
                };
                met += 1;
                if !says(letter, row) {
                    missing.insert(format!(
                        "{} {}: {alarm}",
                        table.name,
                        code_name(letter, number)
                    ));
                }
            }
            for letter in letters {
                // Arguments and data are not what an alarm means, nor words of codes that are not carried out.
                let is_own = |row: &&CodeRow| {
                    let is_other = row.action == Action::Once(OnceCode::SetData)
                        || row.action.is_left_out()
                        || matches!(row.action, Action::Call(_));
                    row.words.has(letter) && !is_other
                };
                let mut rows = table.g_codes.iter().filter(is_own).peekable();
                met += 1;
                // No code takes the word where it stands alone.
                if rows.peek().is_some() && !rows.any(|row| says(b'G', row)) {
                    missing.insert(format!("{} {}: {alarm}", table.name, char::from(letter)));
                }
            }
        }
    }
    assert!(met > 40, "{met}");
    assert!(missing.is_empty(), "{missing:#?}");
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut paths: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "nc" || ending == "ngc") {
            found.push(path);
        }
    }
}

/// The job of a program on the machine that its remarks or its folder say.
fn job_of(path: &Path) -> Option<Job<'static>> {
    let text = String::from_utf8_lossy(&std::fs::read(path).unwrap()).into_owned();
    let remark = |mark: &str| text.split_once(mark)?.1.split(')').next();
    let beside = std::fs::read_to_string(path.with_file_name("chordal.toml")).unwrap_or_default();
    let name = remark("(machine: ").or_else(|| beside.split('"').nth(1))?;
    let mut machine = Machine::from_builtin(name).ok()?;
    for (_, rest) in text.match_indices("(set: ").map(|(at, mark)| text.split_at(at + mark.len())) {
        machine.set(rest.lines().next()?.trim_end().strip_suffix(')')?).ok()?;
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.into_bytes()));
    let options = RunOptions { max_repeated_blocks: 2_000, ..RunOptions::default() };
    Some(Job::new(sources, machine).ok()?.options(options))
}

/// Every code can be one too many, one that the control does not have, or stand among arguments.
const OF_ANY_CODE: [Code; 5] =
    [Code::UnknownCode, Code::SameGroup, Code::RepeatedWord, Code::NotAlone, Code::BadArgument];

#[test]
fn an_alarm_at_a_code_is_on_its_page() {
    let mut paths = Vec::new();
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/suite"), &mut paths);
    let (mut met, mut missing) = (BTreeSet::new(), BTreeSet::new());
    for job in paths.iter().filter_map(|path| job_of(path)) {
        let control = job.word_address().expect("word-address blocks");
        let source = job.sources().get(FileId(0)).unwrap().text().to_vec();
        for problem in job.check().diagnostics {
            let range = problem.primary.span.range;
            let own =
                problem.primary.span.file == FileId(0) && !OF_ANY_CODE.contains(&problem.code);
            if !own || control.table.alarm(problem.code).is_none() {
                continue;
            }
            let mut reader = BlockReader::new(&source, FileId(0), control.table.lexicon);
            let mut block = Block::new();
            while reader.read(&mut block) && block.range.end < range.start {}
            let rows = block.words.iter().filter(|word| word.range == range);
            for row in rows.filter_map(|word| Some((word.letter, control.row_of(word)?))) {
                let name = code_name(row.0, row.1.code);
                let text = explain(&name, &[ControlView::of(control)]).map_err(|_| ()).unwrap();
                let told = format!("{} {name} {}", control.table.name, problem.code.id());
                if !text.contains(problem.code.id()) {
                    missing.insert(told.clone());
                }
                met.insert(told);
            }
        }
    }
    println!("{} alarms at codes", met.len());
    assert!(met.len() > 20, "{met:?}");
    assert!(missing.is_empty(), "{missing:#?}");
}
