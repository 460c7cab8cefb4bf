//! A `match` over what codes do names every one of them, so that a code with a new action does not
//! compile until each place has answered for it. An arm that takes the rest would answer silently.
//! (The lint of clippy knows no list of enums; this one does.)

#![allow(clippy::disallowed_methods, reason = "reads the sources of the workspace")]

use std::fs;
use std::path::{Path, PathBuf};

/// The crates that act on codes.
const CRATES: [&str; 5] =
    ["chordal-kernel", "chordal-dialect", "chordal-gcode", "chordal-rewrite", "chordal-editor"];

/// The enums that are matched exhaustively.
const ENUMS: [&str; 15] = [
    "Action",
    "ReadingCode",
    "BeforeCode",
    "ModeCode",
    "PathCode",
    "LengthCode",
    "MotionCode",
    "OnceCode",
    "AfterCode",
    "CallCode",
    "CycleKind",
    "CycleFamily",
    "TurnCycle",
    "TurnFamily",
    "HolePattern",
];

/// The matches over `CommandKind` with an arm for the rest. Most look for moves among commands, and a new command is none; what
/// answers for every command names them all. The number may only be made smaller.
const MAX_COMMAND_WILDCARDS: usize = 62;

/// The patterns of the arms of each `match` of a source, with the byte where the match begins.
fn matches(text: &str) -> Vec<(usize, Vec<String>)> {
    let mut found = Vec::new();
    for (start, _) in text.match_indices("match ") {
        let before = text[..start].chars().next_back().unwrap_or(' ');
        let Some(open) = body_of(&text[start..]) else { continue };
        if !before.is_alphanumeric() && before != '_' && before != '/' {
            found.push((start, arms(&text[start + open + 1..])));
        }
    }
    found
}

/// The brace that opens the body: the first outside of parentheses.
fn body_of(text: &str) -> Option<usize> {
    let mut depth = 0;
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            '{' if depth == 0 => return Some(at),
            ';' => return None,
            _ => {}
        }
    }
    None
}

/// The patterns of the arms, up to the brace that closes the body.
fn arms(body: &str) -> Vec<String> {
    let (mut depth, mut pattern, mut patterns, mut in_pattern) =
        (0, String::new(), Vec::new(), true);
    let mut chars = body.char_indices().peekable();
    while let Some((at, c)) = chars.next() {
        match c {
            '{' | '(' | '[' => depth += 1,
            '}' | ')' | ']' if depth == 0 => break,
            '}' | ')' | ']' => depth -= 1,
            _ => {}
        }
        if in_pattern && depth == 0 && body[at..].starts_with("=>") {
            patterns.push(std::mem::take(&mut pattern));
            in_pattern = false;
        } else if in_pattern {
            pattern.push(c);
        } else if depth == 0 && (c == ',' || c == '}') {
            in_pattern = true;
            if c == '}' && matches!(chars.peek(), Some((_, ','))) {
                chars.next();
            }
        }
    }
    patterns
}

/// A pattern without its comments, attributes and guard.
fn bare(pattern: &str) -> String {
    let lines = pattern.lines().map(|line| line.split("//").next().unwrap_or(""));
    let text = lines.collect::<Vec<_>>().join(" ");
    text.split(" if ").next().unwrap_or("").trim().to_string()
}

/// The alternatives of a pattern: `A | B`, not those within parentheses.
fn alternatives(pattern: &str) -> Vec<&str> {
    let (mut depth, mut from, mut found) = (0, 0, Vec::new());
    for (at, c) in pattern.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            '|' if depth == 0 => {
                found.push(pattern[from..at].trim());
                from = at + 1;
            }
            _ => {}
        }
    }
    found.push(pattern[from..].trim());
    found
}

fn names_the_enums(pattern: &str, enums: &[&str]) -> bool {
    alternatives(pattern).into_iter().any(|one| {
        enums.iter().any(|name| one.strip_prefix(name).is_some_and(|rest| rest.starts_with("::")))
    })
}

/// `_`, or a name that takes whatever comes, without a condition.
fn takes_the_rest(pattern: &str) -> bool {
    let has_guard = pattern.contains(" if ");
    let name = bare(pattern);
    let is_name = !name.is_empty()
        && name.chars().all(|c| c.is_alphanumeric() || c == '_')
        && !name.starts_with(char::is_uppercase);
    is_name && !has_guard
}

fn wildcards(text: &str, enums: &[&str]) -> Vec<usize> {
    let code: Vec<&str> = text.lines().map(|line| line.split("//").next().unwrap_or("")).collect();
    let code = code.join("\n");
    let wrong = matches(&code).into_iter().filter(|(_, arms)| {
        arms.iter().any(|arm| names_the_enums(&bare(arm), enums))
            && arms.iter().any(|arm| takes_the_rest(arm))
    });
    wrong.map(|(start, _)| code[..start].matches('\n').count() + 1).collect()
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// The places of a crate's sources with an arm for the rest of some enums.
fn wildcards_of(name: &str, enums: &[&str]) -> Vec<String> {
    let mut files = Vec::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name).join("src");
    sources(&folder, &mut files);
    let mut found = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("a source");
        let lines = wildcards(&text, enums).into_iter();
        found.extend(lines.map(|line| format!("{}:{line}", file.display())));
    }
    found
}

#[test]
fn no_match_over_what_codes_do_has_an_arm_for_the_rest() {
    let wrong: Vec<_> = CRATES.iter().flat_map(|name| wildcards_of(name, &ENUMS)).collect();
    assert!(wrong.is_empty(), "an arm takes the rest of the codes:\n{}", wrong.join("\n"));
}

#[test]
fn arms_for_the_rest_of_the_commands_become_fewer() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the folder of crates");
    let mut found = Vec::new();
    for entry in fs::read_dir(crates).expect("the folder of crates") {
        let name = entry.expect("an entry").file_name();
        found.extend(wildcards_of(&name.to_string_lossy(), &["CommandKind"]));
    }
    let count = found.len();
    assert!(
        count <= MAX_COMMAND_WILDCARDS,
        "{count}, not {MAX_COMMAND_WILDCARDS}:\n{}",
        found.join("\n")
    );
}

#[test]
fn an_arm_for_the_rest_is_found() {
    let named = "fn f(a: Action) -> u8 {\n    match a {\n        Action::NoEffect => 1,\n        Action::Mode(_) => 2,\n    }\n}\n";
    assert!(wildcards(named, &ENUMS).is_empty());
    for rest in ["_", "other"] {
        let text = named.replace("Action::Mode(_)", rest);
        assert_eq!(wildcards(&text, &ENUMS), [2], "{rest}");
    }
    let nested = "match f(|x| { x }) {\n    MotionCode::Rapid | MotionCode::Linear => { g() }\n    _ if h() => {}\n    _ => {}\n}\n";
    assert_eq!(wildcards(nested, &ENUMS), [1]);
    let guarded = nested.replace("    _ => {}\n", "");
    assert!(wildcards(&guarded, &ENUMS).is_empty(), "a condition is no rest");
    assert!(
        wildcards("match letter { b'P' => 1, _ => 2 }", &ENUMS).is_empty(),
        "other values may have one"
    );
}
