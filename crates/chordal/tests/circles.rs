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
    // `main.rs` beside `lib.rs` is a crate of its own: here a module that nobody uses.
    if matches!(parts.last().map(String::as_str), Some("mod" | "lib")) {
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
        let name = if rest.starts_with('*') { "*" } else { word(rest) };
        if name.is_empty() {
            break;
        }
        at += name.len();
        base.push(name.to_string());
        match text[at..].strip_prefix("::") {
            Some(_) => at += 2,
            None => break,
        }
    }
    found.push(base.clone());
    base.truncate(depth);
    at
}

/// The word that a text begins with, perhaps none.
fn word(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
    &text[..end]
}

fn split(module: &str) -> Vec<String> {
    module.split("::").filter(|part| !part.is_empty()).map(str::to_string).collect()
}

/// The module that a path leads to: the longest part of it that is one. A name that a module gives
/// on from its child is the child's.
fn target(modules: &Modules, given_on: &GivenOn, path: &[String]) -> String {
    let mut module = String::new();
    for name in path {
        let next = join(&module, name);
        if modules.contains_key(&next) {
            module = next;
            continue;
        }
        while let Some(child) = given_on.get(&(module.clone(), name.clone())) {
            module.clone_from(child);
        }
        break;
    }
    module
}

fn join(module: &str, name: &str) -> String {
    if module.is_empty() { name.to_string() } else { format!("{module}::{name}") }
}

/// By module and name, the module below from which the name is given on.
type GivenOn = BTreeMap<(String, String), String>;

/// Names that modules give on from those below: `pub use child::Name`, and with a star all that
/// the child makes.
fn given_on(modules: &Modules) -> GivenOn {
    let mut given = GivenOn::new();
    for (module, text) in modules {
        for line in code(text).split(';') {
            let Some((_, rest)) = line.rsplit_once("use ") else { continue };
            let rest = rest.strip_prefix("self::").unwrap_or(rest);
            let mut found = paths(module, rest);
            if !rest.starts_with("crate::") && !rest.starts_with("super::") {
                spread(rest, &mut split(module), &mut found);
            }
            for path in found {
                let Some((name, of)) = path.split_last() else { continue };
                let of = of.join("::");
                let is_below = module.is_empty() || of.starts_with(&format!("{module}::"));
                let Some(text) = modules.get(&of).filter(|_| of != *module && is_below) else {
                    continue;
                };
                let names = if name == "*" { made(text) } else { vec![name.clone()] };
                given.extend(names.into_iter().map(|name| ((module.clone(), name), of.clone())));
            }
        }
    }
    given
}

/// The names that a module makes for others.
fn made(text: &str) -> Vec<String> {
    let kinds = ["struct ", "enum ", "trait ", "type ", "const ", "static ", "fn ", "const fn "];
    let mut made = Vec::new();
    for line in text.lines().filter(|line| line.starts_with("pub")) {
        let Some((_, rest)) = line.split_once(' ') else { continue };
        let after = kinds.iter().filter_map(|kind| rest.strip_prefix(kind)).map(word);
        made.extend(after.filter(|name| *name != "fn").map(str::to_string));
    }
    made
}

/// What a path leads to. A star leads to all that the module gives on and the text names.
fn targets(modules: &Modules, given: &GivenOn, path: &[String], text: &str) -> Vec<String> {
    let mut found = vec![target(modules, given, path)];
    if path.last().is_some_and(|name| name == "*") {
        let words: BTreeSet<&str> =
            text.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
        let names = given.keys().filter(|(of, name)| *of == found[0] && words.contains(&**name));
        let more: Vec<String> = names.map(|key| given[key].clone()).collect();
        found.extend(more);
    }
    found
}

/// For the children of each module: who uses whom, and where that is said.
fn neighbours(modules: &Modules) -> BTreeMap<(String, String, String), String> {
    let given = given_on(modules);
    let mut uses = BTreeMap::new();
    for (module, text) in modules {
        let (text, from) = (code(text), split(module));
        for path in paths(module, &text) {
            for to in targets(modules, &given, &path, &text) {
                let to = split(&to);
                let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
                if shared < from.len() && shared < to.len() {
                    let key = (from[..shared].join("::"), from[shared].clone(), to[shared].clone());
                    uses.entry(key).or_insert_with(|| format!("{module} uses {}", path.join("::")));
                }
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
fn made_up(of_root: &str, of_b: &str) -> Vec<String> {
    let texts = [
        ("", of_root),
        ("a", "use crate::b::Thing;\npub struct Other;\n"),
        ("b", of_b),
        ("c", "use super::a;\n"),
    ];
    circles(&texts.map(|(name, text)| (name.to_string(), text.to_string())).into())
}

#[test]
fn a_circle_is_found() {
    let root = "mod a;\nmod b;\nmod c;\n";
    assert!(made_up(root, "").is_empty());
    assert!(!made_up(root, "use crate::a::Other;\n").is_empty(), "two that use each other");
    assert!(!made_up(root, "use super::{a::Other, Thing};\n").is_empty(), "in a list");
    assert!(!made_up(root, "fn f() { crate::c::g() }\n").is_empty(), "over a third");
    assert!(made_up(root, "// crate::a::Other\n").is_empty(), "a remark");
    assert!(made_up(root, "use super::Other;\n").is_empty(), "a name of the root");
    for root in ["pub use a::Other;\n", "pub use crate::a::{Other};\n", "pub use a::*;\n"] {
        assert!(!made_up(root, "use super::Other;\n").is_empty(), "given on: {root}");
        assert!(!made_up(root, "use super::*;\ntype T = Other;\n").is_empty(), "a star: {root}");
        assert!(made_up(root, "use super::*;\n").is_empty(), "a star for nothing: {root}");
    }
}
