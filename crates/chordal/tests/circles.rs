//! Inside a crate imports go one way: of two neighbouring modules one may use the other, not both.
//! A module and its own children may use each other.

#![allow(clippy::disallowed_methods, reason = "reads the sources of the workspace")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Modules of a crate by their path (`interpreter::macros`; the root is empty), with their text.
type Modules = BTreeMap<String, String>;

fn modules(src: &Path) -> Modules {
    let mut modules = Modules::new();
    let mut folders = vec![src.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder of sources") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(&path).expect("a source");
                modules.insert(module_of(src, &path), text);
            }
        }
    }
    modules
}

fn module_of(src: &Path, file: &Path) -> String {
    let relative = file.strip_prefix(src).expect("a file of the crate").with_extension("");
    let mut parts: Vec<String> =
        relative.iter().map(|part| part.to_string_lossy().into_owned()).collect();
    if matches!(parts.last().map(String::as_str), Some("mod" | "lib" | "main")) {
        parts.pop();
    }
    parts.join("::")
}

/// The text without comments and without its tests, which may use anything.
fn code(text: &str) -> String {
    let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or(text);
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

/// Every path that begins with `crate::`, `super::` or `self::`, braces taken apart, absolute.
fn paths(module: &str, text: &str) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    for (start, _) in text.match_indices("crate::") {
        let before = text[..start].chars().next_back();
        if !before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '$') {
            spread(&text[start + "crate::".len()..], &mut Vec::new(), &mut found);
        }
    }
    for (start, _) in text.match_indices("super::") {
        let before = &text[..start];
        if before.ends_with("super::") || before.ends_with("self::") {
            continue;
        }
        let mut base: Vec<String> = split(module);
        let mut rest = &text[start..];
        while let Some(after) = rest.strip_prefix("super::") {
            base.pop();
            rest = after;
        }
        spread(rest, &mut base, &mut found);
    }
    found
}

/// One path, or the several of a list in braces.
fn spread(text: &str, base: &mut Vec<String>, found: &mut Vec<Vec<String>>) -> usize {
    let depth = base.len();
    let mut at = 0;
    loop {
        let rest = &text[at..];
        if let Some(list) = rest.strip_prefix('{') {
            at += 1;
            let mut inner = list;
            loop {
                let skipped = inner.len() - inner.trim_start_matches([' ', '\n', ',']).len();
                inner = &inner[skipped..];
                at += skipped;
                if inner.starts_with('}') || inner.is_empty() {
                    at += 1;
                    break;
                }
                let used = spread(inner, base, found).max(1);
                let as_name = inner[used..].find([',', '}', '\n']).unwrap_or(0);
                inner = &inner[used + as_name..];
                at += used + as_name;
            }
            base.truncate(depth);
            return at;
        }
        let name: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
        if name.is_empty() {
            break;
        }
        at += name.len();
        base.push(name);
        match text[at..].strip_prefix("::") {
            Some(_) => at += 2,
            None => break,
        }
    }
    found.push(base.clone());
    base.truncate(depth);
    at
}

fn split(module: &str) -> Vec<String> {
    module.split("::").filter(|part| !part.is_empty()).map(str::to_string).collect()
}

/// The module that a path leads to: the longest part of it that is one. A name that a module gives
/// on from its child is the child's.
fn target(
    modules: &Modules,
    given_on: &BTreeMap<(String, String), String>,
    path: &[String],
) -> String {
    let mut module = String::new();
    for name in path {
        let next = if module.is_empty() { name.clone() } else { format!("{module}::{name}") };
        if modules.contains_key(&next) {
            module = next;
        } else if let Some(child) = given_on.get(&(module.clone(), name.clone())) {
            return child.clone();
        } else {
            break;
        }
    }
    module
}

/// Names that modules give on from their children: `pub use child::Name`.
fn given_on(modules: &Modules) -> BTreeMap<(String, String), String> {
    let mut given = BTreeMap::new();
    for (module, text) in modules {
        for line in code(text).split(';') {
            let Some((_, rest)) = line.rsplit_once("use ") else { continue };
            let rest = rest.strip_prefix("self::").unwrap_or(rest);
            let mut found = Vec::new();
            spread(rest, &mut split(module), &mut found);
            for path in found {
                let Some((name, of)) = path.split_last() else { continue };
                let of = of.join("::");
                if of != *module && modules.contains_key(&of) {
                    given.insert((module.clone(), name.clone()), of);
                }
            }
        }
    }
    given
}

/// For the children of each module: who uses whom, and where that is said.
fn neighbours(modules: &Modules) -> BTreeMap<(String, String, String), String> {
    let given = given_on(modules);
    let mut uses = BTreeMap::new();
    for (module, text) in modules {
        for path in paths(module, &code(text)) {
            let (from, to) = (split(module), split(&target(modules, &given, &path)));
            let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
            if shared < from.len() && shared < to.len() {
                let key = (from[..shared].join("::"), from[shared].clone(), to[shared].clone());
                uses.entry(key).or_insert_with(|| format!("{module} uses {}", path.join("::")));
            }
        }
    }
    uses
}

/// The neighbours that are reached from one of them, itself perhaps.
fn reached(
    uses: &BTreeMap<(String, String, String), String>,
    parent: &str,
    from: &str,
) -> BTreeSet<String> {
    let mut reached = BTreeSet::new();
    let mut open = vec![from.to_string()];
    while let Some(module) = open.pop() {
        for (of, a, b) in uses.keys() {
            if of == parent && *a == module && reached.insert(b.clone()) {
                open.push(b.clone());
            }
        }
    }
    reached
}

fn circles(modules: &Modules) -> Vec<String> {
    let uses = neighbours(modules);
    let mut found = Vec::new();
    for ((parent, a, b), place) in &uses {
        if reached(&uses, parent, b).contains(a) {
            found.push(format!("{parent}: {a} and {b} use each other ({place})"));
        }
    }
    found
}

#[test]
fn no_crate_has_a_circle_of_imports() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut wrong = Vec::new();
    let mut folders: Vec<PathBuf> = fs::read_dir(crates)
        .expect("the crates")
        .map(|entry| entry.expect("a crate").path().join("src"))
        .filter(|src| src.is_dir())
        .collect();
    folders.sort();
    for src in folders {
        let name = src.parent().and_then(Path::file_name).expect("a crate's folder").to_owned();
        for circle in circles(&modules(&src)) {
            wrong.push(format!("{}: {circle}", name.to_string_lossy()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A crate of three modules, to see the test fail.
fn made_up(of_b: &str) -> Vec<String> {
    let texts = [
        ("", "mod a;\nmod b;\nmod c;\n"),
        ("a", "use crate::b::Thing;\n"),
        ("b", of_b),
        ("c", "use super::a;\n"),
    ];
    circles(&texts.map(|(name, text)| (name.to_string(), text.to_string())).into())
}

#[test]
fn a_circle_is_found() {
    assert!(made_up("").is_empty());
    assert!(!made_up("use crate::a::Other;\n").is_empty(), "two that use each other");
    assert!(!made_up("use super::{a::Other, Thing};\n").is_empty(), "in a list");
    assert!(!made_up("fn f() { crate::c::g() }\n").is_empty(), "over a third");
    assert!(made_up("// crate::a::Other\n").is_empty(), "a remark");
}
