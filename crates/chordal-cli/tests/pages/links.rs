//! Links between the pages of the project.

use std::fs;
use std::path::{Path, PathBuf};

/// Links of the pages to files and headings that are not there.
pub fn lost(root: &Path) -> Vec<String> {
    let mut pages: Vec<PathBuf> = Vec::new();
    for entry in fs::read_dir(root).unwrap() {
        pages.extend(page(entry.unwrap().path()));
    }
    gather(&root.join("docs"), &mut pages);
    assert!(pages.len() > 10);
    let mut lost = Vec::new();
    for path in pages {
        let text = fs::read_to_string(&path).unwrap();
        for link in links(&text) {
            if !leads(&path, &text, link) {
                let page = path.strip_prefix(root).unwrap().display();
                lost.push(format!("{page}: {link}"));
            }
        }
    }
    lost
}

fn page(path: PathBuf) -> Option<PathBuf> {
    path.extension().is_some_and(|ending| ending == "md").then_some(path)
}

fn gather(folder: &Path, pages: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            gather(&path, pages);
        } else {
            pages.extend(page(path));
        }
    }
}

/// What stands in `](…)`, outside of fenced blocks.
fn links(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for (index, part) in text.split("```").enumerate() {
        if index % 2 == 0 {
            let ends = part.split("](").skip(1);
            found.extend(ends.filter_map(|rest| rest.split(')').next()));
        }
    }
    found.retain(|link| !link.contains("://") && !link.contains(' ') && !link.is_empty());
    found
}

fn leads(page: &Path, text: &str, link: &str) -> bool {
    let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
    let target = page.parent().unwrap().join(file);
    if !file.is_empty() && !target.exists() {
        return false;
    }
    if anchor.is_empty() {
        return true;
    }
    let there =
        if file.is_empty() { text.into() } else { fs::read_to_string(target).unwrap_or_default() };
    there.lines().filter(|line| line.starts_with('#')).any(|line| anchor_of(line) == anchor)
}

/// The anchor of a heading: small letters, hyphens for blanks, no other signs.
fn anchor_of(heading: &str) -> String {
    let words = heading.trim_start_matches('#').trim().to_lowercase();
    let kept = words.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}
