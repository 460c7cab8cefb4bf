//! Names of the workspace: one type name is one type, a type name says what kind of thing it is, and words that only this
//! project would use stay out of identifiers. The limits may only be made smaller.

#![allow(clippy::disallowed_methods, reason = "reads the sources of the workspace")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Types that share a name with another type, in percent of all: `Args` of the commands is most of them.
const MAX_SHARED_PERCENT: usize = 3;

/// Types whose name is one word, in percent of all.
const MAX_ONE_WORD_PERCENT: usize = 9;

/// Words of no field's vocabulary: what they stand for has a name of its own.
const GLOSSARY: [&str; 23] = [
    "told",
    "tell",
    "tells",
    "behind",
    "beside",
    "stretch",
    "stretches",
    "way",
    "ways",
    "asked",
    "given",
    "held",
    "wanted",
    "elsewhere",
    "apart",
    "said",
    "standing",
    "believed",
    "looked",
    "laid",
    "patience",
    "handed",
    "untold",
];

/// Constants that do not say of what they are the limit, or in which unit.
const VAGUE_CONSTANTS: [&str; 12] = [
    "MOST", "LEAST", "NEAR", "SAME", "SAME_MM", "ROUNDING", "ROUNDS", "ENOUGH", "FEW", "MANY",
    "FAR", "PATIENCE",
];

/// The sources of the crates, without their tests.
fn sources() -> Vec<(PathBuf, String)> {
    fn gather(folder: &Path, found: &mut Vec<(PathBuf, String)>) {
        for entry in fs::read_dir(folder).expect("a folder of sources").flatten() {
            let path = entry.path();
            if path.is_dir() {
                gather(&path, found);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(&path).expect("a source");
                let code = text.split("#[cfg(test)]\nmod").next().unwrap_or_default();
                found.push((path, without_texts(code)));
            }
        }
    }
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the folder of crates");
    let mut found = Vec::new();
    for entry in fs::read_dir(crates).expect("the folder of crates").flatten() {
        gather(&entry.path().join("src"), &mut found);
    }
    found
}

/// The code with comments and texts taken out; its lines stay.
fn without_texts(code: &str) -> String {
    let (mut out, mut rest) = (String::with_capacity(code.len()), code);
    while let Some(first) = rest.chars().next() {
        let skipped = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if first == '"' {
            text_length(rest)
        } else if let Some(hashes) = raw_text_hashes(rest) {
            let end = format!("\"{}", "#".repeat(hashes));
            let open = hashes + 2;
            rest[open..].find(&end).map_or(rest.len(), |at| open + at + end.len())
        } else {
            // A quote in single quotes opens no text.
            let whole = if rest.starts_with("'\"'") { 3 } else { first.len_utf8() };
            out.push_str(&rest[..whole]);
            rest = &rest[whole..];
            continue;
        };
        out.extend(rest[..skipped].chars().filter(|c| *c == '\n'));
        out.push(' ');
        rest = &rest[skipped..];
    }
    out
}

fn text_length(text: &str) -> usize {
    let mut is_escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if is_escaped => is_escaped = false,
            '\\' => is_escaped = true,
            '"' => return at + 1,
            _ => {}
        }
    }
    text.len()
}

fn raw_text_hashes(text: &str) -> Option<usize> {
    let after = text.strip_prefix('r')?;
    let hashes = after.len() - after.trim_start_matches('#').len();
    after[hashes..].starts_with('"').then_some(hashes)
}

/// The identifiers of code, each with the one before it.
fn identifiers(code: &str) -> impl Iterator<Item = (&str, &str)> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let mut before = "";
    code.split(move |c| !is_part(c)).filter(|word| !word.is_empty()).map(move |word| {
        let pair = (before, word);
        before = word;
        pair
    })
}

/// The words of a name in either case, in lower case.
fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut begins = true;
    for c in name.chars() {
        if c == '_' {
            begins = true;
            continue;
        }
        let ends_lower =
            words.last().and_then(|word| word.chars().last()).is_some_and(char::is_lowercase);
        if begins || (c.is_uppercase() && ends_lower && name.chars().any(char::is_lowercase)) {
            words.push(String::new());
        }
        begins = false;
        if let Some(word) = words.last_mut() {
            word.push(c);
        }
    }
    words.into_iter().map(|word| word.to_lowercase()).collect()
}

/// The types that sources define, by name.
fn types(sources: &[(PathBuf, String)]) -> BTreeMap<String, Vec<PathBuf>> {
    let mut types: BTreeMap<String, Vec<PathBuf>> = BTreeMap::new();
    for (path, code) in sources {
        // Associated types stand in a block, so that they are not at the beginning of a line.
        for line in code.lines() {
            let is_inner = line.starts_with(' ');
            for (before, name) in identifiers(line) {
                let defines = ["struct", "enum", "trait", "union"].contains(&before)
                    || (before == "type" && !is_inner);
                if defines && name.starts_with(char::is_uppercase) {
                    types.entry(name.to_string()).or_default().push(path.clone());
                }
            }
        }
    }
    types
}

#[test]
fn a_type_name_is_one_type_and_says_its_kind() {
    let types = types(&sources());
    let all: usize = types.values().map(Vec::len).sum();
    let shared: Vec<&String> =
        types.iter().filter(|(_, places)| places.len() > 1).map(|(name, _)| name).collect();
    let count = |name: &&String| types[*name].len();
    let shared_count: usize = shared.iter().map(count).sum();
    let one_word: usize =
        types.keys().filter(|name| words(name).len() == 1).map(|name| types[name].len()).sum();
    println!(
        "{all} types; {shared_count} share a name ({:.1} %), {one_word} are one word ({:.1} %)",
        shared_count as f64 / all as f64 * 100.0,
        one_word as f64 / all as f64 * 100.0
    );
    assert!(shared_count * 100 <= MAX_SHARED_PERCENT * all, "names of several types: {shared:?}");
    assert!(one_word * 100 <= MAX_ONE_WORD_PERCENT * all, "{one_word} of {all} types are one word");
}

#[test]
fn identifiers_use_the_words_of_the_field() {
    let mut found = BTreeSet::new();
    for (path, code) in sources() {
        for (before, name) in identifiers(&code) {
            if words(name).iter().any(|word| GLOSSARY.contains(&word.as_str())) {
                found.insert(format!("{}: {name}", path.display()));
            }
            if before == "const" && VAGUE_CONSTANTS.contains(&name) {
                found.insert(format!("{}: const {name}", path.display()));
            }
        }
        let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
        if words(stem).iter().any(|word| GLOSSARY.contains(&word.as_str())) {
            found.insert(format!("{}: the file", path.display()));
        }
    }
    println!("{} identifiers with words of the glossary", found.len());
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn words_of_a_name_are_found_in_either_case() {
    assert_eq!(words("MaxArcPieces"), ["max", "arc", "pieces"]);
    assert_eq!(words("told_per_file"), ["told", "per", "file"]);
    assert_eq!(words("MOST_HELD"), ["most", "held"]);
    assert_eq!(without_texts("a // told\n\"beside\" r#\"held\"# b"), "a  \n    b");
}
