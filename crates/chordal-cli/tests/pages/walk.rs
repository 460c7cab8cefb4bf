//! Runs the commands of a page, in a copy of the examples, and puts what they print where the page shows it.
//!
//! A block of commands is fenced as `sh`. When the next fenced block is `text`, it is what the commands
//! print. A line `…` in it stands for any lines. Blocks in other languages are passed over, so that what
//! must not run (the installation, a workflow) is fenced as `console` or `yaml`.

use std::fs;
use std::path::Path;
use std::process::Command;

/// A fenced block: its language, and the lines of the page between its fences.
struct Block {
    language: String,
    from: usize,
    to: usize,
}

/// The page with what its commands print.
pub fn walked(name: &str, page: &str) -> String {
    let lines: Vec<&str> = page.lines().collect();
    let blocks = blocks(&lines);
    let folder = tempfile::tempdir().expect("a folder for the page");
    for part in ["examples", "docs/getting-started"] {
        copy(&super::root().join(part), &folder.path().join(part));
    }
    let mut place = folder.path().to_string_lossy().into_owned();
    let mut new: Vec<(usize, usize, String)> = Vec::new();
    for (index, block) in blocks.iter().enumerate() {
        if block.language != "sh" {
            continue;
        }
        let script = lines[block.from..block.to].join("\n");
        let (printed, exit) = run(&script, &mut place, folder.path());
        assert!(exit < 2, "{name}: exit {exit} of\n{script}\n{printed}");
        if let Some(shown) = blocks.get(index + 1).filter(|next| next.language == "text") {
            let text = lines[shown.from..shown.to].join("\n") + "\n";
            if text.lines().any(|line| line == "…") {
                assert!(
                    matches(&text, &printed),
                    "{name} shows\n{text}\nbut\n{script}\nprints\n{printed}"
                );
            } else {
                new.push((shown.from, shown.to, printed));
            }
        }
    }
    assert!(!new.is_empty(), "{name} shows no output");
    let mut text = String::new();
    let mut at = 0;
    for (from, to, printed) in new {
        lines[at..from].iter().for_each(|line| text += &format!("{line}\n"));
        text += &printed;
        at = to;
    }
    lines[at..].iter().for_each(|line| text += &format!("{line}\n"));
    text
}

fn blocks(lines: &[&str]) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut open: Option<(String, usize)> = None;
    for (index, line) in lines.iter().enumerate() {
        let Some(language) = line.strip_prefix("```") else { continue };
        match open.take() {
            None => open = Some((language.trim().to_string(), index + 1)),
            Some((language, from)) => blocks.push(Block { language, from, to: index }),
        }
    }
    assert!(open.is_none(), "a block is not closed");
    blocks
}

/// Runs a block in a shell, both streams together, and keeps the folder for the next one.
fn run(script: &str, place: &mut String, folder: &Path) -> (String, i32) {
    let command = Path::new(env!("CARGO_BIN_EXE_chordal")).parent().unwrap();
    let path = std::env::var("PATH").unwrap_or_default();
    let end = folder.join("place");
    let whole = format!("exec 2>&1\n{script}\nexit=$?\npwd > '{}'\nexit $exit\n", end.display());
    let done = Command::new("sh")
        .args(["-c", &whole])
        .current_dir(&place)
        .env("PATH", format!("{}:{path}", command.display()))
        .env("NO_COLOR", "1")
        .env_remove("CLICOLOR_FORCE")
        .env_remove("GITHUB_ACTIONS")
        .output()
        .expect("a shell");
    if let Ok(now) = fs::read_to_string(&end) {
        *place = now.trim_end().to_string();
    }
    let text = String::from_utf8(done.stdout).expect("text");
    let text = if text.is_empty() || text.ends_with('\n') { text } else { text + "\n" };
    (text, done.status.code().unwrap_or(255))
}

/// The printed text has the parts between the lines `…`, in their order; where the page begins or ends
/// without one, so does the text.
fn matches(shown: &str, printed: &str) -> bool {
    let parts: Vec<&str> = split_at_dots(shown);
    let last = parts.len() - 1;
    let mut rest = printed;
    for (index, part) in parts.iter().enumerate() {
        let at = match index {
            0 => rest.starts_with(part).then_some(0),
            _ if index == last => rest.ends_with(part).then(|| rest.len() - part.len()),
            _ => rest.find(part),
        };
        let Some(at) = at else { return false };
        rest = &rest[at + part.len()..];
    }
    true
}

fn split_at_dots(text: &str) -> Vec<&str> {
    let mut parts = Vec::new();
    let mut rest = text;
    loop {
        let own_line = rest
            .strip_prefix("…\n")
            .map(|after| (0, after))
            .or_else(|| rest.find("\n…\n").map(|at| (at + 1, &rest[at + 1 + "…\n".len()..])));
        let Some((at, after)) = own_line else {
            parts.push(rest);
            return parts;
        };
        parts.push(&rest[..at]);
        rest = after;
    }
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let (old, new) = (entry.path(), to.join(entry.file_name()));
        if old.is_dir() {
            copy(&old, &new);
        } else {
            fs::copy(old, new).unwrap();
        }
    }
}

#[test]
fn dots_stand_for_any_lines() {
    assert!(matches("a\n…\nd\n", "a\nb\nc\nd\n"));
    assert!(matches("…\nd\n", "a\nd\n") && matches("a\n…\n", "a\nd\n"));
    assert!(!matches("b\n…\n", "a\nb\n") && !matches("a\n…\nc\n", "a\nb\n"));
    assert!(!matches("a\n…\nc\n…\nb\n…\n", "a\nb\nc\n"));
}
